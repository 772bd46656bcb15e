//! The legend: the mark of each method, and how many decisions it got wrong. A small table beside the
//! panels, so that neither marks nor counts ever cover each other.

use egui::Align;
use pinhole_lecture::numbers::grouped;

use super::frame::{TEXT, WEAK};
use super::marker::{self, WRONG, marker_of};
use super::summary::{Summary, Worst};
use crate::figures::chart::{Chart, Point, bold, plain};

/// Distance from one line to the next, in points.
const LINE: f64 = 29.0;

/// The width of the table, in points.
pub(crate) const WIDTH: f64 = 372.0;

/// Distance of the marks of `f32` and of `f64` from the left edge.
const COLUMNS: [f64; 2] = [156.0, 272.0];

/// Draws the table from its left top corner; the ring's meaning stands below.
pub(crate) fn draw(chart: &mut Chart, [left, top]: Point, summary: &Summary) {
    chart.text([left, top], Align::LEFT, bold(17.0), TEXT, "wrong decisions");
    for (name, x) in ["f32", "f64"].into_iter().zip(COLUMNS) {
        chart.text([left + x + 16.0, top], Align::LEFT, bold(17.0), TEXT, name);
    }
    let mut families: Vec<&str> = Vec::new();
    for method in &summary.methods {
        if !families.contains(&method.family) {
            families.push(method.family);
        }
    }
    for (index, family) in families.iter().enumerate() {
        let y = top + LINE * (index as f64 + 1.1);
        chart.text([left, y], Align::LEFT, plain(17.0), TEXT, *family);
        for method in summary.methods.iter().filter(|method| method.family == *family) {
            let x = left + COLUMNS[usize::from(!method.single)];
            count(chart, [x, y], method);
        }
    }
    let decisions = summary.methods.iter().map(|method| method.decisions).max().unwrap_or(0);
    let y = top + LINE * (families.len() as f64 + 1.2);
    chart.text([left, y], Align::LEFT, plain(15.0), WEAK, format!("of {}", grouped(decisions)));
}

/// A mark and what it got wrong, ringed as in the panels.
fn count(chart: &mut Chart, [x, y]: Point, method: &Worst) {
    marker_of(method.family).draw(chart, [x, y], method.single);
    let at = [x + 20.0, y];
    if method.wrong == 0 {
        chart.text(at, Align::LEFT, plain(17.0), WEAK, "0");
        return;
    }
    marker::ring(chart, [x, y]);
    chart.text(at, Align::LEFT, bold(17.0), WRONG, grouped(method.wrong));
}
