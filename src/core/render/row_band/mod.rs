//! A band of rows of a frame, into which objects are drawn one after the other.

pub(crate) mod fallback;
pub(crate) mod rough_hits;
pub(crate) mod segments;

use std::cmp::Ordering;
use std::mem;
use std::ops::Range;

use fearless_simd::{Level, Simd, dispatch};

use crate::exact::quadratic::{Quadratic, SphereTerms};
use crate::exact::steps::{Step, Steps};
use crate::render::bvh::{DrawnSpheres, draw_visible};
use crate::render::outline::Extent;
use crate::render::plan::{Plan, SLICE_ROWS};
use crate::render::polynomial::frame_rays::Patch;
use crate::render::polynomial::object_kernel::{EVERYWHERE, PlaneKernel, SphereKernel, factor};
use crate::render::polynomial::{DOUBT, blend, is_in_doubt, pixel_hit, to_single};
use crate::render::row_band::fallback::{KnownObjects, PixelQuery, seen_sphere};
use crate::render::row_band::rough_hits::KeptHit;
use crate::render::row_band::segments::Segments;
use crate::render::rows::span::{Doubt, SpanTarget, Unhidden};
use crate::render::rows::{VectorBounds, WrittenBlocks, clear};
use crate::scene::object_from_origin::ObjectFromOrigin;
use crate::scene::sphere_predicates::SphereFromOrigin;

/// The number of `f64` lanes of the widest SIMD vector: rows are padded to a multiple of it.
const LANES: usize = 8;

/// Rows of a frame with their part of the buffers. Objects may be added in any order. If two hits are
/// too close to call, the ladder decides which comes first; of equal hits, that of the object listed
/// first is taken.
pub(crate) struct RowBand<'a> {
    pub(crate) plan: &'a Plan<'a>,
    pub(crate) rows: Range<usize>,
    pub(crate) t: &'a mut [f32],
    pub(crate) object: &'a mut [u32],
    pub(crate) steps: Steps,
    /// Which blocks (SIMD vectors of pixels) have been written so far, while spheres are drawn by rows
    /// into buffers that were not cleared; otherwise `None`.
    written: Option<WrittenBlocks>,
    /// Where drawing by rows continues: at this sphere of the plan or, if there are many spheres, at
    /// this visible group and block. `None` if all are drawn.
    next: Option<(usize, usize)>,
    /// Pixels that drawing by rows could not decide, left to the ladder.
    doubts: Vec<Doubt>,
    /// For each pixel, the hit in `f64` of the sphere that it shows, if it was in doubt; empty if few
    /// were.
    hits: Vec<Option<KeptHit>>,
    /// Number of pixels left to the ladder one by one.
    asked: usize,
    known_objects: KnownObjects,
    drawn: DrawnSpheres,
    /// For each row, true if an object's outline reaches it.
    is_reached: Vec<bool>,
    /// The position m of each column, counted from the middle of the current patch as in
    /// [`Conic`](crate::render::polynomial::conic::Conic).
    m: Vec<f64>,
    /// The kernel's result for each pixel of one row: `t`, or that the ray misses, or that the kernel
    /// cannot decide.
    found: Vec<f64>,
}

/// Maximum number of pixels for which intersecting each pixel's ray costs less than making a sphere's
/// polynomials.
const FEW_PIXELS: usize = 64;

/// An object's polynomials over a rectangle of pixels (a patch).
enum Kernel {
    Sphere(SphereKernel),
    Plane(PlaneKernel),
    /// No polynomials, because lengths are extreme: the ladder decides every pixel.
    Unknown,
}

impl Kernel {
    /// Returns a range of column positions that contains all hits of row k, see [`SphereKernel::reach`];
    /// `None` if the row has none.
    fn reach(&self, k: f64) -> Option<[f64; 2]> {
        if let Kernel::Sphere(kernel) = self { kernel.reach(k) } else { Some(EVERYWHERE) }
    }

    /// Computes the answers in one row, see [`SphereKernel::answer`].
    fn answer(&self, level: Level, m: &[f64], k: f64, found: &mut [f64]) {
        match self {
            Kernel::Sphere(kernel) => dispatch!(level, simd => kernel.answer(simd, m, k, found)),
            Kernel::Plane(kernel) => dispatch!(level, simd => kernel.answer(simd, m, k, found)),
            Kernel::Unknown => found.fill(DOUBT),
        }
    }
}

impl<'a> RowBand<'a> {
    pub(crate) fn new(
        plan: &'a Plan<'a>,
        rows: Range<usize>,
        t: &'a mut [f32],
        object: &'a mut [u32],
    ) -> Self {
        let size = (rows.len(), plan.axes.width);
        let written = if plan.is_written_once {
            let new = dispatch!(plan.level, simd => WrittenBlocks::new(simd, size, t, object));
            Some(new)
        } else {
            dispatch!(plan.level, simd => clear(simd, t, object));
            None
        };
        RowBand {
            plan,
            written,
            is_reached: vec![false; rows.len()],
            rows,
            t,
            object,
            steps: Steps::default(),
            next: Some((0, 0)),
            doubts: Vec::new(),
            hits: Vec::new(),
            asked: 0,
            known_objects: KnownObjects::default(),
            drawn: DrawnSpheres::default(),
            m: Vec::new(),
            found: Vec::new(),
        }
    }

    /// Draws the near and the large spheres first, because they hide many of the others. Does nothing if
    /// there are few spheres.
    pub(crate) fn draw_large(&mut self) {
        let plan = self.plan;
        for (index, extent) in plan.visible.iter().flat_map(|visible| &visible.others) {
            self.add_in_slices(*index, extent);
        }
    }

    /// Draws spheres by rows, until all are drawn or too many undecided pixels have accumulated. Returns
    /// false if no sphere was left to draw.
    pub(crate) fn draw_rows(&mut self) -> bool {
        let RowBand { plan, rows, t, object, written, next, doubts, drawn, is_reached, .. } = self;
        let (plan, Some(from)) = (*plan, *next) else { return false };
        let mut segments = Segments::new(plan, &self.hits, &mut self.known_objects);
        let mut unhidden = |index, pixels, object: &_| segments.unhidden(index, pixels, object);
        let mut target = SpanTarget {
            axes: &plan.axes,
            rows: rows.clone(),
            t,
            object,
            written: written.as_mut(),
            doubts,
            unhidden: (!self.hits.is_empty()).then_some(&mut unhidden as Unhidden),
            has_vector_bounds: plan.axes.are_whole()
                && plan.visible.as_ref().is_some_and(|visible| visible.is_crowded),
            bounds: VectorBounds::NONE,
            is_reached,
            is_all_reached: false,
            decided: 0,
        };
        *next = dispatch!(plan.level, simd => draw(simd, plan, from, &mut target, drawn));
        self.steps.f64 += target.decided;
        if let Some(written) = self.written.take() {
            let (width, t, object) = (plan.axes.width, &mut *self.t, &mut *self.object);
            dispatch!(plan.level, simd => written.clear_others(simd, width, t, object));
        }
        true
    }

    /// Draws the spheres that cannot be drawn by rows, and the planes.
    pub(crate) fn draw_others(&mut self) {
        let plan = self.plan;
        for index in mem::take(&mut self.drawn.others) {
            if let Some(extent) = plan.extents.find(&plan.scene.spheres()[index as usize]) {
                self.add_in_slices(index, &extent);
            }
        }
        for slice in self.slices() {
            for (index, extent) in plan.others(slice.start / SLICE_ROWS) {
                self.add_sphere(index, &slice, &extent);
            }
            for (plane, seen) in plan.planes.iter().enumerate() {
                if let Some(seen) = seen {
                    self.add_plane(plane, seen, slice.clone());
                }
            }
        }
    }

    /// Returns the number of decisions at each step, the number of spheres that were left out while the
    /// band was drawn, and the number of rows that no outline reaches.
    pub(crate) fn counted(self) -> (Steps, u64, u64) {
        let untouched = self.is_reached.iter().filter(|is_reached| !**is_reached).count();
        (self.steps, self.drawn.left_out, untouched as u64)
    }

    /// Returns the slices of rows that make up the band.
    fn slices(&self) -> impl Iterator<Item = Range<usize>> + use<> {
        let Range { start, end } = self.rows;
        (start..end).step_by(SLICE_ROWS).map(move |from| from..end.min(from + SLICE_ROWS))
    }

    /// Marks these rows of the raster as reached by an object's outline.
    fn reach(&mut self, rows: &Range<usize>) {
        let start = self.rows.start;
        self.is_reached[rows.start - start..rows.end - start].fill(true);
    }

    fn add_in_slices(&mut self, index: u32, extent: &Extent) {
        for slice in self.slices() {
            self.add_sphere(index, &slice, extent);
        }
    }

    /// Adds a sphere that covers no pixels outside this extent to a slice.
    fn add_sphere(&mut self, index: u32, slice: &Range<usize>, extent: &Extent) {
        let (rows, columns) = (extent.rows(), extent.columns());
        let rows = rows.start.max(slice.start)..rows.end.min(slice.end);
        if rows.is_empty() {
            return;
        }
        self.reach(&rows);
        let sphere = self.plan.scene.spheres()[index as usize];
        let eye = self.plan.rays.camera.eye();
        let parts = SphereFromOrigin::rough_terms(&sphere, eye);
        let is_per_pixel = rows.len() * columns.len() <= FEW_PIXELS;
        if is_per_pixel
            && let Some(parts) = &parts
            && let Some(factor) = factor(&self.plan.rays, 0)
        {
            return self.add_per_pixel(index, rows, columns, parts, factor);
        }
        let patch = self.plan.rays.patch(&rows, &columns);
        let rays = &self.plan.rays;
        let kernel = match parts {
            Some(parts) => SphereKernel::new(rays, &parts, Ordering::Greater, 0, &patch),
            None => {
                let seen = SphereFromOrigin::new(&sphere, eye);
                // Counted once, in the sphere's first slice.
                if seen.side_step > Step::F64 && rows.start == extent.rows().start {
                    self.steps.count(seen.side_step);
                }
                SphereKernel::new(rays, &seen.rough, seen.side, seen.scale, &patch)
            }
        };
        let kernel = kernel.map_or(Kernel::Unknown, Kernel::Sphere);
        self.add(index, rows, columns, &patch, &kernel, None);
    }

    /// Adds a sphere that covers so few pixels that intersecting each pixel's ray in `f64` costs less
    /// than making polynomials.
    fn add_per_pixel(
        &mut self,
        index: u32,
        rows: Range<usize>,
        columns: Range<usize>,
        parts: &SphereTerms<f64>,
        factor: f64,
    ) {
        let rays = &self.plan.rays;
        let width = rays.n.len();
        let mut own = None;
        for row in rows {
            self.steps.f64 += columns.len() as u64;
            for column in columns.clone() {
                let quadratic = Quadratic::new(parts, &rays.rough_direction(row, column));
                let offset = (row - self.rows.start) * width + column;
                let found = pixel_hit(&quadratic, parts, factor, self.t[offset]);
                if found.is_nan() {
                    let seen = own.get_or_insert_with(|| seen_sphere(self.plan, index));
                    self.resolve_exactly(&PixelQuery { index, seen, row, column, t: None });
                } else if found < f64::INFINITY {
                    (self.t[offset], self.object[offset]) = (to_single(found), index);
                }
            }
        }
    }

    /// Adds a plane, unless the eye lies in the plane: then no ray hits it.
    fn add_plane(&mut self, plane: usize, seen_by_eye: &ObjectFromOrigin, rows: Range<usize>) {
        let ObjectFromOrigin::Plane(seen) = seen_by_eye else { return };
        if seen.side_step > Step::F64 && rows.start == 0 {
            self.steps.count(seen.side_step);
        }
        if seen.side == Ordering::Equal {
            return;
        }
        self.reach(&rows);
        let index = (self.plan.scene.spheres().len() + plane) as u32;
        let columns = 0..self.plan.rays.n.len();
        let patch = self.plan.rays.patch(&rows, &columns);
        let kernel = factor(&self.plan.rays, seen.scale).map_or(Kernel::Unknown, |factor| {
            Kernel::Plane(PlaneKernel::new(seen, factor, &self.plan.rays.steppers, &patch))
        });
        self.add(index, rows, columns, &patch, &kernel, Some(seen_by_eye));
    }

    /// Evaluates an object's polynomials at the pixels of the patch that it can cover, and keeps the
    /// nearer hits.
    fn add(
        &mut self,
        index: u32,
        rows: Range<usize>,
        columns: Range<usize>,
        patch: &Patch,
        kernel: &Kernel,
        seen: Option<&ObjectFromOrigin>,
    ) {
        let padded = columns.len().next_multiple_of(LANES);
        self.m.clear();
        self.m.extend(self.plan.rays.n[columns.clone()].iter().map(|n| n - patch.n));
        self.m.resize(padded, 0.0);
        self.found.resize(padded, 0.0);
        let mut own = None;
        for row in rows {
            let k = self.plan.rays.l[row] - patch.l;
            let Some([low, high]) = kernel.reach(k) else { continue };
            let m = &self.m[..columns.len()];
            let from = m.partition_point(|m| *m < low) / LANES * LANES;
            let to = m.partition_point(|m| *m <= high);
            if from >= to {
                continue;
            }
            let mut found = std::mem::take(&mut self.found);
            let lanes = from..to.next_multiple_of(LANES);
            kernel.answer(self.plan.level, &self.m[lanes.clone()], k, &mut found[lanes]);
            let start = (row - self.rows.start) * self.plan.rays.n.len() + columns.start;
            let offset = start + from..start + to;
            let (t, object) = (&mut self.t[offset.clone()], &mut self.object[offset.clone()]);
            let (level, found_here) = (self.plan.level, &found[from..to]);
            let in_doubt = dispatch!(level, simd => blend(simd, found_here, t, object, index));
            self.steps.f64 += found_here.len() as u64;
            if in_doubt {
                for (offset, (column, found)) in
                    offset.zip((columns.start + from..).zip(found_here))
                {
                    if is_in_doubt(*found, self.t[offset], self.object[offset], index) {
                        let seen = seen.unwrap_or_else(|| {
                            own.get_or_insert_with(|| seen_sphere(self.plan, index))
                        });
                        self.resolve_exactly(&PixelQuery { index, seen, row, column, t: None });
                    }
                }
            }
            self.found = found;
        }
    }
}

#[inline(always)]
fn draw<S: Simd>(
    simd: S,
    plan: &Plan,
    from: (usize, usize),
    target: &mut SpanTarget,
    drawn: &mut DrawnSpheres,
) -> Option<(usize, usize)> {
    if let Some(visible) = &plan.visible {
        return draw_visible(simd, visible, from, target, drawn);
    }
    for (offset, span) in plan.spans.iter().enumerate().skip(from.0) {
        let (rows, columns) = (span.rows_in(target), 0..target.axes.width);
        span.draw(simd, target, rows, &columns);
        if target.is_full() {
            return Some((offset + 1, 0));
        }
    }
    None
}
