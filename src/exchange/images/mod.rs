//! Pictures as files: PNG and OpenEXR; what every SVG has in common, and colours as text.

pub mod color;
pub mod exr;
pub mod png;
