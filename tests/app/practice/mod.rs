//! Exercises, mistakes and graded answers.

mod answers;
mod class;
pub(crate) mod exercises;
mod hands;
mod mistakes;
