//! Several `f64`, or several `f32`, side by side.
//!
//! By `fearless_simd`: it chooses AVX-512, AVX2, SSE4.2 or NEON when the program runs, on stable Rust and
//! without `unsafe` of ours, and was as fast as the processor's own intrinsics. `pulp` was 3 % slower on
//! the row kernel, `wide` cannot choose at run time, and loops left to the compiler took two to three
//! times as long.

use std::ops::{Add, Div, Mul, Neg, Sub};

use fearless_simd::prelude::*;
use fearless_simd::{ExtractToken, Level, Simd};

use crate::exact::error_free::{Lane, SPLITTER, Split, dekker_product};

/// A vector of `f64` of the processor's own width.
#[derive(Clone, Copy)]
pub(crate) struct Lanes<S: Simd>(pub(crate) S::f64s);

impl<S: Simd> Lanes<S> {
    /// Returns a vector with one number in every lane.
    #[inline(always)]
    pub(crate) fn splat(simd: S, x: f64) -> Self {
        Lanes(S::f64s::splat(simd, x))
    }
}

/// Returns whether the level multiplies and adds in one instruction.
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

/// A vector of `f32` of the processor's own width.
#[derive(Clone, Copy)]
pub(crate) struct SingleLanes<S: Simd>(pub(crate) S::f32s);

impl<S: Simd> SingleLanes<S> {
    /// Returns a vector with one number in every lane.
    #[inline(always)]
    pub(crate) fn splat(simd: S, x: f32) -> Self {
        SingleLanes(S::f32s::splat(simd, x))
    }

    /// `self - a * b`, rounded once, where `a * b` is so close to self that their difference is
    /// exact: the residual of a root or a quotient.
    #[inline(always)]
    pub(crate) fn residual(self, a: Self, b: Self) -> Self {
        if is_fused(self.0.token().level()) {
            SingleLanes((-a.0).mul_add_precise(b.0, self.0))
        } else {
            let (product, error) = a.two_product(b);
            (self - product) - error
        }
    }
}

impl<S: Simd> Lane for SingleLanes<S> {
    #[inline(always)]
    fn sqrt(self) -> Self {
        SingleLanes(self.0.sqrt())
    }

    #[inline(always)]
    fn two_product(self, other: Self) -> (Self, Self) {
        if is_fused(self.0.token().level()) {
            let product = self.0 * other.0;
            (SingleLanes(product), SingleLanes(self.0.mul_sub_precise(other.0, product)))
        } else {
            dekker_product(self, other)
        }
    }

    #[inline(always)]
    fn half(self) -> Self {
        SingleLanes(self.0 * 0.5)
    }
}

/// Veltkamp's factor for `f32`, `2^12 + 1`.
const SINGLE_SPLITTER: f32 = (1_u32 << 12) as f32 + 1.0;

impl<S: Simd> Split for SingleLanes<S> {
    #[inline(always)]
    fn shifted(self) -> Self {
        SingleLanes(self.0 * SINGLE_SPLITTER)
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $operator:tt) => {
        impl<S: Simd> $trait for SingleLanes<S> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                SingleLanes(self.0 $operator other.0)
            }
        }
    };
}

operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
operator!(Div, div, /);

impl<S: Simd> Neg for SingleLanes<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        SingleLanes(-self.0)
    }
}

/// The lanes whose bits are set.
#[inline(always)]
pub(crate) fn lanes_of(mut bits: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = bits.trailing_zeros() as usize;
        let is_left = bits != 0;
        bits &= bits.wrapping_sub(1);
        is_left.then_some(lane)
    })
}
