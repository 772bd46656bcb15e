//! One panel: a frame with its scales, and the methods in it.

use egui::{Align, Color32};

use super::axis::{Close, Decades, Knobs, Tick};
use super::frame::{FRAME, Frame, GRID, SMALL, TEXT, WEAK, across};
use super::marker::{self, marker_of};
use super::summary::{SINGLE, Summary, in_ulps_of_f64};
use crate::figures::chart::{Chart, Point, plain};

const ULP: Color32 = Color32::from_gray(0xa8);

/// The height of the places for zero errors and for methods that have no error to show.
const LANE: f64 = 30.0;

/// Room between the outermost values and the frame.
const MARGIN: f64 = 12.0;

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
                let at = [frame.right + 6.0, self.scale.position(ulp)];
                chart.text(at, Align::LEFT, plain(14.0), WEAK, name);
            }
        }
    }
}

/// Error against time: a mark a method at its largest error, with a stem down to the 99th
/// percentile.
pub(crate) fn time(chart: &mut Chart, frame: Frame, errors: &Errors, summary: &Summary) {
    let times = summary.methods.iter().filter_map(|method| method.time);
    let scale = Close::over(times, [frame.left, frame.right]);
    across(chart, frame, scale.ticks(), "nanoseconds a pixel");
    errors.draw(chart, frame, true);
    let mut marks = Vec::new();
    for method in &summary.methods {
        let (Some(time), Some(y)) =
            (method.time.filter(|time| *time > 0.0), errors.position(method.max))
        else {
            continue;
        };
        let x = scale.position(time);
        let look = marker_of(method.family);
        if method.p99.is_some() && method.max.is_some() {
            let low = errors.scale.position(method.p99.unwrap_or_default());
            chart.line(&[[x, y], [x, low]], look.color, 1.5);
            chart.line(&[[x - 5.0, low], [x + 5.0, low]], look.color, 2.0);
        }
        marks.push(Mark {
            center: [x, y],
            family: method.family,
            hollow: method.single,
            wrong: method.wrong > 0,
        });
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
        let color = marker_of(method.family).color;
        let mut chain: Vec<Point> = Vec::new();
        let mut chains: Vec<Vec<Point>> = Vec::new();
        for (knob, row) in summary.along_knob(method.name) {
            let error = in_ulps_of_f64(row, row.ulp.max);
            let Some(y) = errors.position(error) else { continue };
            let center = [scale.position(knob), y];
            marks.push(Mark {
                center,
                family: method.family,
                hollow: method.single,
                wrong: row.wrong > 0,
            });
            // A curve ends where there is no error to show.
            if error.is_some() {
                chain.push(center);
            } else {
                chains.push(std::mem::take(&mut chain));
            }
        }
        chains.push(chain);
        for points in chains.into_iter().filter(|chain| chain.len() > 1) {
            if method.single {
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
    family: &'a str,
    hollow: bool,
    wrong: bool,
}

/// The first method on top of the others, as it is the one to look for; rings last, so that no
/// mark hides one.
fn draw_marks(chart: &mut Chart, marks: &[Mark]) {
    for hollow in [false, true] {
        for mark in marks.iter().rev().filter(|mark| mark.hollow == hollow) {
            marker_of(mark.family).draw(chart, mark.center, hollow);
        }
    }
    for mark in marks.iter().filter(|mark| mark.wrong) {
        marker::ring(chart, mark.center);
    }
}
