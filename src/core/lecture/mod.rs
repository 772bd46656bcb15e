//! What the lecture works out step by step, with every number in between: for teaching, where the rest
//! of this crate is for tracing.

pub mod exercises;
pub mod mistakes;
