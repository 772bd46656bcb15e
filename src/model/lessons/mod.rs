//! The lessons of the lecture.
//!
//! A *lesson* is a data file with a title and *steps*; each step sets the window to a state to look at.
//! `lesson` contains the data of a lesson and the user's place in it, `keys` lists the keys of a step, `read`
//! reads a lesson file, `write` adds what the window shows to it as a step, `builtin` lists the lessons that come
//! with the program, and `apply` applies a step to the document and the session. Nothing here calculates anything.

pub mod apply;
pub mod builtin;
mod keys;
mod lesson;
mod read;
mod write;

pub use lesson::{
    AskedExercise, Lesson, LessonArgument, OpenLesson, Step, StepId, StepQuestion, Which, title_of,
};
pub use read::{VERSION, is_lesson, load, parse};
pub use write::with_step;
