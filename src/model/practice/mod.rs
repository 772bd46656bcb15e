//! The practice of a student: exercises, classic mistakes, and answers to be graded.

pub mod answer_marks;
pub mod exercises;
pub mod mistakes_view;
pub mod student_answers;
