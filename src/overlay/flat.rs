//! A plane of the world as the observer sees it: from dots to places on the plane, without tracing.

use pinhole_core::{DVec2, DVec3};

use crate::overlay::screen::{RayParts, unit};

/// A plane with two coordinates on it, a and b.
///
/// The ray through the dot (x, y) has the direction `d = x*across + y*down + corner`. With the
/// plane's origin O and normal n it meets the plane at
///
/// ```text
/// t = n.(O - eye) / n.d     a = A.(eye - O + t d)     b = B.(eye - O + t d)
/// ```
///
/// and since d is linear in x and y, t, a and b are quotients of linear functions of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flat {
    offset: f64,
    rate: Linear,
    a: Linear,
    b: Linear,
}

/// Where one dot's ray meets a [`Flat`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FlatSpot {
    /// t of the observer's ray; greater than 0.
    pub(crate) t: f64,
    /// (a, b).
    pub(crate) place: DVec2,
    /// `1 / n.d`.
    inverse_rate: f64,
}

/// The part of a [`Flat`] that there is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Extent {
    /// `|a|` and `|b|` up to this.
    Square(f64),
    /// `a^2 + b^2` up to this squared.
    Disc(f64),
}

/// `x*X + y*Y + Z`.
#[derive(Clone, Copy, Debug)]
struct Linear(DVec3);

impl Linear {
    fn of(rays: &RayParts, vector: DVec3) -> Linear {
        Linear(DVec3::new(vector.dot(rays.across), vector.dot(rays.down), vector.dot(rays.corner)))
    }

    fn at(self, dot: DVec2) -> f64 {
        self.0.x * dot.x + self.0.y * dot.y + self.0.z
    }
}

impl Flat {
    /// The plane through `origin`, on which a grows by 1 along `axis_a` and b by 1 along `axis_b`;
    /// the two are at right angles. `None` where the numbers leave the range of `f64`.
    pub(crate) fn new(
        rays: &RayParts,
        origin: DVec3,
        axis_a: DVec3,
        axis_b: DVec3,
    ) -> Option<Flat> {
        let (unit_a, unit_b) = (unit(axis_a)?, unit(axis_b)?);
        let normal = unit_a.cross(unit_b);
        let from_origin = rays.eye - origin;
        let offset = -normal.dot(from_origin);
        let rate = Linear::of(rays, normal);
        let numerator = |direction: DVec3, length: f64| {
            let along = direction / length;
            Linear(along.dot(from_origin) * rate.0 + offset * Linear::of(rays, along).0)
        };
        let flat = Flat {
            offset,
            rate,
            a: numerator(unit_a, axis_a.length()),
            b: numerator(unit_b, axis_b.length()),
        };
        let finite = flat.offset.is_finite()
            && [flat.rate, flat.a, flat.b].iter().all(|linear| linear.0.is_finite());
        finite.then_some(flat)
    }

    /// Where the ray through a dot meets this part of the plane, if it does in front of the
    /// observer. Most dots are beside it, and are told so before any division.
    pub(crate) fn at(&self, dot: DVec2, extent: Extent) -> Option<FlatSpot> {
        let rate = self.rate.at(dot);
        let (a, b) = (self.a.at(dot), self.b.at(dot));
        let inside = match extent {
            Extent::Square(half) => a.abs().max(b.abs()) <= half * rate.abs(),
            Extent::Disc(radius) => a * a + b * b <= radius * radius * (rate * rate),
        };
        if !(inside && self.offset * rate > 0.0) {
            return None;
        }
        let inverse_rate = 1.0 / rate;
        let t = self.offset * inverse_rate;
        let place = DVec2::new(a, b) * inverse_rate;
        (t > 0.0 && t.is_finite() && place.is_finite()).then_some(FlatSpot {
            t,
            place,
            inverse_rate,
        })
    }

    /// How much of the dot a grid line covers, 0 to 1. Lines too dense to be told apart fade away.
    pub(crate) fn grid_coverage(&self, spot: &FlatSpot, grid: &Grid) -> f64 {
        let cells = (spot.place - grid.shift) * grid.inverse_step;
        let reach = 0.5 * grid.width + 0.5;
        let cover = |cells: f64, inverse_step: f64, numerator: Linear, place: f64| {
            // Cells per dot, squared: most dots are beside the lines, and need no root to know.
            let change = (numerator.0.truncate() - place * self.rate.0.truncate())
                * (spot.inverse_rate * inverse_step);
            let per_dot = change.length_squared();
            let off = to_whole(cells);
            if !(off * off < reach * reach * per_dot) {
                return 0.0;
            }
            let dots_per_cell = 1.0 / per_dot.sqrt();
            let line = (reach - off * dots_per_cell).clamp(0.0, 1.0);
            line * (dots_per_cell / (3.0 * grid.width) - 1.0).clamp(0.0, 1.0)
        };
        let across = cover(cells.x, grid.inverse_step.x, self.a, spot.place.x);
        let covered = across.max(cover(cells.y, grid.inverse_step.y, self.b, spot.place.y));
        if covered.is_nan() { 0.0 } else { covered }
    }
}

/// Lines at all whole multiples of a step of a and of b.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grid {
    inverse_step: DVec2,
    /// (a, b) of one crossing of lines.
    shift: DVec2,
    /// Of the lines, in dots.
    width: f64,
}

impl Grid {
    pub(crate) fn new(step: DVec2, shift: DVec2, width: f64) -> Grid {
        Grid { inverse_step: 1.0 / step, shift, width }
    }
}

/// How far it is to the nearest whole number. Without a call to `round`, which is no instruction on
/// every processor.
fn to_whole(x: f64) -> f64 {
    let fraction = (x - x as i64 as f64).abs();
    fraction.min(1.0 - fraction).max(0.0)
}
