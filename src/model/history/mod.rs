//! The history of changes, for undo and redo: two stacks of moments, with a name for the step
//! between each moment and the next.

mod names;

pub use names::{StepName, name_of};

/// Maximum number of steps; the oldest are forgotten first.
const LIMIT: usize = 500;

/// The steps before and after the present, which is not stored here. `M` is the data that a moment
/// is restored from.
#[derive(Clone, Debug)]
pub struct History<M> {
    past: Vec<Step<M>>,
    future: Vec<Step<M>>,
}

/// A change that is undone and redone as a whole.
#[derive(Clone, Debug)]
struct Step<M> {
    name: String,
    /// The moment before the step, in the past; the moment after it, in the future.
    moment: M,
}

impl<M> Default for History<M> {
    fn default() -> Self {
        History { past: Vec::new(), future: Vec::new() }
    }
}

impl<M> History<M> {
    /// Records a step from the moment `before`, and forgets all steps that could be redone.
    pub fn record(&mut self, name: String, before: M) {
        self.future.clear();
        if self.past.len() == LIMIT {
            self.past.remove(0);
        }
        self.past.push(Step { name, moment: before });
    }

    /// Extends the last step, which keeps its beginning. Forgets all steps that could be redone.
    pub fn extend(&mut self) {
        self.future.clear();
    }

    /// Returns the name of the step that *Undo* would undo.
    pub fn undo_name(&self) -> Option<&str> {
        self.past.last().map(|step| step.name.as_str())
    }

    /// Returns the name of the step that *Redo* would redo.
    pub fn redo_name(&self) -> Option<&str> {
        self.future.last().map(|step| step.name.as_str())
    }

    /// Returns the moment before the last step, which can then be redone. `now` creates the present
    /// moment, of the same kind as the restored one, for redo to return to. Returns `None` if there
    /// is nothing to undo.
    pub fn undo(&mut self, now: impl FnOnce(&M) -> M) -> Option<M> {
        Self::step(&mut self.past, &mut self.future, now)
    }

    /// Returns the moment after the step that was undone last; see [`History::undo`].
    pub fn redo(&mut self, now: impl FnOnce(&M) -> M) -> Option<M> {
        Self::step(&mut self.future, &mut self.past, now)
    }

    fn step(
        from: &mut Vec<Step<M>>,
        to: &mut Vec<Step<M>>,
        now: impl FnOnce(&M) -> M,
    ) -> Option<M> {
        let Step { name, moment } = from.pop()?;
        to.push(Step { name, moment: now(&moment) });
        Some(moment)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Undoes or redoes from `now`, which becomes the restored moment.
    fn go(now: &mut u32, step: impl FnOnce(&mut u32) -> Option<u32>) -> bool {
        match step(now) {
            Some(moment) => {
                *now = moment;
                true
            }
            None => false,
        }
    }

    #[test]
    fn undone_and_redone_in_order() {
        let (mut history, mut now) = (History::default(), 0);
        for next in 1..=3 {
            history.record(format!("to {next}"), now);
            now = next;
        }
        assert_eq!((history.undo_name(), history.redo_name()), (Some("to 3"), None));
        for expected in [2, 1, 0] {
            assert!(go(&mut now, |now| history.undo(|_| *now)));
            assert_eq!(now, expected);
        }
        assert!(!go(&mut now, |now| history.undo(|_| *now)));
        assert_eq!((history.undo_name(), history.redo_name()), (None, Some("to 1")));
        for expected in [1, 2, 3] {
            assert!(go(&mut now, |now| history.redo(|_| *now)));
            assert_eq!(now, expected);
        }
        assert!(!go(&mut now, |now| history.redo(|_| *now)));
    }

    #[test]
    fn a_new_step_forgets_what_could_be_redone() {
        let mut history = History::default();
        history.record("one".to_owned(), 0);
        assert_eq!(history.undo(|_| 1), Some(0));
        history.record("other".to_owned(), 0);
        assert_eq!(history.redo(|_| 2), None);
        assert_eq!(history.undo_name(), Some("other"));
    }

    #[test]
    fn the_oldest_steps_are_forgotten() {
        let mut history = History::default();
        for k in 0..LIMIT + 10 {
            history.record(String::new(), k);
        }
        let first = std::iter::from_fn(|| history.undo(|moment| *moment)).last();
        assert_eq!(first, Some(10));
    }
}
