//! The marks that the overlay draws for handles.

use pinhole_core::DVec3;

use super::{Grip, Stage, grips};
use crate::model::concept::Concept;
use crate::model::session::hand::{Along, Axis, Hand, Handle};
use crate::view::overlay::{self, Guide, HandleMark, Handles, Knob, KnobState};

/// Length of the axes at a hovered handle, to either side, in points.
const STUB_POINTS: f64 = 46.0;

/// Length of an axis during a drag along it, as a multiple of the observer's distance.
const LONG: f64 = 100.0;

/// Returns what the overlay draws for the handles: eye, at and the tip of up, and of the others those
/// that are needed, which belong to what is under the hand, chosen, or `spoken` of.
pub fn drawn(stage: &Stage, hand: &Hand, spoken: &[Concept]) -> Handles {
    let mut grips = grips(stage, hand);
    let in_hand = [hand.over, hand.held.map(|grasp| grasp.handle)];
    grips.retain(|grip| {
        let handle = grip.handle;
        is_always_drawn(handle)
            || in_hand.into_iter().flatten().any(|other| belong_together(handle, other))
            || spoken.iter().any(|concept| is_about(handle, *concept))
    });
    let is_marked = |grip: &&Grip| hand.held.is_some_and(|held| held.handle == grip.handle);
    let held = grips.iter().find(is_marked);
    let over = held.or_else(|| grips.iter().find(|grip| hand.over == Some(grip.handle)));
    let marks = grips.iter().map(|grip| HandleMark {
        at: grip.at,
        knob: knob(grip.handle),
        state: match over {
            Some(over) if over.handle == grip.handle && held.is_some() => KnobState::Held,
            Some(over) if over.handle == grip.handle => KnobState::Over,
            _ => KnobState::Plain,
        },
    });
    let grasp = hand.held;
    let beyond = stage.beyond(stage.document.camera.eye);
    let stems = grips.iter().filter_map(|grip| {
        let Handle::Normal(k) = grip.handle else { return None };
        let point = stage.position(Handle::Point(k), stage.grasp(Handle::Point(k))?)?;
        let way = grip.at - point;
        let length = way.length();
        (length > 0.0).then(|| [point, point + (1.0 - stage.beyond(point) / length) * way])
    });
    Handles {
        marks: marks.collect(),
        stems: stems.collect(),
        guides: over.map_or(Vec::new(), |grip| guides(stage, grip, hand)),
        arrow: grasp.filter(|g| g.handle == Handle::Dolly).map(|g| g.length - beyond),
        up: grasp
            .filter(|g| g.handle == Handle::Up)
            .map(|g| g.length * stage.document.camera.up().length() - beyond),
    }
}

/// Returns true for the handles of what a camera is given by, and for those of the objects that are
/// chosen or pointed at: others have none.
fn is_always_drawn(handle: Handle) -> bool {
    matches!(handle, Handle::Eye | Handle::At | Handle::Up) || handle.object().is_some()
}

/// Returns true for a handle itself, and for the handles of one viewport.
fn belong_together(handle: Handle, other: Handle) -> bool {
    let is_of_viewport = |handle| matches!(handle, Handle::Corner(_) | Handle::Distance);
    handle == other || (is_of_viewport(handle) && is_of_viewport(other))
}

/// Returns true if a handle changes what the concept names.
fn is_about(handle: Handle, concept: Concept) -> bool {
    match handle {
        Handle::Roll => concept == Concept::V,
        Handle::Dolly => concept == Concept::W,
        Handle::Corner(_) => concept == Concept::Viewport,
        Handle::Distance => matches!(concept, Concept::Viewport | Concept::Distance),
        Handle::Pixel => matches!(concept, Concept::Pixel | Concept::Ray | Concept::Direction),
        _ => false,
    }
}

fn knob(handle: Handle) -> Knob {
    match handle {
        Handle::Corner(_) | Handle::Pixel => Knob::Square,
        Handle::Distance | Handle::Dolly | Handle::Radius(_) => Knob::Diamond,
        _ => Knob::Round,
    }
}

/// Returns guides for all directions in which the handle can be dragged, or for the one in which it
/// is dragged.
fn guides(stage: &Stage, grip: &Grip, hand: &Hand) -> Vec<Guide> {
    let stub = overlay::length_of_points(stage.observer, grip.at, STUB_POINTS, stage.scale);
    let long = LONG * stage.observer.eye().distance(grip.at);
    let line = |axis: Axis, length: f64| {
        let direction = length * axis.direction(stage.resolved)?;
        let (from, to) = (grip.at - direction, grip.at + direction);
        Some(Guide::Line { from, to, axis: axis as usize, is_long: length > stub })
    };
    let lines = |axes: &[Axis], length: f64| axes.iter().filter_map(|a| line(*a, length)).collect();
    let ring = |center: DVec3, a: DVec3, b: DVec3| vec![Guide::Ring { center, a, b }];
    let eye = stage.document.camera.eye;
    match (grip.handle, hand.held.is_some(), hand.along) {
        (Handle::Roll, ..) => stage.resolved.map_or(Vec::new(), |resolved| {
            let length = grip.at.distance(eye);
            ring(eye, length * resolved.basis().u, length * resolved.basis().v)
        }),
        (Handle::Dolly, ..) | (Handle::Distance, ..) => lines(&[Axis::W], stub),
        (Handle::Radius(k), ..) => stage.document.spheres.get(k).map_or(Vec::new(), |item| {
            let (center, radius) = (item.shape.center, item.shape.radius);
            let basis = stage.observer.basis();
            ring(center, radius * basis.u, radius * basis.v)
        }),
        (handle, true, Along::Axis(axis)) if handle.is_free() => lines(&[axis], long),
        (handle, true, Along::Without(axis)) if handle.is_free() => lines(&axis.others(), long),
        (Handle::Corner(_) | Handle::Pixel, ..) => lines(&[Axis::U, Axis::V], stub),
        (_, true, _) => Vec::new(),
        (_, false, _) => lines(&[Axis::X, Axis::Y, Axis::Z], stub),
    }
}
