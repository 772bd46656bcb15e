//! Spheres drawn row by row: which columns each row covers, decided once with a margin, and `t`
//! inside them.

use std::ops::Range;

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::render::bvh::draw::lanes_of;
use crate::render::outline::Outlines;
use crate::render::outline::raster_axes::RasterAxes;
use crate::render::rows::span_kernel::{
    Narrow, RowBuffers, SpanLanes, SpanRow, SpanShape, TIE, Wide, draw_row,
};
use crate::render::rows::span_rows::SpanRows;
use crate::scene::sphere::Sphere;

/// How far from an outline's end a pixel is beyond doubt, in columns: far more than the end is off
/// by, and so little that hardly a pixel lies within it.
pub(crate) const MARGIN: f64 = 1.0 / 131_072.0;

/// One sphere's outline, see [`Outlines`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outline {
    pub(crate) column: f64,
    pub(crate) row: f64,
    pub(crate) shear: f64,
    pub(crate) square: [f64; 3],
    pub(crate) b0: f64,
    pub(crate) b_column: f64,
    pub(crate) b_row: f64,
    pub(crate) numerator: f64,
    pub(crate) square_doubt: f64,
    pub(crate) first_row: f64,
    pub(crate) last_row: f64,
    pub(crate) nearest: f64,
    pub(crate) thin: f64,
    pub(crate) is_wide: bool,
}

impl Outlines {
    /// One lane.
    #[inline(always)]
    pub(crate) fn one(&self, lane: usize) -> Outline {
        Outline {
            column: self.column[lane],
            row: self.row[lane],
            shear: self.shear[lane],
            square: self.square.map(|x| x[lane]),
            b0: self.b0[lane],
            b_column: self.b_column[lane],
            b_row: self.b_row[lane],
            numerator: self.numerator[lane],
            square_doubt: self.square_doubt[lane],
            first_row: self.first_row[lane],
            last_row: self.last_row[lane],
            nearest: self.nearest[lane],
            thin: self.thin[lane],
            is_wide: self.is_wide >> lane & 1 == 1,
        }
    }
}

/// A sphere that can be drawn by rows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    pub(crate) index: u32,
    pub(crate) outline: Outline,
    pub(crate) shape: SpanShape,
}

/// A pixel that a sphere's row could not decide: whether the sphere covers it at all, or, where its
/// `t` is known, whether it is nearer than another.
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
        let Outline { b_column, numerator, is_wide, .. } = *outline;
        let b_column = if is_wide {
            let high = rounded_to_12_bits(b_column as f32);
            [high, (b_column - f64::from(high)) as f32]
        } else {
            two_parts(b_column)
        };
        let shape = SpanShape { numerator: two_parts(numerator), b_column, is_wide };
        Span { index, outline: *outline, shape }
    }

    /// The part of the raster's rows that it can cover.
    #[inline(always)]
    pub(crate) fn rows(&self, axes: &RasterAxes) -> Range<usize> {
        axes.rows_between(self.outline.first_row, self.outline.last_row)
    }
}

/// The nearest number of 12 bits.
#[inline(always)]
fn rounded_to_12_bits(x: f32) -> f32 {
    let shifted = x * 4097.0;
    shifted - (shifted - x)
}

/// A number as a sum of two `f32`.
#[inline(always)]
fn two_parts(x: f64) -> [f32; 2] {
    let high = x as f32;
    [high, (x - f64::from(high)) as f32]
}

/// Where spans are drawn: some rows of the raster.
pub(crate) struct SpanTarget<'a> {
    pub(crate) axes: &'a RasterAxes,
    pub(crate) rows: Range<usize>,
    pub(crate) t: &'a mut [f32],
    pub(crate) object: &'a mut [u32],
    pub(crate) doubts: &'a mut Vec<Doubt>,
    /// The scene's spheres.
    pub(crate) spheres: &'a [Sphere],
    /// By row of the target, whether an outline reaches it.
    pub(crate) is_reached: &'a mut [bool],
    /// How many pixels were decided.
    pub(crate) decided: u64,
}

impl SpanTarget<'_> {
    /// Whether the sphere is the one that the pixel shows, given twice: then the one that is listed
    /// first is shown, and nothing is in doubt.
    pub(crate) fn is_same_as_known(&mut self, place: usize, index: u32) -> bool {
        let known = self.object[place];
        let is_same = self.spheres.get(known as usize) == Some(&self.spheres[index as usize]);
        if is_same {
            self.object[place] = known.min(index);
        }
        is_same
    }

    /// Whether so many pixels are in doubt that they should be settled before more are drawn.
    pub(crate) fn is_full(&self) -> bool {
        const FULL: usize = 1 << 16;
        self.doubts.len() >= FULL
    }
}

impl Span {
    /// Draws the rows that it has in the target.
    #[inline(always)]
    pub(crate) fn draw<S: Simd>(&self, simd: S, target: &mut SpanTarget) {
        let own = self.rows(target.axes);
        let rows = own.start.max(target.rows.start)..own.end.min(target.rows.end);
        let mut base = rows.start;
        while base < rows.end {
            let ends = SpanRows::find::<S>(simd, self, target.axes, base);
            let there = u64::MAX >> (64 - S::f64s::LEN.min(rows.end - base));
            for lane in lanes_of(ends.is_drawn & there) {
                let (row, columns) = (base + lane, ends.columns(lane));
                if self.draw_row(simd, target, row, &ends.row(lane), columns) {
                    self.find_doubts(simd, target, row, columns, &ends.row(lane));
                }
            }
            for lane in lanes_of(ends.is_doubtful & there) {
                self.doubtful_row(simd, target, base + lane);
            }
            base += S::f64s::LEN;
        }
    }

    /// Draws a row from one column of the raster to another; tells whether a pixel is too close to
    /// what is there.
    #[inline(always)]
    fn draw_row<S: Simd>(
        &self,
        simd: S,
        target: &mut SpanTarget,
        row: usize,
        span_row: &SpanRow,
        columns: (usize, usize),
    ) -> bool {
        let lanes = SpanLanes::new(simd, &self.shape, span_row);
        let start = (row - target.rows.start) * target.axes.width();
        let mut buffers = RowBuffers {
            columns: &target.axes.columns,
            t: &mut target.t[start..],
            object: &mut target.object[start..],
        };
        let own = (self.index, self.outline.nearest as f32);
        target.decided += (columns.1 - columns.0 + 1) as u64;
        target.is_reached[row - target.rows.start] = true;
        if self.shape.is_wide {
            draw_row::<S>(simd, &mut buffers, columns, own, &Wide(&lanes))
        } else {
            draw_row::<S>(simd, &mut buffers, columns, own, &Narrow(&lanes))
        }
    }

    /// Notes which pixels of a row are too close to what is there.
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
        let lanes = SpanLanes::new(simd, &self.shape, span_row);
        let start = (row - target.rows.start) * target.axes.width();
        for at in (from..=to).step_by(S::f32s::LEN) {
            let columns = S::f32s::from_slice(simd, &target.axes.columns[at..at + S::f32s::LEN]);
            let found =
                if self.shape.is_wide { lanes.wide(columns) } else { lanes.narrow(columns) };
            let found = found.0;
            for (column, &t) in (at..=to).zip(found.as_slice()) {
                let place = start + column;
                let (known, object) = (target.t[place], target.object[place]);
                let is_apart = t < known * (1.0 - TIE) || t > known * (1.0 + TIE);
                if object != self.index && !is_apart && !target.is_same_as_known(place, self.index)
                {
                    let (row, column) = (row as u32, column as u32);
                    target.doubts.push(Doubt { index: self.index, row, column, t: Some(t) });
                    target.decided -= 1;
                }
            }
        }
    }

    /// A row of which not all pixels are beyond doubt: those that are get drawn, the others noted.
    #[cold]
    #[inline(never)]
    fn doubtful_row<S: Simd>(&self, simd: S, target: &mut SpanTarget, row: usize) {
        let Outline { column, row: center, shear, square, .. } = self.outline;
        let j = target.axes.row_numbers[row] - center;
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
            let pivot = if self.shape.is_wide { first } else { 0.5 * (first + last) };
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
            };
            if self.draw_row(simd, target, row, &span_row, columns) {
                self.find_doubts(simd, target, row, columns, &span_row);
            }
        }
        let in_doubt = [
            (outer_first, first.min(outer_last + 1.0) - 1.0),
            (last.max(first - 1.0) + 1.0, outer_last),
        ];
        for (from, to) in in_doubt {
            let Some((from, to)) = target.axes.columns_between(from, to) else { continue };
            target.is_reached[row - target.rows.start] = true;
            for column in from..=to {
                let (row, column) = (row as u32, column as u32);
                target.doubts.push(Doubt { index: self.index, row, column, t: None });
            }
        }
    }
}
