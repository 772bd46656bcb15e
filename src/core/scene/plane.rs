//! Planes: implicit function, and intersection with a ray.

use std::cmp::Ordering;

use glam::DVec3;

use crate::camera::exact_ray::ExactRay;
use crate::camera::ray::Ray;
use crate::exact::dyadic::{Dyadic, cross, exact3};
use crate::exact::scale::unit;
use crate::scene::object_from_origin::ObjectSeen;
use crate::scene::plane_predicates::PlaneSeen;
use crate::scene::roots::Roots;

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

impl PlaneTerms {
    const NONE: PlaneTerms = PlaneTerms { rate: f64::NAN, offset: f64::NAN };
}

impl Plane {
    /// The implicit function `f(q) = normal . (q - point)`: 0 on the plane, positive on the side
    /// that the normal points to, both exactly. In world units times the normal's length; infinite
    /// where it overflows, NaN where a number is not finite or the normal is zero.
    pub fn implicit(&self, q: DVec3) -> f64 {
        if self.check().is_err() || !q.is_finite() {
            return f64::NAN;
        }
        // Subtracted from 0, not negated: on the plane it is 0, not -0.
        0.0 - PlaneSeen::new(self, q).offset_given()
    }

    /// The intersection's parts for the readouts, each rounded once from more digits. They may
    /// overflow or underflow where `t` does not; of a ray or a plane that is none, they are NaN.
    pub fn terms(&self, ray: &Ray) -> PlaneTerms {
        match ExactRay::of(ray) {
            Ok(ray) => self.terms_of(&ray),
            Err(_) => PlaneTerms::NONE,
        }
    }

    /// [`Plane::terms`] of a ray with all its digits.
    pub fn terms_of(&self, ray: &ExactRay) -> PlaneTerms {
        if self.check().is_err() {
            return PlaneTerms::NONE;
        }
        let seen = PlaneSeen::up_to(self, ray.origin(), ray.last);
        PlaneTerms { rate: seen.rate_given(ray), offset: seen.offset_given() }
    }

    /// Whether both are the same set of points, exactly: the normals are parallel, and each plane's
    /// point lies in the other. What does not pass [`Plane::check`] is no set of points.
    pub fn is_same(&self, other: &Plane) -> bool {
        if self.check().is_err() || other.check().is_err() {
            return false;
        }
        // Most planes differ by far more than rounding: the exact numbers are for those that do not.
        let (n, m) = (unit(self.normal), unit(other.normal));
        if n.cross(m).length_squared() > 1e-20 {
            return false;
        }
        if PlaneSeen::new(self, other.point).side != Ordering::Equal {
            return false;
        }
        let normals = cross(&exact3(self.normal), &exact3(other.normal));
        normals.iter().all(Dyadic::is_zero)
    }

    /// Where the ray's line meets the plane, decided exactly for the numbers as given: once, or not
    /// at all if it is parallel (even inside the plane); nowhere for a ray that does not pass
    /// [`Ray::check`], or a plane that does not pass [`Plane::check`]. `t` is within half an ulp, and
    /// 2^-40 of one.
    pub fn roots(&self, ray: &Ray) -> Roots {
        ExactRay::of(ray).map_or(Roots::None, |ray| self.roots_of(&ray))
    }

    /// [`Plane::roots`] of a ray with all its digits.
    pub fn roots_of(&self, ray: &ExactRay) -> Roots {
        if self.check().is_err() {
            return Roots::None;
        }
        ObjectSeen::Plane(PlaneSeen::up_to(self, ray.origin(), ray.last)).roots(ray)
    }
}
