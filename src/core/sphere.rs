//! Spheres: implicit function, and intersection with a ray.

use glam::DVec3;

use crate::exact_ray::ExactRay;
use crate::ray::Ray;
use crate::roots::Roots;
use crate::scale::ldexp;
use crate::seen::ObjectSeen;
use crate::sphere_seen::SphereSeen;

/// All points at distance `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// The centre c.
    pub center: DVec3,
    /// The radius r, greater than 0.
    pub radius: f64,
}

/// The quadratic that a ray makes of a sphere's equation, `a t^2 + 2 b t + c = 0`, with
///
/// ```text
/// a = d.d     b = d.(p - center)     c = |p - center|^2 - r^2     D = b^2 - a c
/// ```
///
/// so that `t = (-b -+ sqrt D) / a`. Here b is *half* the linear coefficient; the textbook's
/// `b^2 - 4ac` is four times this D.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereQuadratic {
    /// `d.d`
    pub a: f64,
    /// `d.(p - center)`, half the linear coefficient.
    pub b: f64,
    /// `|p - center|^2 - r^2`: negative inside the sphere, 0 on it.
    pub c: f64,
    /// `b^2 - a c`; from farther out than `sqrt(2) r` computed as `r^2 a - |(p - center) x d|^2`,
    /// which is equal (Lagrange's identity). Negative, 0 or positive exactly where it is.
    pub discriminant: f64,
}

impl SphereQuadratic {
    const NONE: SphereQuadratic =
        SphereQuadratic { a: f64::NAN, b: f64::NAN, c: f64::NAN, discriminant: f64::NAN };
}

impl Sphere {
    /// The implicit function `f(q) = |q - center|^2 - r^2`: 0 on the sphere, negative inside, both
    /// exactly. In squared world units; infinite where it overflows, NaN where a number is not finite
    /// or the radius not positive.
    pub fn implicit(&self, q: DVec3) -> f64 {
        if self.check().is_err() || !q.is_finite() {
            return f64::NAN;
        }
        let seen = SphereSeen::new(self, q);
        ldexp(seen.fine.c.hi, 2 * seen.scale)
    }

    /// The quadratic's parts for the readouts, each rounded once from more digits. They may overflow
    /// or underflow where the roots do not; of a ray or a sphere that is none, they are NaN.
    pub fn quadratic(&self, ray: &Ray) -> SphereQuadratic {
        match ExactRay::of(ray) {
            Ok(ray) => self.quadratic_of(&ray),
            Err(_) => SphereQuadratic::NONE,
        }
    }

    /// [`Sphere::quadratic`] of a ray with all its digits.
    pub fn quadratic_of(&self, ray: &ExactRay) -> SphereQuadratic {
        if self.check().is_err() {
            return SphereQuadratic::NONE;
        }
        let seen = SphereSeen::up_to(self, ray.origin(), ray.last);
        let (a, b, c, discriminant) = seen.quadratic(ray);
        let (k, stretch) = (ray.scale, ray.stretch);
        let scaled = ldexp(discriminant / stretch / stretch, 2 * (k + seen.scale));
        // What underflows keeps its sign.
        let least = if discriminant == 0.0 { 0.0 } else { f64::from_bits(1) };
        SphereQuadratic {
            a: ldexp(a / stretch / stretch, 2 * k),
            b: 0.0 - ldexp(b / stretch, k + seen.scale),
            c: ldexp(c, 2 * seen.scale),
            discriminant: scaled.abs().max(least).copysign(discriminant),
        }
    }

    /// `sqrt D` of [`Sphere::quadratic_of`], also where D itself is out of range; `None` where D is
    /// negative, and of a sphere that is none. Infinite where it overflows.
    pub fn root_of_discriminant_of(&self, ray: &ExactRay) -> Option<f64> {
        self.check().ok()?;
        let seen = SphereSeen::up_to(self, ray.origin(), ray.last);
        let (.., discriminant) = seen.quadratic(ray);
        (discriminant >= 0.0)
            .then(|| ldexp(discriminant.sqrt() / ray.stretch, ray.scale + seen.scale))
    }

    /// Where the ray's line meets the sphere, decided exactly for the numbers as given; nowhere for
    /// a ray that does not pass [`Ray::check`], or a sphere that does not pass [`Sphere::check`]. Each
    /// `t` is within half an ulp, and 2^-40 of one.
    pub fn roots(&self, ray: &Ray) -> Roots {
        ExactRay::of(ray).map_or(Roots::None, |ray| self.roots_of(&ray))
    }

    /// [`Sphere::roots`] of a ray with all its digits.
    pub fn roots_of(&self, ray: &ExactRay) -> Roots {
        if self.check().is_err() {
            return Roots::None;
        }
        ObjectSeen::Sphere(SphereSeen::up_to(self, ray.origin(), ray.last)).roots(ray)
    }
}
