//! Navigation in the camera view: looking round, orbiting, zooming and dollying as in other 3D
//! programs. [`pinhole_core::steering`] calculates the cameras.

use egui::{Context, Id, Key, PointerButton, Pos2, Rect, Response, Ui};
use pinhole_core::steering::{SteerError, rounded_to};
use pinhole_core::{Camera, DVec2, DVec3, Orientation, ResolvedCamera};
use pinhole_lecture::numbers::written;

use super::handles::{Edited, say, taken_keys};
use crate::model::overlay_items::Item;
use crate::model::session::{LOUPE_PIXELS, Session, Settings};
use crate::ui::action::Steer;
use crate::view::handles::vector;
use crate::view::overlay;

/// Time after the last input of wheel or keys during which their effect is shown, and Escape takes
/// it back; in seconds.
const PAUSE: f64 = 1.2;

/// Scrolling that takes the loupe a step closer, in points.
const NOTCH: f32 = 40.0;

/// Step of a key: its angle, in radians, and its share of the distance or of the zoom.
const TURN: f64 = 5.0 * std::f64::consts::PI / 180.0;
const NEARER: f64 = 0.1;

/// The state of the camera view's navigation between passes.
#[derive(Debug, Default)]
pub(crate) struct Navigation {
    /// The camera view's rectangle and its id in egui.
    view: Option<(Rect, Id)>,
    turn: Option<Turn>,
    steered: Option<Steered>,
    /// True if the button is still down although its drag was cancelled.
    given_back: bool,
    refused: Option<SteerError>,
    /// Scrolling since the loupe's last step, in points.
    scrolled: f32,
}

/// The effect of a drag or of the wheel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    Look,
    Orbit,
    Zoom,
    Dolly,
}

#[derive(Debug)]
struct Turn {
    way: Way,
    before: Camera,
    resolved: ResolvedCamera,
    from: Pos2,
}

/// The recent movement by wheel or keys.
#[derive(Debug)]
struct Steered {
    way: Way,
    before: Camera,
    /// The resulting camera.
    made: Camera,
    /// Sum of the movements: to the right and up; if there is only one direction, x is forwards.
    total: DVec2,
    time: f64,
    by_keys: bool,
}

impl Navigation {
    /// Applies the input of mouse and wheel to the camera.
    pub(crate) fn take(&mut self, ctx: &Context, edited: &mut Edited) {
        let any_down = ctx.input(|i| i.pointer.any_down());
        edited.session.hand.is_busy |= self.turn.is_some() || self.given_back;
        self.given_back &= any_down;
        let response = self.view.and_then(|(_, id)| ctx.read_response(id));
        let (Some((rect, _)), Some(response)) = (self.view, response) else {
            (self.turn, self.steered) = (None, None);
            return;
        };
        if self.turn.is_none() {
            self.press(ctx, &response, edited);
        }
        if self.turn.is_some() {
            self.hold(ctx, rect, edited);
        } else {
            self.roll_wheel(ctx, &response, edited);
        }
    }

    /// Releases everything, because another scene or a dialog is shown.
    pub(crate) fn let_go(&mut self) {
        (self.turn, self.steered, self.refused) = (None, None, None);
    }

    fn press(&mut self, ctx: &Context, response: &Response, edited: &mut Edited) {
        let way = ctx.input(|i| {
            let pressed = |button| i.pointer.button_pressed(button);
            if pressed(PointerButton::Middle) {
                Some(Way::Orbit)
            } else if pressed(PointerButton::Secondary) {
                Some(if i.modifiers.shift { Way::Orbit } else { Way::Look })
            } else {
                let looks = pressed(PointerButton::Primary) && i.modifiers.alt;
                looks.then_some(if i.modifiers.shift { Way::Orbit } else { Way::Look })
            }
        });
        let origin = ctx.input(|i| i.pointer.press_origin());
        let before = edited.document.camera;
        let (Some(way), Some(from), Ok(resolved), true) =
            (way, origin, before.resolve(), response.is_pointer_button_down_on())
        else {
            return;
        };
        self.turn = Some(Turn { way, before, resolved, from });
        self.steered = None;
        edited.session.hand.is_busy = true;
    }

    fn hold(&mut self, ctx: &Context, rect: Rect, edited: &mut Edited) {
        let Some(turn) = &self.turn else { return };
        if taken_keys(ctx).contains(&Key::Escape) {
            edited.document.camera = turn.before;
            self.given_back = ctx.input(|i| i.pointer.any_down());
            self.let_go();
            return;
        }
        if let Some(at) = ctx.input(|i| i.pointer.latest_pos()) {
            let [from, to] = [turn.from, at].map(|at| uv_at(&turn.resolved, rect, at));
            let viewport = turn.before.viewport;
            let turned = match turn.way {
                Way::Orbit => {
                    let (yaw, pitch) = viewport.orbit_of_drag(from, to);
                    turn.before.orbited(yaw, pitch)
                }
                _ => {
                    let (yaw, pitch) = viewport.look_of_drag(from, to);
                    turn.before.looked_round(yaw, pitch)
                }
            };
            self.refused = turned.err();
            edited.document.camera = turned.unwrap_or(edited.document.camera);
        }
        if ctx.input(|i| !i.pointer.any_down()) {
            self.let_go();
        }
    }

    fn roll_wheel(&mut self, ctx: &Context, response: &Response, edited: &mut Edited) {
        let time = ctx.input(|i| i.time);
        self.forget(&edited.document.camera, time);
        // Consumed here, so that it does not also end presenter mode.
        let taken =
            |_: &mut Steered| ctx.input_mut(|i| i.consume_key(egui::Modifiers::NONE, Key::Escape));
        if let Some(last) = self.steered.take_if(taken) {
            edited.document.camera = last.before;
            if last.by_keys {
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
            self.go(Way::Zoom, by, &mut edited.document.camera, time, false);
            return;
        }
        self.scrolled += scroll;
        let notches = (self.scrolled / NOTCH).trunc();
        self.scrolled -= notches * NOTCH;
        look_closer(&mut edited.session.settings, notches as i32);
    }

    /// Moves the camera by a step for each key press.
    pub(crate) fn steer(&mut self, steer: Steer, camera: &mut Camera, time: f64) {
        let step = |x: i32, y: i32, length: f64| length * DVec2::new(x.into(), y.into());
        let (way, by) = match steer {
            Steer::Look(right, up) => (Way::Look, step(right, up, TURN)),
            Steer::Orbit(right, up) => (Way::Orbit, step(right, up, TURN)),
            Steer::Zoom(on) => (Way::Zoom, step(on, 0, NEARER)),
            Steer::Dolly(on) => (Way::Dolly, step(on, 0, NEARER)),
        };
        self.forget(camera, time);
        self.go(way, by, camera, time, true);
    }

    /// Forgets the last movement if it is over, or if the camera is another one since.
    fn forget(&mut self, now: &Camera, time: f64) {
        self.steered =
            self.steered.take().filter(|last| last.made == *now && time - last.time < PAUSE);
    }

    /// Adds to the last movement if it was of the same kind; otherwise begins a new one.
    fn go(&mut self, way: Way, by: DVec2, camera: &mut Camera, time: f64, by_keys: bool) {
        let now = *camera;
        let last = self.steered.take().filter(|last| last.way == way);
        let (before, total) = last.map_or((now, by), |last| (last.before, last.total + by));
        let made = match way {
            Way::Look => before.looked_round(-total.x, total.y),
            Way::Orbit => before.orbited(total.x, -total.y),
            Way::Dolly => before.dollied(total.x),
            Way::Zoom => zoomed(&before, (-total.x).exp()),
        };
        self.refused = made.err();
        let made = made.unwrap_or(now);
        *camera = made;
        self.steered = Some(Steered { way, before, made, total, time, by_keys });
    }

    /// Returns true if [`Navigation::tell`] has something to show.
    pub(crate) fn has_word(&self, time: f64) -> bool {
        self.turn.is_some() || self.steered.as_ref().is_some_and(|last| time - last.time < PAUSE)
    }

    /// Shows the text about the current movement beside the pointer. The camera view is at `view`
    /// now.
    pub(crate) fn tell(
        &mut self,
        ui: &Ui,
        view: Option<(Rect, Id)>,
        now: &Camera,
        session: &Session,
    ) {
        self.view = view;
        let Some((rect, id)) = view else { return };
        let time = ui.input(|i| i.time);
        let steered = self.steered.as_ref().filter(|last| time - last.time < PAUSE);
        if let Some(last) = steered {
            let left = std::time::Duration::from_secs_f64(PAUSE - (time - last.time));
            ui.ctx().request_repaint_after(left);
        }
        let by_keys = self.turn.is_none() && steered.is_some_and(|last| last.by_keys);
        let turn = self.turn.as_ref().map(|turn| (turn.way, &turn.before));
        let Some((way, before)) = turn.or(steered.map(|last| (last.way, &last.before))) else {
            return;
        };
        let lines = lines(way, before, now, session.settings.digits.min(5));
        let refused = self.refused.map(|reason| reason.to_string());
        let pointer = ui.input(|i| i.pointer.latest_pos()).filter(|_| !by_keys);
        // The pointer has no part in key presses: show the text in the picture's lower left.
        let view = pointer.unwrap_or(rect.lerp_inside([0.0, 0.72]));
        say(ui, id, view, egui::vec2(1.0, 1.0), &lines, refused.as_deref());
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

fn uv_at(resolved: &ResolvedCamera, rect: Rect, at: Pos2) -> DVec2 {
    let size = [rect.width().round().max(1.0) as usize, rect.height().round().max(1.0) as usize];
    overlay::camera_uv_at(resolved, size, (at - rect.min).into())
}

/// Returns the name of the movement, and its effect on eye, at and up.
fn lines(way: Way, before: &Camera, now: &Camera, digits: usize) -> Vec<String> {
    let by_at = matches!(now.orientation, Orientation::At { .. });
    let title = match way {
        Way::Look => "look around",
        Way::Orbit if by_at => "orbit around at",
        Way::Orbit => "orbit",
        Way::Zoom => "zoom: the field of view",
        Way::Dolly => "dolly: the eye along 𝐰",
    };
    let mut lines = vec![title.to_owned()];
    if way == Way::Zoom {
        let number = |x: f64| written(x, digits);
        let viewport = now.viewport;
        let fov = viewport.vertical_fov().to_degrees();
        lines.push(format!("width = {}", number(viewport.width)));
        lines.push(format!("height = {}", number(viewport.height)));
        lines.push(format!("field of view ↕ {}°", written(fov, digits.min(4))));
        lines.push("eye, at and up stay".replace("at", if by_at { "at" } else { "view" }));
        return lines;
    }
    let mut tell = |name: &str, old: DVec3, new: DVec3| {
        let stays = if old == new { " stays" } else { "" };
        lines.push(format!("{name} = {}{stays}", vector(new, digits)));
    };
    tell("eye", before.eye, now.eye);
    match (before.orientation, now.orientation) {
        (Orientation::At { at, .. }, Orientation::At { at: new, .. }) => tell("at", at, new),
        (Orientation::Basis(old), Orientation::Basis(new)) => {
            tell("𝐮", old.u, new.u);
            tell("𝐯", old.v, new.v);
            tell("𝐰", old.w, new.w);
            return lines;
        }
        _ => tell("view", before.view(), now.view()),
    }
    tell("up", before.up(), now.up());
    lines
}
