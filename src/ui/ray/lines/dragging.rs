//! Dragging in the drawing of both lines.

use egui::accesskit::Role;
use egui::{CursorIcon, Key, Rect, Response, Sense, Ui, Vec2};
use pinhole_core::DVec2;
use pinhole_lecture::numbers::written as number;

use crate::model::lines::{Handle, LinesLab};
use crate::ui::widgets::spoken::{Spoken as _, keep_arrows};
use crate::view::lines::drawing::{GRASP, Plane};

/// Shows the drawing and handles drags in it.
pub(super) fn ui(ui: &mut Ui, rect: Rect, lab: &mut LinesLab, digits: usize) {
    look_around(ui, rect, lab);
    let before = Plane::new(ui, rect, lab.window);
    let inputs = Handle::ALL.into_iter();
    let inputs = inputs.filter_map(|handle| Some((handle, input(ui, &before, lab, handle)?)));
    let grabbed: Vec<(Handle, Response)> = inputs.collect();
    let plane = Plane::new(ui, rect, lab.window);
    plane.background();
    let is_held = |handle| grabbed.iter().any(|(held, by)| *held == handle && is_held(by));
    if let Some(seen) = plane.paint(lab, is_held, digits) {
        let id = ui.scope_id().with("plane");
        ui.ctx().accesskit_node_builder(id, |node| node.set_description(seen));
    }
    for (handle, response) in grabbed {
        response.on_hover_text(handle.name());
    }
}

/// Pans by dragging beside all handles, and zooms about the pointer by the wheel.
fn look_around(ui: &Ui, rect: Rect, lab: &mut LinesLab) {
    let response = ui.interact(rect, ui.scope_id().with("plane"), Sense::drag());
    let response = response.with_role(Role::Image).named("Plane with both lines");
    let per_point = 2.0 * lab.window.half_extent / f64::from(rect.size().min_elem());
    let delta = response.drag_delta();
    lab.window.center -= per_point * DVec2::new(delta.x.into(), (-delta.y).into());
    if response.contains_pointer()
        && let Some(pointer) = ui.input(|i| i.pointer.hover_pos())
    {
        let (scroll, pinch) = ui.input(|i| (i.smooth_scroll_delta(), i.zoom_delta()));
        let factor = f64::from(pinch) * f64::from(scroll.y * 0.004).exp();
        let half = (lab.window.half_extent / factor).clamp(0.05, 1e4);
        let away = pointer - rect.center();
        let away = DVec2::new(away.x.into(), (-away.y).into());
        let kept = lab.window.half_extent - half;
        lab.window.center += 2.0 * kept / f64::from(rect.size().min_elem()) * away;
        lab.window.half_extent = half;
    }
}

/// Handles the drags of a handle. Returns the response of its area, if it is visible.
fn input(ui: &Ui, plane: &Plane, lab: &mut LinesLab, handle: Handle) -> Option<Response> {
    let at = plane.in_sight(lab, handle)?;
    let id = ui.scope_id().with(handle.name());
    let around = Rect::from_center_size(at, Vec2::splat(2.0 * GRASP));
    let response = ui.interact(around, id, Sense::click_and_drag());
    let response = response.on_hover_cursor(CursorIcon::Grab);
    keep_arrows(&response, true, true);
    // Round to hundredths, or finer if a pixel is finer.
    let dots = plane.unit() * f64::from(ui.ctx().pixels_per_point());
    let fineness = 10_f64.powf(dots.log10().ceil());
    if response.drag_started() {
        response.request_focus();
        // A handle that was grabbed beside its middle keeps this offset from the pointer.
        let pressed = ui.input(|i| i.pointer.press_origin()).unwrap_or(at);
        ui.data_mut(|data| data.insert_temp(id, at - pressed));
    }
    if response.dragged()
        && let Some(pointer) = response.interact_pointer_pos()
    {
        let beside: Vec2 = ui.data(|data| data.get_temp(id)).unwrap_or_default();
        lab.drag(handle, plane.to_plane(pointer + beside), fineness);
    }
    if response.has_focus() {
        let presses = |key| ui.input(|i| i.num_presses(key) as f64);
        let right = presses(Key::ArrowRight) - presses(Key::ArrowLeft);
        let up = presses(Key::ArrowUp) - presses(Key::ArrowDown);
        if (right, up) != (0.0, 0.0) {
            lab.nudge(handle, DVec2::new(right, up), fineness);
        }
    }
    let position = lab.position_of(handle)?;
    let value = format!("({}, {})", number(position.x, 5), number(position.y, 5));
    Some(response.with_role(Role::Slider).named(handle.name()).described(value))
}

/// Returns true if the pointer or the keyboard focus is on a handle.
fn is_held(response: &Response) -> bool {
    response.hovered() || response.dragged() || response.has_focus()
}
