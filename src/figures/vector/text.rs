//! Text as egui has laid it out: letters with places, in runs of one font and colour.

use egui::epaint::TextShape;
use egui::text::{LayoutJob, LayoutSection};
use egui::{Color32, Galley};

use super::primitive::Run;
use super::typeface::Face;

/// Lean of egui's slanted letters to the right, for each unit of height.
const SLANT: f32 = 0.25;

/// The runs of a text, lengths multiplied by `scale`.
pub(super) fn runs(shape: &TextShape, scale: f32) -> Vec<Run> {
    let galley: &Galley = &shape.galley;
    let mut letters = galley.job.text.char_indices();
    let mut runs: Vec<Run> = Vec::new();
    for placed in &galley.rows {
        let mut last: Option<f32> = None;
        for glyph in &placed.row.glyphs {
            let Some((byte, letter)) = letters.next() else { break };
            let Some(section) = section(&galley.job, byte) else { continue };
            let format = &section.format;
            let face = Face::for_letter(&format.font_id.family, letter);
            let color = match shape.override_text_color.unwrap_or(format.color) {
                Color32::PLACEHOLDER => shape.fallback_color,
                color => color,
            };
            let offset = placed.pos + glyph.pos.to_vec2();
            let at = [shape.pos.x + offset.x, shape.pos.y + offset.y].map(|x| x * scale);
            let advance = glyph.advance_width * scale;
            let run = Run {
                text: letter.to_string(),
                face,
                size: format.font_id.size * scale,
                at,
                advances: vec![advance],
                color: color.gamma_multiply(shape.opacity_factor),
                slant: if format.italics { SLANT } else { 0.0 },
            };
            match runs.last_mut() {
                Some(open) if last.is_some() && goes_on(open, &run) => {
                    // What kerning moved is part of the letter before.
                    let begin = open.at[0] + open.width();
                    if let Some(before) = open.advances.last_mut() {
                        *before += run.at[0] - begin;
                    }
                    open.text.push(letter);
                    open.advances.push(advance);
                }
                _ => runs.push(run),
            }
            last = Some(at[0]);
        }
        if placed.ends_with_newline {
            letters.next();
        }
    }
    runs.iter_mut().for_each(spread);
    runs.retain(|run| !run.text.trim().is_empty());
    runs
}

fn section(job: &LayoutJob, byte: usize) -> Option<&LayoutSection> {
    job.sections.iter().find(|section| section.byte_range.contains(&egui::text::ByteIndex(byte)))
}

/// Returns whether a letter belongs to the same run.
fn goes_on(open: &Run, next: &Run) -> bool {
    open.face == next.face
        && open.size == next.size
        && open.color == next.color
        && open.slant == next.slant
        && (open.at[1] - next.at[1]).abs() < 1e-3
}

/// A ligature is laid out as its first letter, with all of its width, and the others with none but for
/// rounding; each letter gets its own.
fn spread(run: &mut Run) {
    let own: Vec<f32> = run.text.chars().map(|c| run.size * run.face.advance(c)).collect();
    let mut first = 0;
    while first < own.len() {
        let others = own[first + 1..].iter().zip(&run.advances[first + 1..]);
        let end = first + 1 + others.take_while(|(own, laid)| **laid < 0.2 * **own).count();
        let whole: f32 = own[first..end].iter().sum();
        if end > first + 1 && whole > 0.0 {
            let share = run.advances[first..end].iter().sum::<f32>() / whole;
            for (laid, own) in run.advances[first..end].iter_mut().zip(&own[first..end]) {
                *laid = share * own;
            }
        }
        first = end;
    }
}
