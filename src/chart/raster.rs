//! A figure as pixels: shapes by tiny-skia, text with the window's own fonts.

use egui::{Align2, Color32, FontFamily, FontId, Pos2, pos2};
use tiny_skia::{FillRule, Paint, Path, PathBuilder, PixmapMut, Stroke, StrokeDash, Transform};

use super::figure::{Align, DASH, Figure, Ink, Place, Shape};
use crate::view::headless;
use crate::view::typesetting::fonts;

/// A figure's pixels, opaque sRGB, row by row from the top.
pub struct Raster {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Red, green, blue, opacity.
    pub pixels: Vec<[u8; 4]>,
}

impl Figure {
    /// Draws it with so many pixels to a point.
    pub fn to_pixels(&self, per_point: f32) -> Raster {
        let measure = |points: f64| (points * f64::from(per_point)).ceil().max(1.0) as usize;
        let size = [measure(self.width), measure(self.height)];
        let mut pixels = vec![Color32::WHITE; size[0] * size[1]];
        let bytes = bytemuck::cast_slice_mut(&mut pixels);
        if let Some(mut pixmap) = PixmapMut::from_bytes(bytes, size[0] as u32, size[1] as u32) {
            for shape in &self.shapes {
                draw(shape, &mut pixmap, Transform::from_scale(per_point, per_point));
            }
        }
        headless::draw_text(&mut pixels, size, per_point, |painter| {
            for shape in &self.shapes {
                write(shape, painter);
            }
        });
        Raster {
            width: size[0] as u32,
            height: size[1] as u32,
            pixels: pixels.iter().map(|pixel| pixel.to_array()).collect(),
        }
    }
}

fn draw(shape: &Shape, pixmap: &mut PixmapMut, to_pixels: Transform) {
    let outline = |pixmap: &mut PixmapMut,
                   path: &Path,
                   (color, width): (Ink, f64),
                   dash: Option<StrokeDash>| {
        let stroke = Stroke { width: width as f32, dash, ..Stroke::default() };
        pixmap.stroke_path(path, &paint(color), &stroke, to_pixels, None);
    };
    match shape {
        Shape::Line { points, color, width, dashed } => {
            let dash = || StrokeDash::new(DASH.map(|x| x as f32).to_vec(), 0.0);
            if let Some(path) = path_of(points, false) {
                outline(pixmap, &path, (*color, *width), dashed.then(dash).flatten());
            }
        }
        Shape::Polygon { points, fill, stroke } => {
            let Some(path) = path_of(points, true) else { return };
            if let Some(fill) = fill {
                pixmap.fill_path(&path, &paint(*fill), FillRule::Winding, to_pixels, None);
            }
            if let Some(stroke) = stroke {
                outline(pixmap, &path, *stroke, None);
            }
        }
        Shape::Ring { center: [x, y], radius, color, width } => {
            if let Some(path) = PathBuilder::from_circle(*x as f32, *y as f32, *radius as f32) {
                outline(pixmap, &path, (*color, *width), None);
            }
        }
        Shape::Text { .. } => {}
    }
}

fn write(shape: &Shape, painter: &egui::Painter) {
    let Shape::Text { at: [x, y], align, text, size, bold, color: [r, g, b] } = shape else {
        return;
    };
    let anchor = match align {
        Align::Left => Align2::LEFT_CENTER,
        Align::Middle => Align2::CENTER_CENTER,
        Align::Right => Align2::RIGHT_CENTER,
    };
    let family = if *bold { fonts::bold() } else { FontFamily::Proportional };
    let at: Pos2 = pos2(*x as f32, *y as f32);
    let font = FontId::new(*size as f32, family);
    painter.text(at, anchor, text, font, Color32::from_rgb(*r, *g, *b));
}

fn path_of(points: &[Place], closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    let (first, rest) = points.split_first()?;
    path.move_to(first[0] as f32, first[1] as f32);
    for [x, y] in rest {
        path.line_to(*x as f32, *y as f32);
    }
    if closed {
        path.close();
    }
    path.finish()
}

fn paint([r, g, b]: Ink) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(r, g, b, 255);
    paint
}
