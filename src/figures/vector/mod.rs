//! Figures as vectors: SVG and PDF, with strokes as strokes and text as text.
//!
//! - `primitive`: paths, texts and pictures, whatever drew them;
//! - `shapes`: what egui was told to draw, as parts; `text`: its text, glyph by glyph;
//! - `typeface`: the fonts that the letters come from; `subset`: those letters alone, as a font;
//! - `svg`, `pdf`: parts as files.

mod pdf;
mod primitive;
mod shapes;
mod subset;
mod svg;
mod text;
mod typeface;

pub(super) use self::pdf::write as pdf;
pub(super) use self::primitive::{Page, Picture, Primitive};
pub(super) use self::shapes::primitives;
pub(super) use self::svg::write as svg;
