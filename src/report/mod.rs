//! Measures the error and the run time of every intersection method, and presents the results, for
//! `pinhole report`.
//!
//! [`model`] contains the results. The other modules measure them or present them as text and pictures.

#[cfg(feature = "report")]
pub mod measure;
pub mod model;
pub mod plot;
pub(crate) mod summary;
pub mod table;
