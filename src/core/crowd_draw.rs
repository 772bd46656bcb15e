//! Drawing what a band of rows sees of a crowd of spheres.

use std::ops::Range;

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::counts::Counts;
use crate::crowd::{BoxSeen, Crowd};
use crate::outline::{Outlines, Spheres};
use crate::span::{Span, SpanTarget};
use crate::sphere_index::{NO_SPHERE, SphereIndex};
use crate::tiny::draw_tiny;
use crate::veil::Veil;

/// What a band did with a crowd.
#[derive(Default)]
pub(crate) struct CrowdDrawn {
    pub(crate) counts: Counts,
    /// Spheres that cannot be drawn by rows.
    pub(crate) others: Vec<u32>,
}

/// Draws all that the target's rows see of the crowd, near to far.
#[inline(always)]
pub(crate) fn draw_crowd<S: Simd>(
    simd: S,
    crowd: &Crowd,
    target: &mut SpanTarget,
    drawn: &mut CrowdDrawn,
) {
    let mut drawing = Drawing {
        crowd,
        veil: Veil::new(target.axes.width(), target.rows.len()),
        outlines: Outlines::default(),
        drawn,
    };
    for group in &crowd.groups {
        if !drawing.is_seen(target, &group.bounds) {
            continue;
        }
        for block in &group.blocks {
            if drawing.is_seen(target, block) {
                drawing.block(simd, target, block);
            }
        }
    }
}

struct Drawing<'a> {
    crowd: &'a Crowd<'a>,
    veil: Veil,
    outlines: Outlines,
    drawn: &'a mut CrowdDrawn,
}

/// Rows of the raster that lie in the target, as rows of the target.
#[inline(always)]
fn own_rows(target: &SpanTarget, rows: &Range<usize>) -> Range<usize> {
    let (start, end) = (rows.start.max(target.rows.start), rows.end.min(target.rows.end));
    start - target.rows.start..end.max(start) - target.rows.start
}

impl Drawing<'_> {
    /// Whether a group or block has pixels in the target that are not hidden.
    #[inline(always)]
    fn is_seen(&mut self, target: &SpanTarget, bounds: &BoxSeen) -> bool {
        let rows = own_rows(target, &bounds.rows());
        !rows.is_empty() && !self.veil.hides(target.t, &rows, &bounds.columns(), bounds.nearest)
    }

    #[inline(always)]
    fn block<S: Simd>(&mut self, simd: S, target: &mut SpanTarget, block: &BoxSeen) {
        let index = self.crowd.index;
        let slots = SphereIndex::slots_of(block.place as usize);
        // What is found of a sphere is counted once: by the first band that the block reaches.
        let counts_here = block.rows().start >= target.rows.start;
        for from in slots.step_by(S::f64s::LEN) {
            let lanes = from..from + S::f64s::LEN;
            let of = Spheres {
                x: &index.x[lanes.clone()],
                y: &index.y[lanes.clone()],
                z: &index.z[lanes.clone()],
                radius: &index.radius[lanes.clone()],
            };
            self.outlines.find(simd, &self.crowd.space, &of);
            self.vector(simd, target, &index.ids[lanes], counts_here);
        }
        if !self.crowd.is_crowded {
            let rows = own_rows(target, &block.rows());
            self.veil.touch(&rows, &block.columns());
        }
    }

    /// Draws the spheres of one vector.
    #[inline(always)]
    fn vector<S: Simd>(
        &mut self,
        simd: S,
        target: &mut SpanTarget,
        ids: &[u32],
        counts_here: bool,
    ) {
        let mut there = 0;
        for (lane, id) in ids.iter().enumerate() {
            there |= u64::from(*id != NO_SPHERE) << lane;
        }
        let outlines = &self.outlines;
        let behind = there & outlines.is_behind;
        let outside = there & outlines.is_outside & !behind;
        let left = there & !behind & !outside;
        let plain = left & outlines.is_plain;
        let tiny = plain & outlines.is_tiny;
        if counts_here {
            let counts = &mut self.drawn.counts;
            counts.behind += u64::from(behind.count_ones());
            counts.outside += u64::from(outside.count_ones());
            counts.in_view += u64::from(left.count_ones());
        }
        if tiny != 0 {
            draw_tiny(simd, outlines, tiny, ids, target);
            if self.crowd.is_crowded {
                for lane in lanes_of(tiny) {
                    let (rows, columns) = self.extent(target, lane);
                    self.veil.touch(&rows, &columns);
                }
            }
        }
        for lane in lanes_of(plain & !tiny) {
            self.sphere(simd, target, lane, ids[lane]);
        }
        for lane in lanes_of(left & !plain) {
            self.drawn.others.push(ids[lane]);
        }
    }

    /// Draws one sphere by rows, if it can be.
    #[inline(always)]
    fn sphere<S: Simd>(&mut self, simd: S, target: &mut SpanTarget, lane: usize, id: u32) {
        let outline = self.outlines.one(lane);
        let Some(span) = Span::new(id, &outline) else {
            self.drawn.others.push(id);
            return;
        };
        if !self.crowd.is_crowded {
            span.draw(simd, target);
            return;
        }
        let (rows, columns) = self.extent(target, lane);
        if rows.is_empty() || columns.is_empty() {
            return;
        }
        if self.veil.hides(target.t, &rows, &columns, outline.nearest as f32) {
            self.drawn.counts.hidden += 1;
            return;
        }
        span.draw(simd, target);
        self.veil.touch(&rows, &columns);
    }

    /// Rows of the target and columns that a sphere can cover.
    #[inline(always)]
    fn extent(&self, target: &SpanTarget, lane: usize) -> (Range<usize>, Range<usize>) {
        let of = &self.outlines;
        let rows = target.axes.rows_between(of.first_row[lane], of.last_row[lane]);
        // The middle moves by the shear, the half width is at most that of the widest row.
        let tall =
            (of.first_row[lane] - of.row[lane]).abs().max((of.last_row[lane] - of.row[lane]).abs());
        let reach = of.size[lane].sqrt() + of.shear[lane].abs() * (tall + 1.0) + 1.0;
        let (left, right) = (of.column[lane] - reach, of.column[lane] + reach);
        (own_rows(target, &rows), target.axes.columns_range(left.ceil(), right.floor()))
    }
}

/// The lanes whose bits are set.
#[inline(always)]
pub(crate) fn lanes_of(mut bits: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = bits.trailing_zeros() as usize;
        let is_left = bits != 0;
        bits &= bits.wrapping_sub(1);
        is_left.then_some(lane)
    })
}
