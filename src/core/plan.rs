//! What a frame does, decided before it is done: which objects the rows can see, and what their
//! pixels share.

use std::collections::HashMap;
use std::ops::Range;

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch};
use rayon::prelude::*;

use crate::bounds::{Bounds, PixelBounds};
use crate::camera_space::CameraSpace;
use crate::counts::Counts;
use crate::depth::Depth;
use crate::frame::Raster;
use crate::frame_rays::FrameRays;
use crate::object_kernel::FineKernel;
use crate::outline::{MOST_LANES, Outlines, Spheres};
use crate::plane::Plane;
use crate::posed::PosedCamera;
use crate::raster_axes::RasterAxes;
use crate::scene::{Object, Scene};
use crate::seen::ObjectSeen;
use crate::span::Span;
use crate::sphere::Sphere;
use crate::sphere_seen::SphereSeen;

/// Rows that one thread traces at a time.
pub(crate) const BAND_ROWS: usize = 32;

/// A sphere and the pixels of the raster (not of the image) that it can cover.
struct Visible {
    index: u32,
    rows: Range<u16>,
    columns: Range<u16>,
}

/// What all bands of a frame share.
pub(crate) struct Plan<'a> {
    pub(crate) level: Level,
    pub(crate) scene: &'a Scene,
    pub(crate) rays: FrameRays<'a>,
    pub(crate) axes: RasterAxes,
    /// Spheres that are drawn by rows, near to far.
    pub(crate) spans: Vec<Span>,
    /// The others: for each run of spheres, for each band, those that it can see; in the order of
    /// objects.
    visible: Vec<Vec<Vec<Visible>>>,
    pub(crate) counts: Counts,
    /// `None` for one that an earlier one hides altogether.
    pub(crate) planes: Vec<Option<ObjectSeen>>,
    /// Spheres that cover so much of the picture that coefficients from exact numbers, once a frame,
    /// save more pixels from going up the ladder than they cost.
    pub(crate) large: HashMap<u32, FineKernel>,
}

/// How many pixels a large sphere covers at least.
const LARGE: usize = 4096;

/// How many large spheres there are at most.
const MOST_LARGE: usize = 256;

/// Spheres whose bounds one thread finds at a time.
const SPHERES_PER_RUN: usize = 8192;

/// What a run of spheres is to a frame.
#[derive(Default)]
struct Sorted {
    spans: Vec<Span>,
    /// For each band.
    others: Vec<Vec<Visible>>,
    counts: Counts,
}

/// What sorting spheres takes of a frame.
struct Sorter<'a> {
    level: Level,
    /// `None` where all spheres are asked pixel by pixel.
    space: Option<CameraSpace>,
    bounds: Bounds<'a>,
    raster: &'a Raster,
    axes: &'a RasterAxes,
}

impl Sorter<'_> {
    /// Sorts a run of spheres, whose first index is `first`.
    fn sort(&self, spheres: &[Sphere], first: usize) -> Sorted {
        let mut sorted = Sorted::default();
        sorted.others.resize_with(self.raster.rows().len().div_ceil(BAND_ROWS), Vec::new);
        let Some(space) = &self.space else {
            for (index, sphere) in (first..).zip(spheres) {
                self.add_other(&mut sorted, index, sphere);
            }
            return sorted;
        };
        let mut outlines = Outlines::default();
        let lanes = lanes_of(self.level);
        for (group, some) in spheres.chunks(lanes).enumerate() {
            let side = |x: fn(&Sphere) -> f64| {
                std::array::from_fn::<f64, MOST_LANES, _>(|k| x(&some[k.min(some.len() - 1)]))
            };
            let (x, y, z) = (side(|s| s.center.x), side(|s| s.center.y), side(|s| s.center.z));
            let radius = side(|s| s.radius);
            let of = Spheres { x: &x, y: &y, z: &z, radius: &radius };
            dispatch!(self.level, simd => outlines.find(simd, space, &of));
            for (lane, sphere) in some.iter().enumerate() {
                let index = first + group * lanes + lane;
                self.add(&mut sorted, &outlines, lane, index, sphere);
            }
        }
        sorted
    }

    fn add(
        &self,
        sorted: &mut Sorted,
        outlines: &Outlines,
        lane: usize,
        index: usize,
        sphere: &Sphere,
    ) {
        if outlines.is_behind >> lane & 1 == 1 {
            sorted.counts.behind += 1;
        } else if outlines.is_outside >> lane & 1 == 1 {
            sorted.counts.outside += 1;
        } else if outlines.is_plain >> lane & 1 == 1
            && let Some(span) = Span::new(index as u32, &outlines.one(lane))
        {
            if span.rows(self.axes).is_empty() {
                sorted.counts.outside += 1;
            } else {
                sorted.counts.in_view += 1;
                sorted.spans.push(span);
            }
        } else {
            self.add_other(sorted, index, sphere);
        }
    }

    fn add_other(&self, sorted: &mut Sorted, index: usize, sphere: &Sphere) {
        let part_of = |cells: &Range<u32>, of: &[u32]| {
            let place = |cell: u32| of.partition_point(|x| *x < cell) as u16;
            place(cells.start)..place(cells.end)
        };
        let Some(PixelBounds { rows, columns }) = self.bounds.of(sphere) else {
            sorted.counts.outside += 1;
            return;
        };
        let (rows, columns) =
            (part_of(&rows, self.raster.rows()), part_of(&columns, self.raster.columns()));
        if rows.is_empty() || columns.is_empty() {
            sorted.counts.outside += 1;
            return;
        }
        sorted.counts.in_view += 1;
        let bands = usize::from(rows.start) / BAND_ROWS..usize::from(rows.end).div_ceil(BAND_ROWS);
        for seen_in in &mut sorted.others[bands] {
            let (rows, columns) = (rows.clone(), columns.clone());
            seen_in.push(Visible { index: index as u32, rows, columns });
        }
    }
}

/// How many `f64` a vector of the level has.
fn lanes_of(level: Level) -> usize {
    dispatch!(level, simd => lanes(simd))
}

#[inline(always)]
fn lanes<S: Simd>(_simd: S) -> usize {
    S::f64s::LEN
}

impl<'a> Plan<'a> {
    pub(crate) fn new<T: Depth>(
        level: Level,
        scene: &'a Scene,
        camera: &'a PosedCamera,
        raster: &'a Raster,
    ) -> Self {
        let rays = FrameRays::new(camera, raster, T::IS_FINE);
        let axes = RasterAxes::new(raster);
        let space = CameraSpace::new(camera);
        let sorter = Sorter {
            level,
            space: (!T::IS_FINE && space.is_plain).then_some(space),
            bounds: Bounds::new(camera),
            raster,
            axes: &axes,
        };
        let sorted: Vec<Sorted> = scene
            .spheres()
            .par_chunks(SPHERES_PER_RUN)
            .enumerate()
            .map(|(run, spheres)| sorter.sort(spheres, run * SPHERES_PER_RUN))
            .collect();
        let mut counts = Counts { spheres: scene.spheres().len() as u64, ..Counts::default() };
        let (mut spans, mut visible) = (Vec::new(), Vec::new());
        for run in sorted {
            counts += run.counts;
            spans.extend(run.spans);
            visible.push(run.others);
        }
        spans.sort_unstable_by(|a, b| a.outline.nearest.total_cmp(&b.outline.nearest));
        let seen = |plane| ObjectSeen::new(&Object::Plane(plane), camera.eye());
        let planes = distinct(scene.planes()).map(|plane| plane.map(seen));
        let planes = planes.collect();
        let large = HashMap::new();
        let mut plan = Plan { level, scene, rays, axes, spans, visible, counts, planes, large };
        if T::IS_FINE {
            plan.prepare_large::<T>();
        }
        plan
    }

    fn prepare_large<T: Depth>(&mut self) {
        let camera = self.rays.camera();
        let mut steppers = None;
        for Visible { index, rows, columns } in self.visible.iter().flatten().flatten() {
            let area = rows.len() * columns.len();
            if area < LARGE || self.large.len() >= MOST_LARGE || self.large.contains_key(index) {
                continue;
            }
            let sphere = &self.scene.spheres()[*index as usize];
            let seen = SphereSeen::new(sphere, camera.eye());
            let patch = self.rays.patch(&whole(rows), &whole(columns));
            let steppers = steppers.get_or_insert_with(|| camera.big_steppers());
            let (conic, near_root) = steppers.conic(sphere, &patch, seen.scale, self.rays.scale);
            if let Some(kernel) =
                FineKernel::new::<T>(&self.rays, &seen, conic, Some(near_root), &patch)
            {
                self.large.insert(*index, kernel);
            }
        }
    }

    /// The spheres that a band of rows can see, in the order of objects, with the pixels that each
    /// can cover.
    pub(crate) fn seen_by(
        &self,
        rows: Range<usize>,
    ) -> impl Iterator<Item = (u32, Range<usize>, Range<usize>)> + '_ {
        let band = rows.start / BAND_ROWS;
        self.visible.iter().flat_map(move |run| &run[band]).map(move |visible| {
            let own = whole(&visible.rows);
            let own = own.start.max(rows.start)..own.end.min(rows.end);
            (visible.index, own, whole(&visible.columns))
        })
    }
}

fn whole(range: &Range<u16>) -> Range<usize> {
    usize::from(range.start)..usize::from(range.end)
}

/// The planes, with `None` for one that is the same set of points as an earlier one, which is seen
/// in its place.
fn distinct(planes: &[Plane]) -> impl Iterator<Item = Option<Plane>> + '_ {
    planes.iter().enumerate().map(|(index, plane)| {
        let is_hidden = planes[..index].iter().any(|earlier| earlier.is_same(plane));
        (!is_hidden).then_some(*plane)
    })
}
