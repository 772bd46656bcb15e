//! Paints marks straight into the picture.

mod coverage;
pub(super) mod path;

use std::borrow::Borrow;
use std::f32::consts::PI;

use egui::Color32;
use pinhole_core::glam::Vec2;
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
    let Ink::Stroke { width, round, dash } = path.ink else { return built(&path.outline) };
    if let (Outline::Chain { points, .. }, None) = (&path.outline, dash)
        && let [from, to] = points[..]
        && let Some(line) = straight(from, to, 0.5 * width, round)
    {
        return Some(line);
    }
    let outline = built(&path.outline)?;
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

/// Returns the outline of a straight stroke, of which most marks consist: four corners, and between
/// them half circles if its ends are round. `None` of a line without a direction.
fn straight(from: [f32; 2], to: [f32; 2], half: f32, round: bool) -> Option<tiny_skia_path::Path> {
    let (from, to) = (Vec2::from(from), Vec2::from(to));
    let along = (to - from).try_normalize()?;
    // Lines at most a twentieth of a dot beside the circle, as (1 - cos(step / 2)) r.
    let sides = (PI * (half.max(1.0) / 0.4).sqrt()).ceil().clamp(4.0, 32.0);
    let sides = if round { sides } else { 1.0 };
    let mut path = PathBuilder::new();
    for (end, side) in [(to, -along.perp()), (from, along.perp())] {
        for k in 0..=sides as u32 {
            let point = end + half * Vec2::from_angle(k as f32 / sides * PI).rotate(side);
            match path.is_empty() {
                true => path.move_to(point.x, point.y),
                false => path.line_to(point.x, point.y),
            }
        }
    }
    path.close();
    path.finish()
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_stroke_is_the_strokers_own() {
        let dots = |path: &tiny_skia_path::Path| {
            let mut dots = vec![Color32::BLACK; 40 * 30];
            let filled = Filled::new(path, Color32::WHITE, [40, 30]).expect("a stroke");
            filled.paint(0, 40, &mut dots, &mut Scratch::default());
            dots
        };
        for (from, to) in [([5.0, 6.0], [33.0, 21.0]), ([30.0, 4.0], [30.0, 24.0])] {
            for (width, round) in [(0.8, false), (3.0, false), (3.0, true), (9.0, true)] {
                let own = straight(from, to, 0.5 * width, round).expect("a line");
                let outline = Outline::Chain { points: vec![from, to].into(), closed: false };
                let line_cap = if round { LineCap::Round } else { LineCap::Butt };
                let stroke = Stroke { width, line_cap, ..Stroke::default() };
                let theirs = built(&outline).and_then(|path| path.stroke(&stroke, 1.0));
                let pairs = dots(&own).into_iter().zip(dots(&theirs.expect("a stroke")));
                let largest = pairs.map(|(a, b)| a.r().abs_diff(b.r())).max();
                // The stroker keeps a quarter of a dot to a circle.
                assert!(largest <= Some(12), "{from:?} {to:?} {width} {round}: {largest:?}");
            }
        }
        assert_eq!(straight([1.0, 2.0], [1.0, 2.0], 1.0, true), None);
    }
}
