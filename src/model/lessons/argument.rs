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
        let (lesson, step) = match text.split_once('.') {
            Some((lesson, step)) => (whole(lesson), whole(step)),
            None => (whole(text), Some(1)),
        };
        let (Some(lesson), Some(step)) = (lesson, step) else {
            return match Path::new(text).extension() {
                Some(ending) if ending == "toml" => Ok(LessonArgument::File(text.into())),
                _ => Err(format!(
                    "{text:?} is no lesson: a number from 1 to {}, or the path of a .toml file",
                    builtin::all().len()
                )),
            };
        };
        let count = builtin::all().len();
        let found =
            lesson.checked_sub(1).and_then(|index| Some((index, builtin::all().get(index)?)));
        let Some((index, found)) = found else {
            let typed = text.split('.').next().unwrap_or(text);
            return Err(format!("there is no lesson {typed}: there are lessons 1 to {count}"));
        };
        match step.checked_sub(1).filter(|step| *step < found.steps.len()) {
            Some(step) => {
                Ok(LessonArgument::Builtin(StepId { lesson: Which::Builtin(index), step }))
            }
            None => Err(format!(
                "lesson {lesson} has no step {step}: it has steps 1 to {}",
                found.steps.len()
            )),
        }
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
