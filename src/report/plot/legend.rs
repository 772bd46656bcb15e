//! The legend: the mark of each formula in each precision.

use egui::Align;
use pinhole_lecture::numbers::grouped;

use super::frame::{MARGIN, TEXT, WEAK};
use super::marker::{self, WRONG, in_words, marker_of};
use crate::figures::chart::{Chart, Point, bold, plain};
use crate::report::model::Digits;
use crate::report::summary::{Summary, Worst};

/// Distance from one formula to the next, in points.
const LINE: f64 = 44.0;

/// The width of the table, in points.
pub(crate) const WIDTH: f64 = 400.0;

/// The precisions, their names, and the distance of their marks from the table's left edge.
const COLUMNS: [(Digits, &str, f64); 3] = [
    (Digits::Single, "f32", 142.0),
    (Digits::Double, "f64", 222.0),
    (Digits::DoubleDouble, "double-double", 302.0),
];

/// Draws a table of wrong decisions from its left top corner, a row a formula: beside the panels, so
/// that neither marks nor counts ever cover each other.
pub(crate) fn table(chart: &mut Chart, [left, top]: Point, summary: &Summary) {
    chart.text([left, top], Align::LEFT, bold(15.0), TEXT, "wrong decisions");
    for (_, name, x) in COLUMNS {
        chart.text([left + x - 8.0, top], Align::LEFT, bold(13.0), TEXT, name);
    }
    let formulas = formulas(summary.methods.iter().map(|method| method.formula));
    for (index, formula) in formulas.iter().enumerate() {
        let y = top + LINE * index as f64 + 28.0;
        chart.text([left, y], Align::LEFT, plain(16.0), TEXT, *formula);
        chart.text([left, y + 18.0], Align::LEFT, plain(13.0), WEAK, in_words(formula));
        for method in summary.methods.iter().filter(|method| method.formula == *formula) {
            let column = COLUMNS.iter().find(|(digits, ..)| *digits == method.digits);
            count(chart, [left + column.map_or(0.0, |(.., x)| *x), y], method);
        }
    }
    let decisions = summary.methods.iter().map(|method| method.decisions).max().unwrap_or(0);
    let y = top + LINE * formulas.len() as f64 + 26.0;
    chart.text(
        [left, y],
        Align::LEFT,
        plain(14.0),
        WEAK,
        format!("of {} compared with the truth", grouped(decisions)),
    );
}

/// A mark and what it got wrong, ringed as in the panels.
fn count(chart: &mut Chart, [x, y]: Point, method: &Worst) {
    marker_of(method.formula).draw(chart, [x, y], method.digits);
    let at = [x + 16.0, y];
    if method.wrong == 0 {
        chart.text(at, Align::LEFT, plain(16.0), WEAK, "0");
        return;
    }
    marker::ring_around(chart, &[[x, y]]);
    chart.text(at, Align::LEFT, bold(16.0), WRONG, grouped(method.wrong));
}

/// Draws the marks of these families in one line.
pub(crate) fn line(chart: &mut Chart, y: f64, summaries: &[&Summary]) {
    let methods = summaries.iter().flat_map(|summary| &summary.methods);
    let formulas = formulas(methods.map(|method| method.formula));
    let mut x = MARGIN + 8.0;
    for formula in formulas {
        marker_of(formula).draw(chart, [x, y], Digits::Double);
        chart.text([x + 13.0, y], Align::LEFT, plain(16.0), TEXT, formula);
        x += 46.0 + 8.6 * formula.chars().count() as f64;
    }
}

/// The formulas, each once.
fn formulas<'a>(all: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut formulas = Vec::new();
    for formula in all {
        if !formulas.contains(&formula) {
            formulas.push(formula);
        }
    }
    formulas
}
