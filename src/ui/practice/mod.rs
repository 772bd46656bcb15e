//! The practice workspace: exercises, wrong cameras, and a student's answers.

pub mod answers;
pub mod exercises;
pub mod mistakes;
