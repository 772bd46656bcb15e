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
//! A language is a program in [`LANGUAGES`].

mod language;
mod languages;
mod numbers;

pub use language::{Language, OutOfRange};
pub use languages::LANGUAGES;
pub use numbers::Precision;
