//! The parts of every format: its name and writer, its conventions where they differ from ours, and its text, in
//! which numbers with the opposite sign are marked.

use std::ops::Range;
use std::path::Path;

use pinhole_core::{Camera, DVec3, Rgb};

use crate::error::{is_hidden, one_line};
use crate::export_scene::{ExportScene, Unsupported};
use crate::{FileError, Location, legible};

/// A program, a notation for cameras, or a programming language that Pinhole writes.
#[derive(Debug)]
pub struct Format {
    /// Name on the command line, after `--to`.
    pub name: &'static str,
    /// Name on the screen.
    pub label: &'static str,
    /// Name in a word or two.
    pub short: &'static str,
    /// Proposed name of its file.
    pub file: &'static str,
    /// Its conventions; `None` for code, which has the lecture's.
    pub conventions: Option<Conventions>,
    pub(crate) write: fn(&ExportScene, &mut Vec<String>) -> Result<String, Unsupported>,
}

/// An exported scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Exported {
    /// The file's text.
    pub text: Text,
    /// Notes about anything that the format cannot express, or expresses differently.
    pub notes: Vec<String>,
}

/// A text from another program, and its path for messages.
#[derive(Clone, Copy, Debug)]
pub struct Input<'a> {
    /// The file as the user gave it.
    pub path: &'a Path,
    /// Its contents.
    pub text: &'a str,
}

/// An imported camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// The camera.
    pub camera: Camera,
    /// Notes about anything that could not be imported, or that the text does not specify.
    pub notes: Vec<String>,
}

impl Format {
    /// Returns the ending of its files, without the dot.
    pub fn ending(&self) -> &'static str {
        self.file.rsplit('.').next().unwrap_or_default()
    }

    /// Writes the camera, and the objects if requested, in this format.
    ///
    /// # Errors
    /// Returns the first quantity that the format cannot express, as one that is not finite.
    pub fn write(&self, subject: &ExportScene) -> Result<Exported, Unsupported> {
        let mut notes = Vec::new();
        let marked = (self.write)(subject, &mut notes)?;
        if let Some(line) = marked.lines().find(|line| line.contains(BEYOND)) {
            let line = Text::from_marked(&line.replace(BEYOND, "infinite")).text;
            return Err(Unsupported(format!(
                "a number would not be finite, in {}: bring the eye and the objects nearer to each other",
                one_line(&line)
            )));
        }
        notes.iter_mut().for_each(|note| *note = legible(note));
        Ok(Exported { text: Text::from_marked(&marked), notes })
    }
}

impl Input<'_> {
    /// An error at a byte of the text.
    pub(crate) fn error_at(&self, at: usize, problem: impl Into<String>) -> FileError {
        FileError::at(self.path, Location::of_byte(self.text.as_bytes(), at), problem)
    }
}

/// Direction of an axis of a format's camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Its letter with its sign: `u`, `−w`.
    pub name: &'static str,
    /// The direction in words: `right`, `up`, `backwards`, and their opposites.
    pub meaning: &'static str,
    /// Its vector, in coordinates (u, v, w).
    pub direction: DVec3,
}

/// How a format counts pixels, and where their centres are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PixelConvention {
    /// x right, y down from the image's corner, centres at halves: Pinhole's convention.
    Corner,
    /// x right, y down, centres at whole numbers.
    AtCentre,
    /// y up from the lower left corner, centres at halves.
    FromBottom,
    /// Rows and columns from 1.
    FromOne,
    /// Row and column from 0, the column first.
    ColumnFirst,
    /// -1 to 1 across the image, y up.
    Device,
}

/// A format's conventions.
#[derive(Debug)]
pub struct Conventions {
    /// Directions of its camera's x, y and z.
    pub axes: [Axis; 3],
    /// Numbers that the camera is given by.
    pub given_by: &'static str,
    /// Places of its pixels.
    pub pixels: PixelConvention,
    /// Measure of the field of view.
    pub view: &'static str,
    /// Its number for a camera.
    pub(crate) field: fn(&ExportScene) -> String,
    /// Counterpart of the viewport's distance.
    pub distance: &'static str,
    /// Shapes of pixels that it can have.
    pub shape: &'static str,
    /// Precision that it computes in.
    pub lengths: &'static str,
}

#[allow(missing_docs, reason = "u, v, w of the camera, and their opposites")]
impl Axis {
    pub const U: Axis = Axis { name: "u", meaning: "right", direction: DVec3::X };
    pub const V: Axis = Axis { name: "v", meaning: "up", direction: DVec3::Y };
    pub const W: Axis = Axis { name: "w", meaning: "backwards", direction: DVec3::Z };
    pub const MINUS_U: Axis = Axis { name: "−u", meaning: "left", direction: DVec3::NEG_X };
    pub const MINUS_V: Axis = Axis { name: "−v", meaning: "down", direction: DVec3::NEG_Y };
    pub const MINUS_W: Axis = Axis { name: "−w", meaning: "forwards", direction: DVec3::NEG_Z };

    /// Returns true for the opposites of u, v and w.
    pub fn is_flipped(self) -> bool {
        self.direction.element_sum() < 0.0
    }
}

impl Conventions {
    /// The axes of a camera here.
    pub const OURS: [Axis; 3] = [Axis::U, Axis::V, Axis::W];

    /// Returns true where its camera's axes are right-handed.
    pub fn is_right_handed(&self) -> bool {
        let [x, y, z] = self.axes.map(|axis| axis.direction);
        x.cross(y).dot(z) > 0.0
    }

    /// Returns the number or numbers that describe the field of view of a camera.
    pub fn field_of_view(&self, subject: &ExportScene) -> String {
        (self.field)(subject).replace(BEYOND, "beyond f64")
    }
}

/// A text, and the parts whose sign is the opposite of ours.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// The text.
    pub text: String,
    /// Bytes of the text, in order.
    pub flipped: Vec<Range<usize>>,
}

/// Marks around a flipped part while the text is being written: characters of the private use area, which occur
/// in no number.
const OPEN: char = '\u{e000}';
const CLOSE: char = '\u{e001}';

/// Placeholder for a number that is not finite, which no format allows.
const BEYOND: char = '\u{e002}';

/// Formats a number with the fewest digits that read back to it.
pub(crate) fn n(x: f64) -> String {
    if x.is_finite() { pinhole_core::shortest(x) } else { BEYOND.to_string() }
}

impl Text {
    /// The text whose numbers may be marked by [`flipped`].
    pub(crate) fn from_marked(marked: &str) -> Text {
        let mut made = Text::default();
        let mut from = 0;
        for c in marked.chars() {
            match c {
                OPEN => from = made.text.len(),
                CLOSE => made.flipped.push(from..made.text.len()),
                c => made.text.push(c),
            }
        }
        made
    }
}

/// A number whose sign is turned.
pub(crate) fn flipped(x: f64) -> String {
    format!("{OPEN}{}{CLOSE}", n(x))
}

/// Returns an external text, such as a name, without characters that would end a line, are hidden, or serve as
/// marks here.
pub(crate) fn sanitized(text: &str) -> String {
    text.chars().filter(|c| !is_hidden(*c) && ![OPEN, CLOSE, BEYOND].contains(c)).collect()
}

/// Returns a name that can be quoted in every format.
pub(crate) fn quotable(name: &str) -> String {
    sanitized(name).chars().map(|c| if "\"'\\<>&".contains(c) { '_' } else { c }).collect()
}

/// Formats a number with a point or an exponent, for formats in which `1` would be an integer and divided as
/// one.
pub(crate) fn real(x: f64) -> String {
    point(n(x))
}

/// Adds a point to the text of a number without one and without an exponent.
pub(crate) fn point(number: String) -> String {
    if number.contains(['.', 'e']) { number } else { number + ".0" }
}

/// `1, 2, 3`
pub(crate) fn commas(v: DVec3) -> String {
    commas_of(v, n)
}

/// Formats a vector's components with `number`, separated by commas.
pub(crate) fn commas_of(v: DVec3, number: impl Fn(f64) -> String) -> String {
    v.to_array().map(number).join(", ")
}

/// `1 2 3`
pub(crate) fn spaces(v: DVec3) -> String {
    v.to_array().map(n).join(" ")
}

/// The three rows of a matrix, by its columns.
pub(crate) fn rows(columns: [DVec3; 4], between: &str) -> [String; 3] {
    [0, 1, 2].map(|k| columns.map(|column| n(column[k])).join(between))
}

/// Converts a colour to linear light (with the sRGB curve of IEC 61966-2-1), with six digits.
pub(crate) fn light(color: Rgb, between: &str) -> String {
    let parts = color.map(|byte| {
        let s = f64::from(byte) / 255.0;
        let light = if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) };
        n((light * 1e6).round() / 1e6)
    });
    parts.join(between)
}
