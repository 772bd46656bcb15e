//! Panels: error against time, and against the knob of a family.

use egui::{Align, Color32};

use super::axis::{Close, Decades, Knobs, Tick};
use super::frame::{FRAME, Frame, GRID, SMALL, TEXT, WEAK, across};
use super::marker::{self, marker_of};
use crate::figures::chart::{Chart, Point, plain};
use crate::report::model::{Case, Digits, NO_DIGIT, SINGLE};
use crate::report::summary::{Outcome, Summary, Worst, front, outcome};

const ULP: Color32 = Color32::from_gray(0xa8);

/// The Pareto front, wide and pale behind the curves.
const FRONT: Color32 = Color32::from_rgb(0xc9, 0xd6, 0xe6);

/// The condition number.
const CONDITION: Color32 = Color32::from_gray(0xa0);

/// The height of the places for zero errors and for methods that have no error to show.
const LANE: f64 = 20.0;

/// Room between the outermost values and the frame, and of a knob's outermost settings.
const MARGIN: f64 = 10.0;
const EDGE: f64 = 24.0;

/// Lanes above the scale, from the top, each there only where something stands in it.
const LANES: [(Outcome, &str); 3] = [
    (Outcome::NoHit, "no hit alike"),
    (Outcome::NoDigit, "no digit right"),
    (Outcome::OutOfRange, "out of range"),
];

/// The scale of errors, which both panels of a row share.
pub(crate) struct Errors {
    scale: Decades,
    zero: f64,
    /// The lanes above the scale.
    lanes: Vec<(Outcome, &'static str)>,
}

impl Errors {
    /// The scale of a row whose frames have this top and bottom.
    pub(crate) fn new(summary: &Summary, frame: Frame) -> Errors {
        let is_there = |(lane, _): &(Outcome, &str)| summary.outcomes().any(|o| o == *lane);
        let lanes: Vec<_> = LANES.into_iter().filter(is_there).collect();
        let top = frame.top + LANE * lanes.len() as f64 + MARGIN;
        let zero = frame.bottom - 0.5 * LANE;
        let along = [frame.bottom - LANE - MARGIN, top];
        let errors = summary.outcomes().filter_map(|outcome| match outcome {
            Outcome::Error(error) => Some(error),
            _ => None,
        });
        let conditions = summary.cases.iter().filter_map(|case| condition(case));
        let all = errors.chain(conditions.filter(|_| summary.has_knob()));
        Errors { scale: Decades::over(all, along, zero), zero, lanes }
    }

    /// Position of an outcome in a frame with this top.
    fn position(&self, outcome: Outcome, top: f64) -> f64 {
        if let Outcome::Error(error) = outcome {
            return self.scale.position(error);
        }
        let lane = self.lanes.iter().position(|(lane, _)| *lane == outcome).unwrap_or(0);
        top + LANE * (lane as f64 + 0.5)
    }

    /// Frame, lines across and their numbers; the numbers stand left of the frame.
    fn draw(&self, chart: &mut Chart, frame: Frame, numbers: bool) {
        let Frame { left, top, right, bottom } = frame;
        for Tick { at, text } in self.scale.ticks(6) {
            chart.line(&[[left, at], [right, at]], GRID, 1.0);
            if numbers {
                chart.text([left - 8.0, at], Align::RIGHT, plain(SMALL), TEXT, text);
            }
        }
        for ulp in [1.0, SINGLE] {
            if self.scale.holds(ulp) {
                let at = self.scale.position(ulp);
                chart.dashed(&[[left, at], [right, at]], ULP, 1.5);
            }
        }
        let above = self.lanes.iter().map(|&(lane, name)| (self.position(lane, top), 1.0, name));
        for (middle, side, name) in above.chain([(self.zero, -1.0, "exact")]) {
            let edge = middle + side * 0.5 * LANE;
            chart.line(&[[left, edge], [right, edge]], FRAME, 1.0);
            if numbers {
                let size = if side > 0.0 { 12.0 } else { SMALL };
                chart.text([left - 6.0, middle], Align::RIGHT, plain(size), TEXT, name);
            }
        }
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        chart.outline(&corners, FRAME, 1.5);
    }

    /// The names of the two lines that stand for one ulp, right of a frame.
    pub(crate) fn name_ulps(&self, chart: &mut Chart, frame: Frame) {
        for (ulp, name) in [(1.0, "f64 ulp"), (SINGLE, "f32 ulp")] {
            if self.scale.holds(ulp) {
                let at = [frame.right + 5.0, self.scale.position(ulp)];
                chart.text(at, Align::LEFT, plain(12.0), WEAK, name);
            }
        }
    }
}

/// Error against time: a curve a formula, over its precisions, each with a bar over its times; behind
/// them the Pareto front.
pub(crate) fn time(chart: &mut Chart, frame: Frame, errors: &Errors, summary: &Summary) {
    let times = summary.methods.iter().filter_map(|method| method.time);
    let spreads = summary.methods.iter().filter_map(|method| method.times).flatten();
    let scale = Close::over(times.chain(spreads), [frame.left, frame.right]);
    across(chart, frame, scale.ticks(), SMALL, "nanoseconds a pixel");
    errors.draw(chart, frame, true);
    let at = |method: &Worst| -> Option<Point> {
        Some([scale.position(method.time?), errors.position(method.outcome?, frame.top)])
    };
    draw_front(chart, &front(&summary.methods).into_iter().filter_map(at).collect::<Vec<_>>());
    let mut marks = Vec::new();
    for method in &summary.methods {
        let Some(center) = at(method) else { continue };
        if let Some([low, high]) = method.times {
            let y = center[1];
            let ends = [[scale.position(low), y], [scale.position(high), y]];
            chart.line(&ends, marker_of(method.formula).color, 1.5);
        }
        marks.push(Mark { method, center, has_error: true, wrong: method.wrong > 0 });
    }
    for first in &marks {
        let formula = first.method.formula;
        let mut curve: Vec<&Mark> = marks.iter().filter(|m| m.method.formula == formula).collect();
        curve.sort_by_key(|mark| mark.method.digits);
        if curve.len() > 1 && std::ptr::eq(curve[0], first) {
            let points: Vec<Point> = curve.iter().map(|mark| mark.center).collect();
            chart.line(&points, marker_of(formula).color, 2.0);
        }
    }
    // The first method on top of the others, as it is the one to look for; each ring with its own mark, so
    // that none is taken for another's.
    for mark in marks.iter().rev() {
        if mark.wrong {
            marker::ring_around(chart, &[mark.center]);
        }
        mark.draw(chart);
    }
}

/// The Pareto front as stairs: between two of its methods there is none, so that what is bought for more
/// time is the slower one's error, from its time on.
fn draw_front(chart: &mut Chart, front: &[Point]) {
    let mut stairs: Vec<Point> = Vec::new();
    for point in front {
        stairs.extend(stairs.last().map(|last| [point[0], last[1]]));
        stairs.push(*point);
    }
    if stairs.len() > 1 {
        chart.line(&stairs, FRONT, 7.0);
    }
    for point in front {
        chart.ring(*point, 5.5, FRONT, 11.0);
    }
}

/// Error against the family's knob: a line a method, at its largest error.
pub(crate) fn knob(chart: &mut Chart, frame: Frame, errors: &Errors, summary: &Summary) {
    let knobs: Vec<f64> = summary.cases.iter().filter_map(|case| case.knob).collect();
    let scale_within = |edge| Knobs::over(&knobs, [frame.left + edge, frame.right - edge]);
    // Side by side, the outermost settings keep half a step from the ends anyway.
    let scale = Some(scale_within(EDGE)).filter(Knobs::is_to_scale);
    let scale = scale.unwrap_or_else(|| scale_within(0.25 * EDGE));
    let name = summary.cases.first().map_or("", |case| case.knob_name.as_str());
    let name = if name.is_empty() { "knob" } else { name };
    if scale.is_to_scale() {
        across(chart, frame, scale.ticks(), SMALL, name);
    } else {
        across(chart, frame, scale.ticks(), 11.0, &format!("{name} (not to scale)"));
    }
    errors.draw(chart, frame, false);
    draw_condition(chart, &scale, errors, summary);
    let room = f64::min(0.8 * scale.gap(), 2.0 * EDGE - 18.0);
    let position = |outcome| errors.position(outcome, frame.top);
    let columns: Vec<Column> = summary
        .cases
        .iter()
        .map(|case| {
            let x = scale.position(case.knob.unwrap_or(0.0));
            if case.coverage == 0.0 {
                for (line, text) in [(-8.0, "all"), (8.0, "miss")] {
                    let middle = [x, 0.5 * (frame.top + frame.bottom) + line];
                    chart.text(middle, Align::Center, plain(12.0), WEAK, text);
                }
            }
            column(case, [x, room], &position, summary)
        })
        .collect();
    for method in &summary.methods {
        let color = marker_of(method.formula).color;
        let of_method = |column: &Column| {
            let mark = column.iter().flatten().find(|mark| std::ptr::eq(mark.method, method))?;
            mark.has_error.then_some(mark.center)
        };
        let points: Vec<Option<Point>> = columns.iter().map(of_method).collect();
        // A curve ends where there is no error to show.
        for chain in points.split(Option::is_none).filter(|chain| chain.len() > 1) {
            let chain: Vec<Point> = chain.iter().copied().flatten().collect();
            if method.digits == Digits::Single {
                chart.dashed(&chain, color, 1.5);
            } else {
                chart.line(&chain, color, 1.5);
            }
        }
    }
    for close in columns.iter().flatten() {
        let wrong: Vec<Point> = close.iter().filter(|m| m.wrong).map(|m| m.center).collect();
        marker::ring_around(chart, &wrong);
        close.iter().rev().for_each(|mark| mark.draw(chart));
    }
}

/// The marks of one setting of the knob, those that would hide each other together.
type Column<'a> = Vec<Vec<Mark<'a>>>;

/// Sets marks that would hide each other side by side, over at most `room`: those that decide wrong last, so
/// that one ring can be around them.
fn column<'a>(
    case: &Case,
    [x, room]: [f64; 2],
    position: &dyn Fn(Outcome) -> f64,
    summary: &'a Summary<'a>,
) -> Column<'a> {
    let mark = |method: &'a Worst<'a>| {
        let row = case.methods.iter().find(|row| row.name == method.name)?;
        let outcome = outcome(row)?;
        let has_error = matches!(outcome, Outcome::Error(_));
        Some(Mark { method, center: [x, position(outcome)], has_error, wrong: row.wrong > 0 })
    };
    let mut marks: Vec<Mark> = summary.methods.iter().filter_map(mark).collect();
    marks.sort_by(|a, b| a.center[1].total_cmp(&b.center[1]));
    let is_close = |a: &Mark, b: &Mark| b.center[1] - a.center[1] < CLOSE;
    let mut column: Column = marks.chunk_by(is_close).map(<[Mark]>::to_vec).collect();
    let order = |mark: &Mark| summary.methods.iter().position(|m| std::ptr::eq(m, mark.method));
    for close in &mut column {
        close.sort_by_key(|mark| (mark.wrong, order(mark)));
        let last = close.len() - 1;
        let step = APART.min(room / last.max(1) as f64);
        for (index, mark) in close.iter_mut().enumerate() {
            mark.center[0] += step * (index as f64 - 0.5 * last as f64);
        }
    }
    column
}

/// Marks that stand closer than this above each other are set apart sideways, each from the next by so
/// much.
const CLOSE: f64 = 5.0;
const APART: f64 = 4.0;

/// The condition number over the knob: what one rounding of what is given may cost.
fn draw_condition(chart: &mut Chart, scale: &Knobs, errors: &Errors, summary: &Summary) {
    let point =
        |case: &&Case| Some([scale.position(case.knob?), errors.scale.position(condition(case)?)]);
    let points: Vec<Option<Point>> = summary.cases.iter().map(point).collect();
    for chain in points.split(Option::is_none).filter(|chain| chain.len() > 1) {
        chart.line(&chain.iter().copied().flatten().collect::<Vec<_>>(), CONDITION, 3.0);
    }
}

/// The condition number, where it leaves some digit of t.
fn condition(case: &Case) -> Option<f64> {
    case.condition.map(|condition| condition.max).filter(|max| *max < NO_DIGIT)
}

/// A method's mark, somewhere.
#[derive(Clone, Copy)]
struct Mark<'a> {
    method: &'a Worst<'a>,
    center: Point,
    /// False in the lanes of methods that have no error to show.
    has_error: bool,
    wrong: bool,
}

impl Mark<'_> {
    fn draw(&self, chart: &mut Chart) {
        marker_of(self.method.formula).draw(chart, self.center, self.method.digits);
    }
}
