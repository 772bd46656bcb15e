//! The textbook's formulas computed with 1200 binary digits, for the exact values of `f64` inputs.

use std::ops::{Add, Mul, Sub};

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use pinhole_core::{DVec3, Ray, Sphere};

/// A number of 1200 binary digits.
pub(crate) type Big = FBig<HalfEven, 2>;

/// The number as given.
pub(crate) fn big(x: f64) -> Big {
    Big::try_from(x).unwrap().with_precision(1200).value()
}

/// The nearest `f64`.
pub(crate) fn near(x: &Big) -> f64 {
    x.to_f64().value()
}

/// A vector of [`Big`]s.
#[derive(Clone, Debug)]
pub(crate) struct Big3(pub(crate) [Big; 3]);

impl From<DVec3> for Big3 {
    fn from(v: DVec3) -> Self {
        Big3(v.to_array().map(big))
    }
}

impl Big3 {
    fn zip(&self, other: &Big3, f: impl Fn(&Big, &Big) -> Big) -> Big3 {
        Big3(std::array::from_fn(|i| f(&self.0[i], &other.0[i])))
    }

    pub(crate) fn minus(&self, other: &Big3) -> Big3 {
        self.zip(other, |a, b| a.sub(b))
    }

    pub(crate) fn times(&self, factor: &Big) -> Big3 {
        Big3(std::array::from_fn(|i| (&self.0[i]).mul(factor)))
    }

    pub(crate) fn dot(&self, other: &Big3) -> Big {
        let Big3([x, y, z]) = self.zip(other, |a, b| a.mul(b));
        x.add(y).add(z)
    }

    pub(crate) fn cross(&self, other: &Big3) -> Big3 {
        let (a, b) = (&self.0, &other.0);
        let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
        Big3([minor(1, 2), minor(2, 0), minor(0, 1)])
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.iter().all(|x| *x == Big::ZERO)
    }

    /// The vector at length 1.
    pub(crate) fn unit(&self) -> Big3 {
        self.times(&(big(1.0) / self.dot(self).sqrt()))
    }

    /// Returns the largest difference of a coordinate from that of a rounded vector.
    pub(crate) fn error_of(&self, v: DVec3) -> f64 {
        let difference = self.minus(&v.into());
        difference.0.iter().map(|x| near(x).abs()).fold(0.0, f64::max)
    }
}

/// Returns u, v, w for `view` and `up`; `None` if up is parallel to view.
pub(crate) fn basis(view: &Big3, up: &Big3) -> Option<[Big3; 3]> {
    let back = view.times(&big(-1.0));
    let right = up.cross(&back);
    if right.is_zero() {
        return None;
    }
    let (u, w) = (right.unit(), back.unit());
    Some([u.clone(), w.cross(&u), w])
}

/// Returns the roots of a ray with a sphere, in ascending order; twice the same root for a tangent, and
/// `None` for a miss.
pub(crate) fn sphere_roots(sphere: &Sphere, ray: &Ray) -> Option<[f64; 2]> {
    let from_center = Big3::from(ray.origin).minus(&sphere.center.into());
    let direction = Big3::from(ray.direction);
    let a = direction.dot(&direction);
    let b = direction.dot(&from_center);
    let c = from_center.dot(&from_center) - big(sphere.radius) * big(sphere.radius);
    let discriminant = &b * &b - &a * &c;
    if discriminant < Big::ZERO {
        return None;
    }
    let swing = discriminant.sqrt();
    let root = |swing: Big| near(&((swing - &b) / &a));
    Some([root(-swing.clone()), root(swing)])
}
