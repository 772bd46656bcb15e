//! Tables: many spheres, and rays.

pub mod rays;
pub mod spheres;
pub(crate) mod table;
