//! The report as pictures, similar to work-precision diagrams (Hairer and Wanner, "Solving Ordinary
//! Differential Equations II", section IV.10; SciML's benchmarks). Time is on the x axis and error on
//! the y axis, both logarithmic. Each formula has a curve that connects the precisions in which it is
//! computed.
//!
//! Each page has an aspect ratio of 16:9 and fits on a slide. A scene has one page. A report of several
//! scenes or stress families starts with a summary, with one line per method; families follow, four to
//! a page. A family has a knob, the parameter that makes it easier or harder. One panel shows its
//! largest error over all settings of the knob against time, and a second panel shows the error against
//! the knob.

pub(crate) mod marker;
mod panel;
mod table;

use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Vec2, pos2, vec2};
use pinhole_figure::chart::GridInk;
use pinhole_figure::export::Figure;
use pinhole_figure::typesetting::theme;

use self::panel::Errors;
use super::model::{Digits, Report};
use super::summary::{self, Summary};

const TITLE: &str = "Error against run time";

/// Dots per point in PNG files, which makes the page 1920 dots wide, as wide as a projector's picture.
pub const PNG_SCALE: f32 = 1.5;

/// The size of a page, in points.
const PAGE: Vec2 = vec2(1280.0, 720.0);

/// Margin around all panels.
const MARGIN: f32 = 28.0;

/// Width of the space for the numbers to the left of a panel.
const NUMBERS: f32 = 84.0;
/// Width of the space for the names of horizontal lines to the right of a panel.
const NAMES: f32 = 46.0;

/// Number of families on a page, in two rows and two columns.
const FAMILIES: usize = 4;

const TEXT: Color32 = Color32::from_gray(0x1a);
const WEAK: Color32 = Color32::from_gray(0x5a);
const FRAME: Color32 = Color32::from_gray(0x70);
/// The background of every other formula in a table.
const BAND: Color32 = Color32::from_gray(0xf6);

/// The font size of the numbers on an axis and of other small text.
const SMALL: f32 = 14.0;

const GRID: GridInk = GridInk { line: Color32::from_gray(0xe4), text: TEXT, size: SMALL };

fn plain(size: f32) -> FontId {
    FontId::proportional(size)
}

fn bold(size: f32) -> FontId {
    FontId::new(size, theme::bold())
}

/// A function that draws the contents of a page.
type DrawPage<'a> = Box<dyn Fn(&Painter) + 'a>;

/// Draws a report with `scale` dots per point, as one figure per page.
pub fn pages(report: &Report, scale: f32) -> Vec<Figure> {
    let summaries = summary::summaries(report);
    let (families, scenes): (Vec<&Summary>, Vec<&Summary>) =
        summaries.iter().partition(|summary| summary.has_knob());
    let mut pages: Vec<DrawPage<'_>> = Vec::new();
    if summaries.len() > 1 {
        pages.push(Box::new(|painter| first(painter, report, &summaries)));
    }
    for scene in scenes {
        pages.push(Box::new(move |painter| single(painter, report, scene)));
    }
    for families in families.chunks(FAMILIES) {
        pages.push(Box::new(move |painter| grid(painter, families)));
    }
    let figure = |(page, draw): (usize, &DrawPage<'_>)| {
        Figure::draw(TITLE, PAGE, scale, |painter| {
            painter.text(pos2(MARGIN, 28.0), Align2::LEFT_CENTER, TITLE, bold(24.0), TEXT);
            if pages.len() > 1 {
                let (at, note) =
                    (pos2(PAGE.x - MARGIN, 28.0), format!("page {page} of {}", pages.len()));
                painter.text(at, Align2::RIGHT_CENTER, note, plain(16.0), WEAK);
            }
            draw(painter);
        })
    };
    (1..).zip(&pages).map(figure).collect()
}

/// Text that explains the marks of a panel.
const MARKS: &str = "Down and left is better. A line joins a formula's precisions: hollow (and dashed over \
    a knob) f32, filled f64, framed double-double. Red ring: also decided wrong (hit or miss, which \
    object is first, or another root of it); such rays are in no error.";

/// Text that explains the panels of a family.
const SETTINGS: &str = "Left: worst error of all settings, the middle of their times; bar: least to most. \
    Wide grey line: condition number, the ulps that one rounding of what is given may cost.";

/// Text that explains the panel of a scene.
const ROUNDS: &str = "Time: the shortest of the rounds, which take the methods in turn; the bar ends at \
    their upper quartile.";

/// Text that explains the technical terms.
const WORDS: &str = "Ulp: the spacing of neighbouring numbers; a t off by 1 ulp of f64 has 16 digits right, \
    by 1 ulp of f32 7. Coverage: the share of rays that hit.";

/// Upper edge of a page's content.
const TOP: f32 = 60.0;

/// Draws the page of a scene.
fn single(painter: &Painter, report: &Report, summary: &Summary) {
    let right = PAGE.x - MARGIN - table::WIDTH;
    cell(painter, Rect::from_x_y_ranges(MARGIN..=right - 24.0, TOP..=TOP + 440.0), summary);
    table::of_scene(painter, pos2(right, TOP + 4.0), summary);
    let y = paragraph(painter, TOP + 462.0, MARKS);
    let y = paragraph(painter, y, &format!("{ROUNDS} {WORDS}"));
    foot(painter, y, report);
}

/// Draws the first page of a report with several scenes or families.
fn first(painter: &Painter, report: &Report, summaries: &[Summary]) {
    let all = summary::overall(summaries);
    let bottom = table::of_all(painter, pos2(MARGIN, TOP), &all);
    let wrong = "Wrong: hit or miss, which object is first, or another root of it; such rays are in no \
                 error. None: no digit of t is right, or no hit is.";
    let of_family = match all.noun {
        "families" => {
            " A family's error is that of its worst setting, its time that of the middle one."
        }
        _ => "",
    };
    let y = paragraph(painter, bottom + 2.0, &format!("{wrong}{of_family} {WORDS}"));
    foot(painter, y, report);
}

/// Draws a page with several families.
fn grid(painter: &Painter, families: &[&Summary]) {
    let size = vec2(0.5 * (PAGE.x - 3.0 * MARGIN), 282.0);
    for (index, summary) in families.iter().enumerate() {
        let (column, row) = ((index % 2) as f32, (index / 2) as f32);
        let at = pos2(MARGIN + (size.x + MARGIN) * column, TOP + size.y * row);
        cell(painter, Rect::from_min_size(at, size), summary);
    }
    let below = TOP + 2.0 * size.y;
    legend(painter, below + 10.0, families);
    paragraph(painter, below + 24.0, &format!("{MARKS} {SETTINGS}"));
}

/// Draws the legend: the marks of the families' formulas with their names, in one line.
fn legend(painter: &Painter, y: f32, families: &[&Summary]) {
    let methods = families.iter().flat_map(|summary| &summary.methods);
    let mut at = pos2(MARGIN + 8.0, y);
    for formula in summary::distinct(methods.map(|method| method.formula), |formula| *formula) {
        marker::marker_of(formula).draw(painter, at, Digits::Double);
        at.x += 13.0;
        at.x = painter.text(at, Align2::LEFT_CENTER, formula, plain(16.0), TEXT).right() + 33.0;
    }
}

/// Draws a scene or a family: its name and coverage, its error against time and, if it has a knob, its
/// error against the knob.
fn cell(painter: &Painter, rect: Rect, summary: &Summary) {
    let Some(case) = summary.cases.first() else { return };
    let top = rect.left_top() + vec2(0.0, 4.0);
    let name = if summary.has_knob() { case.name.clone() } else { case.title() };
    painter.text(top, Align2::LEFT_CENTER, name, bold(18.0), TEXT);
    let coverage = format!("coverage {}", summary.coverage());
    let coverage = match summary.cases.len() {
        1 => coverage,
        count => format!("{count} settings, {coverage}"),
    };
    let right = rect.right_top() + vec2(0.0, 4.0);
    painter.text(right, Align2::RIGHT_CENTER, coverage, plain(SMALL), WEAK);
    let about = if case.about.is_empty() { 0.0 } else { 18.0 };
    painter.text(top + vec2(0.0, 20.0), Align2::LEFT_CENTER, &case.about, plain(SMALL), WEAK);
    panels(painter, rect.with_min_y(rect.top() + 15.0 + about), summary, true);
}

/// Draws the panels of a scene or a family, with all labels. If `joins` is true, a line connects a formula's
/// precisions, which needs the words of the page: there is no method between two of them.
pub(crate) fn panels(painter: &Painter, rect: Rect, summary: &Summary, joins: bool) {
    let what = "largest error in t, ulps of f64";
    painter.text(rect.min, Align2::LEFT_TOP, what, plain(SMALL), TEXT);
    let frame = Rect::from_min_max(rect.min + vec2(NUMBERS, 21.0), rect.max - vec2(NAMES, 48.0));
    let errors = Errors::new(summary, frame.y_range());
    errors.name_ulps(painter, frame.right());
    if !summary.has_knob() {
        return panel::time(painter, frame, &errors, summary, joins);
    }
    let (left, right) = frame.split_left_right_at_fraction(0.5);
    panel::knob(painter, right.with_min_x(right.left() + 8.0), &errors, summary);
    panel::time(painter, left.with_max_x(left.right() - 8.0), &errors, summary, joins);
}

/// Writes a text with line breaks. Returns the position of its lower edge.
fn paragraph(painter: &Painter, y: f32, text: &str) -> f32 {
    let galley = painter.layout(text.to_owned(), plain(SMALL), WEAK, PAGE.x - 2.0 * MARGIN);
    let below = y + galley.size().y;
    painter.galley(Pos2::new(MARGIN, y), galley, WEAK);
    below
}

/// Writes the lines at the foot of a page: the reference, the processor, the notes, and the
/// measurements that were left out.
fn foot(painter: &Painter, mut y: f32, report: &Report) {
    let seed = report.seed.map_or(String::new(), |seed| format!("; seed {seed}"));
    for (name, text, more) in [
        ("Reference", &report.reference, ""),
        ("Processor", &report.cpu, seed.as_str()),
        ("Note", &report.notes.join("; "), ""),
    ] {
        if !text.is_empty() {
            y = paragraph(painter, y, &format!("{name}: {text}{more}"));
        }
    }
    if !report.left_out.is_empty() {
        let text = format!("Left out: {} measurements, listed by the table", report.left_out.len());
        paragraph(painter, y, &text);
    }
}
