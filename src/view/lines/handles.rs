//! The handles of the drawing and their look.

use egui::{Align2, Pos2, Rect, Stroke, Vec2, vec2};

use crate::model::lines::{Handle, LinesLab};
use crate::view::lines::canvas::Canvas;
use crate::view::lines::drawing::{Ink, NAMES};
use crate::view::lines::steps::number;
use crate::view::typesetting::label_layout::{Font, LabelLayout, around};

/// Half the side of the square around a handle that takes the pointer, in points.
pub(crate) const GRASP: f32 = 13.0;

/// Keeps labels off the handles.
pub(crate) fn keep_free(canvas: &Canvas, lab: &LinesLab, labels: &mut LabelLayout) {
    for handle in Handle::ALL {
        if let Some(position) = lab.position_of(handle) {
            labels.keep_free(Rect::from_center_size(canvas.to_screen(position), Vec2::splat(15.0)));
        }
    }
}

/// Draws the visible handles over everything else.
pub(crate) fn draw(canvas: &Canvas, lab: &LinesLab, ink: &Ink, held: impl Fn(Handle) -> bool) {
    for handle in Handle::ALL {
        let Some(at) = in_sight(canvas, lab, handle) else { continue };
        one(canvas, handle, at, ink, held(handle));
    }
}

/// Returns a handle's position, if it can be reached.
pub(crate) fn in_sight(canvas: &Canvas, lab: &LinesLab, handle: Handle) -> Option<Pos2> {
    let at = canvas.to_screen(lab.position_of(handle)?);
    canvas.rect.expand(GRASP).contains(at).then_some(at)
}

fn one(canvas: &Canvas, handle: Handle, at: Pos2, ink: &Ink, held: bool) {
    let larger = if held { 1.3 } else { 1.0 };
    let edge = Stroke::new(2.0, canvas.halo);
    let painter = &canvas.painter;
    match handle {
        Handle::Move => {
            let square = Rect::from_center_size(at, Vec2::splat(15.0 * larger));
            painter.rect(square, 2.0, ink.implicit, edge, egui::StrokeKind::Outside);
        }
        Handle::Turn => {
            painter.circle(at, 8.0 * larger, canvas.halo, Stroke::new(4.0, ink.implicit));
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

/// Writes p, d and t at their handles.
pub(crate) fn names(
    canvas: &Canvas,
    lab: &LinesLab,
    ink: &Ink,
    labels: &mut LabelLayout,
    digits: usize,
) {
    let d = lab.ray.d.normalize_or_zero();
    // y grows downwards on the screen: these are the direction to the right of d, and backwards.
    let (right, back) = (vec2(d.y as f32, d.x as f32), vec2(-d.x as f32, d.y as f32));
    let of_ray = Font { size: NAMES + 1.0, color: ink.ray, bold: true };
    let of_t = Font { size: NAMES, color: ink.text, bold: false };
    let t = format!("t = {}", number(lab.t, digits));
    for (handle, text, font, toward) in [
        (Handle::P, "p", of_ray, back - right),
        (Handle::T, t.as_str(), of_t, right),
        (Handle::Tip, "d", of_ray, right),
    ] {
        if let Some(position) = lab.position_of(handle) {
            labels.write(text, font, around(canvas.to_screen(position), toward, 13.0));
        }
    }
}

/// Draws a cross where both lines meet.
pub(crate) fn cross(canvas: &Canvas, at: Pos2, ink: &Ink) {
    let arm = 9.0;
    for (width, color) in [(7.0, canvas.halo), (4.0, ink.text)] {
        for side in [vec2(arm, arm), vec2(arm, -arm)] {
            canvas.painter.line_segment([at - side, at + side], Stroke::new(width, color));
        }
    }
}

/// Returns label positions below, above and beside the crossing.
pub(crate) fn anchors_at_crossing(at: Pos2) -> Vec<(Pos2, Align2)> {
    around(at, vec2(0.0, 1.0), 17.0).chain(around(at, vec2(0.0, 1.0), 30.0)).collect()
}
