//! A panel's frame, the numbers along it, and text around it.

use egui::{Align, Color32};

use super::axis::Tick;
use crate::figures::chart::{Chart, plain};
use crate::report::columns::lines;

pub(crate) const TEXT: Color32 = Color32::from_gray(0x1a);
pub(crate) const WEAK: Color32 = Color32::from_gray(0x5a);
pub(crate) const FRAME: Color32 = Color32::from_gray(0x70);
pub(crate) const GRID: Color32 = Color32::from_gray(0xe4);

/// Margin around all panels.
pub(crate) const MARGIN: f64 = 28.0;

/// The size of the numbers at a scale.
pub(crate) const SMALL: f64 = 16.0;

/// Right of panels: room for the names of lines.
pub(crate) const GAP: f64 = 68.0;

/// The frame of a panel, in points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

/// Draws the vertical lines with their numbers below, and the name of the scale.
pub(crate) fn across(chart: &mut Chart, frame: Frame, ticks: Vec<Tick>, name: &str) {
    for Tick { at, text } in ticks {
        chart.line(&[[at, frame.top], [at, frame.bottom]], GRID, 1.0);
        chart.text([at, frame.bottom + 16.0], Align::Center, plain(SMALL), TEXT, text);
    }
    let y = frame.bottom + 40.0;
    let (width, needed) = (frame.right - frame.left, text_width(name, NAME));
    if needed <= width {
        let middle = 0.5 * (frame.left + frame.right);
        chart.text([middle, y], Align::Center, plain(NAME), TEXT, name);
    } else {
        // A long name goes on to the right, and to the left as far as its neighbour lets it; it gets
        // smaller where it must.
        let size = (NAME * (width + GAP + 50.0) / needed).min(NAME);
        chart.text([frame.right + GAP, y], Align::RIGHT, plain(size), TEXT, name);
    }
}

/// The size of the name of a scale.
const NAME: f64 = 18.0;

/// Estimated width of a text, rather more than less: Noto Sans needs half its size for a character.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    0.51 * size * text.chars().count() as f64
}

/// Writes text over as many lines as it needs; returns where the next may stand.
pub(crate) fn paragraph(chart: &mut Chart, mut y: f64, size: f64, text: &str) -> f64 {
    // Noto Sans needs half its size for a character, and a little less in long texts.
    let most = ((chart.width - 2.0 * MARGIN) / (0.53 * size)) as usize;
    for line in lines(text, most) {
        chart.text([MARGIN, y], Align::LEFT, plain(size), WEAK, line);
        y += 1.5 * size;
    }
    y
}
