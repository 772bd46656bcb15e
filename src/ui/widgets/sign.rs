//! The signs for right and wrong, drawn because the fonts have neither.

use egui::{Response, Sense, Stroke, Ui, vec2};

use crate::view::typesetting::theme::error_color;

/// Shows a tick or a cross, as high as the text beside it.
pub(crate) fn sign(ui: &mut Ui, is_right: bool) -> Response {
    let side = 14.0;
    let line = ui.text_style_height(&egui::TextStyle::Body).max(20.0);
    let (rect, response) = ui.allocate_exact_size(vec2(side, line), Sense::hover());
    let at = |x: f32, y: f32| rect.center() + side * vec2(x - 0.5, y - 0.5);
    let color = if is_right { ui.visuals().text_color() } else { error_color(ui) };
    let stroke = Stroke::new(2.2, color);
    let lines = if is_right {
        [[at(0.1, 0.55), at(0.4, 0.85)], [at(0.4, 0.85), at(0.9, 0.15)]]
    } else {
        [[at(0.15, 0.15), at(0.85, 0.85)], [at(0.85, 0.15), at(0.15, 0.85)]]
    };
    for line in lines {
        ui.painter().line_segment(line, stroke);
    }
    response
}
