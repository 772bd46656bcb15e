//! Marks into pixels, by tiny-skia, straight into the picture's bytes.

use egui::Color32;
use tiny_skia::{
    FillRule, LineCap, LineJoin, Paint, PathBuilder, PixmapMut, Stroke, StrokeDash, Transform,
};

use crate::overlay::drawing::Drawing;
use crate::overlay::path::{Ink, Outline, Path};

impl Drawing {
    /// Paints the marks over a picture of `width` dots a row.
    pub fn paint(&self, width: usize, dots: &mut [Color32]) {
        let height = dots.len().checked_div(width).unwrap_or(0);
        let bytes = bytemuck::cast_slice_mut(&mut dots[..width * height]);
        let Some(mut pixmap) = PixmapMut::from_bytes(bytes, width as u32, height as u32) else {
            return;
        };
        for path in self.paths() {
            paint(&path, &mut pixmap);
        }
    }
}

fn paint(path: &Path, pixmap: &mut PixmapMut) {
    let Some(outline) = built(&path.outline) else { return };
    let mut color = Paint::default();
    let [r, g, b, a] = path.color.to_srgba_unmultiplied();
    color.set_color_rgba8(r, g, b, a);
    match path.ink {
        Ink::Fill => {
            pixmap.fill_path(&outline, &color, FillRule::Winding, Transform::identity(), None);
        }
        Ink::Stroke { width, round, dash } => {
            let stroke = Stroke {
                width,
                line_cap: if round { LineCap::Round } else { LineCap::Butt },
                line_join: LineJoin::Round,
                dash: dash.and_then(|dash| StrokeDash::new(dash.to_vec(), 0.0)),
                ..Stroke::default()
            };
            pixmap.stroke_path(&outline, &color, &stroke, Transform::identity(), None);
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
