//! Charts as plain drawings, written as SVG and as pixels: scales, marks, frames.
//!
//! A plotting crate would do the axes, but brings its own fonts, and no legend that counts.

pub(crate) mod axis;
pub(crate) mod figure;
pub(crate) mod frame;
pub(crate) mod marker;
mod raster;
mod svg;

pub use self::figure::Figure;
pub use self::raster::Raster;

/// Pixels to a point in PNG: as wide as a projector.
pub const PNG_SCALE: f32 = 1.5;
