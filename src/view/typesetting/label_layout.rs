//! Labels in a drawing: a casing keeps them legible over lines, and they never overlap.

use std::sync::Arc;

use egui::{Align2, Color32, FontId, Galley, Painter, Pos2, Rect, Vec2};

use crate::view::typesetting::fonts;
use crate::view::typesetting::label_text::HaloText;
use crate::view::typesetting::notation::formula;

/// The look of a label.
#[derive(Clone, Copy)]
pub(crate) struct Font {
    /// Size in points.
    pub(crate) size: f32,
    pub(crate) color: Color32,
    pub(crate) bold: bool,
}

/// The labels already written, and the area for more.
pub(crate) struct LabelLayout {
    painter: Painter,
    halo: Color32,
    within: Rect,
    taken: Vec<Rect>,
}

impl LabelLayout {
    pub(crate) fn new(painter: Painter, halo: Color32, within: Rect) -> LabelLayout {
        LabelLayout { painter, halo, within, taken: Vec::new() }
    }

    /// Keeps a part of the drawing free of labels.
    pub(crate) fn keep_free(&mut self, rect: Rect) {
        self.taken.push(rect);
    }

    /// Writes a label at the first position that is free and inside the area; returns its
    /// rectangle, if there is such a position. Text that is not bold is typeset as a formula.
    pub(crate) fn write(
        &mut self,
        text: &str,
        font: Font,
        anchors: impl IntoIterator<Item = (Pos2, Align2)>,
    ) -> Option<Rect> {
        self.write_clear_of(&[], text, font, anchors)
    }

    /// Writes a label as [`LabelLayout::write`] does, at the first position that also covers none of
    /// `points`.
    pub(crate) fn write_clear_of(
        &mut self,
        points: &[Pos2],
        text: &str,
        font: Font,
        anchors: impl IntoIterator<Item = (Pos2, Align2)>,
    ) -> Option<Rect> {
        let galley = self.galley(text, font);
        for (at, align) in anchors {
            let rect = align.anchor_size(at, galley.size());
            // Two numbers side by side would read as one.
            let room = rect.expand2(Vec2::new(3.0, 0.0));
            let free = self.taken.iter().all(|taken| !taken.intersects(room));
            let clear = !points.iter().any(|point| rect.contains(*point));
            if free && clear && self.within.contains_rect(rect) {
                self.put(galley, rect, font.color);
                return Some(rect);
            }
        }
        None
    }

    fn galley(&self, text: &str, font: Font) -> Arc<Galley> {
        if font.bold {
            let id = FontId::new(font.size, fonts::bold());
            self.painter.layout_no_wrap(text.to_owned(), id, font.color)
        } else {
            self.painter.layout_job(formula(text, font.size, font.color))
        }
    }

    fn put(&mut self, galley: Arc<Galley>, rect: Rect, color: Color32) {
        self.painter.add(HaloText::new(rect.min, galley, color, self.halo).into_shape());
        self.taken.push(rect);
    }
}

/// Returns positions around a point at a distance from it, beginning in the direction `toward`.
pub(crate) fn around(
    at: Pos2,
    toward: Vec2,
    distance: f32,
) -> impl Iterator<Item = (Pos2, Align2)> {
    let first = if toward == Vec2::ZERO { 0.0 } else { toward.angle() };
    let turns = [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0];
    [1.0, 2.2].into_iter().flat_map(move |ring| {
        turns.into_iter().map(move |turn: f32| {
            let away = Vec2::angled(first + turn * std::f32::consts::FRAC_PI_4);
            (at + ring * distance * away, Align2([side(away.x), side(away.y)]))
        })
    })
}

/// Returns the side of a label on which its point is.
fn side(away: f32) -> egui::Align {
    if away > 0.38 {
        egui::Align::Min
    } else if away < -0.38 {
        egui::Align::Max
    } else {
        egui::Align::Center
    }
}
