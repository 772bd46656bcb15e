//! Arithmetic with error bounds, in `f64` and in double-double, for scalars and vectors.
//!
//! Every bound is of first order in the rounding errors that [`Number`] lists. The factor
//! [`SECOND_ORDER`] covers terms of higher order, and the rounding of the bounds themselves. The
//! analysis follows Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., chapter 3;
//! filtering decisions by such bounds follows Shewchuk, *Adaptive precision floating-point arithmetic
//! and fast robust geometric predicates*, Discrete & Computational Geometry 18, 1997.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::exact::double_double::{DoubleDouble, U2};
use crate::exact::scale::exponent;

/// A type with the operators `+`, `-`, `*`, `/` and negation.
pub(crate) trait Arithmetic:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
}

impl<T> Arithmetic for T where
    T: Copy
        + Add<Output = T>
        + Sub<Output = T>
        + Mul<Output = T>
        + Div<Output = T>
        + Neg<Output = T>
{
}

/// A number type in which the intersection formulas are evaluated, with a bound of the relative rounding
/// error of each operation.
pub(crate) trait Number: Arithmetic + From<f64> {
    /// A bound of the relative error of a sum or difference.
    const SUM: f64;
    /// A bound of the relative error of a product.
    const PRODUCT: f64;
    /// A bound of the relative error of a quotient.
    const QUOTIENT: f64;
    /// A bound of the relative error of a square root.
    const ROOT: f64;

    /// Error bound of a dot product, relative to the product of the vectors' lengths: three products,
    /// each of which goes through at most two sums.
    const DOT: f64 = Self::PRODUCT + 2.0 * Self::SUM;

    /// Bound of the length of a cross product's error vector, relative to the product of the two
    /// vectors' lengths: a coordinate is off by at most `PRODUCT + SUM` times `|a_j b_k| + |a_k b_j|`,
    /// and the vector of those sums is no longer than `sqrt 2 |a| |b|`.
    const CROSS: f64 = 1.415 * (Self::PRODUCT + Self::SUM);

    /// Returns the square root. The number must be greater than 0.
    fn root(self) -> Self;

    /// Returns the number in `f64`, rounded.
    fn near(self) -> f64;

    /// Returns a double-double as a number of this type, rounded.
    fn of(x: DoubleDouble) -> Self;
}

/// The unit roundoff u: half the spacing of `f64` at 1.
pub(crate) const UNIT: f64 = 0.5 * f64::EPSILON;

impl Number for f64 {
    const SUM: f64 = UNIT;
    const PRODUCT: f64 = UNIT;
    const QUOTIENT: f64 = UNIT;
    const ROOT: f64 = UNIT;

    #[inline(always)]
    fn root(self) -> f64 {
        self.sqrt()
    }

    #[inline(always)]
    fn near(self) -> f64 {
        self
    }

    #[inline(always)]
    fn of(x: DoubleDouble) -> f64 {
        x.hi
    }
}

impl Number for DoubleDouble {
    // Proven at the operations.
    const SUM: f64 = 3.01 * U2;
    const PRODUCT: f64 = 7.0 * U2;
    const QUOTIENT: f64 = 17.0 * U2;
    const ROOT: f64 = 3.2 * U2;

    fn root(self) -> DoubleDouble {
        self.square_root()
    }

    fn near(self) -> f64 {
        self.hi
    }

    fn of(x: DoubleDouble) -> DoubleDouble {
        x
    }
}

/// Factor by which a first-order error bound is multiplied to cover the terms of second order (in `f64`,
/// below 1e-12 of the first-order terms) and the rounding of the bound itself.
pub(crate) const SECOND_ORDER: f64 = 1.0 + 1.0 / 64.0;

/// Bound of the error that underflow can add to any value computed from scaled vectors, whose largest
/// coordinates are between 1e-30 and 1e30. The rounding errors of products below 2^-969 are lost: at
/// most 2^-1073 each, which further factors may multiply by up to 1e120.
pub(crate) const UNDERFLOW: f64 = 1e-190;

/// A vector of numbers.
pub(crate) type Vector<T> = [T; 3];

/// Returns `a . b`. The error is at most `DOT |a| |b|`, see [`Number::DOT`].
#[inline(always)]
pub(crate) fn dot<T: Arithmetic>(a: Vector<T>, b: Vector<T>) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns `a x b`. The error is at most `CROSS |a| |b|`, see [`Number::CROSS`].
#[inline(always)]
pub(crate) fn cross<T: Arithmetic>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Returns a vector rounded to `f64`.
#[inline(always)]
pub(crate) fn near<T: Number>(v: Vector<T>) -> Vector<f64> {
    v.map(T::near)
}

/// Returns the Euclidean length, with an error of a few roundings.
#[inline(always)]
pub(crate) fn length(v: Vector<f64>) -> f64 {
    dot(v, v).sqrt()
}

/// Range of a vector's largest coordinate in which no scaling is needed, see [`UNDERFLOW`].
pub(crate) const PLAIN: std::ops::Range<f64> = 1e-30..1e30;

/// Splits a vector into `(m, k)`, so that the vector is `m * 2^k` and the largest coordinate of m lies
/// in [`PLAIN`]. A coordinate that is 2^900 times smaller than the largest may lose digits, by less than
/// [`UNDERFLOW`].
pub(crate) fn scaled(v: Vector<DoubleDouble>) -> (Vector<DoubleDouble>, i32) {
    let largest = v.iter().map(|x| x.hi.abs()).fold(0.0, f64::max);
    if PLAIN.contains(&largest) || largest == 0.0 {
        return (v, 0);
    }
    let k = exponent(largest);
    (v.map(|x| x.scaled(-k)), k)
}
