//! The drawing of f(p + t d) against t.

use std::ops::RangeInclusive;

use egui::accesskit::Role;
use egui::{
    Align2, Color32, FontId, Key, Painter, Pos2, Rect, Sense, Shape, Stroke, Ui, Vec2, pos2, vec2,
};

use super::captions::Captions;
use crate::model::session::Heights;
use crate::ui::ray::lines::{number, round_step};
use crate::ui::widgets::spoken::{Spoken as _, keep_arrows};
use crate::view::plot::{Curve, Plot};
use crate::view::typesetting::label_layout::{Font, LabelLayout};
use crate::view::typesetting::notation::formula;
use crate::view::typesetting::theme;

/// Size of the text, in points.
pub(super) const TEXT: f32 = 15.0;

/// Value of f, in units, at the upper edge: for even and for compressed heights.
const TOP: (f64, f64) = (4.4, 45.0);
/// Value of f, in units, at the lower edge: with and without planes.
const BOTTOM: (f64, f64) = (-2.4, -1.5);

/// Dash and gap in points, by a curve's place; 0 is an unbroken line.
const DASHES: [(f32, f32); 4] = [(0.0, 0.0), (11.0, 6.0), (3.0, 5.0), (20.0, 5.0)];

/// The mapping of t and heights to the screen.
struct Axes {
    rect: Rect,
    t: RangeInclusive<f64>,
    height: (f64, f64),
}

impl Axes {
    fn x(&self, t: f64) -> f32 {
        let share = (t - self.t.start()) / (self.t.end() - self.t.start());
        self.rect.left() + self.rect.width() * share.clamp(-9.0, 9.0) as f32
    }

    fn y(&self, height: f64) -> f32 {
        let share = (height - self.height.0) / (self.height.1 - self.height.0);
        self.rect.bottom() - self.rect.height() * share.clamp(-9.0, 9.0) as f32
    }

    /// Returns the t at an x coordinate of the screen, with only as many digits as a point's width
    /// justifies.
    fn t_at(&self, x: f32) -> f64 {
        let span = self.t.end() - self.t.start();
        let share = f64::from((x - self.rect.left()) / self.rect.width()).clamp(0.0, 1.0);
        let per_unit = 10_f64.powf((f64::from(self.rect.width()) / span).log10().ceil());
        ((self.t.start() + share * span) * per_unit).round() / per_unit + 0.0
    }
}

/// Shows the plot and handles drags of t in it.
pub(super) fn ui(
    ui: &Ui,
    rect: Rect,
    plot: &Plot,
    first: Option<(u32, f64)>,
    ray_point_t: &mut Option<f64>,
) {
    let style = theme::style(ui);
    let colors = style.colors();
    let planes = plot.curves.iter().any(Curve::is_straight);
    let bottom = if planes { BOTTOM.0 } else { BOTTOM.1 };
    // Leave room for the numbers of f at the left, those of t below, and the title above.
    let inner = Rect::from_min_max(rect.min + vec2(44.0, 28.0), rect.max - vec2(8.0, 26.0));
    let top = if plot.heights == Heights::Even { TOP.0 } else { TOP.1 };
    let height = (plot.heights.height(bottom), plot.heights.height(top));
    let axes = Axes { rect: inner, t: plot.range.clone(), height };
    input(ui, &axes, ray_point_t);
    let painter = ui.painter_at(rect);
    painter.rect_filled(inner, 0.0, colors.background);
    let title = match plot.heights {
        Heights::Even => "f(p + t d) / unit",
        Heights::Compressed => "f(p + t d) / unit;  beyond ±1 compressed",
    };
    let title = painter.layout_job(formula(title, TEXT + 0.5, colors.ink));
    painter.galley(rect.min + vec2(6.0, 2.0), title, colors.ink);
    scales(&painter, &axes, colors.ink, plot.heights);
    let inside = ui.painter_at(inner);
    let within = inner.shrink(2.0);
    let mut words = LabelLayout::new(inside.clone(), colors.halo, within);
    if let Some(t) = *ray_point_t {
        let x = axes.x(t);
        words.keep_free(Rect::from_x_y_ranges(x - 4.0..=x + 4.0, inner.y_range()));
    }
    let captions = verticals(&inside, &axes, &mut words, colors.ink);
    let drawn: Vec<Strokes> = plot.samples.iter().map(|samples| strokes(&axes, samples)).collect();
    for (curve, strokes) in plot.curves.iter().zip(&drawn) {
        // The casing has the curve's dashes, so that an equal curve below is seen in the gaps.
        for points in &strokes.points {
            stroke(&inside, points, curve, Stroke::new(5.0, colors.halo));
        }
        for points in &strokes.points {
            stroke(&inside, points, curve, line(curve));
        }
        for (at, upwards) in &strokes.leaves {
            arrowhead(&inside, *at, *upwards, color_of(curve));
        }
    }
    captions.write(&drawn, &mut words);
    zeros(&inside, &axes, &plot.curves, first, &mut words, colors);
    if plot.ray_point_t.is_some() {
        point_that_walks(&inside, &axes, plot, &mut words, colors);
    }
    let lines: Vec<Pos2> = captions.lines(&drawn).collect();
    for (curve, strokes) in plot.curves.iter().zip(&drawn) {
        let font = Font { size: TEXT, color: colors.ink, bold: true };
        let (name, places) = (&curve.named.name, places_at(strokes, within));
        let clear = words.write_clear_of(&lines, name, font, places.iter().copied());
        if let Some(name) = clear.or_else(|| words.write(name, font, places)) {
            // Underlined in the curve's own style.
            let y = name.bottom() - 1.0;
            stroke(&inside, &[pos2(name.left(), y), pos2(name.right(), y)], curve, line(curve));
        }
    }
}

/// Sets t by a press or a drag in the plot, and moves it by arrow keys.
fn input(ui: &Ui, axes: &Axes, ray_point_t: &mut Option<f64>) {
    let id = ui.scope_id().with("plot of f");
    let response = ui.interact(axes.rect, id, Sense::click_and_drag());
    keep_arrows(&response, true, false);
    if response.clicked() || response.drag_started() {
        response.request_focus();
    }
    if (response.dragged() || response.clicked())
        && let Some(pointer) = response.interact_pointer_pos()
    {
        *ray_point_t = Some(axes.t_at(pointer.x));
    }
    if response.has_focus()
        && let Some(t) = ray_point_t
    {
        let presses = |key| ui.input(|i| i.num_presses(key) as f32);
        let steps = presses(Key::ArrowRight) - presses(Key::ArrowLeft);
        if steps != 0.0 {
            *t = axes.t_at(axes.x(*t) + 3.0 * steps);
        }
    }
    let text = ray_point_t.map_or("nobody walks".to_owned(), |t| format!("walked to t = {t}"));
    response.with_role(Role::Image).named("Plot of f(p + t d)").described(text);
}

/// Draws the numbers of t and f, the line f = 0, and the grey area behind the eye.
fn scales(painter: &Painter, axes: &Axes, ink: Color32, heights: Heights) {
    let rect = axes.rect;
    let eye = axes.x(0.0).clamp(rect.left(), rect.right());
    let behind = Rect::from_min_max(rect.min, pos2(eye, rect.bottom()));
    painter.rect_filled(behind, 0.0, ink.gamma_multiply(0.14));
    let faint = Stroke::new(1.0, ink.gamma_multiply(0.2));
    let font = FontId::proportional(TEXT);
    let marks: &[f64] = match heights {
        Heights::Even => &[-2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0],
        Heights::Compressed => &[-2.0, -1.0, 0.0, 1.0, 3.0, 10.0, 30.0],
    };
    for value in marks.iter().filter(|value| heights.height(**value) > axes.height.0) {
        let y = axes.y(heights.height(*value));
        let line = if *value == 0.0 { Stroke::new(2.5, ink) } else { faint };
        painter.hline(rect.x_range(), y, line);
        let text = number(*value, 3);
        painter.text(pos2(rect.left() - 6.0, y), Align2::RIGHT_CENTER, text, font.clone(), ink);
    }
    let span = axes.t.end() - axes.t.start();
    let step = round_step(62.0 * span / f64::from(rect.width()));
    let from = (axes.t.start() / step).ceil() as i64;
    let to = (axes.t.end() / step).floor() as i64;
    for k in from..=to {
        let t = k as f64 * step;
        let x = axes.x(t);
        painter.vline(x, rect.y_range(), faint);
        let at = pos2(x, rect.bottom() + 3.0);
        if x < rect.right() - 30.0 {
            painter.text(at, Align2::CENTER_TOP, number(t, 5), font.clone(), ink);
        }
    }
    let name = painter.layout_job(formula("t", TEXT + 2.0, ink));
    painter.galley(pos2(rect.right() - 14.0, rect.bottom() + 2.0), name, ink);
}

/// Draws the lines of the eye and the viewport. Returns their captions, which are written after the
/// curves.
fn verticals(painter: &Painter, axes: &Axes, words: &mut LabelLayout, ink: Color32) -> Captions {
    let rect = axes.rect;
    let [eye, viewport] = [0.0, 1.0].map(|t| axes.x(t));
    for (x, dash) in [(eye, 0.0), (viewport, 6.0)] {
        let ends = [pos2(x, rect.top()), pos2(x, rect.bottom())];
        let stroke = Stroke::new(2.0, ink);
        if dash > 0.0 {
            painter.extend(Shape::dashed_line(&ends, stroke, dash, dash));
        } else {
            painter.line_segment(ends, stroke);
        }
        words.keep_free(Rect::from_x_y_ranges(x - 1.0..=x + 1.0, rect.y_range()));
    }
    Captions { rect, eye, viewport, zero: axes.y(0.0), color: ink }
}

/// A curve on the screen.
pub(super) struct Strokes {
    /// The parts inside the plot.
    points: Vec<Vec<Pos2>>,
    /// The points where it leaves the plot, each with true if it leaves upwards.
    leaves: Vec<(Pos2, bool)>,
}

impl Strokes {
    /// Returns points of the curve, at most a few points of the screen apart.
    pub(super) fn closely(&self) -> impl Iterator<Item = Pos2> {
        self.points.iter().flat_map(|part| {
            part.windows(2).flat_map(|ends| {
                let count = (ends[0].distance(ends[1]) / 4.0).ceil().max(1.0) as usize;
                (0..=count).map(move |k| ends[0].lerp(ends[1], k as f32 / count as f32))
            })
        })
    }
}

fn strokes(axes: &Axes, samples: &[(f64, f64)]) -> Strokes {
    let (low, high) = axes.height;
    let mut points: Vec<Vec<Pos2>> = Vec::new();
    let mut leaves: Vec<(Pos2, bool)> = Vec::new();
    let to_screen = |(t, y): (f64, f64)| pos2(axes.x(t), axes.y(y));
    let edge_of = |y: f64| if y > high { Some(high) } else { (y < low).then_some(low) };
    let mut before: Option<(f64, f64)> = None;
    for &sample in samples {
        let was = before.replace(sample);
        let crossing = |outside: (f64, f64), inside: (f64, f64)| {
            let edge = edge_of(outside.1)?;
            let share = (edge - inside.1) / (outside.1 - inside.1);
            Some((to_screen((inside.0 + share * (outside.0 - inside.0), edge)), edge == high))
        };
        match (was.map(|w| (w, edge_of(w.1))), edge_of(sample.1)) {
            (None | Some((_, None)), None) => {
                if was.is_none() {
                    points.push(Vec::new());
                }
                points.last_mut().into_iter().for_each(|part| part.push(to_screen(sample)));
            }
            (Some((was, Some(_))), None) => {
                let entry = crossing(was, sample);
                leaves.extend(entry);
                points
                    .push(entry.map(|(at, _)| at).into_iter().chain([to_screen(sample)]).collect());
            }
            (Some((was, None)), Some(_)) => {
                let exit = crossing(sample, was);
                leaves.extend(exit);
                let part = points.last_mut().into_iter();
                part.zip(exit).for_each(|(part, (at, _))| part.push(at));
            }
            _ => {}
        }
    }
    if points.is_empty() {
        // The curve is never inside the plot: an arrow in the middle of the edge shows on which
        // side it is.
        let middle = 0.5 * (axes.t.start() + axes.t.end());
        if let Some(edge) = before.and_then(|(_, y)| edge_of(y)) {
            leaves.push((to_screen((middle, edge)), edge == high));
        }
    }
    Strokes { points, leaves }
}

fn color_of(curve: &Curve) -> Color32 {
    let [r, g, b] = curve.named.color;
    Color32::from_rgb(r, g, b)
}

/// Returns the look of a curve's line.
fn line(curve: &Curve) -> Stroke {
    Stroke::new(3.0, color_of(curve))
}

/// Draws a line with a curve's dashes.
fn stroke(painter: &Painter, points: &[Pos2], curve: &Curve, stroke: Stroke) {
    let (dash, gap) = DASHES[curve.index % DASHES.len()];
    if dash > 0.0 {
        painter.extend(Shape::dashed_line(points, stroke, dash, gap));
    } else {
        painter.add(Shape::line(points.to_vec(), stroke));
    }
}

/// Draws a sample of the curve's line, as a key to the text beside the plot.
pub(super) fn sample(ui: &Ui, rect: Rect, curve: &Curve) {
    let ends = [rect.left_center(), rect.right_center()];
    stroke(ui.painter(), &ends, curve, line(curve));
}

fn arrowhead(painter: &Painter, at: Pos2, upwards: bool, color: Color32) {
    let toward = if upwards { -1.0 } else { 1.0 };
    let back = at - vec2(0.0, 11.0 * toward);
    let corners = vec![at, back + vec2(6.5, 0.0), back - vec2(6.5, 0.0)];
    painter.add(Shape::convex_polygon(corners, color, Stroke::NONE));
}

/// Draws every zero as a ring, and the first hit as a large disc.
fn zeros(
    painter: &Painter,
    axes: &Axes,
    curves: &[Curve],
    first: Option<(u32, f64)>,
    words: &mut LabelLayout,
    colors: &crate::view::overlay::Colors,
) {
    let y = axes.y(0.0);
    let shown = |t: f64| axes.t.contains(&t);
    let roots = || {
        let all = curves.iter().flat_map(|c| c.derivation.roots().map(move |root| (c, root.t)));
        all.filter(|(curve, t)| shown(*t) && first != Some((curve.named.object, *t)))
    };
    for (curve, t) in roots() {
        let at = pos2(axes.x(t), y);
        painter.circle(at, 5.5, colors.background, Stroke::new(3.0, color_of(curve)));
        words.keep_free(Rect::from_center_size(at, Vec2::splat(13.0)));
    }
    if let Some((object, t)) = first.filter(|(_, t)| shown(*t)) {
        let color = curves.iter().find(|c| c.named.object == object).map_or(colors.ink, color_of);
        let at = pos2(axes.x(t), y);
        painter.circle(at, 9.0, color, Stroke::new(3.0, colors.ink));
        words.keep_free(Rect::from_center_size(at, Vec2::splat(20.0)));
        let t = number(t, 5);
        let texts = [format!("first hit: t = {t}"), format!("hit: t = {t}"), t];
        let font = Font { size: TEXT + 1.0, color: colors.ink, bold: true };
        let _ = texts.iter().any(|text| words.write(text, font, beside_hit(at)).is_some());
    }
    // Objects that are met at one t share its number.
    let mut written: Vec<String> = Vec::new();
    for (_, t) in roots() {
        let (at, text) = (pos2(axes.x(t), y), number(t, 4));
        if written.contains(&text) {
            continue;
        }
        let anchors = [
            (at + vec2(0.0, 8.0), Align2::CENTER_TOP),
            (at + vec2(0.0, -8.0), Align2::CENTER_BOTTOM),
            (at + vec2(0.0, 27.0), Align2::CENTER_TOP),
            (at + vec2(0.0, -27.0), Align2::CENTER_BOTTOM),
            (at + vec2(8.0, -27.0), Align2::CENTER_BOTTOM),
            (at + vec2(-8.0, -27.0), Align2::CENTER_BOTTOM),
        ];
        words.write(&text, Font { size: TEXT, color: colors.ink, bold: false }, anchors);
        written.push(text);
    }
}

/// Returns positions below the hit, then above it.
fn beside_hit(at: Pos2) -> [(Pos2, Align2); 6] {
    let below = |x: f32, align| (at + vec2(x, 12.0), align);
    let above = |x: f32, align| (at + vec2(x, -12.0), align);
    [
        below(-4.0, Align2::LEFT_TOP),
        below(4.0, Align2::RIGHT_TOP),
        below(0.0, Align2::CENTER_TOP),
        above(-4.0, Align2::LEFT_BOTTOM),
        above(4.0, Align2::RIGHT_BOTTOM),
        above(0.0, Align2::CENTER_BOTTOM),
    ]
}

/// Draws the vertical line that is dragged, and every f on it.
fn point_that_walks(
    painter: &Painter,
    axes: &Axes,
    plot: &Plot,
    words: &mut LabelLayout,
    colors: &crate::view::overlay::Colors,
) {
    let Some((t, values)) = &plot.ray_point_t else { return };
    let (x, rect) = (axes.x(*t), axes.rect);
    painter.vline(x, rect.y_range(), Stroke::new(6.0, colors.halo));
    painter.vline(x, rect.y_range(), Stroke::new(3.0, colors.ray));
    for (curve, f) in plot.curves.iter().zip(values.iter()) {
        let at = pos2(x, axes.y(curve.height(*f, plot.heights)));
        if rect.contains(at) {
            painter.circle(at, 5.5, colors.ray, Stroke::new(2.5, color_of(curve)));
        }
    }
    let text = format!("t = {}", number(*t, 5));
    let top = rect.top() + 3.0;
    let rows = (0..3).flat_map(|k| {
        let y = top + 20.0 * k as f32;
        [(pos2(x + 7.0, y), Align2::LEFT_TOP), (pos2(x - 7.0, y), Align2::RIGHT_TOP)]
    });
    words.write(&text, Font { size: TEXT + 2.0, color: colors.ray, bold: false }, rows);
}

/// Returns the positions for a curve's name: beside points along the curve, inside the plot.
fn places_at(strokes: &Strokes, within: Rect) -> Vec<(Pos2, Align2)> {
    let all: Vec<Pos2> = strokes.closely().collect();
    let mut anchors = Vec::new();
    let mut around = |at: Pos2| {
        anchors.extend([
            (at + vec2(9.0, -3.0), Align2::LEFT_CENTER),
            (at + vec2(-9.0, -3.0), Align2::RIGHT_CENTER),
            (at + vec2(0.0, -7.0), Align2::CENTER_BOTTOM),
            (at + vec2(0.0, 7.0), Align2::CENTER_TOP),
        ]);
    };
    for share in [0.3, 0.22, 0.4, 0.15, 0.5, 0.6, 0.7, 0.08, 0.8, 0.9, 0.02, 0.98] {
        let at = (share * all.len() as f32) as usize;
        all.get(at).into_iter().for_each(|at| around(*at));
    }
    for (at, upwards) in &strokes.leaves {
        around(*at + vec2(0.0, if *upwards { 12.0 } else { -12.0 }));
    }
    // At the very edge, the middle of the name would be cut off.
    let inner = within.shrink(1.0);
    anchors.into_iter().filter(|(at, _)| inner.expand(40.0).contains(*at)).collect()
}
