//! Steps by keys and by the wheel: of the focused handle, of the camera in its view, and of the loupe.
//! [`pinhole_core::steering`] calculates the cameras.

use egui::{Context, Key, Response};
use pinhole_core::steering::{SteerError, rounded_to};
use pinhole_core::{Basis, Camera, DVec2, DVec3, ResolvedCamera};

use super::dragging::{Dragging, Edited, View};
use crate::model::interaction::{KEY_NEARER, KEY_ROLL, KEY_TURN, LOUPE_SCROLL, PAUSE};
use crate::model::overlay_items::Item;
use crate::model::session::handles::{Drag, Handle};
use crate::model::session::{LOUPE_PIXELS, Settings};
use crate::ui::action::Steer;
use crate::view::handle_drag::{step_of, turned_by};

/// The effect of a drag in the camera view, of its keys or of the wheel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    Look,
    Orbit,
    Zoom,
    Dolly,
}

/// The recent steps of the camera by wheel or keys.
#[derive(Debug)]
pub(super) struct RecentSteps {
    pub(super) way: Way,
    before: Camera,
    /// The resulting camera.
    made: Camera,
    /// Sum of the steps: to the right and up; if there is only one direction, x is forwards.
    total: DVec2,
    pub(super) time: f64,
    pub(super) by_keys: bool,
}

impl View<'_> {
    /// Moves the handle that has the focus by the arrow keys.
    pub(super) fn move_focused(&self, ctx: &Context, edited: &mut Edited) {
        let steps = arrow_steps(ctx);
        if steps == DVec3::ZERO {
            return;
        }
        let Edited { document, session, .. } = edited;
        let mut all = self.placed(document, session).into_iter();
        let Some(found) = all.find(|one| self.has_focus(ctx, one.handle)) else { return };
        if let Handle::Pixel = found.handle {
            if let Ok(resolved) = document.camera.resolve() {
                let selection = session.selection.inside(resolved.image());
                session.selection = selection.stepped(&resolved, -steps.y as i64, steps.x as i64);
            }
            return;
        }
        let drag = found.taken(document, session.selection, DVec2::ZERO);
        let Some(point) = self.target(found.handle, &drag, steps) else { return };
        let settings = session.settings;
        if let Ok(dragged) = self.handle_drag(ctx, found.handle, &drag, &settings).put(point) {
            dragged.values.put(document, &mut session.selection);
        }
    }

    /// Returns the point to which steps to the right, upwards and away move a handle.
    fn target(&self, handle: Handle, drag: &Drag, steps: DVec3) -> Option<DVec3> {
        let forward = steps.x + steps.y + steps.z;
        let basis = drag.before.camera.basis();
        let way = match handle {
            Handle::Roll => return turned_by(drag, -KEY_ROLL * forward),
            Handle::Dolly | Handle::Distance => -forward * basis.ok()?.w,
            Handle::Radius(_) => forward * drag.toward,
            Handle::Corner(_) => {
                let Basis { u, v, .. } = basis.ok()?;
                steps.x * u + steps.y * v
            }
            _ => {
                let [right, up, away] = axes_of(self.observer);
                steps.x * right + steps.y * up + steps.z * away
            }
        };
        Some(drag.at + step_of(self.observer, drag.at, self.scale).ok()? * way)
    }
}

/// Returns the steps of the arrow keys: to the right, upwards, and (with Shift) away from the observer.
fn arrow_steps(ctx: &Context) -> DVec3 {
    ctx.input(|i| {
        let count = |key| i.num_presses(key) as f64;
        let right = count(Key::ArrowRight) - count(Key::ArrowLeft);
        let up = count(Key::ArrowUp) - count(Key::ArrowDown);
        if i.modifiers.shift { DVec3::new(right, 0.0, up) } else { DVec3::new(right, up, 0.0) }
    })
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

impl Dragging {
    /// Applies the wheel in the camera view; Escape takes recent steps back.
    pub(super) fn roll_wheel(&mut self, ctx: &Context, response: &Response, edited: &mut Edited) {
        let time = ctx.input(|i| i.time);
        let camera = &mut edited.document.camera;
        self.forget(camera, time);
        // Consumed here, so that it does not also end presenter mode.
        let is_taken_back = |_: &mut RecentSteps| {
            ctx.input_mut(|i| i.consume_key(egui::Modifiers::NONE, Key::Escape))
        };
        if let Some(recent) = self.recent.take_if(is_taken_back) {
            *camera = recent.before;
            if recent.by_keys {
                // Escape takes the focus away everywhere.
                response.request_focus();
            }
            return;
        }
        if !response.contains_pointer() {
            self.scrolled = 0.0;
            return;
        }
        let (scroll, pinch) = ctx.input(|i| (i.smooth_scroll_delta().y, i.zoom_delta()));
        if pinch != 1.0 {
            let by = DVec2::new(f64::from(pinch).ln(), 0.0);
            self.step(Way::Zoom, by, camera, time, false);
            return;
        }
        self.scrolled += scroll;
        let notches = (self.scrolled / LOUPE_SCROLL).trunc();
        self.scrolled -= notches * LOUPE_SCROLL;
        look_closer(&mut edited.session.settings, notches as i32);
    }

    /// Moves the camera by a step for each key press.
    pub(crate) fn steer(&mut self, steer: Steer, camera: &mut Camera, time: f64) {
        let by = |x: i32, y: i32, length: f64| length * DVec2::new(x.into(), y.into());
        let (way, by) = match steer {
            Steer::Look(right, up) => (Way::Look, by(right, up, KEY_TURN)),
            Steer::Orbit(right, up) => (Way::Orbit, by(right, up, KEY_TURN)),
            Steer::Zoom(on) => (Way::Zoom, by(on, 0, KEY_NEARER)),
            Steer::Dolly(on) => (Way::Dolly, by(on, 0, KEY_NEARER)),
        };
        self.forget(camera, time);
        self.step(way, by, camera, time, true);
    }

    /// Forgets the recent steps if they are over, or if the camera is another one since.
    fn forget(&mut self, now: &Camera, time: f64) {
        self.recent.take_if(|recent| recent.made != *now || !recent.is_shown(time));
    }

    /// Adds to the recent steps if they are of the same kind; otherwise begins new ones.
    fn step(&mut self, way: Way, by: DVec2, camera: &mut Camera, time: f64, by_keys: bool) {
        let now = *camera;
        let recent = self.recent.take().filter(|recent| recent.way == way);
        let (before, total) = recent.map_or((now, by), |recent| (recent.before, recent.total + by));
        let made = match way {
            Way::Look => before.looked_round(-total.x, total.y),
            Way::Orbit => before.orbited(total.x, -total.y),
            Way::Dolly => before.dollied(total.x),
            Way::Zoom => zoomed(&before, (-total.x).exp()),
        };
        self.refused = made.err();
        let made = made.unwrap_or(now);
        *camera = made;
        self.recent = Some(RecentSteps { way, before, made, total, time, by_keys });
    }
}

impl RecentSteps {
    /// Returns true while their effect is shown, and Escape takes it back.
    pub(super) fn is_shown(&self, now: f64) -> bool {
        now - self.time < PAUSE
    }
}

/// Opens the loupe, and lets it show fewer pixels, all the larger; or more, and closes it.
fn look_closer(settings: &mut Settings, notches: i32) {
    let (least, most) = LOUPE_PIXELS;
    for _ in 0..notches.unsigned_abs() {
        let is_open = settings.items.shows(Item::Loupe);
        let pixels = settings.loupe_pixels;
        let (opens, pixels) = match (notches > 0, is_open) {
            (true, true) => (true, pixels.saturating_sub(2).max(least)),
            (true, false) => (true, most),
            (false, true) => (pixels < most, (pixels + 2).min(most)),
            (false, false) => return,
        };
        settings.items.set(Item::Loupe, opens);
        settings.loupe_pixels = pixels;
    }
}

/// Returns the camera with a larger or smaller viewport, whose width is rounded to three digits.
fn zoomed(camera: &Camera, factor: f64) -> Result<Camera, SteerError> {
    let width = factor * camera.viewport.width;
    let readable = rounded_to(width, 0.01 * width)? / camera.viewport.width;
    camera.zoomed(readable)
}
