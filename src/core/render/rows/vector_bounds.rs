//! Lower bounds of `t` along a row: what nearer spheres hide is not computed.

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::render::rows::span::SpanRow;

/// Maximum number of vectors of a row that have a bound of their own.
const MOST: usize = 256;

/// The widest vector of `f32` that any level has.
const MOST_LANES: usize = 16;

/// Lower bounds of `t` in each vector of a row.
///
/// `b + S` is concave along a row: its largest value between two columns is at one of them, or at its
/// peak, if that lies between. There are rounding errors of some `2^-22`; the bounds leave 1e-5 for them.
pub(crate) struct VectorBounds {
    /// Bounds at the first column of each vector, and at that of the next.
    at_columns: [f32; MOST + MOST_LANES],
    count: usize,
}

impl VectorBounds {
    pub(crate) const NONE: VectorBounds =
        VectorBounds { at_columns: [0.0; MOST + MOST_LANES], count: 0 };

    /// Finds them for so many columns from a first one on, which follow one another without a gap.
    #[inline(always)]
    pub(crate) fn find<S: Simd>(
        &mut self,
        simd: S,
        (numerator, b_column, row): (f32, f32, &SpanRow),
        (column, columns): (f32, usize),
    ) {
        let n = S::f32s::LEN;
        self.count = (columns.div_ceil(n)).min(MOST - 1);
        let splat = |x: f32| S::f32s::splat(simd, x);
        let (first, last) = (splat(row.first), splat(row.last));
        let nearest = splat(numerator * (1.0 - 1e-5));
        let step = splat((n * n) as f32);
        let mut numbers = [0.0; MOST_LANES];
        for (k, number) in numbers.iter_mut().enumerate() {
            *number = column + (k * n) as f32;
        }
        let mut at = S::f32s::from_slice(simd, &numbers[..n]);
        for bounds in self.at_columns.chunks_exact_mut(n).take(self.count / n + 1) {
            let column = at.min(last);
            let square =
                ((column - first) + splat(row.left)) * ((last - column) + splat(row.right));
            let b = splat(row.b[0]) + (column - splat(row.pivot)) * splat(b_column);
            let bound = nearest / (b + square.max(splat(0.0)).sqrt());
            bound.store_slice(bounds);
            at += step;
        }
        // The peak, where the slope of S is that of -b.
        let (start, end) = (row.first - row.left, row.last + row.right);
        let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
        let slant = (1.0 + b_column * b_column).sqrt();
        let peak = ((middle + half * b_column / slant - column) / n as f32).floor();
        if peak >= 0.0 && peak < self.count as f32 {
            let highest = row.b[0] + (middle - row.pivot) * b_column + half * slant;
            let bound = &mut self.at_columns[peak as usize];
            *bound = bound.min(numerator * (1.0 - 1e-5) / highest);
        }
    }

    /// Leaves none.
    #[inline(always)]
    pub(crate) fn clear(&mut self) {
        self.count = 0;
    }

    /// The bound of a vector, if it has one.
    #[inline(always)]
    pub(crate) fn get(&self, vector: usize) -> Option<f32> {
        (vector < self.count).then(|| self.at_columns[vector].min(self.at_columns[vector + 1]))
    }
}
