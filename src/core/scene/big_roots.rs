//! Intersection of a ray with spheres and planes in exact arithmetic, the last step of [the
//! ladder](crate#the-ladder).

use std::cmp::Ordering;

use glam::DVec3;
use num_bigint::BigInt;

use crate::exact::big_ray::{BigQuadratic, BigRay, BigRoot};
use crate::exact::dyadic::{Dyadic, Exact3, dot, exact3, minus, ratio, shifted};
use crate::exact::precise::Precise;
use crate::exact::scale::ldexp;
use crate::exact::surd::Surd;
use crate::scene::plane::Plane;
use crate::scene::sphere::Sphere;

impl BigRay {
    /// Returns `center - origin`.
    fn to_center(&self, sphere: &Sphere) -> Exact3 {
        minus(&exact3(sphere.center), &self.origin)
    }

    /// Returns the sphere's quadratic.
    pub(crate) fn quadratic(&self, sphere: &Sphere) -> BigQuadratic {
        let c = big_c(sphere, &self.origin);
        let b = self.dot(&self.to_center(sphere));
        let discriminant = &b.square(&self.radicands) - &self.a.scaled(&c);
        BigQuadratic { b, discriminant }
    }

    /// Returns the sign of `normal . direction`: `Equal` where the ray is parallel to the plane.
    pub(crate) fn rate(&self, plane: &Plane) -> Ordering {
        self.dot(&exact3(plane.normal)).sign(&self.radicands)
    }

    /// Returns the root of a plane that is not parallel to the ray.
    pub(crate) fn plane_root(&self, plane: &Plane) -> BigRoot {
        let normal = exact3(plane.normal);
        let offset = Surd::from(big_offset(plane, &self.origin));
        let rate = self.dot(&normal);
        let (x, y) = if rate.sign(&self.radicands) == Ordering::Less {
            (-&offset, -&rate)
        } else {
            (offset, rate)
        };
        BigRoot { x, sign: Ordering::Equal, radicand: Surd::zero(), y: Some(y) }
    }

    /// Returns `|origin + t direction - center|^2 - r^2`, as accurate as [`BigRay::value`].
    pub(crate) fn sphere_value(&self, sphere: &Sphere, t: f64) -> Precise {
        // All terms are multiplied by the square of the scale, by which the result is divided at the
        // end.
        let (c, t) = (big_c(sphere, &self.origin), Dyadic::from(t));
        let b = self.dot(&self.to_center(sphere));
        let square = self.scale.square(&self.radicands);
        let linear = b.times(&self.scale, &self.radicands).scaled(&(&t + &t));
        let value = &(&self.a.scaled(&t.square()) - &linear) + &square.scaled(&c);
        self.value(&value, &square)
    }

    /// Returns `2 direction . (origin + t direction - center)`, as accurate as [`BigRay::value`].
    pub(crate) fn sphere_slope(&self, sphere: &Sphere, t: f64) -> Precise {
        let b = self.dot(&self.to_center(sphere)).times(&self.scale, &self.radicands);
        let half = &self.a.scaled(&Dyadic::from(t)) - &b;
        self.value(&(&half + &half), &self.scale.square(&self.radicands))
    }

    /// Returns `normal . (origin + t direction - point)`, as accurate as [`BigRay::value`].
    pub(crate) fn plane_value(&self, plane: &Plane, t: f64) -> Precise {
        let normal = exact3(plane.normal);
        let offset = big_offset(plane, &self.origin);
        let value = &self.dot(&normal).scaled(&Dyadic::from(t)) - &self.scale.scaled(&offset);
        self.value(&value, &self.scale)
    }

    /// Returns the outward unit normal `(origin + t direction - center) / r` at a root. The error of
    /// each coordinate is that of rounding it to `f64`, plus at most `2^-60`.
    pub(crate) fn sphere_normal(&self, sphere: &Sphere, root: &BigRoot) -> DVec3 {
        let q = self.to_center(sphere);
        let mut places = 200 - self.a.log2_bound(&self.radicands) / 2;
        loop {
            let numerator = self.numerator(root, places);
            let a = self.a.fixed(2 * places, &self.radicands);
            let d = self.direction.each_ref().map(|x| x.fixed(places, &self.radicands));
            let q = q.each_ref().map(|x| x.fixed(places));
            // All in units of 2^(-3 places).
            let extent = &a * Dyadic::from(sphere.radius).fixed(places);
            let offsets = std::array::from_fn::<_, 3, _>(|i| {
                shifted(&(&numerator * &d[i]), places) - &a * &q[i]
            });
            // Errors: 8 in the numerator, 4 in d, 4 in a, 1 in q and 1 in the shift.
            let bits =
                |v: &[BigInt; 3]| v.iter().map(BigInt::bits).max().unwrap_or_default() as i32;
            let product_off = bits(&d).max(numerator.bits() as i32) + 5 + places;
            let off = product_off.max(bits(&q) + 3).max(a.bits() as i32 + 1).max(1) + 2;
            if extent.bits() as i32 > off + 64 {
                let round = |x: &BigInt| {
                    let (n, k) = ratio(x, &extent, 0);
                    ldexp(n.hi, k)
                };
                return DVec3::from_array(offsets.each_ref().map(round));
            }
            places += 192;
        }
    }
}

/// Returns `|center - origin|^2 - r^2`.
pub(crate) fn big_c(sphere: &Sphere, origin: &Exact3) -> Dyadic {
    let q = minus(&exact3(sphere.center), origin);
    &dot(&q, &q) - &Dyadic::from(sphere.radius).square()
}

/// Returns `normal . (point - origin)`.
pub(crate) fn big_offset(plane: &Plane, origin: &Exact3) -> Dyadic {
    dot(&exact3(plane.normal), &minus(&exact3(plane.point), origin))
}
