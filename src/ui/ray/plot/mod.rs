//! The plot of f(p + t d) against t, and the point that walks along the ray: below both views, with
//! every object on one axis of t, and beside it a text for each curve.

mod brief;
mod drawing;

use egui::{
    Context, Id, Label, Rect, RichText, ScrollArea, Sense, Slider, Ui, UiBuilder, pos2, vec2,
};
use pinhole_lecture::numbers::written as number;

use crate::model::concept::{Concept, HoverSource, Hovered};
use crate::model::inspection::Inspection;
use crate::ui::widgets::Spoken as _;
use crate::ui::widgets::fault_text;
use crate::ui::widgets::number::NumberField;
use crate::view::derive::Derived;
use crate::view::plot::{Curve, Plot};
use crate::view::typesetting::{notation, theme};

/// Size of the text, in points: legible from the back row.
const TEXT: f32 = 15.5;
/// Maximum width of the text beside the plot, in points and as a share of the whole.
const WORDS: (f32, f32) = (430.0, 0.44);
/// Minimum width of the slider of t, in points.
const SLIDER: f32 = 72.0;

/// Shows the plot and the text beside it.
pub(crate) fn ui(
    ui: &mut Ui,
    ray_point_t: &mut Option<f64>,
    compressed: &mut bool,
    derived: &Derived,
    digits: usize,
) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    if let Some(fault) = derived.fault {
        ui.label(fault_text(ui, fault).strong());
    }
    let (Some(plot), Some(inspection)) = (&derived.plot, &derived.inspection) else { return };
    let first = inspection.first_hit().map(|hit| (hit.object, hit.t));
    let area = ui.available_rect_before_wrap();
    let middle = area.right() - WORDS.0.min(WORDS.1 * area.width());
    let left = Rect::from_min_max(area.min, pos2(middle - 10.0, area.bottom() - 4.0));
    let right = Rect::from_min_max(pos2(middle, area.top()), area.max);
    drawing::ui(ui, left, plot, first, ray_point_t);
    ui.scope_builder(UiBuilder::new().max_rect(right), |ui| {
        if theme::installed(ui.ctx()).presenting {
            return brief::ui(ui, plot, inspection, first, digits);
        }
        ScrollArea::vertical().id_salt("plot words scrolled").auto_shrink(false).show(ui, |ui| {
            walk(ui, ray_point_t, plot.range.clone(), first.map_or(1.0, |(_, t)| t));
            if let Some((t, values)) = &plot.ray_point_t {
                text(ui, &point(inspection, *t, digits));
                ui.label(RichText::new(objects_at(plot, values)).strong());
            }
            ui.separator();
            for k in 0..plot.curves.len() {
                said(ui, plot, k, first, digits);
            }
            let text = "Compress values beyond ±1 unit";
            let hint = "The axis is then logarithmic there: lines and parabolas are bent";
            ui.checkbox(compressed, text).on_hover_text(hint);
            if plot.left_out > 0 {
                ui.label(left_out(plot.left_out));
            }
            if plot.curves.is_empty() && plot.left_out == 0 {
                ui.label("There is no object.");
            }
        });
    });
}

/// Returns the text about objects without a curve.
fn left_out(count: usize) -> String {
    match count {
        1 => "1 more object is left out".to_owned(),
        n => format!("{n} more objects are left out"),
    }
}

fn text(ui: &mut Ui, text: &str) {
    notation::label(ui, text, TEXT, ui.visuals().text_color());
}

/// Shows the t of the walking point, as a number and as a slider.
fn walk(
    ui: &mut Ui,
    ray_point_t: &mut Option<f64>,
    range: std::ops::RangeInclusive<f64>,
    first_hit: f64,
) {
    ui.horizontal(|ui| {
        let mut walks = ray_point_t.is_some();
        if ui.checkbox(&mut walks, "Walk along the ray").changed() {
            *ray_point_t = walks.then_some(0.5 * first_hit);
        }
        let Some(t) = ray_point_t else { return };
        text(ui, "t =");
        NumberField::new("walked t", t).within(-1e9..=1e9).show(ui);
        // Without room for a slider, the line in the plot can be dragged.
        if ui.available_width() < SLIDER {
            return;
        }
        ui.spacing_mut().slider_width = ui.available_width() - 12.0;
        let slider = Slider::new(t, range).show_value(false);
        ui.add(slider.clamping(egui::SliderClamping::Never)).named("walk to t");
    });
}

/// Returns the coordinates of the point at t, as a formula.
fn point(inspection: &Inspection, t: f64, digits: usize) -> String {
    let [x, y, z] = inspection.ray.at(t).to_array().map(|x| number(x, digits));
    format!("p + t d = ({x}, {y}, {z})")
}

/// Returns which objects contain the point, and on which ones it is, by the values of f there.
fn objects_at(plot: &Plot, values: &[f64]) -> String {
    let titles = |belongs: &dyn Fn(&Curve, f64) -> bool| -> Vec<&str> {
        let curves = plot.curves.iter().zip(values).filter(|(curve, f)| belongs(curve, **f));
        curves.map(|(curve, _)| curve.named.title.as_str()).collect()
    };
    let inside = titles(&|curve, f| curve.is_inside(f)).join(", ");
    let on = titles(&|_, f| f == 0.0).join(", ");
    match (inside.is_empty(), on.is_empty()) {
        (true, true) => "outside all objects".to_owned(),
        (false, true) => format!("inside {inside}"),
        (true, false) => format!("on {on}"),
        (false, false) => format!("inside {inside}; on {on}"),
    }
}

/// Returns the concept that the mouse is on in the text beside the last frame's plot.
pub(crate) fn hovered(ctx: &Context, derived: &Derived) -> Option<Hovered> {
    let curves = &derived.plot.as_ref()?.curves;
    let is_hovered =
        |object: u32| ctx.read_response(said_id(object)).is_some_and(|said| said.hovered());
    let object = curves.iter().map(|curve| curve.named.object).find(|k| is_hovered(*k))?;
    Some(Hovered { concept: Concept::Object(object), by: HoverSource::Derivation })
}

fn said_id(object: u32) -> Id {
    Id::unique(("said of a curve", object))
}

/// Shows a curve's line sample, title and text, and f at the walking point.
fn said(ui: &mut Ui, plot: &Plot, k: usize, first: Option<(u32, f64)>, digits: usize) {
    let curve: &Curve = &plot.curves[k];
    let object = curve.named.object;
    let title = ui.horizontal_wrapped(|ui| {
        let (sample, _) = ui.allocate_exact_size(vec2(34.0, 14.0), Sense::hover());
        drawing::sample(ui, sample, curve);
        ui.label(RichText::new(&curve.named.title).strong());
        text(ui, &curve.unit_words(digits));
        if first.is_some_and(|(hit, _)| hit == object) {
            ui.add(Label::new(RichText::new("the first hit").strong()).extend());
        }
    });
    let words = ui.indent(("said", object), |ui| {
        text(ui, &curve.description(digits));
        if let Some((t, values)) = &plot.ray_point_t {
            text(
                ui,
                &format!("at t = {}: {}", number(*t, digits), curve.reading(values[k], digits)),
            );
        }
    });
    ui.interact(title.response.rect | words.response.rect, said_id(object), Sense::hover());
}
