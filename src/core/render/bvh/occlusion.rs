//! Upper bounds of the `t` of the farthest hit in each small rectangle of a band of rows, used to skip
//! spheres that nearer ones hide.

use std::ops::Range;

/// Number of columns of a rectangle.
const COLUMNS: usize = 16;
/// Number of rows of a rectangle.
const ROWS: usize = 8;

/// Maximum number of rectangles that a group, block or small sphere may cover to be tested: larger ones
/// are seldom hidden.
const MOST: usize = 512;

/// Upper bounds of the largest `t` in each rectangle of 16 x 8 pixels of a band of rows.
pub(crate) struct Occlusion {
    farthest: Vec<f32>,
    /// For each rectangle, true if pixels in it were drawn since its `farthest` was computed, so that
    /// the bound may be too large.
    is_stale: Vec<bool>,
    across: usize,
    width: usize,
    height: usize,
}

impl Occlusion {
    /// Makes the rectangles of a band. `is_drawn` is false if no pixel of the band has a hit yet.
    pub(crate) fn new(width: usize, height: usize, is_drawn: bool) -> Occlusion {
        let across = width.div_ceil(COLUMNS);
        let count = across * height.div_ceil(ROWS);
        let (farthest, is_stale) = (vec![f32::INFINITY; count], vec![is_drawn; count]);
        Occlusion { farthest, is_stale, across, width, height }
    }

    /// Marks the rectangles of these rows and columns of the band as drawn into, so that their bounds
    /// are recomputed when needed.
    #[inline(always)]
    pub(crate) fn touch(&mut self, rows: &Range<usize>, columns: &Range<usize>) {
        for row in rows.start / ROWS..rows.end.div_ceil(ROWS) {
            let (from, to) = (columns.start / COLUMNS, columns.end.div_ceil(COLUMNS));
            self.is_stale[row * self.across + from..row * self.across + to].fill(true);
        }
    }

    /// Returns whether every pixel in these rows and columns has a hit nearer than `nearest`.
    #[inline(always)]
    pub(crate) fn hides(
        &mut self,
        t: &[f32],
        rows: &Range<usize>,
        columns: &Range<usize>,
        nearest: f32,
    ) -> bool {
        let down = rows.start / ROWS..rows.end.div_ceil(ROWS);
        let across = columns.start / COLUMNS..columns.end.div_ceil(COLUMNS);
        if down.len() * across.len() > MOST {
            return false;
        }
        for row in down {
            for column in across.clone() {
                if !self.is_hidden(t, (row, column), nearest) {
                    return false;
                }
            }
        }
        true
    }

    /// Trims the columns of a strip: removes the rectangles at its two ends in which every pixel has a
    /// hit nearer than `nearest`.
    #[inline(always)]
    pub(crate) fn seen(
        &mut self,
        t: &[f32],
        strip: &Range<usize>,
        columns: &Range<usize>,
        nearest: f32,
    ) -> Range<usize> {
        let row = strip.start / ROWS;
        let (mut first, mut end) = (columns.start / COLUMNS, columns.end.div_ceil(COLUMNS));
        while first < end && self.is_hidden(t, (row, first), nearest) {
            first += 1;
        }
        while first < end && self.is_hidden(t, (row, end - 1), nearest) {
            end -= 1;
        }
        columns.start.max(first * COLUMNS)..columns.end.min(end * COLUMNS)
    }

    /// Returns whether every pixel of a rectangle has a hit nearer than `nearest`.
    #[inline(always)]
    fn is_hidden(&mut self, t: &[f32], (row, column): (usize, usize), nearest: f32) -> bool {
        let cell = row * self.across + column;
        if self.is_stale[cell] && self.farthest[cell] >= nearest {
            self.look(t, row, column);
        }
        self.farthest[cell] < nearest
    }

    /// Computes the farthest `t` of a rectangle.
    #[inline(always)]
    fn look(&mut self, t: &[f32], row: usize, column: usize) {
        let columns = column * COLUMNS..((column + 1) * COLUMNS).min(self.width);
        let mut farthest = [0.0_f32; COLUMNS];
        for row in row * ROWS..((row + 1) * ROWS).min(self.height) {
            let start = row * self.width;
            let of_row = &t[start + columns.start..start + columns.end];
            if let Some(of_row) = of_row.first_chunk::<COLUMNS>() {
                for (farthest, t) in farthest.iter_mut().zip(of_row) {
                    *farthest = farther(*t, *farthest);
                }
            } else {
                farthest[0] = of_row.iter().copied().fold(farthest[0], farther);
            }
        }
        let cell = row * self.across + column;
        self.farthest[cell] = farthest.into_iter().fold(0.0, farther);
        self.is_stale[cell] = false;
    }
}

/// Splits rows of a band into strips, each of which lies in one row of rectangles.
pub(crate) fn strips(rows: &Range<usize>) -> impl Iterator<Item = Range<usize>> + use<> {
    let Range { start, end } = *rows;
    (start - start % ROWS..end).step_by(ROWS).map(move |row| row.max(start)..(row + ROWS).min(end))
}

/// Returns the larger of two numbers, neither of which may be NaN.
#[inline(always)]
fn farther(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
