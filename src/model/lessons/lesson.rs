//! The contents of a lesson file, the user's place in a lesson, and the argument of `--lesson`.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use pinhole_exchange::{Document, FileError};
use pinhole_figure::OverlayItems;
use pinhole_lecture::Exercise;

use crate::features::play::state::Kind;
use crate::model::lessons::{builtin, read};
use crate::model::{Shown, ViewLayout};

/// A lesson: a list of steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Lesson {
    /// The lesson's title.
    pub title: String,
    /// The steps; at least one.
    pub steps: Vec<Step>,
    /// The file that the lesson was read from; `None` for a built-in lesson.
    pub file: Option<PathBuf>,
}

/// A step of a lesson: a state of the window, with a text about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The step's title.
    pub title: String,
    /// The instructions: what to look at or to drag. In it, `*u*` denotes a scalar and `**u**` a vector.
    pub text: String,
    /// The question that the class answers before any number is shown.
    pub question: Option<StepQuestion>,
    /// The document that the step opens, without the spheres of a CSV file.
    pub document: Document,
    /// Index of the step that set the scene. Steps with the same scene also share the world view's
    /// observer, unless they specify another one.
    pub scene_from: usize,
    /// What the step shows, of which its keys and those of the steps before it say a part. The rest is left as the
    /// lecturer has it.
    pub shown: Shown,
    /// The keys that it or a step before it says.
    pub(super) said: BTreeSet<&'static str>,
    /// True if the observer is not fitted to the view.
    pub keep_observer: bool,
    /// The animation to open, at its start.
    pub play: Option<Kind>,
    /// The question of the exercises layout; `None` leaves it as it is.
    pub exercise: Option<AskedExercise>,
}

impl Step {
    /// Returns true if the step or one before it says this key, which sets a part of what is shown.
    pub fn says(&self, key: &str) -> bool {
        self.said.contains(key)
    }

    /// Returns the layout of the views that the step sets.
    pub fn layout(&self) -> Option<ViewLayout> {
        self.says("layout").then_some(self.shown.setup.layout)
    }
}

/// A question to the class and its answer. Symbols are marked as in a step's text: `*u*` and `**u**`.
#[derive(Clone, Debug, PartialEq)]
pub struct StepQuestion {
    /// The question.
    pub ask: String,
    /// The answer, which replaces the question on the screen.
    pub answer: String,
    /// The answers among which the class votes, the right one first; none if there is no vote on it.
    pub choices: Vec<String>,
    /// The overlay items that would reveal the answer, and are hidden while the question is open.
    pub hidden: OverlayItems,
}

/// The exercise that a step opens: the lecture's own question of a kind, or a similar one with random
/// numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AskedExercise {
    /// The kind of question.
    pub exercise: Exercise,
    /// The seed of the question's random numbers; `None` for the lecture's own numbers.
    pub seed: Option<u64>,
}

/// Identifies a lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// A built-in lesson, by its index.
    Builtin(usize),
    /// The lesson that was opened from a file.
    File,
}

/// Identifies a step: its lesson, and its index in the lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepId {
    /// The lesson.
    pub lesson: Which,
    /// Index of the step.
    pub step: usize,
}

/// The open lesson at one of its steps.
#[derive(Clone, Debug)]
pub struct OpenLesson {
    id: StepId,
    lesson: Arc<Lesson>,
}

impl PartialEq for OpenLesson {
    /// Returns true if this is the same step of the same loaded lesson. The contents are not compared.
    fn eq(&self, other: &OpenLesson) -> bool {
        self.id == other.id && Arc::ptr_eq(&self.lesson, &other.lesson)
    }
}

impl OpenLesson {
    /// Opens a lesson at this step. `file` is the lesson if it was read from a file, and `None` for a
    /// built-in one. Returns `None` if there is no such step.
    pub fn at(id: StepId, file: Option<&Arc<Lesson>>) -> Option<OpenLesson> {
        let lesson = match id.lesson {
            Which::Builtin(index) => builtin::all().get(index),
            Which::File => file,
        }?;
        (id.step < lesson.steps.len()).then(|| OpenLesson { id, lesson: Arc::clone(lesson) })
    }

    /// Returns the id of the current step.
    pub fn id(&self) -> StepId {
        self.id
    }

    /// Returns the step's number among the steps of all built-in lessons, and the number of these; `None`
    /// for a lesson from a file.
    pub fn number_of_all(&self) -> Option<[usize; 2]> {
        let Which::Builtin(index) = self.id.lesson else { return None };
        let count = |lessons: &[Arc<Lesson>]| lessons.iter().map(|lesson| lesson.steps.len()).sum();
        let before: usize = count(&builtin::all()[..index]);
        Some([before + self.id.step + 1, count(builtin::all())])
    }

    /// Returns the whole lesson.
    pub fn lesson(&self) -> &Lesson {
        &self.lesson
    }

    /// Returns the current step.
    pub fn step(&self) -> &Step {
        // In range: the constructor `at` checked it.
        &self.lesson.steps[self.id.step]
    }

    /// Returns `Lesson 2`, or the title of a lesson without a number.
    pub fn short_title(&self) -> String {
        match self.id.lesson {
            Which::Builtin(index) => format!("Lesson {}", index + 1),
            Which::File => self.lesson.title.clone(),
        }
    }

    /// Returns the id of the next step. After the last step of a built-in lesson, that is the first
    /// step of the next lesson. Returns `None` if there is no next step.
    pub fn next(&self) -> Option<StepId> {
        if self.id.step + 1 < self.lesson.steps.len() {
            return Some(StepId { step: self.id.step + 1, ..self.id });
        }
        let Which::Builtin(index) = self.id.lesson else { return None };
        builtin::all().get(index + 1)?;
        Some(StepId { lesson: Which::Builtin(index + 1), step: 0 })
    }

    /// Returns the id of the previous step. Before the first step of a built-in lesson, that is the
    /// last step of the previous lesson. Returns `None` if there is no previous step.
    pub fn previous(&self) -> Option<StepId> {
        if let Some(step) = self.id.step.checked_sub(1) {
            return Some(StepId { step, ..self.id });
        }
        let Which::Builtin(index) = self.id.lesson else { return None };
        let index = index.checked_sub(1)?;
        let step = builtin::all().get(index)?.steps.len() - 1;
        Some(StepId { lesson: Which::Builtin(index), step })
    }

    /// Returns true if both steps show the same scene, in which case the world view keeps its observer.
    pub fn shares_scene_with(&self, other: &OpenLesson) -> bool {
        Arc::ptr_eq(&self.lesson, &other.lesson)
            && self.step().scene_from == other.step().scene_from
    }
}

/// Returns `Lesson 2: Warm-up`, or only the title of a lesson without a number.
pub fn title_of(which: Which, lesson: &Lesson) -> String {
    match which {
        Which::Builtin(index) => format!("Lesson {}: {}", index + 1, lesson.title),
        Which::File => lesson.title.clone(),
    }
}

/// A lesson named on the command line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LessonArgument {
    /// A lesson that comes with the program.
    Builtin(StepId),
    /// A lesson file.
    File(PathBuf),
}

impl LessonArgument {
    /// Parses `7` (lesson 7), `7.3` (its third step), or the path of a lesson file.
    ///
    /// # Errors
    /// Returns a message that lists the existing lessons or steps if there is no such lesson or step.
    pub fn parse(text: &str) -> Result<LessonArgument, String> {
        let whole = |text: &str| {
            let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
            // A number that overflows usize cannot be a lesson's number.
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

    /// Returns the step to begin with, and the lesson if it comes from a file.
    ///
    /// # Errors
    /// Returns an error if the file cannot be read or is not a valid lesson.
    pub fn load(&self) -> Result<(StepId, Option<Arc<Lesson>>), FileError> {
        match self {
            LessonArgument::Builtin(id) => Ok((*id, None)),
            LessonArgument::File(path) => {
                Ok((StepId { lesson: Which::File, step: 0 }, Some(Arc::new(read::load(path)?))))
            }
        }
    }
}
