//! The drawing of the lab of lines: the plane with both lines in it.

use std::cmp::Ordering;

use egui::{Align2, Color32, FontId, Pos2, Rect, Sense, Stroke, Ui, Vec2, vec2};
use pinhole_core::DVec2;
use pinhole_lecture::lines::{ImplicitLine, Meeting, ParametricLine, Substitution};

use super::handles;
use super::sheet::{Sheet, round_step};
use super::steps::number;
use crate::lines::{Handle, LinesLab};
use crate::overlay::Style;
use crate::panels::look;
use crate::panels::words::{Font, Words, around};

/// Sizes of text, in points: coordinates, names, regions.
const SMALL: f32 = 15.0;
pub(super) const NAMES: f32 = 19.0;
const REGIONS: f32 = 23.0;

/// More points than this are not drawn.
const MOST_POINTS: usize = 400;

/// Colours of the drawing.
pub(super) struct Ink {
    pub(super) text: Color32,
    pub(super) implicit: Color32,
    pub(super) ray: Color32,
    positive: Color32,
    negative: Color32,
    faint: Color32,
}

impl Ink {
    fn of(style: Style) -> (Ink, Color32, Color32) {
        let colors = style.colors();
        let ink = Ink {
            text: colors.ink,
            implicit: colors.mark,
            ray: colors.ray,
            positive: colors.basis[2],
            negative: colors.basis[0],
            faint: colors.ink.gamma_multiply(0.22),
        };
        (ink, colors.background, colors.halo)
    }
}

/// Shows the drawing and takes what is dragged in it.
pub(super) fn ui(ui: &mut Ui, rect: Rect, lab: &mut LinesLab, digits: usize) {
    look_around(ui, rect, lab);
    let (ink, background, halo) = Ink::of(look::style(ui));
    let sheet = |lab: &LinesLab| Sheet::new(ui.painter_at(rect), rect, lab.window, halo);
    let grabbed = handles::inputs(ui, &sheet(lab), lab);
    let sheet = sheet(lab);
    sheet.painter.rect_filled(rect, 0.0, background);
    let held = |handle| grabbed.iter().any(|(held, by)| *held == handle && handles::is_held(by));
    if let Some(seen) = paint(&sheet, lab, &ink, held, digits) {
        ui.ctx().accesskit_node_builder(ui.scope_id().with("plane"), |node| node.set_value(seen));
    }
    for (handle, response) in grabbed {
        response.on_hover_text(handle.name());
    }
}

/// Draws the plane without its background and with nothing to drag.
pub(super) fn draw(ui: &Ui, rect: Rect, lab: &LinesLab, digits: usize) {
    let (ink, _, halo) = Ink::of(look::style(ui));
    let sheet = Sheet::new(ui.painter_at(rect), rect, lab.window, halo);
    paint(&sheet, lab, &ink, |_| false, digits);
}

/// Paints everything but the background; which points the ray has generated, in words.
fn paint(
    sheet: &Sheet,
    lab: &LinesLab,
    ink: &Ink,
    held: impl Fn(Handle) -> bool,
    digits: usize,
) -> Option<String> {
    let (rect, halo) = (sheet.rect, sheet.halo);
    let line = lab.line();
    let is_line = line.check().is_ok();
    if is_line {
        sheet.half_plane(&line, true, ink.positive.gamma_multiply(0.13));
        sheet.half_plane(&line, false, ink.negative.gamma_multiply(0.13));
    }
    grid(sheet, ink);
    if is_line {
        signs(sheet, &line, ink);
        implicit(sheet, &line, ink);
    }
    let mut words = Words::new(sheet.painter.clone(), halo, rect.shrink(3.0));
    handles::keep_free(sheet, lab, &mut words);
    let is_ray = lab.ray.check().is_ok();
    if is_ray {
        parametric(sheet, lab, ink);
    }
    handles::draw(sheet, lab, ink, held);
    meeting(sheet, lab, ink, &mut words, digits);
    handles::names(sheet, lab, ink, &mut words, digits);
    let seen = is_ray.then(|| {
        let seen = trail(sheet, lab, ink, &mut words);
        sides(sheet, lab, ink, &mut words);
        seen
    });
    if is_line {
        regions(sheet, &line, ink, &mut words);
    }
    coordinates(sheet, ink, &mut words);
    seen
}

/// Dragging beside all handles moves the window, the wheel zooms about the pointer.
fn look_around(ui: &Ui, rect: Rect, lab: &mut LinesLab) {
    let response = ui.interact(rect, ui.scope_id().with("plane"), Sense::drag());
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_role(egui::accesskit::Role::Image);
        node.set_label("Plane with both lines");
    });
    let per_point = 2.0 * lab.window.half_extent / f64::from(rect.size().min_elem());
    let delta = response.drag_delta();
    lab.window.center -= per_point * DVec2::new(delta.x.into(), (-delta.y).into());
    if response.contains_pointer()
        && let Some(pointer) = ui.input(|i| i.pointer.hover_pos())
    {
        let (scroll, pinch) = ui.input(|i| (i.smooth_scroll_delta(), i.zoom_delta()));
        let factor = f64::from(pinch) * f64::from(scroll.y * 0.004).exp();
        let half = (lab.window.half_extent / factor).clamp(0.05, 1e4);
        let away = pointer - rect.center();
        let away = DVec2::new(away.x.into(), (-away.y).into());
        let kept = lab.window.half_extent - half;
        lab.window.center += 2.0 * kept / f64::from(rect.size().min_elem()) * away;
        lab.window.half_extent = half;
    }
}

/// The step from one line of the grid to the next, and those in sight along x and along y.
fn grid_lines(sheet: &Sheet) -> (f64, [Vec<f64>; 2]) {
    let step = round_step(52.0 / sheet.scale);
    let (low, high) = sheet.bounds();
    let lines = |low: f64, high: f64| {
        let (first, last) = ((low / step).ceil() as i64, (high / step).floor() as i64);
        (first..=last).map(|k| k as f64 * step).collect()
    };
    (step, [lines(low.x, high.x), lines(low.y, high.y)])
}

fn grid(sheet: &Sheet, ink: &Ink) {
    let (_, [xs, ys]) = grid_lines(sheet);
    let (low, high) = sheet.bounds();
    let stroke = |at: f64| {
        if at == 0.0 { Stroke::new(2.0, ink.text) } else { Stroke::new(1.0, ink.faint) }
    };
    for x in xs {
        sheet.line(DVec2::new(x, low.y), DVec2::new(x, high.y), stroke(x), 0.0);
    }
    for y in ys {
        sheet.line(DVec2::new(low.x, y), DVec2::new(high.x, y), stroke(y), 0.0);
    }
}

/// The sign of f in the middle of every field of the grid.
fn signs(sheet: &Sheet, line: &ImplicitLine, ink: &Ink) {
    let (step, [xs, ys]) = grid_lines(sheet);
    let before = |values: &[f64]| values.first().map(|first| first - step);
    for x in before(&xs).into_iter().chain(xs.iter().copied()) {
        for y in before(&ys).into_iter().chain(ys.iter().copied()) {
            let at = DVec2::new(x, y) + 0.5 * step;
            let (sign, color) = match line.side(at) {
                Ordering::Less => ("−", ink.negative),
                Ordering::Equal => continue,
                Ordering::Greater => ("+", ink.positive),
            };
            let font = FontId::proportional(SMALL);
            let color = color.gamma_multiply(0.75);
            sheet.painter.text(sheet.place(at), Align2::CENTER_CENTER, sign, font, color);
        }
    }
}

/// The grid's numbers, along the axes or, where those are out of sight, along the edge.
fn coordinates(sheet: &Sheet, ink: &Ink, words: &mut Words) {
    let (_, [xs, ys]) = grid_lines(sheet);
    let (origin, rect) = (sheet.place(DVec2::ZERO), sheet.rect);
    let axis = Pos2::new(
        origin.x.clamp(rect.left() + 40.0, rect.right() - 4.0),
        origin.y.clamp(rect.top() + 2.0, rect.bottom() - 26.0),
    );
    let font = Font { size: SMALL, color: ink.text, bold: false };
    let name = Font { size: NAMES, ..font };
    let right = Pos2::new(rect.right() - 6.0, axis.y - 3.0);
    words.write("x", name, [(right, Align2::RIGHT_BOTTOM)]);
    words.write("y", name, [(Pos2::new(axis.x + 7.0, rect.top() + 4.0), Align2::LEFT_TOP)]);
    for x in xs.into_iter().filter(|x| *x != 0.0) {
        let at = Pos2::new(sheet.place(DVec2::new(x, 0.0)).x, axis.y + 3.0);
        words.write(&number(x, 5), font, [(at, Align2::CENTER_TOP)]);
    }
    for y in ys.into_iter().filter(|y| *y != 0.0) {
        let at = Pos2::new(axis.x - 5.0, sheet.place(DVec2::new(0.0, y)).y);
        words.write(&number(y, 5), font, [(at, Align2::RIGHT_CENTER)]);
    }
}

fn implicit(sheet: &Sheet, line: &ImplicitLine, ink: &Ink) {
    let middle = line.nearest_to(sheet.center());
    let along = sheet.reach() * line.direction().normalize_or_zero();
    if middle.distance(sheet.center()) < sheet.reach() {
        sheet.line(middle - along, middle + along, Stroke::new(3.5, ink.implicit), 0.0);
    }
}

/// On which side f is positive, and where it is 0, in words at both sides of the line.
fn regions(sheet: &Sheet, line: &ImplicitLine, ink: &Ink, words: &mut Words) {
    let direction = line.direction().normalize_or_zero();
    let normal = direction.perp();
    let middle = line.nearest_to(sheet.center());
    // Along the line, beginning well away from where it is dragged.
    let shares = [-0.72, 0.72, -0.55, 0.55, -0.9, 0.9, -0.35, 0.35, 0.0];
    let places = |points: f64| {
        let half = 0.5 * f64::from(sheet.rect.height()) / sheet.scale;
        shares.map(|share| {
            let on_line = middle + share * half * direction;
            (sheet.place(on_line + points / sheet.scale * normal), Align2::CENTER_CENTER)
        })
    };
    let font = |color| Font { size: REGIONS, color, bold: true };
    words.write("f > 0", font(ink.positive), places(46.0));
    words.write("f < 0", font(ink.negative), places(-46.0));
    let font = Font { size: NAMES, color: ink.implicit, bold: true };
    let [low, high] = [places(-26.0), places(26.0)];
    words.write("f = 0", font, high.into_iter().chain(low));
}

/// The line behind p dashed, from p on whole; the points that t has generated; d.
fn parametric(sheet: &Sheet, lab: &LinesLab, ink: &Ink) {
    let ParametricLine { p, d } = lab.ray;
    let (first, last) = seen_of(sheet, &lab.ray);
    if first < 0.0 {
        let stroke = Stroke::new(2.0, ink.ray.gamma_multiply(0.75));
        sheet.line(lab.ray.at(last.min(0.0)), lab.ray.at(first), stroke, 9.0);
    }
    if last > 0.0 {
        let stroke = Stroke::new(3.0, ink.ray);
        sheet.line(lab.ray.at(first.max(0.0)), lab.ray.at(last), stroke, 0.0);
    }
    for (_, at) in generated(sheet, lab) {
        sheet.painter.circle(sheet.place(at), 5.5, ink.ray, Stroke::new(1.5, sheet.halo));
    }
    sheet.arrow(p, p + d, Stroke::new(6.0, ink.ray));
}

/// The points of the trail that are in sight; of too many every second one, or third, and so on.
fn generated(sheet: &Sheet, lab: &LinesLab) -> impl Iterator<Item = (f64, DVec2)> {
    let (trail, (low, high)) = (lab.trail, seen_of(sheet, &lab.ray));
    let (first, last) = (trail.first.max(low), trail.last.min(high));
    let every = ((last - first) / trail.step / MOST_POINTS as f64).ceil().max(1.0);
    lab.ray.generated(every * trail.step, first, last, MOST_POINTS)
}

/// From which t to which one the line may be in sight.
fn seen_of(sheet: &Sheet, ray: &ParametricLine) -> (f64, f64) {
    let middle = ray.nearest_t(sheet.center());
    let reach = sheet.reach() / ray.d.length();
    (middle - reach, middle + reach)
}

/// To the left of d on the screen, where y grows downwards.
fn left_of(d: DVec2) -> Vec2 {
    let d = d.normalize_or_zero();
    -vec2(d.y as f32, d.x as f32)
}

/// t at the points that it has generated, as far as there is room; which ones there are, in words.
fn trail(sheet: &Sheet, lab: &LinesLab, ink: &Ink, words: &mut Words) -> String {
    let font = Font { size: SMALL, color: ink.ray, bold: false };
    let left = left_of(lab.ray.d);
    let points: Vec<(f64, DVec2)> = generated(sheet, lab).collect();
    let seen = match points.as_slice() {
        [] => "no points".to_owned(),
        [(t, _)] => format!("a point at t = {}", number(*t, 5)),
        [(from, _), .., (to, _)] => {
            format!("points from t = {} to t = {}", number(*from, 5), number(*to, 5))
        }
    };
    let whole = |t: f64| t.fract() == 0.0;
    let (first, then): (Vec<_>, Vec<_>) = points.into_iter().partition(|(t, _)| whole(*t));
    for (t, at) in first.into_iter().chain(then) {
        words.write(&number(t, 5), font, around(sheet.place(at), left, 10.0).take(1));
    }
    seen
}

/// Which part of the line is which.
fn sides(sheet: &Sheet, lab: &LinesLab, ink: &Ink, words: &mut Words) {
    let direction = lab.ray.d.normalize_or_zero();
    let font = Font { size: SMALL + 2.0, color: ink.ray, bold: false };
    for (text, sign) in [("t < 0", -1.0), ("t > 0", 1.0)] {
        let places = [120.0, 170.0, 220.0, 90.0].into_iter().flat_map(|points| {
            let at = lab.ray.p + sign * points / sheet.scale * direction;
            around(sheet.place(at), left_of(-lab.ray.d), 10.0).take(3)
        });
        words.write(text, font, places);
    }
}

fn meeting(sheet: &Sheet, lab: &LinesLab, ink: &Ink, words: &mut Words, digits: usize) {
    let Ok(Substitution { meeting: Meeting::At(crossing), .. }) =
        Substitution::new(lab.line(), lab.ray)
    else {
        return;
    };
    let at = sheet.place(crossing.point);
    if !sheet.rect.contains(at) {
        return;
    }
    handles::cross(sheet, at, ink);
    words.keep_free(Rect::from_center_size(at, Vec2::splat(18.0)));
    let said = if crossing.ray_hits { "hit" } else { "ray missed" };
    let text = format!("{said}: t = {}", number(crossing.t, digits));
    let font = Font { size: NAMES, color: ink.text, bold: true };
    words.write(&text, font, handles::places_at_crossing(at));
}
