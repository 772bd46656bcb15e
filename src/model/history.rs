//! The history of changes, for undo and redo: two stacks of named steps. A name says what the step did,
//! such as `move eye` or `add sphere 2`.

use pinhole_core::{Camera, Orientation};
use pinhole_exchange::document::{Document, Item};

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

/// Returns the name of the step from `before` to `after`.
pub fn name_of(before: &Document, after: &Document) -> StepName {
    let camera =
        (before.camera != after.camera).then(|| camera_name(&before.camera, &after.camera));
    let objects = objects_name(before, after);
    match (camera, objects) {
        (Some(text), None) => {
            let text = text.to_owned();
            let same_kind = before.camera.orientation.kind() == after.camera.orientation.kind();
            StepName { text, gradual: same_kind }
        }
        (None, Some(name)) => name,
        _ => StepName { text: "change the scene".to_owned(), gradual: false },
    }
}

fn camera_name(before: &Camera, after: &Camera) -> &'static str {
    let mut parts = vec![("move eye", before.eye != after.eye)];
    parts.extend(match (before.orientation, after.orientation) {
        (Orientation::At { at: a, up: b }, Orientation::At { at: c, up: d }) => {
            vec![("move at", a != c), ("turn up", b != d)]
        }
        (Orientation::View { view: a, up: b }, Orientation::View { view: c, up: d }) => {
            vec![("turn view", a != c), ("turn up", b != d)]
        }
        (Orientation::Basis(a), Orientation::Basis(b)) => {
            vec![("set u", a.u != b.u), ("set v", a.v != b.v), ("set w", a.w != b.w)]
        }
        (_, Orientation::At { .. }) => vec![("give the camera by eye, at, up", true)],
        (_, Orientation::View { .. }) => vec![("give the camera by eye, view, up", true)],
        (_, Orientation::Basis(_)) => vec![("give the camera by u, v, w", true)],
    });
    let (old, new) = (before.viewport, after.viewport);
    parts.extend([
        ("change width", old.width != new.width),
        ("change height", old.height != new.height),
        ("change distance", old.distance != new.distance),
        ("change the image's size", before.image != after.image),
    ]);
    let changed: Vec<&str> =
        parts.into_iter().filter(|(_, is_other)| *is_other).map(|(name, _)| name).collect();
    let [was_long, is_long] = [before, after].map(|camera| camera.view().length());
    match changed[..] {
        _ if *after == Camera::CANONICAL => "canonical camera",
        // The distance is unchanged: at moved around the eye, as when the camera looks around.
        ["move at"] if (is_long - was_long).abs() <= 1e-12 * was_long => "look around",
        [name] => name,
        ["move eye", "move at"] => "move eye and at",
        ["move at", "turn up"] => "move at and turn up",
        ["turn view", "turn up"] => "turn view and up",
        ["set u", "set v" | "set w"] | ["set v", "set w"] | ["set u", "set v", "set w"] => {
            "turn u, v, w"
        }
        ["change width", "change height"] => "change the field of view",
        ["change width", "change height", "change distance"] => "scale distance, width and height",
        _ => "change the camera",
    }
}

/// Returns the name of a change of the objects; `None` if the objects did not change.
fn objects_name(before: &Document, after: &Document) -> Option<StepName> {
    let spheres = change(&before.spheres, &after.spheres, "resize", |a, b| {
        [a.center != b.center, a.radius != b.radius]
    });
    let planes = change(&before.planes, &after.planes, "turn", |a, b| {
        [a.point != b.point, a.normal != b.normal]
    });
    let is_same_file = before.csv_spheres == after.csv_spheres;
    let (change, counts) = match (spheres, planes) {
        (Change::None, Change::None) if is_same_file => return None,
        (change, Change::None) if is_same_file => (change, [0, 0]),
        (Change::None, change) => (change, [before.sphere_count(), after.sphere_count()]),
        _ => (Change::Many, [0, 0]),
    };
    let text = match change {
        Change::Added(k) => format!("add {}", after.title_of(counts[1] + k)),
        Change::Removed(k) => format!("remove {}", before.title_of(counts[0] + k)),
        Change::Edited(k, what) => {
            let text = format!("{what} {}", before.title_of(counts[0] + k));
            return Some(StepName { text, gradual: true });
        }
        Change::None | Change::Many => "change the scene".to_owned(),
    };
    Some(StepName { text, gradual: false })
}

/// The change of a list of objects.
enum Change {
    None,
    /// The object with this index was added.
    Added(usize),
    /// The object with this index was removed.
    Removed(usize),
    /// Only the object with this index was edited; the text says how.
    Edited(usize, &'static str),
    /// Several objects changed.
    Many,
}

/// Returns how a list of objects changed. For two shapes, `differ` returns whether their positions differ
/// and whether anything else differs; `reshape` is the verb for a change of anything else.
fn change<S: PartialEq>(
    before: &[Item<S>],
    after: &[Item<S>],
    reshape: &'static str,
    differ: impl Fn(&S, &S) -> [bool; 2],
) -> Change {
    let pairs = || before.iter().zip(after);
    let first = pairs().take_while(|(a, b)| a == b).count();
    match (before.len(), after.len()) {
        (old, new) if new == old + 1 => Change::Added(first),
        (old, new) if old == new + 1 => Change::Removed(first),
        (old, new) if old != new => Change::Many,
        _ => match pairs().filter(|(a, b)| a != b).collect::<Vec<_>>()[..] {
            [] => Change::None,
            [(a, b)] if a.shape != b.shape => match differ(&a.shape, &b.shape) {
                [true, false] => Change::Edited(first, "move"),
                [false, true] => Change::Edited(first, reshape),
                _ => Change::Edited(first, "change"),
            },
            [(a, b)] if a.name != b.name => Change::Edited(first, "rename"),
            [_] => Change::Edited(first, "colour"),
            _ => Change::Many,
        },
    }
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
}

#[cfg(test)]
mod names_tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use pinhole_core::steering::Keep;
    use pinhole_core::{DVec3, ImageSize, OrientationKind, Plane, Sphere};

    use super::*;

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
    fn changes_of_the_camera() {
        assert_name("move eye", true, |d| d.camera.eye.x = 2.0);
        assert_name("move at", true, |d| {
            d.camera.orientation = Orientation::At { at: DVec3::ONE, up: DVec3::Y };
        });
        assert_name("look around", true, |d| {
            let at = DVec3::new(2.0, 0.0, 1.0);
            d.camera.orientation = Orientation::At { at, up: DVec3::Y };
        });
        assert_name("turn up", true, |d| {
            d.camera.orientation = Orientation::At { at: DVec3::NEG_Z, up: DVec3::X };
        });
        assert_name("move eye and at", true, |d| {
            d.camera = d.camera.with_eye(DVec3::X, Keep::View);
        });
        assert_name("change distance", true, |d| d.camera.viewport.distance = 2.0);
        assert_name("change the field of view", true, |d| {
            d.camera.viewport.width = 2.0;
            d.camera.viewport.height = 2.0;
        });
        assert_name("scale distance, width and height", true, |d| {
            d.camera = d.camera.scaled_picture(3.0).unwrap();
        });
        assert_name("change the image's size", true, |d| {
            d.camera.image = ImageSize::new(10, 10).unwrap();
        });
        assert_name("give the camera by u, v, w", false, |d| {
            let given = d.camera.given_by(OrientationKind::Basis).unwrap();
            d.camera = given;
        });
        assert_name("canonical camera", true, |d| d.camera = Camera::CANONICAL);
    }

    #[test]
    fn changes_of_the_objects() {
        assert_name("move sphere 0 “ball”", true, |d| d.spheres[0].shape.center.x = 1.0);
        assert_name("resize sphere 1", true, |d| d.spheres[1].shape.radius = 2.0);
        assert_name("rename sphere 1", true, |d| d.spheres[1].name = Some("b".to_owned()));
        assert_name("colour plane 2", true, |d| d.planes[0].color = Some([1, 2, 3]));
        assert_name("turn plane 2", true, |d| d.planes[0].shape.normal = DVec3::X);
        assert_name("remove sphere 0 “ball”", false, |d| drop(d.spheres.remove(0)));
        assert_name("add sphere 2", false, |d| {
            let more = d.spheres[1].clone();
            d.spheres.push(more);
        });
        assert_name("add plane 3", false, |d| {
            let more = d.planes[0].clone();
            d.planes.push(more);
        });
        assert_name("change the scene", false, |d| d.spheres.clear());
        assert_name("change the scene", false, |d| {
            d.camera.eye.x = 2.0;
            d.spheres[0].shape.radius = 2.0;
        });
    }
}
