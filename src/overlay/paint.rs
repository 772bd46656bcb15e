//! Marks into pixels, by tiny-skia, straight into the picture's bytes.

use egui::Color32;
use tiny_skia::{
    FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, PixmapMut, Stroke, StrokeDash, Transform,
};

use crate::overlay::drawing::{Drawing, Mark, Shape};

/// How wide the casing of a mark is on each side, in points; of a thin line, as a share of it.
const HALO_WIDTH: f32 = 1.25;
const HALO_SHARE: f32 = 0.5;

/// Dash and gap of a hidden line, in points.
const DASH: [f32; 2] = [5.0, 4.5];

impl Drawing {
    /// Paints the marks over a picture of `width` dots a row.
    pub fn paint(&self, width: usize, dots: &mut [Color32]) {
        let height = dots.len().checked_div(width).unwrap_or(0);
        let bytes = bytemuck::cast_slice_mut(&mut dots[..width * height]);
        let Some(mut pixmap) = PixmapMut::from_bytes(bytes, width as u32, height as u32) else {
            return;
        };
        for mark in &self.marks {
            self.paint_mark(mark, &mut pixmap);
        }
    }

    fn paint_mark(&self, mark: &Mark, pixmap: &mut PixmapMut) {
        let Some(path) = path_of(&mark.shape) else { return };
        let full = HALO_WIDTH * self.scale;
        let (width, casing) = match mark.shape {
            Shape::Line { width, .. } => (width, full.min(HALO_SHARE * width)),
            Shape::Polygon { .. } | Shape::Disc { .. } => (0.0, full),
        };
        if let Some(halo) = mark.halo {
            let stroke = round_stroke(width + 2.0 * casing);
            pixmap.stroke_path(&path, &ink(halo), &stroke, Transform::identity(), None);
        }
        let color = ink(mark.color);
        match mark.shape {
            Shape::Line { .. } => {
                let mut stroke = round_stroke(width);
                if mark.hidden {
                    stroke.line_cap = LineCap::Butt;
                    stroke.dash = StrokeDash::new(DASH.map(|x| x * self.scale).to_vec(), 0.0);
                }
                pixmap.stroke_path(&path, &color, &stroke, Transform::identity(), None);
            }
            Shape::Polygon { .. } | Shape::Disc { .. } => {
                pixmap.fill_path(&path, &color, FillRule::Winding, Transform::identity(), None);
            }
        }
    }
}

fn path_of(shape: &Shape) -> Option<Path> {
    match shape {
        Shape::Line { points, .. } => {
            chain(points, points.len() > 2 && points.first() == points.last())
        }
        Shape::Polygon { points } => chain(points, true),
        Shape::Disc { center: [x, y], radius } => PathBuilder::from_circle(*x, *y, *radius),
    }
}

fn chain(points: &[[f32; 2]], closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    let (first, rest) = points.split_first()?;
    path.move_to(first[0], first[1]);
    for [x, y] in rest {
        path.line_to(*x, *y);
    }
    if closed {
        path.close();
    }
    path.finish()
}

fn round_stroke(width: f32) -> Stroke {
    Stroke { width, line_cap: LineCap::Round, line_join: LineJoin::Round, ..Stroke::default() }
}

fn ink(color: Color32) -> Paint<'static> {
    let mut paint = Paint::default();
    let [r, g, b, a] = color.to_srgba_unmultiplied();
    paint.set_color_rgba8(r, g, b, a);
    paint
}
