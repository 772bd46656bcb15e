//! The plot of error against run time, both logarithmic: a mark for each method, a line through the
//! precisions of each formula, and the Pareto front, as in the plots that are written to files.

use egui::{Align2, Color32, RichText, Ui};
use egui_plot::{
    GridInput, GridMark, HLine, HoverPosition, Line, LineStyle, MarkerShape, Plot, PlotUi, Points,
    Text,
};
use pinhole_core::methods::Method;

use super::table::color_of;
use crate::model::number::{power_of_ten, short};
use crate::report::columns;
use crate::report::model::{Case, Digits, MethodRow, NO_DIGIT, SINGLE};
use crate::report::summary::{Summary, Worst, front};
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::accuracy::WRONG;
use crate::view::typesetting::theme;

/// Position of errors of zero: two decades below one ulp.
const EXACT: f64 = -2.0;

/// Half the width of a mark, in points.
const RADIUS: f32 = 7.5;

/// The colour of the Pareto front, behind the marks.
const FRONT: Color32 = Color32::from_rgba_premultiplied(0x38, 0x44, 0x58, 0x60);

/// A method in the plot.
struct Mark<'a> {
    row: &'a MethodRow,
    /// Powers of ten of nanoseconds and of ulps of `f64`.
    at: [f64; 2],
    color: Color32,
}

/// Shows the plot of a case.
pub(super) fn ui(ui: &mut Ui, case: &Case) {
    // In greys, only the ring marks a wrong method.
    let wrong = theme::finished(ui, WRONG);
    let mark = |row| Some(Mark { row, at: point_of(row)?, color: color_of(ui, row) });
    let marks: Vec<Mark> = case.methods.iter().filter_map(mark).collect();
    let hover = |hover: &HoverPosition<'_>| match hover {
        HoverPosition::NearDataPoint { plot_name, .. } => {
            case.methods.iter().find(|row| row.name == *plot_name).map(description)
        }
        HoverPosition::Elsewhere { .. } => None,
    };
    let shown = Plot::new("error against time")
        .x_axis_label("nanoseconds a pixel")
        .y_axis_label("largest error in t, ulps of f64")
        .x_axis_formatter(|mark, _| short(10f64.powf(mark.value)))
        .y_axis_formatter(|mark, _| error_text(mark.value))
        .x_grid_spacer(|input| times(&input))
        .y_grid_spacer(|input| errors(&input))
        .label_formatter(hover)
        .grid_color(ui.visuals().text_color().gamma_multiply(0.25))
        .show_crosshair(false)
        .allow_scroll(false)
        .set_margin_fraction(egui::vec2(0.1, 0.08))
        .include_y(EXACT)
        .include_y(1.0)
        .show(ui, |plot| {
            for (ulp, name) in [(1.0, "one ulp of f64"), (SINGLE, "one ulp of f32")] {
                let line = HLine::new(name, f64::log10(ulp)).allow_hover(false);
                plot.hline(line.color(Color32::GRAY).style(LineStyle::dashed_loose()));
            }
            // At the position of a mark, so that the plot gets no wider for the text.
            if let Some(left) = marks.iter().map(|mark| mark.at[0]).reduce(f64::min) {
                let at = [left, SINGLE.log10()].into();
                let name = RichText::new("one ulp of f32").size(13.0);
                let name = Text::new("name of the line", at, name);
                plot.text(name.color(Color32::GRAY).anchor(Align2::LEFT_BOTTOM).allow_hover(false));
            }
            draw_front(plot, &Summary::new(vec![case]), &marks);
            draw_curves(plot, &marks);
            // The first method is on top, as in the plots that are written to files.
            marks.iter().rev().for_each(|mark| draw(plot, mark, wrong));
        });
    let response = shown.response.with_role(egui::accesskit::Role::Image);
    response.named("Every method's error against its time");
}

/// Draws the stairs of the Pareto front.
fn draw_front(plot: &mut PlotUi, summary: &Summary, marks: &[Mark]) {
    let at =
        |worst: &Worst| marks.iter().find(|mark| mark.row.name == worst.name).map(|mark| mark.at);
    let front: Vec<[f64; 2]> = front(&summary.methods).into_iter().filter_map(at).collect();
    let corners = front.windows(2).flat_map(|pair| [pair[0], [pair[1][0], pair[0][1]]]);
    let stairs: Vec<[f64; 2]> = corners.chain(front.last().copied()).collect();
    // Each step by itself: egui's wide lines have no clean corners.
    for step in stairs.windows(2) {
        let line = Line::new("Pareto front", step.to_vec()).allow_hover(false);
        plot.line(line.color(FRONT).width(0.8 * RADIUS));
    }
}

/// Draws a line through the precisions of each formula.
fn draw_curves(plot: &mut PlotUi, marks: &[Mark]) {
    for first in marks {
        let formula = first.row.formula();
        let mut own: Vec<&Mark> =
            marks.iter().filter(|mark| mark.row.formula() == formula).collect();
        if own[0].row.name != first.row.name {
            continue;
        }
        own.sort_by_key(|mark| mark.row.digits());
        let points: Vec<[f64; 2]> = own.iter().map(|mark| mark.at).collect();
        let line = Line::new(format!("{formula} in all precisions"), points).allow_hover(false);
        plot.line(line.color(first.color).width(1.5));
    }
}

fn draw(plot: &mut PlotUi, mark: &Mark, wrong: Color32) {
    let Mark { row, at, color } = mark;
    let points = Points::new(row.name.clone(), vec![*at]).shape(shape_of(row));
    plot.points(points.filled(!row.is_single()).color(*color).radius(RADIUS));
    if row.wrong > 0 {
        let ring = Points::new(format!("{}, wrong", row.name), vec![*at]).allow_hover(false);
        let ring = ring.shape(MarkerShape::Circle).filled(false);
        plot.points(ring.color(wrong).radius(1.7 * RADIUS));
    }
}

/// Returns the position of a method; `None` before it was timed, or without any common hit.
fn point_of(row: &MethodRow) -> Option<[f64; 2]> {
    let time = row.ns_per_pixel.min.filter(|time| *time > 0.0)?;
    let error = row.ulp_f64.max?;
    // Beyond, no digit is right: how few is nothing to compare.
    let error = error.min(NO_DIGIT);
    let error = if error > 0.0 { error.log10().max(EXACT + 0.5) } else { EXACT };
    Some([time.log10(), error])
}

fn shape_of(row: &MethodRow) -> MarkerShape {
    match row.formula() {
        "ladder" => MarkerShape::Asterisk,
        "half-b" if row.digits() == Digits::DoubleDouble => MarkerShape::Plus,
        "half-b" => MarkerShape::Square,
        "kahan" => MarkerShape::Up,
        "perpendicular" => MarkerShape::Diamond,
        "closest-point" => MarkerShape::Down,
        "recentred" => MarkerShape::Left,
        "lagrange" => MarkerShape::Right,
        _ => MarkerShape::Circle,
    }
}

/// Returns the description of a method under the pointer.
fn description(row: &MethodRow) -> String {
    let number = |x: Option<f64>| x.map_or("-".to_owned(), short);
    let mut lines = vec![
        row.name.clone(),
        format!("{} ns a pixel", number(row.ns_per_pixel.min)),
        format!("t off by at most {} ulps of f64", number(row.ulp_f64.max)),
        format!("{} of {} decisions wrong", row.wrong, row.decisions),
    ];
    if let Some(method) = Method::from_name(&row.name) {
        // The plot does not wrap them.
        lines.extend(columns::lines(method.about(), 60));
        lines.extend(columns::lines(method.source(), 60));
    }
    lines.join("\n")
}

fn error_text(exponent: f64) -> String {
    if exponent == EXACT {
        return "exact".to_owned();
    }
    power_of_ten(exponent.round() as i32)
}

/// Returns grid marks at 1, 2 and 5 times powers of ten, or only at powers if those would be too
/// many.
fn times(input: &GridInput) -> Vec<GridMark> {
    let (low, high) = input.bounds;
    let digits: &[f64] = if high - low > 2.5 { &[1.0] } else { &[1.0, 2.0, 5.0] };
    let decades = low.floor() as i32..=high.ceil() as i32;
    let values = decades.flat_map(|e| digits.iter().map(move |d| f64::from(e) + d.log10()));
    // All lines have the same thickness, so that all get a number.
    let values = values.filter(|value| (low..=high).contains(value));
    values.map(|value| GridMark { value, step_size: 1.0 }).collect()
}

/// Returns grid marks at the position of zero errors and at powers of ten, few enough to be read.
fn errors(input: &GridInput) -> Vec<GridMark> {
    let (low, high) = input.bounds;
    let step = ((high - low) / 6.0).ceil().max(1.0) as usize;
    let powers = (0..=high.max(0.0).ceil() as i32).step_by(step).map(f64::from);
    let marks = std::iter::once(EXACT).chain(powers);
    let marks = marks.filter(|value| (low..=high).contains(value));
    marks.map(|value| GridMark { value, step_size: step as f64 }).collect()
}
