//! The form of a text that people pass on by hand, such as a link: the version of the form comes first, and a
//! check last, the CRC-32 of what precedes it in hexadecimal. So a text that was cut off or mistyped is noticed.

use crate::error::one_line;

/// The number of characters of the check.
const CHECK: usize = 8;

/// The part of a text that is at fault, and what is wrong with it.
pub type Fault<'t> = (&'t str, String);

/// A form of texts.
pub struct Form {
    /// The letters before the version.
    pub prefix: &'static str,
    /// The version that this program writes, and the newest that it reads.
    pub version: u32,
}

impl Form {
    /// Wraps a content in its version and its check.
    pub fn seal(&self, content: &str) -> String {
        let body = format!("{}{}/{content}", self.prefix, self.version);
        format!("{body}/{:08x}", crc32fast::hash(body.as_bytes()))
    }

    /// Returns true if a text begins as this form does, in any version.
    pub fn is_meant(&self, text: &str) -> bool {
        self.version_of(text).is_some()
    }

    fn version_of<'t>(&self, text: &'t str) -> Option<&'t str> {
        let (version, _) = text.strip_prefix(self.prefix)?.split_once('/')?;
        let is_number = !version.is_empty() && version.bytes().all(|b| b.is_ascii_digit());
        is_number.then_some(version)
    }

    /// Returns the content of a text for which [`is_meant`](Self::is_meant) is true.
    ///
    /// # Errors
    /// Returns an error if another version has written the text, or if it was cut off or mistyped.
    pub fn open<'t>(&self, text: &'t str) -> Result<&'t str, Fault<'t>> {
        let version = self.version_of(text).unwrap_or_default();
        if version != self.version.to_string() {
            let is_older = version.parse().is_ok_and(|version: u32| version <= self.version);
            let right = match is_older {
                true => "mistyped, or of an older Pinhole: make it again",
                false => "a newer Pinhole opens it",
            };
            let (found, own) = (one_line(version), self.version);
            let problem =
                format!("of version {found}, and this program reads version {own}: {right}");
            return Err((version, problem));
        }
        let sealed = text.rsplit_once('/').filter(|(_, check)| check.len() >= CHECK);
        let Some((body, check)) = sealed else {
            return Err((&text[text.len()..], "cut off: copy it again as a whole".into()));
        };
        if check != format!("{:08x}", crc32fast::hash(body.as_bytes())) {
            let problem = "mistyped or cut off: copy it again as a whole";
            return Err((check, problem.to_owned()));
        }
        Ok(body.split_once('/').map_or("", |(_, content)| content))
    }
}
