//! The report as pictures, in the way of work-precision diagrams (Hairer and Wanner, "Solving
//! Ordinary Differential Equations II", section IV.10; SciML's benchmarks): time across, error up,
//! both logarithmic; a curve a formula, over the precisions that it is computed in.
//!
//! Pages of 16:9, each for one slide. A scene is a page; of several scenes the first page is the summary,
//! a line a method. Families are a summary, and pages of four of them each: a family also shows its error
//! against the knob, and its time panel the worst error of all settings.

mod axis;
mod frame;
mod legend;
pub(crate) mod marker;
mod overview;
mod panel;

use egui::Align;

use self::frame::{Frame, MARGIN, TEXT, WEAK, paragraph};
use self::panel::Errors;
use super::model::Report;
use super::summary::{self, Summary};
use crate::figures::Figure;
use crate::figures::chart::{Chart, Point, bold, plain};

const TITLE: &str = "Error against run time";

/// Dots to a point in PNG: as wide as a projector.
pub const PNG_SCALE: f32 = 1.5;

/// The size of a page, in points.
const PAGE: [f64; 2] = [1280.0, 720.0];

/// Room for the numbers left of a panel, and for the names of lines right of it.
const NUMBERS: f64 = 84.0;
const NAMES: f64 = 46.0;

/// Families on a page: two by two.
const GRID: usize = 4;

/// Draws a report, with so many dots to a point: a picture a page.
pub fn pages(report: &Report, scale: f32) -> Vec<Figure> {
    let summaries = summary::summaries(report);
    let (families, scenes): (Vec<&Summary>, Vec<&Summary>) =
        summaries.iter().partition(|summary| summary.has_knob());
    let mut charts = Vec::new();
    if summaries.len() > 1 {
        charts.push(first(report, &summaries));
    }
    charts.extend(scenes.into_iter().map(|scene| single(report, scene)));
    charts.extend(families.chunks(GRID).map(grid));
    let pages = charts.len();
    for (page, chart) in (1..).zip(&mut charts).filter(|_| pages > 1) {
        let note = format!("page {page} of {pages}");
        chart.text([PAGE[0] - MARGIN, 28.0], Align::RIGHT, plain(16.0), WEAK, note);
    }
    charts.into_iter().map(|chart| chart.into_figure(TITLE, scale)).collect()
}

/// How to read the marks of a panel.
const MARKS: &str = "Down and left is better. A line joins a formula's precisions: hollow (and dashed over \
    a knob) f32, filled f64, framed double-double. Pale stairs: the Pareto front, those that no other beats \
    in both time and error and that decide all right. Red ring: also decided wrong (hit or miss, which \
    object is first, or another root of it); such rays are in no error.";

/// How to read the panels of a family.
const SETTINGS: &str = "Left: worst error of all settings, the middle of their times; bar: least to most. \
    Wide grey line: condition number, the ulps that one rounding of what is given may cost.";

/// How to read the panel of a scene.
const ROUNDS: &str = "Time: the shortest of the rounds, which take the methods in turn; the bar ends at \
    their upper quartile.";

/// What the words mean.
const WORDS: &str = "Ulp: the spacing of neighbouring numbers; a t off by 1 ulp of f64 has 16 digits right, \
    by 1 ulp of f32 7. Coverage: the share of rays that hit.";

/// Begins a page; returns where its content begins.
fn page() -> (Chart, f64) {
    let mut chart = Chart::new(PAGE[0]);
    chart.height = PAGE[1];
    chart.text([MARGIN, 28.0], Align::LEFT, bold(24.0), TEXT, TITLE);
    (chart, 60.0)
}

/// The page of a scene.
fn single(report: &Report, summary: &Summary) -> Chart {
    let (mut chart, top) = page();
    let right = PAGE[0] - MARGIN - legend::WIDTH;
    cell(&mut chart, [MARGIN, top], [right - MARGIN, 440.0], summary);
    legend::table(&mut chart, [right + 8.0, top + 28.0], summary);
    let mut y = top + 462.0;
    for text in [MARKS, &format!("{ROUNDS} {WORDS}")] {
        y = paragraph(&mut chart, y, text);
    }
    foot(&mut chart, y, report);
    chart
}

/// The first page of a report of several scenes or families.
fn first(report: &Report, summaries: &[Summary]) -> Chart {
    let (mut chart, top) = page();
    let all = summary::overall(summaries);
    let bottom = overview::draw(&mut chart, top, &all);
    let wrong = "Wrong: hit or miss, which object is first, or another root of it; such rays are in no \
                 error. None: no digit of t is right, or no hit is.";
    let mut y = paragraph(&mut chart, bottom + 8.0, &format!("{wrong} {WORDS}"));
    let summary::Overall { noun, in_share, in_errors, .. } = all;
    if in_errors < in_share {
        let which = format!(
            "Of the {in_share} {noun} that all formulas have, ladder-f32 has {in_errors}: errors and times are \
             of those. The error of each is that of its worst setting, the time that of its middle one."
        );
        y = paragraph(&mut chart, y, &which);
    }
    foot(&mut chart, y, report);
    chart
}

/// A page of several families.
fn grid(families: &[&Summary]) -> Chart {
    let (mut chart, top) = page();
    let size = [0.5 * (PAGE[0] - 3.0 * MARGIN), 282.0];
    for (index, summary) in families.iter().enumerate() {
        let left = MARGIN + (size[0] + MARGIN) * (index % 2) as f64;
        cell(&mut chart, [left, top + size[1] * (index / 2) as f64], size, summary);
    }
    let below = top + 2.0 * size[1];
    legend::line(&mut chart, below + 10.0, families);
    paragraph(&mut chart, below + 33.0, &format!("{MARKS} {SETTINGS}"));
    chart
}

/// A scene or a family: its error against time, and against the knob where it has one.
fn cell(chart: &mut Chart, [left, top]: Point, [width, height]: Point, summary: &Summary) {
    let Some(case) = summary.cases.first() else { return };
    let name = if summary.has_knob() { case.name.clone() } else { case.title() };
    chart.text([left, top + 4.0], Align::LEFT, bold(18.0), TEXT, name);
    let coverage = format!("coverage {}", summary.coverage());
    let coverage = match summary.cases.len() {
        1 => coverage,
        count => format!("{count} settings, {coverage}"),
    };
    chart.text([left + width, top + 4.0], Align::RIGHT, plain(14.0), WEAK, coverage);
    let mut above = top + 24.0;
    if !case.about.is_empty() {
        chart.text([left, above], Align::LEFT, plain(14.0), WEAK, case.about.as_str());
        above += 18.0;
    }
    let what = "largest error in t, ulps of f64";
    chart.text([left, above], Align::LEFT, plain(14.0), TEXT, what);
    let frame = Frame {
        left: left + NUMBERS,
        top: above + 12.0,
        right: left + width - NAMES,
        bottom: top + height - 48.0,
    };
    let errors = Errors::new(summary, frame);
    if summary.has_knob() {
        let middle = 0.5 * (frame.left + frame.right);
        panel::time(chart, Frame { right: middle - 8.0, ..frame }, &errors, summary);
        panel::knob(chart, Frame { left: middle + 8.0, ..frame }, &errors, summary);
    } else {
        panel::time(chart, frame, &errors, summary);
    }
    errors.name_ulps(chart, frame);
}

/// Writes the reference, the processor, what a reader needs and what was left out.
fn foot(chart: &mut Chart, mut y: f64, report: &Report) {
    let seed = report.seed.map_or(String::new(), |seed| format!("; seed {seed}"));
    for (name, text, more) in [
        ("Reference", &report.reference, ""),
        ("Processor", &report.cpu, seed.as_str()),
        ("Note", &report.notes.join("; "), ""),
    ] {
        if !text.is_empty() {
            y = paragraph(chart, y, &format!("{name}: {text}{more}"));
        }
    }
    if !report.left_out.is_empty() {
        paragraph(chart, y, &format!("Left out: {}", left_out(&report.left_out)));
    }
}

/// The first of what was left out, and how much more there is: all of it is in the table.
fn left_out(lines: &[String]) -> String {
    const MOST: usize = 160;
    let mut length = 0;
    let fits = |line: &&String| {
        length += line.chars().count();
        length <= MOST
    };
    let first: Vec<&str> = lines.iter().take_while(fits).map(String::as_str).collect();
    match (lines.len() - first.len(), first.is_empty()) {
        (0, _) => first.join("; "),
        (more, true) => format!("{more} kinds of cases, which the table lists"),
        (more, false) => format!("{}; and {more} more, which the table lists", first.join("; ")),
    }
}
