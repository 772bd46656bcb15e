//! Paints marks straight into the picture.

mod coverage;
pub(super) mod path;

use std::borrow::Borrow;

use egui::Color32;
use rayon::prelude::*;
use tiny_skia_path::{LineCap, LineJoin, PathBuilder, Stroke, StrokeDash};

use self::coverage::{Filled, Scratch};
use crate::view::overlay::drawing::Drawing;
use crate::view::overlay::paint::path::{Ink, Outline, Path};

/// Rows of dots that are painted at a time: what a band is painted with stays in the cache.
const BAND: usize = 32;

/// Paths prepared for painting.
#[derive(Debug, Default)]
pub(super) struct Fills(Vec<Filled>);

impl Fills {
    /// Prepares the marks of a drawing for a picture of this width and height.
    pub(super) fn new(drawing: &Drawing, size: [usize; 2]) -> Fills {
        Fills::of_paths(drawing.paths(), size)
    }

    fn of_paths<'a>(
        paths: impl Iterator<Item: Borrow<Path<'a>> + Sync>,
        size: [usize; 2],
    ) -> Fills {
        let paths: Vec<_> = paths.collect();
        let filled = paths.par_iter().with_min_len(8).filter_map(|path| {
            let path = path.borrow();
            Filled::new(&outlined(path)?, path.color, size)
        });
        Fills(filled.collect())
    }

    /// Paints a picture of `width` dots a row in bands of rows, side by side: each by `before`, which
    /// is told the band's first row, and then by the paths.
    pub(super) fn paint_after(
        &self,
        width: usize,
        dots: &mut [Color32],
        before: impl Fn(usize, &mut [Color32]) + Sync,
    ) {
        if width == 0 {
            return;
        }
        let bands = dots.par_chunks_mut(BAND * width).enumerate();
        bands.for_each_init(Scratch::default, |scratch, (band, dots)| {
            before(band * BAND, dots);
            self.0.iter().for_each(|filled| filled.paint(band * BAND, width, dots, scratch));
        });
    }
}

/// Paints paths over a picture of `width` dots a row.
pub fn paint_paths<'a>(
    paths: impl Iterator<Item: Borrow<Path<'a>> + Sync>,
    width: usize,
    dots: &mut [Color32],
) {
    let height = dots.len().checked_div(width).unwrap_or(0);
    Fills::of_paths(paths, [width, height]).paint_after(width, dots, |_, _| ());
}

/// Returns the outline to fill: a path's own, or that of its stroke.
fn outlined(path: &Path) -> Option<tiny_skia_path::Path> {
    let outline = built(&path.outline)?;
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

fn built(outline: &Outline) -> Option<tiny_skia_path::Path> {
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
