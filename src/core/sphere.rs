//! Spheres: implicit function, and intersection with a ray.

use glam::DVec3;

use crate::error_free::{difference_with_rest, dot2};
use crate::ray::Ray;
use crate::roots::Roots;
use crate::scale::{
    PLAIN_LENGTH_SQUARED, exponent, is_plain_direction, ldexp, ldexp3, split, unit,
};
use crate::wide;

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
    /// which is equal (Lagrange's identity).
    pub discriminant: f64,
}

impl Sphere {
    /// The implicit function `f(q) = |q - center|^2 - r^2`: 0 on the sphere, negative inside. In
    /// squared world units; infinite where it overflows.
    pub fn implicit(&self, q: DVec3) -> f64 {
        let seen = SphereSeen::new(self, q);
        ldexp(seen.c, 2 * seen.scale)
    }

    /// The quadratic's parts for the readouts: those that [`Sphere::roots`] decides by. They may
    /// overflow or underflow where the roots do not.
    pub fn quadratic(&self, ray: &Ray) -> SphereQuadratic {
        let seen = SphereSeen::new(self, ray.origin);
        let (direction, k) = match ray.check() {
            Ok(()) => split(ray.direction),
            Err(_) => (ray.direction, 0),
        };
        let SphereQuadratic { a, b, c, discriminant } = seen.quadratic(direction);
        SphereQuadratic {
            a: ldexp(a, 2 * k),
            b: ldexp(b, k + seen.scale),
            c: ldexp(c, 2 * seen.scale),
            discriminant: ldexp(discriminant, 2 * (k + seen.scale)),
        }
    }

    /// Where the ray's line meets the sphere.
    pub fn roots(&self, ray: &Ray) -> Roots {
        SphereSeen::new(self, ray.origin).roots(ray.direction)
    }

    /// The point and the outward normal where the ray meets the sphere at the root `t`:
    /// `n = (p + t d - center) / |..|`, point `center + r n`.
    ///
    /// From far away (compared with the radius) that sum loses n's digits, and n is put together
    /// from the ray's point nearest to the centre and half the chord instead:
    /// `n = m -+ sqrt(r^2 - |m|^2) d / |d|` with `m = d x ((p - center) x d) / d.d`.
    pub fn point_and_normal(&self, ray: &Ray, t: f64) -> (DVec3, DVec3) {
        let normal = self.normal(ray, t);
        (self.center + self.radius * normal, normal)
    }

    /// The outward unit normal where the ray meets the sphere at the root `t`.
    #[inline(always)]
    pub(crate) fn normal(&self, ray: &Ray, t: f64) -> DVec3 {
        // A copy for the rare case: a ray whose address is taken would live in memory, and going
        // there costs more than all the arithmetic here.
        let copy = *ray;
        let (offset, length) = self.offset(ray.origin, ray.direction, t);
        if length > 0.0 { offset / length } else { self.normal_from_afar(copy, t) }
    }

    /// `|n.d| / |d|` of that normal n.
    #[inline(always)]
    pub(crate) fn cosine(&self, ray: &Ray, t: f64) -> f64 {
        let Ray { origin, direction } = *ray;
        let (offset, length) = self.offset(origin, direction, t);
        if length > 0.0 && is_plain_direction(direction) {
            offset.dot(direction).abs() / (length * direction.length())
        } else {
            self.normal_from_afar(Ray { origin, direction }, t).dot(unit(direction)).abs()
        }
    }

    /// `p + t d - center` and its length; a length of 0 where the digits of the normal are lost.
    #[inline(always)]
    fn offset(&self, origin: DVec3, direction: DVec3, t: f64) -> (DVec3, f64) {
        /// Up to this many radii away, `p + t d - center` has all but four of its digits.
        const NEAR: f64 = 1e4;
        let from_center = origin - self.center;
        let near = NEAR * self.radius;
        let offset = from_center + t * direction;
        let length_squared = offset.length_squared();
        let is_kept = from_center.length_squared() < near * near
            && PLAIN_LENGTH_SQUARED.contains(&length_squared);
        (offset, if is_kept { length_squared.sqrt() } else { 0.0 })
    }

    #[cold]
    fn normal_from_afar(&self, ray: Ray, t: f64) -> DVec3 {
        if ray.check().is_err() {
            return DVec3::ZERO;
        }
        let seen = SphereSeen::new(self, ray.origin);
        let (direction, k) = split(ray.direction);
        let a = direction.length_squared();
        let moment = wide::to_f64(wide::cross_with_rest(seen.from_center, seen.rest, direction));
        let middle = direction.cross(moment) / a;
        let half_chord = (seen.radius * seen.radius - middle.length_squared()).max(0.0).sqrt();
        let middle_t = -direction.dot(seen.from_center) / a;
        // Where t cannot tell the two ends of the chord apart, the near one is meant.
        let is_far_end = ldexp(t, k - seen.scale) > middle_t + 4.0 * f64::EPSILON * middle_t.abs();
        let along = if is_far_end { unit(direction) } else { -unit(direction) };
        let offset = middle + half_chord * along;
        if offset == DVec3::ZERO { along } else { unit(offset) }
    }
}

/// What the rays of one origin share of a sphere. Lengths are in units of `2^scale`, which is 1 but
/// for extreme spheres.
pub(crate) struct SphereSeen {
    from_center: DVec3,
    /// What rounding left out of `from_center`.
    rest: DVec3,
    radius: f64,
    c: f64,
    scale: i32,
    form: Form,
}

/// Which form of the discriminant loses the least, by the origin's distance from the centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// `b^2 - a c`: inside it is a sum; just outside, both parts are small.
    Near,
    /// `r^2 a - |oc x d|^2`, by Lagrange's identity `a |oc|^2 - (d.oc)^2 = |oc x d|^2`: grazing rays
    /// and distant spheres.
    Far,
}

/// Lengths within these neither overflow nor lose digits to underflow in the discriminant of a
/// [plain direction](is_plain_direction).
const PLAIN_LENGTH: std::ops::Range<f64> = 1e-60..1e60;

impl SphereSeen {
    pub(crate) fn new(sphere: &Sphere, origin: DVec3) -> SphereSeen {
        let (from_center, rest, quartered) = difference_with_rest(origin, sphere.center);
        let radius = ldexp(sphere.radius, -quartered);
        let extent = from_center.abs().max_element().max(radius);
        if quartered == 0 && PLAIN_LENGTH.contains(&extent) {
            return SphereSeen::scaled(from_center, rest, radius, 0);
        }
        let k = exponent(extent);
        let scale = |v| ldexp3(v, -k);
        SphereSeen::scaled(scale(from_center), scale(rest), ldexp(radius, -k), k + quartered)
    }

    fn scaled(from_center: DVec3, rest: DVec3, radius: f64, scale: i32) -> SphereSeen {
        let (distance_squared, radius_squared) = (from_center.length_squared(), radius * radius);
        let (form, c) = if distance_squared < 2.0 * radius_squared {
            // Near the sphere the rounding of its terms would be larger than c.
            let DVec3 { x, y, z } = from_center;
            let factors = [(x, x), (y, y), (z, z), (radius, -radius)];
            (Form::Near, dot2(factors, 2.0 * from_center.dot(rest)))
        } else {
            (Form::Far, distance_squared - radius_squared)
        };
        SphereSeen { from_center, rest, radius, c, scale, form }
    }

    fn quadratic(&self, direction: DVec3) -> SphereQuadratic {
        match self.form {
            Form::Near => self.quadratic_near(direction),
            Form::Far => self.quadratic_far(direction),
        }
    }

    fn quadratic_near(&self, direction: DVec3) -> SphereQuadratic {
        let a = direction.length_squared();
        let b = direction.dot(self.from_center);
        SphereQuadratic { a, b, c: self.c, discriminant: b * b - a * self.c }
    }

    fn quadratic_far(&self, direction: DVec3) -> SphereQuadratic {
        let a = direction.length_squared();
        let b = direction.dot(self.from_center);
        let moment = self.from_center.cross(direction);
        let discriminant = self.radius * self.radius * a - moment.length_squared();
        SphereQuadratic { a, b, c: self.c, discriminant }
    }

    /// Where the line from the origin along `direction` meets the sphere.
    pub(crate) fn roots(&self, direction: DVec3) -> Roots {
        if self.scale == 0 && is_plain_direction(direction) {
            return self.quadratic(direction).roots();
        }
        if !direction.is_finite() || direction == DVec3::ZERO {
            return Roots::None;
        }
        let (direction, k) = split(direction);
        self.quadratic(direction).roots().map(|t| ldexp(t, self.scale - k))
    }

    /// Which of the functions below gives [`Roots::first_positive`] of [`SphereSeen::roots`] at the
    /// least cost; `plain` where all directions to come are [plain](is_plain_direction).
    pub(crate) fn kernel(&self, plain: bool) -> Kernel {
        match self.form {
            _ if !plain || self.scale != 0 => Kernel::Any,
            Form::Near => Kernel::Near,
            Form::Far => Kernel::Far,
        }
    }

    /// The first hit's `t`, infinite or NaN where there is none; see [`SphereSeen::kernel`].
    pub(crate) fn first_hit(&self, direction: DVec3) -> f64 {
        self.roots(direction).first_positive().unwrap_or(f64::INFINITY)
    }

    /// As [`SphereSeen::first_hit`], for [`Kernel::Near`].
    pub(crate) fn first_hit_near(&self, direction: DVec3) -> f64 {
        self.quadratic_near(direction).first_hit()
    }

    /// As [`SphereSeen::first_hit`], for [`Kernel::Far`].
    pub(crate) fn first_hit_far(&self, direction: DVec3) -> f64 {
        self.quadratic_far(direction).first_hit()
    }
}

/// See [`SphereSeen::kernel`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kernel {
    /// [`SphereSeen::first_hit`]
    Any,
    /// [`SphereSeen::first_hit_near`]
    Near,
    /// [`SphereSeen::first_hit_far`]
    Far,
}

impl SphereQuadratic {
    /// `-(b + sign(b) sqrt D)`, free of cancellation: the roots are `q / a` and `c / q` (Press et
    /// al., *Numerical Recipes*, 3rd ed., section 5.6).
    fn q(&self) -> f64 {
        -(self.b + self.discriminant.sqrt().copysign(self.b))
    }

    fn roots(&self) -> Roots {
        let SphereQuadratic { a, b, c, discriminant } = *self;
        let roots = if discriminant > 0.0 {
            let q = self.q();
            // |q / a| >= |c / q|, but for rounding.
            let (inner, outer) = (c / q, q / a);
            if q > 0.0 {
                Roots::Two(inner, outer.max(inner))
            } else {
                Roots::Two(outer.min(inner), inner)
            }
        } else if discriminant == 0.0 {
            Roots::One(-b / a)
        } else {
            Roots::None
        };
        roots.in_range()
    }

    /// [`Roots::first_positive`] of the roots; infinite, zero or negative where there is none.
    fn first_hit(&self) -> f64 {
        let SphereQuadratic { a, b, c, discriminant } = *self;
        if discriminant > 0.0 {
            let q = self.q();
            // From outside (c > 0) both roots have the sign of q, and c / q is the nearer one.
            if c <= 0.0 && q > 0.0 { q / a } else { c / q }
        } else if discriminant == 0.0 {
            -b / a
        } else {
            f64::INFINITY
        }
    }
}
