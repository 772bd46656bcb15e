//! Words in a drawing: with a casing that makes them legible over lines, and never over each other.

use std::sync::Arc;

use egui::{Align2, Color32, FontId, Galley, Painter, Pos2, Rect, Vec2};

use super::notation::formula;
use crate::label_text::HaloText;
use crate::present::fonts;

/// How words look.
#[derive(Clone, Copy)]
pub(super) struct Font {
    /// In points.
    pub(super) size: f32,
    pub(super) color: Color32,
    pub(super) bold: bool,
}

/// Words that are already there, and where more may stand.
pub(super) struct Words {
    painter: Painter,
    halo: Color32,
    within: Rect,
    taken: Vec<Rect>,
}

impl Words {
    pub(super) fn new(painter: Painter, halo: Color32, within: Rect) -> Words {
        Words { painter, halo, within, taken: Vec::new() }
    }

    /// Keeps a part of the drawing free of words.
    pub(super) fn keep_free(&mut self, rect: Rect) {
        self.taken.push(rect);
    }

    /// Writes at the first of the places that is free and inside; where that is, if there is one.
    /// What is not bold is set as a formula.
    pub(super) fn write(
        &mut self,
        text: &str,
        font: Font,
        places: impl IntoIterator<Item = (Pos2, Align2)>,
    ) -> Option<Rect> {
        self.write_clear_of(&[], text, font, places)
    }

    /// The same at the first of the places that none of these points of the drawing is in.
    pub(super) fn write_clear_of(
        &mut self,
        points: &[Pos2],
        text: &str,
        font: Font,
        places: impl IntoIterator<Item = (Pos2, Align2)>,
    ) -> Option<Rect> {
        let galley = self.galley(text, font);
        for (at, align) in places {
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

/// Places around a point at a distance from it, that in the direction `toward` first.
pub(super) fn around(
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

/// On which side of words the place is that they belong to.
fn side(away: f32) -> egui::Align {
    if away > 0.38 {
        egui::Align::Min
    } else if away < -0.38 {
        egui::Align::Max
    } else {
        egui::Align::Center
    }
}
