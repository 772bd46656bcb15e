//! Exercises: the question, the student's answers, hints, marks in the scene, and what is done.

pub mod hints;
pub mod marks;
pub mod progress;
mod show_me;
pub mod state;
pub mod ui;
mod ui_fields;

pub use progress::Progress;
pub use state::Exercises;
pub(crate) use state::{Feedback, TypedAnswer};
