//! Movement of the focused handle by keys.

use egui::{Context, Key};
use pinhole_core::{DVec2, DVec3, ResolvedCamera};

use super::{Edited, HandInput, View, axis_held, id_of, options};
use crate::model::session::hand::{Along, Axis, Handle};
use crate::model::session::keeps_of;
use crate::view::handles::{
    DragOptions, DragStart, Grip, HandleDrag, HandleValues, grips, step_of, turned_by,
};

/// Angle by which a key press turns the camera, in degrees.
const TURN: f64 = 5.0;

/// The steps of the arrow keys: to the right, upwards, and away from the observer.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Steps {
    right: f64,
    up: f64,
    away: f64,
}

impl HandInput {
    /// Moves the focused handle by the arrow keys; K swaps what a moved eye keeps.
    pub(super) fn keys(&mut self, ctx: &Context, view: &View, edited: &mut Edited) {
        let Edited { document, session, .. } = edited;
        let resolved = document.camera.resolve().ok();
        let stage = view.stage(document, resolved.as_ref(), session);
        let all = grips(&stage, &session.hand);
        let has_focus = |g: &&Grip| ctx.memory(|m| m.has_focus(id_of(view.id, g.handle)));
        let focused = all.iter().find(has_focus);
        let looked_at = focused.is_some() || session.hand.over.is_some();
        let is_plain = ctx.input(|i| i.modifiers.is_none());
        if looked_at && is_plain && !ctx.text_edit_focused() && pressed(ctx, Key::K) > 0 {
            session.settings.eye_keeps = session.settings.eye_keeps.other();
        }
        let Some((grip, grasp)) = focused.and_then(|grip| Some((grip, stage.grasp(grip.handle)?)))
        else {
            return;
        };
        let steps = steps(ctx);
        if steps == Steps::default() {
            return;
        }
        let before = HandleValues::read(grip.handle, document, session.selection);
        let start = DragStart { before, resolved, grasp, at: grip.at, begun_at: DVec2::ZERO };
        if let Handle::Pixel = grip.handle {
            let camera = resolved.map(|resolved| session.selection.inside(resolved.image()));
            if let (Some(selection), Some(resolved)) = (camera, resolved) {
                session.selection =
                    selection.stepped(&resolved, -steps.up as i64, steps.right as i64);
            }
            return;
        }
        let (eye, corner, distance) = keeps_of(&session.settings, false);
        let options = DragOptions { eye, corner, distance, ..options(ctx, session) };
        let pull =
            HandleDrag { start: &start, observer: view.observer, scale: view.scale, options };
        let moved = target(&start, view, options.along, steps).map(|point| pull.put(point));
        if let Some(Ok(pulled)) = moved {
            pulled.part.put(document, &mut session.selection);
        }
    }
}

fn pressed(ctx: &Context, key: Key) -> usize {
    ctx.input(|i| i.num_presses(key))
}

fn steps(ctx: &Context) -> Steps {
    let count = |key| pressed(ctx, key) as f64;
    let right = count(Key::ArrowRight) - count(Key::ArrowLeft);
    let up = count(Key::ArrowUp) - count(Key::ArrowDown);
    // Together with an axis's key, Shift chooses the plane of the other two.
    match ctx.input(|i| i.modifiers.shift) && axis_held(ctx).is_none() {
        true => Steps { right, up: 0.0, away: up },
        false => Steps { right, up, away: 0.0 },
    }
}

/// Returns the point to which the keys move a handle.
fn target(start: &DragStart, view: &View, along: Along, steps: Steps) -> Option<DVec3> {
    let step = step_of(view.observer, start.at, view.scale)?;
    let camera = start.resolved.as_ref();
    let forward = steps.right + steps.up + steps.away;
    let way = match start.grasp.handle {
        Handle::Roll => return turned_by(start, -TURN * forward),
        Handle::Dolly | Handle::Distance => -forward * Axis::W.direction(camera)?,
        Handle::Radius(_) => forward * start.grasp.toward,
        Handle::Corner(_) => {
            steps.right * Axis::U.direction(camera)? + steps.up * Axis::V.direction(camera)?
        }
        _ => match along {
            Along::Axis(axis) => forward * axis.direction(camera)?,
            Along::Without(axis) => {
                let [a, b] = axis.others();
                in_plane(view.observer, [a.direction(camera)?, b.direction(camera)?], steps)
            }
            Along::View => {
                let [right, up, away] = axes_of(view.observer);
                steps.right * right + steps.up * up + steps.away * away
            }
        },
    };
    Some(start.at + step * way)
}

/// Returns the movement in the plane of two axes. The axis that points more to the right or left
/// follows the right and left keys, the other one the up and down keys.
fn in_plane(observer: &ResolvedCamera, [a, b]: [DVec3; 2], steps: Steps) -> DVec3 {
    let basis = observer.basis();
    let across = |axis: DVec3| axis.dot(basis.u).abs();
    let (right, up) = if across(a) >= across(b) { (a, b) } else { (b, a) };
    // An axis seen end-on points neither up nor down: away from the observer counts as up.
    let upwards = up.dot(basis.v) - 1e-3 * up.dot(basis.w);
    steps.right * right.dot(basis.u).signum() * right + steps.up * upwards.signum() * up
}

/// Returns the world's axes that point most to the right, upwards and away from the observer.
fn axes_of(observer: &ResolvedCamera) -> [DVec3; 3] {
    let basis = observer.basis();
    let most = |direction: DVec3, taken: DVec3| {
        let free = DVec3::AXES.into_iter().filter(|axis| *axis != taken.abs());
        let along = |axis: &DVec3| axis.dot(direction).abs();
        let axis = free.max_by(|a, b| along(a).total_cmp(&along(b))).unwrap_or(DVec3::X);
        axis * axis.dot(direction).signum()
    };
    let up = most(basis.v, DVec3::ZERO);
    let right = most(basis.u, up);
    let third = right.cross(up).abs();
    [right, up, third * third.dot(-basis.w).signum()]
}
