//! Draws spheres that are small compared with their distance. Each step finds one row of every sphere in
//! a SIMD vector of spheres; the rows are then drawn several pixels at a time.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, u32x8};

use crate::exact::lanes::lanes_of;
use crate::render::outline::raster_axes::RasterAxes;
use crate::render::outline::small_outlines::{Halves, Singles, SmallOutlines};
use crate::render::outline::{MARGIN, MOST_SINGLE_LANES};
use crate::render::rows::TIE;
use crate::render::rows::span::{Doubt, SpanTarget};

/// Number of pixels drawn at once.
const PIXELS: usize = 8;

/// Maximum number of rows that are found before they are drawn: the number of bits in a mask.
const RUNS: usize = 64;

/// The rows of the target that the spheres of a SIMD vector cover. The spheres are drawn in steps of one
/// row each. If the raster has no gaps, each sphere's steps start at its own first row; otherwise all
/// start at the first row that any of the spheres covers.
struct OwnRows {
    /// Number of the first row.
    first: Singles,
    /// Number of the last row.
    last: Singles,
    /// The row of the target at which each sphere's steps start.
    row: [i32; MOST_SINGLE_LANES],
    /// The first pixel of that row, in the target's buffers.
    offset: [i32; MOST_SINGLE_LANES],
    /// Number of steps.
    steps: usize,
}

/// One row of each sphere of a SIMD vector, the same step for all (see [`OwnRows`]).
struct RowStep<S: Simd> {
    number: S::f32s,
    /// First pixel of the row in the target.
    offset: S::i32s,
    /// Lanes whose spheres cover this row.
    is_here: <S::f32s as SimdBase<S>>::Mask,
}

/// Rows of small spheres: the first row of each sphere, lane by lane, then the second row of each, and
/// so on. Columns are counted from the first one that the sphere covers, which may lie outside the
/// raster.
pub(crate) struct Runs {
    /// The first column, as a column number of the image.
    first: [f32; RUNS],
    /// The first column that lies in the raster.
    from: [f32; RUNS],
    /// The last column that lies in the raster.
    to: [f32; RUNS],
    /// The last column that the sphere covers.
    last: [f32; RUNS],
    /// Distance of the first column from the outline's left end.
    left: [f32; RUNS],
    /// Distance of the last column from the outline's right end.
    right: [f32; RUNS],
    /// The part of e that does not depend on S, at the first column; see [`SmallOutlines`].
    moved: [f32; RUNS],
    /// The first pixel in the target.
    offset: [i32; RUNS],
    /// The number of pixels.
    count: [i32; RUNS],
    /// Pairs of a sphere's lane and a row of the raster in which it is too close to call whether the
    /// sphere covers some pixel.
    pub(crate) doubtful: Vec<(usize, usize)>,
}

/// Draws those spheres of a SIMD vector whose bits are set in `small`; each must have a row in the
/// target. A row is not drawn, but listed in [`Runs::doubtful`], if it is too close to call whether the
/// sphere covers some pixel of it.
#[inline(always)]
pub(crate) fn draw_small<S: Simd>(
    simd: S,
    outlines: &SmallOutlines,
    small: u64,
    ids: &[u32],
    runs: &mut Runs,
    target: &mut SpanTarget,
) {
    let n = S::f32s::LEN;
    let own = OwnRows::new(simd, outlines, small, target);
    for first in (0..own.steps).step_by(RUNS / n) {
        let mut is_drawn = 0;
        for depth in 0..(RUNS / n).min(own.steps - first) {
            let step = first + depth;
            let rows = own.step(simd, step, target);
            let (drawn, doubtful) = runs.find(simd, outlines, &rows, depth * n, target.axes);
            is_drawn |= (small & drawn) << (depth * n);
            for lane in lanes_of(small & doubtful) {
                let row = target.rows.start + own.row[lane] as usize + step;
                runs.doubtful.push((lane, row));
            }
        }
        simd.vectorize(
            #[inline(always)]
            || runs.draw(simd, is_drawn, (outlines, ids), target),
        );
    }
}

impl OwnRows {
    #[inline(always)]
    fn new<S: Simd>(
        simd: S,
        outlines: &SmallOutlines,
        small: u64,
        target: &mut SpanTarget,
    ) -> OwnRows {
        let n = S::f32s::LEN;
        let splat = |x: f32| S::f32s::splat(simd, x);
        let load = |x: &Singles| S::f32s::from_slice(simd, &x[..n]);
        let numbers = &target.axes.row_numbers;
        let above = splat(numbers[target.rows.start] as f32);
        let below = splat(numbers[target.rows.end - 1] as f32);
        let (first, last) =
            (load(&outlines.first_row).max(above), load(&outlines.last_row).min(below));
        let mut own = OwnRows {
            first: [0.0; MOST_SINGLE_LANES],
            last: [0.0; MOST_SINGLE_LANES],
            row: [0; MOST_SINGLE_LANES],
            offset: [0; MOST_SINGLE_LANES],
            steps: 0,
        };
        first.store_slice(&mut own.first[..n]);
        last.store_slice(&mut own.last[..n]);
        let row = S::i32s::truncate_from(first - above);
        let width = S::i32s::splat(simd, target.axes.width as i32);
        row.store_slice(&mut own.row[..n]);
        (row * width).store_slice(&mut own.offset[..n]);
        if target.axes.are_whole() {
            for lane in lanes_of(small) {
                own.steps = own.steps.max(own.count(lane));
            }
            if !target.is_all_reached {
                for lane in lanes_of(small) {
                    let first = own.row[lane] as usize;
                    target.reach(first..first + own.count(lane));
                }
            }
        } else {
            own.begin_at_first_of_all(small, target);
        }
        own
    }

    /// Returns the number of a sphere's rows in the target, for a raster without gaps.
    #[inline(always)]
    fn count(&self, lane: usize) -> usize {
        // Converts through i32, which takes one instruction.
        (self.last[lane] - self.first[lane]) as i32 as usize + 1
    }

    /// Makes all steps start at the first row of the target that any of these spheres covers.
    #[cold]
    #[inline(never)]
    fn begin_at_first_of_all(&mut self, small: u64, target: &mut SpanTarget) {
        let mut all = target.rows.end..target.rows.start;
        for lane in lanes_of(small) {
            let [first, last] = [self.first[lane], self.last[lane]].map(f64::from);
            let own = target.axes.rows_between(first, last);
            if !own.is_empty() {
                target.reach(own.start - target.rows.start..own.end - target.rows.start);
                all = all.start.min(own.start)..all.end.max(own.end);
            }
        }
        self.steps = all.len();
        let first = all.start - target.rows.start;
        self.row.fill(first as i32);
        self.offset.fill((first * target.axes.width) as i32);
    }

    #[inline(always)]
    fn step<S: Simd>(&self, simd: S, step: usize, target: &SpanTarget) -> RowStep<S> {
        let n = S::f32s::LEN;
        let load = |x: &Singles| S::f32s::from_slice(simd, &x[..n]);
        let (first, last) = (load(&self.first), load(&self.last));
        let number = if target.axes.are_whole() {
            first + S::f32s::splat(simd, step as f32)
        } else {
            let row = target.rows.start + self.row[0] as usize + step;
            S::f32s::splat(simd, target.axes.row_numbers[row] as f32)
        };
        let to_step = S::i32s::splat(simd, (step * target.axes.width) as i32);
        RowStep {
            number,
            offset: S::i32s::from_slice(simd, &self.offset[..n]) + to_step,
            is_here: number.simd_ge(first) & number.simd_le(last),
        }
    }
}

/// The ends of one row of each small sphere, for one half of a SIMD vector of spheres (as many as it has
/// `f64` lanes).
struct SmallRowEnds<S: Simd> {
    first: S::f64s,
    last: S::f64s,
    left: S::f64s,
    right: S::f64s,
    /// The part of e that does not depend on S (see [`SmallOutlines`]), at the first column.
    moved: S::f64s,
    is_thick: <S::f64s as SimdBase<S>>::Mask,
}

impl<S: Simd> SmallRowEnds<S> {
    #[inline(always)]
    fn new(simd: S, outlines: &SmallOutlines, half: usize, j: S::f64s) -> Self {
        let SmallOutlines { column, middle, shear, square, thin, slope, row_slope, .. } = outlines;
        let splat = |x: f64| S::f64s::splat(simd, x);
        let load = |x: &Halves| S::f64s::from_slice(simd, &x[half][..S::f64s::LEN]);
        let middle = load(middle) + load(shear) * j;
        let squared = load(&square[0]) + (load(&square[1]) + load(&square[2]) * j) * j;
        let reach = squared.max(splat(0.0)).sqrt();
        let (start, end) = (middle - reach, middle + reach);
        let (first, last) = (start.ceil(), end.floor());
        let (left, right) = (first - start, end - last);
        let moved = (first - load(column)) * load(slope) + j * load(row_slope);
        SmallRowEnds { first, last, left, right, moved, is_thick: squared.simd_ge(load(thin)) }
    }
}

impl Runs {
    pub(crate) fn new() -> Runs {
        let singles = [0.0; RUNS];
        Runs {
            first: singles,
            from: singles,
            to: singles,
            last: singles,
            left: singles,
            right: singles,
            moved: singles,
            offset: [0; RUNS],
            count: [0; RUNS],
            doubtful: Vec::new(),
        }
    }

    /// Finds where each sphere's row of this step begins and ends, and stores the rows from position
    /// `at` on. Returns two masks: the spheres whose row is to be drawn, and those with a pixel in their
    /// row that is too close to call.
    #[inline(always)]
    fn find<S: Simd>(
        &mut self,
        simd: S,
        outlines: &SmallOutlines,
        rows: &RowStep<S>,
        at: usize,
        axes: &RasterAxes,
    ) -> (u64, u64) {
        let half = S::f64s::LEN;
        let middle = S::f64s::splat(simd, outlines.middle_row);
        let row =
            |half_number: usize| S::f64s::from_slice(simd, &outlines.row[half_number][..half]);
        let (low_number, high_number) = rows.number.widen();
        let (low_j, high_j) = ((low_number - middle) - row(0), (high_number - middle) - row(1));
        let low = SmallRowEnds::<S>::new(simd, outlines, 0, low_j);
        let high = SmallRowEnds::<S>::new(simd, outlines, 1, high_j);
        let (first, last) = (low.first.narrow(high.first), low.last.narrow(high.last));
        let (left, right) = (low.left.narrow(high.left), low.right.narrow(high.right));
        let moved = low.moved.narrow(high.moved);
        let is_thick = low.is_thick.narrow(high.is_thick);

        let n = S::f32s::LEN;
        let splat = |x: f32| S::f32s::splat(simd, x);
        let margin = MARGIN as f32;
        let is_sure = is_thick
            & left.min(right).simd_ge(splat(margin))
            & left.max(right).simd_le(splat(1.0 - margin));
        let (from, to, index, is_there) = axes.clip_singles(simd, first, last);
        let runs = at..at + n;
        first.store_slice(&mut self.first[runs.clone()]);
        (from - first).store_slice(&mut self.from[runs.clone()]);
        (to - first).store_slice(&mut self.to[runs.clone()]);
        (last - first).store_slice(&mut self.last[runs.clone()]);
        left.store_slice(&mut self.left[runs.clone()]);
        right.store_slice(&mut self.right[runs.clone()]);
        moved.store_slice(&mut self.moved[runs.clone()]);
        let [begin, end] = index;
        (rows.offset + begin).store_slice(&mut self.offset[runs.clone()]);
        ((end - begin) + S::i32s::splat(simd, 1)).store_slice(&mut self.count[runs]);
        let (is_drawn, is_doubtful) = (rows.is_here & is_sure, rows.is_here & !is_sure);
        (is_drawn.to_bitmask() & is_there, is_doubtful.to_bitmask())
    }

    /// Computes `t = Q / (1 + e) = Q_high + (Q_low - Q_high e) / (1 + e)`, with Q, e and S of
    /// [`SmallOutlines`], for columns counted from the row's first one.
    ///
    /// Error bound: with `u = 2^-24`, let R be the largest `inverse S`, V the largest absolute value of
    /// the rest of e, of its two terms and of their sum, and v the change of the rest of e along half a
    /// row. Each factor of `S^2` is off by `4/3 u` (u for the sum, `1/3 u` for left or right) and their
    /// product by u more, the product with `inverse^2` by 2 u, so the root by `2.84 u` and its own
    /// rounding: by `3.84 u` of R. `moved` is rounded from `f64`, by u of V; the change along the row, 2
    /// v at most, is off by 2 u of itself; the sum of `moved` and the change is rounded by u of V, and
    /// the sum with the root by u of `R + V`. So e is off by `(4.84 R + 3 V + 4 v) u`, and t, as
    /// `|e| < 1/17`, by 1.13 times that. The roundings of `Q_high e`, of the difference, of `1 + e` and
    /// of the quotient are 4 u of 1.07 |e|. Together: `(9.8 R + 7.8 V + 4.6 v) u`. [`SmallOutlines`]
    /// keep the sum of that and `0.07 u`, for the errors of `S^2` itself and of Q, below `0.5 u`: with
    /// the last rounding, t is within an ulp.
    #[inline(always)]
    fn t<S: Simd>(
        &self,
        simd: S,
        run: usize,
        (spheres, lane): (&SmallOutlines, usize),
        columns: f32x8<S>,
    ) -> f32x8<S> {
        let splat = |x: f32| f32x8::splat(simd, x);
        let to_last = splat(self.last[run]) - columns;
        let square = (columns + splat(self.left[run])) * (to_last + splat(self.right[run]));
        let added = columns * splat(spheres.rounded_slope[lane]) + splat(self.moved[run]);
        let e = added + (square * splat(spheres.inverse_squared[lane])).sqrt();
        let [high, low] = spheres.quotient.each_ref().map(|part| splat(part[lane]));
        high + (low - high * e) / (splat(1.0) + e)
    }

    /// Writes the pixels that are nearer than the known hits, in the rows whose bits are set.
    #[inline(always)]
    fn draw<S: Simd>(
        &self,
        simd: S,
        is_drawn: u64,
        (spheres, ids): (&SmallOutlines, &[u32]),
        target: &mut SpanTarget,
    ) {
        const FIRST: [f32; PIXELS] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];
        let first = f32x8::from_slice(simd, &FIRST);
        let mut decided = 0;
        let are_whole = target.axes.are_whole();
        for run in lanes_of(is_drawn) {
            let lane = run % S::f32s::LEN;
            let index = ids[lane];
            let (mut offset, count) = (self.offset[run] as usize, self.count[run] as usize);
            decided += count;
            let mut columns = first + f32x8::splat(simd, self.from[run]);
            let end = offset + count;
            loop {
                if !are_whole {
                    let column = offset % target.axes.width;
                    let numbers = &target.axes.columns[column..column + PIXELS];
                    columns =
                        f32x8::from_slice(simd, numbers) - f32x8::splat(simd, self.first[run]);
                }
                let found = self.t(simd, run, (spheres, lane), columns);
                let is_inside = columns.simd_le(f32x8::splat(simd, self.to[run]));
                let vector = offset..offset + PIXELS;
                let doubtful = if vector.end <= target.t.len() {
                    let (t, object) = (&mut target.t[vector.clone()], &mut target.object[vector]);
                    take_over(simd, (found, is_inside), index, t, object)
                } else {
                    let (t, object) = (&mut target.t[offset..end], &mut target.object[offset..end]);
                    take_over_last(&found.into(), index, t, object)
                };
                if doubtful != 0 {
                    decided -= note_ties(target, (offset, doubtful), found.into(), index);
                }
                offset += PIXELS;
                if offset >= end {
                    break;
                }
                columns += f32x8::splat(simd, PIXELS as f32);
            }
        }
        target.decided += decided as u64;
    }
}

/// Writes the pixels where the sphere is nearer than the known hit; returns a mask of those too close to
/// call.
#[inline(always)]
fn take_over<S: Simd>(
    simd: S,
    (found, is_inside): (f32x8<S>, <f32x8<S> as SimdBase<S>>::Mask),
    index: u32,
    t: &mut [f32],
    object: &mut [u32],
) -> u64 {
    let known = f32x8::from_slice(simd, t);
    let is_nearer = is_inside & found.simd_lt(known * f32x8::splat(simd, 1.0 - TIE));
    // Selecting between the new and the stored value would compile to a masked store, which is slow on
    // many processors.
    is_nearer.select(found, f32x8::splat(simd, f32::INFINITY)).min(known).store_slice(t);
    let objects = u32x8::from_slice(simd, object);
    let change = u32x8::splat(simd, index) ^ objects;
    (objects ^ is_nearer.select(change, u32x8::splat(simd, 0))).store_slice(object);
    let is_farther = found.simd_gt(known * f32x8::splat(simd, 1.0 + TIE));
    (is_inside & !(is_nearer | is_farther)).to_bitmask()
}

/// Writes like [`take_over`], for the last pixels of the buffers, which do not fill a vector.
#[cold]
#[inline(never)]
fn take_over_last(found: &[f32; PIXELS], index: u32, t: &mut [f32], object: &mut [u32]) -> u64 {
    let mut doubtful = 0;
    for (lane, (found, (t, object))) in found.iter().zip(t.iter_mut().zip(object)).enumerate() {
        if *found < *t * (1.0 - TIE) {
            (*t, *object) = (*found, index);
        } else if *found <= *t * (1.0 + TIE) {
            doubtful |= 1 << lane;
        }
    }
    doubtful
}

/// Adds to the pixels in doubt those whose bits are set in `doubtful`, where bit 0 stands for the pixel
/// at `offset`. In these pixels, the sphere's hit and the known hit are too close to call. Returns the
/// number of pixels added, whose decisions the ladder counts.
#[cold]
#[inline(never)]
fn note_ties(
    target: &mut SpanTarget,
    (offset, doubtful): (usize, u64),
    found: [f32; PIXELS],
    index: u32,
) -> usize {
    let width = target.axes.width;
    for lane in lanes_of(doubtful) {
        let offset = offset + lane;
        let (row, column) = (target.rows.start + offset / width, offset % width);
        let (row, column) = (row as u32, column as u32);
        target.doubts.push(Doubt { index, row, column, t: Some(found[lane]) });
    }
    doubtful.count_ones() as usize
}
