//! The practice of a student: exercises, classic mistakes, and answers to be graded.

mod exercise_twins;
pub mod exercises;
pub mod mistakes_view;
pub mod student_answers;
pub mod twin;
