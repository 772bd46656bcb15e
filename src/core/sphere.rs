//! Spheres: implicit function, and intersection with a ray.

use glam::DVec3;

use crate::ray::Ray;
use crate::scale::{exponent, ldexp, ldexp3, split, unit};

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
    /// `b^2 - a c`, computed as `r^2 a - |(p - center) x d|^2`.
    pub discriminant: f64,
}

/// Where a ray's line meets a surface, ascending.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Roots {
    /// Not at all.
    None,
    /// Once: a tangent, or a plane.
    One(f64),
    /// Twice.
    Two(f64, f64),
}

impl Roots {
    /// The roots in ascending order.
    pub fn iter(self) -> impl Iterator<Item = f64> {
        let (first, second) = match self {
            Roots::None => (None, None),
            Roots::One(t) => (Some(t), None),
            Roots::Two(t0, t1) => (Some(t0), Some(t1)),
        };
        first.into_iter().chain(second)
    }

    /// The smallest root greater than 0 (and within the range of `f64`).
    pub fn first_positive(self) -> Option<f64> {
        self.iter().find(|t| *t > 0.0 && t.is_finite())
    }
}

impl Sphere {
    /// The implicit function `f(q) = |q - center|^2 - r^2`: 0 on the sphere, negative inside.
    pub fn implicit(&self, q: DVec3) -> f64 {
        (q - self.center).length_squared() - self.radius * self.radius
    }

    /// The quadratic's parts for the readouts, in plain `f64` of the values as they are (they may
    /// overflow where the roots do not).
    pub fn quadratic(&self, ray: &Ray) -> SphereQuadratic {
        quadratic(ray.origin - self.center, self.radius, self.implicit(ray.origin), ray.direction)
    }

    /// Where the ray's line meets the sphere.
    pub fn roots(&self, ray: &Ray) -> Roots {
        SphereSeen::new(self, ray.origin).roots(ray.direction)
    }

    /// The point and the outward normal where the ray meets the sphere at `t`:
    /// `n = (p + t d - center) / |..|`, point `center + r n`.
    pub fn point_and_normal(&self, ray: &Ray, t: f64) -> (DVec3, DVec3) {
        let offset = (ray.origin - self.center) + t * ray.direction;
        let normal = if offset.is_finite() && offset != DVec3::ZERO {
            unit(offset)
        } else {
            // The sum overflowed: far out, the direction alone decides.
            unit(t.signum() * ray.direction)
        };
        (self.center + self.radius * normal, normal)
    }
}

/// What the rays of one origin share of a sphere. Lengths are in units of `2^scale`, which is 1 but
/// for extreme spheres.
pub(crate) struct SphereSeen {
    from_center: DVec3,
    radius: f64,
    c: f64,
    scale: i32,
}

/// Lengths within these, and squared directions within their squares, neither overflow nor lose
/// digits to underflow in a discriminant.
const PLAIN_LENGTH: std::ops::Range<f64> = 1e-60..1e60;
const PLAIN_DIRECTION_SQUARED: std::ops::Range<f64> = 1e-120..1e120;

impl SphereSeen {
    pub(crate) fn new(sphere: &Sphere, origin: DVec3) -> SphereSeen {
        let plain = origin - sphere.center;
        let extent = plain.abs().max_element().max(sphere.radius);
        let (from_center, radius, scale) = if PLAIN_LENGTH.contains(&extent) {
            (plain, sphere.radius, 0)
        } else if extent < 1.0 {
            let k = exponent(extent);
            (ldexp3(plain, -k), ldexp(sphere.radius, -k), k)
        } else {
            // Halved first: the difference of two finite numbers may overflow.
            let half = 0.5 * origin - 0.5 * sphere.center;
            let k = exponent(half.abs().max_element().max(0.5 * sphere.radius));
            (ldexp3(half, -k), ldexp(sphere.radius, -k - 1), k + 1)
        };
        let c = from_center.length_squared() - radius * radius;
        SphereSeen { from_center, radius, c, scale }
    }

    /// Where the line from the origin along `direction` meets the sphere.
    pub(crate) fn roots(&self, direction: DVec3) -> Roots {
        if self.scale == 0 && PLAIN_DIRECTION_SQUARED.contains(&direction.length_squared()) {
            return solve(&quadratic(self.from_center, self.radius, self.c, direction));
        }
        let (unit_direction, k) = split(direction);
        let rescaled = |t: f64| ldexp(t, self.scale - k);
        match solve(&quadratic(self.from_center, self.radius, self.c, unit_direction)) {
            Roots::None => Roots::None,
            Roots::One(t) => Roots::One(rescaled(t)),
            Roots::Two(t0, t1) => Roots::Two(rescaled(t0), rescaled(t1)),
        }
    }
}

/// `D` by Lagrange's identity, `a |oc|^2 - (d.oc)^2 = |oc x d|^2`, which puts the cancellation
/// where it does the least harm: grazing rays and distant spheres.
fn quadratic(from_center: DVec3, radius: f64, c: f64, direction: DVec3) -> SphereQuadratic {
    let a = direction.length_squared();
    let b = direction.dot(from_center);
    let discriminant = radius * radius * a - from_center.cross(direction).length_squared();
    SphereQuadratic { a, b, c, discriminant }
}

/// The roots without cancellation: `q = -(b + sign(b) sqrt D)`, `t = q / a` and `t = c / q`
/// (Press et al., *Numerical Recipes*, 3rd ed., section 5.6).
fn solve(quadratic: &SphereQuadratic) -> Roots {
    let SphereQuadratic { a, b, c, discriminant } = *quadratic;
    if discriminant < 0.0 {
        return Roots::None;
    }
    if discriminant == 0.0 {
        return Roots::One(-b / a);
    }
    let q = -(b + discriminant.sqrt().copysign(b));
    let (t0, t1) = (q / a, c / q);
    if t0 <= t1 { Roots::Two(t0, t1) } else { Roots::Two(t1, t0) }
}
