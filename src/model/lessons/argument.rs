//! The argument of `--lesson`: the number of a built-in lesson, or a lesson file.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use pinhole_exchange::FileError;

use super::lesson::Lesson;
use super::open::{StepId, Which};
use super::{builtin, read};

/// A lesson named on the command line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LessonArgument {
    /// A lesson that comes with the program.
    Builtin(StepId),
    /// A lesson file.
    File(PathBuf),
}

impl LessonArgument {
    /// Reads `7` (lesson 7), `7.3` (its third step), or the path of a lesson file.
    ///
    /// # Errors
    /// Returns an error if there is no such lesson or step; the message lists those that there are.
    pub fn parse(text: &str) -> Result<LessonArgument, String> {
        let whole = |text: &str| {
            let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
            // A number that overflows usize is no lesson's number either.
            digits.then(|| text.parse().unwrap_or(usize::MAX))
        };
        let lessons = builtin::all();
        let (typed, step) = text.split_once('.').unwrap_or((text, "1"));
        let (Some(lesson), Some(step)) = (whole(typed), whole(step)) else {
            return match Path::new(text).extension() {
                Some(ending) if ending == "toml" => Ok(LessonArgument::File(text.into())),
                _ => Err(format!(
                    "{text:?} is no lesson: a number from 1 to {}, or the path of a .toml file",
                    lessons.len()
                )),
            };
        };
        let index = lesson.wrapping_sub(1);
        let count = lessons.len();
        let found = lessons
            .get(index)
            .ok_or_else(|| format!("there is no lesson {typed}: there are lessons 1 to {count}"))?;
        let (step_index, steps) = (step.wrapping_sub(1), found.steps.len());
        if step_index >= steps {
            return Err(format!("lesson {lesson} has no step {step}: it has steps 1 to {steps}"));
        }
        Ok(LessonArgument::Builtin(StepId { lesson: Which::Builtin(index), step: step_index }))
    }

    /// Returns the place to begin at, and the lesson if it comes from a file.
    ///
    /// # Errors
    /// Returns an error if the file cannot be read or is no valid lesson.
    pub fn load(&self) -> Result<(StepId, Option<Arc<Lesson>>), FileError> {
        match self {
            LessonArgument::Builtin(id) => Ok((*id, None)),
            LessonArgument::File(path) => {
                Ok((StepId { lesson: Which::File, step: 0 }, Some(Arc::new(read::load(path)?))))
            }
        }
    }
}
