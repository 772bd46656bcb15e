//! The report as pictures, in the way of work-precision diagrams (Hairer and Wanner, "Solving
//! Ordinary Differential Equations II", section IV.10; SciML's benchmarks): time across, error up,
//! both logarithmic; a curve a formula, over the precisions that it is computed in.
//!
//! Pages of 16:9, each for one slide. A report of one scene is one page. Of several scenes or families,
//! the first page is the summary, a line a method, and the others show four of them each. A family also
//! shows its error against the knob; its time panel shows the worst of all settings.

mod axis;
mod frame;
mod legend;
pub(crate) mod marker;
mod overview;
mod panel;
mod summary;

use egui::Align;

use self::frame::{Frame, MARGIN, TEXT, WEAK, paragraph};
use self::panel::Errors;
use self::summary::Summary;
use super::model::Report;
use crate::figures::Figure;
use crate::figures::chart::{Chart, Point, bold, plain};

const TITLE: &str = "Error against run time";

/// Dots to a point in PNG: as wide as a projector.
pub const PNG_SCALE: f32 = 1.5;

/// The size of a page, in points.
const PAGE: [f64; 2] = [1280.0, 720.0];

/// Room for the numbers left of a panel, and for the names of lines right of it.
const NUMBERS: f64 = 78.0;
const NAMES: f64 = 44.0;

/// Scenes or families on a page: two by two.
const GRID: usize = 4;

/// Draws a report, with so many dots to a point: a picture a page.
pub fn pages(report: &Report, scale: f32) -> Vec<Figure> {
    let summaries = summary::summaries(report);
    let mut charts = Vec::new();
    match summaries.as_slice() {
        [one] => charts.push(single(report, one)),
        many => {
            charts.push(first(report, many));
            let pages = many.len().div_ceil(GRID) + 1;
            let of = |index: usize| format!("page {} of {pages}", index + 2);
            charts.extend(many.chunks(GRID).enumerate().map(|(k, four)| grid(&of(k), four)));
        }
    }
    charts.into_iter().map(|chart| chart.into_figure(TITLE, scale)).collect()
}

/// How to read a panel.
const HOW_TO_READ: [&str; 2] = [
    "Down and left is better. A line joins a formula's precisions: hollow f32, filled f64, framed \
     double-double. Bars: quartiles of the times. Yellow: the Pareto front of the methods that decide \
     all right.",
    "A red ring: the method also decided wrong (hit or miss, which object is first); such rays are \
     counted apart and are in no error.",
];

/// Begins a page; returns where its content begins.
fn page(note: &str) -> (Chart, f64) {
    let mut chart = Chart::new(PAGE[0]);
    chart.height = PAGE[1];
    chart.text([MARGIN, 28.0], Align::LEFT, bold(24.0), TEXT, TITLE);
    chart.text([PAGE[0] - MARGIN, 28.0], Align::RIGHT, plain(16.0), WEAK, note);
    (chart, 62.0)
}

/// The page of a report of one scene or family.
fn single(report: &Report, summary: &Summary) -> Chart {
    let (mut chart, top) = page("");
    let right = PAGE[0] - MARGIN - legend::WIDTH;
    cell(&mut chart, [MARGIN, top], [right - MARGIN, 470.0], summary);
    legend::table(&mut chart, [right + 8.0, top + 44.0], summary);
    let mut y = top + 488.0;
    for line in HOW_TO_READ {
        y = paragraph(&mut chart, y, 12.0, line);
    }
    foot(&mut chart, y, report);
    chart
}

/// The first page of a report of several scenes or families.
fn first(report: &Report, summaries: &[Summary]) -> Chart {
    let (mut chart, top) = page("summary");
    let bottom = overview::draw(&mut chart, top, summaries);
    let marks = "Hollow: f32; filled: f64; framed: double-double. A wrong decision (hit or miss, which \
                 object is first) is counted, and is in no error.";
    let y = paragraph(&mut chart, bottom + 6.0, 12.0, marks);
    foot(&mut chart, y, report);
    chart
}

/// A page of several scenes or families.
fn grid(note: &str, summaries: &[Summary]) -> Chart {
    let (mut chart, top) = page(note);
    let size = [0.5 * (PAGE[0] - 3.0 * MARGIN), 284.0];
    for (index, summary) in summaries.iter().enumerate() {
        let left = MARGIN + (size[0] + MARGIN) * (index % 2) as f64;
        cell(&mut chart, [left, top + size[1] * (index / 2) as f64], size, summary);
    }
    legend::line(&mut chart, top + 2.0 * size[1] + 16.0, summaries);
    let mut y = top + 2.0 * size[1] + 40.0;
    for line in HOW_TO_READ {
        y = paragraph(&mut chart, y, 12.0, line);
    }
    chart
}

/// A scene or a family: its error against time, and against the knob where it has one.
fn cell(chart: &mut Chart, [left, top]: Point, [width, height]: Point, summary: &Summary) {
    let Some(case) = summary.cases.first() else { return };
    let name = if summary.cases.len() == 1 { case.title() } else { case.name.clone() };
    chart.text([left, top + 4.0], Align::LEFT, bold(17.0), TEXT, name);
    let coverage = format!("coverage {}", summary.coverage());
    let coverage = match summary.cases.len() {
        1 => coverage,
        count => format!("{count} settings, {coverage}"),
    };
    chart.text([left + width, top + 4.0], Align::RIGHT, plain(13.0), WEAK, coverage);
    let what = "largest error in t, ulps of f64";
    chart.text([left, top + 25.0], Align::LEFT, plain(13.0), WEAK, what);
    let frame = Frame {
        left: left + NUMBERS,
        top: top + 38.0,
        right: left + width - NAMES,
        bottom: top + height - 62.0,
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

/// Writes the reference, the processor, the baseline and what was left out.
fn foot(chart: &mut Chart, mut y: f64, report: &Report) {
    for (name, text) in [
        ("Reference", &report.reference),
        ("Processor", &report.cpu),
        ("Baseline", &report.baseline),
    ] {
        if !text.is_empty() {
            y = paragraph(chart, y, 12.0, &format!("{name}: {text}"));
        }
    }
    if !report.left_out.is_empty() {
        paragraph(chart, y, 12.0, &format!("Left out: {}", left_out(&report.left_out)));
    }
}

/// The first of what was left out, and how much more there is: all of it is in the table.
fn left_out(lines: &[String]) -> String {
    const MOST: usize = 200;
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
