//! An object's polynomials over a patch of pixels, and what they say of a row.

use std::cmp::Ordering;

use fearless_simd::Simd;

use crate::exact::bounded::{Number, SECOND_ORDER, UNDERFLOW, dot, length, near};
use crate::exact::double_double::DoubleDouble;
use crate::exact::lanes::Lanes;
use crate::exact::quadratic::SphereParts;
use crate::exact::scale::ldexp;
use crate::render::frame::depth::Depth;
use crate::render::polynomial::conic::{Conic, ConicRow, Thresholds};
use crate::render::polynomial::exact_conic::BigNearRoot;
use crate::render::polynomial::frame_rays::{FrameRays, Patch, Steppers};
use crate::render::polynomial::kernel::{
    LaneNumber, PlaneRow, RoughDiscriminant, SphereRow, plane_row, sphere_row,
};
use crate::scene::plane_predicates::PlaneSeen;
use crate::scene::sphere_predicates::SphereSeen;

/// From the units of the polynomials to those of `t`; `None` where they are extreme.
pub(crate) fn factor(rays: &FrameRays, scale: i32) -> Option<f64> {
    let factor = ldexp(rays.stretch, scale - rays.scale);
    (rays.is_plain() && (1e-60..1e60).contains(&factor)).then_some(factor)
}

pub(crate) enum SphereKernel {
    Rough(RoughKernel),
    Fine(Box<FineKernel>),
}

/// A sphere's polynomials in `f64`.
pub(crate) struct RoughKernel {
    conic: Conic<f64>,
    c: f64,
    factor: f64,
    side: Ordering,
    thresholds: Thresholds,
}

impl RoughKernel {
    /// `None` where the units are extreme.
    pub(crate) fn new<T: Depth>(
        rays: &FrameRays,
        parts: &SphereParts<f64>,
        side: Ordering,
        scale: i32,
        patch: &Patch,
    ) -> Option<RoughKernel> {
        let factor = factor(rays, scale)?;
        let conic = Conic::new(parts, &rays.rough, patch);
        let thresholds = conic.thresholds(parts, side, rays.rough.least_length, T::DOUBT);
        Some(RoughKernel { conic, c: parts.c * factor, factor, side, thresholds })
    }

    fn rough(&self, k: f64) -> (RoughDiscriminant, SphereRow<f64>) {
        let conic = self.conic.row(k);
        let RoughKernel { c, factor, side, thresholds, .. } = *self;
        let rough = RoughDiscriminant { polynomial: conic.discriminant, miss: thresholds.miss };
        (rough, SphereRow { conic, c, factor, side, thresholds })
    }

    /// From which to which m a row can have a hit, generously; `None` where it has none.
    pub(crate) fn reach(&self, k: f64) -> Option<[f64; 2]> {
        if self.side != Ordering::Greater {
            return Some(EVERYWHERE);
        }
        let ConicRow { b: [b0, b1], discriminant: [c0, c1, c2], .. } = self.conic.row(k);
        // b >= -b_doubt
        let [mut low, mut high] = EVERYWHERE;
        let crossing = -(b0 + self.thresholds.ahead) / b1;
        if b1 > 0.0 {
            low = crossing;
        } else if b1 < 0.0 {
            high = crossing;
        }
        // D >= -doubt
        let c0 = c0 - self.thresholds.miss;
        let (square, product) = (0.25 * c1 * c1, c2 * c0);
        let quarter = square - product;
        let rounding = 1e-12 * (square + product.abs());
        let (middle, half) = (-0.5 * c1 / c2, (quarter + rounding).max(0.0).sqrt() / c2.abs());
        if c2 < 0.0 {
            if quarter < -rounding {
                return None;
            }
            (low, high) = (low.max(middle - half), high.min(middle + half));
        } else if c2 > 0.0 && quarter > rounding {
            let half = (quarter - rounding).sqrt() / c2;
            let (left, right) = (middle - half, middle + half);
            if low > generous(left, 1.0) {
                low = low.max(right);
            }
            if high < generous(right, -1.0) {
                high = high.min(left);
            }
        }
        let (low, high) = (generous(low, -1.0), generous(high, 1.0));
        if low.is_nan() || high.is_nan() {
            return Some(EVERYWHERE);
        }
        (low <= high).then_some([low, high])
    }

    #[inline(always)]
    pub(crate) fn answer<S: Simd>(&self, simd: S, m: &[f64], k: f64, found: &mut [f64]) {
        let (rough, row) = self.rough(k);
        sphere_row::<S, Lanes<S>>(simd, m, &rough, &row, found);
    }
}

/// A sphere's polynomials in double-double, and in `f64` for what that decides.
pub(crate) struct FineKernel {
    pub(crate) patch: Patch,
    /// For a sphere that is seen from outside, where it was worth finding.
    pub(crate) near_root: Option<BigNearRoot>,
    rough: RoughKernel,
    conic: Conic<DoubleDouble>,
    c: DoubleDouble,
    factor: DoubleDouble,
    thresholds: Thresholds,
}

impl FineKernel {
    /// From the conic around the patch's middle; `None` where the units are extreme.
    pub(crate) fn new<T: Depth>(
        rays: &FrameRays,
        seen: &SphereSeen,
        conic: Conic<DoubleDouble>,
        near_root: Option<BigNearRoot>,
        patch: &Patch,
    ) -> Option<FineKernel> {
        let rough = RoughKernel::new::<T>(rays, &seen.rough, seen.side, seen.scale, patch)?;
        let least = rays.fine.least_length;
        let thresholds = conic.thresholds(&seen.fine, seen.side, least, T::DOUBT);
        let factor = DoubleDouble::from(rough.factor);
        let c = seen.fine.c * factor;
        let near_root = near_root.filter(|_| seen.side == Ordering::Greater);
        Some(FineKernel { patch: *patch, near_root, rough, conic, c, factor, thresholds })
    }

    /// See [`RoughKernel::reach`].
    pub(crate) fn reach(&self, k: f64) -> Option<[f64; 2]> {
        self.rough.reach(k)
    }

    #[inline(always)]
    pub(crate) fn answer<S: Simd>(&self, simd: S, m: &[f64], k: f64, found: &mut [f64]) {
        let (rough, _) = self.rough.rough(k);
        let FineKernel { c, factor, thresholds, .. } = *self;
        let side = self.rough.side;
        let row = SphereRow { conic: self.conic.row(k), c, factor, side, thresholds };
        sphere_row::<S, DoubleDouble<Lanes<S>>>(simd, m, &rough, &row, found);
    }
}

/// All columns.
pub(crate) const EVERYWHERE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// Two columns farther to one side, and more where the number is so large that it may be off by more.
fn generous(m: f64, side: f64) -> f64 {
    m + side * (4.0 + 1e-6 * m.abs())
}

/// A plane's `normal . direction` as a polynomial in columns m and rows k from the middle.
pub(crate) struct PlaneKernel<T> {
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
    pub(crate) fn new(
        seen: &PlaneSeen,
        offset: T,
        rays: &Steppers<T>,
        patch: &Patch,
        t_doubt: f64,
    ) -> PlaneKernel<T> {
        let vectors = [rays.direction(patch.n, patch.l), rays.e, rays.g];
        let normal = seen.normal.map(T::from);
        let reach = patch.corner(vectors.map(|v| length(near(v))));
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
    pub(crate) fn answer<S: Simd, N: LaneNumber<S, Scalar = T>>(
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
