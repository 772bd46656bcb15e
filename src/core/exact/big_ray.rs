//! The ladder's last step: intersections in exact arithmetic, and `t` and normal to any number of
//! digits.

use std::cmp::Ordering;

use glam::DVec3;
use num_bigint::BigInt;

use crate::exact::double_double::DoubleDouble;
use crate::exact::dyadic::{Dyadic, Exact3, dot, exact3, minus, ratio, shifted};
use crate::exact::scale::ldexp;
use crate::exact::surd::{Radicands, Surd, sign_with_roots};
use crate::scene::plane::Plane;
use crate::scene::sphere::Sphere;

/// A ray in exact numbers.
#[derive(Clone, Debug)]
pub(crate) struct BigRay {
    origin: Exact3,
    /// The direction times `scale`.
    direction: [Surd; 3],
    scale: Surd,
    of: Radicands,
    /// `direction . direction`
    a: Surd,
}

/// Where a ray meets an object: `(x + sign sqrt radicand) / y` in units of the scaled direction,
/// with `y > 0`.
#[derive(Clone, Debug)]
pub(crate) struct BigRoot {
    x: Surd,
    sign: Ordering,
    radicand: Surd,
    /// `None` for the ray's own `a`.
    y: Option<Surd>,
}

/// A sphere's quadratic `a t^2 - 2 b t + c = 0`.
#[derive(Clone, Debug)]
pub(crate) struct BigQuadratic {
    b: Surd,
    discriminant: Surd,
}

impl BigRay {
    pub(crate) fn new(origin: DVec3, direction: [Surd; 3], scale: Surd, of: Radicands) -> BigRay {
        let squares = direction.each_ref().map(|x| x.square(&of));
        let a = &(&squares[0] + &squares[1]) + &squares[2];
        BigRay { origin: exact3(origin), direction, scale, of, a }
    }

    /// A ray as given.
    pub(crate) fn given(origin: DVec3, direction: DVec3) -> BigRay {
        let one = Surd::from(Dyadic::from(1.0));
        BigRay::new(origin, exact3(direction).map(Surd::from), one, Radicands::none())
    }

    fn dot(&self, v: &Exact3) -> Surd {
        let terms: [Surd; 3] = std::array::from_fn(|i| self.direction[i].scaled(&v[i]));
        &(&terms[0] + &terms[1]) + &terms[2]
    }

    /// `center - origin`
    fn to_center(&self, sphere: &Sphere) -> Exact3 {
        minus(&exact3(sphere.center), &self.origin)
    }

    /// The sphere's quadratic.
    pub(crate) fn quadratic(&self, sphere: &Sphere) -> BigQuadratic {
        let q = self.to_center(sphere);
        let c = &dot(&q, &q) - &Dyadic::from(sphere.radius).square();
        let b = self.dot(&q);
        let discriminant = &b.square(&self.of) - &self.a.scaled(&c);
        BigQuadratic { b, discriminant }
    }

    /// Sign of D: whether the line misses, touches or crosses the sphere.
    pub(crate) fn meets(&self, quadratic: &BigQuadratic) -> Ordering {
        quadratic.discriminant.sign(&self.of)
    }

    /// Sign of b: whether the sphere's centre lies ahead.
    pub(crate) fn is_ahead(&self, quadratic: &BigQuadratic) -> Ordering {
        quadratic.b.sign(&self.of)
    }

    /// The nearer or the farther root: `sign` is that of the square root.
    pub(crate) fn root(&self, quadratic: BigQuadratic, sign: Ordering) -> BigRoot {
        BigRoot { x: quadratic.b, sign, radicand: quadratic.discriminant, y: None }
    }

    /// The sign of `normal . direction`: `Equal` where the ray is parallel to the plane.
    pub(crate) fn rate(&self, plane: &Plane) -> Ordering {
        self.dot(&exact3(plane.normal)).sign(&self.of)
    }

    /// The root of a plane that is not parallel.
    pub(crate) fn plane_root(&self, plane: &Plane) -> BigRoot {
        let normal = exact3(plane.normal);
        let offset = Surd::from(dot(&normal, &minus(&exact3(plane.point), &self.origin)));
        let rate = self.dot(&normal);
        let (x, y) =
            if rate.sign(&self.of) == Ordering::Less { (-&offset, -&rate) } else { (offset, rate) };
        BigRoot { x, sign: Ordering::Equal, radicand: Surd::zero(), y: Some(y) }
    }

    /// `|origin + t direction - center|^2 - r^2`, as [`BigRay::value`].
    pub(crate) fn sphere_value(&self, sphere: &Sphere, t: f64) -> (DoubleDouble, i32) {
        // Times the scale's square: t and the direction are free of it.
        let (q, t) = (self.to_center(sphere), Dyadic::from(t));
        let c = &dot(&q, &q) - &Dyadic::from(sphere.radius).square();
        let (b, square) = (self.dot(&q), self.scale.square(&self.of));
        let linear = b.times(&self.scale, &self.of).scaled(&(&t + &t));
        let value = &(&self.a.scaled(&t.square()) - &linear) + &square.scaled(&c);
        self.value(&value, &square)
    }

    /// `2 direction . (origin + t direction - center)`, as [`BigRay::value`].
    pub(crate) fn sphere_slope(&self, sphere: &Sphere, t: f64) -> (DoubleDouble, i32) {
        let b = self.dot(&self.to_center(sphere)).times(&self.scale, &self.of);
        let half = &self.a.scaled(&Dyadic::from(t)) - &b;
        self.value(&(&half + &half), &self.scale.square(&self.of))
    }

    /// `normal . (origin + t direction - point)`, as [`BigRay::value`].
    pub(crate) fn plane_value(&self, plane: &Plane, t: f64) -> (DoubleDouble, i32) {
        let normal = exact3(plane.normal);
        let offset = dot(&normal, &minus(&exact3(plane.point), &self.origin));
        let value = &self.dot(&normal).scaled(&Dyadic::from(t)) - &self.scale.scaled(&offset);
        self.value(&value, &self.scale)
    }

    /// `value / unit` for a unit greater than 0, relative error at most `2^-100`, as a double-double
    /// times a power of two; 0 exactly where it is.
    fn value(&self, value: &Surd, unit: &Surd) -> (DoubleDouble, i32) {
        if value.sign(&self.of) == Ordering::Equal {
            return (DoubleDouble::default(), 0);
        }
        let (numerator, n) = self.digits(|places| value.fixed(places, &self.of));
        let (denominator, m) = self.digits(|places| unit.fixed(places, &self.of));
        ratio(&numerator, &denominator, m - n)
    }

    /// Which of two roots is smaller, exactly.
    pub(crate) fn compare(&self, one: &BigRoot, other: &BigRoot) -> Ordering {
        let of = &self.of;
        let (numerators, radicands) = match (&one.y, &other.y) {
            (None, None) => (&one.x - &other.x, [one.radicand.clone(), other.radicand.clone()]),
            (y1, y2) => {
                let (y1, y2) = (y1.as_ref().unwrap_or(&self.a), y2.as_ref().unwrap_or(&self.a));
                let numerators = &one.x.times(y2, of) - &other.x.times(y1, of);
                let under = |radicand: &Surd, y: &Surd| radicand.times(&y.square(of), of);
                (numerators, [under(&one.radicand, y2), under(&other.radicand, y1)])
            }
        };
        let [p, q] = &radicands;
        sign_with_roots(&numerators, (one.sign, p), (other.sign.reverse(), q), of)
    }

    /// `t` of a root that is not 0: relative error at most `2^-100`, as a double-double times a
    /// power of two.
    pub(crate) fn t(&self, root: &BigRoot) -> (DoubleDouble, i32) {
        let (numerator, n) = self.digits(|places| self.numerator(root, places));
        let (denominator, m) =
            self.digits(|places| root.y.as_ref().unwrap_or(&self.a).fixed(places, &self.of));
        let (scale, s) = self.digits(|places| self.scale.fixed(places, &self.of));
        ratio(&(numerator * scale), &denominator, m - n - s)
    }

    /// `(x + sign sqrt radicand) * 2^places`, off by less than 8.
    fn numerator(&self, root: &BigRoot, places: i32) -> BigInt {
        let x = root.x.fixed(places, &self.of);
        if root.sign == Ordering::Equal {
            return x;
        }
        // Off by less than 4 below the root, which makes at most 2 above it.
        let square = root.radicand.fixed(2 * places, &self.of);
        let swing = BigInt::from(square.magnitude().sqrt());
        if root.sign == Ordering::Less { x - swing } else { x + swing }
    }

    /// A fixed-point number with enough places that 128 bits of it are right, and its places.
    /// The number itself, which `fixed` gives with an error below 8, must not be 0.
    fn digits(&self, fixed: impl Fn(i32) -> BigInt) -> (BigInt, i32) {
        let mut places = 160 - self.a.log2_bound(&self.of) / 2;
        loop {
            let found = fixed(places);
            let bits = found.bits() as i32;
            if bits >= 132 {
                return (found, places);
            }
            places += (192 - bits).max(128);
        }
    }

    /// The outward unit normal `(origin + t direction - center) / r` at a root: each coordinate is
    /// off by its rounding to `f64`, and at most `2^-60` more.
    pub(crate) fn sphere_normal(&self, sphere: &Sphere, root: &BigRoot) -> DVec3 {
        let q = self.to_center(sphere);
        let mut places = 200 - self.a.log2_bound(&self.of) / 2;
        loop {
            let numerator = self.numerator(root, places);
            let a = self.a.fixed(2 * places, &self.of);
            let d = self.direction.each_ref().map(|x| x.fixed(places, &self.of));
            let q = q.each_ref().map(|x| x.fixed(places));
            // All in units of 2^(-3 places).
            let extent = &a * Dyadic::from(sphere.radius).fixed(places);
            let offsets = std::array::from_fn::<_, 3, _>(|i| {
                shifted(&(&numerator * &d[i]), places) - &a * &q[i]
            });
            // Off by 8 in the numerator, 4 in d, 4 in a, 1 in q and in the shift.
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

/// `|center - origin|^2 - r^2`
pub(crate) fn big_c(sphere: &Sphere, origin: DVec3) -> Dyadic {
    let q = minus(&exact3(sphere.center), &exact3(origin));
    &dot(&q, &q) - &Dyadic::from(sphere.radius).square()
}

/// `normal . (point - origin)`
pub(crate) fn big_offset(plane: &Plane, origin: DVec3) -> Dyadic {
    dot(&exact3(plane.normal), &minus(&exact3(plane.point), &exact3(origin)))
}
