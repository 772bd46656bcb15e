//! The history of changes, for undo and redo: two stacks of named steps. A name says what the step did,
//! such as `move eye`.

use pinhole_exchange::document::Document;

/// Maximum number of steps; beyond it, the oldest are dropped.
const LIMIT: usize = 500;

/// The steps that can be undone and redone, each with its name. `M` is a snapshot of the state, to be
/// restored. The current state is not stored here.
#[derive(Clone, Debug)]
pub struct History<M> {
    /// The steps that can be undone, oldest first, each with a snapshot of the state before it.
    past: Vec<(String, M)>,
    /// The steps that can be redone, each with a snapshot of the state after it. The last one is redone
    /// first.
    future: Vec<(String, M)>,
}

impl<M> Default for History<M> {
    fn default() -> Self {
        History { past: Vec::new(), future: Vec::new() }
    }
}

impl<M> History<M> {
    /// Records a step that began in the state `before`, and drops all steps that could be redone.
    pub fn record(&mut self, name: String, before: M) {
        self.extend();
        if self.past.len() == LIMIT {
            self.past.remove(0);
        }
        self.past.push((name, before));
    }

    /// Extends the last step to a further change: undoing it still restores the state before its first
    /// change. Drops all steps that could be redone.
    pub fn extend(&mut self) {
        self.future.clear();
    }

    /// Drops the steps that can be undone before the newest ones whose snapshots all fit. They are asked one after
    /// another, the newest first.
    pub fn keep_newest(&mut self, mut fits: impl FnMut(&M) -> bool) {
        let last = self.past.iter().rposition(|(_, before)| !fits(before));
        self.past.drain(..last.map_or(0, |last| last + 1));
    }

    /// Returns the name of the step that *Undo* would undo; `None` if there is none.
    pub fn undo_name(&self) -> Option<&str> {
        self.past.last().map(|(name, _)| name.as_str())
    }

    /// Returns the name of the step that *Redo* would redo; `None` if there is none.
    pub fn redo_name(&self) -> Option<&str> {
        self.future.last().map(|(name, _)| name.as_str())
    }

    /// Undoes the last step, or redoes the step that was undone last, and returns the snapshot to restore.
    /// `now` receives that snapshot and returns one of the current state, with the same kind of data, for
    /// the way back. Returns `None` if there is no step to undo or redo.
    pub fn step(&mut self, is_redo: bool, now: impl FnOnce(&M) -> M) -> Option<M> {
        let History { past, future } = self;
        let (from, to) = if is_redo { (future, past) } else { (past, future) };
        let (name, moment) = from.pop()?;
        to.push((name, now(&moment)));
        Some(moment)
    }
}

/// The name of a step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StepName {
    /// The text after *Undo* in the menu.
    pub text: String,
    /// True if the change is one of a gradual series, such as the drag of a number or the typing of a name.
    /// A change with the same name that soon follows then extends the step instead of adding another one.
    pub gradual: bool,
}

/// Returns the name of the step between two documents: what has changed, if it is one thing. Steps that give
/// the camera in another way, and those that add or remove objects, are not gradual.
pub fn name_of(before: &Document, after: &Document) -> StepName {
    let (old, new) = (&before.camera, &after.camera);
    let camera = [
        ("move eye", old.eye != new.eye),
        ("turn the camera", old.orientation != new.orientation),
        ("change the viewport", old.viewport != new.viewport),
        ("change the image's size", old.image != new.image),
    ];
    let objects = [
        ("change spheres", before.spheres != after.spheres),
        ("change planes", before.planes != after.planes),
        ("change the spheres' file", before.csv_spheres != after.csv_spheres),
    ];
    let observer = [("keep the view", before.observer != after.observer)];
    let of_camera = camera.iter().any(|(_, has_changed)| *has_changed);
    let of_objects = objects.iter().any(|(_, has_changed)| *has_changed);
    let parts = camera.into_iter().chain(objects).chain(observer);
    let changed: Vec<&str> = parts.filter(|part| part.1).map(|(name, _)| name).collect();
    let text = match changed[..] {
        [one] => one,
        _ if !of_objects => "change the camera",
        _ => "change the scene",
    };
    let kinds = |document: &Document| {
        let Document { camera, spheres, planes, .. } = document;
        (camera.orientation.kind(), spheres.len(), planes.len())
    };
    let gradual = of_camera != of_objects && kinds(before) == kinds(after);
    StepName { text: text.to_owned(), gradual }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Undoes or redoes a step in the state `now`, which is replaced by the restored state.
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
            assert!(go(&mut now, |now| history.step(false, |_| *now)));
            assert_eq!(now, expected);
        }
        assert!(!go(&mut now, |now| history.step(false, |_| *now)));
        assert_eq!((history.undo_name(), history.redo_name()), (None, Some("to 1")));
        for expected in [1, 2, 3] {
            assert!(go(&mut now, |now| history.step(true, |_| *now)));
            assert_eq!(now, expected);
        }
        assert!(!go(&mut now, |now| history.step(true, |_| *now)));
    }

    #[test]
    fn a_new_step_forgets_what_could_be_redone() {
        let mut history = History::default();
        history.record("one".to_owned(), 0);
        assert_eq!(history.step(false, |_| 1), Some(0));
        history.record("other".to_owned(), 0);
        assert_eq!(history.step(true, |_| 2), None);
        assert_eq!(history.undo_name(), Some("other"));
    }

    #[test]
    fn the_oldest_steps_are_forgotten() {
        let mut history = History::default();
        for k in 0..LIMIT + 10 {
            history.record(String::new(), k);
        }
        let first = std::iter::from_fn(|| history.step(false, |moment| *moment)).last();
        assert_eq!(first, Some(10));
    }

    #[test]
    fn only_the_newest_that_fit_are_kept() {
        let mut history = History::default();
        [5, 1, 9, 2, 3].into_iter().for_each(|size| history.record(String::new(), size));
        let mut sum = 0;
        history.keep_newest(|size| {
            sum += size;
            sum <= 10
        });
        let kept: Vec<i32> = std::iter::from_fn(|| history.step(false, |size| *size)).collect();
        assert_eq!(kept, [3, 2]);
    }
}

#[cfg(test)]
mod names_tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use pinhole_core::steering::Keep;
    use pinhole_core::{Camera, DVec3, ImageSize, Orientation, OrientationKind, Plane, Sphere};
    use pinhole_exchange::document::Item;

    use super::*;
    use pinhole_figure::Observer;

    fn scene() -> Document {
        let ball = Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 };
        let mut named = Item::plain(ball);
        named.name = Some("ball".to_owned());
        let floor = Plane { point: DVec3::NEG_Y, normal: DVec3::Y };
        Document {
            spheres: vec![named, Item::plain(ball)].into(),
            planes: vec![Item::plain(floor)].into(),
            camera: Camera { eye: DVec3::Z, ..Camera::CANONICAL },
            ..Document::default()
        }
    }

    #[track_caller]
    fn assert_name(expected: &str, gradual: bool, change: impl FnOnce(&mut Document)) {
        let before = scene();
        let mut after = before.clone();
        change(&mut after);
        let name = name_of(&before, &after);
        assert_eq!((name.text.as_str(), name.gradual), (expected, gradual));
    }

    #[test]
    fn changes_of_one_thing_have_its_name() {
        assert_name("move eye", true, |d| d.camera.eye.x = 2.0);
        assert_name("turn the camera", true, |d| {
            d.camera.orientation = Orientation::At { at: DVec3::ONE, up: DVec3::Y };
        });
        assert_name("change the camera", true, |d| {
            d.camera = d.camera.with_eye(DVec3::X, Keep::View);
        });
        assert_name("change the viewport", true, |d| d.camera.viewport.distance = 2.0);
        assert_name("change the image's size", true, |d| {
            d.camera.image = ImageSize::new(10, 10).unwrap();
        });
        assert_name("turn the camera", false, |d| {
            d.camera = d.camera.given_by(OrientationKind::Basis).unwrap();
        });
        assert_name("keep the view", false, |d| {
            d.observer = Some(Observer::new(DVec3::ZERO, 0.5, 0.5, 5.0).stored())
        });
        assert_name("change spheres", true, |d| d.spheres[0].shape.center.x = 1.0);
        assert_name("change planes", true, |d| d.planes[0].color = Some([1, 2, 3]));
        assert_name("change spheres", false, |d| drop(d.spheres.remove(0)));
        assert_name("change the scene", false, |d| {
            d.camera.eye.x = 2.0;
            d.spheres[0].shape.radius = 2.0;
        });
    }
}
