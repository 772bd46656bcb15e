//! An object's polynomials over a patch of pixels, and what they say of a row.

use std::cmp::Ordering;

use fearless_simd::Simd;

use crate::exact::bounded::{Number, SECOND_ORDER, UNDERFLOW, dot, length};
use crate::exact::quadratic::SphereParts;
use crate::exact::scale::ldexp;
use crate::render::polynomial::blend::T_SHARE;
use crate::render::polynomial::conic::{Conic, ConicRow, Thresholds};
use crate::render::polynomial::frame_rays::{FrameRays, Patch, Steppers};
use crate::render::polynomial::kernel::{PlaneRow, SphereRow, plane_row, sphere_row};
use crate::scene::plane_predicates::PlaneFromOrigin;

/// Returns the factor from the units of the polynomials to those of `t`; `None` where they are extreme.
pub(crate) fn factor(rays: &FrameRays, scale: i32) -> Option<f64> {
    let factor = ldexp(rays.stretch, scale - rays.scale);
    (rays.is_plain() && (1e-60..1e60).contains(&factor)).then_some(factor)
}

/// A sphere's polynomials.
pub(crate) struct SphereKernel {
    conic: Conic,
    c: f64,
    factor: f64,
    side: Ordering,
    thresholds: Thresholds,
}

impl SphereKernel {
    /// `None` where the units are extreme.
    pub(crate) fn new(
        rays: &FrameRays,
        parts: &SphereParts<f64>,
        side: Ordering,
        scale: i32,
        patch: &Patch,
    ) -> Option<SphereKernel> {
        let factor = factor(rays, scale)?;
        let conic = Conic::new(parts, &rays.steppers, patch);
        let thresholds = conic.thresholds(parts, side, rays.steppers.least_length, T_SHARE);
        Some(SphereKernel { conic, c: parts.c * factor, factor, side, thresholds })
    }

    /// Finds from which to which m a row can have a hit, generously; `None` where it has none.
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
        let SphereKernel { c, factor, side, thresholds, .. } = *self;
        let row = SphereRow { conic: self.conic.row(k), c, factor, side, thresholds };
        sphere_row(simd, m, &row, found);
    }
}

/// All columns.
pub(crate) const EVERYWHERE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// Two columns farther to one side, and more where the number is so large that it may be off by more.
fn generous(m: f64, side: f64) -> f64 {
    m + side * (4.0 + 1e-6 * m.abs())
}

/// A plane's `normal . direction` as a polynomial in columns m and rows k from the middle.
pub(crate) struct PlaneKernel {
    offset: f64,
    rate: [f64; 3],
    hit: f64,
    miss: f64,
    sign: f64,
}

impl PlaneKernel {
    /// Computes the polynomial: with S the longest direction of the patch and P the direction's
    /// doubt, the rate is off by `|n| S (DOT + P)`, and by two steps of a product and a sum where it is
    /// put together. `t` is off by that over the rate, by the offset's share, and by its own operations.
    pub(crate) fn new(
        seen: &PlaneFromOrigin,
        factor: f64,
        rays: &Steppers,
        patch: &Patch,
    ) -> PlaneKernel {
        let vectors = [rays.direction(patch.n, patch.l), rays.e, rays.g];
        let reach = patch.corner(vectors.map(length));
        let step = f64::PRODUCT + f64::SUM;
        let share = SECOND_ORDER * (f64::DOT + 2.0 * step + rays.doubt());
        let doubt = share * length(seen.normal) * reach + UNDERFLOW;
        let left = T_SHARE - seen.offset_doubt() - f64::QUOTIENT - 2.0 * f64::PRODUCT;
        PlaneKernel {
            offset: seen.offset.hi * factor,
            rate: vectors.map(|v| dot(seen.normal, v)),
            hit: if left > 0.0 { doubt.max(doubt / left) } else { f64::INFINITY },
            miss: doubt,
            sign: if seen.side == Ordering::Less { -1.0 } else { 1.0 },
        }
    }

    #[inline(always)]
    pub(crate) fn answer<S: Simd>(&self, simd: S, m: &[f64], k: f64, found: &mut [f64]) {
        let PlaneKernel { offset, hit, miss, sign, .. } = *self;
        let rate = [self.rate[0] + k * self.rate[2], self.rate[1]];
        plane_row(simd, m, &PlaneRow { offset, rate, hit, miss, sign }, found);
    }
}
