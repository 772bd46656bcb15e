//! The translator: the camera in another program's terms, and pasted cameras.

pub mod conventions;

use std::ops::Range;
use std::path::Path;

use pinhole_core::{Camera, Pixel, shortest};
use pinhole_exchange::code::{LANGUAGES, Language};
use pinhole_exchange::document::Document;
use pinhole_exchange::format::{
    ExportScene, Exported, Format, Include, Input, MIRRORED, Text, Unsupported,
};
use pinhole_exchange::programs::{FORMATS, importer_of, unknown_form};
use pinhole_exchange::{FileError, limits, scene_file};

use crate::model::translator::conventions::{FIELD_OF_VIEW, Row, rows};

/// Maximum number of objects that are written and shown.
pub const MOST_OBJECTS: usize = 500;

/// A target of a translation.
#[derive(Clone, Copy, Debug)]
pub enum Target {
    /// The format of a program, or a common way of writing cameras.
    Format(&'static Format),
    /// Code from a pixel to its ray, in a language.
    Code(&'static Language),
}

impl Target {
    /// Returns all formats, then all languages.
    pub fn all() -> impl Iterator<Item = Target> {
        FORMATS.iter().map(Target::Format).chain(LANGUAGES.iter().map(Target::Code))
    }

    /// Returns the target with this name.
    pub fn named(name: &str) -> Option<Target> {
        Target::all().find(|target| target.name() == name)
    }

    /// Returns the name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Target::Format(format) => format.name,
            Target::Code(language) => language.name,
        }
    }

    /// Returns the name for people.
    pub fn label(self) -> &'static str {
        match self {
            Target::Format(format) => format.label,
            Target::Code(language) => language.label,
        }
    }

    /// Returns the name in a word or two.
    pub fn short(self) -> &'static str {
        match self {
            Target::Format(format) => format.short,
            Target::Code(language) => language.label,
        }
    }

    /// Returns the ending of its files, without the dot.
    pub fn ending(self) -> &'static str {
        match self {
            Target::Format(format) => format.ending,
            Target::Code(language) => language.ending(),
        }
    }

    /// Writes the camera, and the objects where the target has terms for them; code describes only the
    /// camera.
    ///
    /// # Errors
    /// Returns the reason if the target has no terms for the camera.
    pub fn write(self, subject: &ExportScene) -> Result<Exported, Unsupported> {
        match self {
            Target::Format(format) => format.write(subject),
            Target::Code(language) => {
                let text = language
                    .code(subject.resolve())
                    .map_err(|error| Unsupported(error.to_string()))?;
                let text = Text { text, flipped: Vec::new() };
                Ok(Exported { files: vec![(language.file, text)], notes: Vec::new() })
            }
        }
    }

    /// Returns the table of conventions, with the numbers of a pixel; empty for code, which has the
    /// lecture's own.
    fn rows(self, subject: &ExportScene, pixel: Pixel, digits: usize) -> Vec<Row> {
        match self {
            Target::Format(format) => {
                let mut rows = rows(format, subject, pixel, digits);
                for row in rows.iter_mut().filter(|row| row.about == FIELD_OF_VIEW) {
                    let theirs =
                        Text { text: std::mem::take(&mut row.theirs), flipped: Vec::new() };
                    row.theirs = shortened(&theirs, digits).text;
                }
                rows
            }
            Target::Code(_) => Vec::new(),
        }
    }
}

/// The choices in the translator.
#[derive(Clone, Debug, PartialEq)]
pub struct Translator {
    /// The name of the [`Target`].
    pub target: &'static str,
    /// True if the objects are written, too.
    pub objects: bool,
    /// True if numbers are shown to the last digit, as they are always copied and saved.
    pub every_digit: bool,
    /// What was done last, while it is shown.
    pub notice: Option<Notice>,
}

impl Default for Translator {
    fn default() -> Translator {
        Translator { target: "opencv", objects: false, every_digit: false, notice: None }
    }
}

impl Translator {
    /// Returns the chosen target.
    pub fn chosen(&self) -> Target {
        Target::named(self.target).unwrap_or(Target::Format(&FORMATS[0]))
    }
}

/// What was done, to be read in passing: the result of a paste, or of a file that was read again.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    /// The result in a few words.
    pub title: String,
    /// More about it: the parts that were not taken over, or the error in the text.
    pub notes: Vec<String>,
    /// True if it went well.
    pub worked: bool,
    /// The camera after that, if it is about the camera; the notice is outdated once it has changed.
    pub camera: Option<Camera>,
    /// Time in seconds at which this was first shown.
    pub shown_at: Option<f64>,
}

/// The note on a left-handed camera among objects that stay as they are.
const ALONE: &str = "its world is left-handed, Pinhole's is right-handed: the camera's every z is negated here, \
                     but the objects are not: negate their z, too, for the same picture";

/// Reads the camera in a text. Fields that the text leaves open stay as in the camera `at_hand`;
/// objects are not taken over. Returns no camera if the text has none or an invalid one.
pub fn pasted(text: &str, at_hand: &Camera) -> (Option<Camera>, Notice) {
    let failed = |title: &str, note: String| {
        let (title, notes) = (title.to_owned(), vec![note]);
        (None, Notice { title, notes, worked: false, camera: Some(*at_hand), shown_at: None })
    };
    if text.len() > limits::PASTE {
        let most = limits::PASTE >> 10;
        let has = text.len().div_ceil(1 << 10);
        let problem = format!(
            "it has {has} KiB, and at most {most} KiB are read: copy the camera's lines alone"
        );
        return failed("This text was not pasted: nothing was changed", problem);
    }
    if let Some(scene) = own_scene(text) {
        return match scene {
            Ok(document) => {
                let title = "Camera pasted: a scene of Pinhole".to_owned();
                let objects = document.object_count();
                taken_over(title, document.camera, Vec::new(), objects)
            }
            Err(error) => failed("Not pasted: this scene cannot be read", error.to_string()),
        };
    }
    let Some(importer) = importer_of(text) else {
        return failed("This text is not a camera: nothing was changed", unknown_form());
    };
    let text = Input { path: Path::new("pasted"), text };
    match importer.read(&text, at_hand) {
        Ok(read) => {
            let objects = read.spheres.len() + read.planes.len();
            let notes = read.notes.into_iter();
            let notes = notes.map(|note| if note == MIRRORED { ALONE.to_owned() } else { note });
            let title = format!("Camera pasted: {}", importer.label);
            taken_over(title, read.camera, notes.collect(), objects)
        }
        Err(error) => {
            let title = format!("Not pasted: this camera of {} cannot be read", importer.label);
            failed(&title, error.to_string())
        }
    }
}

fn taken_over(
    title: String,
    camera: Camera,
    mut notes: Vec<String>,
    objects: usize,
) -> (Option<Camera>, Notice) {
    if objects > 0 {
        let noun = if objects == 1 { "object is" } else { "objects are" };
        notes.push(format!("{objects} {noun} left out: a paste sets only the camera"));
    }
    (Some(camera), Notice { title, notes, worked: true, camera: Some(camera), shown_at: None })
}

/// Reads a scene file of this program, if the text is one.
fn own_scene(text: &str) -> Option<Result<Document, FileError>> {
    let is_one = text.lines().any(|line| line.trim_start().starts_with("pinhole ="));
    is_one.then(|| scene_file::parse_alone(text, Path::new("pasted")))
}

/// Returns what is written with the camera: the objects if they are wanted and not too many.
pub fn with(document: &Document, objects: bool) -> Include {
    let few = document.object_count() <= MOST_OBJECTS;
    if objects && few { Include::Meshes } else { Include::CameraAlone }
}

/// A camera in the terms of a target.
#[derive(Clone, Debug, PartialEq)]
pub struct Translation {
    /// The texts, or the reason why there are none.
    pub written: Result<Exported, Unsupported>,
    /// The table of conventions; empty if there is no camera.
    pub rows: Vec<Row>,
}

impl Translation {
    /// Translates a document's camera; the table has the numbers of `pixel`.
    pub fn new(
        document: &Document,
        target: Target,
        objects: bool,
        pixel: Pixel,
        digits: usize,
    ) -> Translation {
        match ExportScene::new(document, with(document, objects)) {
            Ok(subject) => Translation {
                written: target.write(&subject),
                rows: target.rows(&subject, pixel, digits),
            },
            Err(error) => Translation { written: Err(error), rows: Vec::new() },
        }
    }
}

/// Returns the text with long numbers cut to `digits` significant digits, for reading.
pub fn shortened(text: &Text, digits: usize) -> Text {
    let mut short = Text::default();
    let mut from = 0;
    for mark in &text.flipped {
        push_short(&mut short.text, &text.text, from..mark.start, digits);
        let start = short.text.len();
        push_short(&mut short.text, &text.text, mark.clone(), digits);
        short.flipped.push(start..short.text.len());
        from = mark.end;
    }
    push_short(&mut short.text, &text.text, from..text.text.len(), digits);
    short
}

/// Adds a part of the text with its long numbers cut. A digit after a letter begins no number.
fn push_short(short: &mut String, text: &str, part: Range<usize>, digits: usize) {
    let bytes = &text.as_bytes()[..part.end];
    let (mut from, mut at) = (part.start, part.start);
    while at < part.end {
        let before = at.checked_sub(1).map_or(b' ', |k| bytes[k]);
        if !bytes[at].is_ascii_digit() || before.is_ascii_alphanumeric() || before == b'_' {
            at += 1;
            continue;
        }
        let is_number = |b: &&u8| b.is_ascii_digit() || **b == b'.';
        let mut end = at + bytes[at..].iter().take_while(is_number).count();
        if bytes.get(end) == Some(&b'e') {
            let sign = usize::from(bytes.get(end + 1) == Some(&b'-'));
            let exponent = bytes[end + 1 + sign..].iter().take_while(|b| b.is_ascii_digit());
            let count = exponent.count();
            end += if count > 0 { 1 + sign + count } else { 0 };
        }
        let number = &text[at..end];
        let mantissa = number.split('e').next().unwrap_or_default().bytes();
        let count = mantissa.skip_while(|b| b"0.".contains(b)).filter(u8::is_ascii_digit).count();
        if let (true, Ok(value)) = (count > digits && number.contains(['.', 'e']), number.parse()) {
            short.push_str(&text[from..at]);
            short.push_str(&cut(value, digits));
            from = end;
        }
        at = end;
    }
    short.push_str(&text[from..part.end]);
}

fn cut(value: f64, digits: usize) -> String {
    let rounded = format!("{value:.*e}", digits.max(1) - 1);
    rounded.parse().map_or(rounded, shortest)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Clipboards have what pages and editors put there.
    #[test]
    fn a_paste_with_characters_of_more_bytes_is_read_or_told() {
        let text = "glm::mat4\u{a0}view =\u{a0}glm::lookAt(glm::vec3(4, 3, 3),\u{a0}glm::vec3(0), \
                    glm::vec3(0, 1, 0)); // it\u{2019}s\n\
                    auto p = glm::perspective(glm::radians(45.0f), 1.5f, 0.1f, 9.0f);\n";
        assert_eq!(pasted(text, &Camera::CANONICAL).1.notes.len(), 1);
        for (at, _) in text.char_indices() {
            for strange in ["\u{a0}", "\u{2019}", "\u{201c}", "\r", "\r\u{1d54f}"] {
                let (head, tail) = text.split_at(at);
                let (camera, said) = pasted(&format!("{head}{strange}{tail}"), &Camera::CANONICAL);
                assert_eq!((camera.is_some(), !said.notes.is_empty()), (said.worked, true));
            }
        }
    }

    #[test]
    fn a_large_paste_is_refused_and_one_of_many_calculations_is_told_in_short() {
        let sum = |terms: usize| format!("gluLookAt({}1)", "1 + ".repeat(terms));
        let told = |text: &str| {
            let (camera, said) = pasted(text, &Camera::CANONICAL);
            assert_eq!(camera, None);
            said.notes.join(" ")
        };
        assert!(told(&sum(30_000)).len() < 300);
        assert_eq!(
            told(&sum(40_000)),
            "it has 157 KiB, and at most 128 KiB are read: copy the camera's lines alone"
        );
    }

    #[test]
    fn a_pasted_scene_reads_no_file() {
        let text = "pinhole = 1\nspheres = \"/dev/zero\"\n[camera]\neye = [0, 0, 0]\nat = [0, 0, -1]\n\
                    up = [0, 1, 0]\n";
        assert!(pasted(text, &Camera::CANONICAL).1.worked);
    }

    #[test]
    fn long_numbers_are_cut_and_marks_go_along() {
        let text = "R [0.5812381937190964, -0.8137e-20] v10.123456789 12345678 1.23456789e-7.";
        let exact = Text { text: text.to_owned(), flipped: vec![3..21, 23..34] };
        let short = shortened(&exact, 4);
        assert_eq!(short.text, "R [0.5812, -0.8137e-20] v10.123456789 12345678 1.235e-7.");
        let marked: Vec<&str> = short.flipped.iter().map(|m| &short.text[m.clone()]).collect();
        assert_eq!(marked, ["0.5812", "-0.8137e-20"]);
        assert_eq!(shortened(&exact, 17).text, text);
    }
}
