//! The way that each sphere of a frame is drawn, if it can be seen at all.

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch};

use crate::render::frame::counts::Counts;
use crate::render::outline::camera_space::CameraSpace;
use crate::render::outline::extent::{Extent, Extents};
use crate::render::outline::raster_axes::RasterAxes;
use crate::render::outline::{MOST_LANES, Outlines};
use crate::render::rows::span::Span;
use crate::scene::sphere::Sphere;
use crate::scene::sphere_index::SphereSlots;

/// Rows in a slice: what the polynomials of one object are made for. Bands are whole slices.
pub(crate) const SLICE_ROWS: usize = 32;

/// A run of spheres by the way they are drawn.
#[derive(Default)]
pub(crate) struct Classified {
    pub(crate) spans: Vec<Span>,
    /// The others, for each slice of rows.
    pub(crate) others: Vec<Vec<(u32, Extent)>>,
    pub(crate) counts: Counts,
}

/// The parts of a frame that it takes to classify spheres.
pub(crate) struct Classifier<'a> {
    pub(crate) level: Level,
    /// `None` where all spheres are asked pixel by pixel.
    pub(crate) space: Option<CameraSpace>,
    pub(crate) extents: &'a Extents<'a>,
    pub(crate) axes: &'a RasterAxes,
}

impl Classifier<'_> {
    /// Sorts a run of spheres, whose first index is `first`.
    pub(crate) fn classify(&self, spheres: &[Sphere], first: usize) -> Classified {
        let mut classified = Classified::default();
        classified.others.resize_with(self.axes.height().div_ceil(SLICE_ROWS), Vec::new);
        let Some(space) = &self.space else {
            for (index, sphere) in (first..).zip(spheres) {
                self.add_other(&mut classified, index, sphere);
            }
            return classified;
        };
        let mut outlines = Outlines::default();
        let lanes = lanes_of(self.level);
        for (group, some) in spheres.chunks(lanes).enumerate() {
            let side = |x: fn(&Sphere) -> f64| {
                std::array::from_fn::<f64, MOST_LANES, _>(|k| x(&some[k.min(some.len() - 1)]))
            };
            let (x, y, z) = (side(|s| s.center.x), side(|s| s.center.y), side(|s| s.center.z));
            let radius = side(|s| s.radius);
            let slots: SphereSlots = [&x, &y, &z, &radius];
            dispatch!(self.level, simd => outlines.find(simd, space, &slots));
            for (lane, sphere) in some.iter().enumerate() {
                let index = first + group * lanes + lane;
                self.add(&mut classified, &outlines, lane, index, sphere);
            }
        }
        classified
    }

    fn add(
        &self,
        classified: &mut Classified,
        outlines: &Outlines,
        lane: usize,
        index: usize,
        sphere: &Sphere,
    ) {
        if outlines.is_behind >> lane & 1 == 1 {
            classified.counts.behind += 1;
        } else if outlines.is_outside >> lane & 1 == 1 {
            classified.counts.outside += 1;
        } else if outlines.is_plain >> lane & 1 == 1 {
            let span = Span::new(index as u32, &outlines.one(lane));
            if span.rows(self.axes).is_empty() {
                classified.counts.outside += 1;
            } else {
                classified.counts.in_view += 1;
                classified.spans.push(span);
            }
        } else {
            self.add_other(classified, index, sphere);
        }
    }

    fn add_other(&self, classified: &mut Classified, index: usize, sphere: &Sphere) {
        let Some(extent) = self.extents.find(sphere) else {
            classified.counts.outside += 1;
            return;
        };
        classified.counts.in_view += 1;
        let rows = extent.rows();
        for seen_in in
            &mut classified.others[rows.start / SLICE_ROWS..rows.end.div_ceil(SLICE_ROWS)]
        {
            seen_in.push((index as u32, extent));
        }
    }
}

/// Returns the number of `f64` in a vector of the level.
fn lanes_of(level: Level) -> usize {
    dispatch!(level, simd => lanes(simd))
}

#[inline(always)]
fn lanes<S: Simd>(_simd: S) -> usize {
    S::f64s::LEN
}
