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
    /// How much a and b change, at most, from one dot to the next.
    pub(crate) per_dot: DVec2,
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

    /// Where the ray through a dot meets the plane, if it does in front of the observer.
    pub(crate) fn at(&self, dot: DVec2) -> Option<FlatSpot> {
        let rate = self.rate.at(dot);
        let t = self.offset / rate;
        if !(t > 0.0 && t.is_finite()) {
            return None;
        }
        let place = DVec2::new(self.a.at(dot), self.b.at(dot)) / rate;
        let slope = |numerator: Linear, value: f64| {
            let change = numerator.0.truncate() - value * self.rate.0.truncate();
            (change / rate).length()
        };
        let per_dot = DVec2::new(slope(self.a, place.x), slope(self.b, place.y));
        Some(FlatSpot { t, place, per_dot })
    }
}

impl FlatSpot {
    /// How much of the dot a grid line covers, 0 to 1: lines `width` dots wide at all whole
    /// multiples of `step` from `shift`. Lines too dense to be told apart fade away.
    pub(crate) fn grid_coverage(&self, step: DVec2, shift: DVec2, width: f64) -> f64 {
        let cover = |place: f64, step: f64, per_dot: f64| {
            let cells = place / step;
            let dots_per_cell = step / per_dot;
            let off = (cells - cells.round()).abs() * dots_per_cell;
            let line = (0.5 * width + 0.5 - off).clamp(0.0, 1.0);
            line * (dots_per_cell / (3.0 * width) - 1.0).clamp(0.0, 1.0)
        };
        let place = self.place - shift;
        let covered =
            cover(place.x, step.x, self.per_dot.x).max(cover(place.y, step.y, self.per_dot.y));
        if covered.is_nan() { 0.0 } else { covered }
    }
}
