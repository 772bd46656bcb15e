//! The lecture, step by step.
//!
//! A *lesson* is a data file: a title and *steps*, states of the window to look at. `lesson` holds
//! its contents, `read` reads it, `builtin` holds the lessons that come with the program, `open`
//! the user's place in them, and `apply` applies a step to the document and the session. Nothing
//! here calculates anything.

pub mod apply;
mod argument;
pub mod builtin;
mod lesson;
mod open;
mod read;

pub use argument::LessonArgument;
pub use lesson::{AskedExercise, Lesson, Question, Step, StepView};
pub use open::{OpenLesson, StepId, Which, title_of};
pub use read::{VERSION, is_lesson, load, parse};
