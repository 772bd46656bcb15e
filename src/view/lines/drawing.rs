//! The drawing of the lab of lines: the plane with both lines in it.

use std::cmp::Ordering;

use egui::{Align2, Color32, FontId, Pos2, Rect, Stroke, Ui, Vec2, vec2};
use pinhole_core::DVec2;
use pinhole_lecture::lines::{ImplicitLine, Meeting, ParametricLine, Substitution};

use super::handles;
use crate::model::lines::{Handle, LinesLab};
use crate::view::lines::canvas::{Canvas, round_step};
use crate::view::lines::steps::number;
use crate::view::overlay::Style;
use crate::view::typesetting::label_layout::{Font, LabelLayout, around};
use crate::view::typesetting::theme;

/// Text sizes in points: coordinates, names, regions.
const SMALL: f32 = 15.0;
pub(crate) const NAMES: f32 = 19.0;
const REGIONS: f32 = 23.0;

/// Maximum number of points drawn.
const MOST_POINTS: usize = 400;

/// The colours of the drawing.
pub(crate) struct Ink {
    pub(crate) text: Color32,
    pub(crate) implicit: Color32,
    pub(crate) ray: Color32,
    positive: Color32,
    negative: Color32,
    faint: Color32,
}

impl Ink {
    pub(crate) fn from_style(style: Style) -> (Ink, Color32, Color32) {
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

/// Draws the plane without its background and with nothing to drag.
pub(crate) fn draw(ui: &Ui, rect: Rect, lab: &LinesLab, digits: usize) {
    let (ink, _, halo) = Ink::from_style(theme::style(ui));
    let canvas = Canvas::new(ui.painter_at(rect), rect, lab.window, halo);
    paint(&canvas, lab, &ink, |_| false, digits);
}

/// Draws both lines and nothing that tells where they meet.
pub(crate) fn draw_question(ui: &Ui, rect: Rect, lab: &LinesLab) {
    let (ink, background, halo) = Ink::from_style(theme::style(ui));
    let canvas = Canvas::new(ui.painter_at(rect), rect, lab.window, halo);
    canvas.painter.rect_filled(rect, 0.0, background);
    let mut labels = LabelLayout::new(canvas.painter.clone(), halo, rect.shrink(3.0));
    grid(&canvas, &ink);
    implicit(&canvas, &lab.line(), &ink);
    parametric(&canvas, lab, &ink);
    coordinates(&canvas, &ink, &mut labels);
}

/// Draws the plane as a question shows it: the line, p, and what was typed, as rings; how both lines
/// meet only once that `may_be_seen`.
pub(crate) fn draw_exercise(
    ui: &Ui,
    rect: Rect,
    lab: &LinesLab,
    typed: &[(String, DVec2)],
    (may_be_seen, digits): (bool, usize),
) {
    let (ink, background, halo) = Ink::from_style(theme::style(ui));
    let canvas = Canvas::new(ui.painter_at(rect), rect, lab.window, halo);
    canvas.painter.rect_filled(rect, 0.0, background);
    let mut labels = LabelLayout::new(canvas.painter.clone(), halo, rect.shrink(3.0));
    if may_be_seen {
        paint(&canvas, lab, &ink, |_| false, digits);
    } else {
        grid(&canvas, &ink);
        implicit(&canvas, &lab.line(), &ink);
        let p = canvas.to_screen(lab.ray.p);
        canvas.painter.circle(p, 8.0, ink.ray, Stroke::new(2.0, halo));
        let font = Font { size: NAMES + 1.0, color: ink.ray, bold: true };
        labels.write("p", font, around(p, vec2(-1.0, 1.0), 13.0));
    }
    for (name, at) in typed {
        let at = canvas.to_screen(*at);
        canvas.painter.circle_stroke(at, 9.0, Stroke::new(3.0, ink.ray));
        let font = Font { size: NAMES, color: ink.ray, bold: true };
        labels.write(name, font, around(at, vec2(1.0, -1.0), 15.0));
    }
    if !may_be_seen {
        regions(&canvas, &lab.line(), &ink, &mut labels);
        coordinates(&canvas, &ink, &mut labels);
    }
}

/// Paints everything but the background. Returns a description of the points that the ray has
/// generated.
pub(crate) fn paint(
    canvas: &Canvas,
    lab: &LinesLab,
    ink: &Ink,
    held: impl Fn(Handle) -> bool,
    digits: usize,
) -> Option<String> {
    let (rect, halo) = (canvas.rect, canvas.halo);
    let line = lab.line();
    let is_line = line.check().is_ok();
    if is_line {
        canvas.half_plane(&line, true, ink.positive.gamma_multiply(0.13));
        canvas.half_plane(&line, false, ink.negative.gamma_multiply(0.13));
    }
    grid(canvas, ink);
    if is_line {
        signs(canvas, &line, ink);
        implicit(canvas, &line, ink);
    }
    let mut labels = LabelLayout::new(canvas.painter.clone(), halo, rect.shrink(3.0));
    handles::keep_free(canvas, lab, &mut labels);
    let is_ray = lab.ray.check().is_ok();
    if is_ray {
        parametric(canvas, lab, ink);
    }
    handles::draw(canvas, lab, ink, held);
    meeting(canvas, lab, ink, &mut labels, digits);
    handles::names(canvas, lab, ink, &mut labels, digits);
    let seen = is_ray.then(|| {
        let seen = trail(canvas, lab, ink, &mut labels);
        sides(canvas, lab, ink, &mut labels);
        seen
    });
    if is_line {
        regions(canvas, &line, ink, &mut labels);
    }
    coordinates(canvas, ink, &mut labels);
    seen
}

/// Returns the step between grid lines, and the visible ones along x and along y.
fn grid_lines(canvas: &Canvas) -> (f64, [Vec<f64>; 2]) {
    let step = round_step(52.0 / canvas.scale);
    let (low, high) = canvas.bounds();
    let lines = |low: f64, high: f64| {
        let (first, last) = ((low / step).ceil() as i64, (high / step).floor() as i64);
        (first..=last).map(|k| k as f64 * step).collect()
    };
    (step, [lines(low.x, high.x), lines(low.y, high.y)])
}

fn grid(canvas: &Canvas, ink: &Ink) {
    let (_, [xs, ys]) = grid_lines(canvas);
    let (low, high) = canvas.bounds();
    let stroke = |at: f64| {
        if at == 0.0 { Stroke::new(2.0, ink.text) } else { Stroke::new(1.0, ink.faint) }
    };
    for x in xs {
        canvas.line(DVec2::new(x, low.y), DVec2::new(x, high.y), stroke(x), 0.0);
    }
    for y in ys {
        canvas.line(DVec2::new(low.x, y), DVec2::new(high.x, y), stroke(y), 0.0);
    }
}

/// Draws the sign of f in the middle of every cell of the grid.
fn signs(canvas: &Canvas, line: &ImplicitLine, ink: &Ink) {
    let (step, [xs, ys]) = grid_lines(canvas);
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
            canvas.painter.text(canvas.to_screen(at), Align2::CENTER_CENTER, sign, font, color);
        }
    }
}

/// Draws the grid's numbers along the axes, or along the edge where an axis is out of sight.
fn coordinates(canvas: &Canvas, ink: &Ink, labels: &mut LabelLayout) {
    let (_, [xs, ys]) = grid_lines(canvas);
    let (origin, rect) = (canvas.to_screen(DVec2::ZERO), canvas.rect);
    let axis = Pos2::new(
        origin.x.clamp(rect.left() + 40.0, rect.right() - 4.0),
        origin.y.clamp(rect.top() + 2.0, rect.bottom() - 26.0),
    );
    let font = Font { size: SMALL, color: ink.text, bold: false };
    let name = Font { size: NAMES, ..font };
    let right = Pos2::new(rect.right() - 6.0, axis.y - 3.0);
    labels.write("x", name, [(right, Align2::RIGHT_BOTTOM)]);
    labels.write("y", name, [(Pos2::new(axis.x + 7.0, rect.top() + 4.0), Align2::LEFT_TOP)]);
    for x in xs.into_iter().filter(|x| *x != 0.0) {
        let at = Pos2::new(canvas.to_screen(DVec2::new(x, 0.0)).x, axis.y + 3.0);
        labels.write(&number(x, 5), font, [(at, Align2::CENTER_TOP)]);
    }
    for y in ys.into_iter().filter(|y| *y != 0.0) {
        let at = Pos2::new(axis.x - 5.0, canvas.to_screen(DVec2::new(0.0, y)).y);
        labels.write(&number(y, 5), font, [(at, Align2::RIGHT_CENTER)]);
    }
}

fn implicit(canvas: &Canvas, line: &ImplicitLine, ink: &Ink) {
    let middle = line.nearest_to(canvas.center());
    let along = canvas.reach() * line.direction().normalize_or_zero();
    if middle.distance(canvas.center()) < canvas.reach() {
        canvas.line(middle - along, middle + along, Stroke::new(3.5, ink.implicit), 0.0);
    }
}

/// Writes on both sides of the line where f is positive, negative and 0.
fn regions(canvas: &Canvas, line: &ImplicitLine, ink: &Ink, labels: &mut LabelLayout) {
    let direction = line.direction().normalize_or_zero();
    let normal = direction.perp();
    let middle = line.nearest_to(canvas.center());
    // Positions along the line, beginning well away from its handles.
    let shares = [-0.72, 0.72, -0.55, 0.55, -0.9, 0.9, -0.35, 0.35, 0.0];
    let anchors = |points: f64| {
        let half = 0.5 * f64::from(canvas.rect.height()) / canvas.scale;
        shares.map(|share| {
            let on_line = middle + share * half * direction;
            (canvas.to_screen(on_line + points / canvas.scale * normal), Align2::CENTER_CENTER)
        })
    };
    let font = |color| Font { size: REGIONS, color, bold: true };
    labels.write("f > 0", font(ink.positive), anchors(46.0));
    labels.write("f < 0", font(ink.negative), anchors(-46.0));
    let font = Font { size: NAMES, color: ink.implicit, bold: true };
    let [low, high] = [anchors(-26.0), anchors(26.0)];
    labels.write("f = 0", font, high.into_iter().chain(low));
}

/// Draws the line: dashed behind p, solid from p on; then the points that t has generated, and d.
fn parametric(canvas: &Canvas, lab: &LinesLab, ink: &Ink) {
    let ParametricLine { p, d } = lab.ray;
    let (first, last) = seen_of(canvas, &lab.ray);
    if first < 0.0 {
        let stroke = Stroke::new(2.0, ink.ray.gamma_multiply(0.75));
        canvas.line(lab.ray.at(last.min(0.0)), lab.ray.at(first), stroke, 9.0);
    }
    if last > 0.0 {
        let stroke = Stroke::new(3.0, ink.ray);
        canvas.line(lab.ray.at(first.max(0.0)), lab.ray.at(last), stroke, 0.0);
    }
    for (_, at) in generated(canvas, lab) {
        canvas.painter.circle(canvas.to_screen(at), 5.5, ink.ray, Stroke::new(1.5, canvas.halo));
    }
    canvas.arrow(p, p + d, Stroke::new(6.0, ink.ray));
}

/// Returns the visible points of the trail; of too many only every second one, or third, and so on.
fn generated(canvas: &Canvas, lab: &LinesLab) -> impl Iterator<Item = (f64, DVec2)> {
    let (trail, (low, high)) = (lab.trail, seen_of(canvas, &lab.ray));
    let (first, last) = (trail.first.max(low), trail.last.min(high));
    let every = ((last - first) / trail.step / MOST_POINTS as f64).ceil().max(1.0);
    lab.ray.generated(every * trail.step, first, last, MOST_POINTS)
}

/// Returns the range of t in which the line may be visible.
fn seen_of(canvas: &Canvas, ray: &ParametricLine) -> (f64, f64) {
    let middle = ray.nearest_t(canvas.center());
    let reach = canvas.reach() / ray.d.length();
    (middle - reach, middle + reach)
}

/// Returns the direction to the left of d on the screen, where y grows downwards.
fn left_of(d: DVec2) -> Vec2 {
    let d = d.normalize_or_zero();
    -vec2(d.y as f32, d.x as f32)
}

/// Writes t at the generated points, as far as there is room. Returns a description of these
/// points.
fn trail(canvas: &Canvas, lab: &LinesLab, ink: &Ink, labels: &mut LabelLayout) -> String {
    let font = Font { size: SMALL, color: ink.ray, bold: false };
    let left = left_of(lab.ray.d);
    let points: Vec<(f64, DVec2)> = generated(canvas, lab).collect();
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
        labels.write(&number(t, 5), font, around(canvas.to_screen(at), left, 10.0).take(1));
    }
    seen
}

/// Labels the parts of the line with t < 0 and t > 0.
fn sides(canvas: &Canvas, lab: &LinesLab, ink: &Ink, labels: &mut LabelLayout) {
    let direction = lab.ray.d.normalize_or_zero();
    let font = Font { size: SMALL + 2.0, color: ink.ray, bold: false };
    for (text, sign) in [("t < 0", -1.0), ("t > 0", 1.0)] {
        let anchors = [120.0, 170.0, 220.0, 90.0].into_iter().flat_map(|points| {
            let at = lab.ray.p + sign * points / canvas.scale * direction;
            around(canvas.to_screen(at), left_of(-lab.ray.d), 10.0).take(3)
        });
        labels.write(text, font, anchors);
    }
}

fn meeting(canvas: &Canvas, lab: &LinesLab, ink: &Ink, labels: &mut LabelLayout, digits: usize) {
    let Ok(Substitution { meeting: Meeting::At(crossing), .. }) =
        Substitution::new(lab.line(), lab.ray)
    else {
        return;
    };
    let at = canvas.to_screen(crossing.point);
    if !canvas.rect.contains(at) {
        return;
    }
    handles::cross(canvas, at, ink);
    labels.keep_free(Rect::from_center_size(at, Vec2::splat(18.0)));
    let said = if crossing.ray_hits { "hit" } else { "ray missed" };
    let text = format!("{said}: t = {}", number(crossing.t, digits));
    let font = Font { size: NAMES, color: ink.text, bold: true };
    labels.write(&text, font, handles::anchors_at_crossing(at));
}
