//! Mouse input on the handles of the world view, and in the camera view, where drags look around and orbit.
//! The input is applied before anything is drawn, so that the frame already shows its effect. The effects of
//! drags are computed in [`crate::features::handles::placed`] and [`pinhole_core::steering`].

use egui::{Context, Event, Id, Key, PointerButton, Pos2, Rect, Response, Ui, Vec2};
use pinhole_core::steering::SteerError;
use pinhole_core::{Camera, DVec2, DVec3, NO_OBJECT, ResolvedCamera};
use pinhole_exchange::document::Document;
use pinhole_figure::overlay::{self, pick};

use super::steps::RecentSteps;
use crate::features::handles::drag::HandleDrag;
use crate::features::handles::placed::{HandleInputs, PlacedHandle, hit, placed};
use crate::features::handles::state::{Drag, Grabbed, Handle, HandleValues};
use crate::model::interaction::{CLICK, FINGER_REACH, HANDLE_REACH, RAY_POINT_REACH};
use crate::model::session::{Session, Settings};
use crate::view::derive::Derived;

/// The input state of the world view and the camera view that persists between egui passes: the drag in
/// progress, and recent steps by keys and wheel.
#[derive(Debug, Default)]
pub(crate) struct Dragging {
    /// The world view's rectangle and its id in egui.
    pub(super) world: Option<(Rect, Id)>,
    /// The camera view's rectangle and its id in egui.
    pub(super) camera: Option<(Rect, Id)>,
    /// The position where the mouse button was pressed on a handle; `None` once the pointer has moved away
    /// from there, because the press is then a drag rather than a click.
    pressed_at: Option<Pos2>,
    /// True from the moment when Escape cancels a drag until the mouse button is released.
    given_back: bool,
    /// True if a handle is under the pointer.
    pub(super) by_pointer: bool,
    /// The reason why the last drag or step had no effect.
    pub(super) refused: Option<SteerError>,
    /// True if the current drag has also turned the up vector.
    pub(super) up_went_along: bool,
    /// The recent steps by keys or by the wheel.
    pub(super) recent: Option<RecentSteps>,
    /// Scrolling since the loupe's last step, in points.
    pub(super) scrolled: f32,
}

/// The context in which input in the views is handled: what the user sees, and the data that the input edits.
pub(crate) struct ViewInput<'a> {
    pub(crate) ctx: &'a Context,
    /// The values shown in the last frame, to which the user's input refers.
    pub(crate) shown: &'a Derived,
    pub(crate) document: &'a mut Document,
    pub(crate) session: &'a mut Session,
    pub(crate) chosen_object: &'a mut Option<usize>,
}

/// The world view on the screen.
pub(super) struct WorldArea<'a> {
    pub(super) rect: Rect,
    pub(super) id: Id,
    pub(super) observer: &'a ResolvedCamera,
    pub(super) scale: f32,
}

impl WorldArea<'_> {
    fn dots(&self, at: Pos2) -> Vec2 {
        (at - self.rect.min) * self.scale
    }

    /// Converts a point of the screen to (u, v) in the observer's viewport.
    fn uv(&self, at: Pos2) -> DVec2 {
        let image = self.observer.image();
        let size = [image.width() as usize, image.height() as usize];
        overlay::camera_uv_at(self.observer, size, self.dots(at).into())
    }

    /// Returns all handles with their positions.
    pub(super) fn placed(&self, document: &Document, session: &Session) -> Vec<PlacedHandle> {
        let resolved = document.camera.resolve().ok();
        let (resolved, selection) = (resolved.as_ref(), session.shown.selection);
        let WorldArea { observer, scale, .. } = *self;
        placed(&HandleInputs { document, session, resolved, selection, observer, scale })
    }

    /// Returns the parameters of a handle's drag. While Ctrl is held, values snap to round steps. While Alt
    /// is held, a moved eye keeps its view direction if the setting says that it keeps looking at *at*, and
    /// vice versa.
    pub(super) fn handle_drag<'a>(
        &'a self,
        ctx: &Context,
        handle: Handle,
        drag: &'a Drag,
        settings: &'a Settings,
    ) -> HandleDrag<'a> {
        let modifiers = ctx.input(|i| i.modifiers);
        let keeps = settings.preferences.eye_keeps;
        let eye_keeps = if modifiers.alt { keeps.other() } else { keeps };
        let (observer, scale, snaps) = (self.observer, self.scale, modifiers.command);
        HandleDrag { handle, drag, observer, scale, settings, eye_keeps, snaps }
    }

    /// Returns the handle at a position on the screen; `None` if the draggable point on the selected ray is
    /// nearer.
    fn hit(
        &self,
        all: &[PlacedHandle],
        at: Pos2,
        ray_point_t: Option<f64>,
        shown: &Derived,
        reach: f64,
    ) -> Option<PlacedHandle> {
        let [x, y]: [f32; 2] = self.dots(at).into();
        let (dots, reach) = (DVec2::new(x.into(), y.into()), reach * f64::from(self.scale));
        let found = hit(all, dots, reach)?;
        let ray_point = || {
            let point = shown.inspection.as_deref()?.ray.at(ray_point_t?);
            overlay::world_position_of(shown.world_frame.as_deref()?.camera(), point)
        };
        let is_nearest =
            ray_point().is_none_or(|point| point.distance(dots) > found.spot.distance(dots));
        is_nearest.then_some(found)
    }

    /// Returns a handle's id in egui, for the focus and for screen readers.
    pub(super) fn id_of(&self, handle: Handle) -> Id {
        self.id.with(("handle", handle))
    }

    pub(super) fn has_focus(&self, ctx: &Context, handle: Handle) -> bool {
        ctx.memory(|memory| memory.has_focus(self.id_of(handle)))
    }
}

impl Dragging {
    /// Applies mouse, wheel and key input in the views, unless a dialog or another overlay covers the
    /// window.
    pub(crate) fn take(&mut self, input: &mut ViewInput, is_covered: bool) {
        let ctx = input.ctx;
        let handles = &mut input.session.live.handles;
        handles.is_busy = !is_covered && (handles.drag.is_some() || self.given_back);
        if is_covered {
            self.recent = None;
            self.let_go(input.session);
            return;
        }
        self.given_back &= ctx.input(|i| i.pointer.any_down());
        let response = |view: Option<(Rect, Id)>| ctx.read_response(view?.1);
        let (world, camera) = (response(self.world), response(self.camera));
        let world = self.world_view(ctx, input.shown).zip(world);
        if world.is_none() {
            handles.over = None;
        }
        if handles.drag.is_none() {
            if let Some((view, response)) = &world {
                self.point(view, response, input);
            }
            if let (None, Some(response)) = (input.session.live.handles.drag, &camera) {
                self.press_camera(response, input);
            }
        }
        let Some(drag) = input.session.live.handles.drag else {
            if let Some((view, _)) = world {
                view.move_focused(input);
            }
            match camera {
                Some(response) => self.roll_wheel(&response, input),
                None => self.recent = None,
            }
            return;
        };
        match (drag.grabbed, world, camera) {
            (Grabbed::Handle(_), Some((view, _)), _) => self.hold(drag, Some(&view), input),
            (Grabbed::Look | Grabbed::Orbit, _, Some(_)) => self.hold(drag, None, input),
            _ => self.let_go(input.session),
        }
    }

    /// Returns the world view as it was drawn last.
    pub(super) fn world_view<'a>(&self, ctx: &Context, now: &'a Derived) -> Option<WorldArea<'a>> {
        let (rect, id) = self.world?;
        let observer = now.world_frame.as_deref()?.camera();
        Some(WorldArea { rect, id, observer, scale: ctx.pixels_per_point() })
    }

    /// Releases the handle or the camera.
    fn let_go(&mut self, session: &mut Session) {
        (self.pressed_at, self.refused, self.up_went_along) = (None, None, false);
        (session.live.handles.drag, session.live.handles.over) = (None, None);
    }

    /// Updates which handle is under the pointer or has the keyboard focus, and starts a drag if the mouse
    /// button was pressed on a handle.
    fn point(&mut self, view: &WorldArea, response: &Response, input: &mut ViewInput) {
        let ViewInput { ctx, shown, document, session, chosen_object } = input;
        let chosen = chosen_object.filter(|chosen| *chosen < document.object_count());
        session.live.handles.objects[0] = chosen;
        let all = view.placed(document, session);
        if !ctx.input(|i| i.pointer.any_down()) {
            let pointer = response.hover_pos().filter(|_| response.hovered());
            let t = session.shown.ray_point_t;
            let found = pointer.and_then(|at| view.hit(&all, at, t, shown, HANDLE_REACH));
            let focused = || all.iter().find(|one| view.has_focus(ctx, one.handle)).copied();
            let over = found.or_else(focused).map(|one| one.handle);
            session.live.handles.over = over;
            self.by_pointer = found.is_some();
            let over = over.and_then(Handle::object);
            if over.is_none() {
                let sphere = pointer.and_then(|at| sphere_at(shown, view.dots(at)));
                let hovered = sphere.map(|k| k as usize);
                let hovered = hovered.filter(|k| *k < document.spheres.len() && chosen != Some(*k));
                session.live.handles.objects[1] = hovered;
            } else if over == chosen {
                session.live.handles.objects[1] = None;
            }
        }
        let is_pressed = ctx.input(|i| i.pointer.button_pressed(PointerButton::Primary));
        let pressed_at = ctx
            .input(|i| i.pointer.press_origin())
            .filter(|_| is_pressed && response.is_pointer_button_down_on());
        // The press and the release of a short click may arrive in the same pass.
        let clicked_at = response.interact_pointer_pos().filter(|_| response.clicked());
        let Some(at) = pressed_at.or(clicked_at) else { return };
        let reach = if ctx.input(|i| i.any_touches()) { FINGER_REACH } else { HANDLE_REACH };
        let t = session.shown.ray_point_t;
        let Some(found) = view.hit(&all, at, t, shown, reach) else {
            let is_on_viewport = |at| {
                let (camera, frame) = (shown.resolved.as_ref(), shown.world_frame.as_ref());
                camera.zip(frame).is_some_and(|(camera, frame)| pick(camera, frame, at).is_some())
            };
            let dots = clicked_at.map(|at| view.dots(at));
            let dots = dots.filter(|dots| !is_on_viewport((*dots).into()));
            let clicked = dots.and_then(|dots| sphere_at(shown, dots));
            **chosen_object = clicked.map(|k| k as usize).or(**chosen_object);
            return;
        };
        **chosen_object = found.handle.object().or(**chosen_object);
        session.live.handles.is_busy = true;
        if pressed_at.is_none() {
            return;
        }
        self.pressed_at = pressed_at;
        session.live.handles.over = Some(found.handle);
        session.live.handles.drag =
            Some(found.taken(document, session.shown.selection, view.uv(at)));
    }

    /// Starts a drag in the camera view if a button that looks around or orbits was pressed there in this
    /// pass.
    fn press_camera(&mut self, response: &Response, input: &mut ViewInput) {
        let ViewInput { ctx, document, session, .. } = input;
        let grabbed = ctx.input(|i| {
            let pressed = |button| i.pointer.button_pressed(button);
            let looks = pressed(PointerButton::Secondary)
                || (pressed(PointerButton::Primary) && i.modifiers.alt);
            let orbits = pressed(PointerButton::Middle) || (looks && i.modifiers.shift);
            if orbits { Some(Grabbed::Orbit) } else { looks.then_some(Grabbed::Look) }
        });
        let origin = ctx.input(|i| i.pointer.press_origin());
        let (camera, is_down) = (document.camera.resolve(), response.is_pointer_button_down_on());
        let (Some(grabbed), Some(at), Ok(_), true) = (grabbed, origin, camera, is_down) else {
            return;
        };
        let before = HandleValues::read(document, session.shown.selection, None);
        let begun_at = self.camera_uv(&before.camera, at);
        let (at, length, toward) = (before.camera.eye, 1.0, DVec3::X);
        let is_beside_view = None;
        session.live.handles.drag =
            Some(Drag { grabbed, before, begun_at, at, length, toward, is_beside_view });
        session.live.handles.is_busy = true;
        (self.recent, self.refused) = (None, None);
    }

    /// Converts a point of the screen to (u, v) in the camera's viewport.
    fn camera_uv(&self, camera: &Camera, at: Pos2) -> DVec2 {
        let rect = self.camera.map_or(Rect::ZERO, |(rect, _)| rect);
        let size = rect.size().round().max(Vec2::splat(1.0));
        let at = at - rect.min;
        let share = |at: f32, size: f32| f64::from(at) / f64::from(size);
        let (right, down) = (share(at.x, size.x), share(at.y, size.y));
        DVec2::new(camera.viewport.width * (right - 0.5), camera.viewport.height * (0.5 - down))
    }

    /// Moves the held handle or the camera with the pointer; Escape undoes the drag.
    fn hold(&mut self, mut drag: Drag, world: Option<&WorldArea>, input: &mut ViewInput) {
        let ViewInput { ctx, document, session, .. } = input;
        let is_down = ctx.input(|i| match drag.grabbed {
            Grabbed::Handle(_) => i.pointer.primary_down(),
            Grabbed::Look | Grabbed::Orbit => i.pointer.any_down(),
        });
        if is_escape_pressed(ctx) {
            drag.before.put(document, &mut session.shown.selection);
            self.given_back = is_down;
            self.let_go(session);
            return;
        }
        if let Some(at) = ctx.input(|i| i.pointer.latest_pos()) {
            self.pressed_at = self.pressed_at.filter(|from| at.distance(*from) < CLICK);
            if self.pressed_at.is_none() {
                let outcome = match (drag.grabbed, world) {
                    (Grabbed::Handle(handle), Some(view)) => {
                        let settings = session.settings();
                        if drag.is_beside_view.is_none() {
                            let begun = view.handle_drag(ctx, handle, &drag, &settings);
                            drag.is_beside_view = Some(begun.begins_beside_view(view.uv(at)));
                        }
                        let dragged = view.handle_drag(ctx, handle, &drag, &settings);
                        dragged.to(view.uv(at)).map(|dragged| {
                            dragged.values.put(document, &mut session.shown.selection);
                            drag.toward = dragged.toward;
                            self.up_went_along = dragged.up_went_along;
                        })
                    }
                    _ => turned(&drag, self.camera_uv(&drag.before.camera, at))
                        .map(|camera| document.camera = camera),
                };
                self.refused = outcome.err();
            }
        }
        session.live.handles.drag = Some(drag);
        if !is_down {
            let handle = drag.handle();
            self.let_go(session);
            session.live.handles.over = handle;
        }
    }
}

/// Returns the camera after a drag in the camera view that looks around or orbits. The pointer is now at `uv`
/// in the camera's viewport.
fn turned(drag: &Drag, uv: DVec2) -> Result<Camera, SteerError> {
    let camera = drag.before.camera;
    if drag.grabbed == Grabbed::Orbit {
        let (yaw, pitch) = camera.viewport.orbit_of_drag(drag.begun_at, uv);
        camera.orbited(yaw, pitch)
    } else {
        let (yaw, pitch) = camera.viewport.look_of_drag(drag.begun_at, uv);
        camera.looked_round(yaw, pitch)
    }
}

/// Consumes all key events, so that keys have no other effect during a drag. Returns true if Escape was
/// pressed.
fn is_escape_pressed(ctx: &Context) -> bool {
    ctx.input_mut(|i| {
        let is_pressed = i.events.iter().any(|event| {
            matches!(event, Event::Key { key: Key::Escape, pressed: true, repeat: false, .. })
        });
        i.events.retain(|event| !matches!(event, Event::Key { .. } | Event::Text(_)));
        is_pressed
    })
}

/// Returns the index of the sphere at a position of the world view. The position is in physical pixels.
pub(crate) fn sphere_at(shown: &Derived, at: Vec2) -> Option<u32> {
    let frame = shown.world_frame.as_ref()?;
    let image = frame.camera().image();
    let inside = at.x >= 0.0 && at.x < image.width() as f32 && at.y >= 0.0;
    let view = (at.y as usize) * image.width() as usize + at.x as usize;
    frame.object.get(view).copied().filter(|object| inside && *object != NO_OBJECT)
}

/// Returns the t to which the user drags the point on the selected ray in the world view; `None` if there is
/// no such drag.
pub(crate) fn dragged_ray_point(
    ui: &Ui,
    response: &Response,
    ray_point_t: Option<f64>,
    shown: &Derived,
) -> Option<f64> {
    let (t, frame) = (ray_point_t?, shown.world_frame.as_deref()?);
    let ray = shown.inspection.as_deref()?.ray;
    let key = response.id.with("ray point");
    let per_point = ui.ctx().pixels_per_point();
    if response.drag_started() {
        let pressed = ui.input(|i| i.pointer.press_origin())?;
        let on_screen = overlay::world_position_of(frame.camera(), ray.at(t));
        let near = |at: DVec2| {
            let at = response.rect.min + egui::vec2(at.x as f32, at.y as f32) / per_point;
            at.distance(pressed) <= RAY_POINT_REACH
        };
        ui.data_mut(|data| data.insert_temp(key, on_screen.is_some_and(near)));
    }
    let is_taken = ui.data(|data| data.get_temp(key)).unwrap_or(false);
    if !is_taken || !response.dragged_by(PointerButton::Primary) {
        return None;
    }
    let dots = (response.interact_pointer_pos()? - response.rect.min) * per_point;
    // If the ray runs towards the observer, the point stays in place.
    Some(overlay::t_towards(frame, &ray, dots.into()).unwrap_or(t))
}
