//! A figure as a PDF of one page: strokes as strokes, text as text, in fonts that are in the file.
//!
//! Written by krilla: it takes glyphs with their places and keeps them text, where turning the SVG into a PDF
//! would lay the text out anew, and it embeds only the letters that are there.

use std::collections::HashMap;

use egui::Color32;
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

use super::primitive::{Page, Picture, Primitive, Run, Text};
use super::typeface::Face;
use crate::view::overlay::{Ink, Outline, Path};

/// PDF's points, of which an inch has 72, in a dot, of which it has 96 in style sheets.
const POINTS: f32 = 0.75;

/// The whole file.
pub(in crate::figures) fn write(page: &Page) -> Result<Vec<u8>, String> {
    let [width, height] = page.size.map(|n| n as f32);
    let settings =
        PageSettings::from_wh(POINTS * width, POINTS * height).ok_or("a page without extent")?;
    let mut document = Document::new();
    let metadata = Metadata::new().title(page.title.to_owned()).creator("Pinhole".to_owned());
    document.set_metadata(metadata.language("en".to_owned()));
    let mut paper = document.start_page_with(settings);
    let mut writer = Writer { surface: paper.surface(), fonts: HashMap::new() };
    writer.surface.push_transform(&Transform::from_scale(POINTS, POINTS));
    if let Some(ground) = page.ground {
        let corners = [[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]];
        let outline = Outline::Chain { points: corners.as_slice().into(), closed: true };
        writer.path(&Path { outline, color: ground, ink: Ink::Fill });
    }
    for primitive in &page.primitives {
        match primitive {
            Primitive::Picture(picture) => writer.picture(picture, [width, height]),
            Primitive::Path(path) => writer.path(path),
            Primitive::Text(text) => writer.text(text)?,
        }
    }
    writer.surface.pop();
    drop(writer);
    paper.finish();
    document.finish().map_err(|error| error.to_string())
}

struct Writer<'a> {
    surface: Surface<'a>,
    fonts: HashMap<Face, Font>,
}

impl Writer<'_> {
    fn picture(&mut self, picture: &Picture, [width, height]: [f32; 2]) {
        let bytes = picture.pixels.iter().flat_map(Color32::to_srgba_unmultiplied).collect();
        let [columns, rows] = picture.size.map(|n| n as u32);
        if let Some(size) = Size::from_wh(width, height) {
            self.surface.draw_image(Image::from_rgba8(bytes, columns, rows), size);
        }
    }

    fn path(&mut self, Path { outline, color, ink }: &Path) {
        let Some(outline) = built(outline) else { return };
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

    /// The casing as outlines, so that the text is there once.
    fn text(&mut self, text: &Text) -> Result<(), String> {
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

    fn run(&mut self, run: &Run, outlined: bool) -> Result<(), String> {
        let font = self.font(run.face)?;
        let letters = run.text.char_indices().zip(&run.advances);
        let glyphs: Vec<KrillaGlyph> = letters
            .map(|((byte, letter), advance)| {
                let glyph = run.face.glyph(letter).map_or(0, |glyph| glyph.to_u32());
                let range = byte..byte + letter.len_utf8();
                KrillaGlyph::new(
                    GlyphId::new(glyph),
                    advance / run.size,
                    0.0,
                    0.0,
                    0.0,
                    range,
                    None,
                )
            })
            .collect();
        let [x, y] = run.at;
        self.surface.push_transform(&Transform::from_row(1.0, 0.0, -run.slant, 1.0, x, y));
        let origin = Point::from_xy(0.0, 0.0);
        self.surface.draw_glyphs(origin, &glyphs, font, &run.text, run.size, outlined);
        self.surface.pop();
        Ok(())
    }

    fn font(&mut self, face: Face) -> Result<Font, String> {
        if let Some(font) = self.fonts.get(&face) {
            return Ok(font.clone());
        }
        let font = Font::new(face.shared().into(), 0);
        let font = font.ok_or_else(|| format!("the font {} is none", face.family()))?;
        self.fonts.insert(face, font.clone());
        Ok(font)
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

/// A quarter of a circle of radius 1 is a cubic curve whose handles are so long.
const QUARTER: f32 = 0.552_284_8;

fn built(outline: &Outline) -> Option<krilla::geom::Path> {
    let mut path = PathBuilder::new();
    match outline {
        Outline::Chain { points, closed } => {
            let (first, rest) = points.split_first()?;
            path.move_to(first[0], first[1]);
            for [x, y] in rest {
                path.line_to(*x, *y);
            }
            if *closed {
                path.close();
            }
        }
        Outline::Circle { center: [x, y], radius } => {
            let at = |right: f32, down: f32| (x + radius * right, y + radius * down);
            let (from_x, from_y) = at(1.0, 0.0);
            path.move_to(from_x, from_y);
            for [c, s] in [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0_f32]] {
                // (c, s) and, a quarter further on, (-s, c).
                let (x1, y1) = at(c - QUARTER * s, s + QUARTER * c);
                let (x2, y2) = at(-s + QUARTER * c, c + QUARTER * s);
                let (x3, y3) = at(-s, c);
                path.cubic_to(x1, y1, x2, y2, x3, y3);
            }
            path.close();
        }
    }
    path.finish()
}
