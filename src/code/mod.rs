//! Code for the camera at hand: in each language a short function from a pixel to its view ray, with
//! this camera's numbers and the lecture's words, to be put on a slide or run.
//!
//! All are the same few lines:
//!
//! ```text
//! u = width  * ((j + 0.5) / columns - 0.5)
//! v = height * (0.5 - (i + 0.5) / rows)
//! origin = eye        direction = u*U + v*V - distance*W
//! ```
//!
//! with row i and column j from 0, row 0 on top. Capital U, V, W are the basis vectors, as in the
//! lecture's formula; columns and rows stand for the image's W and H, which would be taken for them.
//! A language is one file and one row of [`LANGUAGES`].

mod cpp;
mod glsl;
mod javascript;
mod julia;
mod numbers;
mod python;
mod rust;

use std::fmt;

use pinhole_core::ResolvedCamera;

use numbers::Numbers;

/// A language, or a library for vectors in one.
#[derive(Debug)]
pub struct Language {
    /// What `pinhole export --to` calls it.
    pub name: &'static str,
    /// What people call it.
    pub label: &'static str,
    /// What a file of it may be called.
    pub file: &'static str,
    /// In which precision its numbers are.
    pub precision: Precision,
    write: fn(&Numbers) -> String,
}

/// A language's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// `f64`: the numbers read back to the same ones.
    Double,
    /// `f32`, as shaders have them: rounded, the shortest decimals that read back to the same `f32`.
    Single,
}

/// Every language.
pub static LANGUAGES: [Language; 6] = [
    julia::LANGUAGE,
    python::LANGUAGE,
    cpp::LANGUAGE,
    glsl::LANGUAGE,
    rust::LANGUAGE,
    javascript::LANGUAGE,
];

/// A number that a language's precision has no place for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    /// Which language.
    pub language: &'static str,
    /// Which number, as `eye` or `distance`.
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
    /// How its files end, without the dot.
    pub fn ending(&self) -> &'static str {
        self.file.rsplit('.').next().unwrap_or_default()
    }

    /// The function from (i, j) to the ray of this camera, as a whole program or shader.
    ///
    /// # Errors
    /// A number beyond the language's precision.
    pub fn code(&self, camera: &ResolvedCamera) -> Result<String, OutOfRange> {
        let numbers = Numbers::of(camera, self.precision);
        let numbers =
            numbers.map_err(|(field, value)| OutOfRange { language: self.label, field, value })?;
        Ok((self.write)(&numbers))
    }
}
