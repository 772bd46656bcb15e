//! Writes a figure as a PDF with one page and embedded fonts. Strokes and text are not converted to
//! outlines.
//!
//! The file is written by the crate krilla, which takes positioned glyphs, keeps them as selectable
//! text, and embeds only the letters that occur. The alternative, converting the SVG with `krilla-svg`,
//! would lay out the text again letter by letter, write each text that has a casing (a halo that
//! separates it from the picture) twice, and require 23 more crates.

use std::collections::HashMap;

use egui::{Color32, ColorImage};
use krilla::Document;
use krilla::color::rgb;
use krilla::geom::{PathBuilder, Point, Size, Transform};
use krilla::image::Image;
use krilla::metadata::Metadata;
use krilla::num::NormalizedF32;
use krilla::page::PageSettings;
use krilla::paint::{Fill, FillRule, LineCap, LineJoin, Stroke, StrokeDash};
use krilla::surface::Surface;
use krilla::text::{Font, GlyphId, KrillaGlyph};
use pinhole_core::Ellipse;
use tiny_skia::PathSegment;

use super::{CasedText, FontName, LetterRun, Primitive, primitives};
use crate::export::{Figure, SphereEdges};
use crate::overlay::{Ink, Path, PathOutline};

/// Number of PDF points per dot of the figure. An inch has 72 points and, as in CSS, 96 dots.
const POINTS: f32 = 0.75;

/// Writes the whole file.
pub(in crate::export) fn write(figure: &Figure) -> Result<Vec<u8>, String> {
    let [width, height] = figure.size.map(|n| n as f32);
    let size = Size::from_wh(width, height).ok_or("a page without extent")?;
    let settings =
        PageSettings::from_wh(POINTS * width, POINTS * height).ok_or("a page without extent")?;
    let mut document = Document::new();
    let metadata = Metadata::new().title(figure.title.clone()).creator("Pinhole".to_owned());
    document.set_metadata(metadata.language("en".to_owned()));
    let mut page = document.start_page_with(settings);
    let mut writer = Writer { surface: page.surface(), fonts: HashMap::new() };
    writer.surface.push_transform(&Transform::from_scale(POINTS, POINTS));
    if let Some(color) = figure.ground {
        let corners = [[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]];
        let outline = PathOutline::Chain { points: corners.into(), closed: true };
        writer.path(&Path { outline, color, ink: Ink::Fill });
    }
    if let Some(picture) = &figure.picture {
        writer.surface.draw_image(image(picture), size);
    }
    if let SphereEdges { outlines, picture: Some(picture) } = &figure.spheres {
        let image = image(picture);
        for outline in outlines.iter().filter_map(ellipse) {
            writer.surface.push_clip_path(&outline, &FillRule::NonZero);
            writer.surface.draw_image(image.clone(), size);
            writer.surface.pop();
        }
    }
    for primitive in primitives(figure) {
        match primitive {
            Primitive::Path(path) => writer.path(&path),
            Primitive::Text(text) => writer.text(&text)?,
        }
    }
    writer.surface.pop();
    drop(writer);
    page.finish();
    document.finish().map_err(|error| error.to_string())
}

struct Writer<'a> {
    surface: Surface<'a>,
    fonts: HashMap<FontName, Option<Font>>,
}

impl Writer<'_> {
    fn path(&mut self, Path { outline, color, ink }: &Path) {
        let Some(outline) = outline.to_path().as_ref().and_then(built) else { return };
        let (fill, stroke) = match *ink {
            Ink::Fill => (Some(fill(*color)), None),
            Ink::Stroke { width, round, dash } => {
                let line_cap = if round { LineCap::Round } else { LineCap::Butt };
                let dash = dash.map(|dash| StrokeDash { array: dash.to_vec(), offset: 0.0 });
                (None, Some(Stroke { line_cap, dash, ..stroke(*color, width) }))
            }
        };
        self.surface.set_fill(fill);
        self.surface.set_stroke(stroke);
        self.surface.draw_path(&outline);
    }

    /// Writes a text. Its casing (the halo around its letters), if any, is written first, as stroked
    /// outlines, so that the file contains the text itself only once.
    fn text(&mut self, text: &CasedText) -> Result<(), String> {
        if let Some((color, reach)) = text.halo {
            self.surface.set_fill(None);
            self.surface.set_stroke(Some(stroke(color, 2.0 * reach)));
            text.runs.iter().try_for_each(|run| self.run(run, true))?;
        }
        self.surface.set_stroke(None);
        text.runs.iter().try_for_each(|run| {
            self.surface.set_fill(Some(fill(run.color)));
            self.run(run, false)
        })
    }

    fn run(&mut self, run: &LetterRun, outlined: bool) -> Result<(), String> {
        let LetterRun { text, face, size, at: [x, y], advances, slant, .. } = run;
        let font = self.fonts.entry(*face).or_insert_with(|| Font::new(face.data().into(), 0));
        let font =
            font.clone().ok_or_else(|| format!("the font {} is unreadable", face.family()))?;
        let glyph = |((byte, letter), advance): ((usize, char), &f32)| {
            let glyph = GlyphId::new(face.glyph(letter).map_or(0, |glyph| glyph.to_u32()));
            let range = byte..byte + letter.len_utf8();
            KrillaGlyph::new(glyph, advance / size, 0.0, 0.0, 0.0, range, None)
        };
        let glyphs: Vec<KrillaGlyph> = text.char_indices().zip(advances).map(glyph).collect();
        self.surface.push_transform(&Transform::from_row(1.0, 0.0, -slant, 1.0, *x, *y));
        let origin = Point::from_xy(0.0, 0.0);
        self.surface.draw_glyphs(origin, &glyphs, font, text, *size, outlined);
        self.surface.pop();
        Ok(())
    }
}

fn parts_of(color: Color32) -> (rgb::Color, NormalizedF32) {
    let [r, g, b, a] = color.to_srgba_unmultiplied();
    let opacity = NormalizedF32::new(f32::from(a) / 255.0).unwrap_or(NormalizedF32::ONE);
    (rgb::Color::new(r, g, b), opacity)
}

fn fill(color: Color32) -> Fill {
    let (color, opacity) = parts_of(color);
    Fill { paint: color.into(), opacity, rule: FillRule::NonZero }
}

fn stroke(color: Color32, width: f32) -> Stroke {
    let (color, opacity) = parts_of(color);
    Stroke { paint: color.into(), opacity, width, line_join: LineJoin::Round, ..Stroke::default() }
}

fn image(ColorImage { size: [columns, rows], pixels, .. }: &ColorImage) -> Image {
    let bytes = pixels.iter().flat_map(Color32::to_srgba_unmultiplied).collect();
    Image::from_rgba8(bytes, *columns as u32, *rows as u32)
}

fn ellipse(Ellipse { center, axes: [a, b] }: &Ellipse) -> Option<krilla::geom::Path> {
    let [[ax, ay], [bx, by], [x, y]] = [a, b, center].map(|at| at.as_vec2().to_array());
    let placed = tiny_skia::Transform::from_row(ax, ay, bx, by, x, y);
    built(&tiny_skia::PathBuilder::from_circle(0.0, 0.0, 1.0)?.transform(placed)?)
}

fn built(outline: &tiny_skia::Path) -> Option<krilla::geom::Path> {
    let mut path = PathBuilder::new();
    for segment in outline.segments() {
        match segment {
            PathSegment::MoveTo(to) => path.move_to(to.x, to.y),
            PathSegment::LineTo(to) => path.line_to(to.x, to.y),
            PathSegment::QuadTo(a, to) => path.quad_to(a.x, a.y, to.x, to.y),
            PathSegment::CubicTo(a, b, to) => path.cubic_to(a.x, a.y, b.x, b.y, to.x, to.y),
            PathSegment::Close => path.close(),
        }
    }
    path.finish()
}
