//! Mouse and keyboard input for the handles. It is processed before anything is drawn, so that
//! everything drawn is up to date; `crate::view::handles` calculates the effects.

mod keys;
mod tell;

use egui::{Context, Event, Id, Key, PointerButton, Pos2, Rect, Response, Vec2};
use pinhole_core::{DVec2, NO_OBJECT, ResolvedCamera};
use pinhole_exchange::document::Document;

use crate::model::session::hand::{Along, Axis, Handle};
use crate::model::session::{Session, keeps_of};
use crate::view::derive::Derived;
use crate::view::handles::{
    DragOptions, DragStart, Dragged, Grip, HandleDrag, HandleValues, Stage, grips, hit,
};
use crate::view::overlay;

pub(crate) use self::tell::say;

/// Maximum distance from a handle at which the mouse grabs it, in points.
const REACH: f64 = 11.0;

/// Movement during a press, in points, below which it is a click.
const CLICK: f32 = 2.0;

/// The state of the handles' input between passes.
#[derive(Debug, Default)]
pub(crate) struct HandInput {
    /// The world view's rectangle and its id in egui.
    view: Option<(Rect, Id)>,
    start: Option<Taken>,
    /// The handle that was clicked last, so that the next click reaches the one below it.
    clicked: Option<Handle>,
    /// True if the button is still down although its drag was cancelled.
    given_back: bool,
    /// The reason why the handle is not where the pointer is.
    refused: Option<String>,
    /// The effect of the last move.
    last: Option<Dragged>,
    /// Time since when the pointer or the focus has been on its handle, in seconds.
    over_since: f64,
}

#[derive(Debug)]
struct Taken {
    start: DragStart,
    pressed_at: Pos2,
    moved: bool,
}

/// The data that the input edits.
pub(crate) struct Edited<'a> {
    pub(crate) document: &'a mut Document,
    pub(crate) session: &'a mut Session,
    pub(crate) chosen_object: &'a mut Option<usize>,
}

/// The world view on the screen.
#[derive(Clone, Copy)]
struct View<'a> {
    rect: Rect,
    id: Id,
    observer: &'a ResolvedCamera,
    scale: f32,
}

impl View<'_> {
    fn dots(&self, at: Pos2) -> DVec2 {
        let at = (at - self.rect.min) * self.scale;
        DVec2::new(at.x.into(), at.y.into())
    }

    /// Returns the position of a point of the screen in the observer's viewport.
    fn uv(&self, at: Pos2) -> DVec2 {
        let image = self.observer.image();
        let size = [image.width() as usize, image.height() as usize];
        let dots = self.dots(at);
        overlay::camera_uv_at(self.observer, size, [dots.x as f32, dots.y as f32])
    }

    fn stage<'a>(
        &'a self,
        document: &'a Document,
        resolved: Option<&'a ResolvedCamera>,
        session: &Session,
    ) -> Stage<'a> {
        Stage {
            document,
            resolved,
            selection: session.selection,
            items: session.settings.items,
            observer: self.observer,
            scale: self.scale,
        }
    }
}

impl HandInput {
    /// Applies the input of mouse and keys to the handles. `shown` is the last frame, which the
    /// user reacts to.
    pub(crate) fn take(&mut self, ctx: &Context, edited: &mut Edited, shown: &Derived) {
        let hand = &mut edited.session.hand;
        hand.is_busy = self.start.is_some() || self.given_back;
        let down = ctx.input(|i| i.pointer.primary_down());
        self.given_back &= down;
        let response = self.view.and_then(|(_, id)| ctx.read_response(id));
        let (Some((rect, id)), Some(frame), Some(response)) =
            (self.view, shown.world_frame.as_deref(), response)
        else {
            self.let_go(edited.session);
            return;
        };
        let view = View { rect, id, observer: frame.camera(), scale: ctx.pixels_per_point() };
        if self.start.is_none() {
            self.look(ctx, &view, &response, edited, shown);
            if ctx.input(|i| i.pointer.button_pressed(PointerButton::Primary)) {
                self.press(ctx, &view, &response, edited, shown);
            }
            if self.start.is_none() && response.clicked() {
                self.click(&view, &response, edited, shown);
            }
        }
        if self.start.is_some() {
            self.hold(ctx, &view, edited);
        } else {
            self.keys(ctx, &view, edited);
        }
    }

    /// Releases everything, because another scene or a dialog is shown.
    pub(crate) fn let_go(&mut self, session: &mut Session) {
        self.start = None;
        self.refused = None;
        self.last = None;
        session.hand.held = None;
        session.hand.over = None;
        session.hand.along = Along::default();
    }

    /// Updates which handle the pointer or the keyboard focus is on.
    fn look(
        &mut self,
        ctx: &Context,
        view: &View,
        response: &Response,
        edited: &mut Edited,
        shown: &Derived,
    ) {
        let Edited { document, session, chosen_object } = edited;
        let chosen = chosen_object.filter(|chosen| *chosen < document.object_count());
        session.hand.objects[0] = chosen;
        let resolved = document.camera.resolve().ok();
        let all = grips(&view.stage(document, resolved.as_ref(), session), &session.hand);
        let pointer = response.hover_pos().filter(|_| response.hovered());
        let pointer = pointer.filter(|_| ctx.input(|i| !i.pointer.any_down()));
        let found = pointer.and_then(|at| self.hit(&all, view, at, session, shown));
        let focused = || all.iter().find(|g| ctx.memory(|m| m.has_focus(id_of(view.id, g.handle))));
        if ctx.input(|i| i.pointer.any_down()) {
            return;
        }
        let over = found.map(|hit| hit.handle).or_else(|| Some(focused()?.handle));
        if over != session.hand.over {
            self.over_since = ctx.input(|i| i.time);
        }
        session.hand.over = over;
        session.hand.together = found.map_or(0, |hit| hit.together);
        let over = over.and_then(Handle::object);
        if over.is_none() {
            let dots = |at| (at - view.rect.min) * view.scale;
            let hovered = pointer.and_then(|at| sphere_at(shown, dots(at))).map(|k| k as usize);
            let hovered = hovered.filter(|k| *k < document.spheres.len() && chosen != Some(*k));
            session.hand.objects[1] = hovered;
        } else if over == chosen {
            session.hand.objects[1] = None;
        }
    }

    fn hit(
        &mut self,
        all: &[Grip],
        view: &View,
        at: Pos2,
        session: &Session,
        shown: &Derived,
    ) -> Option<crate::view::handles::Hit> {
        let (dots, reach) = (view.dots(at), REACH * f64::from(view.scale));
        let near = |handle: &Handle| {
            all.iter().any(|g| g.handle == *handle && g.spot.distance(dots) <= reach)
        };
        self.clicked = self.clicked.filter(near);
        let found = hit(all, dots, reach, self.clicked)?;
        // The point that walks along the ray can be grabbed too.
        let ray_point_t =
            session.ray_point_t.zip(shown.inspection.as_deref()).zip(shown.world_frame.as_deref());
        let ray_point_t = ray_point_t.and_then(|((t, inspection), frame)| {
            overlay::world_position_of(frame, inspection.ray.at(t))
        });
        let ray_point_t = ray_point_t.map(|[x, y]| DVec2::new(x.into(), y.into()).distance(dots));
        let own = all.iter().find(|g| g.handle == found.handle)?.spot.distance(dots);
        ray_point_t.is_none_or(|ray_point_t| ray_point_t > own).then_some(found)
    }

    fn press(
        &mut self,
        ctx: &Context,
        view: &View,
        response: &Response,
        edited: &mut Edited,
        shown: &Derived,
    ) {
        let origin = ctx.input(|i| i.pointer.press_origin());
        let Some(at) = origin.filter(|_| response.is_pointer_button_down_on()) else { return };
        let Edited { document, session, chosen_object } = edited;
        let resolved = document.camera.resolve().ok();
        let stage = view.stage(document, resolved.as_ref(), session);
        let all = grips(&stage, &session.hand);
        let Some(found) = self.hit(&all, view, at, session, shown) else { return };
        let taken = all.iter().find(|grip| grip.handle == found.handle);
        let (Some(grip), Some(grasp)) = (taken, stage.grasp(found.handle)) else { return };
        let before = HandleValues::read(found.handle, document, session.selection);
        let start = DragStart { before, resolved, grasp, at: grip.at, begun_at: view.uv(at) };
        self.start = Some(Taken { start, pressed_at: at, moved: false });
        if let Some(object) = found.handle.object() {
            **chosen_object = Some(object);
        }
        let hand = &mut session.hand;
        (hand.held, hand.over, hand.is_busy) = (Some(grasp), Some(found.handle), true);
    }

    /// Handles a click so short that press and release arrive in the same pass.
    fn click(&mut self, view: &View, response: &Response, edited: &mut Edited, shown: &Derived) {
        let Edited { document, session, chosen_object } = edited;
        let Some(at) = response.interact_pointer_pos() else { return };
        let resolved = document.camera.resolve().ok();
        let all = grips(&view.stage(document, resolved.as_ref(), session), &session.hand);
        let Some(found) = self.hit(&all, view, at, session, shown) else { return };
        if let Some(object) = found.handle.object() {
            **chosen_object = Some(object);
        }
        self.clicked = Some(found.handle);
        session.hand.is_busy = true;
    }

    /// Moves the held handle with the pointer.
    fn hold(&mut self, ctx: &Context, view: &View, edited: &mut Edited) {
        let Some(taken) = &mut self.start else { return };
        let Edited { document, session, .. } = edited;
        let keys = taken_keys(ctx);
        if keys.contains(&Key::K) {
            session.settings.eye_keeps = session.settings.eye_keeps.other();
        }
        let down = ctx.input(|i| i.pointer.primary_down());
        if keys.contains(&Key::Escape) {
            taken.start.before.put(document, &mut session.selection);
            self.given_back = down;
            self.clicked = None;
            self.let_go(session);
            return;
        }
        let options = options(ctx, session);
        let along = kept_along(session.hand.along, options.along);
        let options = DragOptions { along, ..options };
        session.hand.along = along;
        let pointer = ctx.input(|i| i.pointer.latest_pos());
        if let Some(at) = pointer {
            taken.moved |= at.distance(taken.pressed_at) >= CLICK;
            if taken.moved {
                let pull = HandleDrag {
                    start: &taken.start,
                    observer: view.observer,
                    scale: view.scale,
                    options,
                };
                match pull.to(view.uv(at)) {
                    Ok(pulled) => {
                        pulled.part.put(document, &mut session.selection);
                        session.hand.held = Some(pulled.grasp);
                        (self.last, self.refused) = (Some(pulled), None);
                    }
                    Err(reason) => self.refused = Some(reason),
                }
            }
        }
        if !down {
            let handle = taken.start.grasp.handle;
            self.clicked = (!taken.moved).then_some(handle);
            self.let_go(session);
            session.hand.over = Some(handle);
        }
    }
}

/// Returns the constraint of a drag whose keys now ask for `asked`: letting go of a key moves nothing, so
/// a constraint lasts until another key or the end of the drag.
fn kept_along(before: Along, asked: Along) -> Along {
    match (before, asked) {
        (_, Along::View) => before,
        (Along::Without(plane), Along::Axis(axis)) if plane == axis => before,
        _ => asked,
    }
}

/// Returns the id that represents a handle in egui, for the focus and for screen readers.
fn id_of(view: Id, handle: Handle) -> Id {
    view.with(("handle", handle))
}

/// Returns the pressed keys and consumes them: they have no other effect during a drag.
pub(crate) fn taken_keys(ctx: &Context) -> Vec<Key> {
    ctx.input_mut(|i| {
        let pressed = i.events.iter().filter_map(|event| match event {
            Event::Key { key, pressed: true, repeat: false, .. } => Some(*key),
            _ => None,
        });
        let pressed = pressed.collect();
        i.events.retain(|event| !matches!(event, Event::Key { .. } | Event::Text(_)));
        pressed
    })
}

/// Returns the axis whose key is held down.
fn axis_held(ctx: &Context) -> Option<Axis> {
    let keys = [Key::X, Key::Y, Key::Z, Key::U, Key::V, Key::W];
    let held = |key: Key| ctx.input(|i| i.key_down(key));
    Axis::ALL.into_iter().zip(keys).find(|(_, key)| held(*key)).map(|(axis, _)| axis)
}

/// Returns the constraints of the drag, from keys and settings.
fn options(ctx: &Context, session: &Session) -> DragOptions {
    let modifiers = ctx.input(|i| i.modifiers);
    let along = match (axis_held(ctx), modifiers.shift) {
        (None, _) => Along::View,
        (Some(axis), false) => Along::Axis(axis),
        (Some(axis), true) => Along::Without(axis),
    };
    let (eye, corner, distance) = keeps_of(&session.settings, modifiers.alt);
    let keeps_up = session.settings.keep_up;
    DragOptions { along, snaps: modifiers.command, eye, keeps_up, corner, distance }
}

/// Returns the index of the sphere at a position of the world view, in physical pixels.
pub(crate) fn sphere_at(shown: &Derived, at: Vec2) -> Option<u32> {
    let frame = shown.world_frame.as_ref()?;
    let image = frame.camera().image();
    let inside = at.x >= 0.0 && at.x < image.width() as f32 && at.y >= 0.0;
    let view = (at.y as usize) * image.width() as usize + at.x as usize;
    frame.object.get(view).copied().filter(|object| inside && *object != NO_OBJECT)
}
