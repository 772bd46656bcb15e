//! Where a row of a sphere begins and ends: decided once for every way that rows are drawn.

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::render::rows::span::MARGIN;

/// A vector of rows, each with `w^2` and the column of its middle known; see
/// [`Outlines`](crate::render::outline::Outlines).
pub(crate) struct RowEnds<S: Simd> {
    /// The outline's two ends.
    pub(crate) start: S::f64s,
    pub(crate) end: S::f64s,
    /// First and last column between them, by a margin.
    pub(crate) first: S::f64s,
    pub(crate) last: S::f64s,
    /// Rows in which no column lies within the margin of an end, and that are not thin.
    pub(crate) is_sure: <S::f64s as SimdBase<S>>::Mask,
}

impl<S: Simd> RowEnds<S> {
    #[inline(always)]
    pub(crate) fn new(simd: S, middle: S::f64s, squared: S::f64s, thin: S::f64s) -> RowEnds<S> {
        let zero = S::f64s::splat(simd, 0.0);
        let half = squared.max(zero).sqrt();
        let (start, end) = (middle - half, middle + half);
        let margin = S::f64s::splat(simd, MARGIN);
        let (first, last) = ((start + margin).ceil(), (end - margin).floor());
        let same_first = first.simd_eq((start - margin).ceil());
        let same_last = last.simd_eq((end + margin).floor());
        let is_sure = same_first & same_last & squared.simd_ge(thin);
        RowEnds { start, end, first, last, is_sure }
    }
}
