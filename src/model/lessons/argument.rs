//! What `--lesson` means: one of the lessons by its number, or a lesson file.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::builtin;
use super::lesson::Lesson;
use super::open::{Place, Which};
use super::read;
use pinhole_exchange::FileError;

/// A lesson named on the command line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LessonArgument {
    /// One that comes with the program.
    Builtin(Place),
    /// A teacher's own.
    File(PathBuf),
}

impl LessonArgument {
    /// Reads `7` (lesson 7), `7.3` (its third step), or the path of a lesson file.
    ///
    /// # Errors
    /// Where there is no such lesson or step; with what there is.
    pub fn of(text: &str) -> Result<LessonArgument, String> {
        let whole = |text: &str| {
            let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
            // A number too large for usize is too large for a lesson, too.
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
                Ok(LessonArgument::Builtin(Place { lesson: Which::Builtin(index), step }))
            }
            None => Err(format!(
                "lesson {lesson} has no step {step}: it has steps 1 to {}",
                found.steps.len()
            )),
        }
    }

    /// Where to begin, and the lesson if it is from a file.
    ///
    /// # Errors
    /// What is wrong with the file.
    pub fn load(&self) -> Result<(Place, Option<Arc<Lesson>>), FileError> {
        match self {
            LessonArgument::Builtin(place) => Ok((*place, None)),
            LessonArgument::File(path) => {
                Ok((Place { lesson: Which::File, step: 0 }, Some(Arc::new(read::load(path)?))))
            }
        }
    }
}
