//! The table of the methods' results.

use egui::{Color32, Grid, RichText, Stroke, Ui, vec2};

use pinhole_core::methods::Method;

use crate::model::number::short;
use crate::report::model::{Case, MethodRow};
use crate::report::plot::marker::{lightened, marker_of};
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::typesetting::theme;
use crate::view::typesetting::theme::error_color;

/// The columns' names and their explanations.
const COLUMNS: [(&str, &str); 7] = [
    (
        "wrong",
        "Decisions (hit or miss, which object is first, which of its roots) that differ from exact arithmetic",
    ),
    ("share", "Wrong decisions as a share of all"),
    ("median", "Error in t, in ulps of f64: half are at most this"),
    ("p99", "Error in t, in ulps of f64: 99 of 100 are at most this"),
    ("max ulps", "Error in t, in ulps of f64: all are at most this"),
    ("rad", "The largest angle between its normal and the true one, in radians"),
    ("ns", "Nanoseconds a pixel, the shortest of interleaved rounds, on one thread"),
];

/// Shows one row per method; a click on a row shows its method in the error map.
pub(super) fn ui(ui: &mut Ui, case: &Case, compared: &mut Method) {
    // All methods and all columns must fit into the room below two pictures.
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(13.0));
    ui.spacing_mut().interact_size.y = 17.0;
    ui.spacing_mut().button_padding = vec2(4.0, 0.0);
    Grid::new("methods").striped(true).num_columns(COLUMNS.len() + 1).spacing([10.0, 1.0]).show(
        ui,
        |ui| {
            ui.strong("method");
            for (name, hint) in COLUMNS {
                ui.strong(name).on_hover_text(hint);
            }
            ui.end_row();
            for row in &case.methods {
                line(ui, row, compared);
                ui.end_row();
            }
        },
    );
    for row in &case.methods {
        if let Some(text) = row.decided() {
            ui.label(text);
        }
    }
}

fn line(ui: &mut Ui, row: &MethodRow, compared: &mut Method) {
    ui.horizontal(|ui| {
        let (swatch, _) = ui.allocate_exact_size(vec2(9.0, 9.0), egui::Sense::hover());
        let color = color_of(ui, row);
        let radius = 0.5 * swatch.width();
        if row.is_single() {
            ui.painter().circle_stroke(swatch.center(), radius - 1.0, Stroke::new(2.0, color));
        } else {
            ui.painter().circle_filled(swatch.center(), radius, color);
        }
        match Method::from_name(&row.name) {
            Some(method) => {
                let hint = format!("{}\n{}", method.about(), method.source());
                let name = ui.selectable_value(compared, method, &row.name);
                name.named(format!("error map of {}", row.name)).on_hover_text(hint);
            }
            None => {
                ui.label(&row.name);
            }
        }
    });
    let wrong = RichText::new(row.wrong.to_string());
    ui.label(if row.wrong > 0 { wrong.strong().color(error_color(ui)) } else { wrong });
    let number = |x: Option<f64>| x.map_or("-".to_owned(), short).replace('-', "−");
    ui.label(row.wrong_share.map_or(String::new(), |share| format!("{} %", short(100.0 * share))));
    let ulps = row.ulp_f64;
    for x in [ulps.median, ulps.p99, ulps.max, row.normal_error_max] {
        ui.label(number(x));
    }
    ui.label(number(row.ns_per_pixel.min));
}

/// Returns a method's colour on this window's background.
fn color_of(ui: &Ui, row: &MethodRow) -> Color32 {
    let color = match (marker_of(row.formula()).color, ui.visuals().dark_mode) {
        (color, false) => color,
        (Color32::BLACK, true) => Color32::WHITE,
        (color, true) => lightened(color),
    };
    theme::finished(ui, color)
}
