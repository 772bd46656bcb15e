//! The plot of error against run time, as it is written to files, in the window's colours.

use egui::accesskit::Role;
use egui::epaint::shape_transform::adjust_colors;
use egui::layers::ShapeIdx;
use egui::{Color32, Painter, Sense, Ui};
use pinhole_core::methods::Method;

use crate::model::number::short;
use crate::report::model::{Case, MethodRow};
use crate::report::plot::{marker, panels};
use crate::report::summary::Summary;
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::typesetting::theme;

/// Greatest distance of the pointer from the mark that it shows the numbers of, in points.
const NEAR: f32 = 14.0;

/// Shows the plot of a case.
pub(super) fn ui(ui: &mut Ui, case: &Case) {
    let rect = ui.available_rect_before_wrap();
    let response = ui.allocate_rect(rect, Sense::hover()).with_role(Role::Image);
    let response = response.named("Every method's error against its time");
    let summary = Summary::new(vec![case]);
    let painter = ui.painter_at(rect);
    let first = next_shape(&painter);
    let marks = panels(&painter, rect, &summary);
    let (style, ground) = (theme::style(ui), ui.visuals().panel_fill);
    recolor(&painter, first, move |color| {
        let mut dots = [if style.is_dark() { on_dark(color, ground) } else { color }];
        style.finish(&mut dots);
        dots[0]
    });
    let Some(pointer) = response.hover_pos() else { return };
    let distance = |center: egui::Pos2| center.distance(pointer);
    let nearest = marks.iter().min_by(|a, b| distance(a.center).total_cmp(&distance(b.center)));
    let name = nearest.filter(|mark| distance(mark.center) < NEAR).map(|mark| mark.method.name);
    if let Some(row) = case.methods.iter().find(|row| Some(row.name.as_str()) == name) {
        response.on_hover_text_at_pointer(description(row));
    }
}

/// Returns the index of the next shape in the painter's layer.
fn next_shape(painter: &Painter) -> usize {
    painter.ctx().graphics_mut(|graphics| graphics.entry(painter.layer_id()).next_idx().0)
}

/// Changes the colours of everything that was drawn since the shape `first`.
fn recolor(
    painter: &Painter,
    first: usize,
    color: impl Fn(Color32) -> Color32 + Copy + Send + Sync + 'static,
) {
    let drawn = first..next_shape(painter);
    painter.ctx().graphics_mut(|graphics| {
        let list = graphics.entry(painter.layer_id());
        for k in drawn {
            list.mutate_shape(ShapeIdx(k), |clipped| {
                adjust_colors(&mut clipped.shape, move |own| *own = color(*own));
            });
        }
    });
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
        return marker::lightened(color);
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
