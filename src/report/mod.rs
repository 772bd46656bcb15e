//! Measures error against run time and shows the results, for `pinhole report`.
//!
//! [`model`] contains the results; the other modules measure them, or turn them into text and pictures.

#[cfg(feature = "report")]
pub mod measure;
pub mod model;
pub mod plot;
pub(crate) mod summary;
pub mod table;
