//! An object's implicit function along a ray, which is 0 at the ray's roots.

use crate::camera::ray::ExactRay;
use crate::exact::bounded::{Number, Vector, dot, length, near};
use crate::exact::double_double::DoubleDouble;
use crate::exact::precise::Precise;
use crate::exact::scale::{exponent, ldexp};
use crate::scene::error::ObjectError;
use crate::scene::object::Object;
use crate::scene::object_from_origin::ObjectFromOrigin;
use crate::scene::plane_predicates::PlaneFromOrigin;
use crate::scene::sphere_predicates::SphereFromOrigin;

/// The implicit function of an object at the point `p + t d` of a ray, as a function of t:
///
/// ```text
/// sphere:  f(t) = |p + t d - center|^2 - r^2 = a t^2 + 2 b t + c     a parabola
/// plane:   f(t) = n . (p + t d - point)                              a straight line
/// ```
///
/// (Marschner, Shirley, *Fundamentals of Computer Graphics*, 4th ed., sections 2.5.3 and 4.4.) Here n is
/// the plane's normal; a, b and c are those of [`SphereQuadratic`](crate::SphereQuadratic). The zeros of
/// f are the ray's roots, the `t` at which its line meets the object. f is negative inside a sphere, and
/// on the side of a plane that the normal points away from.
///
/// ```
/// use pinhole_core::*;
/// let ball = Object::Sphere(Sphere::new([0.0, 0.0, -5.0], 1.0)?);
/// let ray = Ray::new([0.0; 3], [0.0, 0.0, -1.0])?;
/// let along = AlongRay::new(&ball, ExactRay::from_ray(&ray)?)?;
/// assert_eq!([3.0, 4.0, 5.0, 6.0, 7.0].map(|t| along.value(t)), [3.0, 0.0, -1.0, 0.0, 3.0]);
/// assert_eq!(along.slope(4.0), -2.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct AlongRay<'a> {
    ray: ExactRay<'a>,
    seen: ObjectFromOrigin,
}

/// The lowest point of the parabola f(t) of a sphere ([`AlongRay`]), where the ray's line is nearest to
/// the sphere's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParabolaVertex {
    /// The `t` of the vertex, `-b / a`, where the derivative is 0.
    pub t: f64,
    /// f at the vertex, `-D / a` with the discriminant D: negative if the line crosses the sphere, 0 if
    /// it touches the sphere. It is at least `-r^2`, in squared world units.
    pub value: f64,
}

/// Maximum relative error of a value before it is rounded: 2^-60, so that the rounded value is within
/// half an ulp plus 2^-7 of an ulp.
const ENOUGH: f64 = 1.0 / (1_u64 << 60) as f64;

/// Range of the magnitude of a scaled `t` in which double-double neither overflows nor loses digits to
/// underflow.
const PLAIN_TIMES: std::ops::Range<f64> = 1e-90..1e90;

impl<'a> AlongRay<'a> {
    /// Creates the function of one object along one ray.
    ///
    /// # Errors
    /// Returns an error if the object is invalid, see [`Object::check`].
    pub fn new(object: &Object, ray: ExactRay<'a>) -> Result<AlongRay<'a>, ObjectError> {
        object.check()?;
        Ok(AlongRay { seen: ObjectFromOrigin::new(object, ray.origin()), ray })
    }

    /// Returns f(t), within half an ulp plus 2^-7 of an ulp of the exact value for the ray's inputs,
    /// even next to a root, where the formulas cancel. The sign is exact, and the value is 0 only where
    /// f is. For a sphere it is in squared world units, for a plane in world units times the normal's
    /// length. The value is infinite if it overflows. An infinite t gives the limit; NaN gives NaN.
    ///
    /// The value is computed in double-double with an error bound. Where that does not suffice (within
    /// about 1e-13 of a root), it is computed in exact numbers, which takes some 40 microseconds.
    pub fn value(&self, t: f64) -> f64 {
        if !t.is_finite() {
            return self.limit(t);
        }
        let sure = match &self.seen {
            ObjectFromOrigin::Sphere(seen) => self.sphere_value(seen, t),
            ObjectFromOrigin::Plane(seen) => self.plane_value(seen, t),
        };
        let value = sure.unwrap_or_else(|| match &self.seen {
            ObjectFromOrigin::Sphere(seen) => self.ray.big().sphere_value(&seen.sphere, t),
            ObjectFromOrigin::Plane(seen) => self.ray.big().plane_value(&seen.plane, t),
        });
        value.to_f64()
    }

    /// Returns f'(t): `2 (a t + b)` for a sphere, the constant `n . d` for a plane. It is computed with
    /// more digits, then rounded; infinite if it overflows. An infinite t gives the limit; NaN gives
    /// NaN.
    pub fn slope(&self, t: f64) -> f64 {
        let seen = match &self.seen {
            ObjectFromOrigin::Plane(seen) => return seen.rate_given(&self.ray),
            // The limit is infinite, with the sign of t.
            ObjectFromOrigin::Sphere(_) if !t.is_finite() => return t,
            ObjectFromOrigin::Sphere(seen) => seen,
        };
        match self.offset_from_center(seen, t) {
            Some((offset, _)) => {
                let along = dot(offset, self.ray.fine.d) / self.stretch();
                2.0 * ldexp(along.hi, seen.scale + self.ray.scale)
            }
            None => self.ray.big().sphere_slope(&seen.sphere, t).to_f64(),
        }
    }

    /// Returns the point at which a sphere's f is least; `None` for a plane, whose f has no minimum.
    pub fn vertex(&self) -> Option<ParabolaVertex> {
        let ObjectFromOrigin::Sphere(seen) = &self.seen else { return None };
        let (d, q) = (self.ray.fine.d, seen.fine.q);
        let (a, b) = (dot(d, d), dot(q, d));
        let t = (b / a).times(self.ray.stretch).hi;
        // The discriminant has its exact sign; a and D are in the same units of the direction.
        let (.., discriminant) = seen.quadratic(&self.ray);
        Some(ParabolaVertex {
            t: ldexp(t, seen.scale - self.ray.scale) + 0.0,
            value: 0.0 - ldexp(discriminant / a.hi, 2 * seen.scale),
        })
    }

    fn stretch(&self) -> DoubleDouble {
        DoubleDouble::from(self.ray.stretch)
    }

    /// Returns `p + t d - center` in units of `2^(scale of the sphere)`, and its error bound. Returns
    /// `None` if it would overflow or underflow.
    fn offset_from_center(
        &self,
        seen: &SphereFromOrigin,
        t: f64,
    ) -> Option<(Vector<DoubleDouble>, f64)> {
        type T = DoubleDouble;
        let (ray, q) = (&self.ray, seen.fine.q);
        let t = self.scaled_time(t, ray.scale - seen.scale)?;
        let reach = t.hi.abs() * ray.fine.length;
        // t d has the error of d and those of a quotient and a product; the difference adds that of a
        // sum.
        let share = ray.fine.doubt + T::QUOTIENT + T::PRODUCT + T::SUM;
        let doubt = 1.05 * (reach * share + seen.fine.distance * (seen.fine.q_doubt + T::SUM));
        Some((std::array::from_fn(|i| ray.fine.d[i] * t - q[i]), doubt))
    }

    /// Returns `t 2^k / stretch`, with the factor `stretch` of the ray's direction; or `None` if the
    /// result is neither 0 nor of a magnitude in [`PLAIN_TIMES`].
    fn scaled_time(&self, t: f64, k: i32) -> Option<DoubleDouble> {
        if t == 0.0 {
            return Some(DoubleDouble::default());
        }
        if !t.is_finite() {
            return None;
        }
        let own = exponent(t);
        let magnitude = ldexp(1.0, own + k);
        let is_plain = PLAIN_TIMES.contains(&magnitude);
        let mantissa = DoubleDouble::from(ldexp(t, -own)) / self.stretch();
        is_plain.then(|| mantissa.scaled(own + k))
    }

    /// Returns `|e|^2 - r^2` with e = p + t d - center, or `None` if double-double does not suffice.
    fn sphere_value(&self, seen: &SphereFromOrigin, t: f64) -> Option<Precise> {
        type T = DoubleDouble;
        let (offset, off) = self.offset_from_center(seen, t)?;
        let radius = seen.fine.radius;
        let (ee, rr) = (dot(offset, offset), radius * radius);
        let value = ee - rr;
        let doubt = (2.0 * length(near(offset)) + off) * off
            + (T::DOT + T::SUM) * ee.hi
            + (T::PRODUCT + T::SUM) * rr.hi;
        is_sure(value, 1.05 * doubt).then_some(Precise::new(value, 2 * seen.scale))
    }

    /// Returns `n . d t - n . (point - p)`, or `None` if double-double does not suffice.
    fn plane_value(&self, seen: &PlaneFromOrigin, t: f64) -> Option<Precise> {
        type T = DoubleDouble;
        let normal = seen.normal.map(T::from);
        let t = self.scaled_time(t, self.ray.scale - seen.scale)?;
        let rate = dot(normal, self.ray.fine.d);
        let reach = length(seen.normal) * self.ray.fine.length * t.hi.abs();
        let value = rate * t - seen.offset;
        let doubt = (self.ray.fine.doubt + T::DOT + T::QUOTIENT + T::PRODUCT + T::SUM) * reach
            + (seen.offset_doubt + T::SUM) * seen.offset.hi.abs();
        is_sure(value, 1.05 * doubt).then_some(Precise::new(value, seen.scale + seen.normal_scale))
    }

    /// Returns the limit of f at an infinite t, which is infinite unless the ray is parallel to a plane,
    /// where f is constant. NaN gives NaN.
    fn limit(&self, t: f64) -> f64 {
        if t.is_nan() {
            return t;
        }
        match &self.seen {
            ObjectFromOrigin::Sphere(_) => f64::INFINITY,
            ObjectFromOrigin::Plane(_) => match self.slope(t) {
                0.0 => self.value(0.0),
                slope => slope * t,
            },
        }
    }
}

/// Returns whether a value's error bound `doubt` is at most [`ENOUGH`] times the value, and the value
/// far enough from 0 and infinity that nothing has underflowed or overflowed.
fn is_sure(value: DoubleDouble, doubt: f64) -> bool {
    let magnitude = value.hi.abs();
    magnitude > 1e-200 && magnitude < 1e250 && doubt <= ENOUGH * magnitude
}
