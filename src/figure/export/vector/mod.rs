//! Figures in vector formats: SVG and PDF. Strokes and text are not converted to outlines.
//!
//! This file converts a figure to paths and texts. A text of egui becomes runs of positioned letters,
//! each run with a single font and colour; a letter has the font that egui chose for it. The modules
//! `svg` and `pdf` write the files.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use egui::epaint::tessellator::path::rounded_rectangle;
use egui::epaint::{CircleShape, ColorMode, PathShape, RectShape, RoundedRect, TextShape};
use egui::text::ByteIndex;
use egui::{Color32, FontDefinitions, FontFamily, Pos2, Shape, Stroke, StrokeKind};
use skrifa::instance::{LocationRef, Size};
use skrifa::raw::TableProvider as _;
use skrifa::{FontRef, GlyphId, MetadataProvider as _};
use subsetter::GlyphRemapper;
use write_fonts::FontBuilder;
use write_fonts::tables::cmap::Cmap;
use write_fonts::types::Tag;

use crate::export::Figure;
use crate::overlay::{Ink, Path, PathOutline};
use crate::typesetting::labels::HaloText;
use crate::typesetting::theme;

pub(super) use crate::export::vector::pdf::write as pdf;
pub(super) use crate::export::vector::svg::write as svg;

mod pdf;
mod svg;

/// A path or a text of a figure. Positions are in dots from the figure's upper left corner.
#[derive(Clone, Debug)]
enum Primitive {
    /// A fill or a stroke.
    Path(Path),
    /// Text.
    Text(CasedText),
}

/// Returns the paths and texts that are drawn over the figure's picture, from back to front.
fn primitives(figure: &Figure) -> Vec<Primitive> {
    let primitives = figure.paths.iter().cloned().map(Primitive::Path).collect();
    let mut maker = Maker { scale: figure.drawn.pixels_per_point, primitives };
    figure.drawn.shapes.iter().for_each(|clipped| maker.shape(&clipped.shape));
    maker.primitives
}

/// Converts egui's shapes, which are in points, to primitives in dots.
struct Maker {
    /// Dots per point.
    scale: f32,
    primitives: Vec<Primitive>,
}

impl Maker {
    fn shape(&mut self, shape: &Shape) {
        if let Some(HaloText { text, halo }) = HaloText::from_shape(shape) {
            return self.text(&text, Some(halo));
        }
        match shape {
            Shape::Noop => {}
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| self.shape(shape)),
            Shape::Text(text) => self.text(text, None),
            Shape::LineSegment { points, stroke } => self.stroke(self.chain(points, false), stroke),
            Shape::Path(PathShape { points, closed, fill, stroke }) => {
                let outline = self.chain(points, *closed);
                self.fill(outline.clone(), *fill);
                if let ColorMode::Solid(color) = stroke.color {
                    self.stroke(outline, &Stroke::new(stroke.width, color));
                }
            }
            Shape::Circle(CircleShape { center, radius, fill, stroke }) => {
                let circle = |radius: f32| PathOutline::Circle {
                    center: [center.x * self.scale, center.y * self.scale],
                    radius: radius * self.scale,
                };
                // egui draws a circle's stroke outside the circle.
                let (inner, outer) = (circle(*radius), circle(radius + 0.5 * stroke.width));
                self.fill(inner, *fill);
                self.stroke(outer, stroke);
            }
            Shape::Rect(rect) => self.rectangle(rect),
            other => debug_assert!(false, "figures have no {other:?}"),
        }
    }

    fn text(&mut self, shape: &TextShape, halo: Option<Color32>) {
        let halo = halo.map(|halo| (halo, HaloText::REACH * self.scale));
        let text = CasedText { runs: runs(shape, self.scale), halo };
        if !text.runs.is_empty() {
            self.primitives.push(Primitive::Text(text));
        }
    }

    fn rectangle(&mut self, shape: &RectShape) {
        let whole = RoundedRect::new(shape.rect, shape.corner_radius);
        let out = match shape.stroke_kind {
            StrokeKind::Inside => -0.5,
            StrokeKind::Middle => 0.0,
            StrokeKind::Outside => 0.5,
        };
        let outline = |rect: RoundedRect| {
            let mut corners = Vec::new();
            rounded_rectangle(&mut corners, rect);
            self.chain(&corners, true)
        };
        let (inner, edge) = (outline(whole), outline(whole.expand(out * shape.stroke.width)));
        self.fill(inner, shape.fill);
        self.stroke(edge, &shape.stroke);
    }

    fn fill(&mut self, outline: PathOutline, color: Color32) {
        if color.a() > 0 {
            self.primitives.push(Primitive::Path(Path { outline, color, ink: Ink::Fill }));
        }
    }

    fn stroke(&mut self, outline: PathOutline, &Stroke { width, color }: &Stroke) {
        if width > 0.0 && color.a() > 0 {
            let ink = Ink::Stroke { width: width * self.scale, round: false, dash: None };
            self.primitives.push(Primitive::Path(Path { outline, color, ink }));
        }
    }

    fn chain(&self, points: &[Pos2], closed: bool) -> PathOutline {
        let points = points.iter().map(|at| [at.x * self.scale, at.y * self.scale]).collect();
        PathOutline::Chain { points, closed }
    }
}

/// Slant of the letters that egui draws as italics: their shift to the right per unit of height.
const SLANT: f32 = 0.25;

/// A text that is written as one element.
#[derive(Clone, Debug, PartialEq)]
struct CasedText {
    runs: Vec<LetterRun>,
    /// The casing around all letters: its colour, and its width on each side.
    halo: Option<(Color32, f32)>,
}

/// A run of letters on the same baseline, with the same font and colour.
#[derive(Clone, Debug, PartialEq)]
struct LetterRun {
    text: String,
    face: FontName,
    /// Size of the em.
    size: f32,
    /// Start of the baseline.
    at: [f32; 2],
    /// For each letter, the distance from its start to the start of the next letter.
    advances: Vec<f32>,
    color: Color32,
    /// Slant of the letters: their shift to the right per unit of height; 0 if upright.
    slant: f32,
}

/// Splits a text of egui into runs of letters. All lengths are multiplied by `scale`.
fn runs(shape: &TextShape, scale: f32) -> Vec<LetterRun> {
    let job = &shape.galley.job;
    let mut letters = job.text.char_indices();
    let mut runs: Vec<LetterRun> = Vec::new();
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
            let next = LetterRun {
                text: letter.to_string(),
                face: FontName::for_letter(&format.font_id.family, letter),
                size: format.font_id.size * scale,
                at: [shape.pos.x + offset.x, shape.pos.y + offset.y].map(|x| x * scale),
                advances: vec![glyph.advance_width * scale],
                color: color.gamma_multiply(shape.opacity_factor),
                slant: if format.italics { SLANT } else { 0.0 },
            };
            match runs[row..].last_mut() {
                Some(open) if open.continues_with(&next) => open.append(&next),
                _ => runs.push(next),
            }
        }
        if placed.ends_with_newline {
            letters.next();
        }
    }
    runs.iter_mut().for_each(LetterRun::spread);
    runs.retain(|run| !run.text.trim().is_empty());
    runs
}

impl LetterRun {
    fn width(&self) -> f32 {
        self.advances.iter().sum()
    }

    /// Returns true if the run `next` can be appended to this one.
    fn continues_with(&self, next: &LetterRun) -> bool {
        self.face == next.face
            && self.size == next.size
            && self.color == next.color
            && self.slant == next.slant
            && (self.at[1] - next.at[1]).abs() < 1e-3
    }

    fn append(&mut self, next: &LetterRun) {
        // Kerning shifts the letter. The shift is added to the advance of the previous letter.
        let moved = next.at[0] - (self.at[0] + self.width());
        if let Some(before) = self.advances.last_mut() {
            *before += moved;
        }
        self.text.push_str(&next.text);
        self.advances.extend(&next.advances);
    }

    /// Distributes the width of each ligature over its letters. Before, the first letter has the whole
    /// width, and the others have a width of zero, apart from rounding, because egui lays ligatures out
    /// so.
    fn spread(&mut self) {
        let natural: Vec<f32> =
            self.text.chars().map(|c| self.size * self.face.advance(c)).collect();
        let mut first = 0;
        for end in 1..=natural.len() {
            if end < natural.len() && self.advances[end] < 0.2 * natural[end] {
                continue;
            }
            let whole: f32 = natural[first..end].iter().sum();
            if end > first + 1 && whole > 0.0 {
                let share = self.advances[first..end].iter().sum::<f32>() / whole;
                let laid = self.advances[first..end].iter_mut();
                laid.zip(&natural[first..end]).for_each(|(laid, natural)| *laid = share * natural);
            }
            first = end;
        }
    }
}

/// The font families for plain text, as in CSS: the program's own font, then similar ones as fallbacks.
const SANS: &str = "Noto Sans, DejaVu Sans, Helvetica, Arial, sans-serif";

/// Tables of a font file that the subsetter, which is made for PDF, drops, but that are kept here:
/// browsers require `OS/2`, and `name` contains the licence.
const KEPT: [&[u8; 4]; 2] = [b"OS/2", b"name"];

/// The program's fonts, as they are installed in egui.
static FONTS: LazyLock<FontDefinitions> = LazyLock::new(theme::font_definitions);

/// A font of the program, identified by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
struct FontName(&'static str);

impl FontName {
    /// Returns the font that egui uses for a letter: the first font in the family's list that contains
    /// the letter.
    fn for_letter(family: &FontFamily, letter: char) -> FontName {
        let chain = FONTS.families.get(family).map(Vec::as_slice).unwrap_or_default();
        let name = chain.iter().find(|name| FontName(name).glyph(letter).is_some());
        FontName(name.or(chain.first()).map_or("", String::as_str))
    }

    /// Returns the font's file.
    fn data(self) -> &'static [u8] {
        FONTS.font_data.get(self.0).map_or(&[], |data| (*data.font).as_ref())
    }

    fn font(self) -> Option<FontRef<'static>> {
        FontRef::new(self.data()).ok()
    }

    /// Returns the glyph of a letter; `None` if the font lacks the letter.
    fn glyph(self, letter: char) -> Option<GlyphId> {
        self.font()?.charmap().map(letter)
    }

    /// Returns the width of a letter, in ems.
    fn advance(self, letter: char) -> f32 {
        let width = || {
            let metrics = self.font()?.glyph_metrics(Size::new(1.0), LocationRef::default());
            metrics.advance_width(self.glyph(letter)?)
        };
        width().unwrap_or_default()
    }

    /// Returns the family name for style sheets.
    fn family(self) -> &'static str {
        self.0.strip_suffix(" Bold").unwrap_or(self.0)
    }

    /// Returns the font's family and its fallbacks, for style sheets.
    fn families(self) -> String {
        if SANS.starts_with(&format!("{},", self.family())) {
            return SANS.to_owned();
        }
        format!("{}, {SANS}", self.family())
    }

    /// Returns true if the font is bold.
    fn is_bold(self) -> bool {
        self.0.ends_with(" Bold")
    }

    /// Returns the contents of a font file that has only the given letters, in a form that browsers
    /// accept.
    ///
    /// # Errors
    /// Returns an error, as a sentence, if the font cannot be read.
    fn subset(self, letters: &BTreeSet<char>) -> Result<Vec<u8>, String> {
        let problem = |error: &dyn std::fmt::Display| format!("the font {}: {error}", self.0);
        let mut glyphs = GlyphRemapper::new();
        let mappings = letters.iter().filter_map(|letter| {
            let glyph = u16::try_from(self.glyph(*letter)?.to_u32()).ok()?;
            Some((*letter, GlyphId::from(glyphs.remap(glyph))))
        });
        let cmap = Cmap::from_mappings(mappings).map_err(|error| problem(&error))?;
        let outlines =
            subsetter::subset(self.data(), 0, &glyphs).map_err(|error| problem(&error))?;
        let outlines = FontRef::new(&outlines).map_err(|error| problem(&error))?;
        let whole = FontRef::new(self.data()).map_err(|error| problem(&error))?;
        let mut font = FontBuilder::new();
        font.add_table(&cmap).map_err(|error| problem(&error))?;
        for tag in KEPT.map(Tag::new) {
            if let Some(table) = whole.data_for_tag(tag) {
                font.add_raw(tag, table.as_bytes());
            }
        }
        // Version 3 of this table states that the glyphs have no names, and contains nothing else.
        font.add_raw(Tag::new(b"post"), [&[0, 3], &[0; 30][..]].concat());
        Ok(font.copy_missing_tables(outlines).build())
    }
}

#[cfg(test)]
mod tests {
    use egui::{Align2, Context, FontFamily, FontId, Painter, Rect, Vec2, pos2};

    use super::*;
    use crate::headless::UiPass;
    use crate::typesetting::theme;

    fn drawn(scale: f32, draw: impl Fn(&Painter)) -> Vec<Primitive> {
        let ctx = Context::default();
        theme::install_base(&ctx);
        let drawn = UiPass::draw(&ctx, [400, 300], scale, |ui| draw(ui.painter()));
        let mut maker = Maker { scale, primitives: Vec::new() };
        drawn.shapes.iter().for_each(|clipped| maker.shape(&clipped.shape));
        maker.primitives
    }

    fn text(primitive: &Primitive) -> Option<(String, Option<(Color32, f32)>)> {
        let Primitive::Text(text) = primitive else { return None };
        Some((text.runs.iter().map(|run| run.text.as_str()).collect(), text.halo))
    }

    #[test]
    fn letters_are_where_egui_put_them() {
        let font = FontId::proportional(20.0);
        // The text has a kerned pair, letters of two fonts, and letters that some fonts join.
        let written = "AV floor 𝑡 = ffi";
        let primitives = drawn(2.0, |painter| {
            painter.text(pos2(10.0, 5.0), Align2::LEFT_TOP, written, font.clone(), Color32::RED);
        });
        let [Primitive::Text(text)] = primitives.as_slice() else { panic!("{primitives:?}") };
        assert_eq!(text.runs.iter().map(|run| run.text.as_str()).collect::<String>(), written);
        assert!(text.runs.len() > 1 && text.halo.is_none());
        assert_eq!(text.runs[0].at[0], 20.0);
        let ctx = Context::default();
        theme::install_base(&ctx);
        let mut width = 0.0;
        UiPass::draw(&ctx, [400, 300], 2.0, |ui| {
            let galley =
                ui.painter().layout_no_wrap(written.to_owned(), font.clone(), Color32::RED);
            width = 2.0 * galley.size().x;
        });
        let last = text.runs.last().expect("a run");
        assert!((last.at[0] + last.width() - 20.0 - width).abs() < 1.0, "{text:?} {width}");
        for run in &text.runs {
            assert_eq!((run.size, run.color), (40.0, Color32::RED));
            let own = run.text.chars().map(|c| run.size * run.face.advance(c));
            let near = |(laid, own): (&f32, f32)| (laid - own).abs() < 0.15 * own + 1.0;
            assert!(run.advances.iter().zip(own).all(near), "{run:?}");
        }
    }

    #[test]
    fn text_with_a_halo_is_one_text() {
        let primitives = drawn(1.5, |painter| {
            let font = FontId::new(14.0, theme::bold());
            let galley = painter.layout_no_wrap("cased".to_owned(), font, Color32::BLACK);
            let text = HaloText::new(pos2(20.0, 20.0), galley, Color32::BLACK, Color32::WHITE);
            painter.add(text.into_shape());
            let font = FontId::new(14.0, FontFamily::Proportional);
            let galley =
                painter.layout_no_wrap("in another colour".to_owned(), font, Color32::BLACK);
            painter.galley_with_override_text_color(pos2(9.0, 9.0), galley, Color32::BLUE);
        });
        let texts: Vec<_> = primitives.iter().filter_map(text).collect();
        let [(cased, Some((color, reach))), (other, None)] = texts.as_slice() else {
            panic!("{texts:?}")
        };
        assert_eq!((cased.as_str(), *color), ("cased", Color32::WHITE));
        assert!((reach - 1.95).abs() < 0.01);
        assert_eq!(other, "in another colour");
        let Some(Primitive::Text(last)) = primitives.last() else { panic!("{primitives:?}") };
        assert_eq!(last.runs[0].color, Color32::BLUE);
    }

    #[test]
    fn shapes_are_fills_and_strokes_in_dots() {
        let stroke = Stroke::new(2.0, Color32::GREEN);
        let primitives = drawn(2.0, |painter| {
            painter.circle(pos2(10.0, 20.0), 5.0, Color32::RED, stroke);
            painter.line_segment([pos2(0.0, 0.0), pos2(3.0, 4.0)], stroke);
            let square = Rect::from_min_size(pos2(1.0, 1.0), Vec2::splat(4.0));
            painter.rect_filled(square, 0.0, Color32::BLUE);
        });
        let path = |outline, color, ink| Path { outline, color, ink };
        let circle = |radius| PathOutline::Circle { center: [20.0, 40.0], radius };
        let chain =
            |points: &[[f32; 2]], closed| PathOutline::Chain { points: points.to_vec(), closed };
        let pen = Ink::Stroke { width: 4.0, round: false, dash: None };
        let corners = [[2.0, 2.0], [10.0, 2.0], [10.0, 10.0], [2.0, 10.0]];
        let paths: Vec<Path> = primitives
            .into_iter()
            .map(|primitive| match primitive {
                Primitive::Path(path) => path,
                other => panic!("{other:?}"),
            })
            .collect();
        assert_eq!(
            paths,
            [
                path(circle(10.0), Color32::RED, Ink::Fill),
                path(circle(12.0), Color32::GREEN, pen),
                path(chain(&[[0.0, 0.0], [6.0, 8.0]], false), Color32::GREEN, pen),
                path(chain(&corners, true), Color32::BLUE, Ink::Fill),
            ]
        );
    }
}
