//! The lecture, step by step.
//!
//! A *lesson* is a data file: a title and *steps*, states of the window to look at. `lesson` is what
//! is in it, `read` how it is read, `builtin` the lessons that come with the program, `open` where
//! in them the user is, `apply` how a step becomes what is edited and how it is looked at. Nothing
//! here calculates anything.

pub mod apply;
mod argument;
pub mod builtin;
mod lesson;
mod open;
mod read;

pub use argument::LessonArgument;
pub use lesson::{AskedExercise, Lesson, Looks, Step};
pub use open::{OpenLesson, Place, Which, title_of};
pub use read::{VERSION, is_lesson, load, parse};
