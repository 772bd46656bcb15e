//! A language: its name, and its program for a camera.

use std::fmt;

use pinhole_core::ResolvedCamera;

use super::numbers::{Precision, numbers};

/// A language, or a library for vectors in one.
#[derive(Debug)]
pub struct Language {
    /// Name on the command line, after `--to`.
    pub name: &'static str,
    /// Name on the screen.
    pub label: &'static str,
    /// Proposed name of its file.
    pub file: &'static str,
    /// Precision of its numbers.
    pub precision: Precision,
    /// Its program, with the names of numbers in braces, as `{eye}`.
    pub(super) program: &'static str,
}

/// A number that a language's precision has no place for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    /// Name of the language.
    pub language: &'static str,
    /// Name of the number, as `eye` or `distance`.
    pub field: &'static str,
    /// The number.
    pub value: f64,
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let OutOfRange { language, field, value } = self;
        let value = pinhole_core::shortest(*value);
        write!(
            f,
            "{field} has the number {value}, and {language} calculates in f32: it must be between \
             1e-37 and 1e38 in size"
        )
    }
}

impl std::error::Error for OutOfRange {}

impl Language {
    /// Returns the ending of its files, without the dot.
    pub fn ending(&self) -> &'static str {
        self.file.rsplit('.').next().unwrap_or_default()
    }

    /// The function from (i, j) to the ray of this camera, as a whole program or shader.
    ///
    /// # Errors
    /// Returns an error if a number is out of range in the language's precision.
    pub fn code(&self, camera: &ResolvedCamera) -> Result<String, OutOfRange> {
        let numbers = numbers(camera, self.precision).map_err(|(field, value)| OutOfRange {
            language: self.label,
            field,
            value,
        })?;
        let put = |program: String, (name, number): (&str, String)| {
            program.replace(&format!("{{{name}}}"), &number)
        };
        Ok(numbers.into_iter().fold(self.program.to_owned(), put))
    }
}
