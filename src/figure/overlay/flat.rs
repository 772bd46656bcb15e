//! A plane in the world, as the observer sees it: maps screen pixels to points of the plane without tracing
//! rays.

use std::ops::Range;

use pinhole_core::{DVec2, DVec3, PixelRays};

use crate::overlay::screen::unit;

/// A plane with coordinates (a, b), as the observer sees it.
///
/// The observer's ray through the screen position (x, y) has the direction
/// `d = x*across + y*down + corner`, with three constant vectors. With the plane's origin O, its normal n,
/// and the vectors A and B along which a and b are measured, the ray meets the plane at
///
/// ```text
/// t = n.(O - eye) / n.d     a = A.(eye - O + t d)     b = B.(eye - O + t d)
/// ```
///
/// Since d is linear in x and y, each of t, a and b is a quotient of two linear functions of x and y. Their
/// numerators are `offset`, `a` and `b`, and their common denominator is `rate`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Flat {
    /// The numerator of t, which is greater than 0. A pixel's ray therefore meets the plane in front of the
    /// observer exactly where `rate` is greater than 0.
    offset: f64,
    rate: Linear,
    a: Linear,
    b: Linear,
}

/// The point where one screen pixel's ray meets a [`Flat`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FlatSpot {
    /// The t of the observer's ray, greater than 0.
    pub(crate) t: f64,
    /// The coordinates (a, b) in the plane.
    pub(crate) position: DVec2,
}

/// The linear function `x*X + y*Y + Z` of a screen position (x, y), stored as (X, Y, Z).
#[derive(Clone, Copy, Debug, PartialEq)]
struct Linear(DVec3);

impl Linear {
    fn new(rays: &PixelRays, vector: DVec3) -> Linear {
        Linear(DVec3::new(vector.dot(rays.across), vector.dot(rays.down), vector.dot(rays.corner)))
    }

    fn at(self, dot: DVec2) -> f64 {
        self.0.x * dot.x + self.0.y * dot.y + self.0.z
    }
}

impl Flat {
    /// Creates the plane through `origin` in which the coordinate a increases by 1 along the vector `a`,
    /// and b by 1 along the vector `b`. The vectors must be orthogonal. Returns `None` if the numbers leave
    /// the range of `f64`, or if the observer lies in the plane.
    pub(crate) fn new(rays: &PixelRays, origin: DVec3, a: DVec3, b: DVec3) -> Option<Flat> {
        let (unit_a, unit_b) = (unit(a)?, unit(b)?);
        let normal = unit_a.cross(unit_b);
        let from_origin = rays.eye - origin;
        let offset = -normal.dot(from_origin);
        let rate = Linear::new(rays, normal);
        // The quotients stay the same if all four functions are multiplied by the same factor. This one
        // keeps their values near 1, since rows of screen pixels are computed in `f32`.
        let scale = offset.signum() / rate.0.abs().max_element();
        let numerator = |direction: DVec3, length: f64| {
            let along = direction / length;
            let sum = along.dot(from_origin) * rate.0 + offset * Linear::new(rays, along).0;
            Linear(sum * scale)
        };
        let flat = Flat {
            offset: offset * scale,
            rate: Linear(rate.0 * scale),
            a: numerator(unit_a, a.length()),
            b: numerator(unit_b, b.length()),
        };
        let finite = flat.offset.is_finite()
            && [flat.rate, flat.a, flat.b].iter().all(|linear| linear.0.is_finite());
        (finite && flat.offset > 0.0).then_some(flat)
    }

    /// Returns the point where the ray through a screen position meets the plane. Returns `None` if the
    /// point is not in front of the observer, or if `|a|` or `|b|` is greater than `half`.
    pub(crate) fn at(&self, dot: DVec2, half: f64) -> Option<FlatSpot> {
        let rate = self.rate.at(dot);
        let position = DVec2::new(self.a.at(dot), self.b.at(dot));
        if !(rate > 0.0 && position.abs().max_element() <= half * rate) {
            return None;
        }
        let (t, position) = (self.offset / rate, position / rate);
        (t > 0.0 && t.is_finite() && position.is_finite()).then_some(FlatSpot { t, position })
    }

    /// Returns the range of screen pixels in a row for which [`Flat::at`] finds a point. Each end may be
    /// off by one pixel.
    pub(crate) fn span(&self, y: f64, width: usize, half: f64) -> Range<usize> {
        // Each condition on x is linear: value + slope x >= 0.
        let reach = half * self.rate.0;
        let conditions =
            [self.rate.0, reach - self.a.0, reach + self.a.0, reach - self.b.0, reach + self.b.0];
        let (mut from, mut to) = (0.0f64, width as f64);
        for condition in conditions {
            let (slope, value) = (condition.x, condition.y * y + condition.z);
            let zero = -value / slope;
            if slope > 0.0 {
                from = from.max(zero);
            } else if slope < 0.0 {
                to = to.min(zero);
            } else if value < 0.0 || value.is_nan() {
                return 0..0;
            }
        }
        // Neither bound is NaN, since `max` and `min` ignore NaN.
        let to = (to.ceil() as usize).min(width);
        (from as usize).min(to)..to
    }

    /// Computes a part of a row of screen pixels: for each pixel, the result of [`Flat::at`] and the
    /// fraction of the pixel that grid lines cover. The loops over `f32` are kept simple so that the
    /// compiler can vectorize them.
    pub(crate) fn fill_row(
        &self,
        row: &mut FlatRow,
        y: f64,
        part: &Range<usize>,
        half: f64,
        grid: Option<&Grid>,
    ) {
        let span = self.span(y, part.end, half);
        let start = span.start.max(part.start);
        let span = start..span.end.max(start);
        row.resize(&span);
        let first = DVec2::new(span.start as f64 + 0.5, y);
        let terms = |linear: Linear| (linear.at(first) as f32, linear.0.x as f32);
        let (rate, a, b, offset) =
            (terms(self.rate), terms(self.a), terms(self.b), self.offset as f32);
        let values = row.t.iter_mut().zip(&mut row.a).zip(&mut row.b).zip(&mut row.inverse_rate);
        for (k, (((t_of, a_of), b_of), inverse_of)) in values.enumerate() {
            let x = k as f32;
            let inverse = 1.0 / (rate.0 + rate.1 * x);
            *inverse_of = inverse;
            *t_of = offset * inverse;
            *a_of = (a.0 + a.1 * x) * inverse;
            *b_of = (b.0 + b.1 * x) * inverse;
        }
        if let Some(grid) = grid {
            self.cover(&mut row.line, &row.a, &row.inverse_rate, self.a, &grid.of_a);
            self.cover(&mut row.line, &row.b, &row.inverse_rate, self.b, &grid.of_b);
        }
    }

    /// Adds the grid lines that are perpendicular to one coordinate's axis. Where they cover more of a pixel
    /// than `line` says, `line` is raised.
    fn cover(
        &self,
        line: &mut [f32],
        position: &[f32],
        inverse_rate: &[f32],
        numerator: Linear,
        lines: &Lines,
    ) {
        // Changes of the coordinate's numerator and of `rate` per screen pixel to the right and down.
        let (n, r) = (numerator.0.as_vec3(), self.rate.0.as_vec3());
        let reach = 0.5 * lines.width + 0.5;
        let sparse = 1.0 / (3.0 * lines.width);
        for ((line, position), inverse_rate) in line.iter_mut().zip(position).zip(inverse_rate) {
            let (across, down) = (n.x - position * r.x, n.y - position * r.y);
            let per_dot =
                (across * across + down * down).sqrt() * inverse_rate * lines.inverse_step;
            let cells = (position - lines.shift) * lines.inverse_step;
            // Adding and subtracting 1.5 * 2^23 rounds to an integer without a function call.
            let whole = (cells + 12_582_912.0) - 12_582_912.0;
            let dots_per_cell = 1.0 / per_dot.max(1e-30);
            let near = (reach - (cells - whole).abs() * dots_per_cell).clamp(0.0, 1.0);
            let distinct = (dots_per_cell * sparse - 1.0).clamp(0.0, 1.0);
            *line = line.max(near * distinct);
        }
    }
}

/// The screen pixels of one row whose rays meet a [`Flat`], with the values at each of them.
#[derive(Clone, Debug, Default)]
pub(crate) struct FlatRow {
    /// The range of these pixels in the row.
    pub(crate) span: Range<usize>,
    pub(crate) t: Vec<f32>,
    pub(crate) a: Vec<f32>,
    pub(crate) b: Vec<f32>,
    /// Fraction of each screen pixel that grid lines cover, 0 to 1. It fades to 0 where the lines are too
    /// dense to be distinguished.
    pub(crate) line: Vec<f32>,
    inverse_rate: Vec<f32>,
}

impl FlatRow {
    fn resize(&mut self, span: &Range<usize>) {
        for values in
            [&mut self.t, &mut self.a, &mut self.b, &mut self.line, &mut self.inverse_rate]
        {
            values.clear();
            values.resize(span.len(), 0.0);
        }
        self.span = span.clone();
    }

    /// Returns a, b and the coverage by grid lines at index `k` of the span.
    #[inline(always)]
    pub(crate) fn spot(&self, k: usize) -> [f32; 3] {
        [self.a[k], self.b[k], self.line[k]]
    }

    /// Returns t and (a, b, coverage by grid lines) for each screen pixel in `part` of the row.
    pub(crate) fn spots(&self, part: Range<usize>) -> impl Iterator<Item = (f32, [f32; 3])> {
        let part = part.start - self.span.start..part.end - self.span.start;
        let values = self.t[part.clone()].iter().zip(&self.a[part.clone()]);
        let values = values.zip(&self.b[part.clone()]).zip(&self.line[part]);
        values.map(|(((t, a), b), line)| (*t, [*a, *b, *line]))
    }
}

/// Grid lines where the coordinate a or b differs by a multiple of a step from that of one crossing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grid {
    of_a: Lines,
    of_b: Lines,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Lines {
    inverse_step: f32,
    shift: f32,
    /// Width in screen pixels.
    width: f32,
}

impl Grid {
    /// Creates grid lines that are `width` screen pixels wide. `shift` is the (a, b) of one crossing.
    pub(crate) fn new(step: DVec2, shift: DVec2, width: f32) -> Grid {
        let lines = |step: f64, shift: f64| Lines {
            inverse_step: (1.0 / step) as f32,
            shift: shift as f32,
            width,
        };
        Grid { of_a: lines(step.x, shift.x), of_b: lines(step.y, shift.y) }
    }
}
