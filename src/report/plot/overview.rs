//! The summary of a report over all scenes or families: a line a method.

use egui::{Align, Color32};

use super::axis::{Decades, Tick};
use super::frame::{FRAME, GRID, MARGIN, SMALL, TEXT, WEAK};
use super::marker::{WRONG, in_words, marker_of};
use crate::figures::chart::{Chart, bold, plain};
use crate::model::number::short_plain;
use crate::report::columns::lines;
use crate::report::summary::{MethodOverall, Overall, least_middle_most};

/// Distance from one method to the next, in points.
const LINE: f64 = 23.0;

/// The columns' left edges, and the right edges of those of numbers.
const WORDS_AT: f64 = 206.0;
const WRONG_AT: f64 = 540.0;
const ERROR: [f64; 2] = [590.0, 885.0];
const TIME: [f64; 2] = [930.0, 1240.0];

/// Every other formula lies on this.
const BAND: Color32 = Color32::from_gray(0xf6);

/// Draws the summary; returns where it ends.
pub(crate) fn draw(chart: &mut Chart, top: f64, all: &Overall) -> f64 {
    let Overall { methods, noun, in_share, in_errors } = all;
    let head = |chart: &mut Chart, x: f64, align: Align, name: &str, about: String| {
        chart.text([x, top], align, bold(17.0), TEXT, name);
        chart.text([x, top + 20.0], align, plain(14.0), WEAK, about);
    };
    head(chart, MARGIN, Align::LEFT, "method", String::new());
    head(
        chart,
        WRONG_AT,
        Align::RIGHT,
        "wrong decisions",
        format!("mean share, {in_share} {noun}"),
    );
    let spread = format!("least to most of {in_errors} {noun} that all have");
    head(chart, ERROR[0], Align::LEFT, "largest error in t, ulps of f64", spread);
    head(
        chart,
        TIME[0],
        Align::LEFT,
        "nanoseconds a pixel",
        "mark: the one in the middle".to_owned(),
    );
    let upper = top + 38.0;
    let bottom = upper + LINE * methods.len() as f64;
    let mut y = upper;
    let formulas = methods.chunk_by(|a, b| a.formula == b.formula);
    for (index, formula) in formulas.enumerate() {
        let below = y + LINE * formula.len() as f64;
        if index % 2 == 0 {
            let [left, right] = [MARGIN - 6.0, chart.width - MARGIN + 6.0];
            chart.fill(&[[left, y], [right, y], [right, below], [left, below]], BAND);
        }
        let words = lines(in_words(formula[0].formula), 38);
        for (method, words) in
            formula.iter().zip(words.into_iter().chain(std::iter::repeat(String::new())))
        {
            let middle = y + 0.5 * LINE;
            marker_of(method.formula).draw(chart, [MARGIN + 8.0, middle], method.digits);
            chart.text([MARGIN + 24.0, middle], Align::LEFT, plain(17.0), TEXT, method.name);
            chart.text([WORDS_AT, middle], Align::LEFT, plain(13.0), WEAK, words);
            wrong(chart, middle, method);
            y += LINE;
        }
    }
    let errors: Vec<_> = methods.iter().map(MethodOverall::errors).collect();
    let times: Vec<_> = methods.iter().map(|method| least_middle_most(&method.times)).collect();
    columns(chart, [upper, bottom], ERROR, methods, &errors);
    columns(chart, [upper, bottom], TIME, methods, &times);
    bottom + 30.0
}

fn wrong(chart: &mut Chart, y: f64, method: &MethodOverall) {
    let (font, color) = if method.wrong == 0 { (plain(17.0), WEAK) } else { (bold(17.0), WRONG) };
    let share = match method.share {
        None => "-".to_owned(),
        Some(0.0) => "0 %".to_owned(),
        // Never told as none.
        Some(share) => format!("{} %", short_plain(((1e5 * share).round() / 1e3).max(1e-3))),
    };
    chart.text([WRONG_AT, y], Align::RIGHT, font, color, share);
}

/// Draws one column: for each method, a line from its least to its greatest value, and its mark at the
/// one in the middle. What is infinite stands at the end.
fn columns(
    chart: &mut Chart,
    [top, bottom]: [f64; 2],
    [left, right]: [f64; 2],
    methods: &[MethodOverall],
    values: &[Option<[f64; 3]>],
) {
    let all = || values.iter().flatten().flatten().copied();
    let end = if all().any(f64::is_infinite) { right - 44.0 } else { right };
    let scale = Decades::over(all(), [left + 26.0, end], left + 8.0);
    let position =
        |value: f64| if value.is_infinite() { right - 14.0 } else { scale.position(value) };
    for Tick { at, text } in scale.ticks(6) {
        chart.line(&[[at, top], [at, bottom]], GRID, 1.0);
        chart.text([at, bottom + 13.0], Align::Center, plain(SMALL), TEXT, text);
    }
    for (value, name) in [(0.0, "0"), (f64::INFINITY, "none")] {
        if all().any(|other| other == value) {
            let at = [position(value), bottom + 13.0];
            chart.text(at, Align::Center, plain(SMALL), TEXT, name);
        }
    }
    chart.line(&[[left, bottom], [right, bottom]], FRAME, 1.5);
    for (index, (method, values)) in methods.iter().zip(values).enumerate() {
        let y = top + LINE * (index as f64 + 0.5);
        let Some([low, middle, high]) = values.map(|values| values.map(position)) else { continue };
        let marker = marker_of(method.formula);
        chart.line(&[[low, y], [high, y]], marker.color, 2.5);
        marker.draw(chart, [middle, y], method.digits);
    }
}
