//! Draws a sphere row by row: finds the columns that it covers in each row, with a margin for errors at
//! their ends, and computes `t` in these columns.

use std::ops::Range;

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::exact::double_double::Lane;
use crate::exact::lanes::{SingleLanes, lanes_of};
use crate::render::outline::raster_axes::RasterAxes;
use crate::render::outline::small_outlines::Singles;
use crate::render::outline::{MARGIN, MOST_LANES, Outline};
use crate::render::rows::{RowBuffers, TIE, VectorBounds, WrittenBlocks, draw_row};

/// A sphere that can be drawn by rows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    pub(crate) index: u32,
    pub(crate) outline: Outline,
    /// The numerator of `t` (see [`Outline`]), in two parts.
    numerator: [f32; 2],
    /// Change of b (see [`Outline`]) from one column to the next, in two parts. If
    /// [`Outline::corrects_root`] is true, the first part has 12 bits.
    b_column: [f32; 2],
}

/// A pixel in doubt, left to the ladder. The question is whether a sphere covers it or, if the sphere's
/// `t` is given, whether the sphere is nearer than the object that the pixel shows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Doubt {
    pub(crate) index: u32,
    pub(crate) row: u32,
    pub(crate) column: u32,
    pub(crate) t: Option<f32>,
}

impl Span {
    #[inline(always)]
    pub(crate) fn new(index: u32, outline: &Outline) -> Span {
        let Outline { b_column, numerator, corrects_root, .. } = *outline;
        let b_column = if corrects_root {
            let high = rounded_to_12_bits(b_column as f32);
            [high, (b_column - f64::from(high)) as f32]
        } else {
            two_parts(b_column)
        };
        Span { index, outline: *outline, numerator: two_parts(numerator), b_column }
    }

    /// Returns the rows of the raster that the sphere can cover.
    #[inline(always)]
    pub(crate) fn rows(&self, axes: &RasterAxes) -> Range<usize> {
        axes.rows_between(self.outline.first_row, self.outline.last_row)
    }
}

/// Rounds to the nearest number of 12 bits.
#[inline(always)]
fn rounded_to_12_bits(x: f32) -> f32 {
    let shifted = x * 4097.0;
    shifted - (shifted - x)
}

/// Splits a number into a sum of two `f32`.
#[inline(always)]
fn two_parts(x: f64) -> [f32; 2] {
    let high = x as f32;
    [high, (x - f64::from(high)) as f32]
}

/// Returns the first run of pixels of a range of the target, in which the objects that they show do not
/// certainly hide a sphere. Its arguments are the sphere, the range, and the objects of all pixels.
pub(crate) type Unhidden<'a> = &'a mut dyn FnMut(u32, Range<usize>, &[u32]) -> Range<usize>;

/// The rows of the raster that spans are drawn into.
pub(crate) struct SpanTarget<'a> {
    pub(crate) axes: &'a RasterAxes,
    pub(crate) rows: Range<usize>,
    pub(crate) t: &'a mut [f32],
    pub(crate) object: &'a mut [u32],
    /// Which blocks (SIMD vectors of pixels) have been written so far; `None` if all pixels were cleared
    /// at the start.
    pub(crate) written: Option<&'a mut WrittenBlocks>,
    pub(crate) doubts: &'a mut Vec<Doubt>,
    /// Passes over hidden pixels; `None` if no pixel's hit is known so well.
    pub(crate) unhidden: Option<Unhidden<'a>>,
    /// True if the raster has no gaps, as the bounds require, and spheres overlap so much that it pays
    /// to test whether each SIMD vector of pixels of a row is hidden.
    pub(crate) has_vector_bounds: bool,
    /// The bounds of the current row, if it has any.
    pub(crate) bounds: VectorBounds,
    /// For each row of the target, true if an outline reaches it.
    pub(crate) is_reached: &'a mut [bool],
    /// True if all rows are reached, so that no more need to be marked.
    pub(crate) is_all_reached: bool,
    /// Number of pixels that were decided.
    pub(crate) decided: u64,
}

/// Minimum length, in pixels, of a row whose SIMD vectors have bounds of their own; the vectors of a
/// shorter row share one bound.
const SHORT: usize = 128;

impl SpanTarget<'_> {
    /// Marks these rows of the target as reached by an outline.
    #[inline(always)]
    pub(crate) fn reach(&mut self, rows: Range<usize>) {
        self.is_reached[rows].fill(true);
        self.is_all_reached = !self.is_reached.contains(&false);
    }

    /// Adds pixels of a row of the raster to those in doubt: the ladder decides whether the sphere
    /// covers them.
    pub(crate) fn doubt(&mut self, index: u32, row: usize, columns: Range<usize>) {
        let row = row as u32;
        let doubt = |column| Doubt { index, row, column: column as u32, t: None };
        self.doubts.extend(columns.map(doubt));
    }

    /// Returns whether so many pixels have been left to the ladder that they should be decided before
    /// drawing continues.
    pub(crate) fn is_full(&self) -> bool {
        const FULL: usize = 1 << 16;
        self.doubts.len() >= FULL
    }
}

impl Span {
    /// Returns the rows of the raster that lie in the target and in the sphere's outline.
    #[inline(always)]
    pub(crate) fn rows_in(&self, target: &SpanTarget) -> Range<usize> {
        let own = self.rows(target.axes);
        own.start.max(target.rows.start)..own.end.min(target.rows.end)
    }

    /// Draws some of the sphere's rows, within a range of columns.
    #[inline(always)]
    pub(crate) fn draw<S: Simd>(
        &self,
        simd: S,
        target: &mut SpanTarget,
        rows: Range<usize>,
        between: &Range<usize>,
    ) {
        let mut base = rows.start;
        while base < rows.end {
            let ends = SpanRows::find::<S>(simd, self, target.axes, base);
            let there = u64::MAX >> (64 - S::f64s::LEN.min(rows.end - base));
            for lane in lanes_of(ends.is_drawn & there) {
                let (row, (from, to)) = (base + lane, ends.columns(lane));
                let columns = (from.max(between.start), to.min(between.end - 1));
                if columns.0 <= columns.1 {
                    self.draw_row(simd, target, row, &ends.row(lane), columns);
                }
            }
            for lane in lanes_of(ends.is_doubtful & there) {
                self.doubtful_row(simd, target, base + lane);
            }
            base += S::f64s::LEN;
        }
    }

    /// Draws the part of a row between two columns of the raster, and adds to the pixels in doubt those in
    /// which the sphere's hit and the known hit are too close to call.
    #[inline(always)]
    fn draw_row<S: Simd>(
        &self,
        simd: S,
        target: &mut SpanTarget,
        row: usize,
        span_row: &SpanRow,
        (from, to): (usize, usize),
    ) {
        target.decided += (to + 1 - from) as u64;
        target.is_reached[row - target.rows.start] = true;
        let start = (row - target.rows.start) * target.axes.width;
        let mut left = start + from..start + to + 1;
        while !left.is_empty() {
            let run = match &mut target.unhidden {
                Some(unhidden) => unhidden(self.index, left.clone(), target.object),
                None => left.clone(),
            };
            if run.is_empty() {
                return;
            }
            left.start = run.end;
            let columns = (run.start - start, run.end - 1 - start);
            let lanes = SpanLanes::new(simd, self, span_row);
            let mut buffers = RowBuffers {
                columns: &target.axes.columns,
                t: &mut target.t[start..],
                object: &mut target.object[start..],
                is_written: match &mut target.written {
                    Some(written) => written.row(row - target.rows.start),
                    None => &mut [],
                },
            };
            if target.has_vector_bounds {
                let (first, last) = columns;
                if last - first >= SHORT {
                    let numbers = (self.numerator[0], self.outline.b_column as f32, span_row);
                    let column = target.axes.columns[first];
                    target.bounds.find(simd, numbers, (column, last + 1 - first));
                } else {
                    target.bounds.clear();
                }
            }
            let own = (self.index, span_row.nearest, &target.bounds);
            let is_in_doubt = if self.outline.corrects_root {
                draw_row::<S, true>(simd, &mut buffers, columns, own, &lanes)
            } else {
                draw_row::<S, false>(simd, &mut buffers, columns, own, &lanes)
            };
            if is_in_doubt {
                self.find_doubts(simd, target, row, columns, span_row);
            }
        }
    }

    /// Adds to the pixels in doubt those of a row in which the sphere's hit and the known hit are too
    /// close to call.
    #[cold]
    #[inline(never)]
    fn find_doubts<S: Simd>(
        &self,
        simd: S,
        target: &mut SpanTarget,
        row: usize,
        (from, to): (usize, usize),
        span_row: &SpanRow,
    ) {
        let lanes = SpanLanes::new(simd, self, span_row);
        let start = (row - target.rows.start) * target.axes.width;
        for at in (from..=to).step_by(S::f32s::LEN) {
            // A function that is not inlined does not get the level's instructions automatically.
            let found = simd.vectorize(
                #[inline(always)]
                || {
                    let columns = &target.axes.columns[at..at + S::f32s::LEN];
                    let columns = S::f32s::from_slice(simd, columns);
                    lanes.t(columns, self.outline.corrects_root)
                },
            );
            for (column, &t) in (at..=to).zip(found.as_slice()) {
                let offset = start + column;
                let (known, object) = (target.t[offset], target.object[offset]);
                let is_apart = t < known * (1.0 - TIE) || t > known * (1.0 + TIE);
                if object != self.index && !is_apart {
                    let (row, column) = (row as u32, column as u32);
                    target.doubts.push(Doubt { index: self.index, row, column, t: Some(t) });
                    target.decided -= 1;
                }
            }
        }
    }

    /// Draws the pixels of a row that the sphere certainly covers, and adds to the pixels in doubt those
    /// that it may cover.
    #[cold]
    #[inline(never)]
    pub(crate) fn doubtful_row<S: Simd>(&self, simd: S, target: &mut SpanTarget, row: usize) {
        let Outline { column, shear, square, .. } = self.outline;
        let j = (target.axes.row_numbers[row] - self.outline.middle_row) - self.outline.row;
        let middle = column + shear * j;
        let squared = square[0] + (square[1] + square[2] * j) * j;
        let is_thin = squared < self.outline.thin;
        let half = if is_thin { (2.0 * self.outline.thin).sqrt() } else { squared.sqrt() };
        let (start, end) = (middle - half, middle + half);
        let (outer_first, outer_last) = ((start - MARGIN).ceil(), (end + MARGIN).floor());
        let (first, last) = match is_thin {
            true => (outer_last + 1.0, outer_last),
            false => ((start + MARGIN).ceil(), (end - MARGIN).floor()),
        };
        if first <= last
            && let Some(columns) = target.axes.columns_between(first, last)
        {
            let pivot = match (self.outline.corrects_root, self.outline.b_column > 0.0) {
                (true, false) => first,
                (true, true) => last,
                (false, _) => 0.5 * (first + last),
            };
            let b = self.outline.b0 + self.outline.b_row * j + self.outline.b_column * pivot;
            let (left, right) = (first - start, end - last);
            let span_row = SpanRow {
                first: first as f32,
                last: last as f32,
                left: left as f32,
                right: right as f32,
                b: two_parts(b),
                pivot: pivot as f32,
                offset: (left * right) as f32,
                nearest: self.outline.nearest as f32,
            };
            self.draw_row(simd, target, row, &span_row, columns);
        }
        let in_doubt = [
            (outer_first, first.min(outer_last + 1.0) - 1.0),
            (last.max(first - 1.0) + 1.0, outer_last),
        ];
        for (from, to) in in_doubt {
            let Some((from, to)) = target.axes.columns_between(from, to) else { continue };
            target.is_reached[row - target.rows.start] = true;
            target.doubt(self.index, row, from..to + 1);
        }
    }
}

/// Some rows of one sphere, one in each lane of a SIMD vector.
pub(crate) struct SpanRows {
    rows: SpanRow<Singles>,
    /// Index in the raster of each row's first column, as a floating-point number.
    from: [f64; MOST_LANES],
    /// Index in the raster of each row's last column, as a floating-point number.
    to: [f64; MOST_LANES],
    /// Mask of the rows that cover a column of the raster and in which every pixel is certainly inside
    /// or outside.
    pub(crate) is_drawn: u64,
    /// Mask of the rows in which some pixel is neither certainly inside nor certainly outside.
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
    /// Finds the sphere's part of each row in a SIMD vector of rows, which starts at the raster's row
    /// `base`.
    #[inline(always)]
    pub(crate) fn find<S: Simd>(simd: S, span: &Span, axes: &RasterAxes, base: usize) -> SpanRows {
        let splat = |x: f64| S::f64s::splat(simd, x);
        let Outline { column, middle_row, row, shear, square, square_doubt, .. } = span.outline;
        let Outline { b0, b_column, b_row, .. } = span.outline;
        let numbers = &axes.row_numbers[base..base + S::f64s::LEN];
        let j = (S::f64s::from_slice(simd, numbers) - splat(middle_row)) - splat(row);
        let middle = splat(column) + splat(shear) * j;
        let squared = splat(square[0]) + (splat(square[1]) + splat(square[2]) * j) * j;
        let ends = RowEnds::<S>::new(simd, middle, squared, splat(span.outline.thin));
        let RowEnds { start, end, first, last, is_sure } = ends;
        let (from, to, is_there) = axes.clip(simd, first, last);
        let corrects_root = span.outline.corrects_root;
        let pivot = match (corrects_root, b_column > 0.0) {
            (true, false) => first,
            (true, true) => last,
            (false, _) => splat(0.5) * (first + last),
        };
        let b = splat(b0) + splat(b_row) * j + splat(b_column) * pivot;
        let high = b.narrow(b);
        let (left, right) = (first - start, end - last);
        let offset =
            if corrects_root { store_narrow::<S>(left * right) } else { [0.0; 2 * MOST_LANES] };
        // Within the row `b <= b(pivot) + |b_column| 2 w` and `S <= w`.
        let half = (end - start) * splat(0.5);
        let most = b + half * splat(1.0 + 2.0 * b_column.abs());
        let nearest = splat(span.outline.numerator * (1.0 - 1e-6)) / most;
        let nearest = nearest.max(splat(span.outline.nearest));
        let is_doubtful =
            squared.simd_ge(splat(-square_doubt)).to_bitmask() & !is_sure.to_bitmask();
        let rows = SpanRow {
            first: store_narrow::<S>(first),
            last: store_narrow::<S>(last),
            left: store_narrow::<S>(left),
            right: store_narrow::<S>(right),
            b: [store_narrow::<S>(b), store_narrow::<S>(b - high.widen().0)],
            pivot: store_narrow::<S>(pivot),
            offset,
            nearest: store_narrow::<S>(nearest),
        };
        SpanRows {
            rows,
            from: store::<S>(from),
            to: store::<S>(to),
            is_drawn: is_sure.to_bitmask() & is_there,
            is_doubtful,
        }
    }

    /// Returns one of the rows.
    #[inline(always)]
    pub(crate) fn row(&self, lane: usize) -> SpanRow {
        self.rows.map(|x| x[lane])
    }

    /// Returns a row's first and last column in the raster.
    #[inline(always)]
    pub(crate) fn columns(&self, lane: usize) -> (usize, usize) {
        // Converts through i32, which takes one instruction.
        (self.from[lane] as i32 as usize, self.to[lane] as i32 as usize)
    }
}

/// The ends of a SIMD vector of rows, computed from the square of half of each row's width, `w^2`, and
/// the column of its middle; see [`Outline`].
pub(crate) struct RowEnds<S: Simd> {
    /// The outline's left end.
    pub(crate) start: S::f64s,
    /// The outline's right end.
    pub(crate) end: S::f64s,
    /// First column inside the ends by at least the margin.
    pub(crate) first: S::f64s,
    /// Last column inside the ends by at least the margin.
    pub(crate) last: S::f64s,
    /// Mask of the rows that are not [thin](Outline::thin) and have no column within the margin of an
    /// end.
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

/// The values that the pixels of one row of a sphere share; for b and S, see [`Outline`]. Column numbers
/// are whole, so that their differences are exact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpanRow<T = f32> {
    /// First column that the sphere covers, even beyond the image.
    pub(crate) first: T,
    /// Last column that the sphere covers, even beyond the image.
    pub(crate) last: T,
    /// Distance from the outline's left end to the first column, in columns.
    pub(crate) left: T,
    /// Distance from the last column to the outline's right end, in columns.
    pub(crate) right: T,
    /// b at the pivot, in two parts.
    pub(crate) b: [T; 2],
    /// The column at which b is given: the middle of the row or, if [`Outline::corrects_root`] is
    /// true, the end at which b is larger.
    pub(crate) pivot: T,
    /// The product `left right`, used only if [`Outline::corrects_root`] is true.
    pub(crate) offset: T,
    /// Lower bound of `t` of all hits.
    pub(crate) nearest: T,
}

impl<T> SpanRow<T> {
    /// Converts each of the values.
    #[inline(always)]
    fn map<U>(&self, convert: impl Fn(&T) -> U) -> SpanRow<U> {
        SpanRow {
            first: convert(&self.first),
            last: convert(&self.last),
            left: convert(&self.left),
            right: convert(&self.right),
            b: [convert(&self.b[0]), convert(&self.b[1])],
            pivot: convert(&self.pivot),
            offset: convert(&self.offset),
            nearest: convert(&self.nearest),
        }
    }
}

/// The values of a [`Span`] and a [`SpanRow`], each copied to all lanes of a SIMD vector.
#[derive(Clone, Copy)]
pub(crate) struct SpanLanes<S: Simd> {
    row: SpanRow<SingleLanes<S>>,
    numerator: [SingleLanes<S>; 2],
    b_column: [SingleLanes<S>; 2],
}

impl<S: Simd> SpanLanes<S> {
    #[inline(always)]
    pub(crate) fn new(simd: S, span: &Span, row: &SpanRow) -> Self {
        let splat = |x| SingleLanes::splat(simd, x);
        SpanLanes {
            row: row.map(|x| splat(*x)),
            numerator: span.numerator.map(splat),
            b_column: span.b_column.map(splat),
        }
    }

    /// Computes `t` in some columns: by [`SpanLanes::wide`] if the rounding error of the root S is to
    /// be corrected, otherwise by [`SpanLanes::narrow`].
    #[inline(always)]
    pub(crate) fn t(&self, columns: S::f32s, corrects_root: bool) -> S::f32s {
        if corrects_root { self.wide(columns).0 } else { self.narrow(columns).0 }
    }

    /// Computes `t = numerator / (b + S)` (see [`Outline`]) in each column c, within an ulp, for a
    /// sphere whose root S is small compared with b. With the ends of the row, `start = first - left`
    /// and `end = last + right`, and the value b_pivot of b at the column `pivot`,
    /// `S^2 = (c - start) (end - c)` and `b = b_pivot + b_column (c - pivot)`.
    ///
    /// The errors, with `u = 2^-24`, are:
    ///
    /// - Each factor of `S^2` is off by 2 u of itself: by the rounding of `left` or `right`, and by
    ///   that of the sum `(c - first) + left` or `(last - c) + right`. Their product is rounded by u
    ///   more. So S is off by `5/2 u` of itself, and by u for its own rounding.
    /// - The varying part of b, `b - b_pivot`, is off by 3 u of itself.
    /// - The sum of S and `b - b_pivot` is rounded by u. Together with the errors above, this makes
    ///   at most `(4.5 S + 4 |b - b_pivot|) u`. `Kinds::new` in `render/outline` chooses this kernel
    ///   only where that is at most 0.42 u of the denominator `b + S`.
    /// - The error of the outline's `w^2` moves S by at most `2^-28` of b, as `Outlines::find`
    ///   derives, which adds u / 16.
    ///
    /// All this is less than 0.49 u of the denominator, which leaves room for terms of second order
    /// below half an ulp of t. The last rounding adds another half, so t is within an ulp;
    /// `tests/ladder.rs` checks it against the reference. The last sum of the denominator, that of
    /// `row.b[0]`, the first part of b_pivot, and all other terms, adds no error: the quotient is
    /// corrected by the rounding error of this sum and by its own residual.
    #[inline(always)]
    fn narrow(&self, columns: S::f32s) -> SingleLanes<S> {
        let columns = SingleLanes(columns);
        let (from_first, to_last) = (columns - self.row.first, self.row.last - columns);
        let square = (from_first + self.row.left) * (to_last + self.row.right);
        let root = square.sqrt();
        let moved = (columns - self.row.pivot) * self.b_column[0] + self.row.b[1];
        let added = moved + root;
        let sum = self.row.b[0] + added;
        let rest = added - (sum - self.row.b[0]);
        let one = SingleLanes(S::f32s::splat(columns.0.token(), 1.0));
        let reciprocal = one / sum;
        let quotient = self.numerator[0] * reciprocal;
        let residual = self.numerator[0].residual(quotient, sum) + self.numerator[1];
        quotient + (residual - quotient * rest) * reciprocal
    }

    /// Computes `t` like [`SpanLanes::narrow`], for a sphere whose root S is not small compared with
    /// b. For a pixel in column c, let `m = c - first` and `n = last - c`. Then
    ///
    /// ```text
    /// S^2 = (m + left) (n + right) = m n + (m right + (n left + left right))
    /// ```
    ///
    /// in which nothing cancels, and whose first term is exact, since `m + n < 2^12`. The computed
    /// root of `S^2` is corrected by `(S^2 - root^2) / (2 root)`. With the computed `sum = b + root`,
    /// one reciprocal `i = 1 / (root sum)` serves both quotients, since `1 / sum = i root` and
    /// `1 / root = i sum` are right to 3 u, with `u = 2^-24`, and what they multiply is small.
    ///
    /// Two errors remain:
    ///
    /// - The second term of `S^2`, in parentheses, is rounded by 4 u of itself. It is at most
    ///   `2 w + 1`, with w half the width of the row, so S is off by less than `2 sqrt(2 w + 1) u`.
    /// - The quotient is corrected by the first and second powers of `rest / sum`, but not by the
    ///   third, where `rest` is the error of the computed sum. It is at most `2^-12` of the variation
    ///   of b, which is less than four times the sum.
    ///
    /// The rounding error of the sum of `row.b[0]` and the change of b from the pivot is found
    /// exactly: the pivot is the end at which b is larger, so b only decreases from there (Dekker,
    /// Numerische Mathematik 18, 1971).
    #[inline(always)]
    fn wide(&self, columns: S::f32s) -> SingleLanes<S> {
        let columns = SingleLanes(columns);
        let (from_first, to_last) = (columns - self.row.first, self.row.last - columns);
        let whole = from_first * to_last;
        let part = from_first * self.row.right + (to_last * self.row.left + self.row.offset);
        let square = whole + part;
        let square_rest = part - (square - whole);
        let root = square.sqrt();
        let root_residual = square.residual(root, root) + square_rest;

        // Exact: the product of two 12-bit numbers.
        let from_pivot = columns - self.row.pivot;
        let moved = from_pivot * self.b_column[0];
        let b = self.row.b[0] + moved;
        let b_low = self.row.b[1] + from_pivot * self.b_column[1];
        let b_rest = (moved - (b - self.row.b[0])) + b_low;
        let sum = b + root;
        let sum_rest = root - (sum - b);

        let one = SingleLanes(S::f32s::splat(columns.0.token(), 1.0));
        let inverse = one / (root * sum);
        let reciprocal = inverse * root;
        let root_rest = root_residual * (inverse * sum).half();
        let rest = (b_rest + sum_rest) + root_rest;
        let quotient = self.numerator[0] * reciprocal;
        let residual = self.numerator[0].residual(quotient, sum) + self.numerator[1];
        let share = rest * reciprocal;
        quotient + (residual * reciprocal - quotient * (share - share * share))
    }
}
