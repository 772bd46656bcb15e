//! This machine's speed: what `pinhole bench` measures, and the forms it shows that in.
//!
//! [`model`] is what was measured; everything else turns it into something to read. What is measured
//! and against what is [`pinhole_yardstick`]'s.

pub mod measure;
pub mod model;
pub mod plot;
pub mod table;
