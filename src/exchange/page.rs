//! The page that runs the program in a browser, and the scene or lesson that it contains.
//!
//! The page is one HTML file. Its part is JSON in a script element that the browser does not run:
//!
//! ```json
//! {"pinhole": 1, "lesson": "lesson.toml", "step": 3, "files": {"lesson.toml": "..."}}
//! ```

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::error::of_json;

/// The version of the part's format.
const VERSION: u32 = 1;

/// The element that contains the part.
const BEGIN: &str = "<script type=\"application/json\" id=\"part\">";
const END: &str = "</script>";

/// The scene or lesson in a page.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PagePart {
    /// The version of the format.
    pub pinhole: u32,
    /// The scene to open: the name of a built-in one, or of one of the files.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene: Option<String>,
    /// The lesson to open, as an argument of the command line: `7.3`, or one of the files.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lesson: Option<String>,
    /// The step of a lesson from a file, counted from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub step: Option<usize>,
    /// The texts of files, by their names.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub files: BTreeMap<String, String>,
}

/// Returns the name of a file in a page: its path without `.`, `..` and folders above.
pub fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => drop(plain.pop()),
            Component::Normal(name) => plain.push(name),
            _ => {}
        }
    }
    plain
}

impl Default for PagePart {
    /// Returns a part without a scene or lesson.
    fn default() -> PagePart {
        PagePart { pinhole: VERSION, scene: None, lesson: None, step: None, files: BTreeMap::new() }
    }
}

impl PagePart {
    /// Parses a page's part. An empty text is a part without a scene or lesson.
    ///
    /// # Errors
    /// Returns a reason, as a sentence, if the text is not such a part.
    pub fn parse(text: &str) -> Result<PagePart, String> {
        if text.trim().is_empty() {
            return Ok(PagePart::default());
        }
        let part: PagePart = serde_json::from_str(text).map_err(|error| {
            format!("The page was changed, and cannot be read: {}.", of_json(&error))
        })?;
        if part.pinhole != VERSION {
            return Err(format!(
                "The page was made by another version of Pinhole: its format is {}, and this program \
                 reads {VERSION}.",
                part.pinhole
            ));
        }
        Ok(part)
    }

    /// Returns a page with this part in place of its own.
    ///
    /// # Errors
    /// Returns a reason, as a sentence, if `page` is not a page of this program.
    pub fn in_page(&self, page: &str) -> Result<String, String> {
        let found = page.find(BEGIN).and_then(|begin| {
            let begin = begin + BEGIN.len();
            Some((&page[..begin], &page[begin + page[begin..].find(END)?..]))
        });
        let (before, after) = found.ok_or("not a page of Pinhole: it has no place for a scene")?;
        let json = serde_json::to_string(self).map_err(|error| error.to_string())?;
        // No text in the part can end the element or begin another one.
        Ok([before, &json.replace('<', "\\u003c"), after].concat())
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;

    const PAGE: &str =
        "<html><script type=\"application/json\" id=\"part\"></script><p></p></html>";

    #[test]
    fn a_part_is_read_back_whatever_its_files_contain() {
        let mut part = PagePart::default();
        (part.lesson, part.step) = (Some("a.toml".to_owned()), Some(3));
        let text = "</script><script>alert(1)</script>\n# \u{2028} <!-- \\u003c \"";
        part.files.insert("a.toml".to_owned(), text.to_owned());
        let page = part.in_page(PAGE).unwrap();
        assert_eq!(page.matches("<script").count(), 1);
        let json = &page[page.find('{').unwrap()..page.find("</script>").unwrap()];
        assert_eq!(PagePart::parse(json).unwrap(), part);
        assert_eq!(PagePart::default().in_page(&page), PagePart::default().in_page(PAGE));
    }

    #[test]
    fn a_changed_part_is_refused_with_a_reason() {
        assert_eq!(PagePart::parse(" "), Ok(PagePart::default()));
        for (text, reason) in [
            ("{\"pinhole\": 1, \"scene\": 3}", "integer 3 is there: it must be text in quotes"),
            ("{\"pinhole\": 1", "the text ends inside an object: is all of the file there?"),
            ("{\"pinhole\": 2}", "another version"),
            (
                "{\"pinhole\": 1, \"script\": \"\"}",
                "unknown field script is there: it must be one of pinhole, ",
            ),
        ] {
            let error = PagePart::parse(text).unwrap_err();
            assert!(error.contains(reason), "{error}");
        }
        assert!(PagePart::default().in_page("<html></html>").is_err());
    }
}
