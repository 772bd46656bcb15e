//! Lower bounds of `t` along a row: what nearer spheres hide is not computed.

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::render::outline::MOST_SINGLE_LANES;
use crate::render::rows::span::SpanRow;

/// Maximum number of vectors of a row that have a bound of their own.
const MOST: usize = 256;

/// Lower bounds of `t` in each vector of a row.
///
/// `b + S` is concave along a row: its largest value between two columns is at one of them, or at its
/// peak, if that lies between. Columns count from the row's first one on, so that the rounding errors are
/// some `2^-21`; the bounds leave 1e-5 for them.
pub(crate) struct VectorBounds {
    /// Bounds at the first column of each vector, and at that of the next.
    at_columns: [f32; MOST + MOST_SINGLE_LANES],
    count: usize,
}

impl VectorBounds {
    pub(crate) const NONE: VectorBounds =
        VectorBounds { at_columns: [0.0; MOST + MOST_SINGLE_LANES], count: 0 };

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
        let mut numbers = [0.0; MOST_SINGLE_LANES];
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
        let (length, pivot) = (row.last - row.first, row.pivot - row.first);
        let middle = 0.5 * (length + (row.right - row.left));
        let half = 0.5 * (length + (row.left + row.right));
        let slant = (1.0 + b_column * b_column).sqrt();
        let from = column - row.first;
        let peak = ((middle + half * b_column / slant - from) / n as f32).floor();
        if peak >= 0.0 && peak < self.count as f32 {
            let highest = row.b[0] + (middle - pivot) * b_column + half * slant;
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

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;

    /// Asserts that no column of a row has a smaller t than its vector's bound, where
    /// `b = b_first + b_column m`, m columns from the first one.
    fn assert_bounds(first: f32, last: f32, [left, right, b_first, b_column]: [f32; 4]) {
        let level = Level::new();
        let n = dispatch!(level, simd => lanes(simd));
        let row = SpanRow {
            first,
            last,
            left,
            right,
            b: [b_first, 0.0],
            pivot: first,
            offset: left * right,
            nearest: 0.0,
        };
        let mut bounds = VectorBounds::NONE;
        let columns = (last - first) as usize + 1;
        let numbers = (1.0, b_column, &row);
        dispatch!(level, simd => bounds.find(simd, numbers, (first, columns)));
        assert!(bounds.get(0).is_some_and(|bound| bound > 0.0), "{row:?}");
        for m in 0..columns {
            let Some(bound) = bounds.get(m / n) else { continue };
            let [m, left, right] = [m as f64, f64::from(left), f64::from(right)];
            let square = (m + left) * (f64::from(last - first) - m + right);
            let b = f64::from(b_first) + f64::from(b_column) * m;
            let t = 1.0 / (b + square.sqrt());
            assert!(f64::from(bound) <= t, "{row:?}, column {m}: {bound} and {t}");
        }
    }

    fn lanes<S: Simd>(_simd: S) -> usize {
        S::f32s::LEN
    }

    #[test]
    fn bounds_are_below_t_however_far_to_the_right_a_row_lies() {
        for first in [0.0, 5.0, 1000.0, 32_900.0, 65_000.0] {
            for length in [127.0, 200.0, 531.0] {
                for b_column in [-3.0, -0.9, -0.31, 0.0, 0.017, 0.5, 1.7, 4.0] {
                    for (left, right) in [(0.001, 0.9), (0.5, 0.37), (0.99, 0.002)] {
                        let least = 1.0 - length * f32::min(b_column, 0.0);
                        assert_bounds(first, first + length, [left, right, least, b_column]);
                    }
                }
            }
        }
    }
}
