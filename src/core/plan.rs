//! What a frame does, decided before it is done: which objects the rows can see, and what their
//! pixels share.

use std::collections::HashMap;
use std::ops::Range;

use fearless_simd::Level;
use rayon::prelude::*;

use crate::bounds::{Bounds, PixelBounds};
use crate::depth::Depth;
use crate::frame::Raster;
use crate::frame_rays::FrameRays;
use crate::object_kernel::FineKernel;
use crate::plane::Plane;
use crate::posed::PosedCamera;
use crate::scene::{Object, Scene};
use crate::seen::ObjectSeen;
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
    /// For each run of spheres, for each band, those that it can see; in the order of objects.
    visible: Vec<Vec<Vec<Visible>>>,
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

/// For each band, the spheres of a run that it can see; `first` is the run's first index.
fn visible_by_band(
    spheres: &[Sphere],
    first: usize,
    bounds: &Bounds,
    raster: &Raster,
) -> Vec<Vec<Visible>> {
    let part_of = |cells: &Range<u32>, of: &[u32]| {
        let place = |cell: u32| of.partition_point(|x| *x < cell) as u16;
        place(cells.start)..place(cells.end)
    };
    let mut bands = Vec::new();
    bands.resize_with(raster.rows().len().div_ceil(BAND_ROWS), Vec::new);
    for (index, sphere) in (first..).zip(spheres) {
        let Some(PixelBounds { rows, columns }) = bounds.of(sphere) else { continue };
        let (rows, columns) = (part_of(&rows, raster.rows()), part_of(&columns, raster.columns()));
        if rows.is_empty() || columns.is_empty() {
            continue;
        }
        let (rows, band) = (usize::from(rows.start)..usize::from(rows.end), BAND_ROWS);
        for seen_in in &mut bands[rows.start / band..rows.end.div_ceil(band)] {
            let rows = rows.start as u16..rows.end as u16;
            seen_in.push(Visible { index: index as u32, rows, columns: columns.clone() });
        }
    }
    bands
}

impl<'a> Plan<'a> {
    pub(crate) fn new<T: Depth>(
        level: Level,
        scene: &'a Scene,
        camera: &'a PosedCamera,
        raster: &'a Raster,
    ) -> Self {
        let bounds = Bounds::new(camera);
        let rays = FrameRays::new(camera, raster, T::IS_FINE);
        let visible: Vec<Vec<Vec<Visible>>> = scene
            .spheres()
            .par_chunks(SPHERES_PER_RUN)
            .enumerate()
            .map(|(run, spheres)| visible_by_band(spheres, run * SPHERES_PER_RUN, &bounds, raster))
            .collect();
        let seen = |plane| ObjectSeen::new(&Object::Plane(plane), camera.eye());
        let planes = distinct(scene.planes()).map(|plane| plane.map(seen));
        let planes = planes.collect();
        let mut plan = Plan { level, scene, rays, visible, planes, large: HashMap::new() };
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
