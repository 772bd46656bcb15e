//! Which exercises a student has done. The next run of the program knows it, too.

use pinhole_lecture::exercises::Exercise;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::features::exercises::state::Exercises;

/// The exercises that were answered all right before their solution was shown, with whatever numbers.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "Value", into = "Vec<&'static str>")]
pub struct Progress(Vec<Exercise>);

impl Progress {
    /// Returns true if the exercise is done.
    pub fn is_done(&self, exercise: Exercise) -> bool {
        self.0.contains(&exercise)
    }

    /// Returns the number of exercises that are done.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// Adds the open exercise if its checked answers are all right.
    pub(crate) fn note(&mut self, exercises: &Exercises) {
        let exercise = exercises.question().exercise;
        if exercises.is_right() && !exercises.saw_solution && !self.is_done(exercise) {
            self.0.push(exercise);
        }
    }

    /// Returns the stored progress `theirs` with the changes from `base` to this one.
    pub(crate) fn merged(&self, base: &Progress, theirs: &Progress) -> Progress {
        let is_done = |exercise: &Exercise| {
            let is_own = self.is_done(*exercise) != base.is_done(*exercise);
            if is_own { self } else { theirs }.is_done(*exercise)
        };
        Progress(Exercise::LISTED.iter().copied().filter(is_done).collect())
    }

    /// Returns the next exercise that is not done, after this one or, behind the last one, from the first on;
    /// `None` if no other is left.
    pub(crate) fn next_after(&self, exercise: Exercise) -> Option<Exercise> {
        let (mut others, before) = (Exercise::LISTED.iter().copied(), exercise);
        let until: Vec<Exercise> = others.by_ref().take_while(|other| *other != before).collect();
        others.chain(until).find(|other| !self.is_done(*other))
    }
}

impl From<Value> for Progress {
    /// Reads the names of exercises, and ignores everything else.
    fn from(value: Value) -> Progress {
        let names = value.as_array().into_iter().flatten().filter_map(Value::as_str);
        let names: Vec<&str> = names.collect();
        let all = Exercise::LISTED.iter().copied();
        Progress(all.filter(|exercise| names.contains(&exercise.id())).collect())
    }
}

impl From<Progress> for Vec<&'static str> {
    fn from(progress: Progress) -> Vec<&'static str> {
        progress.0.into_iter().map(Exercise::id).collect()
    }
}
