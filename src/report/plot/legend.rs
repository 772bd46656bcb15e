//! Which mark is which method, and how many decisions each got wrong: a small table beside the
//! panels, so that neither marks nor counts ever cover each other.

use super::marker::{self, WRONG};
use super::summary::{Summary, Worst};
use crate::chart::figure::{Align, Figure, Place};
use crate::chart::frame::{TEXT, WEAK};
use crate::model::number::grouped;

/// From one line to the next, in points.
const LINE: f64 = 29.0;

/// The width of the table, in points.
pub(crate) const WIDTH: f64 = 372.0;

/// From the left edge to the marks of `f32` and of `f64`.
const COLUMNS: [f64; 2] = [156.0, 272.0];

/// Draws the table from its left top corner; the ring's meaning stands below.
pub(crate) fn draw(figure: &mut Figure, [left, top]: Place, summary: &Summary) {
    figure.bold([left, top], Align::Left, 17.0, TEXT, "wrong decisions".to_owned());
    for (name, x) in ["f32", "f64"].into_iter().zip(COLUMNS) {
        figure.bold([left + x + 16.0, top], Align::Left, 17.0, TEXT, name.to_owned());
    }
    let mut families: Vec<&str> = Vec::new();
    for method in &summary.methods {
        if !families.contains(&method.family) {
            families.push(method.family);
        }
    }
    for (index, family) in families.iter().enumerate() {
        let y = top + LINE * (index as f64 + 1.1);
        figure.text([left, y], Align::Left, 17.0, TEXT, (*family).to_owned());
        for method in summary.methods.iter().filter(|method| method.family == *family) {
            let x = left + COLUMNS[usize::from(!method.single)];
            count(figure, [x, y], method);
        }
    }
    let decisions = summary.methods.iter().map(|method| method.decisions).max().unwrap_or(0);
    let y = top + LINE * (families.len() as f64 + 1.2);
    figure.text([left, y], Align::Left, 15.0, WEAK, format!("of {}", grouped(decisions)));
}

/// A mark and what it got wrong, ringed as in the panels.
fn count(figure: &mut Figure, [x, y]: Place, method: &Worst) {
    marker::of(method.family).draw(figure, [x, y], method.single);
    let at = [x + 20.0, y];
    if method.wrong == 0 {
        figure.text(at, Align::Left, 17.0, WEAK, "0".to_owned());
        return;
    }
    marker::ring(figure, [x, y]);
    figure.bold(at, Align::Left, 17.0, WRONG, grouped(method.wrong));
}
