//! The plan of a frame, made before anything is drawn: which objects the rows can see, and what their
//! pixels share.

pub(crate) mod classify;

use std::ops::Range;

use fearless_simd::Level;
use rayon::prelude::*;

use crate::camera::resolved::ResolvedCamera;
use crate::render::bvh::visible::VisibleSpheres;
use crate::render::frame::Raster;
use crate::render::frame::counts::Counts;
use crate::render::outline::camera_space::CameraSpace;
use crate::render::outline::extent::{Extent, Extents};
use crate::render::outline::raster_axes::RasterAxes;
use crate::render::plan::classify::{Classified, Classifier, SLICE_ROWS};
use crate::render::polynomial::frame_rays::FrameRays;
use crate::render::rows::span::Span;
use crate::scene::Scene;
use crate::scene::object::Object;
use crate::scene::object_from_origin::ObjectFromOrigin;
use crate::scene::plane::Plane;

/// The parts that all bands of a frame share.
pub(crate) struct Plan<'a> {
    pub(crate) level: Level,
    pub(crate) scene: &'a Scene,
    pub(crate) rays: FrameRays<'a>,
    pub(crate) axes: RasterAxes,
    /// Spheres that are drawn by rows, near to far.
    pub(crate) spans: Vec<Span>,
    /// The others: for each run of spheres, for each slice of rows, those that it can see.
    others: Vec<Vec<Vec<(u32, Extent)>>>,
    /// The part of an index over the spheres that is seen; of few there is none.
    pub(crate) visible: Option<VisibleSpheres<'a>>,
    pub(crate) counts: Counts,
    /// True if spheres are so few that pixels are not cleared before them.
    pub(crate) is_written_once: bool,
    /// True if the frame is done before another thread would have begun.
    pub(crate) is_quick: bool,
    pub(crate) extents: Extents<'a>,
    /// `None` for one that an earlier one hides altogether.
    pub(crate) planes: Vec<Option<ObjectFromOrigin>>,
}

/// Spheres whose bounds one thread finds at a time.
const SPHERES_PER_RUN: usize = 8192;

/// Number of spheres up to which whole blocks, most of them written once, cost less than clearing all.
const MOST_WRITTEN_ONCE: usize = 64;

impl<'a> Plan<'a> {
    pub(crate) fn new(
        level: Level,
        scene: &'a Scene,
        camera: &'a ResolvedCamera,
        raster: &'a Raster,
    ) -> Self {
        let rays = FrameRays::new(camera, raster);
        let axes = RasterAxes::new(raster);
        let space = CameraSpace::new(camera);
        let extents = Extents::new(camera, raster);
        let space = space.is_plain.then_some(space);
        let mut counts = Counts { spheres: scene.spheres().len() as u64, ..Counts::default() };
        let visible = match (scene.index(), space) {
            (Some(index), Some(space)) => {
                Some(VisibleSpheres::new(level, index, space, (&axes, &extents), &mut counts))
            }
            _ => None,
        };
        let (mut spans, mut others) = (Vec::new(), Vec::new());
        if visible.is_none() {
            let classifier = Classifier { level, space, extents: &extents, axes: &axes };
            let runs = scene.spheres().chunks(SPHERES_PER_RUN).enumerate();
            let classify = |(run, spheres)| classifier.classify(spheres, run * SPHERES_PER_RUN);
            let classified: Vec<Classified> = if runs.len() > 1 {
                runs.collect::<Vec<_>>().into_par_iter().map(classify).collect()
            } else {
                runs.map(classify).collect()
            };
            for run in classified {
                counts += run.counts;
                spans.extend(run.spans);
                others.push(run.others);
            }
            spans.sort_unstable_by(|a, b| a.outline.nearest.total_cmp(&b.outline.nearest));
        }
        let seen = |plane| ObjectFromOrigin::new(&Object::Plane(plane), camera.eye());
        let planes = distinct(scene.planes()).map(|plane| plane.map(seen));
        let planes: Vec<Option<ObjectFromOrigin>> = planes.collect();
        let mut plan = Plan {
            level,
            scene,
            rays,
            axes,
            spans,
            others,
            visible,
            counts,
            is_written_once: false,
            is_quick: false,
            extents,
            planes,
        };
        plan.is_written_once = plan.visible.is_none() && plan.spans.len() <= MOST_WRITTEN_ONCE;
        plan.is_quick = plan.is_quick();
        plan
    }

    /// Returns whether a thread draws the frame, a few operations a pixel, in the time that others
    /// take to wake up.
    fn is_quick(&self) -> bool {
        const PIXELS: usize = 1 << 18;
        const SPANS: usize = 8;
        let has_others = self.others.iter().flatten().any(|slice| !slice.is_empty());
        let is_simple = self.visible.is_none() && self.planes.is_empty() && !has_others;
        is_simple && self.spans.len() <= SPANS && self.axes.pixels() <= PIXELS
    }

    /// The rows of each band, in the order in which threads take them.
    ///
    /// Of many spheres, what lies on the border of two bands is looked at twice: bands are of two
    /// slices, and of one towards the end, so that all threads are done at about the same time.
    pub(crate) fn bands(&self) -> Vec<Range<usize>> {
        /// The last rows are one part of so many.
        const LAST: usize = 4;
        let rows = self.axes.height();
        let mut bands = Vec::new();
        let mut first = 0;
        while first < rows {
            let is_wide = self.visible.is_some() && rows - first > rows / LAST;
            let last = rows.min(first + if is_wide { 2 * SLICE_ROWS } else { SLICE_ROWS });
            bands.push(first..last);
            first = last;
        }
        bands
    }

    /// The spheres, but those drawn by rows and those of an index, that a slice of rows can see.
    pub(crate) fn others(&self, slice: usize) -> impl Iterator<Item = (u32, Extent)> + '_ {
        self.others.iter().flat_map(move |run| &run[slice]).copied()
    }
}

/// The planes, with `None` for one that is the same set of points as an earlier one, which is seen
/// in its place.
fn distinct(planes: &[Plane]) -> impl Iterator<Item = Option<Plane>> + '_ {
    planes.iter().enumerate().map(|(index, plane)| {
        let is_hidden = planes[..index].iter().any(|earlier| earlier.is_same(plane));
        (!is_hidden).then_some(*plane)
    })
}
