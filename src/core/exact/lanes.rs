//! SIMD vectors of `f64` or `f32`.
//!
//! The module uses `fearless_simd`, which chooses AVX-512, AVX2, SSE4.2 or NEON at run time, on stable
//! Rust and without any `unsafe` in this crate. In measurements it was as fast as the processor's
//! intrinsics. `pulp` was 3 % slower on the kernel that draws rows, `wide` cannot choose at run time,
//! and loops vectorized by the compiler took two to three times as long.

use std::ops::{Add, Div, Mul, Neg, Sub};

use fearless_simd::prelude::*;
use fearless_simd::{ExtractToken, Level, Simd};

use crate::exact::double_double::{Lane, SPLITTER, dekker_product};

/// A SIMD vector of `f64`, with as many lanes as the SIMD level S has.
#[derive(Clone, Copy)]
pub(crate) struct Lanes<S: Simd>(pub(crate) S::f64s);

/// A SIMD vector of `f32`, with as many lanes as the SIMD level S has.
#[derive(Clone, Copy)]
pub(crate) struct SingleLanes<S: Simd>(pub(crate) S::f32s);

/// Returns whether the level has fused multiply-add.
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

macro_rules! operator {
    ($lanes:ident, $trait:ident, $method:ident, $operator:tt) => {
        impl<S: Simd> $trait for $lanes<S> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                $lanes(self.0 $operator other.0)
            }
        }
    };
}

/// Implements arithmetic for a SIMD vector type, given its element type and the factor of Veltkamp's
/// splitting for that type.
macro_rules! lanes {
    ($lanes:ident, $real:ident, $vector:ident, $splitter:expr) => {
        impl<S: Simd> $lanes<S> {
            /// Returns a vector with one number in every lane.
            #[inline(always)]
            pub(crate) fn splat(simd: S, x: $real) -> Self {
                $lanes(S::$vector::splat(simd, x))
            }
        }

        operator!($lanes, Add, add, +);
        operator!($lanes, Sub, sub, -);
        operator!($lanes, Mul, mul, *);
        operator!($lanes, Div, div, /);

        impl<S: Simd> Neg for $lanes<S> {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                $lanes(-self.0)
            }
        }

        impl<S: Simd> Lane for $lanes<S> {
            #[inline(always)]
            fn sqrt(self) -> Self {
                $lanes(self.0.sqrt())
            }

            #[inline(always)]
            fn two_product(self, other: Self) -> (Self, Self) {
                if is_fused(self.0.token().level()) {
                    let product = self.0 * other.0;
                    ($lanes(product), $lanes(self.0.mul_sub_precise(other.0, product)))
                } else {
                    dekker_product(self, other)
                }
            }

            #[inline(always)]
            fn half(self) -> Self {
                $lanes(self.0 * 0.5)
            }

            #[inline(always)]
            fn not_negative(self) -> Self {
                $lanes(self.0.max(S::$vector::splat(self.0.token(), 0.0)))
            }

            #[inline(always)]
            fn shifted(self) -> Self {
                $lanes(self.0 * $splitter)
            }
        }
    };
}

lanes!(Lanes, f64, f64s, SPLITTER);
// For f32, the factor is 2^12 + 1.
lanes!(SingleLanes, f32, f32s, (1_u32 << 12) as f32 + 1.0);

impl<S: Simd> SingleLanes<S> {
    /// Returns the residual `self - a * b` of a computed square root or quotient. `a * b` must be so
    /// close to `self` that the difference is exact.
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

/// Returns the numbers of the lanes whose bits are set in a mask, in ascending order.
#[inline(always)]
pub(crate) fn lanes_of(mut bits: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = bits.trailing_zeros() as usize;
        let is_left = bits != 0;
        bits &= bits.wrapping_sub(1);
        is_left.then_some(lane)
    })
}
