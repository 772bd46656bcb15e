//! The legend of the map of certainty.

use egui::{Rect, Ui, UiBuilder, pos2, vec2};
use pinhole_core::Certificate;

use super::{LEGEND, color_bar};
use crate::view::certainty::{Certainty, STEPS, color};
use crate::view::typesetting::theme;

/// Shows which colour is which step, with the number of its pixels, and what bright and dark are.
pub(crate) fn legend(ui: &mut Ui, area: Rect, certainty: &Certainty) {
    let below = Rect::from_min_size(
        pos2(area.left(), area.bottom() + 2.0),
        vec2(area.width(), LEGEND - 2.0),
    );
    ui.scope_builder(UiBuilder::new().max_rect(below), |ui| {
        ui.set_clip_rect(below);
        ui.horizontal(|ui| {
            for (step, name, full) in STEPS {
                let (swatch, _) = ui.allocate_exact_size(vec2(12.0, 12.0), egui::Sense::hover());
                ui.painter().rect_filled(swatch, 0.0, theme::finished(ui, full));
                ui.strong(format!("{name}: {}", certainty.count(step)));
                ui.add_space(6.0);
            }
            ui.label("screen pixels");
        });
        ui.horizontal(|ui| {
            ui.label("0 bits to spare");
            let width = (ui.available_width() - 70.0).clamp(40.0, 200.0);
            color_bar(ui, width, &STEPS.map(|(step, ..)| step), |step, share| {
                color(*step, Certificate::MOST * share)
            });
            ui.label(format!("{} or more", Certificate::MOST));
        });
    });
}

/// Returns `f64 decided 159990 of 160000 screen pixels, with 23 bits to spare or more; double-double 8,
/// exact 2`.
pub(crate) fn summary(certainty: &Certainty) -> String {
    let [f64, double_double, exact] = STEPS.map(|(step, ..)| certainty.count(step));
    let all = certainty.certificates.len();
    let least = certainty.least_in_f64();
    let least = least
        .map_or(String::new(), |margin| format!(", with {} bits to spare or more", margin.floor()));
    format!(
        "f64 decided {f64} of {all} screen pixels{least}; double-double {double_double}, exact {exact}"
    )
}
