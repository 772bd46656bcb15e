//! An object's polynomials over a rectangle of pixels (a patch). They compute `t` for several pixels of
//! a row at a time, and mark the pixels that they cannot decide.

use std::cmp::Ordering;

use fearless_simd::prelude::*;
use fearless_simd::{Select, Simd};

use crate::exact::bounded::{Number, SECOND_ORDER, UNDERFLOW, dot, length};
use crate::exact::double_double::Lane;
use crate::exact::lanes::Lanes;
use crate::exact::quadratic::SphereTerms;
use crate::exact::scale::ldexp;
use crate::render::polynomial::conic::{Conic, ConicRow, Thresholds};
use crate::render::polynomial::frame_rays::{FrameRays, Patch, Steppers};
use crate::render::polynomial::{DOUBT, MISS, T_SHARE};
use crate::scene::plane_predicates::PlaneFromOrigin;

/// Returns the factor that converts from the units of an object's polynomials to those of `t`; `None` if
/// lengths are so extreme that `f64` could overflow or lose digits.
pub(crate) fn factor(rays: &FrameRays, scale: i32) -> Option<f64> {
    let factor = ldexp(rays.stretch, scale - rays.scale);
    (rays.is_plain && (1e-60..1e60).contains(&factor)).then_some(factor)
}

type MaskOf<S> = <<S as Simd>::f64s as SimdBase<S>>::Mask;

/// Returns `c0 + m (c1 + m c2)`.
#[inline(always)]
fn quadratic<S: Simd>(c: [Lanes<S>; 3], m: Lanes<S>) -> Lanes<S> {
    c[0] + (c[1] + c[2] * m) * m
}

/// Selects each lane from one of two vectors.
#[inline(always)]
fn select<S: Simd>(mask: MaskOf<S>, yes: Lanes<S>, no: Lanes<S>) -> Lanes<S> {
    Lanes(mask.select(yes.0, no.0))
}

/// A sphere's quadratic equation, as polynomials in a pixel's position in a patch.
pub(crate) struct SphereKernel {
    conic: Conic,
    /// The coefficient `c = |q|^2 - r^2` of [`SphereTerms`], times `factor`.
    c: f64,
    /// Factor from the polynomials' units to those of `t`.
    factor: f64,
    /// `Greater` if the eye is outside the sphere, `Equal` if on it, `Less` if inside.
    side: Ordering,
    thresholds: Thresholds,
}

impl SphereKernel {
    /// Makes a sphere's polynomials; returns `None` if lengths are so extreme that `f64` could overflow
    /// or lose digits.
    pub(crate) fn new(
        rays: &FrameRays,
        parts: &SphereTerms<f64>,
        side: Ordering,
        scale: i32,
        patch: &Patch,
    ) -> Option<SphereKernel> {
        let factor = factor(rays, scale)?;
        let conic = Conic::new(parts, &rays.steppers, patch);
        let thresholds = conic.thresholds(parts, side, rays.steppers.least_length, T_SHARE);
        Some(SphereKernel { conic, c: parts.c * factor, factor, side, thresholds })
    }

    /// Finds a range of the column coordinate m that contains all hits of the row with the coordinate
    /// k; `None` if the row has none. m and k are counted in half columns and half rows from the
    /// middle of the patch, as in [`Conic`].
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

    /// Computes the first hit's `t`, or [`MISS`] or [`DOUBT`], for the pixels at the column
    /// coordinates `m` of the row with the coordinate `k`. Both are counted in half columns and half
    /// rows from the middle of the patch, as in [`Conic`]. `m` and `t` must have the same length, a
    /// multiple of a SIMD vector's.
    #[inline(always)]
    pub(crate) fn answer<S: Simd>(&self, simd: S, m: &[f64], k: f64, t: &mut [f64]) {
        let row = self.conic.row(k);
        let splat = |x: f64| Lanes::<S>::splat(simd, x);
        let (d, b, a) = (row.discriminant.map(splat), row.b.map(splat), row.a.map(splat));
        let (c, factor) = (splat(self.c), splat(self.factor));
        let minus_c = -c;
        let Thresholds { hit, miss, ahead } = self.thresholds;
        let (hit, miss, ahead, behind) =
            (splat(hit).0, splat(miss).0, splat(ahead).0, splat(-ahead).0);
        let (none, doubt) = (splat(MISS).0, splat(DOUBT).0);
        let pairs = m.chunks_exact(S::f64s::LEN).zip(t.chunks_exact_mut(S::f64s::LEN));
        for (m, t) in pairs {
            let m = Lanes::<S>(S::f64s::from_slice(simd, m));
            let b = b[0] + b[1] * m;
            let found = match self.side {
                Ordering::Greater => {
                    let discriminant = quadratic(d, m);
                    if discriminant.0.simd_lt(miss).all_true() {
                        none.store_slice(t);
                        continue;
                    }
                    let t = c / (b + discriminant.sqrt());
                    let is_miss = discriminant.0.simd_lt(miss) | b.0.simd_lt(behind);
                    let is_hit = discriminant.0.simd_ge(hit) & b.0.simd_gt(ahead);
                    is_hit.select(t.0, is_miss.select(none, doubt))
                }
                Ordering::Less => {
                    let discriminant = quadratic(d, m);
                    let is_ahead = b.0.simd_ge(splat(0.0).0);
                    let z = select(is_ahead, b, -b) + discriminant.sqrt();
                    let above = select(is_ahead, z * factor, minus_c);
                    let t = above / select(is_ahead, quadratic(a, m), z);
                    discriminant.0.simd_ge(hit).select(t.0, doubt)
                }
                Ordering::Equal => {
                    let t = (b + b) * factor / quadratic(a, m);
                    let is_miss = b.0.simd_lt(miss);
                    b.0.simd_gt(ahead).select(t.0, is_miss.select(none, doubt))
                }
            };
            found.store_slice(t);
        }
    }
}

/// All columns.
pub(crate) const EVERYWHERE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// Moves a bound of the column coordinate m in the direction `side` (1 or -1) by 4, which is two
/// columns, plus a fraction of m that covers its rounding error.
fn generous(m: f64, side: f64) -> f64 {
    m + side * (4.0 + 1e-6 * m.abs())
}

/// A plane, whose hit in a pixel is at `t = offset / rate`. The rate, `normal . direction`, is a
/// linear polynomial in the pixel's position (m, k), counted in half columns and half rows from the
/// middle of the patch, as in [`Conic`].
pub(crate) struct PlaneKernel {
    /// The offset `normal . (point - eye)`, in such units that the quotient is `t`.
    offset: f64,
    /// The rate's coefficients of 1, m and k.
    rate: [f64; 3],
    /// Threshold of a hit: where `sign` times the rate is above this value, the pixel is a hit whose
    /// `t` is accurate enough.
    hit: f64,
    /// Threshold of a miss, not negative: where `sign` times the rate is below the negative of this
    /// value, the pixel is a miss.
    miss: f64,
    /// 1, or -1 if the offset is negative. A pixel is a hit if its rate has this sign.
    sign: f64,
}

impl PlaneKernel {
    /// Computes the rate's coefficients and the thresholds.
    ///
    /// Let n be the normal, S a bound of the length of the directions in the patch, P their relative
    /// error, and DOT that of a dot product. The rate is off by `|n| S (DOT + P)`, and by the rounding
    /// of two products and two sums when the polynomial is evaluated. The relative error of `t` is
    /// that error divided by the rate, plus the offset's, plus that of its own operations.
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
        let left = T_SHARE - seen.offset_doubt - f64::QUOTIENT - 2.0 * f64::PRODUCT;
        PlaneKernel {
            offset: seen.offset.hi * factor,
            rate: vectors.map(|v| dot(seen.normal, v)),
            hit: if left > 0.0 { doubt.max(doubt / left) } else { f64::INFINITY },
            miss: doubt,
            sign: if seen.side == Ordering::Less { -1.0 } else { 1.0 },
        }
    }

    /// Computes `t`, or [`MISS`] or [`DOUBT`], for each pixel, like [`SphereKernel::answer`].
    #[inline(always)]
    pub(crate) fn answer<S: Simd>(&self, simd: S, m: &[f64], k: f64, t: &mut [f64]) {
        let splat = |x: f64| Lanes::<S>::splat(simd, x);
        let (offset, rate) =
            (splat(self.offset), [self.rate[0] + k * self.rate[2], self.rate[1]].map(splat));
        let (hit, miss, sign) = (splat(self.hit).0, splat(-self.miss).0, splat(self.sign));
        let (none, doubt) = (splat(MISS).0, splat(DOUBT).0);
        let pairs = m.chunks_exact(S::f64s::LEN).zip(t.chunks_exact_mut(S::f64s::LEN));
        for (m, t) in pairs {
            let m = Lanes::<S>(S::f64s::from_slice(simd, m));
            let rate = rate[0] + rate[1] * m;
            let found = (offset / rate).0;
            let rate = (rate * sign).0;
            let is_miss = rate.simd_lt(miss);
            rate.simd_gt(hit).select(found, is_miss.select(none, doubt)).store_slice(t);
        }
    }
}
