//! Formulas on the screen: how wide text is there, and painting what was laid out.

use egui::epaint::text::{LayoutJob, TextFormat};
use egui::{Color32, Context, FontFamily, FontId, Painter, Pos2, Stroke, Ui, pos2, vec2};

use crate::formula::{Column, Face, Formula, Ink, Layout, Measure, lines};
use crate::panels::look;
use crate::present::fonts;

/// Sets a formula in lines as wide as `column` says, with the window's fonts.
pub(crate) fn set(ctx: &Context, formula: &Formula, column: Column) -> Layout {
    lines(formula, column, &mut Fonts(ctx))
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

/// The colours of one window.
#[derive(Clone, Copy)]
pub(crate) struct Inks {
    text: Color32,
    basis: [Color32; 3],
    given: Color32,
    ray: Color32,
    wrong: Color32,
}

impl Inks {
    pub(crate) fn of(ui: &Ui) -> Inks {
        let style = look::style(ui);
        let colors = style.colors();
        Inks {
            text: ui.visuals().text_color(),
            basis: colors.basis,
            given: colors.given,
            ray: colors.ray,
            wrong: super::number::error_color(ui),
        }
    }

    fn color(self, ink: Ink) -> Color32 {
        match ink {
            Ink::Text => self.text,
            Ink::U => self.basis[0],
            Ink::V => self.basis[1],
            Ink::W => self.basis[2],
            Ink::Given => self.given,
            Ink::Ray => self.ray,
            Ink::Wrong => self.wrong,
        }
    }
}

/// Paints a layout whose first baseline begins at `origin`.
pub(crate) fn paint(painter: &Painter, origin: Pos2, layout: &Layout, inks: Inks) {
    for run in &layout.runs {
        let color = inks.color(run.ink);
        // A word's italic letters are slanted ones: those of Unicode would read as a product.
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
