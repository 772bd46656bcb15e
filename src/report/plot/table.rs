//! The table of methods, which is on every page except those that show families. Each method has a row
//! with its mark, its formula in words, and its wrong decisions. For several scenes or families, the
//! row also shows the method's errors and times, each as a line from the smallest to the largest value.

use egui::{Align2, Painter, Pos2, Rect, pos2, vec2};
use pinhole_figure::chart::{Scale, columns};
use pinhole_lecture::numbers::{grouped, short_plain};

use super::marker::{WRONG, in_words, marker_of};
use super::{BAND, FRAME, GRID, MARGIN, PAGE, SMALL, TEXT, WEAK, bold, plain};
use crate::report::summary::{MethodOverall, MethodSummary, Overall, Summary, least_middle_most};
use crate::report::table::lines;

/// Width of the table without errors and times, in points.
pub(super) const WIDTH: f32 = 512.0;

/// Height of a row, in points.
const ROW: f32 = 23.0;

/// Distance from the table's left edge to the column with the formulas in words, in points.
const WORDS: f32 = 178.0;

/// Distances of the left and the right edge of the column of errors from the left edge of the page, in
/// points.
const ERROR: [f32; 2] = [590.0, 885.0];
/// Distances of the left and the right edge of the column of times from the left edge of the page, in
/// points.
const TIME: [f32; 2] = [930.0, 1240.0];

/// A row of the table.
struct TableRow<'a> {
    method: &'a MethodSummary<'a>,
    /// The method's number or fraction of wrong decisions, as text.
    wrong: String,
    is_wrong: bool,
}

/// Draws the table for a scene.
pub(super) fn of_scene<'a>(painter: &Painter, at: Pos2, summary: &'a Summary<'a>) {
    let methods = &summary.methods;
    let place = |worst: &&MethodSummary| {
        (methods.iter().position(|other| other.formula == worst.formula), worst.digits)
    };
    let mut sorted: Vec<&MethodSummary> = methods.iter().collect();
    sorted.sort_by_key(place);
    let row = |method: &'a MethodSummary<'a>| {
        let (wrong, is_wrong) = (grouped(method.wrong), method.wrong > 0);
        TableRow { method, wrong, is_wrong }
    };
    let rows: Vec<TableRow> = sorted.into_iter().map(row).collect();
    let decisions = methods.iter().map(|method| method.decisions).max().unwrap_or(0);
    table(painter, at, WIDTH, &rows, &format!("of {} compared", grouped(decisions)));
}

/// Draws the table for all scenes or families. Returns the position of its lower edge.
pub(super) fn of_all<'a>(painter: &Painter, at: Pos2, all: &Overall<'a>) -> f32 {
    let Overall { methods, noun, shared } = all;
    let row = |method: &MethodOverall<'a>| {
        let wrong = match method.share {
            None => "-".to_owned(),
            Some(0.0) => "0 %".to_owned(),
            // A share that is not zero is never rounded to 0 %.
            Some(share) => format!("{} %", short_plain(((1e5 * share).round() / 1e3).max(1e-3))),
        };
        TableRow { method: method.first, wrong, is_wrong: method.wrong > 0 }
    };
    let rows: Vec<TableRow> = methods.iter().map(row).collect();
    let about = format!("mean share, {shared} {noun}");
    let body = table(painter, at, PAGE.x - 2.0 * MARGIN, &rows, &about);
    let spread = format!("least to most of {shared} {noun} that all have");
    let head = |x: f32, name: &str, about: &str| {
        painter.text(pos2(x, at.y), Align2::LEFT_CENTER, name, bold(17.0), TEXT);
        painter.text(pos2(x, at.y + 20.0), Align2::LEFT_CENTER, about, plain(SMALL), WEAK);
    };
    head(ERROR[0], "largest error in t, ulps of f64", &spread);
    head(TIME[0], "nanoseconds a pixel", "mark: the one in the middle");
    let errors: Vec<_> = methods.iter().map(|method| method.errors()).collect();
    let times: Vec<_> = methods.iter().map(|method| least_middle_most(&method.times)).collect();
    for (across, values) in [(ERROR, errors), (TIME, times)] {
        let rect = Rect::from_x_y_ranges(across[0]..=across[1], body.y_range());
        spreads(painter, rect, &rows, &values);
    }
    body.bottom() + 30.0
}

/// Draws the rows. Returns the area that they cover.
fn table(painter: &Painter, at: Pos2, width: f32, rows: &[TableRow], about: &str) -> Rect {
    let right = at.x + WIDTH;
    painter.text(at, Align2::LEFT_CENTER, "method", bold(17.0), TEXT);
    painter.text(pos2(right, at.y), Align2::RIGHT_CENTER, "wrong decisions", bold(17.0), TEXT);
    painter.text(pos2(right, at.y + 20.0), Align2::RIGHT_CENTER, about, plain(SMALL), WEAK);
    let size = vec2(width, ROW * rows.len() as f32);
    let body = Rect::from_min_size(at + vec2(0.0, 38.0), size);
    let mut y = body.top();
    let is_same = |a: &TableRow, b: &TableRow| a.method.formula == b.method.formula;
    for (index, formula) in rows.chunk_by(is_same).enumerate() {
        if index % 2 == 0 {
            let size = vec2(width + 12.0, ROW * formula.len() as f32);
            painter.rect_filled(Rect::from_min_size(pos2(at.x - 6.0, y), size), 0.0, BAND);
        }
        let words = lines(in_words(formula[0].method.formula), 38);
        for (k, row) in formula.iter().enumerate() {
            let middle = y + 0.5 * ROW;
            let text = |x: f32, align: Align2, text: &str, font, color| {
                painter.text(pos2(x, middle), align, text, font, color);
            };
            let MethodSummary { name, formula, digits, .. } = *row.method;
            marker_of(formula).draw(painter, pos2(at.x + 8.0, middle), digits);
            text(at.x + 24.0, Align2::LEFT_CENTER, name, plain(17.0), TEXT);
            let words = words.get(k).map_or("", String::as_str);
            text(at.x + WORDS, Align2::LEFT_CENTER, words, plain(13.0), WEAK);
            let (font, color) =
                if row.is_wrong { (bold(17.0), WRONG) } else { (plain(17.0), WEAK) };
            text(right, Align2::RIGHT_CENTER, &row.wrong, font, color);
            y += ROW;
        }
    }
    body
}

/// Draws, for each method, a line from its smallest to its largest value, with its mark at the median.
/// The values 0 and infinity are drawn beyond the ends of the logarithmic scale.
fn spreads(painter: &Painter, rect: Rect, rows: &[TableRow], values: &[Option<[f64; 3]>]) {
    let all = || values.iter().flatten().flatten().copied();
    let end = if all().any(f64::is_infinite) { rect.right() - 44.0 } else { rect.right() };
    let scale = Scale::decades(all(), [rect.left() + 26.0, end]);
    let position = |value: f64| match value {
        0.0 => rect.left() + 8.0,
        f64::INFINITY => rect.right() - 14.0,
        value => scale.position(value),
    };
    columns(painter, rect, &scale.ticks(44.0), GRID);
    for (value, name) in [(0.0, "0"), (f64::INFINITY, "none")] {
        if all().any(|other| other == value) {
            let at = pos2(position(value), rect.bottom() + 3.0);
            painter.text(at, Align2::CENTER_TOP, name, plain(SMALL), TEXT);
        }
    }
    painter.hline(rect.x_range(), rect.bottom(), (1.5, FRAME));
    for (index, (row, values)) in rows.iter().zip(values).enumerate() {
        let Some([low, middle, high]) = values.map(|values| values.map(position)) else { continue };
        let y = rect.top() + ROW * (index as f32 + 0.5);
        let marker = marker_of(row.method.formula);
        painter.hline(low..=high, y, (2.5, marker.color));
        marker.draw(painter, pos2(middle, y), row.method.digits);
    }
}
