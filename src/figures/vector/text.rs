//! Text as egui has laid it out: letters with places, in runs of one font and colour.

use egui::Color32;
use egui::epaint::TextShape;
use egui::text::ByteIndex;

use super::typeface::Face;

/// Lean of egui's slanted letters to the right, for each unit of height.
const SLANT: f32 = 0.25;

/// Text that is written in one go.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Text {
    pub(super) runs: Vec<Run>,
    /// A casing around all letters: its colour, and how far it reaches.
    pub(super) halo: Option<(Color32, f32)>,
}

/// Letters on one baseline, all of one font and colour.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Run {
    pub(super) text: String,
    pub(super) face: Face,
    /// The font's em.
    pub(super) size: f32,
    /// Start of the baseline.
    pub(super) at: [f32; 2],
    /// Distance of each letter from the next.
    pub(super) advances: Vec<f32>,
    pub(super) color: Color32,
    /// Lean of a letter to the right, for each unit of height.
    pub(super) slant: f32,
}

/// Returns the runs of a text, lengths multiplied by `scale`.
pub(super) fn runs(shape: &TextShape, scale: f32) -> Vec<Run> {
    let job = &shape.galley.job;
    let mut letters = job.text.char_indices();
    let mut runs: Vec<Run> = Vec::new();
    for placed in &shape.galley.rows {
        let row = runs.len();
        for glyph in &placed.row.glyphs {
            let Some((byte, letter)) = letters.next() else { break };
            let is_of = |range: &std::ops::Range<ByteIndex>| range.contains(&ByteIndex(byte));
            let section = job.sections.iter().find(|section| is_of(&section.byte_range));
            let Some(format) = section.map(|section| &section.format) else { continue };
            let color = match shape.override_text_color.unwrap_or(format.color) {
                Color32::PLACEHOLDER => shape.fallback_color,
                color => color,
            };
            let offset = placed.pos + glyph.pos.to_vec2();
            let next = Run {
                text: letter.to_string(),
                face: Face::for_letter(&format.font_id.family, letter),
                size: format.font_id.size * scale,
                at: [shape.pos.x + offset.x, shape.pos.y + offset.y].map(|x| x * scale),
                advances: vec![glyph.advance_width * scale],
                color: color.gamma_multiply(shape.opacity_factor),
                slant: if format.italics { SLANT } else { 0.0 },
            };
            match runs[row..].last_mut() {
                Some(open) if open.goes_on(&next) => open.append(&next),
                _ => runs.push(next),
            }
        }
        if placed.ends_with_newline {
            letters.next();
        }
    }
    runs.iter_mut().for_each(Run::spread);
    runs.retain(|run| !run.text.trim().is_empty());
    runs
}

impl Run {
    pub(super) fn width(&self) -> f32 {
        self.advances.iter().sum()
    }

    /// Returns true if another run belongs to the same.
    fn goes_on(&self, next: &Run) -> bool {
        self.face == next.face
            && self.size == next.size
            && self.color == next.color
            && self.slant == next.slant
            && (self.at[1] - next.at[1]).abs() < 1e-3
    }

    fn append(&mut self, next: &Run) {
        // What kerning moved is part of the letter before.
        let moved = next.at[0] - (self.at[0] + self.width());
        if let Some(before) = self.advances.last_mut() {
            *before += moved;
        }
        self.text.push_str(&next.text);
        self.advances.extend(&next.advances);
    }

    /// Gives each letter of a ligature its share of the width. egui lays a ligature out as its first
    /// letter, with all of the width, and the others with none but for rounding.
    fn spread(&mut self) {
        let own: Vec<f32> = self.text.chars().map(|c| self.size * self.face.advance(c)).collect();
        let mut first = 0;
        for end in 1..=own.len() {
            if end < own.len() && self.advances[end] < 0.2 * own[end] {
                continue;
            }
            let whole: f32 = own[first..end].iter().sum();
            if end > first + 1 && whole > 0.0 {
                let share = self.advances[first..end].iter().sum::<f32>() / whole;
                let laid = self.advances[first..end].iter_mut();
                laid.zip(&own[first..end]).for_each(|(laid, own)| *laid = share * own);
            }
            first = end;
        }
    }
}
