//! What the last frames took, a bar a frame, the parts on top of each other.

use egui::{Align2, Color32, RichText, Stroke, Ui};
use egui_plot::{Bar, BarChart, HLine, LineStyle, Plot, PlotBounds, PlotPoint, Text};

use super::ms;
use crate::ui::frame_times::{FrameHistory, FrameRecord, KEPT, Part};
use crate::view::typesetting::theme;

/// What a frame may take at 60 frames a second, in milliseconds.
const SMOOTH: f64 = 1000.0 / 60.0;

/// The plot shows at least this much, in milliseconds: a frame that is fast enough looks small.
const LEAST: f64 = 20.0;

/// It shows at most so many times what half of the frames take: one that takes as long as none besides,
/// as the first does, makes no others small. How long it took is written on its bar.
const MOST: f64 = 5.0;

/// Shows the plot.
pub(super) fn ui(ui: &mut Ui, frames: &FrameHistory) {
    let records: Vec<&FrameRecord> = frames.records().collect();
    let top = top(&records);
    let right = KEPT as f64;
    let line = ui.visuals().text_color();
    let mut index = 0..;
    let colors =
        Part::ALL.map(|part| theme::plotted(ui, part.color(), index.next().unwrap_or_default()));
    let shown = Plot::new("frame times")
        .x_axis_label("the last 200 new pictures; dashed: 16.7 ms")
        .y_axis_label("ms")
        .show_axes([true, true])
        .x_axis_formatter(|_, _| String::new())
        .grid_color(line.gamma_multiply(0.2))
        .show_grid([false, true])
        .show_crosshair(false)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .show(ui, |plot| {
            plot.set_plot_bounds(PlotBounds::from_min_max([0.0, 0.0], [right, top]));
            let mut charts: Vec<BarChart> = Vec::new();
            for (part, color) in Part::ALL.into_iter().zip(colors) {
                let below: Vec<&BarChart> = charts.iter().collect();
                let chart = chart(part, color, &records).stack_on(&below);
                charts.push(chart);
            }
            charts.into_iter().for_each(|chart| plot.bar_chart(chart));
            for (x, text) in cut_off(&records, top) {
                let place = PlotPoint::new(x, top);
                let text = Text::new("longer", place, RichText::new(text).strong());
                let anchor = if x < right / 2.0 { Align2::LEFT_TOP } else { Align2::RIGHT_TOP };
                plot.text(text.anchor(anchor).color(line).allow_hover(false));
            }
            let smooth = HLine::new("60 frames a second", SMOOTH).allow_hover(false);
            plot.hline(smooth.color(line).width(2.0).style(LineStyle::dashed_loose()));
        });
    ui.ctx().accesskit_node_builder(shown.response.id, |node| {
        node.set_role(egui::accesskit::Role::Image);
        node.set_label("The last frames' times, part by part");
    });
}

/// The bars of one part, the last frame's at the right end.
fn chart(part: Part, color: Color32, records: &[&FrameRecord]) -> BarChart {
    let first = KEPT - records.len();
    let bars = records.iter().enumerate().map(|(index, record)| {
        let time = 1e3 * record.time(part).unwrap_or_default().as_secs_f64();
        Bar::new((first + index) as f64 + 0.5, time).width(1.0).fill(color).stroke(Stroke::NONE)
    });
    let description =
        move |bar: &Bar, _: &BarChart| format!("{} {} ms", part.name(), ms(1e-3 * bar.value));
    BarChart::new(part.name(), bars.collect()).color(color).element_formatter(Box::new(description))
}

fn total(record: &FrameRecord) -> f64 {
    1e3 * record.total().as_secs_f64()
}

/// The upper end in milliseconds: a little above the slowest frame that is not cut off.
fn top(records: &[&FrameRecord]) -> f64 {
    let mut totals: Vec<f64> = records.iter().map(|record| total(record)).collect();
    totals.sort_unstable_by(f64::total_cmp);
    let most = totals.get(totals.len() / 2).map_or(LEAST, |median| (MOST * median).max(LEAST));
    let slowest = totals.into_iter().rfind(|total| *total <= most).unwrap_or_default();
    (1.05 * slowest).max(LEAST)
}

/// Where the bars are that go on above the plot, and how long they are.
fn cut_off(records: &[&FrameRecord], top: f64) -> Vec<(f64, String)> {
    let first = KEPT - records.len();
    let places = records.iter().enumerate();
    places
        .filter(|(_, record)| total(record) > top)
        .map(|(index, record)| {
            let text = format!("{} ms", ms(1e-3 * total(record)));
            ((first + index) as f64 + 0.5, text)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;
    use crate::ui::frame_times::WorkTimes;

    fn record(milliseconds: u64) -> FrameRecord {
        let work = WorkTimes { trace: Duration::from_millis(milliseconds), ..WorkTimes::default() };
        FrameRecord::of(0, work)
    }

    #[test]
    fn one_frame_that_takes_long_makes_no_others_small() {
        let records: Vec<FrameRecord> = [900, 10, 12, 11, 30, 10].map(record).into();
        let records: Vec<&FrameRecord> = records.iter().collect();
        let top = top(&records);
        assert!((top - 31.5).abs() < 1e-9, "{top}");
        let place = (KEPT - records.len()) as f64 + 0.5;
        assert_eq!(cut_off(&records, top), [(place, "900.0 ms".to_owned())]);
    }

    #[test]
    fn no_frame_and_fast_frames_leave_the_line_of_60_a_second() {
        assert_eq!(top(&[]), LEAST);
        assert_eq!(top(&[&record(1)]), LEAST);
        assert_eq!(cut_off(&[&record(1)], LEAST), []);
    }
}
