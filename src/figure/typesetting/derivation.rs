//! Lays out and paints formulas and whole derivations, in the window and in figures.

use std::sync::Arc;

use egui::epaint::text::{LayoutJob, TextFormat};
use egui::{
    Color32, Context, FontFamily, FontId, Galley, Id, Painter, Pos2, Rect, Stroke, Ui, Vec2, pos2,
    vec2,
};

use crate::derivation::sections::DerivationSection;
use crate::derivation::{Derivation, DerivedLine, DerivedSection, left_out};
use crate::formula::{Column, Face, Layout, SymbolInk, TextMeasure, TextRun, left_width, lines};
use crate::overlay::Colors;
use crate::symbols::{SymbolKind, meaning, plain_scalars};
use crate::typesetting::theme::{self, WRITTEN, error_color};

/// Size of the em of formulas, in points.
pub const SIZE: f32 = 17.0;

/// Size of the em of notes, in points.
pub const NOTE: f32 = 15.0;

/// Size of a note's em, as a fraction of its formula's.
const NOTE_SHARE: f32 = NOTE / SIZE;

/// Padding around a line, in points.
pub const PAD: egui::Vec2 = vec2(8.0, 4.0);

/// Minimum indent, in points: the position at which the formulas' relations (such as `=`) are aligned and
/// their later lines begin.
const INDENT: f32 = 26.0;

/// Distance above a section's title, in points.
pub const BEFORE_SECTION: f32 = 6.0;

/// Distance between two lines, in points.
pub const BETWEEN_LINES: f32 = 2.0;

/// A line of the derivation after layout.
pub struct LaidLine {
    /// Identifies the line in the window.
    pub id: Id,
    /// Size of the formula's em, in points.
    pub size: f32,
    /// The formula as plain text.
    pub text: String,
    /// The laid out formula.
    pub layout: Layout,
    /// Position of the note, from the line's upper left corner.
    pub note: egui::Vec2,
    /// The line's height with its note, in points.
    pub height: f32,
}

fn note_galley(ui: &Ui, line: &DerivedLine, size: f32, width: f32) -> Arc<Galley> {
    let color = if line.is_fault { error_color(ui) } else { ui.visuals().weak_text_color() };
    ui.painter().layout(
        line.note.clone(),
        FontId::proportional((NOTE_SHARE * size).max(WRITTEN)),
        color,
        width,
    )
}

/// Maximum width of the part before a formula's relation, as a fraction of the column, for which the indent
/// is increased; a wider part does not affect the indent.
const LEFT: f32 = 0.32;

/// Lays out all lines of a derivation in a column, section by section. The relations (such as `=`) are
/// aligned in all sections of the same kind. `id` returns the id of a line, given its section and its index
/// there.
pub fn laid_lines(
    ui: &Ui,
    derivation: &Derivation,
    [width, size]: [f32; 2],
    id: impl Fn(&DerivedSection, usize) -> Id,
) -> Vec<Vec<LaidLine>> {
    let inner = (width - 2.0 * PAD.x).max(20.0);
    let left = |line: &DerivedLine| left_width(&line.formula, size, &mut Fonts(ui.ctx()));
    let indent_of = |kind: DerivationSection| {
        let sections = derivation.sections.iter().filter(|section| section.section == kind);
        let lefts = sections.flat_map(|section| &section.lines).map(left);
        lefts.filter(|left| *left <= LEFT * inner).fold(INDENT.min(0.2 * inner), f32::max)
    };
    let indents = DerivationSection::ALL.map(indent_of);
    let of_section = |section: &DerivedSection| {
        let column = Column { size, width: inner, indent: indents[section.section as usize] };
        let lines = section.lines.iter().enumerate();
        lines.map(|(k, line)| laid_line(ui, line, id(section, k), column)).collect()
    };
    derivation.sections.iter().map(of_section).collect()
}

fn laid_line(ui: &Ui, line: &DerivedLine, id: Id, column: Column) -> LaidLine {
    let Column { size, width: inner, indent } = column;
    let layout = lines(&line.formula, column, &mut Fonts(ui.ctx()));
    let height = layout.ascent + layout.descent;
    let mut whole = LaidLine { id, size, text: line.to_string(), layout, note: PAD, height };
    if !line.note.is_empty() {
        let note = note_galley(ui, line, size, inner - indent).size();
        let behind = whole.layout.width + 18.0;
        if behind + note.x <= inner && height < 2.4 * size {
            whole.note.x += behind;
            whole.note.y += whole.layout.ascent - 0.78 * note.y;
        } else {
            whole.note += vec2(indent, height + 1.0);
            whole.height += note.y + 1.0;
        }
    }
    whole.height += 2.0 * PAD.y;
    whole
}

/// Returns the start of the first baseline of a line's formula. `rect` is the rectangle of the whole line.
pub fn baseline_of(rect: Rect, laid: &LaidLine) -> egui::Pos2 {
    rect.min + PAD + vec2(0.0, laid.layout.ascent)
}

/// Paints a line's formula and its note.
pub fn paint_line(ui: &Ui, rect: Rect, line: &DerivedLine, laid: &LaidLine, inks: Inks) {
    paint_formula(ui.painter(), baseline_of(rect, laid), &laid.layout, inks);
    if !line.note.is_empty() {
        let width = (rect.width() - laid.note.x).max(20.0);
        let galley = note_galley(ui, line, laid.size, width);
        ui.painter().galley(rect.min + laid.note, galley, ui.visuals().text_color());
    }
}

/// Draws the derivation as in its panel, from the top of a column, and returns the height of the drawing.
pub fn draw(ui: &Ui, derivation: &Derivation, column: Rect) -> f32 {
    let (inks, painter) = (Inks::from_ui(ui), ui.painter());
    let write = |at: Pos2, text: String, size: f32, color: Color32| {
        let galley = painter.layout(text, FontId::proportional(size), color, column.width());
        let height = galley.size().y;
        painter.galley(at, galley, color);
        height
    };
    let mut at = column.min;
    let laid = laid_lines(ui, derivation, [column.width(), SIZE], |_, _| Id::NULL);
    for (k, (section, laid)) in derivation.sections.iter().zip(&laid).enumerate() {
        at.y += if k == 0 { 0.0 } else { BEFORE_SECTION };
        let color = ui.visuals().strong_text_color();
        at.y += write(at, section.title.clone(), SIZE, color) + BETWEEN_LINES;
        for (line, laid) in section.lines.iter().zip(laid) {
            let rect = Rect::from_min_size(at, vec2(column.width(), laid.height));
            paint_line(ui, rect, line, laid, inks);
            at.y += laid.height + BETWEEN_LINES;
        }
    }
    if derivation.left_out > 0 {
        at.y += BEFORE_SECTION;
        at.y += write(at, left_out(derivation.left_out), NOTE, ui.visuals().text_color());
    }
    at.y - column.top()
}

/// Measures text in the window's fonts.
struct Fonts<'a>(&'a Context);

impl TextMeasure for Fonts<'_> {
    fn width(&mut self, text: &str, face: Face, size: f32) -> f32 {
        let font = font(face, size);
        self.0.fonts_mut(|fonts| text.chars().map(|c| fonts.glyph_width(&font, c)).sum())
    }
}

fn font(face: Face, size: f32) -> FontId {
    match face {
        Face::Bold => FontId::new(size, theme::bold()),
        Face::Upright | Face::Italic => FontId::new(size, FontFamily::Proportional),
    }
}

/// The colours of formulas in the current style.
#[derive(Clone, Copy)]
pub struct Inks {
    text: Color32,
    colors: &'static Colors,
}

impl Inks {
    /// Returns the colours in this window's style.
    pub fn from_ui(ui: &Ui) -> Inks {
        Inks { text: ui.visuals().text_color(), colors: theme::style(ui).colors() }
    }

    fn color(self, ink: SymbolInk) -> Color32 {
        match ink {
            SymbolInk::Text => self.text,
            SymbolInk::U => self.colors.basis[0],
            SymbolInk::V => self.colors.basis[1],
            SymbolInk::W => self.colors.basis[2],
            SymbolInk::Given => self.colors.given,
            SymbolInk::Ray => self.colors.ray,
        }
    }
}

/// Returns the meaning of the symbol at a position, which is relative to the start of the layout's first
/// baseline; `None` if there is no symbol with a meaning.
pub fn meaning_at(ctx: &Context, layout: &Layout, at: Vec2) -> Option<&'static str> {
    let mut fonts = Fonts(ctx);
    let mut holds = |run: &&TextRun| {
        let [x, y] = run.at;
        // The margin makes narrow letters as easy to hover as wide ones.
        let across = x - 2.0..=x + fonts.width(&run.text, run.face, run.size) + 2.0;
        let down = y - 0.8 * run.size..=y + 0.3 * run.size;
        across.contains(&at.x) && down.contains(&at.y)
    };
    let run = layout.runs.iter().find(|run| run.face != Face::Upright && holds(run))?;
    let kind = if run.face == Face::Bold { SymbolKind::Vector } else { SymbolKind::Scalar };
    meaning(kind, &plain_scalars(&run.text))
}

/// Paints a layout whose first baseline begins at `origin`.
pub fn paint_formula(painter: &Painter, origin: Pos2, layout: &Layout, inks: Inks) {
    for run in &layout.runs {
        let color = inks.color(run.ink);
        // egui slants the words, because a word in Unicode's italic letters would look like a product.
        let italics = run.face == Face::Italic && run.text.len() > 4;
        let format =
            TextFormat { font_id: font(run.face, run.size), color, italics, ..Default::default() };
        let job = LayoutJob::single_section(run.text.clone(), format);
        let galley = painter.layout_job(job);
        let baseline = galley
            .rows
            .first()
            .map_or(0.0, |row| row.pos.y + row.glyphs.first().map_or(0.0, |glyph| glyph.pos.y));
        painter.galley(origin + vec2(run.at[0], run.at[1] - baseline), galley, color);
    }
    for rule in &layout.rules {
        let points = rule.points.iter().map(|[x, y]| pos2(origin.x + x, origin.y + y)).collect();
        painter.line(points, Stroke::new(rule.width, inks.color(rule.ink)));
    }
}
