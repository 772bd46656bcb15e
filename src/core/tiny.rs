//! Spheres that cover a few pixels in a few rows: all of a vector at once, row by row.

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::certainty::Certainty;
use crate::crowd_draw::lanes_of;
use crate::outline::{MOST_LANES, Outlines};
use crate::row_ends::RowEnds;
use crate::span::{Doubt, MARGIN, SpanTarget};
use crate::span_kernel::TIE;

/// A tiny sphere has at most so many rows.
pub(crate) const TINY_ROWS: usize = 4;

/// The ends of one row of each sphere of a vector, see [`Outlines`].
struct Rows {
    number: [f64; MOST_LANES],
    start: [f64; MOST_LANES],
    end: [f64; MOST_LANES],
    first: [f64; MOST_LANES],
    last: [f64; MOST_LANES],
    /// b at column 0.
    b: [f64; MOST_LANES],
    is_sure: u64,
    is_reached: u64,
    /// Spheres that have this row or a later one.
    is_left: u64,
}

/// Draws those spheres of a vector whose bits are set: finds their pixels, which then wait.
#[inline(always)]
pub(crate) fn draw_tiny<S: Simd, C: Certainty>(
    simd: S,
    outlines: &Outlines,
    tiny: u64,
    ids: &[u32],
    pixels: &mut TinyPixels,
    target: &mut SpanTarget<C>,
) {
    for step in 0..TINY_ROWS {
        let rows = Rows::find::<S, C>(simd, outlines, step as f64);
        // A row between two others may pass no pixel's centre, where the outline leans.
        if tiny & rows.is_left == 0 {
            break;
        }
        for lane in lanes_of(tiny & rows.is_reached) {
            let Some(row) = target.axes.row_at(rows.number[lane]) else { continue };
            if !target.rows.contains(&row) {
                continue;
            }
            let ends = [rows.first[lane], rows.last[lane]];
            if rows.is_sure >> lane & 1 == 0 {
                note_doubts(outlines, lane, ids[lane], row, &rows, target);
            } else if let Some((from, to)) = target.axes.columns_between(ends[0], ends[1]) {
                let of = (outlines, lane, ids[lane]);
                push_pixels(simd, of, (row, from, to), &rows, pixels, target);
            }
        }
    }
}

impl Rows {
    /// The ends of the row that is so many below the first.
    #[inline(always)]
    fn find<S: Simd, C: Certainty>(simd: S, of: &Outlines, step: f64) -> Rows {
        let splat = |x: f64| S::f64s::splat(simd, x);
        let load = |x: &[f64; MOST_LANES]| S::f64s::from_slice(simd, &x[..S::f64s::LEN]);
        let number = load(&of.first_row) + splat(step);
        let j = number - load(&of.row);
        let middle = load(&of.column) + load(&of.shear) * j;
        let squared = load(&of.square[0]) + (load(&of.square[1]) + load(&of.square[2]) * j) * j;
        let RowEnds { start, end, first, last, is_sure } =
            RowEnds::<S>::new::<C>(simd, middle, squared, load(&of.thin));
        let is_left = number.simd_le(load(&of.last_row));
        let is_reached = is_left
            & ((squared.simd_ge(-load(&of.square_doubt)) & !is_sure)
                | (is_sure & first.simd_le(last)));
        let b = load(&of.b0) + load(&of.b_row) * j;
        let store = |x: S::f64s| {
            let mut all = [0.0; MOST_LANES];
            x.store_slice(&mut all[..S::f64s::LEN]);
            all
        };
        Rows {
            number: store(number),
            start: store(start),
            end: store(end),
            first: store(first),
            last: store(last),
            b: store(b),
            is_sure: is_sure.to_bitmask(),
            is_reached: is_reached.to_bitmask(),
            is_left: is_left.to_bitmask(),
        }
    }
}

/// Pixels of tiny spheres whose `t` is found later, many at once: one by one, each would wait for the
/// root and the quotient of its own.
pub(crate) struct TinyPixels {
    squared: [f64; WAITING],
    b: [f64; WAITING],
    numerator: [f64; WAITING],
    /// In the target's buffers.
    place: [u32; WAITING],
    index: [u32; WAITING],
    count: usize,
}

/// How many pixels wait at most.
const WAITING: usize = 128;

impl TinyPixels {
    pub(crate) fn new() -> TinyPixels {
        let zero = [0.0; WAITING];
        let (place, index) = ([0; WAITING], [0; WAITING]);
        TinyPixels { squared: zero, b: zero, numerator: zero, place, index, count: 0 }
    }

    /// Finds `t` of all that wait, in `f64`, and takes over those that are nearer than what is there.
    #[inline(always)]
    pub(crate) fn draw<S: Simd, C: Certainty>(&mut self, simd: S, target: &mut SpanTarget<C>) {
        target.decided += self.count as u64;
        let mut from = 0;
        while from < self.count {
            let load =
                |x: &[f64; WAITING]| S::f64s::from_slice(simd, &x[from..from + S::f64s::LEN]);
            let t = load(&self.numerator) / (load(&self.b) + load(&self.squared).sqrt());
            let t = t.narrow(t);
            let end = self.count.min(from + S::f64s::LEN);
            for (at, t) in (from..end).zip(t.as_slice()) {
                take_over(target, self.place[at] as usize, self.index[at], *t);
            }
            from += S::f64s::LEN;
        }
        self.count = 0;
    }
}

/// The pixel's first hit is this one, if it is nearer than what is known.
#[inline(always)]
fn take_over<C: Certainty>(target: &mut SpanTarget<C>, place: usize, index: u32, t: f32) {
    let known = target.t[place];
    if t < known * below::<C>() {
        target.t[place] = t;
        target.object[place] = index;
    } else if C::IS_CERTAIN && t <= known * (1.0 + TIE) {
        if target.is_same_as_known(place, index) {
            return;
        }
        // The ladder counts it.
        target.decided -= 1;
        let width = target.axes.width();
        let (row, column) = (target.rows.start + place / width, place % width);
        let (row, column) = (row as u32, column as u32);
        target.doubts.push(Doubt { index, row, column, t: Some(t) });
    }
}

/// Lets the pixels of one row of a sphere wait.
#[inline(always)]
fn push_pixels<S: Simd, C: Certainty>(
    simd: S,
    (of, lane, index): (&Outlines, usize, u32),
    (row, from, to): (usize, usize, usize),
    rows: &Rows,
    pixels: &mut TinyPixels,
    target: &mut SpanTarget<C>,
) {
    target.is_reached[row - target.rows.start] = true;
    let start = (row - target.rows.start) * target.axes.width();
    if pixels.count + (to - from + 1) > WAITING {
        pixels.draw(simd, target);
    }
    for column in from..=to {
        let c = f64::from(target.axes.columns[column]);
        let at = pixels.count;
        pixels.squared[at] = (c - rows.start[lane]) * (rows.end[lane] - c);
        pixels.b[at] = rows.b[lane] + of.b_column[lane] * c;
        pixels.numerator[at] = of.numerator[lane];
        pixels.place[at] = (start + column) as u32;
        pixels.index[at] = index;
        pixels.count += 1;
    }
}

/// A `t` below this share of another is nearer.
#[inline(always)]
fn below<C: Certainty>() -> f32 {
    if C::IS_CERTAIN { 1.0 - TIE } else { 1.0 }
}

/// Leaves all pixels that a row may cover to the ladder.
#[cold]
#[inline(never)]
fn note_doubts<C: Certainty>(
    of: &Outlines,
    lane: usize,
    index: u32,
    row: usize,
    rows: &Rows,
    target: &mut SpanTarget<C>,
) {
    let more = MARGIN + (2.0 * of.thin[lane]).sqrt();
    let (first, last) = ((rows.start[lane] - more).ceil(), (rows.end[lane] + more).floor());
    let Some((from, to)) = target.axes.columns_between(first, last) else { return };
    target.is_reached[row - target.rows.start] = true;
    for column in from..=to {
        let (row, column) = (row as u32, column as u32);
        target.doubts.push(Doubt { index, row, column, t: None });
    }
}
