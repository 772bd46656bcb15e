//! Planes: implicit function, and intersection with a ray.

use glam::DVec3;

use crate::error_free::{difference_with_rest, dot2};
use crate::ray::Ray;
use crate::roots::Roots;
use crate::scale::{exponent, is_plain_direction, ldexp, ldexp3, split, unit};

/// All points `q` with `normal . (q - point) = 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Any point of the plane.
    pub point: DVec3,
    /// Any non-zero vector at right angles to it.
    pub normal: DVec3,
}

/// The parts of a ray-plane intersection: `t = offset / rate`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneTerms {
    /// `normal . d`: how fast the ray nears the plane; 0 where it is parallel.
    pub rate: f64,
    /// `normal . (point - p)`: how far there is to go.
    pub offset: f64,
}

impl Plane {
    /// The implicit function `f(q) = normal . (q - point)`: 0 on the plane, positive on the side
    /// that the normal points to. In world units times the normal's length; infinite where it
    /// overflows.
    pub fn implicit(&self, q: DVec3) -> f64 {
        // Subtracted from 0, not negated: on the plane it is 0, not -0.
        0.0 - self.offset_from(q)
    }

    /// The intersection's parts for the readouts: those that [`Plane::roots`] divides. They may
    /// overflow or underflow where `t` does not.
    pub fn terms(&self, ray: &Ray) -> PlaneTerms {
        let (normal, normal_scale) = split(self.normal);
        let (direction, k) = match ray.check() {
            Ok(()) => split(ray.direction),
            Err(_) => (ray.direction, 0),
        };
        PlaneTerms {
            rate: ldexp(normal.dot(direction), normal_scale + k),
            offset: self.offset_from(ray.origin),
        }
    }

    fn offset_from(&self, q: DVec3) -> f64 {
        let seen = PlaneSeen::new(self, q);
        ldexp(seen.offset, seen.scale + split(self.normal).1)
    }

    /// Where the ray's line meets the plane: once, or not at all if it is parallel (even inside
    /// the plane).
    pub fn roots(&self, ray: &Ray) -> Roots {
        PlaneSeen::new(self, ray.origin).roots(ray.direction)
    }

    /// The point and the unit normal where the ray meets the plane at the root `t`: `q = p + t d`,
    /// moved onto the plane along the normal, `q - n (n . (q - point))`, because rounding leaves
    /// `p + t d` beside it.
    pub fn point_and_normal(&self, ray: &Ray, t: f64) -> (DVec3, DVec3) {
        let normal = unit(self.normal);
        let q = ray.at(t);
        let beside = normal.dot(q - self.point);
        (if beside.is_finite() { q - beside * normal } else { q }, normal)
    }
}

/// What the rays of one origin share of a plane.
pub(crate) struct PlaneSeen {
    /// The normal, scaled by a power of two to a largest coordinate near 1.
    normal: DVec3,
    /// `normal . (point - origin)` in units of `2^scale`.
    offset: f64,
    /// 0 but for extreme distances.
    scale: i32,
}

/// Distances within these need no scaling.
const PLAIN_DISTANCE: std::ops::Range<f64> = 1e-100..1e100;

impl PlaneSeen {
    pub(crate) fn new(plane: &Plane, origin: DVec3) -> PlaneSeen {
        let (normal, _) = split(plane.normal);
        let (mut to, mut rest, mut scale) = difference_with_rest(plane.point, origin);
        if to != DVec3::ZERO && !PLAIN_DISTANCE.contains(&to.abs().max_element()) {
            let k = exponent(to.abs().max_element());
            (to, rest, scale) = (ldexp3(to, -k), ldexp3(rest, -k), scale + k);
        }
        let factors = [(normal.x, to.x), (normal.y, to.y), (normal.z, to.z)];
        PlaneSeen { normal, offset: dot2(factors, normal.dot(rest)), scale }
    }

    /// Where the line from the origin along `direction` meets the plane.
    pub(crate) fn roots(&self, direction: DVec3) -> Roots {
        // Powers of two cancel in the quotient: taking them out changes no bit of an ordinary t.
        let (direction, k) = if is_plain_direction(direction) {
            (direction, 0)
        } else if direction.is_finite() && direction != DVec3::ZERO {
            split(direction)
        } else {
            return Roots::None;
        };
        let rate = self.normal.dot(direction);
        if rate == 0.0 {
            return Roots::None;
        }
        let t = self.offset / rate;
        let k = self.scale - k;
        Roots::One(if k == 0 { t } else { ldexp(t, k) }).in_range()
    }

    /// Whether [`PlaneSeen::first_hit_plain`] may be used: `plain` where all directions to come are
    /// [plain](is_plain_direction).
    pub(crate) fn is_plain(&self, plain: bool) -> bool {
        plain && self.scale == 0
    }

    /// The first hit's `t`; infinite where there is none.
    pub(crate) fn first_hit(&self, direction: DVec3) -> f64 {
        self.roots(direction).first_positive().unwrap_or(f64::INFINITY)
    }

    /// [`Roots::first_positive`] of [`PlaneSeen::roots`]; infinite, NaN, zero or negative where there
    /// is none.
    pub(crate) fn first_hit_plain(&self, direction: DVec3) -> f64 {
        self.offset / self.normal.dot(direction)
    }
}
