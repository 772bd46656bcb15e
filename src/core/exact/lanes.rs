//! Several `f64` side by side.

use std::ops::{Add, Div, Mul, Neg, Sub};

use fearless_simd::prelude::*;
use fearless_simd::{ExtractToken, Level, Simd};

use crate::exact::error_free::{SPLITTER, Split, dekker_product};
use crate::exact::lane::Lane;

/// A vector of the processor's own width.
#[derive(Clone, Copy)]
pub(crate) struct Lanes<S: Simd>(pub(crate) S::f64s);

impl<S: Simd> Lanes<S> {
    /// The same number in every lane.
    #[inline(always)]
    pub(crate) fn splat(simd: S, x: f64) -> Self {
        Lanes(S::f64s::splat(simd, x))
    }

    /// 1 in as many lanes as another vector has.
    #[inline(always)]
    pub(crate) fn one(like: Self) -> Self {
        Lanes::splat(like.0.token(), 1.0)
    }
}

/// Whether the level multiplies and adds in one instruction.
#[inline(always)]
pub(crate) fn is_fused(level: Level) -> bool {
    match level {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx2(_) | Level::Avx512(_) => true,
        #[cfg(target_arch = "aarch64")]
        Level::Neon(_) => true,
        _ => false,
    }
}

impl<S: Simd> Lane for Lanes<S> {
    #[inline(always)]
    fn sqrt(self) -> Self {
        Lanes(self.0.sqrt())
    }

    #[inline(always)]
    fn two_product(self, other: Self) -> (Self, Self) {
        if is_fused(self.0.token().level()) {
            let product = self.0 * other.0;
            (Lanes(product), Lanes(self.0.mul_sub_precise(other.0, product)))
        } else {
            dekker_product(self, other)
        }
    }

    #[inline(always)]
    fn half(self) -> Self {
        Lanes(self.0 * 0.5)
    }
}

impl<S: Simd> Split for Lanes<S> {
    #[inline(always)]
    fn shifted(self) -> Self {
        Lanes(self.0 * SPLITTER)
    }
}

impl<S: Simd> Add for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Lanes(self.0 + other.0)
    }
}

impl<S: Simd> Sub for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Lanes(self.0 - other.0)
    }
}

impl<S: Simd> Mul for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Lanes(self.0 * other.0)
    }
}

impl<S: Simd> Div for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Lanes(self.0 / other.0)
    }
}

impl<S: Simd> Neg for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Lanes(-self.0)
    }
}
