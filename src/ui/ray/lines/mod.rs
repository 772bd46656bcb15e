//! The lab of lines: the drawing, in which everything can be dragged, and beside it the numbers and
//! the substitution.

mod dragging;

use egui::{Context, Grid, Id, ScrollArea, Slider, Ui, UiBuilder, Vec2};
use pinhole_lecture::numbers::written as number;

use crate::model::lines::{LARGEST, LinesLab};
use crate::ui::widgets::number::NumberField;
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::lines::drawing::draw_question;
use crate::view::lines::{TEXT, parts, substitution, text};

/// Range of the slider of t.
const SLIDER: std::ops::RangeInclusive<f64> = -4.0..=4.0;

fn lab_id() -> Id {
    Id::unique("the lab's area")
}

/// Returns the width and height of the lab when it was last shown, in points.
pub(crate) fn size(ctx: &Context) -> Option<[f32; 2]> {
    ctx.data(|data| data.get_temp::<Vec2>(lab_id())).map(Into::into)
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
    dragging::ui(ui, left, lab, digits);
}

/// Shows both lines while the class is asked where they meet.
pub(crate) fn asked(ui: &Ui, lab: &LinesLab) {
    let mut lab = lab.clone();
    lab.set_t(0.0);
    draw_question(ui, ui.available_rect_before_wrap(), &lab);
}

fn examples(ui: &mut Ui, lab: &mut LinesLab) {
    ui.horizontal_wrapped(|ui| {
        for (name, mut next) in LinesLab::examples() {
            if ui.button(name).clicked() {
                (next.snap, next.trail.step) = (lab.snap, lab.trail.step);
                *lab = next;
            }
        }
    });
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
        (Ok(()), None) => "vertical: there is no y = m x + q".to_owned(),
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

/// Shows t as a slider that generates points, and the options of the trail.
fn time(ui: &mut Ui, lab: &mut LinesLab) {
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        text(ui, "t =");
        let mut t = lab.t;
        let mut changed = field(ui, "t", &mut t);
        ui.spacing_mut().slider_width = (ui.available_width() - 12.0).max(80.0);
        let slider = Slider::new(&mut t, SLIDER).show_value(false).step_by(0.01);
        let response = ui.add(slider.clamping(egui::SliderClamping::Never)).named("slide t along");
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
        if ui.button("Clear").on_hover_text("Remove the points left behind").clicked() {
            lab.clear_trail();
        }
        ui.checkbox(&mut lab.snap, "drag in steps of 0.5");
    });
}
