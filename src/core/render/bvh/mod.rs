//! Draws many spheres by means of the sphere index: visits its visible groups and blocks (two levels of
//! boxes around nearby spheres) near to far, and skips spheres that nearer ones hide.

use std::ops::Range;

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::exact::lanes::lanes_of;
use crate::render::bvh::occlusion::{Occlusion, strips};
use crate::render::bvh::visible::{VisibleBox, VisibleSpheres};
use crate::render::outline::small_outlines::SmallOutlines;
use crate::render::outline::{Outline, Outlines};
use crate::render::rows::small_spheres::{Runs, draw_small};
use crate::render::rows::span::{Span, SpanTarget};
use crate::scene::sphere_index::{NO_SPHERE, SphereIndex, SphereSlots};

pub(crate) mod occlusion;
pub(crate) mod visible;

/// The outcome of drawing many spheres into a band of rows, besides its pixels.
#[derive(Default)]
pub(crate) struct DrawnSpheres {
    /// Number of spheres that were left out because they cannot be seen.
    pub(crate) left_out: u64,
    /// Spheres that cannot be drawn by rows and remain to be drawn.
    pub(crate) others: Vec<u32>,
}

/// Draws the visible spheres of the index in the target's rows, near to far, starting at a given group
/// and block. If too many undecided pixels have accumulated, it stops early and returns the group and
/// block at which to continue; otherwise it returns `None`.
#[inline(always)]
pub(crate) fn draw_visible<S: Simd>(
    simd: S,
    visible: &VisibleSpheres,
    (first_group, mut first_block): (usize, usize),
    target: &mut SpanTarget,
    drawn: &mut DrawnSpheres,
) -> Option<(usize, usize)> {
    let is_drawn = !visible.others.is_empty() || first_group + first_block > 0;
    let mut drawing = Drawing {
        visible,
        runs: Runs::new(),
        small: SmallOutlines::default(),
        outlines: None,
        occlusion: Occlusion::new(target.axes.width, target.rows.len(), is_drawn),
        drawn,
    };
    for (number, group) in visible.groups.iter().enumerate().skip(first_group) {
        let start = std::mem::take(&mut first_block);
        let rows = own_rows(target, &group.bounds.extent.rows());
        if rows.is_empty() {
            continue;
        }
        if drawing.is_hidden(target, &group.bounds) {
            continue;
        }
        for (k, block) in group.blocks.iter().enumerate().skip(start) {
            if own_rows(target, &block.extent.rows()).is_empty() {
                continue;
            }
            // If spheres overlap little, testing each block costs more time than it saves.
            if visible.is_crowded && drawing.is_hidden(target, block) {
                continue;
            }
            drawing.block(simd, target, (block, group.has_others));
            if target.is_full() {
                return Some((number, k + 1));
            }
        }
        if !visible.is_crowded {
            drawing.occlusion.touch(&rows, &group.bounds.extent.columns());
        }
    }
    None
}

struct Drawing<'a> {
    visible: &'a VisibleSpheres<'a>,
    runs: Runs,
    /// The outlines of the current spheres, if they are small.
    small: SmallOutlines,
    outlines: Option<Box<Outlines>>,
    occlusion: Occlusion,
    drawn: &'a mut DrawnSpheres,
}

/// Returns whether this band is the one that counts a block's spheres: the first band that the block
/// reaches. Each sphere is thus counted once.
#[inline(always)]
fn is_first_band(target: &SpanTarget, block: &VisibleBox) -> bool {
    block.extent.rows().start >= target.rows.start
}

/// Returns those of the given rows of the raster that lie in the target, counted from the target's
/// first row.
#[inline(always)]
fn own_rows(target: &SpanTarget, rows: &Range<usize>) -> Range<usize> {
    let (start, end) = (rows.start.max(target.rows.start), rows.end.min(target.rows.end));
    start - target.rows.start..end.max(start) - target.rows.start
}

impl Drawing<'_> {
    /// Returns whether nearer spheres cover all pixels that a group or block has in the target.
    #[inline(always)]
    fn is_hidden(&mut self, target: &SpanTarget, bounds: &VisibleBox) -> bool {
        let rows = own_rows(target, &bounds.extent.rows());
        self.occlusion.hides(target.t, &rows, &bounds.extent.columns(), bounds.nearest)
    }

    /// Draws the spheres of a block.
    #[inline(always)]
    fn block<S: Simd>(
        &mut self,
        simd: S,
        target: &mut SpanTarget,
        (block, has_others): (&VisibleBox, bool),
    ) {
        let index = self.visible.index;
        let counts_here = is_first_band(target, block);
        let n = S::f64s::LEN;
        for from in SphereIndex::slots_of(block.id as usize).step_by(2 * n) {
            let halves = [index.spheres(from..from + n), index.spheres(from + n..from + 2 * n)];
            let ids = S::u32s::from_slice(simd, &index.ids[from..from + 2 * n]);
            let there = !ids.simd_eq(S::u32s::splat(simd, NO_SPHERE));
            let there = there.to_bitmask();
            let left = self.small_spheres(simd, target, (from, &halves), (there, counts_here));
            for (half, slots) in halves.iter().enumerate() {
                let left = left >> (half * n) & (u64::MAX >> (64 - n));
                if left != 0 {
                    let from = from + half * n;
                    self.other_spheres(
                        simd,
                        target,
                        (from, slots),
                        (left, counts_here, has_others),
                    );
                }
            }
        }
    }

    /// Draws those spheres of a SIMD vector of slots, which starts at slot `from`, that are small
    /// compared with their distance; returns a mask of the spheres that remain to be drawn.
    #[inline(always)]
    fn small_spheres<S: Simd>(
        &mut self,
        simd: S,
        target: &mut SpanTarget,
        (from, halves): (usize, &[SphereSlots; 2]),
        (there, counts_here): (u64, bool),
    ) -> u64 {
        let (index, space) = (self.visible.index, &self.visible.space);
        self.small.find(simd, space, halves);
        let outlines = &self.small;
        let unseen = there & (outlines.is_behind | outlines.is_outside);
        let small = there & outlines.is_small & !unseen;
        let in_view = small & outlines.rows_meet(simd, target.axes, 0..target.axes.height);
        if counts_here {
            self.drawn.left_out += u64::from((unseen | small & !in_view).count_ones());
        }
        let mut drawn = in_view & outlines.rows_meet(simd, target.axes, target.rows.clone());
        if self.visible.is_crowded {
            for lane in lanes_of(drawn) {
                let (rows, columns) = outlines.extent((lane, S::f64s::LEN), target.axes);
                let rows = own_rows(target, &rows);
                let is_nowhere = rows.is_empty() || columns.is_empty();
                let nearest = outlines.nearest[lane];
                if is_nowhere || self.occlusion.hides(target.t, &rows, &columns, nearest) {
                    drawn &= !(1 << lane);
                }
            }
        }
        if drawn != 0 {
            let ids = &index.ids[from..from + S::f32s::LEN];
            draw_small(simd, outlines, drawn, ids, &mut self.runs, target);
            for (lane, row) in self.runs.doubtful.drain(..) {
                let mut outlines = Outlines::default();
                outlines.find(simd, space, &halves[lane / S::f64s::LEN]);
                let half_lane = lane % S::f64s::LEN;
                if outlines.is_plain >> half_lane & 1 == 1 {
                    let span = Span::new(ids[lane], &outlines.one(half_lane));
                    span.doubtful_row(simd, target, row);
                } else {
                    let (_, columns) = self.small.extent((lane, S::f64s::LEN), target.axes);
                    target.doubt(ids[lane], row, columns);
                }
            }
        }
        if self.visible.is_crowded {
            for lane in lanes_of(drawn) {
                let (rows, columns) = outlines.extent((lane, S::f64s::LEN), target.axes);
                self.occlusion.touch(&own_rows(target, &rows), &columns);
            }
        }
        there & !unseen & !small
    }

    /// Draws the spheres whose bits are set in the mask `there`, in which bit 0 stands for slot `from`.
    /// Adds those that cannot be drawn by rows to [`DrawnSpheres::others`], unless they are in
    /// [`VisibleSpheres::others`] already (`has_others`).
    #[inline(always)]
    fn other_spheres<S: Simd>(
        &mut self,
        simd: S,
        target: &mut SpanTarget,
        (from, slots): (usize, &SphereSlots),
        (there, counts_here, has_others): (u64, bool, bool),
    ) {
        let mut outlines = self.outlines.take().unwrap_or_default();
        outlines.find(simd, &self.visible.space, slots);
        let ids = &self.visible.index.ids[from..from + S::f64s::LEN];
        let between =
            outlines.is_plain & !rows_meet(simd, &outlines, target, 0..target.axes.height);
        let unseen = there & (outlines.is_behind | outlines.is_outside | between);
        let left = there & !unseen;
        let plain = left & outlines.is_plain;
        let plain_here = plain & rows_meet(simd, &outlines, target, target.rows.clone());
        if counts_here {
            self.drawn.left_out += u64::from(unseen.count_ones());
        }
        for lane in lanes_of(plain_here) {
            self.sphere(simd, target, &outlines, lane, ids[lane]);
        }
        if !has_others {
            for lane in lanes_of(left & !plain) {
                self.drawn.others.push(ids[lane]);
            }
        }
        self.outlines = Some(outlines);
    }

    /// Draws one sphere by rows.
    #[inline(always)]
    fn sphere<S: Simd>(
        &mut self,
        simd: S,
        target: &mut SpanTarget,
        outlines: &Outlines,
        lane: usize,
        id: u32,
    ) {
        let span = Span::new(id, &outlines.one(lane));
        // If spheres overlap little, a test costs more time than it saves.
        if !self.visible.is_crowded {
            let (rows, columns) = (span.rows_in(target), 0..target.axes.width);
            return span.draw(simd, target, rows, &columns);
        }
        let (rows, columns) = extent(target, outlines, lane);
        if rows.is_empty() || columns.is_empty() {
            return;
        }
        let nearest = span.outline.nearest as f32;
        for strip in strips(&rows) {
            let seen = self.occlusion.seen(target.t, &strip, &columns, nearest);
            if !seen.is_empty() {
                let first = target.rows.start;
                span.draw(simd, target, first + strip.start..first + strip.end, &seen);
                self.occlusion.touch(&strip, &seen);
            }
        }
    }
}

/// Returns a mask of the lanes whose spheres have a row between the first and the last of these rows of
/// the raster.
#[inline(always)]
fn rows_meet<S: Simd>(
    simd: S,
    outlines: &Outlines,
    target: &SpanTarget,
    rows: Range<usize>,
) -> u64 {
    let load = |x: &[f64]| S::f64s::from_slice(simd, &x[..S::f64s::LEN]);
    let number = |row: usize| S::f64s::splat(simd, target.axes.row_numbers[row]);
    let (first, last) = (number(rows.start), number(rows.end - 1));
    let (first_row, last_row) = (load(&outlines.lanes.first_row), load(&outlines.lanes.last_row));
    let meets = last_row.simd_ge(first) & first_row.simd_le(last) & first_row.simd_le(last_row);
    meets.to_bitmask()
}

/// Returns the rows of the target and the columns that a sphere can cover.
#[inline(always)]
fn extent(target: &SpanTarget, outlines: &Outlines, lane: usize) -> (Range<usize>, Range<usize>) {
    let Outline { column, middle_row, row, shear, first_row, last_row, .. } = &outlines.lanes;
    let rows = target.axes.rows_between(first_row[lane], last_row[lane]);
    // The middle of a row moves by the shear; its half width is at most that of the widest row.
    let row = middle_row + row[lane];
    let (above, below) = (row - first_row[lane], last_row[lane] - row);
    let reach = outlines.size[lane].sqrt() + shear[lane].abs() * (above.max(below) + 1.0) + 1.0;
    let (left, right) = (column[lane] - reach, column[lane] + reach);
    (own_rows(target, &rows), target.axes.columns_range(left.ceil(), right.floor()))
}
