//! The camera view taken in the hand: looking round, orbiting, zooming and dollying as in other 3D
//! programs. What each does to the camera is [`pinhole_core::steering`]'s.

use egui::{Context, Id, Key, PointerButton, Pos2, Rect, Response, Ui};
use pinhole_core::steering::{SteerError, rounded_to};
use pinhole_core::{Camera, DVec2, DVec3, Orientation, ResolvedCamera};

use super::handles::{Edited, say, taken_keys};
use crate::action::Steer;
use crate::handles::vector;
use crate::number::written;
use crate::overlay;
use crate::session::Session;

/// So long after wheel and keys rest it is said what they did, and Escape takes it back; in seconds.
const PAUSE: f64 = 1.2;

/// How much a point of scrolling zooms.
const WHEEL: f64 = 0.004;

/// A step by a key: so far it turns, in radians, and so many lengths of the way it goes, or zooms.
const TURN: f64 = 5.0 * std::f64::consts::PI / 180.0;
const NEARER: f64 = 0.1;

/// What is remembered of the camera view's navigation from one pass to the next.
#[derive(Debug, Default)]
pub(crate) struct Navigation {
    /// Where the camera view was, and its name in egui.
    place: Option<(Rect, Id)>,
    turn: Option<Turn>,
    steered: Option<Steered>,
    /// The button is still down, but what it did was given back.
    given_back: bool,
    refused: Option<SteerError>,
}

/// What a drag or the wheel does.
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

/// What the wheel, or keys, have done until just now.
#[derive(Debug)]
struct Steered {
    way: Way,
    before: Camera,
    /// What it made of that camera.
    made: Camera,
    /// To the right and up; on, where there is one way alone.
    total: DVec2,
    time: f64,
    by_keys: bool,
}

impl Steered {
    /// More of it, or its beginning.
    fn on(
        before: Option<Steered>,
        way: Way,
        by: DVec2,
        now: &Camera,
    ) -> (Camera, DVec2, Result<Camera, SteerError>) {
        let last = before.filter(|last| last.way == way);
        let (before, total) = last.map_or((*now, by), |last| (last.before, last.total + by));
        let made = match way {
            Way::Look => before.looked_round(-total.x, total.y),
            Way::Orbit => before.orbited(total.x, -total.y),
            Way::Dolly => before.dollied(total.x),
            Way::Zoom => zoomed(&before, (-total.x).exp()),
        };
        (before, total, made)
    }
}

impl Navigation {
    /// What mouse and wheel do to the camera in its view.
    pub(crate) fn take(&mut self, ctx: &Context, edited: &mut Edited) {
        let any_down = ctx.input(|i| i.pointer.any_down());
        edited.session.hand.is_busy |= self.turn.is_some() || self.given_back;
        self.given_back &= any_down;
        let response = self.place.and_then(|(_, id)| ctx.read_response(id));
        let (Some((rect, _)), Some(response)) = (self.place, response) else {
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

    /// Another scene is shown, or a dialog: nothing is held any more.
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
        let now = edited.document.camera;
        let time = ctx.input(|i| i.time);
        self.steered =
            self.steered.take().filter(|last| last.made == now && time - last.time < PAUSE);
        // Taken here, it does not end presenting, too.
        let taken =
            |_: &mut Steered| ctx.input_mut(|i| i.consume_key(egui::Modifiers::NONE, Key::Escape));
        if let Some(last) = self.steered.take_if(taken) {
            edited.document.camera = last.before;
            if last.by_keys {
                // Which Escape takes away everywhere.
                response.request_focus();
            }
            return;
        }
        let (scroll, pinch) = ctx.input(|i| (i.smooth_scroll_delta().y, i.zoom_delta()));
        let (way, by) = match (scroll, pinch) {
            (_, pinch) if pinch != 1.0 => (Way::Dolly, f64::from(pinch).ln()),
            (scroll, _) => (Way::Zoom, WHEEL * f64::from(scroll)),
        };
        if by != 0.0 && response.contains_pointer() {
            self.go(way, DVec2::new(by, 0.0), &mut edited.document.camera, time, false);
        }
    }

    /// What keys do to the camera: each press a step.
    pub(crate) fn steer(&mut self, steer: Steer, camera: &mut Camera, time: f64) {
        let step = |x: i32, y: i32, length: f64| length * DVec2::new(x.into(), y.into());
        let (way, by) = match steer {
            Steer::Look(right, up) => (Way::Look, step(right, up, TURN)),
            Steer::Orbit(right, up) => (Way::Orbit, step(right, up, TURN)),
            Steer::Zoom(on) => (Way::Zoom, step(on, 0, NEARER)),
            Steer::Dolly(on) => (Way::Dolly, step(on, 0, NEARER)),
        };
        let now = *camera;
        self.steered =
            self.steered.take().filter(|last| last.made == now && time - last.time < PAUSE);
        self.go(way, by, camera, time, true);
    }

    fn go(&mut self, way: Way, by: DVec2, camera: &mut Camera, time: f64, by_keys: bool) {
        let now = *camera;
        let (before, total, made) = Steered::on(self.steered.take(), way, by, &now);
        self.refused = made.err();
        let made = made.unwrap_or(now);
        *camera = made;
        self.steered = Some(Steered { way, before, made, total, time, by_keys });
    }

    /// Whether [`Navigation::tell`] has something to say.
    pub(crate) fn has_word(&self, time: f64) -> bool {
        self.turn.is_some() || self.steered.as_ref().is_some_and(|last| time - last.time < PAUSE)
    }

    /// What is said beside the pointer of what is being done. The camera view is at `place` now.
    pub(crate) fn tell(
        &mut self,
        ui: &Ui,
        place: Option<(Rect, Id)>,
        now: &Camera,
        session: &Session,
    ) {
        self.place = place;
        let Some((rect, id)) = place else { return };
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
        // Keys are pressed wherever the pointer is: in the picture's lower left, beside what it shows.
        let place = pointer.unwrap_or(rect.lerp_inside([0.0, 0.72]));
        say(ui, id, place, egui::vec2(1.0, 1.0), &lines, refused.as_deref());
    }
}

/// The viewport larger or smaller, its width to three digits.
fn zoomed(camera: &Camera, factor: f64) -> Result<Camera, SteerError> {
    let width = factor * camera.viewport.width;
    let readable = rounded_to(width, 0.01 * width)? / camera.viewport.width;
    camera.zoomed(readable)
}

fn uv_at(resolved: &ResolvedCamera, rect: Rect, at: Pos2) -> DVec2 {
    let size = [rect.width().round().max(1.0) as usize, rect.height().round().max(1.0) as usize];
    overlay::camera_uv_at(resolved, size, (at - rect.min).into())
}

/// What the hand does, and what that does to eye, at and up.
fn lines(way: Way, before: &Camera, now: &Camera, digits: usize) -> Vec<String> {
    let by_at = matches!(now.orientation, Orientation::At { .. });
    let title = match way {
        Way::Look => "look round",
        Way::Orbit if by_at => "orbit round at",
        Way::Orbit => "orbit",
        Way::Zoom => "zoom: the field of view",
        Way::Dolly => "dolly along 𝐰",
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
