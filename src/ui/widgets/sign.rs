//! The signs for right and wrong, drawn because the fonts have neither.

use egui::{Color32, Painter, Rect, Response, Sense, Stroke, Ui, vec2};

use crate::view::typesetting::theme::error_color;

/// Shows a tick or a cross, as high as the text beside it.
pub(crate) fn sign(ui: &mut Ui, is_right: bool) -> Response {
    let side = 14.0;
    let line = ui.text_style_height(&egui::TextStyle::Body).max(20.0);
    let (rect, response) = ui.allocate_exact_size(vec2(side, line), Sense::hover());
    let rect = Rect::from_center_size(rect.center(), vec2(side, side));
    if is_right {
        tick(ui.painter(), rect, ui.visuals().text_color());
    } else {
        cross(ui.painter(), rect, error_color(ui));
    }
    response
}

/// Draws a tick.
pub(crate) fn tick(painter: &Painter, rect: Rect, color: Color32) {
    draw(painter, rect, color, [[(0.1, 0.55), (0.4, 0.85)], [(0.4, 0.85), (0.9, 0.15)]]);
}

/// Draws a cross.
pub(crate) fn cross(painter: &Painter, rect: Rect, color: Color32) {
    draw(painter, rect, color, [[(0.15, 0.15), (0.85, 0.85)], [(0.85, 0.15), (0.15, 0.85)]]);
}

fn draw(painter: &Painter, rect: Rect, color: Color32, lines: [[(f32, f32); 2]; 2]) {
    let stroke = Stroke::new(0.16 * rect.width(), color);
    for line in lines {
        painter.line_segment(line.map(|(x, y)| rect.lerp_inside(vec2(x, y))), stroke);
    }
}
