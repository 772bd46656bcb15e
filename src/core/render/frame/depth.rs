//! What a frame keeps `t` in, and how a row's answers go into it.

use std::ops::Range;

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd};

use crate::render::frame::{Frame, Stage};
use crate::scene::Scene;

/// A miss in a kernel's answers.
pub(crate) const MISS: f64 = f64::INFINITY;

/// In doubt, in a kernel's answers: the pixel goes up the ladder by itself.
pub(crate) const DOUBT: f64 = f64::NAN;

/// What a frame keeps `t` in: `f64`, within half an ulp and 2^-40 of one, or `f32`, within an ulp, at
/// a fraction of the time.
pub trait Depth: Copy + PartialOrd + Send + Sync + std::fmt::Debug + sealed::Sealed {
    /// 0
    #[doc(hidden)]
    const ZERO: Self;
    /// Where nothing is hit.
    const NONE: Self;
    /// How exact the row kernels' `t` must be, as a share.
    #[doc(hidden)]
    const DOUBT: f64;
    /// Whether that takes double-double.
    #[doc(hidden)]
    const IS_FINE: bool;

    /// The nearest one; infinite or the smallest positive one where it is beyond the range.
    #[doc(hidden)]
    fn of(t: f64) -> Self;

    /// Whether it is well within the range.
    #[doc(hidden)]
    fn is_in_range(t: f64) -> bool;

    /// As `f64`, exactly.
    fn widened(self) -> f64;

    /// The same numbers, where they are `f32`.
    #[doc(hidden)]
    fn singles(t: &mut [Self]) -> Option<&mut [f32]>;

    /// Takes over what is nearer than what is there, and tells whether anything
    /// [is in doubt](Depth::is_in_doubt), which it leaves as it is.
    #[doc(hidden)]
    fn blend<S: Simd>(
        simd: S,
        found: &[f64],
        t: &mut [Self],
        object: &mut [u32],
        index: u32,
    ) -> bool;

    /// Whether a blended pixel is in doubt: the kernel could not give its `t`, that is close to the
    /// ends of the range, or closer to what is there than their rounding.
    #[doc(hidden)]
    fn is_in_doubt(found: f64, t: Self, object: u32, index: u32) -> bool;
}

/// What is done with the rows of a band when they are traced: rows, `t`, objects.
pub(crate) type Finish<'a, T> = &'a (dyn Fn(Range<usize>, &[T], &[u32]) + Sync);

pub(crate) mod sealed {
    use super::*;

    /// The tracer of one precision.
    pub trait Sealed: Sized {
        /// See [`fill`](crate::render::fill). Neither generic nor inlined, it is compiled with this crate, once, and not
        /// again with each crate that calls what is generic over [`Depth`].
        fn fill(
            frame: &mut Frame<Self>,
            level: Level,
            scene: &Scene,
            finish: Option<Finish<'_, Self>>,
            observe: &(dyn Fn(Stage) + Sync),
        );
    }
}

/// Two `t` that are closer than this many spacings may be in the wrong order for their rounding.
const TIE: f64 = 4.0;

/// What one precision's [`Depth`] is, but for how lanes become its vectors.
macro_rules! depth {
    ($real:ident, $doubt:expr, $is_fine:expr, $range:expr, $blend_lanes:ident, $singles:expr) => {
        impl Depth for $real {
            const ZERO: $real = 0.0;
            const NONE: $real = $real::INFINITY;
            const DOUBT: f64 = $doubt;
            const IS_FINE: bool = $is_fine;

            #[inline(always)]
            fn of(t: f64) -> $real {
                (t as $real).max($real::from_bits(1))
            }

            #[inline(always)]
            fn is_in_range(t: f64) -> bool {
                t > $range.0.into() && t < $range.1.into()
            }

            #[inline(always)]
            fn widened(self) -> f64 {
                self.into()
            }

            fn singles(t: &mut [$real]) -> Option<&mut [f32]> {
                ($singles)(t)
            }

            #[inline(always)]
            fn blend<S: Simd>(
                simd: S,
                found: &[f64],
                t: &mut [$real],
                object: &mut [u32],
                index: u32,
            ) -> bool {
                let n = S::u32s::LEN;
                let whole = t.len() - t.len() % n;
                let mut any = false;
                let rows = t[..whole].chunks_exact_mut(n).zip(object[..whole].chunks_exact_mut(n));
                for (found, (t, object)) in found.chunks_exact(n).zip(rows) {
                    any |= $blend_lanes(simd, found, t, object, index);
                }
                for k in whole..t.len() {
                    let x = found[k] as $real;
                    let in_doubt = <$real as Depth>::is_in_doubt(found[k], t[k], object[k], index);
                    any |= in_doubt;
                    if !in_doubt && x < t[k] {
                        (t[k], object[k]) = (x, index);
                    }
                }
                any
            }

            #[inline(always)]
            fn is_in_doubt(found: f64, t: $real, object: u32, index: u32) -> bool {
                let x = found as $real;
                let tie = (TIE * f64::from($real::EPSILON)) as $real * x;
                let is_plain = (x > $range.0) & (x < $range.1);
                // A miss is infinite in f64 already; what only the narrowing makes infinite is none.
                let is_sure = (found == MISS) | (is_plain & ((x - t).abs() > tie));
                // What was just taken over is there itself.
                !is_sure && object != index
            }
        }
    };
}

// 2^-27 of f32 makes at most a quarter of an ulp, and its rounding half of one.
depth!(f32, 1.0 / (1_u64 << 27) as f64, false, SINGLE_RANGE, blend_single, Some);
depth!(f64, crate::exact::precise::T_DOUBT, true, DOUBLE_RANGE, blend_double, |_| None);

/// Well within the range, so that what is computed of it is too.
const SINGLE_RANGE: (f32, f32) = (1e-37, 1e38);
const DOUBLE_RANGE: (f64, f64) = (1e-290, 1e290);

/// Which lanes of x, misses apart, are nearer than what is known, and which are in doubt.
macro_rules! compare {
    ($simd:ident, $vector:ty, $x:ident, $known:ident, $is_miss:expr, $real:ident, $range:expr) => {{
        let tie = $x * ((TIE * f64::from($real::EPSILON)) as $real);
        let is_apart = ($x - $known).simd_gt(tie) | ($known - $x).simd_gt(tie);
        let is_plain = $x.simd_gt(<$vector>::splat($simd, $range.0))
            & $x.simd_lt(<$vector>::splat($simd, $range.1));
        let is_sure = $is_miss | (is_plain & is_apart);
        (is_sure & $x.simd_lt($known), !is_sure)
    }};
}

/// One vector of `f32`.
#[inline(always)]
fn blend_single<S: Simd>(
    simd: S,
    found: &[f64],
    t: &mut [f32],
    object: &mut [u32],
    index: u32,
) -> bool {
    let half = S::f64s::LEN;
    let low = S::f64s::from_slice(simd, &found[..half]);
    let high = S::f64s::from_slice(simd, &found[half..]);
    let miss = S::f64s::splat(simd, MISS);
    let is_miss = low.simd_eq(miss).narrow(high.simd_eq(miss));
    let (x, known) = (low.narrow(high), S::f32s::from_slice(simd, t));
    let (take, in_doubt) = compare!(simd, S::f32s, x, known, is_miss, f32, SINGLE_RANGE);
    // Vectors, not a loop over numbers: that would become masked stores, slow on many processors.
    take.select(x, known).store_slice(t);
    let objects = S::u32s::from_slice(simd, object);
    take.select(S::u32s::splat(simd, index), objects).store_slice(object);
    in_doubt.any_true()
}

/// Two vectors of `f64`.
#[inline(always)]
fn blend_double<S: Simd>(
    simd: S,
    found: &[f64],
    t: &mut [f64],
    object: &mut [u32],
    index: u32,
) -> bool {
    let half = S::f64s::LEN;
    let (low, high) = t.split_at_mut(half);
    let (low, low_in_doubt) = blend_half::<S>(simd, &found[..half], low);
    let (high, high_in_doubt) = blend_half::<S>(simd, &found[half..], high);
    let objects = S::u32s::from_slice(simd, object);
    let take = low.narrow(high);
    take.select(S::u32s::splat(simd, index), objects).store_slice(object);
    low_in_doubt | high_in_doubt
}

/// One vector of `f64`: which lanes were taken over, and whether any is in doubt.
#[inline(always)]
fn blend_half<S: Simd>(
    simd: S,
    found: &[f64],
    t: &mut [f64],
) -> (<S::f64s as SimdBase<S>>::Mask, bool) {
    let (x, known) = (S::f64s::from_slice(simd, found), S::f64s::from_slice(simd, t));
    let is_miss = x.simd_eq(S::f64s::splat(simd, MISS));
    let (take, in_doubt) = compare!(simd, S::f64s, x, known, is_miss, f64, DOUBLE_RANGE);
    take.select(x, known).store_slice(t);
    (take, in_doubt.any_true())
}
