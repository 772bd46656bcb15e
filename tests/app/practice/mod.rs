//! Exercises, mistakes and graded answers.

mod answers;
pub(crate) mod exercises;
mod hands;
mod mistakes;
