//! Paints marks straight into the picture, by tiny-skia.

use std::borrow::Borrow;

use egui::Color32;
use rayon::prelude::*;
use tiny_skia::{FillRule, LineCap, LineJoin, Paint, PixmapMut, Stroke, StrokeDash, Transform};

use crate::view::overlay::drawing::Drawing;
use crate::view::overlay::path::{Ink, Path};

/// Rows of dots that are painted at a time: what a band is painted with stays in the cache.
const BAND: usize = 32;

/// Paths prepared for painting: outlines to fill, each with its colour.
#[derive(Debug, Default)]
pub(super) struct Fills(Vec<(tiny_skia::Path, Paint<'static>)>);

impl Fills {
    /// Prepares the marks of a drawing.
    pub(super) fn new(drawing: &Drawing) -> Fills {
        Fills::of_paths(drawing.paths())
    }

    fn of_paths<'a>(paths: impl Iterator<Item: Borrow<Path<'a>> + Sync>) -> Fills {
        let paths: Vec<_> = paths.collect();
        let filled = paths.par_iter().with_min_len(8).filter_map(|path| {
            let path = path.borrow();
            let [r, g, b, a] = path.color.to_srgba_unmultiplied();
            let mut paint = Paint::default();
            paint.set_color_rgba8(r, g, b, a);
            Some((outlined(path)?, paint))
        });
        Fills(filled.collect())
    }

    /// Paints a picture of `width` dots a row in bands of rows, in parallel: each first by `before`,
    /// which gets the band's first row, and then by the paths.
    pub(super) fn paint_after(
        &self,
        width: usize,
        dots: &mut [Color32],
        before: impl Fn(usize, &mut [Color32]) + Sync,
    ) {
        if width == 0 {
            return;
        }
        dots.par_chunks_mut(BAND * width).enumerate().for_each(|(band, dots)| {
            before(band * BAND, dots);
            self.paint_band(band * BAND, width, dots);
        });
    }

    /// Paints the band of rows that starts at row `top`. A dot of egui has tiny-skia's layout: four
    /// bytes, premultiplied.
    fn paint_band(&self, top: usize, width: usize, dots: &mut [Color32]) {
        let height = dots.len() / width;
        let bytes = bytemuck::cast_slice_mut(dots);
        let Some(mut band) = PixmapMut::from_bytes(bytes, width as u32, height as u32) else {
            return;
        };
        let (above, below) = (top as f32, (top + height) as f32);
        let moved = Transform::from_translate(0.0, -above);
        for (path, paint) in &self.0 {
            if path.bounds().bottom() > above && path.bounds().top() < below {
                band.fill_path(path, paint, FillRule::Winding, moved, None);
            }
        }
    }
}

/// Paints paths over a picture of `width` dots a row.
pub fn paint_paths<'a>(
    paths: impl Iterator<Item: Borrow<Path<'a>> + Sync>,
    width: usize,
    dots: &mut [Color32],
) {
    Fills::of_paths(paths).paint_after(width, dots, |_, _| ());
}

/// Returns the outline to fill: a path's own, or that of its stroke.
fn outlined(path: &Path) -> Option<tiny_skia::Path> {
    let outline = path.outline.to_path()?;
    let Ink::Stroke { width, round, dash } = path.ink else { return Some(outline) };
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
    outline.stroke(&stroke, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::overlay::path::Outline;

    const WIDTH: usize = 40;

    /// Paints a path in white on 40 x 100 black dots, which are several bands, and returns the shares
    /// covered.
    fn covered(points: &[[f32; 2]], ink: Ink) -> Vec<f32> {
        let outline = Outline::Chain { points: points.into(), closed: true };
        let path = Path { outline, color: Color32::WHITE, ink };
        let mut dots = vec![Color32::BLACK; WIDTH * 100];
        paint_paths(std::iter::once(&path), WIDTH, &mut dots);
        dots.into_iter().map(|dot| f32::from(dot.r()) / 255.0).collect()
    }

    #[test]
    fn bands_have_no_seam() {
        let shares = covered(&[[5.5, 3.0], [35.5, 3.0], [35.5, 97.0], [5.5, 97.0]], Ink::Fill);
        for (row, shares) in shares.chunks(WIDTH).enumerate() {
            let inside = if (3..97).contains(&row) { 1.0 } else { 0.0 };
            assert!(shares[6..35].iter().all(|share| *share == inside), "{row}");
            assert!((shares[5] - 0.5 * inside).abs() < 0.01, "{row}");
        }
    }

    #[test]
    fn a_strokes_overlaps_are_painted_once() {
        let ink = Ink::Stroke { width: 4.0, round: true, dash: None };
        let shares = covered(&[[8.0, 8.0], [30.0, 8.0], [30.0, 22.0], [8.0, 22.0]], ink);
        let at = |x: usize, y: usize| shares[y * WIDTH + x];
        assert_eq!([at(8, 7), at(20, 8), at(29, 21), at(8, 15)], [1.0; 4]);
        assert_eq!([at(20, 15), at(2, 2), at(35, 15)], [0.0; 3], "inside and beside it");
    }

    #[test]
    fn what_lies_beside_the_picture_or_is_no_number_leaves_it_alone() {
        for far in [-100.0, 100.0, 1e9, -1e30, f32::INFINITY, f32::NAN] {
            for [x, y] in [[far, 10.0], [10.0, far]] {
                let shares = covered(&[[x, y], [x + 9.0, y], [x + 9.0, y + 9.0]], Ink::Fill);
                assert!(shares.iter().all(|share| *share == 0.0), "{x} {y}");
            }
        }
    }
}
