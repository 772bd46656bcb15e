//! Formulas on the screen: measuring text and painting layouts.

use egui::epaint::text::{LayoutJob, TextFormat};
use egui::{Color32, Context, FontFamily, FontId, Painter, Pos2, Stroke, Ui, Vec2, pos2, vec2};

use crate::model::letters::plain_scalars;
use crate::model::symbols::{Kind, meaning};
use crate::view::formula::{Column, Face, Formula, Ink, Layout, Measure, Run, lines};
use crate::view::overlay::Colors;
use crate::view::typesetting::{fonts, theme};

/// Sets a formula in lines of the width of `column`, with the window's fonts.
pub(crate) fn set(ctx: &Context, formula: &Formula, column: Column) -> Layout {
    lines(formula, column, &mut Fonts(ctx))
}

/// Returns the width of what stands before a formula's first relation, with the gap behind it.
pub(crate) fn left_width(ctx: &Context, formula: &Formula, size: f32) -> f32 {
    crate::view::formula::left_width(formula, size, &mut Fonts(ctx))
}

struct Fonts<'a>(&'a Context);

impl Measure for Fonts<'_> {
    fn width(&mut self, text: &str, face: Face, size: f32) -> f32 {
        let font = font(face, size);
        self.0.fonts_mut(|fonts| text.chars().map(|c| fonts.glyph_width(&font, c)).sum())
    }
}

fn font(face: Face, size: f32) -> FontId {
    match face {
        Face::Bold => FontId::new(size, fonts::bold()),
        Face::Upright | Face::Italic => FontId::new(size, FontFamily::Proportional),
    }
}

/// The formulas' colours in one window.
#[derive(Clone, Copy)]
pub(crate) struct Inks {
    text: Color32,
    colors: &'static Colors,
}

impl Inks {
    pub(crate) fn from_ui(ui: &Ui) -> Inks {
        Inks { text: ui.visuals().text_color(), colors: theme::style(ui).colors() }
    }

    fn color(self, ink: Ink) -> Color32 {
        match ink {
            Ink::Text => self.text,
            Ink::U => self.colors.basis[0],
            Ink::V => self.colors.basis[1],
            Ink::W => self.colors.basis[2],
            Ink::Given => self.colors.given,
            Ink::Ray => self.colors.ray,
        }
    }
}

/// Returns the meaning of the symbol at a position of a layout, which is relative to the start of
/// its first baseline.
pub(crate) fn meaning_at(ctx: &Context, layout: &Layout, at: Vec2) -> Option<&'static str> {
    let mut fonts = Fonts(ctx);
    let mut holds = |run: &&Run| {
        let [x, y] = run.at;
        // A margin makes thin letters as easy to hover as wide ones.
        let across = x - 2.0..=x + fonts.width(&run.text, run.face, run.size) + 2.0;
        let down = y - 0.8 * run.size..=y + 0.3 * run.size;
        across.contains(&at.x) && down.contains(&at.y)
    };
    let run = layout.runs.iter().find(|run| run.face != Face::Upright && holds(run))?;
    let kind = if run.face == Face::Bold { Kind::Vector } else { Kind::Scalar };
    meaning(kind, &plain_scalars(&run.text))
}

/// Paints a layout whose first baseline begins at `origin`.
pub(crate) fn paint(painter: &Painter, origin: Pos2, layout: &Layout, inks: Inks) {
    for run in &layout.runs {
        let color = inks.color(run.ink);
        // The italic letters of a word are slanted ones: Unicode's would read as a product.
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
