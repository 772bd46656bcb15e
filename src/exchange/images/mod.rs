//! Pictures as files, PNG, GIF and OpenEXR; colours as text.

pub mod color;
#[cfg(feature = "exr")]
pub mod exr;
pub mod gif;
pub mod png;
