//! Some rows of a frame, and the objects that are added to them one after the other.

use std::cmp::Ordering;
use std::ops::Range;

use fearless_simd::{Level, Simd, dispatch};

use crate::blend::blend;
use crate::conic::{Conic, Patch};
use crate::double_double::DoubleDouble;
use crate::frame::{Depth, NO_OBJECT};
use crate::frame_rays::{FrameRays, Steppers};
use crate::kernel::{LaneNumber, PlaneRow, RoughDiscriminant, SphereRow, plane_row, sphere_row};
use crate::lanes::Lanes;
use crate::plane_seen::PlaneSeen;
use crate::scale::ldexp;
use crate::scene::{Object, Scene};
use crate::seen::{Hit, ObjectSeen};
use crate::sphere_seen::SphereSeen;
use crate::steps::Steps;
use crate::terms::{Number, SECOND_ORDER, SphereParts, UNDERFLOW, dot, length, near};

/// The widest vector there is: rows are padded to whole ones.
const LANES: usize = 8;

/// Rows of a frame with their part of the buffers. Objects are added in the order of their indices,
/// so "nearer than what is there" keeps the first of equals.
pub(crate) struct Band<'a, T> {
    level: Level,
    scene: &'a Scene,
    rays: &'a FrameRays<'a>,
    planes: &'a [ObjectSeen],
    rows: Range<usize>,
    t: &'a mut [T],
    object: &'a mut [u32],
    pub(crate) steps: Steps,
    /// Columns from the middle of the patch at hand.
    m: Vec<f64>,
    /// The kernels' answers for one row.
    found: Vec<f64>,
}

/// What a kernel does with one row: columns from the middle, row's l, answers.
type RowOf<'a> = &'a dyn Fn(&[f64], f64, &mut [f64]);

impl<'a, T: Depth> Band<'a, T> {
    pub(crate) fn new(
        level: Level,
        scene: &'a Scene,
        rays: &'a FrameRays<'a>,
        planes: &'a [ObjectSeen],
        rows: Range<usize>,
        t: &'a mut [T],
        object: &'a mut [u32],
    ) -> Self {
        let (m, found) = (Vec::new(), Vec::new());
        Band { level, scene, rays, planes, rows, t, object, steps: Steps::default(), m, found }
    }

    /// The patch that rows and columns of the raster make.
    fn patch(&self, rows: &Range<usize>, columns: &Range<usize>) -> Patch {
        let (n, l) = (&self.rays.n[columns.clone()], &self.rays.l[rows.clone()]);
        let (n0, l0) = (n[n.len() / 2], l[l.len() / 2]);
        let reach =
            |of: &[f64], from: f64| (of[0] - from).abs().max((of[of.len() - 1] - from).abs());
        Patch { n: n0, l: l0, columns: reach(n, n0), rows: reach(l, l0) }
    }

    /// Adds a sphere, which can cover these rows and columns of the raster at most.
    pub(crate) fn add_sphere(&mut self, index: u32, rows: Range<usize>, columns: Range<usize>) {
        let sphere = self.scene.spheres()[index as usize];
        let eye = self.rays.camera().eye();
        let patch = self.patch(&rows, &columns);
        // A patch of few pixels is not worth the coefficients in double-double.
        let is_small = rows.len() * columns.len() < 64;
        let kernel = if T::DOUBT > 1e-20 || is_small {
            let kernel = match SphereSeen::rough_parts(&sphere, eye) {
                Some(parts) => self.rough_kernel(&parts, Ordering::Greater, 0, &patch),
                None => {
                    let seen = SphereSeen::new(&sphere, eye);
                    self.rough_kernel(&seen.rough, seen.side, seen.scale, &patch)
                }
            };
            kernel.map(SphereKernel::Rough)
        } else {
            let seen = SphereSeen::new(&sphere, eye);
            self.fine_kernel(&seen, &patch).map(|fine| SphereKernel::Fine(Box::new(fine)))
        };
        let level = self.level;
        let row: RowOf = match &kernel {
            Some(SphereKernel::Rough(kernel)) => &|m, k, found| {
                dispatch!(level, simd => kernel.answer(simd, m, k, found));
            },
            Some(SphereKernel::Fine(kernel)) => &|m, k, found| {
                dispatch!(level, simd => kernel.answer(simd, m, k, found));
            },
            None => &|_, _, found| found.fill(crate::kernel::DOUBT),
        };
        self.add(index, rows, columns, &patch, row, None);
    }

    /// The kernel in `f64`; `None` where the units are extreme.
    fn rough_kernel(
        &self,
        parts: &SphereParts<f64>,
        side: Ordering,
        scale: i32,
        patch: &Patch,
    ) -> Option<RoughKernel> {
        let rays = &self.rays.rough;
        let factor = self.factor(scale)?;
        let conic = Conic::new(parts, rays, patch);
        let thresholds = conic.thresholds(parts, side, rays.least_length, T::DOUBT);
        Some(RoughKernel { conic, c: parts.c * factor, factor, side, thresholds })
    }

    /// The kernel in double-double; `None` where the units are extreme.
    fn fine_kernel(&self, seen: &SphereSeen, patch: &Patch) -> Option<FineKernel> {
        let rough = self.rough_kernel(&seen.rough, seen.side, seen.scale, patch)?;
        let rays = &self.rays.fine;
        let conic = Conic::new(&seen.fine, rays, patch);
        let thresholds = conic.thresholds(&seen.fine, seen.side, rays.least_length, T::DOUBT);
        let factor = DoubleDouble::from(rough.factor);
        Some(FineKernel { rough, conic, c: seen.fine.c * factor, factor, thresholds })
    }

    /// From the units of the polynomials to those of `t`.
    fn factor(&self, scale: i32) -> Option<f64> {
        let factor = ldexp(self.rays.stretch, scale - self.rays.scale);
        (1e-60..1e60).contains(&factor).then_some(factor)
    }

    /// Adds a plane.
    pub(crate) fn add_plane(&mut self, plane: usize) {
        let planes = self.planes;
        let ObjectSeen::Plane(seen) = &planes[plane] else { return };
        let index = (self.scene.spheres().len() + plane) as u32;
        let same = |other: &Object| matches!(other, Object::Plane(p) if p.is_same(seen.plane()));
        let earlier = self.scene.planes()[..plane].iter();
        if seen.side == Ordering::Equal || earlier.map(|p| Object::Plane(*p)).any(|p| same(&p)) {
            // The eye lies in it, or an earlier one is seen in its place.
            return;
        }
        let (rows, columns) = (self.rows.clone(), 0..self.rays.n.len());
        let patch = self.patch(&rows, &columns);
        let level = self.level;
        let (rough, fine);
        let row: RowOf = match self.factor(seen.scale) {
            None => &|_, _, found| found.fill(crate::kernel::DOUBT),
            Some(factor) if T::DOUBT > 1e-20 => {
                let rays = &self.rays.rough;
                rough = PlaneKernel::new(seen, seen.offset.hi * factor, rays, &patch, T::DOUBT);
                &|m, k, found| dispatch!(level, simd => rough.answer::<_, Lanes<_>>(simd, m, k, found))
            }
            Some(factor) => {
                let rays = &self.rays.fine;
                let offset = seen.offset * DoubleDouble::from(factor);
                fine = PlaneKernel::new(seen, offset, rays, &patch, T::DOUBT);
                &|m, k, found| dispatch!(level, simd => fine.answer::<_, DoubleDouble<Lanes<_>>>(simd, m, k, found))
            }
        };
        self.add(index, rows, columns, &patch, row, Some(&planes[plane]));
    }

    /// Asks every pixel of the patch.
    fn add(
        &mut self,
        index: u32,
        rows: Range<usize>,
        columns: Range<usize>,
        patch: &Patch,
        answer: RowOf,
        seen: Option<&ObjectSeen>,
    ) {
        let width = self.rays.n.len();
        let padded = columns.len().next_multiple_of(LANES);
        self.m.clear();
        self.m.extend(self.rays.n[columns.clone()].iter().map(|n| n - patch.n));
        self.m.resize(padded, 0.0);
        self.found.resize(padded, 0.0);
        let mut own = None;
        for row in rows {
            let mut found = std::mem::take(&mut self.found);
            answer(&self.m, self.rays.l[row] - patch.l, &mut found[..padded]);
            let start = (row - self.rows.start) * width;
            let place = start + columns.start..start + columns.end;
            let (t, object) = (&mut self.t[place.clone()], &mut self.object[place]);
            let level = self.level;
            let found_here = &mut found[..columns.len()];
            let in_doubt = dispatch!(level, simd => blend(simd, found_here, t, object, index));
            self.steps.f64 += columns.len() as u64;
            if in_doubt {
                for (step, found) in found_here.iter().enumerate() {
                    if found.is_nan() {
                        let seen =
                            seen.unwrap_or_else(|| own.get_or_insert_with(|| self.seen(index)));
                        self.settle(index, seen, row, columns.start + step);
                    }
                }
            }
            self.found = found;
        }
    }

    fn seen(&self, index: u32) -> ObjectSeen {
        let sphere = Object::Sphere(self.scene.spheres()[index as usize]);
        ObjectSeen::new(&sphere, self.rays.camera().eye())
    }

    /// One pixel by itself, up the ladder.
    #[cold]
    fn settle(&mut self, index: u32, seen: &ObjectSeen, row: usize, column: usize) {
        let camera = self.rays.camera();
        let ray = camera.exact_ray(self.rays.pixel(row, column));
        let place = (row - self.rows.start) * self.rays.n.len() + column;
        // The ladder counts this decision at its own step.
        self.steps.f64 -= 1;
        let Some(end) = seen.first_end(&ray, &mut self.steps) else { return };
        let hit = Hit { index, seen, end };
        let known = self.object[place];
        if known != NO_OBJECT
            && let Some(object) = self.scene.object(known)
        {
            let known_seen = ObjectSeen::new(&object, camera.eye());
            let end = known_seen.first_end(&ray, &mut Steps::default());
            let is_before = end.is_none_or(|end| {
                hit.is_before(&Hit { index: known, seen: &known_seen, end }, &ray, &mut self.steps)
            });
            if !is_before {
                return;
            }
        }
        self.t[place] = T::of(seen.t_within(&ray, end, T::DOUBT).to_f64());
        self.object[place] = index;
    }
}

enum SphereKernel {
    Rough(RoughKernel),
    Fine(Box<FineKernel>),
}

/// A sphere's polynomials in `f64`.
struct RoughKernel {
    conic: Conic<f64>,
    c: f64,
    factor: f64,
    side: Ordering,
    thresholds: crate::conic::Thresholds,
}

impl RoughKernel {
    fn rough(&self, k: f64) -> (RoughDiscriminant, SphereRow<f64>) {
        let conic = self.conic.row(k);
        let RoughKernel { c, factor, side, thresholds, .. } = *self;
        let rough = RoughDiscriminant { polynomial: conic.discriminant, miss: thresholds.miss };
        (rough, SphereRow { conic, c, factor, side, thresholds })
    }

    #[inline(always)]
    fn answer<S: Simd>(&self, simd: S, m: &[f64], k: f64, found: &mut [f64]) {
        let (rough, row) = self.rough(k);
        sphere_row::<S, Lanes<S>>(simd, m, &rough, &row, found);
    }
}

/// A sphere's polynomials in double-double, and in `f64` for what that decides.
struct FineKernel {
    rough: RoughKernel,
    conic: Conic<DoubleDouble>,
    c: DoubleDouble,
    factor: DoubleDouble,
    thresholds: crate::conic::Thresholds,
}

impl FineKernel {
    #[inline(always)]
    fn answer<S: Simd>(&self, simd: S, m: &[f64], k: f64, found: &mut [f64]) {
        let (rough, _) = self.rough.rough(k);
        let FineKernel { c, factor, thresholds, .. } = *self;
        let side = self.rough.side;
        let row = SphereRow { conic: self.conic.row(k), c, factor, side, thresholds };
        sphere_row::<S, DoubleDouble<Lanes<S>>>(simd, m, &rough, &row, found);
    }
}

/// A plane's `normal . direction` as a polynomial in columns m and rows k from the middle.
struct PlaneKernel<T> {
    offset: T,
    rate: [T; 3],
    hit: f64,
    miss: f64,
    sign: f64,
}

impl<T: Number> PlaneKernel<T> {
    /// With S the longest direction of the patch and P the direction's doubt, the rate is off by
    /// `|n| S (DOT + P)`, and by two steps of a product and a sum where it is put together. `t` is
    /// off by that over the rate, by the offset's share, and by its own operations.
    fn new(
        seen: &PlaneSeen,
        offset: T,
        rays: &Steppers<T>,
        patch: &Patch,
        t_doubt: f64,
    ) -> PlaneKernel<T> {
        let vectors = [rays.direction(patch.n, patch.l), rays.e, rays.g];
        let normal = seen.normal.map(T::from);
        let corner = |[x0, x1, x2]: [f64; 3]| x0 + patch.columns * x1 + patch.rows * x2;
        let reach = corner(vectors.map(|v| length(near(v))));
        let step = T::PRODUCT + T::SUM;
        let share = SECOND_ORDER * (T::DOT + 2.0 * step + rays.doubt());
        let doubt = share * length(seen.normal) * reach + UNDERFLOW;
        let left = t_doubt - seen.offset_doubt() - T::QUOTIENT - 2.0 * T::PRODUCT;
        PlaneKernel {
            offset,
            rate: vectors.map(|v| dot(normal, v)),
            hit: if left > 0.0 { doubt.max(doubt / left) } else { f64::INFINITY },
            miss: doubt,
            sign: if seen.side == Ordering::Less { -1.0 } else { 1.0 },
        }
    }

    #[inline(always)]
    fn answer<S: Simd, N: LaneNumber<S, Scalar = T>>(
        &self,
        simd: S,
        m: &[f64],
        k: f64,
        found: &mut [f64],
    ) {
        let PlaneKernel { offset, hit, miss, sign, .. } = *self;
        let rate = [self.rate[0] + T::from(k) * self.rate[2], self.rate[1]];
        plane_row::<S, N>(simd, m, &PlaneRow { offset, rate, hit, miss, sign }, found);
    }
}
