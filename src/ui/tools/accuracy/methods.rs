//! The results of every method: error against run time as it is written to files, in the window's
//! colours, and the table of numbers.

use egui::accesskit::Role;
use egui::epaint::shape_transform::adjust_colors;
use egui::layers::ShapeIdx;
use egui::{Color32, Grid, Painter, PopupAnchor, Pos2, RichText, Sense, Tooltip, Ui, vec2};
use pinhole_core::methods::Method;

use crate::report::model::{Case, MethodRow};
use crate::report::plot::marker::{lightened, marker_of};
use crate::report::plot::panels;
use crate::report::summary::Summary;
use crate::ui::widgets::Spoken as _;
use crate::view::typesetting::theme::{self, error_color};
use pinhole_lecture::numbers::short;

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

/// Greatest distance of the pointer from the mark that it shows the numbers of, in points.
const NEAR: f32 = 14.0;

/// Shows the plot of a case; at the mark under the pointer, the numbers of its method.
pub(super) fn plot(ui: &mut Ui, case: &Case) {
    let rect = ui.available_rect_before_wrap();
    let response = ui.allocate_rect(rect, Sense::CLICK).with_role(Role::Image);
    let response = response.named("Every method's error against its time");
    let summary = Summary::new(vec![case]);
    let marks = in_window_colors(ui, |painter| panels(painter, rect, &summary));
    let Some(pointer) = response.hover_pos() else { return };
    let distance = |center: Pos2| center.distance(pointer);
    let nearest = marks.iter().min_by(|a, b| distance(a.center).total_cmp(&distance(b.center)));
    let name = nearest.filter(|mark| distance(mark.center) < NEAR).map(|mark| mark.method.name);
    if let Some(row) = case.methods.iter().find(|row| Some(row.name.as_str()) == name) {
        let (layer, pointer) = (response.layer_id, PopupAnchor::Pointer);
        let tooltip = Tooltip::always_open(ui.ctx().clone(), layer, response.id, pointer);
        tooltip.show(|ui| ui.label(description(row)));
    }
}

/// Draws what is made for white paper, and changes its colours to the window's.
fn in_window_colors<R>(ui: &Ui, draw: impl FnOnce(&Painter) -> R) -> R {
    let (painter, style, ground) = (ui.painter(), theme::style(ui), ui.visuals().panel_fill);
    let next_shape =
        || ui.ctx().graphics_mut(|graphics| graphics.entry(painter.layer_id()).next_idx().0);
    let first = next_shape();
    let result = draw(painter);
    let drawn = first..next_shape();
    let recolor = move |color: &mut Color32| {
        let mut dots = [if style.is_dark() { on_dark(*color, ground) } else { *color }];
        style.finish(&mut dots);
        *color = dots[0];
    };
    ui.ctx().graphics_mut(|graphics| {
        let list = graphics.entry(painter.layer_id());
        for k in drawn {
            list.mutate_shape(ShapeIdx(k), |clipped| adjust_colors(&mut clipped.shape, recolor));
        }
    });
    result
}

/// Returns the colour on a dark ground of what is drawn on white paper: greys and pale colours are
/// mirrored, others lightened.
fn on_dark(color: Color32, ground: Color32) -> Color32 {
    let [r, g, b, a] = color.to_array().map(f32::from);
    let (least, most) = (r.min(g).min(b), r.max(g).max(b));
    if a == 0.0 {
        return color;
    }
    if most - least > 64.0 {
        return lightened(color);
    }
    let middle = 0.5 * (least + most);
    let mirrored = 255.0 - middle / 255.0 * (255.0 - f32::from(ground.g()));
    let [r, g, b] = [r, g, b].map(|part| (part - middle + mirrored) as u8);
    Color32::from_rgb(r, g, b)
}

/// Returns the description of a method under the pointer.
fn description(row: &MethodRow) -> String {
    let number = |x: Option<f64>| x.map_or("-".to_owned(), short);
    let mut lines = vec![
        row.name.clone(),
        format!("{} ns a pixel", number(row.ns_per_pixel.min)),
        format!("t off by at most {} ulps of f64", number(row.ulp_f64.max)),
        format!("{} of {} decisions wrong", row.wrong, row.decisions),
    ];
    if let Some(method) = Method::from_name(&row.name) {
        lines.extend([method.about(), method.source()].map(str::to_owned));
    }
    lines.join("\n")
}

/// Shows one row per method; a click on a row shows its method in the error map.
pub(super) fn table(ui: &mut Ui, case: &Case, compared: &mut Method) {
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
        let (mark, _) = ui.allocate_exact_size(vec2(20.0, 12.0), Sense::hover());
        in_window_colors(ui, |painter| {
            marker_of(row.formula()).draw(painter, mark.center(), row.digits());
        });
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
