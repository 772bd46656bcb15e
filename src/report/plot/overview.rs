//! The summary of a report over all families: a line a method.

use egui::Align;
use pinhole_lecture::numbers::grouped;

use super::axis::{Decades, Tick};
use super::frame::{FRAME, GRID, MARGIN, SMALL, TEXT, WEAK};
use super::marker::{WRONG, marker_of};
use super::summary::{Overall, Summary, overall};
use crate::figures::chart::{Chart, bold, plain};
use crate::model::number::short_plain;

/// Distance from one method to the next, in points.
const LINE: f64 = 24.0;

/// The columns' left edges, and the right edge of the last.
const WRONG_AT: f64 = 376.0;
const ERROR: [f64; 2] = [505.0, 850.0];
const TIME: [f64; 2] = [905.0, 1240.0];

/// Draws the summary; returns where it ends.
pub(crate) fn draw(chart: &mut Chart, top: f64, summaries: &[Summary]) -> f64 {
    let (methods, shared) = overall(summaries);
    let head = |chart: &mut Chart, x: f64, align: Align, texts: [String; 2]| {
        let [name, about] = texts;
        chart.text([x, top], align, bold(17.0), TEXT, name);
        chart.text([x, top + 20.0], align, plain(13.0), WEAK, about);
    };
    let over = match shared {
        1 => "of the one family that all methods share".to_owned(),
        _ => format!("least to most of {shared} families that all methods share; mark: median"),
    };
    head(chart, MARGIN, Align::LEFT, ["method".to_owned(), String::new()]);
    let all = format!("of all decisions in {} families", summaries.len());
    head(chart, WRONG_AT, Align::RIGHT, ["wrong decisions".to_owned(), all]);
    head(chart, ERROR[0], Align::LEFT, ["largest error in t, ulps of f64".to_owned(), over]);
    head(chart, TIME[0], Align::LEFT, ["nanoseconds a pixel".to_owned(), String::new()]);
    let upper = top + 38.0;
    let bottom = upper + LINE * methods.len() as f64;
    let row = |index: usize| upper + LINE * (index as f64 + 0.5);
    for index in (0..methods.len()).step_by(2) {
        let (low, high) = (row(index) - 0.5 * LINE, row(index) + 0.5 * LINE);
        let [left, right] = [MARGIN - 6.0, chart.width - MARGIN + 6.0];
        chart.fill(&[[left, low], [right, low], [right, high], [left, high]], BAND);
    }
    for (index, method) in methods.iter().enumerate() {
        let y = row(index);
        marker_of(method.formula).draw(chart, [MARGIN + 8.0, y], method.digits);
        chart.text([MARGIN + 24.0, y], Align::LEFT, plain(17.0), TEXT, method.name);
        wrong(chart, y, method);
    }
    spread(chart, [upper, bottom], ERROR, &methods, |method| &method.errors);
    spread(chart, [upper, bottom], TIME, &methods, |method| &method.times);
    bottom + 30.0
}

/// Every other line lies on this.
const BAND: egui::Color32 = egui::Color32::from_gray(0xf6);

fn wrong(chart: &mut Chart, y: f64, method: &Overall) {
    let share = 100.0 * method.wrong as f64 / method.decisions.max(1) as f64;
    let (font, color) = if method.wrong == 0 { (plain(17.0), WEAK) } else { (bold(17.0), WRONG) };
    chart.text([WRONG_AT - 74.0, y], Align::RIGHT, font, color, grouped(method.wrong));
    let share = match method.wrong {
        0 => "0 %".to_owned(),
        _ => format!("{} %", short_plain((share * 1e3).round().max(1.0) / 1e3)),
    };
    chart.text([WRONG_AT, y], Align::RIGHT, plain(15.0), color, share);
    let of = format!("of {}", grouped(method.decisions));
    chart.text([WRONG_AT + 92.0, y], Align::RIGHT, plain(13.0), WEAK, of);
}

/// Draws one column: for each method, a line from its least to its greatest value, and its mark at the
/// one in the middle.
fn spread(
    chart: &mut Chart,
    [top, bottom]: [f64; 2],
    [left, right]: [f64; 2],
    methods: &[Overall],
    values: for<'a> fn(&'a Overall) -> &'a [f64],
) {
    let all = methods.iter().flat_map(values).copied();
    let scale = Decades::over(all, [left + 26.0, right], left + 8.0);
    for Tick { at, text } in scale.ticks(8) {
        chart.line(&[[at, top], [at, bottom]], GRID, 1.0);
        chart.text([at, bottom + 13.0], Align::Center, plain(SMALL), TEXT, text);
    }
    if methods.iter().any(|method| values(method).contains(&0.0)) {
        chart.text([left + 8.0, bottom + 13.0], Align::Center, plain(SMALL), TEXT, "0");
    }
    chart.line(&[[left, bottom], [right, bottom]], FRAME, 1.5);
    for (index, method) in methods.iter().enumerate() {
        let y = top + LINE * (index as f64 + 0.5);
        let values = values(method);
        let (Some(low), Some(high)) = (values.first(), values.last()) else { continue };
        let marker = marker_of(method.formula);
        let ends = [[scale.position(*low), y], [scale.position(*high), y]];
        chart.line(&ends, marker.color, 2.5);
        let middle = values[values.len() / 2];
        marker.draw(chart, [scale.position(middle), y], method.digits);
    }
}
