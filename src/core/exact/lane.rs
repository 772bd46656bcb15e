//! What the ladder's formulas are written over: one number, or several side by side.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::exact::error_free::dekker_product;

/// One `f64`, or a SIMD vector of them, all rounded to nearest.
///
/// The same operations give the same bits whatever the width, because none of them fuses a product
/// with a sum but where the result is exact.
pub trait Lane:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The rounded square root.
    fn sqrt(self) -> Self;

    /// `(p, e)` with `p = fl(self * other)` and `self * other = p + e` exactly, for factors below
    /// 2^996 and products of at least 2^-969. Below that, e is off by at most 2^-1073.
    fn two_product(self, other: Self) -> (Self, Self);

    /// `x / 2`.
    fn half(self) -> Self;
}

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
}
