//! The frame view: below both views what the last new picture took, what those before it took, and
//! what the pictures left out.

mod counts;
mod plot;

use egui::{Color32, Grid, Rect, RichText, Ui, UiBuilder, pos2, vec2};

use crate::ui::frame_times::{FrameHistory, Part};
use crate::view::derive::Derived;
use crate::view::typesetting::theme;

/// Size of the text, in points: for the back row.
const TEXT: f32 = 15.0;

/// The counts need no more width than this, in points; times and plot get the rest.
const COUNTS: f32 = 476.0;

impl Part {
    /// Its name on the screen.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Part::Plan => "plan",
            Part::Trace => "trace",
            Part::Overlay => "overlay",
            Part::Readouts => "readouts",
            Part::Interface => "interface",
            Part::Upload => "upload",
            Part::Paint => "paint",
        }
    }

    fn about(self) -> &'static str {
        match self {
            Part::Plan => "Deciding what the rows of both pictures can see",
            Part::Trace => "What each pixel's ray hits first, and its colour, for both pictures",
            Part::Overlay => {
                "Showing the camera's pixels as pixels, and drawing basis, viewport, rays and \
                 marks over both pictures"
            }
            Part::Readouts => "The numbers: the selected ray, its hits, the ledger or the plot",
            Part::Interface => "Panels and layout of the window, with all text set",
            Part::Upload => "Taking the new pictures over to where the window is drawn",
            Part::Paint => "Drawing the window and handing it to the display",
        }
    }

    /// Told apart by every eye, on light and on dark (Okabe and Ito 2008).
    fn color(self) -> Color32 {
        let [r, g, b] = match self {
            Part::Plan => [0x56, 0xb4, 0xe9],
            Part::Trace => [0xe6, 0x9f, 0x00],
            Part::Overlay => [0x00, 0x9e, 0x73],
            Part::Readouts => [0xf0, 0xe4, 0x42],
            Part::Interface => [0xcc, 0x79, 0xa7],
            Part::Upload => [0xd5, 0x5e, 0x00],
            Part::Paint => [0x00, 0x72, 0xb2],
        };
        Color32::from_rgb(r, g, b)
    }
}

/// Shows times, their history, and counts.
pub(crate) fn ui(ui: &mut Ui, frames: &FrameHistory, derived: &Derived) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    let area = ui.available_rect_before_wrap();
    let middle = area.right() - COUNTS.min(0.56 * area.width());
    let left = Rect::from_min_max(area.min, pos2(middle - 8.0, area.bottom() - 4.0));
    let right = Rect::from_min_max(pos2(middle + 8.0, area.top()), area.max);
    ui.scope_builder(UiBuilder::new().max_rect(left), |ui| {
        times(ui, frames);
        plot::ui(ui, frames);
    });
    ui.scope_builder(UiBuilder::new().max_rect(right), |ui| counts::ui(ui, derived));
}

/// The last new picture's times; they name the colours of the plot below.
fn times(ui: &mut Ui, frames: &FrameHistory) {
    let last = frames.last();
    let total = match last {
        Some(last) => format!("Last new picture took {} ms", ms(last.total().as_secs_f64())),
        None => "No new picture yet: drag something".to_owned(),
    };
    ui.label(RichText::new(total).size(TEXT + 3.0).strong()).on_hover_text(
        "Frames that show a new picture are counted, from input to display without waiting for it",
    );
    Grid::new("times").num_columns(3).spacing([14.0, 2.0]).show(ui, |ui| {
        for (index, part) in Part::ALL.into_iter().enumerate() {
            let time = last.and_then(|last| last.time(part));
            let time = time.map_or("-".to_owned(), |time| ms(time.as_secs_f64()));
            ui.horizontal(|ui| {
                let (mark, _) = ui.allocate_exact_size(vec2(13.0, 13.0), egui::Sense::hover());
                let color = theme::plotted(ui, part.color(), index);
                ui.painter().rect_filled(mark, 2.0, color);
                let label = ui.label(format!("{} {time}", part.name()));
                label.on_hover_text(format!("{}, in milliseconds", part.about()));
            });
            if index % 3 == 2 {
                ui.end_row();
            }
        }
    });
}

/// Seconds as milliseconds, two decimals below ten: as wide on the next frame as on this one.
fn ms(seconds: f64) -> String {
    let ms = 1e3 * seconds;
    if ms < 9.995 { format!("{ms:.2}") } else { format!("{ms:.1}") }
}

#[cfg(test)]
mod tests {
    #[test]
    fn milliseconds() {
        let cases = [(0.0, "0.00"), (0.00123, "1.23"), (0.009_996, "10.0"), (0.1234, "123.4")];
        for (seconds, text) in cases {
            assert_eq!(super::ms(seconds), text);
        }
    }
}
