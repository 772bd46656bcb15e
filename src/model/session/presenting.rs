//! Presenter mode: its theme, the size of its text, the state to which it returns, and the pen's strokes
//! over the views.

use pinhole_figure::typesetting::theme::WRITTEN;

use crate::model::session::{ThemeName, ViewLayout};

/// Number of decimals while presenting, low enough that the numbers are legible from the back row.
pub(crate) const PRESENTED_DECIMALS: usize = 3;

/// Presenter mode while it is on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Presenting {
    /// The layout that fills the window because the presenter chose it by a key, and the layout that it
    /// replaced.
    pub replaced: Option<(ViewLayout, ViewLayout)>,
    /// The window's theme meanwhile.
    pub theme: ThemeName,
    /// True while the screen is black.
    pub is_blank: bool,
}

impl Presenting {
    /// Begins presenting. The theme is light, since a dark ground is hard to see in a bright hall.
    pub fn begin() -> Presenting {
        Presenting { theme: ThemeName::Light, ..Presenting::default() }
    }

    /// Fills the window with the views of the layout `full`. For the camera view, which swaps places with the
    /// world view on a lesson's stage, does so back and forth.
    pub fn fill(&mut self, full: ViewLayout, layout: &mut ViewLayout) {
        if full == ViewLayout::Camera && self.is_swapped(*layout) {
            *layout = self.before(*layout);
            self.replaced = None;
            return;
        }
        self.replaced = Some((full, self.before(*layout)));
        *layout = full;
    }

    /// Returns true if the camera view has replaced a layout that shows the world view, too. `now` is the
    /// current layout.
    pub fn is_swapped(&self, now: ViewLayout) -> bool {
        let before = self.replaced.filter(|(own, _)| *own == now && now == ViewLayout::Camera);
        before.is_some_and(|(_, before)| before != ViewLayout::Camera)
    }

    /// Returns the layout to restore: the one that was replaced or, if a lesson's step has set another
    /// layout in the meantime, that one, which is `now`.
    pub fn before(&self, now: ViewLayout) -> ViewLayout {
        self.replaced.filter(|(own, _)| *own == now).map_or(now, |(_, before)| before)
    }
}

/// The range of the minimum text size, in points.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    /// The minimum.
    pub least: f32,
    /// The default.
    pub usual: f32,
    /// The maximum.
    pub most: f32,
    /// Step from one value to the next.
    pub step: f32,
}

/// The range of [`crate::model::session::Preferences::smallest_text`].
pub const SMALLEST_TEXT: Range = Range { least: 12.0, usual: 20.0, most: 36.0, step: 2.0 };

/// The window size to which [`crate::model::session::Preferences::smallest_text`] refers, in points: that of a
/// projector.
const PROJECTOR: [f32; 2] = [1229.0, 768.0];

/// Returns the window's zoom while presenting, at which no text is smaller than `smallest_text` on a
/// projector. In a larger or smaller window, everything is larger or smaller in proportion, but no text is
/// smaller than [`WRITTEN`]. `window` is the window's size in points without zoom, or zero if it is not
/// known.
pub fn zoom(window: [f32; 2], smallest_text: f32) -> f32 {
    let in_proportion = (window[0] / PROJECTOR[0]).min(window[1] / PROJECTOR[1]);
    let in_proportion = if in_proportion > 0.0 { in_proportion } else { 1.0 };
    (in_proportion * smallest_text / WRITTEN).max(1.0)
}

/// The pen, and the strokes drawn over the views since it was taken up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pen {
    /// The strokes.
    pub strokes: Vec<PenStroke>,
    /// Number of the pen's colour, below [`PEN_COLORS`].
    pub color: usize,
}

/// Number of the pen's colours.
pub const PEN_COLORS: usize = 3;

/// A stroke of the pen.
#[derive(Clone, Debug, PartialEq)]
pub struct PenStroke {
    /// Number of its colour.
    pub color: usize,
    /// The corners of its polyline, as fractions of the drawing area's width and height.
    pub points: Vec<[f32; 2]>,
}

impl Pen {
    /// Begins a stroke.
    pub fn press(&mut self, at: [f32; 2]) {
        self.strokes.push(PenStroke { color: self.color, points: vec![at] });
    }

    /// Extends the last stroke to this point.
    pub fn draw_to(&mut self, to: [f32; 2]) {
        let last = self.strokes.last_mut().map(|stroke| &mut stroke.points);
        if let Some(points) = last.filter(|points| points.last() != Some(&to)) {
            points.push(to);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_layout_from_before_comes_back_unless_another_one_was_set() {
        let mut presenting = Presenting::default();
        let mut layout = ViewLayout::Plot;
        presenting.fill(ViewLayout::Camera, &mut layout);
        presenting.fill(ViewLayout::DerivationAlone, &mut layout);
        assert_eq!(layout, ViewLayout::DerivationAlone);
        assert_eq!(presenting.before(layout), ViewLayout::Plot);
        assert_eq!(presenting.before(ViewLayout::Mistakes), ViewLayout::Mistakes);
        layout = ViewLayout::Mistakes;
        presenting.fill(ViewLayout::World, &mut layout);
        assert_eq!(presenting.before(layout), ViewLayout::Mistakes);
    }

    #[test]
    fn text_grows_with_the_window_and_is_never_too_small_to_read() {
        assert_eq!(zoom([1280.0, 768.0], 2.0 * WRITTEN), 2.0);
        assert_eq!(zoom([614.5, 768.0], 4.0 * WRITTEN), 2.0);
        assert_eq!(zoom([640.0, 480.0], WRITTEN), 1.0);
        assert_eq!(zoom([4096.0, 1536.0], WRITTEN), 2.0);
    }
}
