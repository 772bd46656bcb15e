//! The rows of one sphere: where they begin and end, and what their pixels share, a vector of rows at
//! a time.

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::render::outline::MOST_LANES;
use crate::render::outline::raster_axes::RasterAxes;
use crate::render::rows::row_ends::RowEnds;
use crate::render::rows::span::{Outline, Span};
use crate::render::rows::span_kernel::SpanRow;

/// As many `f32` as two vectors of `f64` narrow to.
type Singles = [f32; 2 * MOST_LANES];

/// A vector of rows.
pub(crate) struct SpanRows {
    first: Singles,
    last: Singles,
    left: Singles,
    right: Singles,
    b: [Singles; 2],
    pivot: Singles,
    offset: Singles,
    /// First and last column of the raster, as numbers.
    from: [f64; MOST_LANES],
    to: [f64; MOST_LANES],
    /// Rows that are beyond doubt and have a column of the raster.
    pub(crate) is_drawn: u64,
    /// Rows in which a pixel is in doubt.
    pub(crate) is_doubtful: u64,
}

#[inline(always)]
fn store<S: Simd>(x: S::f64s) -> [f64; MOST_LANES] {
    let mut all = [0.0; MOST_LANES];
    x.store_slice(&mut all[..S::f64s::LEN]);
    all
}

#[inline(always)]
fn store_narrow<S: Simd>(x: S::f64s) -> Singles {
    let mut all = [0.0; 2 * MOST_LANES];
    x.narrow(x).store_slice(&mut all[..S::f32s::LEN]);
    all
}

impl SpanRows {
    /// The sphere's rows from the raster's row `base` on.
    #[inline(always)]
    pub(crate) fn find<S: Simd>(simd: S, span: &Span, axes: &RasterAxes, base: usize) -> SpanRows {
        let splat = |x: f64| S::f64s::splat(simd, x);
        let Outline { column, row, shear, square, square_doubt, .. } = span.outline;
        let Outline { b0, b_column, b_row, .. } = span.outline;
        let numbers = &axes.row_numbers[base..base + S::f64s::LEN];
        let j = S::f64s::from_slice(simd, numbers) - splat(row);
        let middle = splat(column) + splat(shear) * j;
        let squared = splat(square[0]) + (splat(square[1]) + splat(square[2]) * j) * j;
        let ends = RowEnds::<S>::new(simd, middle, squared, splat(span.outline.thin));
        let RowEnds { start, end, first, last, is_sure } = ends;
        let (from, to, is_there) = axes.clip(simd, first, last);
        let is_wide = span.shape.is_wide;
        let pivot = if is_wide { first } else { splat(0.5) * (first + last) };
        let b = splat(b0) + splat(b_row) * j + splat(b_column) * pivot;
        let high = b.narrow(b);
        let (left, right) = (first - start, end - last);
        let offset = if is_wide { store_narrow::<S>(left * right) } else { [0.0; 2 * MOST_LANES] };
        let is_doubtful =
            squared.simd_ge(splat(-square_doubt)).to_bitmask() & !is_sure.to_bitmask();
        SpanRows {
            first: store_narrow::<S>(first),
            last: store_narrow::<S>(last),
            left: store_narrow::<S>(left),
            right: store_narrow::<S>(right),
            b: [store_narrow::<S>(b), store_narrow::<S>(b - high.widen().0)],
            pivot: store_narrow::<S>(pivot),
            offset,
            from: store::<S>(from),
            to: store::<S>(to),
            is_drawn: is_sure.to_bitmask() & is_there,
            is_doubtful,
        }
    }

    /// One row.
    #[inline(always)]
    pub(crate) fn row(&self, lane: usize) -> SpanRow {
        SpanRow {
            first: self.first[lane],
            last: self.last[lane],
            left: self.left[lane],
            right: self.right[lane],
            b: self.b.map(|b| b[lane]),
            pivot: self.pivot[lane],
            offset: self.offset[lane],
        }
    }

    /// A row's first and last column in the raster.
    #[inline(always)]
    pub(crate) fn columns(&self, lane: usize) -> (usize, usize) {
        // By way of i32, which processors convert to in one instruction.
        (self.from[lane] as i32 as usize, self.to[lane] as i32 as usize)
    }
}
