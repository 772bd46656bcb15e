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
pub(crate) const SMALL: f64 = 14.0;

/// The frame of a panel, in points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

/// Draws the vertical lines with their numbers, of this size, below, and the name of the scale.
pub(crate) fn across(chart: &mut Chart, frame: Frame, ticks: Vec<Tick>, size: f64, name: &str) {
    // A number that would touch the one before, or the next panel's, is left out.
    let gap = size - 8.0;
    let mut free = frame.left - gap;
    for Tick { at, text } in ticks {
        chart.line(&[[at, frame.top], [at, frame.bottom]], GRID, 1.0);
        let half = 0.26 * size * text.chars().count() as f64;
        if at - half >= free && at + half <= frame.right + gap {
            chart.text([at, frame.bottom + 13.0], Align::Center, plain(size), TEXT, text);
            free = at + half + gap;
        }
    }
    let middle = [0.5 * (frame.left + frame.right), frame.bottom + 32.0];
    chart.text(middle, Align::Center, plain(SMALL), TEXT, name);
}

/// The size of what is to be read, below the panels.
const READ: f64 = 14.0;

/// Writes text over as many lines as it needs; returns where the next may stand.
pub(crate) fn paragraph(chart: &mut Chart, mut y: f64, text: &str) -> f64 {
    // Noto Sans needs a little less than half its size for a character.
    let most = ((chart.width - 2.0 * MARGIN) / (0.475 * READ)) as usize;
    for line in lines(text, most) {
        chart.text([MARGIN, y], Align::LEFT, plain(READ), WEAK, line);
        y += 1.32 * READ;
    }
    y
}
