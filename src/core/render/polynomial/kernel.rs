//! One row of one object: `t` of every pixel that is beyond doubt, several at a time.

use std::cmp::Ordering;
use std::ops::{Add, Div, Neg};

use fearless_simd::prelude::*;
use fearless_simd::{Select, Simd};

use crate::exact::double_double::DoubleDouble;
use crate::exact::error_free::{Lane, two_sum};
use crate::exact::lanes::Lanes;
use crate::render::frame::depth::{DOUBT, MISS};
use crate::render::polynomial::conic::{ConicRow, Thresholds};

/// What a kernel's polynomials are evaluated in: lanes of `f64`, or of double-doubles.
pub(crate) trait LaneNumber<S: Simd>:
    Copy + Add<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// One lane's worth.
    type Scalar: Copy;

    fn splat(simd: S, x: Self::Scalar) -> Self;

    /// `c0 + m c1`, of whose terms none is much larger than the sum.
    fn linear(c: [Self; 2], m: Lanes<S>) -> Self;

    /// `c / (b + sqrt D)`, rounded, for `D > 0` and `b > 0`; anything elsewhere.
    fn near_root(c: Self, b: Self, discriminant: Self) -> Lanes<S>;

    fn times_whole(self, m: Lanes<S>) -> Self;
    fn times_number(self, x: Self) -> Self;
    fn root(self) -> Self;
    fn near(self) -> Lanes<S>;
    fn select(mask: MaskOf<S>, yes: Self, no: Self) -> Self;
}

type MaskOf<S> = <<S as Simd>::f64s as SimdBase<S>>::Mask;

impl<S: Simd> LaneNumber<S> for Lanes<S> {
    type Scalar = f64;

    #[inline(always)]
    fn splat(simd: S, x: f64) -> Self {
        Lanes::splat(simd, x)
    }

    #[inline(always)]
    fn linear(c: [Self; 2], m: Lanes<S>) -> Self {
        c[0] + c[1] * m
    }

    #[inline(always)]
    fn near_root(c: Self, b: Self, discriminant: Self) -> Lanes<S> {
        c / (b + discriminant.sqrt())
    }

    #[inline(always)]
    fn times_whole(self, m: Lanes<S>) -> Self {
        self * m
    }

    #[inline(always)]
    fn times_number(self, x: Self) -> Self {
        self * x
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn near(self) -> Lanes<S> {
        self
    }

    #[inline(always)]
    fn select(mask: MaskOf<S>, yes: Self, no: Self) -> Self {
        Lanes(mask.select(yes.0, no.0))
    }
}

impl<S: Simd> LaneNumber<S> for DoubleDouble<Lanes<S>> {
    type Scalar = DoubleDouble;

    #[inline(always)]
    fn splat(simd: S, x: DoubleDouble) -> Self {
        DoubleDouble { hi: Lanes::splat(simd, x.hi), lo: Lanes::splat(simd, x.lo) }
    }

    #[inline(always)]
    fn linear(c: [Self; 2], m: Lanes<S>) -> Self {
        c[0].loosely_plus(c[1].times(m))
    }

    /// One square root and one division. With `s = fl(sqrt D)` and `z = b + s`, both in `f64`, and
    /// `i = 1 / (s z)`, the reciprocals `1 / s = i z` and `1 / z = i s` are right to 3 u, which is
    /// enough for the corrections that follow: half of `(D - s^2) / s` for the root, and
    /// `(c - q z') / z` for the quotient `q = c / z`, where z' has all digits.
    ///
    /// Relative error before the last rounding, with `u = 2^-53`: the root's correction is below
    /// `2 u s` and off by `12 u^2 s` at most, what is added to it by `6 u^2 z`; q is off by `4 u`, so
    /// that `c - q z'` is below `7.5 u c`, off by `17.5 u^2 c`, and its product with `1 / z` by
    /// `30 u^2 + 14 u^2` more. In all below `80 u^2`.
    #[inline(always)]
    fn near_root(c: Self, b: Self, discriminant: Self) -> Lanes<S> {
        let root = discriminant.hi.sqrt();
        let (square, square_error) = root.two_product(root);
        let root_rest = ((discriminant.hi - square) - square_error) + discriminant.lo;
        let (z, z_error) = two_sum(b.hi, root);
        let reciprocal = Lanes::one(z) / (root * z);
        let z_rest = z_error + (b.lo + root_rest * (reciprocal * z).half());
        let reciprocal = reciprocal * root;
        let quotient = c.hi * reciprocal;
        let (product, product_error) = quotient.two_product(z);
        let rest = ((c.hi - product) - product_error) + (c.lo - quotient * z_rest);
        quotient + rest * reciprocal
    }

    #[inline(always)]
    fn times_whole(self, m: Lanes<S>) -> Self {
        self.times(m)
    }

    #[inline(always)]
    fn times_number(self, x: Self) -> Self {
        self * x
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.square_root()
    }

    #[inline(always)]
    fn near(self) -> Lanes<S> {
        self.hi
    }

    #[inline(always)]
    fn select(mask: MaskOf<S>, yes: Self, no: Self) -> Self {
        DoubleDouble {
            hi: Lanes::select(mask, yes.hi, no.hi),
            lo: Lanes::select(mask, yes.lo, no.lo),
        }
    }
}

/// A sphere in one row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SphereRow<T> {
    pub(crate) conic: ConicRow<T>,
    /// `c` times `factor`.
    pub(crate) c: T,
    /// From the polynomials' units to those of `t`.
    pub(crate) factor: T,
    pub(crate) side: Ordering,
    pub(crate) thresholds: Thresholds,
}

/// D in `f64`, which suffices for most misses.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RoughDiscriminant {
    pub(crate) polynomial: [f64; 3],
    pub(crate) miss: f64,
}

/// `c0 + m (c1 + m c2)`
#[inline(always)]
fn quadratic<S: Simd, N: LaneNumber<S>>(c: [N; 3], m: Lanes<S>) -> N {
    c[0] + (c[1] + c[2].times_whole(m)).times_whole(m)
}

/// `t` of the first hit of each pixel, m columns from the middle; [`MISS`] or [`DOUBT`].
///
/// `m` and `t` are as long as each other, and a multiple of the vector's length.
#[inline(always)]
pub(crate) fn sphere_row<S: Simd, N: LaneNumber<S>>(
    simd: S,
    m: &[f64],
    rough: &RoughDiscriminant,
    row: &SphereRow<N::Scalar>,
    t: &mut [f64],
) {
    let splat = |x: f64| Lanes::<S>::splat(simd, x);
    let number = |x: N::Scalar| N::splat(simd, x);
    let (d, b, a) =
        (row.conic.discriminant.map(number), row.conic.b.map(number), row.conic.a.map(number));
    let (c, factor) = (number(row.c), number(row.factor));
    let minus_c = -c;
    let rough_d = rough.polynomial.map(splat);
    let (rough_miss, rough_hit) = (splat(rough.miss).0, splat(-rough.miss).0);
    let Thresholds { hit, miss, ahead } = row.thresholds;
    let (hit, miss, ahead, behind) = (splat(hit).0, splat(miss).0, splat(ahead).0, splat(-ahead).0);
    let (none, doubt) = (splat(MISS).0, splat(DOUBT).0);
    let pairs = m.chunks_exact(S::f64s::LEN).zip(t.chunks_exact_mut(S::f64s::LEN));
    for (m, t) in pairs {
        let m = Lanes::<S>(S::f64s::from_slice(simd, m));
        let found = match row.side {
            Ordering::Greater => {
                let rough = quadratic(rough_d, m).0;
                let is_rough_hit = rough.simd_gt(rough_hit);
                if rough.simd_lt(rough_miss).all_true() {
                    none.store_slice(t);
                    continue;
                }
                let discriminant = quadratic(d, m);
                let b = N::linear(b, m);
                let t = N::near_root(c, b, discriminant);
                let (discriminant, b) = (discriminant.near().0, b.near().0);
                let is_miss = rough.simd_lt(rough_miss) | b.simd_lt(behind);
                // What is counted as decided in f64 was.
                let is_hit = discriminant.simd_ge(hit) & b.simd_gt(ahead) & is_rough_hit;
                is_hit.select(t.0, is_miss.select(none, doubt))
            }
            Ordering::Less => {
                let discriminant = quadratic(d, m);
                let b = b[0] + b[1].times_whole(m);
                let is_ahead = b.near().0.simd_ge(splat(0.0).0);
                let size = N::select(is_ahead, b, -b);
                let z = size + discriminant.root();
                let above = N::select(is_ahead, z.times_number(factor), minus_c);
                let t = above / N::select(is_ahead, quadratic(a, m), z);
                let is_hit = discriminant.near().0.simd_ge(hit);
                is_hit.select(t.near().0, doubt)
            }
            Ordering::Equal => {
                let b = b[0] + b[1].times_whole(m);
                let t = (b + b).times_number(factor) / quadratic(a, m);
                let b = b.near().0;
                let is_miss = b.simd_lt(miss);
                b.simd_gt(ahead).select(t.near().0, is_miss.select(none, doubt))
            }
        };
        found.store_slice(t);
    }
}

/// A plane in one row: `t = offset / (rate0 + m rate1)`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlaneRow<T> {
    /// The offset, in the units of `t`.
    pub(crate) offset: T,
    pub(crate) rate: [T; 2],
    /// A rate beyond this, with the offset's sign, is a hit, and `t` exact enough.
    pub(crate) hit: f64,
    /// A rate beyond this, with the other sign, is a miss.
    pub(crate) miss: f64,
    /// 1 or -1: the offset's sign.
    pub(crate) sign: f64,
}

/// `t` of the hit of each pixel, m columns from the middle; [`MISS`] or [`DOUBT`].
#[inline(always)]
pub(crate) fn plane_row<S: Simd, N: LaneNumber<S>>(
    simd: S,
    m: &[f64],
    row: &PlaneRow<N::Scalar>,
    t: &mut [f64],
) {
    let splat = |x: f64| Lanes::<S>::splat(simd, x);
    let (offset, rate) = (N::splat(simd, row.offset), row.rate.map(|x| N::splat(simd, x)));
    let (hit, miss, sign) = (splat(row.hit).0, splat(-row.miss).0, splat(row.sign).0);
    let (none, doubt) = (splat(MISS).0, splat(DOUBT).0);
    let pairs = m.chunks_exact(S::f64s::LEN).zip(t.chunks_exact_mut(S::f64s::LEN));
    for (m, t) in pairs {
        let m = Lanes::<S>(S::f64s::from_slice(simd, m));
        let rate = rate[0] + rate[1].times_whole(m);
        let found = (offset / rate).near().0;
        let rate = rate.near().0 * sign;
        let is_miss = rate.simd_lt(miss);
        rate.simd_gt(hit).select(found, is_miss.select(none, doubt)).store_slice(t);
    }
}
