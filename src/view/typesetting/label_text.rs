//! Text of the overlay's labels, the same in the window and in files.

use egui::{FontFamily, FontId, Painter, Pos2, Vec2, vec2};

use crate::view::overlay::Label;

/// Writes a label of a picture whose upper left corner is at `origin`.
pub(crate) fn write(painter: &Painter, origin: Pos2, per_point: f32, label: &Label) {
    let center = origin + vec2(label.position[0], label.position[1]) / per_point;
    let family =
        if label.bold { FontFamily::Name("bold".into()) } else { FontFamily::Proportional };
    let font = FontId::new(label.size, family);
    let galley = painter.layout_no_wrap(label.text.clone(), font, label.color);
    let min = center - 0.5 * galley.size();
    // A casing in the background's colour keeps text legible over anything.
    for direction in 0..8 {
        let at = min + 1.3 * Vec2::angled(direction as f32 * std::f32::consts::FRAC_PI_4);
        painter.galley_with_override_text_color(at, galley.clone(), label.halo);
    }
    painter.galley(min, galley, label.color);
}
