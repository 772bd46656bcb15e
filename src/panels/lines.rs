//! The lab of lines: the drawing, in which everything can be dragged, and beside it the numbers and
//! the substitution.

mod drawing;
mod handles;
mod sheet;
mod steps;

use egui::{Context, Grid, Id, Rect, RichText, ScrollArea, Slider, Ui, UiBuilder, Vec2, pos2};
use pinhole_lecture::lines::{LineError, Substitution};

pub(super) use self::sheet::round_step;
pub(super) use self::steps::number;
use self::steps::{steps, verdict};
use super::notation;
use super::number::{NumberField, error_color};
use crate::letters::told;
use crate::lines::{LARGEST, LinesLab};

/// Size of the text, in points: for the back row.
const TEXT: f32 = 16.5;
/// The numbers beside the drawing are at least so wide, in points, and at most so much of the whole.
const NUMBERS: (f32, f32) = (400.0, 0.46);
/// The slider of t goes from here to there.
const SLIDER: std::ops::RangeInclusive<f64> = -4.0..=4.0;

fn lab_id() -> Id {
    Id::unique("the lab's area")
}

/// Width and height of the lab when it was last shown, in points.
pub(crate) fn size(ctx: &Context) -> Option<[f32; 2]> {
    ctx.data(|data| data.get_temp::<Vec2>(lab_id())).map(Into::into)
}

/// Draws the lab with nothing to drag and on nothing: the plane with both lines in it, and one line
/// put into the other.
pub(crate) fn draw(ui: &mut Ui, area: Rect, lab: &LinesLab, digits: usize) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    let (left, right) = parts(area);
    drawing::draw(ui, left, lab, digits);
    let right = right.shrink2(Vec2::new(2.0, 14.0));
    ui.scope_builder(UiBuilder::new().max_rect(right), |ui| substitution(ui, lab, digits));
}

/// The plane, and what is beside it.
fn parts(area: Rect) -> (Rect, Rect) {
    let middle = area.right() - NUMBERS.0.min(NUMBERS.1 * area.width());
    let left = Rect::from_min_max(area.min, pos2(middle - 10.0, area.bottom()));
    (left, Rect::from_min_max(pos2(middle, area.top()), area.max))
}

/// Shows the lab.
pub(crate) fn ui(ui: &mut Ui, lab: &mut LinesLab, digits: usize) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    let area = ui.available_rect_before_wrap();
    let (left, right) = parts(area);
    ui.scope_builder(UiBuilder::new().max_rect(right), |ui| {
        ScrollArea::vertical().id_salt("lines words scrolled").auto_shrink(false).show(ui, |ui| {
            examples(ui, lab);
            fields(ui, lab);
            time(ui, lab);
            ui.separator();
            substitution(ui, lab, digits);
        });
    });
    ui.data_mut(|data| data.insert_temp(lab_id(), area.size()));
    drawing::ui(ui, left, lab, digits);
}

fn examples(ui: &mut Ui, lab: &mut LinesLab) {
    ui.horizontal_wrapped(|ui| {
        for (name, example) in LinesLab::EXAMPLES {
            if ui.button(name).clicked() {
                let mut next = example.lab();
                (next.snap, next.trail.step) = (lab.snap, lab.trail.step);
                *lab = next;
            }
        }
    });
}

/// A line of text and fields, the text as a formula.
fn text(ui: &mut Ui, text: &str) {
    notation::label(ui, text, TEXT + 1.0, ui.visuals().text_color());
}

fn field(ui: &mut Ui, name: &str, value: &mut f64) -> bool {
    NumberField::new(name, value).width(70.0).within(-LARGEST..=LARGEST).show(ui).changed()
}

fn fields(ui: &mut Ui, lab: &mut LinesLab) {
    let mut line = lab.line();
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 5.0;
        let mut changed = false;
        for (name, value, behind) in
            [("a", &mut line.a, "x +"), ("b", &mut line.b, "y +"), ("c", &mut line.c, "= 0")]
        {
            changed |= field(ui, name, value);
            text(ui, behind);
        }
        if changed {
            lab.set_line(line);
        }
    });
    let form = match (line.check(), line.slope_form()) {
        (Err(_), _) => "no line".to_owned(),
        (Ok(()), None) => "upright: no y = m x + q".to_owned(),
        (Ok(()), Some((m, q))) => {
            let sign = if q < 0.0 { '−' } else { '+' };
            format!("y = {} x {sign} {}", number(m, 5), number(q.abs(), 5))
        }
    };
    text(ui, &format!("the same as  {form}"));
    ui.add_space(4.0);
    Grid::new("parametric").num_columns(3).spacing([6.0, 4.0]).show(ui, |ui| {
        let ray = &mut lab.ray;
        for (name, vector) in [("p", &mut ray.p), ("d", &mut ray.d)] {
            text(ui, &format!("{name} ="));
            field(ui, &format!("{name} x"), &mut vector.x);
            field(ui, &format!("{name} y"), &mut vector.y);
            ui.end_row();
        }
    });
}

/// t as a slider that generates points, and what is left behind.
fn time(ui: &mut Ui, lab: &mut LinesLab) {
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        text(ui, "t =");
        let mut t = lab.t;
        let mut changed = field(ui, "t", &mut t);
        ui.spacing_mut().slider_width = (ui.available_width() - 12.0).max(80.0);
        let slider = Slider::new(&mut t, SLIDER).show_value(false).step_by(0.01);
        let response = ui.add(slider.clamping(egui::SliderClamping::Never));
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_label("slide t along"));
        changed |= response.changed();
        if changed {
            lab.set_t(t);
        }
    });
    ui.horizontal_wrapped(|ui| {
        ui.label("points at steps of");
        for step in [1.0, 0.5, 0.25, 0.1] {
            ui.selectable_value(&mut lab.trail.step, step, number(step, 5));
        }
        if ui.button("Clear").on_hover_text("Take away the points left behind").clicked() {
            lab.clear_trail();
        }
        ui.checkbox(&mut lab.snap, "drag by halves");
    });
}

fn substitution(ui: &mut Ui, lab: &LinesLab, digits: usize) {
    let substitution = match Substitution::new(lab.line(), lab.ray) {
        Ok(substitution) => substitution,
        Err(error) => return no_line(ui, &error),
    };
    for step in steps(&substitution, digits) {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 0.0;
            ui.weak(format!("{}:  ", step.what));
            text(ui, &step.text);
        });
    }
    ui.add_space(6.0);
    let verdict = verdict(&substitution, digits);
    notation::label(ui, &verdict, TEXT + 3.0, ui.visuals().strong_text_color());
    ui.add_space(4.0);
    let (f, sign) = substitution.f(lab.t);
    let compared = match sign {
        std::cmp::Ordering::Less => "< 0",
        std::cmp::Ordering::Equal => ": on the line",
        std::cmp::Ordering::Greater => "> 0",
    };
    let (t, f) = (number(lab.t, digits), number(f, digits));
    text(ui, &format!("at t = {t}:  f = {f} {compared}"));
}

fn no_line(ui: &mut Ui, error: &LineError) {
    let text = RichText::new(told(error)).size(TEXT + 2.0).strong();
    ui.label(text.color(error_color(ui)));
}
