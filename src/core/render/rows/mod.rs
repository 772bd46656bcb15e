//! Draws spheres row by row: where each row begins and ends, and `t` in between, in `f32`.

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::render::frame::NO_OBJECT;
use crate::render::outline::MOST_SINGLE_LANES;
use crate::render::rows::span::{SpanLanes, SpanRow};

pub(crate) mod small_spheres;
pub(crate) mod span;

/// The buffers of a row of pixels, and the column number of each pixel, a whole number.
pub(crate) struct RowBuffers<'a> {
    pub(crate) columns: &'a [f32],
    pub(crate) t: &'a mut [f32],
    pub(crate) object: &'a mut [u32],
    /// For each block (SIMD vector of pixels) of the row, true if its pixels have been written; empty if
    /// all blocks have been.
    pub(crate) is_written: &'a mut [bool],
}

/// Relative difference below which rounding may have put two `t` in the wrong order. The error of
/// each `t` is at most an ulp.
pub(crate) const TIE: f32 = 6.0 * f32::EPSILON;

/// For each block of pixels of a band, whether it has been written. The first sphere that covers part of
/// a block writes it without reading it; blocks that no sphere covers are cleared at the end.
///
/// A block is a SIMD vector of neighbouring pixels of a row. Pixels at the end of a row that do not fill
/// a block are cleared at the start.
pub(crate) struct WrittenBlocks {
    is_written: Vec<bool>,
    /// Number of blocks in a row.
    per_row: usize,
}

impl WrittenBlocks {
    /// Makes the blocks of rows of this many columns; none of them has been written.
    #[inline(always)]
    pub(crate) fn new<S: Simd>(
        _simd: S,
        (rows, width): (usize, usize),
        t: &mut [f32],
        object: &mut [u32],
    ) -> WrittenBlocks {
        let per_row = width / S::f32s::LEN;
        let whole = per_row * S::f32s::LEN;
        if whole < width {
            let rows = t.chunks_exact_mut(width).zip(object.chunks_exact_mut(width));
            for (t, object) in rows {
                t[whole..].fill(f32::INFINITY);
                object[whole..].fill(NO_OBJECT);
            }
        }
        WrittenBlocks { is_written: vec![false; rows * per_row], per_row }
    }

    /// Returns, for each block of a row of the band, whether it has been written.
    #[inline(always)]
    pub(crate) fn row(&mut self, row: usize) -> &mut [bool] {
        &mut self.is_written[row * self.per_row..(row + 1) * self.per_row]
    }

    /// Clears the blocks that have not been written.
    #[inline(always)]
    pub(crate) fn clear_others<S: Simd>(
        self,
        _simd: S,
        width: usize,
        t: &mut [f32],
        object: &mut [u32],
    ) {
        if self.per_row == 0 {
            return;
        }
        let rows = t.chunks_exact_mut(width).zip(object.chunks_exact_mut(width));
        for ((t, object), is_written) in rows.zip(self.is_written.chunks_exact(self.per_row)) {
            let mut start = 0;
            for run in is_written.chunk_by(|a, b| a == b) {
                let end = start + run.len() * S::f32s::LEN;
                if !run[0] {
                    t[start..end].fill(f32::INFINITY);
                    object[start..end].fill(NO_OBJECT);
                }
                start = end;
            }
        }
    }
}

/// Marks all pixels as having no hit.
#[inline(always)]
pub(crate) fn clear<S: Simd>(simd: S, t: &mut [f32], object: &mut [u32]) {
    let none = S::f32s::splat(simd, f32::INFINITY);
    let mut vectors = t.chunks_exact_mut(S::f32s::LEN);
    for vector in &mut vectors {
        none.store_slice(vector);
    }
    vectors.into_remainder().fill(f32::INFINITY);
    object.fill(NO_OBJECT);
}

/// The values that all SIMD vectors of pixels of one row share.
struct Drawing<S: Simd> {
    simd: S,
    below: S::f32s,
    above: S::f32s,
    none: S::f32s,
    /// Lower bound of all t of the row.
    nearest: S::f32s,
    begin: S::f32s,
    end: S::f32s,
    own: S::u32s,
}

impl<S: Simd> Drawing<S> {
    /// Draws one SIMD vector of pixels, in which no `t` of the sphere is below `nearest`; returns a mask
    /// of the pixels that are too close to call.
    #[inline(always)]
    fn draw<const CORRECTS_ROOT: bool>(
        &self,
        columns: &[f32],
        t: &mut [f32],
        object: &mut [u32],
        (lanes, nearest): (&SpanLanes<S>, S::f32s),
    ) -> <S::f32s as SimdBase<S>>::Mask {
        let columns = S::f32s::from_slice(self.simd, columns);
        let known = S::f32s::from_slice(self.simd, t);
        if known.simd_lt(nearest).all_true() {
            return self.none.simd_lt(self.none);
        }
        let found = lanes.t(columns, CORRECTS_ROOT);
        let is_inside = columns.simd_ge(self.begin) & columns.simd_le(self.end);
        let is_nearer = is_inside & found.simd_lt(known * self.below);
        // Selecting between the new and the stored value would compile to a masked store, which is slow
        // on many processors.
        let nearest = is_nearer.select(found, self.none).min(known);
        nearest.store_slice(t);
        let objects = S::u32s::from_slice(self.simd, object);
        let is_changed = is_nearer.select(self.own ^ objects, S::u32s::splat(self.simd, 0));
        (objects ^ is_changed).store_slice(object);
        let is_farther = found.simd_gt(known * self.above);
        is_inside & !(is_nearer | is_farther)
    }

    /// Draws one block that has not been written yet. `is_whole` is true if the sphere covers all of it.
    #[inline(always)]
    fn write<const CORRECTS_ROOT: bool>(
        &self,
        is_whole: bool,
        columns: &[f32],
        t: &mut [f32],
        object: &mut [u32],
        lanes: &SpanLanes<S>,
    ) {
        let columns = S::f32s::from_slice(self.simd, columns);
        if is_whole {
            lanes.t(columns, CORRECTS_ROOT).store_slice(t);
            self.own.store_slice(object);
            return;
        }
        let is_inside = columns.simd_ge(self.begin) & columns.simd_le(self.end);
        let found = lanes.t(columns, CORRECTS_ROOT);
        is_inside.select(found, self.none).store_slice(t);
        is_inside.select(self.own, S::u32s::splat(self.simd, NO_OBJECT)).store_slice(object);
    }
}

/// Writes the sphere's pixels in the columns `from..=to` of a row where they are nearer than the known
/// hits. No `t` of the sphere is below `nearest`, or below the bound in `bounds` of its SIMD vector of
/// pixels, if the vector has one. Returns whether any pixel is too close to call; such pixels stay
/// unchanged.
#[inline(always)]
pub(crate) fn draw_row<S: Simd, const CORRECTS_ROOT: bool>(
    simd: S,
    buffers: &mut RowBuffers,
    (from, to): (usize, usize),
    (index, nearest, bounds): (u32, f32, &VectorBounds),
    lanes: &SpanLanes<S>,
) -> bool {
    let n = S::f32s::LEN;
    let drawing = Drawing {
        simd,
        below: S::f32s::splat(simd, 1.0 - TIE),
        above: S::f32s::splat(simd, 1.0 + TIE),
        none: S::f32s::splat(simd, f32::INFINITY),
        nearest: S::f32s::splat(simd, nearest),
        begin: S::f32s::splat(simd, buffers.columns[from]),
        end: S::f32s::splat(simd, buffers.columns[to]),
        own: S::u32s::splat(simd, index),
    };
    let mut in_doubt = drawing.none.simd_lt(drawing.none);
    // While blocks may be unwritten, vectors must coincide with blocks.
    let mut at = if buffers.is_written.is_empty() { from } else { from - from % n };
    for is_written in buffers.is_written.iter_mut().take(to / n + 1).skip(from / n) {
        let vector = at..at + n;
        let (t, object) = (&mut buffers.t[vector.clone()], &mut buffers.object[vector.clone()]);
        let columns = &buffers.columns[vector];
        if *is_written {
            in_doubt |= drawing.draw::<CORRECTS_ROOT>(columns, t, object, (lanes, drawing.nearest));
        } else {
            *is_written = true;
            let is_whole = from <= at && at + n <= to + 1;
            drawing.write::<CORRECTS_ROOT>(is_whole, columns, t, object, lanes);
        }
        at += n;
    }
    // Whole vectors begin at columns below this one.
    let whole = (buffers.t.len() + 1).saturating_sub(n).min(to + 1);
    let mut vector = 0;
    while at < whole {
        let (t, object) = (&mut buffers.t[at..at + n], &mut buffers.object[at..at + n]);
        let nearest = match bounds.get(vector) {
            Some(nearest) => S::f32s::splat(simd, nearest),
            None => drawing.nearest,
        };
        let columns = &buffers.columns[at..at + n];
        in_doubt |= drawing.draw::<CORRECTS_ROOT>(columns, t, object, (lanes, nearest));
        (at, vector) = (at + n, vector + 1);
    }
    if at <= to {
        // The buffers end within this vector.
        let (mut t, mut object) = ([0.0; 16], [0; 16]);
        let left = buffers.t.len() - at;
        t[..left].copy_from_slice(&buffers.t[at..]);
        object[..left].copy_from_slice(&buffers.object[at..]);
        let columns = &buffers.columns[at..at + n];
        in_doubt |= drawing.draw::<CORRECTS_ROOT>(
            columns,
            &mut t[..n],
            &mut object[..n],
            (lanes, drawing.nearest),
        );
        buffers.t[at..].copy_from_slice(&t[..left]);
        buffers.object[at..].copy_from_slice(&object[..left]);
    }
    in_doubt.any_true()
}

/// Maximum number of SIMD vectors of pixels of a row that have their own bounds.
const MOST: usize = 256;

/// Lower bounds of `t` in each SIMD vector of pixels of a row.
///
/// In `t = numerator / (b + S)` (see [`Outline`](crate::render::outline::Outline)), `b + S` is concave
/// along a row: its largest value between two columns is at one of the columns or, if the peak lies
/// between them, at the peak. Columns are counted from the row's first one, which keeps rounding errors
/// at about `2^-21`; the bounds allow 1e-5 for them.
pub(crate) struct VectorBounds {
    /// For each vector, a bound at its first column and a bound at the first column of the next.
    at_columns: [f32; MOST + MOST_SINGLE_LANES],
    count: usize,
}

impl VectorBounds {
    pub(crate) const NONE: VectorBounds =
        VectorBounds { at_columns: [0.0; MOST + MOST_SINGLE_LANES], count: 0 };

    /// Computes the bounds of `columns` neighbouring columns, the first of which is `column`.
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
        // The peak, where the slope of S is the negative of b's slope.
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

    /// Removes all bounds.
    #[inline(always)]
    pub(crate) fn clear(&mut self) {
        self.count = 0;
    }

    /// Returns the bound of a vector; `None` if it has none.
    #[inline(always)]
    pub(crate) fn get(&self, vector: usize) -> Option<f32> {
        (vector < self.count).then(|| self.at_columns[vector].min(self.at_columns[vector + 1]))
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;

    /// Asserts that no column of a row has a smaller t than its vector's bound, for
    /// `b = b_first + b_column m`, where m counts columns from the first one.
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
