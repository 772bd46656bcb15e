//! The quadratic of a ray and a sphere with a bound of its own error, in `f64` and in
//! double-double: one formula for both steps of the ladder.
//!
//! Every bound is of first order in the constants of [`Number`]; the factor [`SECOND_ORDER`] covers
//! the rest, and the rounding of the bounds themselves. The manner of the analysis is that of Higham,
//! *Accuracy and Stability of Numerical Algorithms*, 2nd ed., chapter 3; that of filtering decisions
//! by it, of Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric
//! predicates*, Discrete & Computational Geometry 18, 1997.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::exact::double_double::{DoubleDouble, U2};

/// What the formulas are computed in.
pub(crate) trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + From<f64>
{
    /// A bound of the relative error of a sum or difference.
    const SUM: f64;
    /// Of a product.
    const PRODUCT: f64;
    /// Of a product with one `f64`.
    const STRETCH: f64;
    /// Of a quotient.
    const QUOTIENT: f64;
    /// Of a square root.
    const ROOT: f64;

    /// Of a dot product, as a share of the vectors' lengths: three products, each of which goes
    /// through at most two sums.
    const DOT: f64 = Self::PRODUCT + 2.0 * Self::SUM;

    /// Of a cross product's length, likewise: a coordinate is off by `PRODUCT + SUM` times
    /// `|a_j b_k| + |a_k b_j|`, and the vector of those sums is no longer than `sqrt 2 |a| |b|`.
    const CROSS: f64 = 1.415 * (Self::PRODUCT + Self::SUM);

    /// The square root of a number that is greater than 0.
    fn root(self) -> Self;

    /// The product with one `f64`.
    fn stretched(self, x: f64) -> Self;

    /// The number in `f64`, rounded.
    fn near(self) -> f64;
}

/// u, half the spacing of `f64` at 1.
pub(crate) const UNIT: f64 = 0.5 * f64::EPSILON;

impl Number for f64 {
    const SUM: f64 = UNIT;
    const PRODUCT: f64 = UNIT;
    const STRETCH: f64 = UNIT;
    const QUOTIENT: f64 = UNIT;
    const ROOT: f64 = UNIT;

    #[inline(always)]
    fn root(self) -> f64 {
        self.sqrt()
    }

    #[inline(always)]
    fn stretched(self, x: f64) -> f64 {
        self * x
    }

    #[inline(always)]
    fn near(self) -> f64 {
        self
    }
}

impl Number for DoubleDouble {
    // Proven at the operations.
    const SUM: f64 = 3.01 * U2;
    const PRODUCT: f64 = 7.0 * U2;
    const STRETCH: f64 = 3.0 * U2;
    const QUOTIENT: f64 = 17.0 * U2;
    const ROOT: f64 = 3.2 * U2;

    fn root(self) -> DoubleDouble {
        self.square_root()
    }

    fn stretched(self, x: f64) -> DoubleDouble {
        self.times(x)
    }

    fn near(self) -> f64 {
        self.hi
    }
}

/// For terms of second order in the bounds (below 1e-12 of those of the first in `f64`) and the
/// rounding of the bounds.
pub(crate) const SECOND_ORDER: f64 = 1.0 + 1.0 / 64.0;

/// What underflow can add to any of the values below, which are made of scaled vectors whose
/// largest coordinates are within 1e-30 and 1e30: products below 2^-969 lose their rounding error,
/// at most 2^-1073 each, times 1e120.
pub(crate) const UNDERFLOW: f64 = 1e-190;

/// A vector of numbers.
pub(crate) type Vector<T> = [T; 3];

/// `a . b`: error at most `DOT |a| |b|`.
#[inline(always)]
pub(crate) fn dot<T: Number>(a: Vector<T>, b: Vector<T>) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `a x b`: error at most `CROSS |a| |b|`.
#[inline(always)]
pub(crate) fn cross<T: Number>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    let of = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    [of(1, 2), of(2, 0), of(0, 1)]
}

/// A vector rounded to `f64`.
#[inline(always)]
pub(crate) fn near<T: Number>(v: Vector<T>) -> Vector<f64> {
    v.map(T::near)
}

/// The Euclidean length, to a few roundings.
#[inline(always)]
pub(crate) fn length(v: Vector<f64>) -> f64 {
    dot(v, v).sqrt()
}

/// Which form of the discriminant loses the least, by the origin's distance from the centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// `b^2 - a c`: inside it is a sum; just outside, both parts are small.
    Near,
    /// `r^2 a - |q x d|^2`, by Lagrange's identity `a |q|^2 - (d.q)^2 = |q x d|^2`: grazing rays
    /// and distant spheres.
    Far,
}

/// A sphere as the rays of one origin see it, scaled: `q = center - origin`, r, and
/// `c = |q|^2 - r^2`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SphereParts<T> {
    pub(crate) q: Vector<T>,
    pub(crate) radius: T,
    pub(crate) c: T,
    /// Relative error of c.
    pub(crate) c_doubt: f64,
    /// `|q|`, rounded.
    pub(crate) distance: f64,
    /// Error of q as a share of `|q|`.
    pub(crate) q_doubt: f64,
    pub(crate) form: Form,
}

/// A direction, scaled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DirectionParts<T> {
    pub(crate) d: Vector<T>,
    /// `|d|`, rounded.
    pub(crate) length: f64,
    /// Error of d as a share of `|d|`.
    pub(crate) doubt: f64,
}

/// `a t^2 - 2 b t + c = 0` with `b = q.d`, positive towards the centre, and `D = b^2 - a c`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quadratic<T> {
    pub(crate) a: T,
    pub(crate) b: T,
    pub(crate) discriminant: T,
    /// How far b may be off.
    pub(crate) b_doubt: f64,
    /// How far D may be off.
    pub(crate) discriminant_doubt: f64,
    /// Relative error of a.
    pub(crate) a_doubt: f64,
}

impl<T: Number> Quadratic<T> {
    /// The parts and their bounds. With `k` the doubts of q and d together:
    ///
    /// ```text
    /// b:  B = |q||d| (DOT + k)                 a:  a (DOT + 2 k)
    /// m = q x d:  M = |q||d| (CROSS + k)
    /// far,  r^2 a - m.m:  2 |m| M + M^2 + r^2 a (2 PRODUCT + DOT + 2 k) + DOT m.m
    /// near, b^2 - a c:    2 |b| B + B^2 + PRODUCT b^2 + a |c| (PRODUCT + DOT + 2 k + doubt of c)
    /// ```
    ///
    /// and SUM of both terms for the difference itself.
    #[inline(always)]
    pub(crate) fn new(sphere: &SphereParts<T>, direction: &DirectionParts<T>) -> Quadratic<T> {
        let (q, d) = (sphere.q, direction.d);
        let k = sphere.q_doubt + direction.doubt;
        let a = dot(d, d);
        let b = dot(q, d);
        let reach = sphere.distance * direction.length;
        let b_doubt = SECOND_ORDER * (T::DOT + k) * reach + UNDERFLOW;
        let (discriminant, doubt) = match sphere.form {
            Form::Far => {
                let m = cross(q, d);
                let (mm, rra) = (dot(m, m), sphere.radius * sphere.radius * a);
                let (m_squared, m_doubt) = (mm.near(), (T::CROSS + k) * reach);
                let doubt = (2.0 * m_squared.sqrt() + m_doubt) * m_doubt
                    + (2.0 * T::PRODUCT + T::DOT + 2.0 * k + T::SUM) * rra.near()
                    + (T::DOT + T::SUM) * m_squared;
                (rra - mm, doubt)
            }
            Form::Near => {
                let (b_near, ac) = (b.near().abs(), a * sphere.c);
                let doubt = (2.0 * b_near + b_doubt) * b_doubt
                    + (T::PRODUCT + T::SUM) * b_near * b_near
                    + (T::PRODUCT + T::DOT + T::SUM + 2.0 * k + sphere.c_doubt) * ac.near().abs();
                (b * b - ac, doubt)
            }
        };
        let discriminant_doubt = SECOND_ORDER * doubt + UNDERFLOW;
        let a_doubt = SECOND_ORDER * (T::DOT + 2.0 * k);
        Quadratic { a, b, discriminant, b_doubt, discriminant_doubt, a_doubt }
    }

    /// The nearer or the farther root with a bound of its relative error; `None` where D may be 0.
    ///
    /// With `z = b + sign(b) sqrt D`, free of cancellation, the roots are `z / a` and `c / z`
    /// (Press et al., *Numerical Recipes*, 3rd ed., section 5.6). D is off by at most its doubt, so
    /// its root is by `doubt / sqrt D`, and where D is large against its doubt, by little more than
    /// half of that. z is off by that, b's doubt, a root and a sum.
    #[inline(always)]
    pub(crate) fn root(&self, sphere: &SphereParts<T>, far: bool) -> Option<(T, f64)> {
        let Quadratic { a, b, discriminant, b_doubt, discriminant_doubt, a_doubt } = *self;
        if discriminant.near() <= discriminant_doubt {
            return None;
        }
        let root = discriminant.root();
        let share = if discriminant.near() > 32.0 * discriminant_doubt { 0.51 } else { 1.0 };
        let is_ahead = b.near() >= 0.0;
        let z = if is_ahead { b + root } else { b - root };
        let z_doubt = (b_doubt + share * discriminant_doubt / root.near()) / z.near().abs();
        let (t, other_doubt) =
            if far == is_ahead { (z / a, a_doubt) } else { (sphere.c / z, sphere.c_doubt) };
        // A product more for the whole number that t is stretched by.
        let operations = T::ROOT + T::SUM + T::QUOTIENT + T::PRODUCT;
        Some((t, SECOND_ORDER * (z_doubt + other_doubt + operations)))
    }

    /// The root by rounded numbers alone, whatever the doubt; a negative D counts as 0.
    pub(crate) fn rounded_root(&self, sphere: &SphereParts<T>, far: bool) -> T {
        let Quadratic { a, b, discriminant, .. } = *self;
        let root = if discriminant.near() > 0.0 { discriminant.root() } else { T::from(0.0) };
        let is_ahead = b.near() >= 0.0;
        let z = if is_ahead { b + root } else { b - root };
        let t = if far == is_ahead { z / a } else { sphere.c / z };
        // Where rounding has left nothing to divide by, D is next to 0, and this the double root.
        if t.near().is_finite() { t } else { b / a }
    }
}

/// `(t d - q) / r` made a unit vector: the outward normal of a sphere at `t`. Zero where rounding has
/// left no direction.
pub(crate) fn sphere_normal<T: Number>(
    q: Vector<T>,
    direction: &DirectionParts<T>,
    t: T,
) -> Vector<f64> {
    let offset: Vector<T> = std::array::from_fn(|i| direction.d[i] * t - q[i]);
    let square = dot(offset, offset);
    if !(square.near() > 0.0 && square.near().is_finite()) {
        return [0.0; 3];
    }
    let length = square.root();
    offset.map(|x| (x / length).near())
}
