//! The lab of lines, a page that intersects two lines in the plane: a drawing in which the lines can be
//! dragged, with their numbers and the substitution of one line into the other on its right.

use egui::accesskit::Role;
use egui::{Context, CursorIcon, Grid, Id, Rect, Response, ScrollArea, Sense, Slider, Ui, Vec2};
use pinhole_core::DVec2;
use pinhole_figure::chart;
use pinhole_lecture::Rounding;
use pinhole_lecture::numbers::{sum, written as number};

use crate::features::lines::state::{LARGEST, LineHandle, LinesLab};
use crate::features::lines::view::{GRASP, NUMBERS, PlaneView, TEXT, is_whole, substitution, text};
use crate::ui::PageContext;
use crate::ui::scene::views;
use crate::ui::widgets::{NumberField, ResponseExt as _, arrows, inside, keep_arrows};

/// Range of the slider of t.
const SLIDER: std::ops::RangeInclusive<f64> = -4.0..=4.0;

fn lab_id() -> Id {
    Id::unique("the lab's area")
}

/// Returns the width and height at which the lab of lines was last shown, in points.
pub(crate) fn size(ctx: &Context) -> Option<[f32; 2]> {
    ctx.data(|data| data.get_temp::<Vec2>(lab_id())).map(Into::into)
}

/// Shows the lab.
pub(crate) fn ui(ui: &mut Ui, context: &mut PageContext<'_>) {
    let (lab, digits) = (&mut context.session.shown.lines, context.style.digits);
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    let area = ui.available_rect_before_wrap();
    let (left, right) = chart::beside(area, NUMBERS);
    inside(ui, right, |ui| {
        ScrollArea::vertical().id_salt("lines words scrolled").auto_shrink(false).show(ui, |ui| {
            examples(ui, lab);
            fields(ui, lab);
            time(ui, lab);
            ui.separator();
            substitution(ui, lab, digits);
        });
    });
    ui.data_mut(|data| data.insert_temp(lab_id(), area.size()));
    plane(ui, left, lab, (digits, true));
}

/// Shows only the drawing of the lab, in which the lines can be dragged.
pub(crate) fn figure(ui: &mut Ui, context: &mut PageContext<'_>) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    let area = ui.available_rect_before_wrap();
    let shown = &mut context.session.shown;
    // Where the lines meet comes with the last line of the card.
    let shows_meeting = is_whole(&shown.lines, shown.revealed_lines);
    plane(ui, area, &mut shown.lines, (context.style.digits, shows_meeting));
}

fn examples(ui: &mut Ui, lab: &mut LinesLab) {
    ui.horizontal_wrapped(|ui| {
        for (name, mut next) in LinesLab::examples() {
            if ui.button(name).clicked() {
                next.trail.step = lab.trail.step;
                *lab = next;
            }
        }
    });
}

fn field(ui: &mut Ui, name: &str, value: &mut f64) -> bool {
    let field = NumberField::new(name, value);
    NumberField { width: 70.0, range: -LARGEST..=LARGEST, ..field }.show(ui).changed()
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
            let is = Rounding::Significant(5).relation(&[m, q]);
            format!("y {is} {}", sum([(m, " x"), (q, "")], |x| number(x, 5)))
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

/// Shows a field and a slider for t, and the options for the trail of points that p + t d leaves.
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
            (lab.trail.first, lab.trail.last) = (lab.t, lab.t);
        }
    });
}

/// Shows the drawing, with where the lines meet or without it, and handles drags in it.
fn plane(ui: &mut Ui, rect: Rect, lab: &mut LinesLab, (digits, shows_meeting): (usize, bool)) {
    look_around(ui, rect, lab);
    let before = PlaneView::new(ui, rect, lab.window);
    let inputs = LineHandle::ALL.into_iter();
    let inputs = inputs.filter_map(|handle| Some((handle, input(ui, &before, lab, handle)?)));
    let grabbed: Vec<(LineHandle, Response)> = inputs.collect();
    let mut plane = PlaneView::new(ui, rect, lab.window);
    plane.shows_meeting = shows_meeting;
    plane.background();
    let is_held = |handle| grabbed.iter().any(|(held, by)| *held == handle && is_held(by));
    if let Some(text) = plane.paint(lab, is_held, digits) {
        views::speak(ui, "plane", &text);
    }
    for (handle, response) in grabbed {
        response.on_hover_text(handle.name());
    }
}

/// Pans the drawing when a drag does not start on a handle, and zooms about the pointer with the wheel.
fn look_around(ui: &Ui, rect: Rect, lab: &mut LinesLab) {
    let response = ui.interact(rect, ui.scope_id().with("plane"), Sense::drag());
    let response = response.with_role(Role::Image).named("Plane with both lines");
    let per_point = 2.0 * lab.window.half_extent / f64::from(rect.size().min_elem());
    let delta = response.drag_delta();
    lab.window.center -= per_point * DVec2::new(delta.x.into(), (-delta.y).into());
    if response.contains_pointer()
        && let Some(pointer) = ui.input(|i| i.pointer.hover_pos())
    {
        let half = (lab.window.half_extent / views::wheel_zoom(ui)).clamp(0.05, 1e4);
        let away = pointer - rect.center();
        let away = DVec2::new(away.x.into(), (-away.y).into());
        let kept = lab.window.half_extent - half;
        lab.window.center += 2.0 * kept / f64::from(rect.size().min_elem()) * away;
        lab.window.half_extent = half;
    }
}

/// Handles mouse and keys on a handle of the drawing. Returns the response of the handle's area, if the
/// handle is visible.
fn input(ui: &Ui, plane: &PlaneView, lab: &mut LinesLab, handle: LineHandle) -> Option<Response> {
    let at = plane.in_sight(lab, handle)?;
    let id = ui.scope_id().with(handle.name());
    let around = Rect::from_center_size(at, Vec2::splat(2.0 * GRASP));
    let response = ui.interact(around, id, Sense::click_and_drag());
    let response = response.on_hover_cursor(CursorIcon::Grab);
    keep_arrows(&response, true, true);
    // The number of rounding steps per unit: the next power of ten above the number of pixels per unit.
    let dots = plane.unit() * f64::from(ui.ctx().pixels_per_point());
    let fineness = 10_f64.powf(dots.log10().ceil());
    if response.drag_started() {
        response.request_focus();
        // A handle that was grabbed off-centre keeps its offset from the pointer.
        let pressed = ui.input(|i| i.pointer.press_origin()).unwrap_or(at);
        ui.data_mut(|data| data.insert_temp(id, at - pressed));
    }
    if response.dragged()
        && let Some(pointer) = response.interact_pointer_pos()
    {
        let offset: Vec2 = ui.data(|data| data.get_temp(id)).unwrap_or_default();
        lab.drag(handle, plane.to_plane(pointer + offset), fineness);
    }
    if response.has_focus() {
        let steps = arrows(ui.ctx());
        if steps != Vec2::ZERO {
            lab.nudge(handle, DVec2::new(steps.x.into(), (-steps.y).into()), fineness);
        }
    }
    let position = lab.position_of(handle)?;
    let value = format!("({}, {})", number(position.x, 5), number(position.y, 5));
    Some(response.with_role(Role::Slider).named(handle.name()).described(value))
}

/// Returns true if the user drags a handle, or if the pointer or the keyboard focus is on it.
fn is_held(response: &Response) -> bool {
    response.hovered() || response.dragged() || response.has_focus()
}
