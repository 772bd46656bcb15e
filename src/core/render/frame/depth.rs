//! The number that a frame keeps `t` in.

use std::ops::Range;

use fearless_simd::Level;

use crate::render::frame::Frame;
use crate::scene::Scene;

/// The number that a frame keeps `t` in: `f64`, rounded from the exact one, or `f32`, within
/// an ulp, at a fraction of the time.
pub trait Depth: Copy + PartialOrd + Send + Sync + std::fmt::Debug + sealed::Sealed {
    /// 0
    #[doc(hidden)]
    const ZERO: Self;
    /// The `t` of a pixel where nothing is hit.
    const NONE: Self;
    /// True if frames are drawn in it; `t` in `f64` is found when the objects are known.
    #[doc(hidden)]
    const IS_DRAWN: bool;

    /// Returns the number as `f64`, exactly.
    fn widened(self) -> f64;

    /// Returns the numbers that are drawn: `t` itself, or as many of the thread's own.
    #[doc(hidden)]
    fn drawn<'a>(t: &'a mut [Self], own: &'a mut Vec<f32>) -> &'a mut [f32];

    /// Returns the numbers that are found when the objects are known: `t` itself, or none.
    #[doc(hidden)]
    fn found(t: &mut [Self]) -> &mut [f64];
}

impl Depth for f32 {
    const ZERO: f32 = 0.0;
    const NONE: f32 = f32::INFINITY;
    const IS_DRAWN: bool = true;

    #[inline(always)]
    fn widened(self) -> f64 {
        self.into()
    }

    fn drawn<'a>(t: &'a mut [f32], _: &'a mut Vec<f32>) -> &'a mut [f32] {
        t
    }

    fn found(_: &mut [f32]) -> &mut [f64] {
        &mut []
    }
}

impl Depth for f64 {
    const ZERO: f64 = 0.0;
    const NONE: f64 = f64::INFINITY;
    const IS_DRAWN: bool = false;

    #[inline(always)]
    fn widened(self) -> f64 {
        self
    }

    fn drawn<'a>(t: &'a mut [f64], own: &'a mut Vec<f32>) -> &'a mut [f32] {
        own.resize(t.len().max(own.len()), 0.0);
        &mut own[..t.len()]
    }

    fn found(t: &mut [f64]) -> &mut [f64] {
        t
    }
}

/// A step that is taken with the rows of a band when they are traced: rows, `t`, objects.
pub(crate) type Finish<'a, T> = &'a (dyn Fn(Range<usize>, &[T], &[u32]) + Sync);

pub(crate) mod sealed {
    use super::*;

    /// The tracer of one precision.
    pub trait Sealed: Sized {
        /// See [`fill`](crate::render::fill). Neither generic nor inlined, it is compiled with this
        /// crate, once, and not again with each crate that calls what is generic over [`Depth`].
        fn fill(
            frame: &mut Frame<Self>,
            level: Level,
            scene: &Scene,
            finish: Option<Finish<'_, Self>>,
            done: &(dyn Fn(usize) + Sync),
        );
    }
}
