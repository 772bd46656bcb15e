//! One row of one object: `t` of every pixel that is beyond doubt, several at a time.

use std::cmp::Ordering;

use fearless_simd::prelude::*;
use fearless_simd::{Select, Simd};

use crate::exact::error_free::Lane;
use crate::exact::lanes::Lanes;
use crate::render::polynomial::blend::{DOUBT, MISS};
use crate::render::polynomial::conic::{ConicRow, Thresholds};

type MaskOf<S> = <<S as Simd>::f64s as SimdBase<S>>::Mask;

/// A sphere in one row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SphereRow {
    pub(crate) conic: ConicRow,
    /// `c` times `factor`.
    pub(crate) c: f64,
    /// Factor from the polynomials' units to those of `t`.
    pub(crate) factor: f64,
    pub(crate) side: Ordering,
    pub(crate) thresholds: Thresholds,
}

/// `c0 + m (c1 + m c2)`
#[inline(always)]
fn quadratic<S: Simd>(c: [Lanes<S>; 3], m: Lanes<S>) -> Lanes<S> {
    c[0] + (c[1] + c[2] * m) * m
}

/// Selects the lanes of one of two vectors.
#[inline(always)]
fn select<S: Simd>(mask: MaskOf<S>, yes: Lanes<S>, no: Lanes<S>) -> Lanes<S> {
    Lanes(mask.select(yes.0, no.0))
}

/// Computes `t` of the first hit of each pixel, m columns from the middle; [`MISS`] or [`DOUBT`].
///
/// `m` and `t` are as long as each other, and a multiple of the vector's length.
#[inline(always)]
pub(crate) fn sphere_row<S: Simd>(simd: S, m: &[f64], row: &SphereRow, t: &mut [f64]) {
    let splat = |x: f64| Lanes::<S>::splat(simd, x);
    let (d, b, a) =
        (row.conic.discriminant.map(splat), row.conic.b.map(splat), row.conic.a.map(splat));
    let (c, factor) = (splat(row.c), splat(row.factor));
    let minus_c = -c;
    let Thresholds { hit, miss, ahead } = row.thresholds;
    let (hit, miss, ahead, behind) = (splat(hit).0, splat(miss).0, splat(ahead).0, splat(-ahead).0);
    let (none, doubt) = (splat(MISS).0, splat(DOUBT).0);
    let pairs = m.chunks_exact(S::f64s::LEN).zip(t.chunks_exact_mut(S::f64s::LEN));
    for (m, t) in pairs {
        let m = Lanes::<S>(S::f64s::from_slice(simd, m));
        let b = b[0] + b[1] * m;
        let found = match row.side {
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

/// A plane in one row: `t = offset / (rate0 + m rate1)`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlaneRow {
    /// The offset, in the units of `t`.
    pub(crate) offset: f64,
    pub(crate) rate: [f64; 2],
    /// A rate beyond this, with the offset's sign, is a hit, and `t` exact enough.
    pub(crate) hit: f64,
    /// A rate beyond this, with the other sign, is a miss.
    pub(crate) miss: f64,
    /// 1 or -1: the offset's sign.
    pub(crate) sign: f64,
}

/// Computes `t` of the hit of each pixel, m columns from the middle; [`MISS`] or [`DOUBT`].
#[inline(always)]
pub(crate) fn plane_row<S: Simd>(simd: S, m: &[f64], row: &PlaneRow, t: &mut [f64]) {
    let splat = |x: f64| Lanes::<S>::splat(simd, x);
    let (offset, rate) = (splat(row.offset), row.rate.map(splat));
    let (hit, miss, sign) = (splat(row.hit).0, splat(-row.miss).0, splat(row.sign));
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
