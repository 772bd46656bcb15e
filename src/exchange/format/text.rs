//! A text in which the numbers whose sign is turned against ours are marked.

use std::ops::Range;

use pinhole_core::{DVec3, Rgb};

use crate::error::is_hidden;

/// A text, and which parts of it have another sign than here.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// The text.
    pub text: String,
    /// Bytes of the text, in order.
    pub flipped: Vec<Range<usize>>,
}

/// Around a flipped part while the text is put together: letters of the private use area, which no
/// number has in it.
const OPEN: char = '\u{e000}';
const CLOSE: char = '\u{e001}';

/// In the place of a number that is not finite, which no text may have.
pub(super) const BEYOND: char = '\u{e002}';

/// A number in the fewest digits that read back to it.
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

/// A text that came from outside, such as a name, without what would end a line, hide or mark a part.
pub(crate) fn one_line(text: &str) -> String {
    text.chars().filter(|c| !is_hidden(*c) && ![OPEN, CLOSE, BEYOND].contains(c)).collect()
}

/// A name as it can stand in quotes in every format.
pub(crate) fn quotable(name: &str) -> String {
    one_line(name).chars().map(|c| if "\"'\\<>&".contains(c) { '_' } else { c }).collect()
}

/// A number with a point or an exponent, where `1` would be a whole number and divided as one.
pub(crate) fn real(x: f64) -> String {
    point(n(x))
}

/// The text of a number as one with a point or an exponent.
pub(crate) fn point(number: String) -> String {
    if number.contains(['.', 'e']) { number } else { number + ".0" }
}

/// `1, 2, 3`
pub(crate) fn commas(v: DVec3) -> String {
    commas_of(v, n)
}

/// A vector's numbers between commas, each as it is written by this.
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

/// A colour of the screen as light (the sRGB curve of IEC 61966-2-1), to six digits.
pub(crate) fn light(color: Rgb, between: &str) -> String {
    let parts = color.map(|byte| {
        let s = f64::from(byte) / 255.0;
        let light = if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) };
        n((light * 1e6).round() / 1e6)
    });
    parts.join(between)
}
