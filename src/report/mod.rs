//! Error against run time: what `pinhole report` measures, and the forms it shows that in.
//!
//! [`model`] is what was measured; everything else turns it into text and pictures.

#[cfg(feature = "report")]
#[cfg(feature = "report")]
pub mod measure;
pub mod model;
pub mod plot;
pub(crate) mod summary;
pub mod table;
