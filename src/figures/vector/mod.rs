//! Figures as vectors: SVG and PDF, with strokes as strokes and text as text.
//!
//! - `part`: the parts of a figure, whatever drew them;
//! - `shapes`: what egui was told to draw, as parts; `text`: its text, glyph by glyph;
//! - `typeface`: the fonts that the letters come from; `subset`: those letters alone, as a font;
//! - `svg`, `pdf`: parts as files.

mod part;
mod pdf;
mod shapes;
mod subset;
mod svg;
mod text;
mod typeface;

pub(super) use self::part::{Page, Part, Picture};
pub(super) use self::pdf::write as pdf;
pub(super) use self::shapes::parts;
pub(super) use self::svg::write as svg;
