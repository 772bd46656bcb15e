//! Planes: implicit function, and intersection with a ray.

use glam::DVec3;

use crate::ray::Ray;
use crate::scale::{ldexp, split, unit};
use crate::sphere::Roots;

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
    /// that the normal points to.
    pub fn implicit(&self, q: DVec3) -> f64 {
        self.normal.dot(q - self.point)
    }

    /// The intersection's parts for the readouts, in plain `f64` of the values as they are.
    pub fn terms(&self, ray: &Ray) -> PlaneTerms {
        PlaneTerms {
            rate: self.normal.dot(ray.direction),
            offset: self.normal.dot(self.point - ray.origin),
        }
    }

    /// Where the ray's line meets the plane: once, or not at all if it is parallel (even inside
    /// the plane).
    pub fn roots(&self, ray: &Ray) -> Roots {
        PlaneSeen::new(self, ray.origin).roots(ray.direction)
    }

    /// The point `p + t d` and the unit normal.
    pub fn point_and_normal(&self, ray: &Ray, t: f64) -> (DVec3, DVec3) {
        (ray.at(t), unit(self.normal))
    }
}

/// What the rays of one origin share of a plane.
pub(crate) struct PlaneSeen {
    /// The normal, scaled by a power of two to a length near 1.
    normal: DVec3,
    /// `normal . (point - origin) * 2^-scale`
    offset: f64,
    scale: i32,
}

impl PlaneSeen {
    pub(crate) fn new(plane: &Plane, origin: DVec3) -> PlaneSeen {
        let (normal, _) = split(plane.normal);
        let mut to_plane = plane.point - origin;
        let mut scale = 0;
        if !to_plane.is_finite() {
            to_plane = 0.5 * plane.point - 0.5 * origin;
            scale = 1;
        }
        if to_plane != DVec3::ZERO {
            let (near_one, k) = split(to_plane);
            to_plane = near_one;
            scale += k;
        }
        PlaneSeen { normal, offset: normal.dot(to_plane), scale }
    }

    pub(crate) fn roots(&self, direction: DVec3) -> Roots {
        // Powers of two cancel in the quotient: taking them out changes no bit of an ordinary t.
        let (direction, k) = if (1e-100..1e100).contains(&direction.abs().max_element()) {
            (direction, 0)
        } else {
            split(direction)
        };
        let rate = self.normal.dot(direction);
        if rate == 0.0 {
            Roots::None
        } else {
            Roots::One(ldexp(self.offset / rate, self.scale - k))
        }
    }
}
