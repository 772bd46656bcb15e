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

/// Room between numbers at a scale.
const GAP: f64 = 6.0;

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
    // A number that would touch the one before, or the next panel's, is left out.
    let mut free = frame.left - GAP;
    for Tick { at, text } in ticks {
        chart.line(&[[at, frame.top], [at, frame.bottom]], GRID, 1.0);
        let half = 0.26 * SMALL * text.chars().count() as f64;
        if at - half >= free && at + half <= frame.right + GAP {
            chart.text([at, frame.bottom + 13.0], Align::Center, plain(SMALL), TEXT, text);
            free = at + half + GAP;
        }
    }
    // Noto Sans needs half its size for a character.
    let most = ((frame.right - frame.left) / (0.51 * SMALL)) as usize;
    for (index, line) in lines(name, most).into_iter().enumerate() {
        let middle = [0.5 * (frame.left + frame.right), frame.bottom + 32.0 + 16.0 * index as f64];
        chart.text(middle, Align::Center, plain(SMALL), TEXT, line);
    }
}

/// Writes text over as many lines as it needs; returns where the next may stand.
pub(crate) fn paragraph(chart: &mut Chart, mut y: f64, size: f64, text: &str) -> f64 {
    // Noto Sans needs half its size for a character, and a little less in long texts.
    let most = ((chart.width - 2.0 * MARGIN) / (0.53 * size)) as usize;
    for line in lines(text, most) {
        chart.text([MARGIN, y], Align::LEFT, plain(size), WEAK, line);
        y += 1.35 * size;
    }
    y
}
