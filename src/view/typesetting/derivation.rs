//! Layout and painting of the derivation, line by line, in the window and in figures.

use std::sync::Arc;

use egui::{FontId, Galley, Id, Rect, Ui, vec2};

use crate::model::derivation_sections::DerivationSection;
use crate::view::derivation::{Derivation, Line, Section, left_out};
use crate::view::formula::{Column, Layout};
use crate::view::typesetting::formula::{self, Inks};
use crate::view::typesetting::theme::error_color;

/// Sizes of the em in points: formulas, and the notes behind them.
pub(crate) const SIZE: f32 = 17.0;

pub(crate) const NOTE: f32 = 15.0;

/// Padding around a line, in points.
pub(crate) const PAD: egui::Vec2 = vec2(8.0, 4.0);

/// Least indent of the relations and of the second and later lines of a formula, in points.
const INDENT: f32 = 26.0;

/// Distances in points: above a section's title, and between two lines.
pub(crate) const BEFORE_SECTION: f32 = 6.0;

pub(crate) const BETWEEN_LINES: f32 = 2.0;

/// A laid-out line.
pub(crate) struct LaidLine {
    pub(crate) id: Id,
    pub(crate) text: String,
    pub(crate) layout: Layout,
    /// Position of the note, from the line's upper left corner.
    pub(crate) note: egui::Vec2,
    pub(crate) height: f32,
}

pub(crate) fn note_galley(ui: &Ui, line: &Line, width: f32) -> Arc<Galley> {
    let color = if line.is_fault { error_color(ui) } else { ui.visuals().weak_text_color() };
    ui.painter().layout(line.note.clone(), FontId::proportional(NOTE), color, width)
}

/// Largest share of the width for what stands before the relations.
const LEFT: f32 = 0.32;

/// Lays out all lines of a derivation in a column, by sections; `id` names a line by its section and
/// its index there. The relations of a kind of section stand below each other.
pub(crate) fn laid_lines(
    ui: &Ui,
    derivation: &Derivation,
    width: f32,
    id: impl Fn(&Section, usize) -> Id,
) -> Vec<Vec<LaidLine>> {
    let inner = (width - 2.0 * PAD.x).max(20.0);
    let left = |line: &Line| formula::left_width(ui.ctx(), &line.formula, SIZE);
    let indent_of = |kind: DerivationSection| {
        let sections = derivation.sections.iter().filter(|section| section.section == kind);
        let lefts = sections.flat_map(|section| &section.lines).map(left);
        lefts.filter(|left| *left <= LEFT * inner).fold(INDENT.min(0.2 * inner), f32::max)
    };
    let indents = DerivationSection::ALL.map(indent_of);
    let of_section = |section: &Section| {
        let column = Column { size: SIZE, width: inner, indent: indents[section.section as usize] };
        let lines = section.lines.iter().enumerate();
        lines.map(|(k, line)| laid_line(ui, line, id(section, k), column)).collect()
    };
    derivation.sections.iter().map(of_section).collect()
}

fn laid_line(ui: &Ui, line: &Line, id: Id, column: Column) -> LaidLine {
    let Column { width: inner, indent, .. } = column;
    let layout = formula::set(ui.ctx(), &line.formula, column);
    let height = layout.ascent + layout.descent;
    let mut whole = LaidLine { id, text: line.to_string(), layout, note: PAD, height };
    if !line.note.is_empty() {
        let note = note_galley(ui, line, inner - indent).size();
        let beside = whole.layout.width + 18.0;
        if beside + note.x <= inner && height < 2.4 * SIZE {
            whole.note.x += beside;
            whole.note.y += whole.layout.ascent - 0.78 * note.y;
        } else {
            whole.note += vec2(indent, height + 1.0);
            whole.height += note.y + 1.0;
        }
    }
    whole.height += 2.0 * PAD.y;
    whole
}

/// Returns the start of a line's first baseline.
pub(crate) fn baseline_of(rect: Rect, laid: &LaidLine) -> egui::Pos2 {
    rect.min + PAD + vec2(0.0, laid.layout.ascent)
}

/// Paints a line's formula and its note.
pub(crate) fn paint(ui: &Ui, rect: Rect, line: &Line, laid: &LaidLine, inks: Inks) {
    formula::paint(ui.painter(), baseline_of(rect, laid), &laid.layout, inks);
    if !line.note.is_empty() {
        let width = (rect.width() - laid.note.x).max(20.0);
        let galley = note_galley(ui, line, width);
        ui.painter().galley(rect.min + laid.note, galley, ui.visuals().text_color());
    }
}

/// Draws the derivation as in its panel, from the upper left corner of a column downwards, and
/// returns its height. Of a section that `is_folded`, only the title is drawn.
pub(crate) fn draw(
    ui: &Ui,
    derivation: &Derivation,
    column: Rect,
    is_folded: impl Fn(&Section) -> bool,
) -> f32 {
    let (inks, painter) = (Inks::from_ui(ui), ui.painter());
    let mut at = column.min;
    let laid = laid_lines(ui, derivation, column.width(), |_, _| Id::NULL);
    for (k, (section, laid)) in derivation.sections.iter().zip(&laid).enumerate() {
        at.y += if k == 0 { 0.0 } else { BEFORE_SECTION };
        let color = ui.visuals().strong_text_color();
        let title = FontId::proportional(SIZE);
        let title = painter.layout(section.title.clone(), title, color, column.width());
        let height = title.size().y;
        painter.galley(at, title, color);
        at.y += height + BETWEEN_LINES;
        if is_folded(section) {
            continue;
        }
        for (line, laid) in section.lines.iter().zip(laid) {
            let rect = Rect::from_min_size(at, vec2(column.width(), laid.height));
            paint(ui, rect, line, laid, inks);
            at.y += laid.height + BETWEEN_LINES;
        }
    }
    if derivation.left_out > 0 {
        at.y += BEFORE_SECTION;
        let color = ui.visuals().text_color();
        let note = FontId::proportional(NOTE);
        let note = painter.layout(left_out(derivation.left_out), note, color, column.width());
        let height = note.size().y;
        painter.galley(at, note, color);
        at.y += height;
    }
    at.y - column.top()
}
