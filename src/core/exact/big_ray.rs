//! A ray in exact arithmetic: compares its roots (the points where its line meets an object) exactly,
//! and computes their `t` to 100 bits.

use std::cmp::Ordering;

use glam::DVec3;
use num_bigint::BigInt;

use crate::exact::dyadic::{Dyadic, Exact3, exact3, ratio};
use crate::exact::precise::Precise;
use crate::exact::surd::{Radicands, Surd, sign_with_roots};

/// A ray whose origin and direction are exact numbers.
#[derive(Clone, Debug)]
pub(crate) struct BigRay {
    pub(crate) origin: Exact3,
    /// The direction times `scale`.
    pub(crate) direction: [Surd; 3],
    pub(crate) scale: Surd,
    pub(crate) radicands: Radicands,
    /// `direction . direction`
    pub(crate) a: Surd,
}

/// A root of a ray: a point where its line meets an object. Measured in lengths of the scaled direction,
/// it is at `(x + sign sqrt radicand) / y`, where `sign` stands for -1, 0 or 1, and `y > 0`.
#[derive(Clone, Debug)]
pub(crate) struct BigRoot {
    pub(crate) x: Surd,
    pub(crate) sign: Ordering,
    pub(crate) radicand: Surd,
    /// The denominator; `None` stands for the ray's `a`.
    pub(crate) y: Option<Surd>,
}

/// The quadratic `a t^2 - 2 b t + c = 0` of a ray and a sphere, without a, which is [`BigRay::a`], and
/// c.
#[derive(Clone, Debug)]
pub(crate) struct BigQuadratic {
    pub(crate) b: Surd,
    pub(crate) discriminant: Surd,
}

impl BigRay {
    pub(crate) fn new(
        origin: DVec3,
        direction: [Surd; 3],
        scale: Surd,
        radicands: Radicands,
    ) -> BigRay {
        let squares = direction.each_ref().map(|x| x.square(&radicands));
        let a = &(&squares[0] + &squares[1]) + &squares[2];
        BigRay { origin: exact3(origin), direction, scale, radicands, a }
    }

    /// Creates a ray from an origin and a direction.
    pub(crate) fn given(origin: DVec3, direction: DVec3) -> BigRay {
        let one = Surd::from(Dyadic::from(1.0));
        BigRay::new(origin, exact3(direction).map(Surd::from), one, Radicands::none())
    }

    pub(crate) fn dot(&self, v: &Exact3) -> Surd {
        let terms: [Surd; 3] = std::array::from_fn(|i| self.direction[i].scaled(&v[i]));
        &(&terms[0] + &terms[1]) + &terms[2]
    }

    /// Returns `value / unit` with a relative error of at most `2^-100`. `unit` must be greater than 0.
    /// The result is 0 only if the value is exactly 0.
    pub(crate) fn value(&self, value: &Surd, unit: &Surd) -> Precise {
        if value.sign(&self.radicands) == Ordering::Equal {
            return Precise::ZERO;
        }
        let (numerator, n) = self.digits(|places| value.fixed(places, &self.radicands));
        let (denominator, m) = self.digits(|places| unit.fixed(places, &self.radicands));
        let (value, scale) = ratio(&numerator, &denominator, m - n);
        Precise { value, scale }
    }

    /// Compares two roots, exactly.
    pub(crate) fn compare(&self, one: &BigRoot, other: &BigRoot) -> Ordering {
        let radicands = &self.radicands;
        let (numerators, [p, q]) = match (&one.y, &other.y) {
            (None, None) => (&one.x - &other.x, [one.radicand.clone(), other.radicand.clone()]),
            (y1, y2) => {
                let (y1, y2) = (y1.as_ref().unwrap_or(&self.a), y2.as_ref().unwrap_or(&self.a));
                let numerators = &one.x.times(y2, radicands) - &other.x.times(y1, radicands);
                let under =
                    |radicand: &Surd, y: &Surd| radicand.times(&y.square(radicands), radicands);
                (numerators, [under(&one.radicand, y2), under(&other.radicand, y1)])
            }
        };
        sign_with_roots(&numerators, (one.sign, &p), (other.sign.reverse(), &q), radicands)
    }

    /// Returns `t` of a root that is not 0, with a relative error of at most `2^-100`.
    pub(crate) fn t(&self, root: &BigRoot) -> Precise {
        let (numerator, n) = self.digits(|places| self.numerator(root, places));
        let (denominator, m) =
            self.digits(|places| root.y.as_ref().unwrap_or(&self.a).fixed(places, &self.radicands));
        let (scale, s) = self.digits(|places| self.scale.fixed(places, &self.radicands));
        let (value, scale) = ratio(&(numerator * scale), &denominator, m - n - s);
        Precise { value, scale }
    }

    /// Compares `t` of a root with a number, exactly.
    pub(crate) fn compare_t(&self, root: &BigRoot, t: &Dyadic) -> Ordering {
        // scale (x + sign sqrt radicand) - t y
        let radicands = &self.radicands;
        let y = root.y.as_ref().unwrap_or(&self.a);
        let x = &self.scale.times(&root.x, radicands) - &y.scaled(t);
        let radicand = root.radicand.times(&self.scale.square(radicands), radicands);
        let no_root = (Ordering::Equal, &Surd::zero());
        sign_with_roots(&x, (root.sign, &radicand), no_root, radicands)
    }

    /// Compares a root's signed distance from the ray's origin (negative behind the origin) with a given
    /// distance, exactly.
    pub(crate) fn compare_distance(&self, root: &BigRoot, distance: &Dyadic) -> Ordering {
        let radicands = &self.radicands;
        let under_root = |x: &Surd| self.a.times(&x.square(radicands), radicands);
        let Some(y) = &root.y else {
            // x + sign sqrt radicand - distance sqrt a
            let other = under_root(&Surd::from(distance.clone()));
            let (one, sign) = ((root.sign, &root.radicand), distance.sign().reverse());
            return sign_with_roots(&root.x, one, (sign, &other), radicands);
        };
        // x sqrt a - distance y
        let one = (root.x.sign(radicands), &under_root(&root.x));
        let no_root = (Ordering::Equal, &Surd::zero());
        sign_with_roots(&-&y.scaled(distance), one, no_root, radicands)
    }

    /// Returns `(x + sign sqrt radicand) * 2^places` with an error of less than 8.
    pub(crate) fn numerator(&self, root: &BigRoot, places: i32) -> BigInt {
        let x = root.x.fixed(places, &self.radicands);
        if root.sign == Ordering::Equal {
            return x;
        }
        // An error of less than 4 under the root becomes an error of at most 2.
        let square = root.radicand.fixed(2 * places, &self.radicands);
        let swing = BigInt::from(square.magnitude().sqrt());
        if root.sign == Ordering::Less { x - swing } else { x + swing }
    }

    /// Evaluates a number other than 0 in fixed point, with as many binary places as 128 correct bits
    /// need. Returns the fixed-point number and the number of places. `fixed(places)` must return the
    /// number times `2^places`, with an error below 8.
    fn digits(&self, fixed: impl Fn(i32) -> BigInt) -> (BigInt, i32) {
        let mut places = 160 - self.a.log2_bound(&self.radicands) / 2;
        loop {
            let found = fixed(places);
            let bits = found.bits() as i32;
            if bits >= 132 {
                return (found, places);
            }
            places += (192 - bits).max(128);
        }
    }
}
