//! Pictures as files, PNG and OpenEXR; colours as text.

pub mod color;
#[cfg(feature = "exr")]
pub mod exr;
pub mod png;
