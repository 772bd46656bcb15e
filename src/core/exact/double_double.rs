//! Double-double arithmetic: a number is the unevaluated sum of two `f64`, with at least 106 bits.
//!
//! Every operation below has a proven bound of its relative error, given in terms of `u = 2^-53`. The
//! bounds hold if nothing overflows or underflows; callers scale by powers of two to ensure this.
//!
//! The module also has the error-free sums and products on which double-double is based, for scalars and
//! for SIMD vectors.

use std::ops::{Add, Div, Mul, Neg, Sub};

use glam::DVec3;

use crate::exact::bounded::Arithmetic;
use crate::exact::scale::ldexp;

/// `hi + lo` with `|lo| <= ulp(hi) / 2`.
///
/// ```
/// use pinhole_core::DoubleDouble;
/// let third = DoubleDouble::from(1.0) / DoubleDouble::from(3.0);
/// assert_eq!(third.hi, 1.0 / 3.0);
/// assert!((third * DoubleDouble::from(3.0) - DoubleDouble::from(1.0)).hi.abs() < 1e-31);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoubleDouble {
    /// The number, rounded to `f64`.
    pub hi: f64,
    /// The number minus `hi`: the part that rounding left out.
    pub lo: f64,
}

/// `u^2 = 2^-106`.
pub(crate) const U2: f64 = 0.25 * f64::EPSILON * f64::EPSILON;

impl DoubleDouble {
    /// Returns `a * b`, exactly.
    #[inline(always)]
    pub(crate) fn product(a: f64, b: f64) -> Self {
        let (hi, lo) = a.two_product(b);
        DoubleDouble { hi, lo }
    }

    /// Returns `self * x`: relative error at most `3 u^2` (Joldes, Muller, Popescu, *Tight and rigorous
    /// error bounds for basic building blocks of double-word arithmetic*, ACM TOMS 44, 2017, algorithm 8
    /// and theorem 4.2).
    #[inline(always)]
    pub(crate) fn times(self, x: f64) -> Self {
        let (product, error) = self.hi.two_product(x);
        let (hi, lo) = fast_two_sum(product, error + self.lo * x);
        DoubleDouble { hi, lo }
    }

    /// Returns the square root: relative error at most `25/8 u^2` (Lefevre, Louvet, Muller, Picot,
    /// Rideau, *Accurate calculation of Euclidean norms using double-word arithmetic*, ACM TOMS 49,
    /// 2023, algorithm 8). `hi` must be greater than 0.
    #[inline(always)]
    pub(crate) fn square_root(self) -> Self {
        let root = self.hi.sqrt();
        let (square, error) = root.two_product(root);
        // hi - root^2 is exact in f64, so the two differences here are rounded at most once.
        let rest = ((self.hi - square) - error) + self.lo;
        let (hi, lo) = fast_two_sum(root, rest.half() / root);
        DoubleDouble { hi, lo }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    /// Adds two numbers, with a relative error of at most `3 u^2 / (1 - 4u)`, whatever the signs
    /// (Joldes, Muller, Popescu 2017, algorithm 6 and theorem 3.1).
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (high, high_error) = two_sum(self.hi, other.hi);
        let (low, low_error) = two_sum(self.lo, other.lo);
        let (high, rest) = fast_two_sum(high, high_error + low);
        let (hi, lo) = fast_two_sum(high, low_error + rest);
        DoubleDouble { hi, lo }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        DoubleDouble { hi: -self.hi, lo: -self.lo }
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    /// Multiplies two numbers, with a relative error of at most `7 u^2` (Joldes, Muller, Popescu 2017,
    /// algorithm 10 and theorem 5.1).
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (product, error) = self.hi.two_product(other.hi);
        let cross = self.hi * other.lo + self.lo * other.hi;
        let (hi, lo) = fast_two_sum(product, error + cross);
        DoubleDouble { hi, lo }
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    /// Divides two numbers, with a relative error of at most `17 u^2`. This is algorithm 17 of Joldes,
    /// Muller, Popescu 2017, whose bound is slightly more than `15 u^2` (theorem 6.2), except that
    /// `times` multiplies by the quotient, with an error bound larger by `3/2 u^2`.
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let quotient = self.hi / other.hi;
        let back = other.times(quotient);
        let rest = (self.hi - back.hi) + (self.lo - back.lo);
        let (hi, lo) = fast_two_sum(quotient, rest / other.hi);
        DoubleDouble { hi, lo }
    }
}

impl DoubleDouble {
    /// Returns whether every number within `doubt` of this one rounds to the same `f64` (Ziv, *Fast
    /// evaluation of elementary mathematical functions with correctly rounded last bit*, 1991).
    pub(crate) fn rounds_surely(self, doubt: f64) -> bool {
        let doubt = 1.01 * doubt;
        self.hi + (self.lo + doubt) == self.hi && self.hi + (self.lo - doubt) == self.hi
    }

    /// Returns `self * 2^k`, which is exact unless it leaves the range of `f64`.
    pub(crate) fn scaled(self, k: i32) -> DoubleDouble {
        DoubleDouble { hi: ldexp(self.hi, k), lo: ldexp(self.lo, k) }
    }
}

impl From<f64> for DoubleDouble {
    fn from(x: f64) -> Self {
        DoubleDouble { hi: x, lo: 0.0 }
    }
}

/// A floating-point number, or a SIMD vector of them. All operations round to nearest.
///
/// The same operations give the same bits for any number of lanes, because multiplication and addition
/// are fused only where the result is exact anyway.
pub(crate) trait Lane: Arithmetic {
    /// Returns the rounded square root.
    fn sqrt(self) -> Self;

    /// Returns `(p, e)` with `p = fl(self * other)` and `self * other = p + e` exactly, in `f64` for
    /// factors below 2^996 and products of at least 2^-969. For smaller products, e is off by at most
    /// 2^-1073.
    fn two_product(self, other: Self) -> (Self, Self);

    /// Returns `x / 2`.
    fn half(self) -> Self;

    /// Returns the number itself, or 0 if it is negative.
    fn not_negative(self) -> Self;

    /// Returns the number times Veltkamp's factor: `2^27 + 1` in `f64`, `2^12 + 1` in `f32`.
    fn shifted(self) -> Self;

    /// Splits the number into a sum of two numbers with half as many bits each (in `f64`, at most 26),
    /// by Veltkamp's splitting.
    #[inline(always)]
    fn halves(self) -> (Self, Self) {
        let shifted = self.shifted();
        let high = shifted - (shifted - self);
        (high, self - high)
    }
}

/// Returns `(s, e)` with `s = fl(a + b)` and `a + b = s + e` exactly, unless the sum overflows (Knuth,
/// *The Art of Computer Programming* vol. 2, section 4.2.2, theorem B).
#[inline(always)]
pub(crate) fn two_sum<F: Lane>(a: F, b: F) -> (F, F) {
    let sum = a + b;
    let b_rounded = sum - a;
    let a_rounded = sum - b_rounded;
    (sum, (a - a_rounded) + (b - b_rounded))
}

/// Returns the [`two_sum`] of a and b, where a is 0 or has no smaller exponent than b (Dekker, *A
/// floating-point technique for extending the available precision*, Numerische Mathematik 18, 1971).
#[inline(always)]
pub(crate) fn fast_two_sum<F: Lane>(a: F, b: F) -> (F, F) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// Returns `(p, e)` with `p = fl(a * b)` and `a * b = p + e` exactly, for factors below 2^996 and
/// products of at least 2^-969 (Dekker 1971, by Veltkamp's splitting). It uses no fused multiply-add,
/// for processors that have none. With one, the results would have the same bits, except for the sign of
/// an error of 0.
#[inline(always)]
pub(crate) fn dekker_product<F: Lane>(a: F, b: F) -> (F, F) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (a.halves(), b.halves());
    let error = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
    (product, error)
}

/// Veltkamp's factor, `2^27 + 1`.
pub(crate) const SPLITTER: f64 = (1_u32 << 27) as f64 + 1.0;

impl Lane for f64 {
    #[inline(always)]
    fn sqrt(self) -> f64 {
        self.sqrt()
    }

    #[inline(always)]
    fn two_product(self, other: f64) -> (f64, f64) {
        dekker_product(self, other)
    }

    #[inline(always)]
    fn half(self) -> f64 {
        0.5 * self
    }

    #[inline(always)]
    fn not_negative(self) -> f64 {
        self.max(0.0)
    }

    #[inline(always)]
    fn shifted(self) -> f64 {
        SPLITTER * self
    }
}

/// Returns `(d, e, k)` with `a - b = (d + e) * 2^k` exactly, for finite vectors. d is the rounded
/// difference, e its rounding error, and k is 0 unless the difference would overflow.
pub(crate) fn difference_with_rest(a: DVec3, b: DVec3) -> (DVec3, DVec3, i32) {
    let (shrink, k) = if (a - b).is_finite() { (1.0, 0) } else { (0.25, 2) };
    let (a, b) = (shrink * a, shrink * b);
    let (x, y, z) = (two_sum(a.x, -b.x), two_sum(a.y, -b.y), two_sum(a.z, -b.z));
    (DVec3::new(x.0, y.0, z.0), DVec3::new(x.1, y.1, z.1), k)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use dashu_float::FBig;
    use dashu_float::round::mode::HalfEven;
    use proptest::prelude::*;

    use super::*;
    use crate::test_seed::config;

    fn big(x: f64) -> FBig<HalfEven, 2> {
        FBig::try_from(x).unwrap().with_precision(5000).value()
    }

    /// Generates numbers of any bits, with an exponent between -400 and 400.
    fn number() -> impl Strategy<Value = f64> {
        (any::<u64>(), -400..400_i32).prop_map(|(bits, exponent)| {
            let mantissa = f64::from_bits(bits & !(0x7ff << 52) | (1023 << 52));
            mantissa * 2_f64.powi(exponent)
        })
    }

    proptest! {
        #![proptest_config(config(256))]

        #[test]
        fn sums_are_exact(a in number(), b in number(), close in any::<bool>()) {
            let b = if close { a * 1e-9 + b * 1e-200 } else { b };
            let (sum, error) = two_sum(a, b);
            prop_assert_eq!(sum, a + b);
            prop_assert_eq!(big(sum) + big(error), big(a) + big(b));
        }

        #[test]
        fn products_are_exact(a in number(), b in number()) {
            let (product, error) = dekker_product(a, b);
            prop_assert_eq!(product, a * b);
            prop_assert_eq!(big(product) + big(error), big(a) * big(b));
        }
    }
}
