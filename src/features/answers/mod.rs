//! A student's answers, graded.

mod state;
pub mod ui;

pub use state::{AnswersFile, StudentAnswers};
