//! Exercises, mistakes and graded answers.

mod answers;
mod class;
mod diagnosis;
pub(crate) mod exercises;
mod hands;
mod mistakes;
mod progress;
mod show_me;
