//! Double-double arithmetic: a number as the unevaluated sum of two `f64`, 106 bits and more.
//!
//! With `u = 2^-53` every operation below has a proven bound on its relative error. The bounds hold
//! barring overflow and underflow; callers scale by powers of two.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::exact::error_free::{Lane, fast_two_sum, two_sum};
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
    /// The number, rounded.
    pub hi: f64,
    /// The part that rounding left out.
    pub lo: f64,
}

/// `u^2 = 2^-106`.
pub(crate) const U2: f64 = 0.25 * f64::EPSILON * f64::EPSILON;

impl DoubleDouble {
    /// `a * b`, exactly.
    #[inline(always)]
    pub(crate) fn product(a: f64, b: f64) -> Self {
        let (hi, lo) = a.two_product(b);
        DoubleDouble { hi, lo }
    }

    /// `self * x`: relative error at most `3 u^2` (Joldes, Muller, Popescu, *Tight and rigorous
    /// error bounds for basic building blocks of double-word arithmetic*, ACM TOMS 44, 2017,
    /// algorithm 8 and theorem 4.2).
    #[inline(always)]
    pub(crate) fn times(self, x: f64) -> Self {
        let (product, error) = self.hi.two_product(x);
        let (hi, lo) = fast_two_sum(product, error + self.lo * x);
        DoubleDouble { hi, lo }
    }

    /// The square root: relative error at most `25/8 u^2` (Lefevre, Louvet, Muller, Picot, Rideau,
    /// *Accurate calculation of Euclidean norms using double-word arithmetic*, ACM TOMS 49, 2023,
    /// algorithm 8). `hi` must be greater than 0.
    #[inline(always)]
    pub(crate) fn square_root(self) -> Self {
        let root = self.hi.sqrt();
        let (square, error) = root.two_product(root);
        // hi - root^2 is exact in f64, so both differences here are one rounding at most.
        let rest = ((self.hi - square) - error) + self.lo;
        let (hi, lo) = fast_two_sum(root, rest.half() / root);
        DoubleDouble { hi, lo }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    /// Relative error at most `3 u^2 / (1 - 4u)`, whatever the signs (the same, algorithm 6 and
    /// theorem 3.1).
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

    /// Relative error at most `7 u^2` (the same, algorithm 10 and theorem 5.1).
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

    /// Relative error at most `17 u^2` (the same, algorithm 17 and theorem 6.2: `15 u^2` and a
    /// little; its product by a quotient has `3/2 u^2` less than ours by one `f64`).
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

    /// `self * 2^k`, exact unless it leaves the range.
    pub(crate) fn scaled(self, k: i32) -> DoubleDouble {
        DoubleDouble { hi: ldexp(self.hi, k), lo: ldexp(self.lo, k) }
    }
}

impl From<f64> for DoubleDouble {
    fn from(x: f64) -> Self {
        DoubleDouble { hi: x, lo: 0.0 }
    }
}
