//! The panels of a plot: error against time, and error against the knob of a family (the parameter that
//! makes it easier or harder).

use egui::{Align2, Color32, Painter, Pos2, Rangef, Rect, Stroke, StrokeKind, pos2};
use pinhole_figure::chart::{GridInk, SOLID, Scale, Tick, columns, line, row_numbers, rows};
use pinhole_lecture::numbers::short_plain;

use super::marker::{self, marker_of};
use super::{FRAME, GRID, SMALL, TEXT, WEAK, plain};
use crate::report::model::{Case, Digits, NO_DIGIT, SINGLE};
use crate::report::summary::{MethodSummary, Outcome, Summary, outcome};

const ULP: Color32 = Color32::from_gray(0xa8);

/// The colour of the condition number.
const CONDITION: Color32 = Color32::from_gray(0xa0);

/// Dash and gap of a dashed line.
const DASH: [f32; 2] = [7.0, 5.0];

/// The height of a lane, a strip beyond the logarithmic scale for marks that have no place on it:
/// errors of zero, and methods without an error.
const LANE: f32 = 20.0;

/// Space between the outermost values and the frame.
const MARGIN: f32 = 10.0;
/// Space on both sides of a knob's outermost settings.
const EDGE: f32 = 24.0;

/// The lanes above the scale, from top to bottom, for methods without an error. A lane is drawn only if
/// there is a mark in it.
const LANES: [(Outcome, &str); 3] = [
    (Outcome::NoHit, "no hit alike"),
    (Outcome::NoDigit, "no digit right"),
    (Outcome::OutOfRange, "out of range"),
];

/// The vertical scale of errors, which two panels side by side share.
pub(super) struct Errors {
    scale: Scale,
    y: Rangef,
    /// The drawn lanes above the scale.
    lanes: Vec<(Outcome, &'static str)>,
}

impl Errors {
    /// Creates the scale for panels with this vertical range.
    pub(super) fn new(summary: &Summary, y: Rangef) -> Errors {
        let is_there = |(lane, _): &(Outcome, &str)| summary.outcomes().any(|o| o == *lane);
        let lanes: Vec<_> = LANES.into_iter().filter(is_there).collect();
        let edge = [y.max - LANE - MARGIN, y.min + LANE * lanes.len() as f32 + MARGIN];
        let errors = summary.outcomes().filter_map(|outcome| match outcome {
            Outcome::Error(error) => Some(error),
            _ => None,
        });
        let conditions = summary.cases.iter().filter_map(|case| condition(case));
        let all = errors.chain(conditions.filter(|_| summary.has_knob()));
        Errors { scale: Scale::decades(all, edge), y, lanes }
    }

    fn position(&self, outcome: Outcome) -> f32 {
        match outcome {
            Outcome::Error(error) if error <= 0.0 => self.y.max - 0.5 * LANE,
            Outcome::Error(error) => self.scale.position(error),
            _ => {
                let lane = self.lanes.iter().position(|(lane, _)| *lane == outcome).unwrap_or(0);
                self.y.min + LANE * (lane as f32 + 0.5)
            }
        }
    }

    /// Draws a panel's frame and horizontal lines and, if `has_numbers` is true, the labels to the left
    /// of the frame.
    fn draw(&self, painter: &Painter, rect: Rect, has_numbers: bool) {
        let ticks = self.scale.ticks(24.0);
        rows(painter, rect, &ticks, GRID.line);
        for ulp in [1.0, SINGLE].into_iter().filter(|ulp| self.scale.contains(*ulp)) {
            let y = self.scale.position(ulp);
            line(painter, &[pos2(rect.left(), y), pos2(rect.right(), y)], (1.5, ULP), DASH);
        }
        let above = self.lanes.iter().map(|&(lane, name)| (self.position(lane), 1.0, 12.0, name));
        let exact = (self.position(Outcome::Error(0.0)), -1.0, SMALL, "exact");
        for (middle, side, size, name) in above.chain([exact]) {
            painter.hline(rect.x_range(), middle + side * 0.5 * LANE, (1.0, FRAME));
            if has_numbers {
                let at = pos2(rect.left() - 6.0, middle);
                painter.text(at, Align2::RIGHT_CENTER, name, plain(size), TEXT);
            }
        }
        if has_numbers {
            row_numbers(painter, rect.left(), &ticks, GRID);
        }
        painter.rect_stroke(rect, 0.0, Stroke::new(1.5, FRAME), StrokeKind::Middle);
    }

    /// Writes the names of the two horizontal lines at an error of one ulp, of `f64` and of `f32`, to
    /// the right of a frame.
    pub(super) fn name_ulps(&self, painter: &Painter, right: f32) {
        for (ulp, name) in [(1.0, "f64 ulp"), (SINGLE, "f32 ulp")] {
            if self.scale.contains(ulp) {
                let at = pos2(right + 5.0, self.scale.position(ulp));
                painter.text(at, Align2::LEFT_CENTER, name, plain(12.0), WEAK);
            }
        }
    }
}

/// The mark of a method and its position.
#[derive(Clone, Copy)]
struct PlotMark<'a> {
    method: &'a MethodSummary<'a>,
    center: Pos2,
    outcome: Outcome,
    is_wrong: bool,
}

impl PlotMark<'_> {
    fn draw(&self, painter: &Painter) {
        marker_of(self.method.formula).draw(painter, self.center, self.method.digits);
    }
}

/// Draws the panel of error against time: for each formula, if `joins` is true, a curve that connects its
/// precisions; for each method, a mark, and a horizontal bar from its shortest to its longest time.
pub(super) fn time<'a>(
    painter: &Painter,
    rect: Rect,
    errors: &Errors,
    summary: &'a Summary,
    joins: bool,
) {
    let times = summary.methods.iter().filter_map(|method| method.time);
    let spreads = summary.methods.iter().filter_map(|method| method.times).flatten();
    let scale = Scale::close(times.chain(spreads), [rect.left(), rect.right()]);
    across(painter, rect, &scale.ticks(36.0), GRID, "nanoseconds a pixel");
    errors.draw(painter, rect, true);
    let mark = |method: &'a MethodSummary<'a>| {
        let outcome = method.outcome?;
        let center = pos2(scale.position(method.time?), errors.position(outcome));
        Some(PlotMark { method, center, outcome, is_wrong: method.wrong > 0 })
    };
    let marks: Vec<PlotMark> = summary.methods.iter().filter_map(mark).collect();
    for PlotMark { method, center, .. } in &marks {
        if let Some([low, high]) = method.times.map(|times| times.map(|x| scale.position(x))) {
            painter.hline(low..=high, center.y, (1.5, marker_of(method.formula).color));
        }
    }
    let mut sorted = marks.clone();
    sorted.sort_by_key(|mark| (mark.method.formula, mark.method.digits));
    let curves = sorted.chunk_by(|a, b| a.method.formula == b.method.formula);
    for curve in curves.filter(|_| joins) {
        let points: Vec<Pos2> = curve.iter().map(|mark| mark.center).collect();
        line(painter, &points, (2.0, marker_of(curve[0].method.formula).color), SOLID);
    }
    // The first method is the most important one, so it is drawn last, on top. Each ring is drawn
    // together with its mark, so that it is clear which mark it belongs to.
    for mark in marks.iter().rev() {
        marker::ring_around(painter, mark.is_wrong.then_some(mark.center));
        mark.draw(painter);
    }
}

/// Draws vertical grid lines, with their numbers and the name of the horizontal axis below the panel.
fn across(painter: &Painter, rect: Rect, ticks: &[Tick], ink: GridInk, name: &str) {
    columns(painter, rect, ticks, ink);
    let below = pos2(rect.center().x, rect.bottom() + 32.0);
    painter.text(below, Align2::CENTER_CENTER, name, plain(SMALL), TEXT);
}

/// Draws the panel of error against the family's knob: for each method, a line through its largest
/// error at each setting.
pub(super) fn knob(painter: &Painter, rect: Rect, errors: &Errors, summary: &Summary) {
    let places = places(rect, summary.cases.len());
    let case_name = summary.cases.first().map_or("", |case| case.knob_name.as_str());
    let name = if case_name.is_empty() { "knob" } else { case_name };
    let tick = |(case, at): (&&Case, &f32)| {
        let value = case.knob.unwrap_or(0.0);
        Tick { value, at: *at, text: short_plain(value) }
    };
    let ticks: Vec<Tick> = summary.cases.iter().zip(&places).map(tick).collect();
    let ink = GridInk { size: 11.0, ..GRID };
    across(painter, rect, &ticks, ink, &format!("{name} (not to scale)"));
    errors.draw(painter, rect, false);
    let condition_at =
        |(case, x): (&&Case, &f32)| Some(pos2(*x, errors.scale.position(condition(case)?)));
    let conditions = summary.cases.iter().zip(&places).map(condition_at).collect();
    chains(conditions).for_each(|chain| line(painter, &chain, (3.0, CONDITION), SOLID));
    let gap = places.windows(2).map(|pair| pair[1] - pair[0]).fold(rect.width(), f32::min);
    let room = f32::min(0.8 * gap, 2.0 * EDGE - 18.0);
    let column = |(case, x): (&&Case, &f32)| {
        if case.coverage == 0.0 {
            let middle = pos2(*x, rect.center().y);
            painter.text(middle, Align2::CENTER_CENTER, "all\nmiss", plain(12.0), WEAK);
        }
        column(case, (*x, room), errors, summary)
    };
    let columns: Vec<Vec<Vec<PlotMark>>> = summary.cases.iter().zip(&places).map(column).collect();
    for method in &summary.methods {
        let center = |column: &Vec<Vec<PlotMark>>| {
            let mark = column.iter().flatten().find(|mark| std::ptr::eq(mark.method, method))?;
            matches!(mark.outcome, Outcome::Error(_)).then_some(mark.center)
        };
        let dash = if method.digits == Digits::Single { DASH } else { SOLID };
        let stroke = Stroke::new(1.5, marker_of(method.formula).color);
        // A line is interrupted where there is no error to show.
        let points = columns.iter().map(center).collect();
        chains(points).for_each(|chain| line(painter, &chain, stroke, dash));
    }
    for close in columns.iter().flatten() {
        let wrong = close.iter().filter(|mark| mark.is_wrong);
        marker::ring_around(painter, wrong.map(|mark| mark.center));
        close.iter().rev().for_each(|mark| mark.draw(painter));
    }
}

/// Returns the horizontal positions of this many settings of the knob, which are equally spaced.
fn places(rect: Rect, count: usize) -> Vec<f32> {
    let step = (rect.width() - 0.5 * EDGE) / count as f32;
    let place = |k: usize| rect.left() + 0.25 * EDGE + (k as f32 + 0.5) * step;
    (0..count).map(place).collect()
}

/// Splits the points at each `None` into runs without gaps. Runs of a single point are dropped.
fn chains(points: Vec<Option<Pos2>>) -> impl Iterator<Item = Vec<Pos2>> {
    let chains: Vec<Vec<Pos2>> = points
        .split(Option::is_none)
        .filter(|chain| chain.len() > 1)
        .map(|chain| chain.iter().copied().flatten().collect())
        .collect();
    chains.into_iter()
}

/// Vertical distance below which marks are moved apart horizontally.
const CLOSE: f32 = 5.0;
/// Horizontal distance to which marks are moved apart.
const APART: f32 = 4.0;

/// Returns the marks for one setting of the knob, in groups. Marks that would overlap form a group and
/// are placed side by side, over a width of at most `room`. Within a group, the marks of methods with
/// wrong decisions come last, so that a single ring can enclose them.
fn column<'a>(
    case: &Case,
    (x, room): (f32, f32),
    errors: &Errors,
    summary: &'a Summary<'a>,
) -> Vec<Vec<PlotMark<'a>>> {
    let mark = |method: &'a MethodSummary<'a>| {
        let row = case.methods.iter().find(|row| row.name == method.name)?;
        let outcome = outcome(row)?;
        let center = pos2(x, errors.position(outcome));
        Some(PlotMark { method, center, outcome, is_wrong: row.wrong > 0 })
    };
    let mut marks: Vec<PlotMark> = summary.methods.iter().filter_map(mark).collect();
    marks.sort_by(|a, b| a.center.y.total_cmp(&b.center.y));
    let is_close = |a: &PlotMark, b: &PlotMark| b.center.y - a.center.y < CLOSE;
    let mut column: Vec<Vec<PlotMark>> =
        marks.chunk_by(is_close).map(<[PlotMark]>::to_vec).collect();
    let order = |mark: &PlotMark| summary.methods.iter().position(|m| std::ptr::eq(m, mark.method));
    for close in &mut column {
        close.sort_by_key(|mark| (mark.is_wrong, order(mark)));
        let last = close.len() - 1;
        let step = APART.min(room / last.max(1) as f32);
        for (index, mark) in close.iter_mut().enumerate() {
            mark.center.x += step * (index as f32 - 0.5 * last as f32);
        }
    }
    column
}

/// Returns the case's largest condition number, which is the error of t, in ulps, that rounding the
/// input once may cause. Returns `None` if that error leaves no correct digit of t.
fn condition(case: &Case) -> Option<f64> {
    case.condition.map(|condition| condition.max).filter(|max| *max < NO_DIGIT)
}
