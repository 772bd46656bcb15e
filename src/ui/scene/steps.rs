//! Stepwise input by keys and the wheel: moves the focused handle, moves the camera in the camera view, and
//! opens, magnifies or closes the loupe. Also shows the text next to the pointer during a drag or after a
//! step. The moved cameras are computed by [`pinhole_core::steering`].

use std::time::Duration;

use egui::accesskit::Role;
use egui::{
    Align, Align2, Context, CursorIcon, Id, Key, PopupAnchor, Pos2, Rect, RectAlign, Response,
    RichText, Sense, Ui, Vec2, vec2,
};
use pinhole_core::steering::{SteerError, rounded_to};
use pinhole_core::{Basis, Camera, DVec2, DVec3, ResolvedCamera};
use pinhole_exchange::document::Document;
use pinhole_figure::{HoverSource, Hovered, Item};

use crate::features::handles::drag::{Dragged, step_of};
use crate::features::handles::placed::{PlacedHandle, label, value};
use crate::features::handles::state::{Corner, Drag, Grabbed, Handle, HandleValues};
use crate::model::interaction::{HANDLE_REACH, KEY_NEARER, KEY_TURN, LOUPE_SCROLL, PAUSE};
use crate::model::session::{LOUPE_PIXELS, Session};
use crate::ui::action::{CameraMove, Steer};
use crate::ui::scene::views::{CAMERA, WORLD};
use crate::ui::scene::{Dragging, ViewInput, ViewRects, WorldArea};
use crate::ui::widgets::{ResponseExt as _, arrows, fault_text, keep_arrows};
use crate::view::derive::Derived;

/// The recent steps of the camera by wheel or keys.
#[derive(Debug)]
pub(super) struct RecentSteps {
    pub(super) way: CameraMove,
    before: Camera,
    /// The resulting camera.
    made: Camera,
    /// Sum of the steps: x to the right and y up or, for zoom, x forwards.
    total: DVec2,
    /// Time of the last step, in egui's seconds.
    pub(super) time: f64,
    /// True if the steps were made by keys, not by the wheel.
    pub(super) by_keys: bool,
}

impl WorldArea<'_> {
    /// Moves the focused handle with the arrow keys.
    pub(super) fn move_focused(&self, input: &mut ViewInput) {
        let ViewInput { ctx, document, session, .. } = input;
        let steps = arrow_steps(ctx);
        if steps == DVec3::ZERO {
            return;
        }
        let mut all = self.placed(document, session).into_iter();
        let Some(found) = all.find(|one| self.has_focus(ctx, one.handle)) else { return };
        if let Handle::Pixel = found.handle {
            if let Ok(resolved) = document.camera.resolve() {
                let selected = &mut session.shown.selection;
                *selected = selected.stepped(&resolved, -steps.y as i64, steps.x as i64);
            }
            return;
        }
        let drag = found.taken(document, session.shown.selection, DVec2::ZERO);
        let Some(point) = self.target(found.handle, &drag, steps) else { return };
        let settings = session.settings();
        let handle_drag = self.handle_drag(ctx, found.handle, &drag, &settings);
        // A step may be larger than the viewport.
        let is_valid = |dragged: &Dragged| {
            let viewports =
                [&drag.before.camera, &dragged.values.camera].map(|one| one.viewport.check());
            viewports[1].is_ok() || viewports[0].is_err()
        };
        if let Some(dragged) = handle_drag.put(point).ok().filter(is_valid) {
            dragged.values.put(document, &mut session.shown.selection);
        }
    }

    /// Returns the point to which a handle is moved by `steps`: x to the right, y upwards, and z away from
    /// the observer.
    fn target(&self, handle: Handle, drag: &Drag, steps: DVec3) -> Option<DVec3> {
        let forward = steps.x + steps.y + steps.z;
        let basis = drag.before.camera.basis();
        let way = match handle {
            Handle::Distance => -forward * basis.ok()?.w,
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

/// Returns the presses of the arrow keys as steps to the right, upwards, and (with Shift) away from the
/// observer.
fn arrow_steps(ctx: &Context) -> DVec3 {
    let steps = arrows(ctx);
    let (right, up) = (f64::from(steps.x), f64::from(-steps.y));
    let is_away = ctx.input(|i| i.modifiers.shift);
    if is_away { DVec3::new(right, 0.0, up) } else { DVec3::new(right, up, 0.0) }
}

/// Returns the signed world axes that are closest to the directions right, up and away from the observer.
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
    /// Applies the wheel in the camera view. Escape undoes recent steps.
    pub(super) fn roll_wheel(&mut self, response: &Response, input: &mut ViewInput) {
        let ViewInput { ctx, document, session, .. } = input;
        let time = ctx.input(|i| i.time);
        let camera = &mut document.camera;
        self.forget(camera, time);
        // Escape is consumed here, so that it does not end presenter mode as well.
        let is_taken_back = |_: &mut RecentSteps| {
            ctx.input_mut(|i| i.consume_key(egui::Modifiers::NONE, Key::Escape))
        };
        if let Some(recent) = self.recent.take_if(is_taken_back) {
            *camera = recent.before;
            if recent.by_keys {
                // egui removes the focus on Escape, so the view requests it again.
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
            self.step(CameraMove::Zoom, by, camera, time, false);
            return;
        }
        self.scrolled += scroll;
        let notches = (self.scrolled / LOUPE_SCROLL).trunc();
        self.scrolled -= notches * LOUPE_SCROLL;
        look_closer(session, notches as i32);
    }

    /// Moves the camera by a step for each key press.
    pub(crate) fn steer(&mut self, steer: Steer, camera: &mut Camera, time: f64) {
        let Steer(way, right, up) = steer;
        let length = if way == CameraMove::Zoom { KEY_NEARER } else { KEY_TURN };
        self.forget(camera, time);
        self.step(way, length * DVec2::new(right.into(), up.into()), camera, time, true);
    }

    /// Forgets the recent steps after a pause, or if the camera has changed since they were made.
    fn forget(&mut self, now: &Camera, time: f64) {
        self.recent.take_if(|recent| recent.made != *now || !recent.is_shown(time));
    }

    /// Moves the camera by one step. The step is added to the recent steps if it is of the same kind;
    /// otherwise a new sum starts with it.
    fn step(&mut self, way: CameraMove, by: DVec2, camera: &mut Camera, time: f64, by_keys: bool) {
        let now = *camera;
        let recent = self.recent.take().filter(|recent| recent.way == way);
        let (before, total) = recent.map_or((now, by), |recent| (recent.before, recent.total + by));
        let made = match way {
            CameraMove::Look => before.looked_round(-total.x, total.y),
            CameraMove::Orbit => before.orbited(total.x, -total.y),
            CameraMove::Zoom => zoomed(&before, (-total.x).exp()),
        };
        self.refused = made.err();
        let made = made.unwrap_or(now);
        *camera = made;
        self.recent = Some(RecentSteps { way, before, made, total, time, by_keys });
    }
}

impl RecentSteps {
    /// Returns true while the text about the steps is shown. During this time, Escape undoes the steps.
    pub(super) fn is_shown(&self, now: f64) -> bool {
        now - self.time < PAUSE
    }
}

/// Applies notches of the wheel to the loupe, which magnifies the pixels around the selected point. Forward
/// notches open it and then magnify more. Backward notches magnify less, and finally close it.
fn look_closer(session: &mut Session, notches: i32) {
    let (least, most) = LOUPE_PIXELS;
    for _ in 0..notches.unsigned_abs() {
        let is_open = session.shown.setup.items.shows(Item::Loupe);
        let pixels = session.preferences.loupe_pixels;
        let (opens, pixels) = match (notches > 0, is_open) {
            (true, true) => (true, pixels.saturating_sub(2).max(least)),
            (true, false) => (true, most),
            (false, true) => (pixels < most, (pixels + 2).min(most)),
            (false, false) => return,
        };
        session.shown.setup.items.set(Item::Loupe, opens);
        session.preferences.loupe_pixels = pixels;
    }
}

/// Returns the camera with its viewport scaled by a factor. The new width is rounded to the shortest decimal
/// that is within 0.1 % of it.
fn zoomed(camera: &Camera, factor: f64) -> Result<Camera, SteerError> {
    let width = factor * camera.viewport.width;
    let readable = rounded_to(width, 0.01 * width)? / camera.viewport.width;
    camera.zoomed(readable)
}

/// Size of the text's first line, in points.
const FIRST: f32 = 19.0;
/// Size of the other lines, in points.
const REST: f32 = 15.0;

/// Distance from the pointer to the text, in points, across and down.
const GAP: f32 = 20.0;

impl Dragging {
    /// Shows the texts about handles and steps, and stores the views' rectangles for the input of the next
    /// pass.
    pub(crate) fn show_text(
        &mut self,
        ui: &Ui,
        rects: &ViewRects,
        (document, session): (&Document, &Session),
        shown: &Derived,
    ) {
        let view = |rect: Option<Rect>, name: &str| Some((rect?, ui.scope_id().with(name)));
        (self.world, self.camera) = (view(rects.world, WORLD), view(rects.camera, CAMERA));
        if let Some(view) = self.world_view(ui.ctx(), shown) {
            self.show_handle_text(ui, &view, document, session);
        }
        if let Some(view) = self.camera {
            self.show_step(ui, view, document, session);
        }
    }

    fn show_handle_text(&self, ui: &Ui, view: &WorldArea, document: &Document, session: &Session) {
        let all = view.placed(document, session);
        let spot = |one: &PlacedHandle| {
            view.rect.min + vec2(one.spot.x as f32, one.spot.y as f32) / view.scale
        };
        for one in &all {
            // The handle can have the focus, and has a name and a value for screen readers.
            let rect = Rect::from_center_size(spot(one), Vec2::splat(2.0 * HANDLE_REACH as f32));
            let sense = Sense::focusable_noninteractive();
            let response = ui.interact(rect, view.id_of(one.handle), sense);
            keep_arrows(&response, true, true);
            let value = value_of(one.handle, usize::MAX, document, session);
            let name = format!("{} handle", label(one.handle, document));
            response.with_role(Role::Slider).described(value).named(name);
        }
        let Some(handle) = session.live.handles.over else { return };
        let is_held = session.live.handles.drag.is_some();
        let by_pointer = is_held || self.by_pointer;
        if by_pointer {
            ui.ctx().set_cursor_icon(if is_held { CursorIcon::Grabbing } else { CursorIcon::Grab });
        }
        let own = all.iter().find(|one| one.handle == handle).map(spot);
        // A held handle may temporarily have no position, when the viewport has no area.
        let pointer = ui.input(|i| i.pointer.latest_pos()).filter(|_| by_pointer);
        let Some(at) = pointer.or(own) else { return };
        let text = value_of(handle, 6, document, session);
        let mut lines = vec![match handle.object() {
            Some(object) => format!("{}: {text}", document.title_of(object)),
            None => text,
        }];
        if let (Some(Hovered { concept, by: HoverSource::View }), false) =
            (session.live.hovered, is_held)
        {
            lines.push(concept.description(|object| document.title_of(object as usize)));
        }
        if self.up_went_along {
            lines.push("up turns with the camera".to_owned());
        }
        let refused = self.refused.filter(|_| is_held).map(|reason| reason.to_string());
        show_lines(ui, view.id, at, at - view.rect.center(), &lines, refused);
    }

    /// Returns true if there is text to show about a drag or a recent step in the camera view.
    pub(crate) fn has_step_text(&self, session: &Session, time: f64) -> bool {
        session.live.handles.drag.is_some_and(|drag| drag.handle().is_none())
            || self.recent.as_ref().is_some_and(|recent| recent.is_shown(time))
    }

    fn show_step(&self, ui: &Ui, (rect, id): (Rect, Id), document: &Document, session: &Session) {
        let time = ui.input(|i| i.time);
        let recent = self.recent.as_ref().filter(|recent| recent.is_shown(time));
        if let Some(recent) = recent {
            let left = Duration::from_secs_f64(PAUSE - (time - recent.time));
            ui.ctx().request_repaint_after(left);
        }
        let (way, by_keys) = match (session.live.handles.drag.map(|drag| drag.grabbed), recent) {
            (Some(Grabbed::Look), _) => (CameraMove::Look, false),
            (Some(Grabbed::Orbit), _) => (CameraMove::Orbit, false),
            (_, Some(recent)) => (recent.way, recent.by_keys),
            _ => return,
        };
        let by_at = document.camera.orientation.has_at();
        let corner = Handle::Corner(Corner { is_right: true, is_top: true });
        let (title, changed) = match way {
            CameraMove::Look => ("look around", Handle::At),
            CameraMove::Orbit if by_at => ("orbit around at", Handle::Eye),
            CameraMove::Orbit => ("orbit", Handle::Eye),
            CameraMove::Zoom => ("zoom: the field of view", corner),
        };
        let lines = [title.to_owned(), value_of(changed, 5, document, session)];
        let pointer = ui.input(|i| i.pointer.latest_pos()).filter(|_| !by_keys);
        // After a key press, the text is at the picture's lower left, wherever the pointer is.
        let at = pointer.unwrap_or(rect.lerp_inside([0.0, 0.72]));
        let refused = self.refused.map(|reason| reason.to_string());
        show_lines(ui, id, at, vec2(1.0, 1.0), &lines, refused);
    }
}

/// Returns a handle's value, with at most `digits` digits.
fn value_of(handle: Handle, digits: usize, document: &Document, session: &Session) -> String {
    let values = HandleValues::read(document, session.shown.selection, handle.object());
    let setup = &session.shown.setup;
    value(handle, &values, setup.digits.min(digits), setup.count_from_one)
}

/// Shows lines of text next to a position, on the side to which `away` points; below them, the reason why the
/// input had no effect, if there is one.
fn show_lines(ui: &Ui, id: Id, at: Pos2, away: Vec2, lines: &[String], refused: Option<String>) {
    let align = |is_far: bool| if is_far { Align::Max } else { Align::Min };
    let side = RectAlign::outside(Align2([align(away.x >= 0.0), align(away.y >= 0.0)]));
    let anchor = PopupAnchor::ParentRect(Rect::from_center_size(at, Vec2::splat(2.0 * GAP)));
    let id = id.with("said");
    let mut tooltip =
        egui::Tooltip::always_open(ui.ctx().clone(), ui.layer_id(), id, anchor).gap(0.0);
    tooltip.popup = tooltip.popup.align(side);
    tooltip.show(|ui| {
        for (k, text) in lines.iter().enumerate() {
            let text = match k {
                0 => RichText::new(text).size(FIRST).strong(),
                _ => RichText::new(text).size(REST),
            };
            ui.add(egui::Label::new(text).wrap_mode(egui::TextWrapMode::Extend));
        }
        if let Some(reason) = refused {
            ui.label(fault_text(ui, reason).size(REST));
        }
    });
}
