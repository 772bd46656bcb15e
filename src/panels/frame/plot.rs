//! What the last frames took, a bar a frame, the parts on top of each other.

use egui::{Color32, Stroke, Ui};
use egui_plot::{Bar, BarChart, HLine, LineStyle, Plot, PlotBounds};

use super::ms;
use crate::frame_times::{FrameHistory, FrameRecord, KEPT, Part};
use crate::panels::look;

/// What a frame may take at 60 frames a second, in milliseconds.
const SMOOTH: f64 = 1000.0 / 60.0;

/// The plot shows at least this much, in milliseconds: a frame that is fast enough looks small.
const LEAST: f64 = 20.0;

/// Shows the plot.
pub(super) fn ui(ui: &mut Ui, frames: &FrameHistory) {
    let records: Vec<&FrameRecord> = frames.records().collect();
    let top = top(&records);
    let right = KEPT as f64;
    let line = ui.visuals().text_color();
    let mut index = 0..;
    let colors =
        Part::ALL.map(|part| look::plotted(ui, part.color(), index.next().unwrap_or_default()));
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

/// The upper end in milliseconds: a little above the slowest frame, so that no bar is cut off.
fn top(records: &[&FrameRecord]) -> f64 {
    records.iter().map(|r| 1.05e3 * r.total().as_secs_f64()).fold(LEAST, f64::max)
}
