//! Spheres that cover a few pixels in a few rows: the rows of a vector of them are found together, and
//! each is drawn as one vector of pixels.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, u32x8};

use crate::exact::lanes::lanes_of;
use crate::render::outline::{MARGIN, MOST_LANES, Outlines, SMALL_ROWS};
use crate::render::rows::draw_row::TIE;
use crate::render::rows::span::{Doubt, RowEnds, SpanTarget};

/// Pixels drawn at once.
const PIXELS: usize = 8;

/// Maximum number of rows of the spheres of a vector.
const RUNS: usize = SMALL_ROWS * MOST_LANES;

/// The numbers that the rows of a small sphere share, lane by lane: with an anchor B near all of its b,
/// `Q = numerator / B` in two parts.
struct SmallSpheres {
    /// 1 / B.
    inverse: [f32; 2 * MOST_LANES],
    /// Change of e from column to column, see [`SmallSpheres::t`].
    slope: [f32; 2 * MOST_LANES],
    quotient: [[f32; 2 * MOST_LANES]; 2],
}

/// Rows of small spheres: those of the first row of each, lane by lane, then those of the second, and so
/// on; each narrowed vector is stored with as many lanes again, which the next one overwrites.
pub(crate) struct Runs {
    /// First and last column that the sphere covers, wherever the image ends, and how far inside
    /// the outline's two ends they are.
    first: [f32; RUNS + MOST_LANES],
    last: [f32; RUNS + MOST_LANES],
    left: [f32; RUNS + MOST_LANES],
    right: [f32; RUNS + MOST_LANES],
    /// e without S at the first column.
    moved: [f32; RUNS + MOST_LANES],
    /// The row in the target and the first column in the raster; see [`whole`].
    row: [f64; RUNS],
    from: [f64; RUNS],
    /// The rows that are drawn.
    listed: [u8; RUNS + 1],
}

/// Rows of some spheres: those drawn, those in doubt, and the spheres that have this row or a later
/// one.
struct FoundRows {
    is_drawn: u64,
    is_doubtful: u64,
    is_left: u64,
}

/// Summand that leaves a whole number from 0 on as the lowest bits of the sum.
const WHOLE: f64 = (1_u64 << 52) as f64;

/// The whole number that [`WHOLE`] was added to.
#[inline(always)]
fn whole(sum: f64) -> usize {
    sum.to_bits() as u32 as usize
}

/// Draws those spheres of a vector whose bits are set.
#[inline(always)]
pub(crate) fn draw_small<S: Simd>(
    simd: S,
    outlines: &Outlines,
    small: u64,
    ids: &[u32],
    runs: &mut Runs,
    target: &mut SpanTarget,
) {
    let (spheres, anchor) = SmallSpheres::new(simd, outlines);
    // Listed without a branch, which no processor could foresee.
    let mut count = 0;
    for number in 0..SMALL_ROWS {
        let step = runs.find::<S>(simd, (outlines, &spheres, anchor), number, target);
        // A row between two others may pass no pixel's centre, where the outline leans.
        if small & step.is_left == 0 {
            break;
        }
        let is_drawn = small & step.is_drawn;
        for lane in 0..S::f64s::LEN {
            runs.listed[count] = (number * S::f64s::LEN + lane) as u8;
            count += (is_drawn >> lane & 1) as usize;
        }
        for lane in lanes_of(small & step.is_doubtful) {
            note_doubts(outlines, lane, ids[lane], number, target);
        }
    }
    for offset in 0..count {
        let run = usize::from(runs.listed[offset]);
        let lane = run % S::f64s::LEN;
        runs.draw::<S>(simd, run, (&spheres, lane, ids[lane]), target);
    }
}

impl SmallSpheres {
    /// Computes the spheres' numbers, and the anchors: each sphere's b at its centre.
    #[inline(always)]
    fn new<S: Simd>(simd: S, outlines: &Outlines) -> (SmallSpheres, S::f64s) {
        let load = |x: &[f64; MOST_LANES]| S::f64s::from_slice(simd, &x[..S::f64s::LEN]);
        let anchor = load(&outlines.b0) + load(&outlines.b_column) * load(&outlines.column);
        let inverse = S::f64s::splat(simd, 1.0) / anchor;
        let quotient = load(&outlines.numerator) * inverse;
        let high = quotient.narrow(quotient);
        let spheres = SmallSpheres {
            inverse: narrowed::<S>(inverse),
            slope: narrowed::<S>(load(&outlines.b_column) * inverse),
            quotient: [narrowed::<S>(quotient), narrowed::<S>(quotient - high.widen().0)],
        };
        (spheres, anchor)
    }

    /// `t = numerator / (b + S) = Q / (1 + e)` of the columns from a row's first one on.
    ///
    /// With `u = 2^-24`, w the most that S can be and v the most that b can differ from the anchor B,
    /// both in units of B: each factor of `S^2` is off by `4/3 u` (u for the sum, `1/3 u` for left or
    /// right), and their product by u more, so S is by less than `2 u` and its own rounding, and as a
    /// share of B by 5 u; what b changes along the row, `2 w |b_column|` at most, by 2 u of itself, and
    /// the rest of b by 2 u; their sum by `v u`, and the sum with S by `(w + v) u`. So e is off by at
    /// most `(6 w + 4 w |b_column| + 4 v) u`. The series `e (1 - e) (1 + e^2)` differs from
    /// `e / (1 + e)` by `e^5 / (1 + e)`, and its roundings and those of its product with Q are less
    /// than `8 |e| u`: less than `(14 w + 4 w |b_column| + 12 v) u` in all. The caller keeps
    /// `4 w + 4 w |b_column| + 3 v` below a twentieth, so that `|e| < 1/60`: together less than
    /// `0.25 u`.
    #[inline(always)]
    fn t<S: Simd>(
        &self,
        simd: S,
        (lane, from_first): (usize, f32x8<S>),
        square: f32x8<S>,
        moved: f32,
    ) -> f32x8<S> {
        let splat = |x: f32| f32x8::splat(simd, x);
        let added = from_first * splat(self.slope[lane]) + splat(moved);
        let e = added + square.sqrt() * splat(self.inverse[lane]);
        let one = splat(1.0);
        let series = (e * (one - e)) * (one + e * e);
        let [high, low] = self.quotient.each_ref().map(|part| splat(part[lane]));
        high + (low - high * series)
    }
}

#[inline(always)]
fn narrowed<S: Simd>(x: S::f64s) -> [f32; 2 * MOST_LANES] {
    let mut all = [0.0; 2 * MOST_LANES];
    x.narrow(x).store_slice(&mut all[..S::f32s::LEN]);
    all
}

impl Runs {
    pub(crate) fn new() -> Runs {
        let singles = [0.0; RUNS + MOST_LANES];
        Runs {
            first: singles,
            last: singles,
            left: singles,
            right: singles,
            moved: singles,
            row: [0.0; RUNS],
            from: [0.0; RUNS],
            listed: [0; RUNS + 1],
        }
    }

    /// The row of each sphere that is so many below its first.
    #[inline(always)]
    fn find<S: Simd>(
        &mut self,
        simd: S,
        (outlines, spheres, anchor): (&Outlines, &SmallSpheres, S::f64s),
        step: usize,
        target: &SpanTarget,
    ) -> FoundRows {
        let n = S::f64s::LEN;
        let splat = |x: f64| S::f64s::splat(simd, x);
        let load = |x: &[f64; MOST_LANES]| S::f64s::from_slice(simd, &x[..n]);
        let number = load(&outlines.first_row) + splat(step as f64);
        let j = number - load(&outlines.row);
        let middle = load(&outlines.column) + load(&outlines.shear) * j;
        let squared = load(&outlines.square[0])
            + (load(&outlines.square[1]) + load(&outlines.square[2]) * j) * j;
        let RowEnds { start, end, first, last, is_sure } =
            RowEnds::<S>::new(simd, middle, squared, load(&outlines.thin));
        let is_left = number.simd_le(load(&outlines.last_row)).to_bitmask();
        let is_near = squared.simd_ge(-load(&outlines.square_doubt)).to_bitmask();
        let (row, is_here) = target.axes.locate_rows(simd, number, &target.rows);
        let (from, _, is_there) = target.axes.clip(simd, first, last);
        let is_sure = is_sure.to_bitmask();

        let b = load(&outlines.b0) + load(&outlines.b_row) * j + load(&outlines.b_column) * first;
        let inverse = S::f32s::from_slice(simd, &spheres.inverse[..S::f32s::LEN]).widen().0;
        let moved = (b - anchor) * inverse;
        let at = step * n;
        let singles = at..at + S::f32s::LEN;
        first.narrow(first).store_slice(&mut self.first[singles.clone()]);
        last.narrow(last).store_slice(&mut self.last[singles.clone()]);
        let (left, right) = (first - start, end - last);
        left.narrow(left).store_slice(&mut self.left[singles.clone()]);
        right.narrow(right).store_slice(&mut self.right[singles.clone()]);
        moved.narrow(moved).store_slice(&mut self.moved[singles]);
        (row + splat(WHOLE)).store_slice(&mut self.row[at..at + n]);
        (from + splat(WHOLE)).store_slice(&mut self.from[at..at + n]);
        FoundRows {
            is_drawn: is_left & is_here & is_sure & is_there,
            is_doubtful: is_left & is_here & is_near & !is_sure,
            is_left,
        }
    }

    /// Takes over the pixels of a row that are nearer than what is there.
    #[inline(always)]
    fn draw<S: Simd>(
        &self,
        simd: S,
        run: usize,
        (spheres, lane, index): (&SmallSpheres, usize, u32),
        target: &mut SpanTarget,
    ) {
        let (row, from) = (whole(self.row[run]), whole(self.from[run]));
        let offset = row * target.axes.width() + from;
        target.is_reached[row] = true;
        let splat = |x: f32| f32x8::splat(simd, x);
        let columns = f32x8::from_slice(simd, &target.axes.columns[from..from + PIXELS]);
        let (first, last) = (splat(self.first[run]), splat(self.last[run]));
        let (from_first, to_last) = (columns - first, last - columns);
        let square = (from_first + splat(self.left[run])) * (to_last + splat(self.right[run]));
        let found = spheres.t(simd, (lane, from_first), square, self.moved[run]);
        let is_inside = columns.simd_le(last);
        let mut doubtful = 0;
        let pixels = Pixels { simd, found, is_inside, index };
        if target.t.len() - offset >= PIXELS {
            let (t, object) = (&mut target.t[offset..], &mut target.object[offset..]);
            doubtful = pixels.take_over(&mut t[..PIXELS], &mut object[..PIXELS]);
        } else {
            let left = target.t.len() - offset;
            let (mut t, mut object) = ([0.0; PIXELS], [0; PIXELS]);
            t[..left].copy_from_slice(&target.t[offset..]);
            object[..left].copy_from_slice(&target.object[offset..]);
            doubtful |= pixels.take_over(&mut t, &mut object);
            target.t[offset..].copy_from_slice(&t[..left]);
            target.object[offset..].copy_from_slice(&object[..left]);
        }
        target.decided += u64::from(is_inside.to_bitmask().count_ones());
        if doubtful != 0 {
            note_ties(target, (offset, doubtful), found.into(), index);
        }
    }
}

/// Pixels of one row of a sphere.
struct Pixels<S: Simd> {
    simd: S,
    found: f32x8<S>,
    is_inside: <f32x8<S> as SimdBase<S>>::Mask,
    index: u32,
}

impl<S: Simd> Pixels<S> {
    /// Takes over those that are nearer than what is known; tells which are too close to it to tell.
    #[inline(always)]
    fn take_over(&self, t: &mut [f32], object: &mut [u32]) -> u64 {
        let Pixels { simd, found, is_inside, index } = *self;
        let known = f32x8::from_slice(simd, t);
        let is_nearer = is_inside & found.simd_lt(known * f32x8::splat(simd, 1.0 - TIE));
        is_nearer.select(found, known).store_slice(t);
        let objects = u32x8::from_slice(simd, object);
        is_nearer.select(u32x8::splat(simd, index), objects).store_slice(object);
        let is_farther = found.simd_gt(known * f32x8::splat(simd, 1.0 + TIE));
        (is_inside & !(is_nearer | is_farther)).to_bitmask()
    }
}

/// Leaves pixels from a position on, whose bits are set, to the ladder: they are too close to what is
/// known.
#[cold]
#[inline(never)]
fn note_ties(
    target: &mut SpanTarget,
    (offset, doubtful): (usize, u64),
    found: [f32; PIXELS],
    index: u32,
) {
    let width = target.axes.width();
    for lane in lanes_of(doubtful) {
        let offset = offset + lane;
        if target.is_same_as_known(offset, index) {
            continue;
        }
        // The ladder counts it.
        target.decided -= 1;
        let (row, column) = (target.rows.start + offset / width, offset % width);
        let (row, column) = (row as u32, column as u32);
        target.doubts.push(Doubt { index, row, column, t: Some(found[lane]) });
    }
}

/// Leaves all pixels that a row, so many below the first, may cover to the ladder.
#[cold]
#[inline(never)]
fn note_doubts(outlines: &Outlines, lane: usize, index: u32, step: usize, target: &mut SpanTarget) {
    let number = outlines.first_row[lane] + step as f64;
    let Some(row) = target.axes.row_at(number) else { return };
    let j = number - outlines.row[lane];
    let middle = outlines.column[lane] + outlines.shear[lane] * j;
    let [square0, square1, square2] = [0, 1, 2].map(|power| outlines.square[power][lane]);
    let squared = square0 + (square1 + square2 * j) * j;
    let reach = squared.max(0.0).sqrt() + MARGIN + (2.0 * outlines.thin[lane]).sqrt();
    let (first, last) = ((middle - reach).ceil(), (middle + reach).floor());
    let Some((from, to)) = target.axes.columns_between(first, last) else { return };
    target.is_reached[row - target.rows.start] = true;
    for column in from..=to {
        let (row, column) = (row as u32, column as u32);
        target.doubts.push(Doubt { index, row, column, t: None });
    }
}
