//! What can be dragged in the drawing, and how it looks.

use egui::{
    Align2, CursorIcon, EventFilter, Key, Pos2, Rect, Response, Sense, Stroke, Ui, Vec2, vec2,
};
use pinhole_core::DVec2;

use super::drawing::{Ink, NAMES};
use super::sheet::Sheet;
use super::steps::number;
use crate::lines::{Handle, LinesLab};
use crate::panels::words::{Font, Words, around};

/// Half the side of what takes the pointer around a handle, in points.
const GRASP: f32 = 13.0;

/// A handle that is in sight, and what the pointer does with it.
pub(super) type Grabbed = (Handle, Response);

/// Takes what is dragged.
pub(super) fn inputs(ui: &Ui, sheet: &Sheet, lab: &mut LinesLab) -> Vec<Grabbed> {
    Handle::ALL
        .into_iter()
        .filter_map(|handle| Some((handle, input(ui, sheet, lab, handle)?)))
        .collect()
}

fn input(ui: &Ui, sheet: &Sheet, lab: &mut LinesLab, handle: Handle) -> Option<Response> {
    let at = in_sight(sheet, lab, handle)?;
    let id = ui.scope_id().with(handle.name());
    let around = Rect::from_center_size(at, Vec2::splat(2.0 * GRASP));
    let response = ui.interact(around, id, Sense::click_and_drag());
    let response = response.on_hover_cursor(CursorIcon::Grab);
    let arrows =
        EventFilter { horizontal_arrows: true, vertical_arrows: true, ..Default::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(id, arrows));
    // Whole hundredths, or whatever is finer than a dot.
    let dots = sheet.scale * f64::from(ui.ctx().pixels_per_point());
    let fineness = 10_f64.powf(dots.log10().ceil());
    if response.drag_started() {
        response.request_focus();
        // Taken hold of beside its middle, it stays that far beside the pointer.
        let pressed = ui.input(|i| i.pointer.press_origin()).unwrap_or(at);
        ui.data_mut(|data| data.insert_temp(id, at - pressed));
    }
    if response.dragged()
        && let Some(pointer) = response.interact_pointer_pos()
    {
        let beside: Vec2 = ui.data(|data| data.get_temp(id)).unwrap_or_default();
        lab.drag(handle, sheet.point(pointer + beside), fineness);
    }
    if response.has_focus() {
        let presses = |key| ui.input(|i| i.num_presses(key) as f64);
        let right = presses(Key::ArrowRight) - presses(Key::ArrowLeft);
        let up = presses(Key::ArrowUp) - presses(Key::ArrowDown);
        if (right, up) != (0.0, 0.0) {
            lab.nudge(handle, DVec2::new(right, up), fineness);
        }
    }
    let place = lab.place_of(handle)?;
    ui.ctx().accesskit_node_builder(id, |node| {
        node.set_role(egui::accesskit::Role::Slider);
        node.set_label(handle.name());
        node.set_value(format!("({}, {})", number(place.x, 5), number(place.y, 5)));
    });
    Some(response)
}

/// Keeps words off the handles.
pub(super) fn keep_free(sheet: &Sheet, lab: &LinesLab, words: &mut Words) {
    for handle in Handle::ALL {
        if let Some(place) = lab.place_of(handle) {
            words.keep_free(Rect::from_center_size(sheet.place(place), Vec2::splat(15.0)));
        }
    }
}

/// Whether the pointer or the keyboard is at a handle.
pub(super) fn is_held(response: &Response) -> bool {
    response.hovered() || response.dragged() || response.has_focus()
}

/// Draws the handles in sight over everything else.
pub(super) fn draw(sheet: &Sheet, lab: &LinesLab, ink: &Ink, held: impl Fn(Handle) -> bool) {
    for handle in Handle::ALL {
        let Some(at) = in_sight(sheet, lab, handle) else { continue };
        one(sheet, handle, at, ink, held(handle));
    }
}

/// Where a handle is, if it can be reached.
fn in_sight(sheet: &Sheet, lab: &LinesLab, handle: Handle) -> Option<Pos2> {
    let at = sheet.place(lab.place_of(handle)?);
    sheet.rect.expand(GRASP).contains(at).then_some(at)
}

fn one(sheet: &Sheet, handle: Handle, at: Pos2, ink: &Ink, held: bool) {
    let larger = if held { 1.3 } else { 1.0 };
    let edge = Stroke::new(2.0, sheet.halo);
    let painter = &sheet.painter;
    match handle {
        Handle::Move => {
            let square = Rect::from_center_size(at, Vec2::splat(15.0 * larger));
            painter.rect(square, 2.0, ink.implicit, edge, egui::StrokeKind::Outside);
        }
        Handle::Turn => {
            painter.circle(at, 8.0 * larger, sheet.halo, Stroke::new(4.0, ink.implicit));
        }
        Handle::P => {
            painter.circle(at, 8.0 * larger, ink.ray, edge);
        }
        Handle::Tip if held => {
            painter.circle_stroke(at, 12.0, Stroke::new(2.0, ink.ray));
        }
        Handle::Tip => {}
        Handle::T => {
            painter.circle(at, 7.0 * larger, ink.text, Stroke::new(3.0, ink.ray));
        }
    }
}

/// p, d and t at their handles.
pub(super) fn names(sheet: &Sheet, lab: &LinesLab, ink: &Ink, words: &mut Words, digits: usize) {
    let d = lab.ray.d.normalize_or_zero();
    // On the screen y grows downwards: to the right of d, and backwards.
    let (right, back) = (vec2(d.y as f32, d.x as f32), vec2(-d.x as f32, d.y as f32));
    let of_ray = Font { size: NAMES + 1.0, color: ink.ray, bold: true };
    let of_t = Font { size: NAMES, color: ink.text, bold: false };
    let t = format!("t = {}", number(lab.t, digits));
    for (handle, text, font, toward) in [
        (Handle::P, "p", of_ray, back - right),
        (Handle::T, t.as_str(), of_t, right),
        (Handle::Tip, "d", of_ray, right),
    ] {
        if let Some(place) = lab.place_of(handle) {
            words.write(text, font, around(sheet.place(place), toward, 13.0));
        }
    }
}

/// The crossing of both lines.
pub(super) fn cross(sheet: &Sheet, at: Pos2, ink: &Ink) {
    let arm = 9.0;
    for (width, color) in [(7.0, sheet.halo), (4.0, ink.text)] {
        for side in [vec2(arm, arm), vec2(arm, -arm)] {
            sheet.painter.line_segment([at - side, at + side], Stroke::new(width, color));
        }
    }
}

/// Below, above and beside the crossing.
pub(super) fn places_at_crossing(at: Pos2) -> Vec<(Pos2, Align2)> {
    around(at, vec2(0.0, 1.0), 17.0).chain(around(at, vec2(0.0, 1.0), 30.0)).collect()
}
