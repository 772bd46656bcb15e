//! `t` of the pixels in one row of a sphere, in `f32`, several at a time.

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::exact::lane::Lane;
use crate::exact::single_lanes::SingleLanes;

/// What a row's pixels share. Column numbers are whole, so that differences of them are exact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpanRow {
    /// First and last column that the sphere covers, wherever the image ends.
    pub(crate) first: f32,
    pub(crate) last: f32,
    /// How far inside the outline's two ends they are, in columns.
    pub(crate) left: f32,
    pub(crate) right: f32,
    /// b at the pivot, in two parts.
    pub(crate) b: [f32; 2],
    /// The column that b is given at: the middle, for wide spheres the first.
    pub(crate) pivot: f32,
    /// `left right`, for wide spheres.
    pub(crate) offset: f32,
}

/// What all of a sphere's rows share.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpanShape {
    /// In two parts.
    pub(crate) numerator: [f32; 2],
    /// b for each column, in two parts, for wide spheres the first of 12 bits.
    pub(crate) b_column: [f32; 2],
    /// Whether the error of the root needs correction too.
    pub(crate) is_wide: bool,
}

/// The lanes' version of a [`SpanShape`] and a [`SpanRow`].
#[derive(Clone, Copy)]
pub(crate) struct SpanLanes<S: Simd> {
    first: SingleLanes<S>,
    last: SingleLanes<S>,
    left: SingleLanes<S>,
    right: SingleLanes<S>,
    b: [SingleLanes<S>; 2],
    pivot: SingleLanes<S>,
    offset: SingleLanes<S>,
    numerator: [SingleLanes<S>; 2],
    b_column: [SingleLanes<S>; 2],
}

impl<S: Simd> SpanLanes<S> {
    #[inline(always)]
    pub(crate) fn new(simd: S, shape: &SpanShape, row: &SpanRow) -> Self {
        let splat = |x| SingleLanes::splat(simd, x);
        SpanLanes {
            first: splat(row.first),
            last: splat(row.last),
            left: splat(row.left),
            right: splat(row.right),
            b: row.b.map(splat),
            pivot: splat(row.pivot),
            offset: splat(row.offset),
            numerator: shape.numerator.map(splat),
            b_column: shape.b_column.map(splat),
        }
    }

    /// `t = numerator / (b + S)`, with `S^2 = (c - start) (end - c)`, to an ulp: for a sphere whose
    /// S is small beside b.
    ///
    /// With `u = 2^-24`: each factor of `S^2` is off by 2 u, its own rounding and that of left or
    /// right, and their product by u more, so S is by `5/2 u` and its own rounding, the part of b that varies by 3 u of itself, and the sum of both by u: in all
    /// `(4.5 S + 4 (b - b0)) u`, which the caller keeps below 0.45 u of the denominator. The sum with
    /// b0 keeps its rest, and the quotient is corrected by it and by its own residual.
    #[inline(always)]
    pub(crate) fn narrow(&self, columns: S::f32s) -> SingleLanes<S> {
        let columns = SingleLanes(columns);
        let (from_first, to_last) = (columns - self.first, self.last - columns);
        let square = (from_first + self.left) * (to_last + self.right);
        let root = square.sqrt();
        let moved = (columns - self.pivot) * self.b_column[0] + self.b[1];
        let added = moved + root;
        let sum = self.b[0] + added;
        let rest = added - (sum - self.b[0]);
        let one = SingleLanes(S::f32s::splat(columns.0.token(), 1.0));
        let reciprocal = one / sum;
        let quotient = self.numerator[0] * reciprocal;
        let residual = self.numerator[0].residual(quotient, sum) + self.numerator[1];
        quotient + (residual - quotient * rest) * reciprocal
    }

    /// The same for a sphere whose S is not small beside b: with whole numbers m and n of columns
    /// from the first and to the last pixel,
    ///
    /// ```text
    /// S^2 = (m + left) (n + right) = m n + (m right + (n left + left right))
    /// ```
    ///
    /// in which nothing cancels, and whose first term is exact, since `m + n < 2^12`. The root is corrected by
    /// `(S^2 - root^2) / (2 root)`. One reciprocal `i = 1 / (root sum)` serves both quotients, since
    /// `1 / sum = i root` and `1 / root = i sum` are right to 3 u, and what they multiply is small.
    ///
    /// What is left: the rounding of the second term of `S^2`, by 4 u of itself, which is at most
    /// `2 w + 1`, so that S is off by less than `2 sqrt(2 w + 1) u`; and the third power of the share of
    /// the sum that stands in `rest`, at most `2^-12` of what b varies by.
    #[inline(always)]
    pub(crate) fn wide(&self, columns: S::f32s) -> SingleLanes<S> {
        let columns = SingleLanes(columns);
        let (from_first, to_last) = (columns - self.first, self.last - columns);
        let whole = from_first * to_last;
        let part = from_first * self.right + (to_last * self.left + self.offset);
        let square = whole + part;
        let square_rest = part - (square - whole);
        let root = square.sqrt();
        let root_residual = square.residual(root, root) + square_rest;

        // Exact: 12 bits by 12.
        let moved = from_first * self.b_column[0];
        let b = self.b[0] + moved;
        let b_low = self.b[1] + from_first * self.b_column[1];
        let b_rest = (moved - (b - self.b[0])) + b_low;
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

/// The buffers of a row, and the whole column numbers of its pixels.
pub(crate) struct RowBuffers<'a> {
    pub(crate) columns: &'a [f32],
    pub(crate) t: &'a mut [f32],
    pub(crate) object: &'a mut [u32],
}

/// Two `t` that are closer than this share of them may be in the wrong order for their rounding:
/// each is off by an ulp at most.
pub(crate) const TIE: f32 = 6.0 * f32::EPSILON;

/// What the vectors of one row share.
struct Drawing<S: Simd> {
    simd: S,
    below: S::f32s,
    above: S::f32s,
    none: S::f32s,
    nearest: S::f32s,
    /// Whether a row is so long that it pays to look whether whole vectors are hidden.
    may_be_hidden: bool,
    end: S::f32s,
    own: S::u32s,
}

impl<S: Simd> Drawing<S> {
    /// One vector: which lanes are in doubt.
    #[inline(always)]
    fn draw(
        &self,
        columns: &[f32],
        t: &mut [f32],
        object: &mut [u32],
        t_of: &impl RowOfT<S>,
    ) -> <S::f32s as SimdBase<S>>::Mask {
        let columns = S::f32s::from_slice(self.simd, columns);
        let known = S::f32s::from_slice(self.simd, t);
        if self.may_be_hidden && known.simd_lt(self.nearest).all_true() {
            return self.none.simd_lt(self.none);
        }
        let found = t_of.t(columns).0;
        let is_inside = columns.simd_le(self.end);
        let is_nearer = is_inside & found.simd_lt(known * self.below);
        // Not a selection of what is stored: that would become a masked store, slow on many
        // processors.
        let nearest = is_nearer.select(found, self.none).min(known);
        nearest.store_slice(t);
        let objects = S::u32s::from_slice(self.simd, object);
        let is_changed = is_nearer.select(self.own ^ objects, S::u32s::splat(self.simd, 0));
        (objects ^ is_changed).store_slice(object);
        let is_farther = found.simd_gt(known * self.above);
        is_inside & !(is_nearer | is_farther)
    }
}

/// A row's `t`, column by column.
pub(crate) trait RowOfT<S: Simd> {
    fn t(&self, columns: S::f32s) -> SingleLanes<S>;
}

/// [`SpanLanes::narrow`]
pub(crate) struct Narrow<'a, S: Simd>(pub(crate) &'a SpanLanes<S>);

/// [`SpanLanes::wide`]
pub(crate) struct Wide<'a, S: Simd>(pub(crate) &'a SpanLanes<S>);

impl<S: Simd> RowOfT<S> for Narrow<'_, S> {
    #[inline(always)]
    fn t(&self, columns: S::f32s) -> SingleLanes<S> {
        self.0.narrow(columns)
    }
}

impl<S: Simd> RowOfT<S> for Wide<'_, S> {
    #[inline(always)]
    fn t(&self, columns: S::f32s) -> SingleLanes<S> {
        self.0.wide(columns)
    }
}

/// Takes over the sphere's pixels from `from` to `to` (which is the last one) of a row where they
/// are nearer than what is there; none of them is nearer than `nearest`. Tells whether any is too close to it to tell; those stay as they
/// are.
#[inline(always)]
pub(crate) fn draw_row<S: Simd>(
    simd: S,
    buffers: &mut RowBuffers,
    (from, to): (usize, usize),
    (index, nearest): (u32, f32),
    t_of: &impl RowOfT<S>,
) -> bool {
    let n = S::f32s::LEN;
    let drawing = Drawing {
        simd,
        below: S::f32s::splat(simd, 1.0 - TIE),
        above: S::f32s::splat(simd, 1.0 + TIE),
        none: S::f32s::splat(simd, f32::INFINITY),
        nearest: S::f32s::splat(simd, nearest),
        may_be_hidden: to - from >= 8 * n,
        end: S::f32s::splat(simd, buffers.columns[to]),
        own: S::u32s::splat(simd, index),
    };
    let mut in_doubt = drawing.none.simd_lt(drawing.none);
    // Where whole vectors may begin.
    let whole = (buffers.t.len() + 1).saturating_sub(n).min(to + 1);
    let mut at = from;
    while at < whole {
        let (t, object) = (&mut buffers.t[at..at + n], &mut buffers.object[at..at + n]);
        in_doubt |= drawing.draw(&buffers.columns[at..at + n], t, object, t_of);
        at += n;
    }
    if at <= to {
        // The buffers end within this vector.
        let (mut t, mut object) = ([0.0; 16], [0; 16]);
        let left = buffers.t.len() - at;
        t[..left].copy_from_slice(&buffers.t[at..]);
        object[..left].copy_from_slice(&buffers.object[at..]);
        let columns = &buffers.columns[at..at + n];
        in_doubt |= drawing.draw(columns, &mut t[..n], &mut object[..n], t_of);
        buffers.t[at..].copy_from_slice(&t[..left]);
        buffers.object[at..].copy_from_slice(&object[..left]);
    }
    in_doubt.any_true()
}
