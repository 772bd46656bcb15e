//! The plan of a frame, made before drawing: which objects are visible, how each sphere is drawn, and
//! the data that the pixels share.

use std::ops::Range;

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch};

use crate::camera::resolved::ResolvedCamera;
use crate::render::bvh::visible::VisibleSpheres;
use crate::render::frame::Raster;
use crate::render::outline::raster_axes::{CameraSpace, RasterAxes};
use crate::render::outline::{Extent, Extents, MOST_LANES, Outlines};
use crate::render::polynomial::frame_rays::FrameRays;
use crate::render::rows::span::Span;
use crate::scene::Scene;
use crate::scene::object::Object;
use crate::scene::object_from_origin::ObjectFromOrigin;
use crate::scene::plane::Plane;
use crate::scene::sphere::Sphere;
use crate::scene::sphere_index::SphereSlots;

/// The data that all bands of a frame share.
pub(crate) struct Plan<'a> {
    pub(crate) level: Level,
    pub(crate) scene: &'a Scene,
    pub(crate) rays: FrameRays<'a>,
    pub(crate) axes: RasterAxes,
    /// Spheres that are drawn by rows, near to far.
    pub(crate) spans: Vec<Span>,
    /// For each slice of [`SLICE_ROWS`] rows, the spheres visible in it that are drawn by polynomials,
    /// not by rows; empty if `visible` is not `None`.
    others: Vec<Vec<(u32, Extent)>>,
    /// The visible part of the sphere index; `None` if there are few spheres.
    pub(crate) visible: Option<VisibleSpheres<'a>>,
    /// Number of spheres that were left out because they cannot be seen.
    pub(crate) left_out: u64,
    /// True if there are so few spheres that the pixels need not be cleared before drawing.
    pub(crate) is_written_once: bool,
    /// True if one thread can finish the frame before a second one could start.
    pub(crate) is_quick: bool,
    pub(crate) extents: Extents<'a>,
    /// The planes; `None` for a plane that an earlier one hides completely.
    pub(crate) planes: Vec<Option<ObjectFromOrigin>>,
}

/// Maximum number of spheres for which it costs less to write whole SIMD vectors of pixels, most of them
/// once, than to clear all pixels first.
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
        let visible = match (scene.index(), space) {
            (Some(index), Some(space)) => {
                Some(VisibleSpheres::new(level, index, space, (&axes, &extents)))
            }
            _ => None,
        };
        let Classified { mut spans, others, left_out } = match &visible {
            Some(VisibleSpheres { left_out, .. }) => {
                Classified { left_out: *left_out, ..Classified::default() }
            }
            None => Classifier { level, space, extents: &extents, axes: &axes }
                .classify(scene.spheres()),
        };
        spans.sort_unstable_by(|a, b| a.outline.nearest.total_cmp(&b.outline.nearest));
        let seen = |plane| ObjectFromOrigin::new(&Object::Plane(plane), camera.eye());
        let planes: Vec<Option<ObjectFromOrigin>> =
            distinct(scene.planes()).map(|plane| plane.map(seen)).collect();
        /// Maximum numbers of pixels and spheres with which one thread, at a few operations per pixel,
        /// can finish the frame before a second one could start.
        const QUICK: (usize, usize) = (1 << 18, 8);
        let has_others = others.iter().any(|slice| !slice.is_empty());
        let is_quick = visible.is_none()
            && planes.is_empty()
            && !has_others
            && axes.pixels() <= QUICK.0
            && spans.len() <= QUICK.1;
        Plan {
            level,
            scene,
            rays,
            is_written_once: visible.is_none() && spans.len() <= MOST_WRITTEN_ONCE,
            is_quick,
            axes,
            spans,
            others,
            visible,
            left_out,
            extents,
            planes,
        }
    }

    /// Returns the rows of each band, in the order in which threads take the bands.
    ///
    /// A sphere on the border of two bands is examined twice, so with many spheres a band has two slices
    /// of [`SLICE_ROWS`] rows. Towards the end it has one, so that all threads finish at about the same
    /// time.
    pub(crate) fn bands(&self) -> Vec<Range<usize>> {
        /// The last `rows / LAST` rows are in bands of one slice.
        const LAST: usize = 4;
        let rows = self.axes.height;
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

    /// Returns the spheres visible in a slice of [`SLICE_ROWS`] rows that are neither drawn by rows nor
    /// found by the sphere index.
    pub(crate) fn others(&self, slice: usize) -> impl Iterator<Item = (u32, Extent)> + '_ {
        self.others.get(slice).into_iter().flatten().copied()
    }
}

/// Returns the planes, with `None` in place of each plane that coincides with an earlier one, which
/// hides it.
fn distinct(planes: &[Plane]) -> impl Iterator<Item = Option<Plane>> + '_ {
    planes.iter().enumerate().map(|(index, plane)| {
        let is_hidden = planes[..index].iter().any(|earlier| earlier.is_same(plane));
        (!is_hidden).then_some(*plane)
    })
}

/// Number of rows in a slice. An object's polynomials are made for one slice at a time, and each band
/// consists of whole slices.
pub(crate) const SLICE_ROWS: usize = 32;

/// Spheres, classified by how they are drawn.
#[derive(Default)]
pub(crate) struct Classified {
    pub(crate) spans: Vec<Span>,
    /// For each slice of [`SLICE_ROWS`] rows, the spheres visible in it that are drawn by polynomials,
    /// not by rows.
    pub(crate) others: Vec<Vec<(u32, Extent)>>,
    /// Number of spheres that were left out because they cannot be seen.
    pub(crate) left_out: u64,
}

/// The data that is needed to classify spheres.
pub(crate) struct Classifier<'a> {
    pub(crate) level: Level,
    /// The camera's coordinate system; `None` if it is so extreme that no outline can be computed, and
    /// every sphere is drawn by polynomials.
    pub(crate) space: Option<CameraSpace>,
    pub(crate) extents: &'a Extents<'a>,
    pub(crate) axes: &'a RasterAxes,
}

impl Classifier<'_> {
    /// Classifies the spheres of a scene.
    pub(crate) fn classify(&self, spheres: &[Sphere]) -> Classified {
        let mut classified = Classified::default();
        classified.others.resize_with(self.axes.height.div_ceil(SLICE_ROWS), Vec::new);
        let Some(space) = &self.space else {
            for (index, sphere) in spheres.iter().enumerate() {
                self.add_other(&mut classified, index, sphere);
            }
            return classified;
        };
        let mut outlines = Outlines::default();
        let lanes = dispatch!(self.level, simd => lanes(simd));
        for (group, some) in spheres.chunks(lanes).enumerate() {
            let side = |x: fn(&Sphere) -> f64| {
                std::array::from_fn::<f64, MOST_LANES, _>(|k| x(&some[k.min(some.len() - 1)]))
            };
            let (x, y, z) = (side(|s| s.center.x), side(|s| s.center.y), side(|s| s.center.z));
            let radius = side(|s| s.radius);
            let slots: SphereSlots = [&x, &y, &z, &radius];
            dispatch!(self.level, simd => outlines.find(simd, space, &slots));
            for (lane, sphere) in some.iter().enumerate() {
                let index = group * lanes + lane;
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
        if (outlines.is_behind | outlines.is_outside) >> lane & 1 == 1 {
            classified.left_out += 1;
        } else if outlines.is_plain >> lane & 1 == 1 {
            let span = Span::new(index as u32, &outlines.one(lane));
            if span.rows(self.axes).is_empty() {
                classified.left_out += 1;
            } else {
                classified.spans.push(span);
            }
        } else {
            self.add_other(classified, index, sphere);
        }
    }

    fn add_other(&self, classified: &mut Classified, index: usize, sphere: &Sphere) {
        let Some(extent) = self.extents.find(sphere) else {
            classified.left_out += 1;
            return;
        };
        let rows = extent.rows();
        for seen_in in
            &mut classified.others[rows.start / SLICE_ROWS..rows.end.div_ceil(SLICE_ROWS)]
        {
            seen_in.push((index as u32, extent));
        }
    }
}

/// Returns the number of `f64` lanes in a SIMD vector.
#[inline(always)]
fn lanes<S: Simd>(_simd: S) -> usize {
    S::f64s::LEN
}
