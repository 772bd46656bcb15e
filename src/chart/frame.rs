//! A panel's frame, the numbers along it, and text around it.

use super::axis::Tick;
use super::figure::{Align, Figure, Ink};

pub(crate) const TEXT: Ink = [0x1a; 3];
pub(crate) const WEAK: Ink = [0x5a; 3];
pub(crate) const FRAME: Ink = [0x70; 3];
pub(crate) const GRID: Ink = [0xe4; 3];

/// Around all panels.
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

/// The lines up and their numbers, and what they are.
pub(crate) fn across(figure: &mut Figure, frame: Frame, ticks: Vec<Tick>, name: &str) {
    for Tick { at, text } in ticks {
        figure.line(&[[at, frame.top], [at, frame.bottom]], GRID, 1.0);
        figure.text([at, frame.bottom + 16.0], Align::Middle, SMALL, TEXT, text);
    }
    let y = frame.bottom + 40.0;
    let (width, needed) = (frame.right - frame.left, text_width(name, NAME));
    if needed <= width {
        let middle = 0.5 * (frame.left + frame.right);
        figure.text([middle, y], Align::Middle, NAME, TEXT, name.to_owned());
    } else {
        // A long name goes on to the right, and to the left as far as its neighbour lets it; it gets
        // smaller where it must.
        let size = (NAME * (width + GAP + 50.0) / needed).min(NAME);
        figure.text([frame.right + GAP, y], Align::Right, size, TEXT, name.to_owned());
    }
}

/// The size of the name of a scale.
const NAME: f64 = 18.0;

/// How wide a text is about, rather more than less: Noto Sans needs half its size for a character.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    0.51 * size * text.chars().count() as f64
}

/// Text over as many lines as it needs; returns where the next may stand.
pub(crate) fn paragraph(figure: &mut Figure, mut y: f64, size: f64, text: &str) -> f64 {
    // Noto Sans needs half its size for a character, and a little less in long texts.
    let most = ((figure.width - 2.0 * MARGIN) / (0.53 * size)) as usize;
    let mut line = String::new();
    for word in text.split_whitespace() {
        if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > most {
            figure.text([MARGIN, y], Align::Left, size, WEAK, std::mem::take(&mut line));
            y += 1.5 * size;
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    if !line.is_empty() {
        figure.text([MARGIN, y], Align::Left, size, WEAK, line);
        y += 1.5 * size;
    }
    y
}
