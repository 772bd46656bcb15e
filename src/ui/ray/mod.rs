//! The ray workspace: f(p + t d) along the selected ray, and lines in two dimensions.

pub mod lines;
pub mod plot;
