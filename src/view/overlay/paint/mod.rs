//! Paints marks with tiny-skia, straight into the picture's bytes.

pub(super) mod path;

use std::borrow::Borrow;

use egui::Color32;
use rayon::prelude::*;
use tiny_skia::{
    FillRule, LineCap, LineJoin, Paint, PathBuilder, PixmapMut, Stroke, StrokeDash, Transform,
};

use crate::view::overlay::drawing::Drawing;
use crate::view::overlay::paint::path::{Ink, Outline, Path};

/// Rows of dots that are painted at a time. The number does not depend on the number of threads, so
/// neither do the dots.
const BAND: usize = 128;

impl Drawing {
    /// Paints the marks over a picture of `width` dots a row.
    pub fn paint(&self, width: usize, dots: &mut [Color32]) {
        paint_paths(self.paths(), width, dots);
    }
}

/// Paints paths over a picture of `width` dots a row.
pub fn paint_paths<'a>(
    paths: impl Iterator<Item: Borrow<Path<'a>>>,
    width: usize,
    dots: &mut [Color32],
) {
    let height = dots.len().checked_div(width).unwrap_or(0);
    if height == 0 {
        return;
    }
    let strokes: Vec<_> = paths.filter_map(|path| Stroked::new(path.borrow())).collect();
    let bands = dots[..width * height].par_chunks_mut(BAND * width).enumerate();
    bands.for_each(|(band, dots)| {
        let (top, rows) = ((band * BAND) as f32, dots.len() / width);
        let bytes = bytemuck::cast_slice_mut(dots);
        let pixmap = PixmapMut::from_bytes(bytes, width as u32, rows as u32);
        let Some(mut pixmap) = pixmap else { return };
        let strokes = strokes.iter().filter(|stroke| stroke.reaches(top, rows as f32));
        strokes.for_each(|stroke| stroke.paint(top, &mut pixmap));
    });
}

/// A path prepared for tiny-skia: outlined once instead of once for each band.
struct Stroked {
    outline: tiny_skia::Path,
    paint: Paint<'static>,
    /// The stroke, if it is too thin to be drawn as an outline.
    hairline: Option<Stroke>,
}

/// Greatest width, in dots, that tiny-skia draws as a pale line one dot wide.
const HAIRLINE: f32 = 1.0;

impl Stroked {
    fn new(path: &Path) -> Option<Stroked> {
        let mut paint = Paint::default();
        let [r, g, b, a] = path.color.to_srgba_unmultiplied();
        paint.set_color_rgba8(r, g, b, a);
        let outline = built(&path.outline)?;
        let Ink::Stroke { width, round, dash } = path.ink else {
            return Some(Stroked { outline, paint, hairline: None });
        };
        let outline = match dash.and_then(|dash| StrokeDash::new(dash.to_vec(), 0.0)) {
            Some(dash) => outline.dash(&dash, 1.0)?,
            None => outline,
        };
        let stroke = Stroke {
            width,
            line_cap: if round { LineCap::Round } else { LineCap::Butt },
            line_join: LineJoin::Round,
            ..Stroke::default()
        };
        Some(if width <= HAIRLINE {
            Stroked { outline, paint, hairline: Some(stroke) }
        } else {
            Stroked { outline: outline.stroke(&stroke, 1.0)?, paint, hairline: None }
        })
    }

    /// Returns true if a part of it lies in the `rows` rows below `top`.
    fn reaches(&self, top: f32, rows: f32) -> bool {
        let bounds = self.outline.bounds();
        // The hairline's width, and a dot for antialiasing.
        let margin = HAIRLINE + 1.0;
        bounds.top() - margin < top + rows && bounds.bottom() + margin > top
    }

    /// Paints it into a picture that starts `top` dots below the drawing's top.
    fn paint(&self, top: f32, pixmap: &mut PixmapMut) {
        let transform = Transform::from_translate(0.0, -top);
        let (outline, paint) = (&self.outline, &self.paint);
        match &self.hairline {
            None => pixmap.fill_path(outline, paint, FillRule::Winding, transform, None),
            Some(stroke) => pixmap.stroke_path(outline, paint, stroke, transform, None),
        }
    }
}

fn built(outline: &Outline) -> Option<tiny_skia::Path> {
    let (points, closed) = match outline {
        Outline::Circle { center: [x, y], radius } => {
            return PathBuilder::from_circle(*x, *y, *radius);
        }
        Outline::Chain { points, closed } => (points, *closed),
    };
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
