//! The captions beside the vertical lines of the plot.

use egui::{Align2, Color32, Pos2, Rect, pos2};

use super::drawing::{Strokes, TEXT};
use crate::view::typesetting::label_layout::{Font, LabelLayout};

/// Distance from one position of a caption to the one above it, in points.
const ROW: f32 = 20.0;

/// The names of the eye and of the viewport in the plot.
pub(super) struct Captions {
    pub(super) rect: Rect,
    /// The x coordinates of their lines.
    pub(super) eye: f32,
    pub(super) viewport: f32,
    /// The y coordinate of the line f = 0.
    pub(super) zero: f32,
    pub(super) color: Color32,
}

impl Captions {
    /// Writes the captions where no curve runs through them.
    pub(super) fn write(&self, drawn: &[Strokes], words: &mut LabelLayout) {
        let curves: Vec<Pos2> = self.lines(drawn).collect();
        let right = |x: f32| self.rows(x + 5.0, Align2::LEFT_BOTTOM);
        let left = |x: f32| self.rows(x - 5.0, Align2::RIGHT_BOTTOM);
        let (eye, viewport) = (self.eye, self.viewport);
        let font = Font { size: TEXT, color: self.color, bold: false };
        let _ = ["behind the eye", "behind\nthe eye"]
            .iter()
            .any(|text| words.write_clear_of(&curves, text, font, left(eye)).is_some());
        let anchors = right(viewport).chain(left(viewport));
        words.write_clear_of(&curves, "viewport: t = 1", font, anchors);
        words.write_clear_of(&curves, "eye: t = 0", font, right(eye).chain(left(eye)));
    }

    /// Returns points on what must not run through a caption: the curves and the line f = 0.
    pub(super) fn lines(&self, drawn: &[Strokes]) -> impl Iterator<Item = Pos2> {
        let (left, right) = (self.rect.left() as i32, self.rect.right() as i32);
        let zero = (left..right).step_by(4).map(|x| pos2(x as f32, self.zero));
        drawn.iter().flat_map(Strokes::closely).chain(zero)
    }

    /// Returns the positions of a caption, from the bottom upwards.
    fn rows(&self, x: f32, align: Align2) -> impl Iterator<Item = (Pos2, Align2)> + use<> {
        let (top, bottom) = (self.rect.top() + 24.0, self.rect.bottom() - 4.0);
        let count = ((bottom - top) / ROW).max(0.0) as usize + 1;
        (0..count).map(move |k| (pos2(x, bottom - ROW * k as f32), align))
    }
}
