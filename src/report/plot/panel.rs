//! One panel: a frame with its scales, and the methods in it.

use egui::{Align, Color32};

use super::axis::{Close, Decades, Knobs, Tick};
use super::frame::{FRAME, Frame, GRID, SMALL, TEXT, WEAK, across};
use super::marker::{self, marker_of};
use super::summary::{Summary, Worst, front};
use crate::figures::chart::{Chart, Point, plain};
use crate::report::model::{Digits, SINGLE};

const ULP: Color32 = Color32::from_gray(0xa8);

/// The Pareto front, wide and pale behind the curves.
const FRONT: Color32 = Color32::from_rgb(0xf0, 0xe4, 0x42);

/// The height of the places for zero errors and for methods that have no error to show.
const LANE: f64 = 22.0;

/// Room between the outermost values and the frame.
const MARGIN: f64 = 10.0;

/// The scale of errors, which both panels of a row share.
pub(crate) struct Errors {
    scale: Decades,
    zero: f64,
    /// Position of methods that have no hit in common with the truth, where there are some.
    nowhere: Option<f64>,
}

impl Errors {
    /// The scale of a row whose frames have this top and bottom.
    pub(crate) fn new(summary: &Summary, frame: Frame) -> Errors {
        let lost = summary.methods.iter().any(|method| method.max.is_none());
        let nowhere = lost.then_some(frame.top + 0.5 * LANE);
        let top = frame.top + if lost { LANE } else { 0.0 } + MARGIN;
        let zero = frame.bottom - 0.5 * LANE;
        let along = [frame.bottom - LANE - MARGIN, top];
        Errors { scale: Decades::over(summary.errors(), along, zero), zero, nowhere }
    }

    /// Position of an error; `None` only if the whole row has no place for methods without one.
    fn position(&self, error: Option<f64>) -> Option<f64> {
        error.map_or(self.nowhere, |error| Some(self.scale.position(error)))
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
        let lanes =
            [(Some(self.zero), bottom - LANE, "exact"), (self.nowhere, top + LANE, "no hit alike")];
        for (middle, edge, name) in lanes {
            let Some(middle) = middle else { continue };
            chart.line(&[[left, edge], [right, edge]], FRAME, 1.0);
            if numbers {
                chart.text([left - 8.0, middle], Align::RIGHT, plain(SMALL), TEXT, name);
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

/// Error against time: a curve a formula, over its precisions, each with a bar from quartile to quartile
/// of the times; behind them the Pareto front.
pub(crate) fn time(chart: &mut Chart, frame: Frame, errors: &Errors, summary: &Summary) {
    let times = summary.methods.iter().filter_map(|method| method.time);
    let spreads = summary.methods.iter().filter_map(|method| method.spread).flatten();
    let scale = Close::over(times.chain(spreads), [frame.left, frame.right]);
    across(chart, frame, scale.ticks(), "nanoseconds a pixel");
    errors.draw(chart, frame, true);
    let at = |method: &Worst| -> Option<Point> {
        Some([scale.position(method.time?), errors.position(method.max)?])
    };
    let front: Vec<Point> = front(&summary.methods).into_iter().filter_map(at).collect();
    if front.len() > 1 {
        chart.line(&front, FRONT, 7.0);
    }
    let mut marks = Vec::new();
    for method in &summary.methods {
        let Some(center) = at(method) else { continue };
        if let Some([low, high]) = method.spread.filter(|[low, _]| *low > 0.0) {
            let y = center[1];
            let ends = [[scale.position(low), y], [scale.position(high), y]];
            chart.line(&ends, marker_of(method.formula).color, 1.5);
        }
        let (formula, digits, wrong) = (method.formula, method.digits, method.wrong > 0);
        marks.push(Mark { center, formula, digits, wrong });
    }
    for first in &marks {
        let mut curve: Vec<&Mark> = marks.iter().filter(|m| m.formula == first.formula).collect();
        curve.sort_by_key(|mark| mark.digits);
        if curve.len() > 1 && std::ptr::eq(curve[0], first) {
            let points: Vec<Point> = curve.iter().map(|mark| mark.center).collect();
            chart.line(&points, marker_of(first.formula).color, 2.0);
        }
    }
    draw_marks(chart, &marks);
}

/// Error against the family's knob: a line a method, at its largest error.
pub(crate) fn knob(chart: &mut Chart, frame: Frame, errors: &Errors, summary: &Summary) {
    let knobs: Vec<f64> = summary.cases.iter().filter_map(|case| case.knob).collect();
    let inside = [frame.left + 16.0, frame.right - 16.0];
    let scale = Knobs::over(&knobs, inside);
    let name = summary.cases.first().map_or("", |case| case.knob_name.as_str());
    let name = if name.is_empty() { "knob" } else { name };
    across(chart, frame, scale.ticks(), name);
    errors.draw(chart, frame, false);
    let mut marks = Vec::new();
    for method in &summary.methods {
        let color = marker_of(method.formula).color;
        let mut chain: Vec<Point> = Vec::new();
        let mut chains: Vec<Vec<Point>> = Vec::new();
        for (knob, row) in summary.along_knob(method.name) {
            let error = row.ulp_f64.max;
            let Some(y) = errors.position(error) else { continue };
            let center = [scale.position(knob), y];
            let (formula, digits, wrong) = (method.formula, method.digits, row.wrong > 0);
            marks.push(Mark { center, formula, digits, wrong });
            // A curve ends where there is no error to show.
            if error.is_some() {
                chain.push(center);
            } else {
                chains.push(std::mem::take(&mut chain));
            }
        }
        chains.push(chain);
        for points in chains.into_iter().filter(|chain| chain.len() > 1) {
            if method.digits == Digits::Single {
                chart.dashed(&points, color, 2.0);
            } else {
                chart.line(&points, color, 2.0);
            }
        }
    }
    draw_marks(chart, &marks);
}

/// A method's mark, somewhere.
struct Mark<'a> {
    center: Point,
    formula: &'a str,
    digits: Digits,
    wrong: bool,
}

/// The first method on top of the others, as it is the one to look for; rings last, so that no
/// mark hides one.
fn draw_marks(chart: &mut Chart, marks: &[Mark]) {
    for mark in marks.iter().rev() {
        marker_of(mark.formula).draw(chart, mark.center, mark.digits);
    }
    for mark in marks.iter().filter(|mark| mark.wrong) {
        marker::ring(chart, mark.center);
    }
}
