//! The user's place in the lessons.

use std::sync::Arc;

use super::builtin;
use super::lesson::{Lesson, Step};

/// The identity of a lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// A built-in lesson, by its index.
    Builtin(usize),
    /// The lesson that was opened from a file.
    File,
}

/// Identifies a step: its lesson, and its index in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepId {
    /// The lesson.
    pub lesson: Which,
    /// Index of the step.
    pub step: usize,
}

/// The open lesson at one of its steps.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenLesson {
    id: StepId,
    lesson: Arc<Lesson>,
}

impl OpenLesson {
    /// Opens the lesson at that place; `file` is the lesson that was opened from a file. Returns
    /// `None` if there is no such step.
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

    /// Returns the whole lesson.
    pub fn lesson(&self) -> &Lesson {
        &self.lesson
    }

    /// Returns the current step.
    pub fn step(&self) -> &Step {
        // In range: `at` checked it.
        &self.lesson.steps[self.id.step]
    }

    /// Returns `Lesson 2: Warm-up`, or only the title of a lesson without a number.
    pub fn title(&self) -> String {
        title_of(self.id.lesson, &self.lesson)
    }

    /// Returns `Lesson 2`, or the title of a lesson without a number.
    pub fn short_title(&self) -> String {
        match self.id.lesson {
            Which::Builtin(index) => format!("Lesson {}", index + 1),
            Which::File => self.lesson.title.clone(),
        }
    }

    /// Returns the id of the next step; after a lesson's last step, of the next lesson's first.
    pub fn next(&self) -> Option<StepId> {
        if self.id.step + 1 < self.lesson.steps.len() {
            return Some(StepId { step: self.id.step + 1, ..self.id });
        }
        let Which::Builtin(index) = self.id.lesson else { return None };
        builtin::all().get(index + 1)?;
        Some(StepId { lesson: Which::Builtin(index + 1), step: 0 })
    }

    /// Returns the id of the previous step; before a lesson's first step, of the previous
    /// lesson's last.
    pub fn previous(&self) -> Option<StepId> {
        if let Some(step) = self.id.step.checked_sub(1) {
            return Some(StepId { step, ..self.id });
        }
        let Which::Builtin(index) = self.id.lesson else { return None };
        let index = index.checked_sub(1)?;
        let step = builtin::all().get(index)?.steps.len() - 1;
        Some(StepId { lesson: Which::Builtin(index), step })
    }

    /// Returns true if both steps show the same scene, so that the world view keeps its observer.
    pub fn shares_scene_with(&self, other: &OpenLesson) -> bool {
        self.lesson == other.lesson && self.step().scene_from == other.step().scene_from
    }
}

/// Returns `Lesson 2: Warm-up`, or only the title of a lesson without a number.
pub fn title_of(which: Which, lesson: &Lesson) -> String {
    match which {
        Which::Builtin(index) => format!("Lesson {}: {}", index + 1, lesson.title),
        Which::File => lesson.title.clone(),
    }
}
