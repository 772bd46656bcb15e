//! The marks that the overlay draws for handles.

use pinhole_core::{Basis, DVec3};

use super::{PlacedHandle, Stage, placed};
use crate::model::concept::Concept;
use crate::model::session::handles::{Handle, HandleState};
use crate::view::overlay::{self, Guide, HandleMark, Handles, Knob, KnobState};

/// Length of the lines along which a handle moves, to either side, in points.
const GUIDE_POINTS: f64 = 46.0;

/// Returns what the overlay draws for the handles: eye, at and the tip of up, and of the others those
/// that are needed, which belong to what is under the hand, chosen, or `spoken` of.
pub fn drawn(stage: &Stage, state: &HandleState, spoken: &[Concept]) -> Handles {
    let mut placed = placed(stage, state);
    let held = state.drag.and_then(|drag| drag.handle());
    placed.retain(|PlacedHandle { handle, .. }| {
        is_always_drawn(*handle)
            || [state.over, held].into_iter().flatten().any(|other| belong_together(*handle, other))
            || spoken.iter().any(|concept| is_about(*handle, *concept))
    });
    let find = |handle: Option<Handle>| placed.iter().find(|one| Some(one.handle) == handle);
    let (held, over) = (find(held), find(held).or_else(|| find(state.over)));
    let marks = placed.iter().map(|one| HandleMark {
        at: one.at,
        knob: knob(one.handle),
        state: match over {
            Some(over) if over.handle == one.handle && held.is_some() => KnobState::Held,
            Some(over) if over.handle == one.handle => KnobState::Over,
            _ => KnobState::Plain,
        },
    });
    let camera = &stage.document.camera;
    let beyond = stage.beyond(camera.eye);
    let stems = placed.iter().filter_map(|one| {
        let Handle::Normal(k) = one.handle else { return None };
        let point = stage.plane(k)?.point;
        let way = one.at - point;
        let length = way.length();
        (length > 0.0).then(|| [point, point + (1.0 - stage.beyond(point) / length) * way])
    });
    let length_of = |handle| held.filter(|held| held.handle == handle).map(|held| held.length);
    Handles {
        marks: marks.collect(),
        stems: stems.collect(),
        guides: over.map_or(Vec::new(), |over| guides(stage, over)),
        arrow: length_of(Handle::Dolly).map(|length| length - beyond),
        up: length_of(Handle::Up).map(|length| length * camera.up().length() - beyond),
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

/// Returns the lines or the ring along which a handle moves; none for one that moves freely.
fn guides(stage: &Stage, over: &PlacedHandle) -> Vec<Guide> {
    let PlacedHandle { handle, at, .. } = *over;
    let length = overlay::length_of_points(stage.observer, at, GUIDE_POINTS, stage.scale);
    let ring = |center: DVec3, radius: f64, basis: &Basis| {
        vec![Guide::Ring { center, a: radius * basis.u, b: radius * basis.v }]
    };
    let line = |axis: usize| {
        let basis = stage.resolved?.basis();
        let direction = length * [basis.u, basis.v, basis.w][axis];
        Some(Guide::Line { from: at - direction, to: at + direction, axis })
    };
    match handle {
        Handle::Roll => {
            let eye = stage.document.camera.eye;
            stage.resolved.map_or(Vec::new(), |camera| ring(eye, at.distance(eye), camera.basis()))
        }
        Handle::Radius(k) => stage.document.spheres.get(k).map_or(Vec::new(), |item| {
            ring(item.shape.center, item.shape.radius, stage.observer.basis())
        }),
        Handle::Dolly | Handle::Distance => line(2).into_iter().collect(),
        Handle::Corner(_) | Handle::Pixel => [0, 1].into_iter().filter_map(line).collect(),
        _ => Vec::new(),
    }
}
