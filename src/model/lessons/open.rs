//! Where in the lessons the user is.

use std::sync::Arc;

use super::builtin;
use super::lesson::{Lesson, Step};

/// A lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// One that comes with the program, counted from 0.
    Builtin(usize),
    /// The one that was opened from a file.
    File,
}

/// A step of a lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Which lesson.
    pub lesson: Which,
    /// Which of its steps, counted from 0.
    pub step: usize,
}

/// The lesson that is open, at one of its steps.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenLesson {
    place: Place,
    lesson: Arc<Lesson>,
}

impl OpenLesson {
    /// The lesson at that place; `file` is the one that was opened from a file. `None` where there is
    /// no such step.
    pub fn at(place: Place, file: Option<&Arc<Lesson>>) -> Option<OpenLesson> {
        let lesson = match place.lesson {
            Which::Builtin(index) => builtin::all().get(index),
            Which::File => file,
        }?;
        (place.step < lesson.steps.len()).then(|| OpenLesson { place, lesson: Arc::clone(lesson) })
    }

    /// Which step this is.
    pub fn place(&self) -> Place {
        self.place
    }

    /// The whole lesson.
    pub fn lesson(&self) -> &Lesson {
        &self.lesson
    }

    /// The step.
    pub fn step(&self) -> &Step {
        // In range: `at` is the only way here.
        &self.lesson.steps[self.place.step]
    }

    /// `Lesson 2: Warm-up`, or the title alone of a lesson without a number.
    pub fn title(&self) -> String {
        title_of(self.place.lesson, &self.lesson)
    }

    /// `Lesson 2`, or the title of a lesson without a number.
    pub fn short_title(&self) -> String {
        match self.place.lesson {
            Which::Builtin(index) => format!("Lesson {}", index + 1),
            Which::File => self.lesson.title.clone(),
        }
    }

    /// The step after this one; after a lesson's last, the next lesson's first.
    pub fn next(&self) -> Option<Place> {
        if self.place.step + 1 < self.lesson.steps.len() {
            return Some(Place { step: self.place.step + 1, ..self.place });
        }
        let Which::Builtin(index) = self.place.lesson else { return None };
        builtin::all().get(index + 1)?;
        Some(Place { lesson: Which::Builtin(index + 1), step: 0 })
    }

    /// The step before this one; before a lesson's first, the last lesson's last.
    pub fn previous(&self) -> Option<Place> {
        if let Some(step) = self.place.step.checked_sub(1) {
            return Some(Place { step, ..self.place });
        }
        let Which::Builtin(index) = self.place.lesson else { return None };
        let index = index.checked_sub(1)?;
        let step = builtin::all().get(index)?.steps.len() - 1;
        Some(Place { lesson: Which::Builtin(index), step })
    }

    /// Whether both show the same scene, so that the world view need not be framed anew.
    pub fn shares_scene_with(&self, other: &OpenLesson) -> bool {
        self.lesson == other.lesson && self.step().scene_from == other.step().scene_from
    }
}

/// `Lesson 2: Warm-up`, or the title alone of a lesson without a number.
pub fn title_of(which: Which, lesson: &Lesson) -> String {
    match which {
        Which::Builtin(index) => format!("Lesson {}: {}", index + 1, lesson.title),
        Which::File => lesson.title.clone(),
    }
}
