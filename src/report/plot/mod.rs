//! The report as a picture, in the way of work-precision diagrams (Hairer and Wanner, "Solving
//! Ordinary Differential Equations II", section IV.10; SciML's benchmarks): time across, error up,
//! both logarithmic.
//!
//! A row a scene: error against time, and how many decisions each method got wrong. A family also
//! shows its error against the knob; its time panel shows the worst of all settings.

mod axis;
mod frame;
mod legend;
pub(crate) mod marker;
mod panel;
mod summary;

use egui::Align;

use self::frame::{Frame, GAP, MARGIN, TEXT, WEAK, paragraph};
use self::panel::Errors;
use self::summary::Summary;
pub(crate) use self::summary::{SINGLE, in_ulps_of_f64};
use super::model::Report;
use crate::figures::Figure;
use crate::figures::chart::{Chart, bold, plain};

const TITLE: &str = "Error against run time";

/// Dots to a point in PNG: as wide as a projector.
pub const PNG_SCALE: f32 = 1.5;

const WIDTH: f64 = 1280.0;

/// Room for the numbers left of a panel.
const NUMBERS: f64 = 104.0;

/// The height of a panel, and of a row with all that belongs to it.
const PANEL: f64 = 300.0;
const ROW: f64 = 440.0;

/// Draws a report, with so many dots to a point.
pub fn figure(report: &Report, scale: f32) -> Figure {
    let mut chart = Chart::new(WIDTH);
    let mut y = head(&mut chart);
    for summary in summary::summaries(report) {
        row(&mut chart, y, &summary);
        y += ROW;
    }
    chart.height = foot(&mut chart, y, report) + MARGIN;
    chart.into_figure(TITLE, scale)
}

/// Writes the title and how to read what is below; returns where it ends.
fn head(chart: &mut Chart) -> f64 {
    chart.text([MARGIN, 40.0], Align::LEFT, bold(30.0), TEXT, TITLE);
    let how_to_read = [
        "Down and left is better. Filled: f64; hollow: f32. A mark stands at the largest error in t, \
         its stem ends at the 99th percentile.",
        "A red ring: the method also decided wrong (hit or miss, which object is first); such rays \
         are counted on the right and are in no error.",
    ];
    let mut y = 76.0;
    for line in how_to_read {
        y = paragraph(chart, y, 17.0, line);
    }
    y + 22.0
}

/// Writes the reference, the processor and the baseline; returns where it ends.
fn foot(chart: &mut Chart, top: f64, report: &Report) -> f64 {
    let mut y = top + 4.0;
    for (name, text) in [
        ("Reference", &report.reference),
        ("Processor", &report.cpu),
        ("Baseline", &report.baseline),
    ] {
        if !text.is_empty() {
            y = paragraph(chart, y, 16.0, &format!("{name}: {text}"));
        }
    }
    if !report.left_out.is_empty() {
        y = paragraph(chart, y, 16.0, &format!("Left out: {}", left_out(&report.left_out)));
    }
    y - 16.0
}

/// The first of what was left out, and how much more there is: all of it is in the table.
fn left_out(lines: &[String]) -> String {
    const MOST: usize = 600;
    let mut length = 0;
    let fits = |line: &&String| {
        length += line.chars().count();
        length <= MOST
    };
    let first: Vec<&str> = lines.iter().take_while(fits).map(String::as_str).collect();
    let first = if first.is_empty() { vec![lines[0].as_str()] } else { first };
    match lines.len() - first.len() {
        0 => first.join("; "),
        more => format!("{}; and {more} more, which the table lists", first.join("; ")),
    }
}

fn row(chart: &mut Chart, top: f64, summary: &Summary) {
    let Some(case) = summary.cases.first() else { return };
    let settings = match summary.cases.len() {
        1 => case.title(),
        _ => case.name.clone(),
    };
    chart.text([MARGIN, top + 14.0], Align::LEFT, bold(22.0), TEXT, settings);
    let coverage = format!("coverage {}", summary.coverage());
    let coverage = match summary.cases.len() {
        1 => coverage,
        count => format!("{count} settings, {coverage}"),
    };
    chart.text([WIDTH - MARGIN, top + 14.0], Align::RIGHT, plain(17.0), WEAK, coverage);
    let (upper, lower) = (top + 62.0, top + 62.0 + PANEL);
    let left = MARGIN + NUMBERS;
    let right = WIDTH - MARGIN - legend::WIDTH - GAP - 14.0;
    let middle = 0.5 * (left + right);
    let whole = Frame { left, top: upper, right, bottom: lower };
    let errors = Errors::new(summary, whole);
    let what = "largest error in t, in ulps of f64".to_owned();
    chart.text([MARGIN, top + 44.0], Align::LEFT, plain(17.0), TEXT, what);
    if summary.has_knob() {
        let across = Frame { right: middle - 8.0, ..whole };
        panel::time(chart, across, &errors, summary);
        panel::knob(chart, Frame { left: middle + 8.0, ..whole }, &errors, summary);
    } else {
        panel::time(chart, whole, &errors, summary);
    }
    errors.name_ulps(chart, whole);
    legend::draw(chart, [right + GAP + 14.0, upper + 12.0], summary);
}
