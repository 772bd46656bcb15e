//! Numbers whose exponent cannot overflow: cross products of any two vectors, exact in range.

use std::ops::Add;

use glam::DVec3;

use crate::scale::{exponent, ldexp};

/// `mantissa * 2^exponent`, `|mantissa|` in `[1, 2)`, or zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wide {
    mantissa: f64,
    exponent: i32,
}

impl Wide {
    /// Below the exponent of every product of two `f64`, so that a zero never sets the scale.
    const ZERO: Wide = Wide { mantissa: 0.0, exponent: -10_000 };

    /// `x * 2^k` of a finite `x`.
    fn new(x: f64, k: i32) -> Wide {
        if x == 0.0 {
            return Wide::ZERO;
        }
        let e = exponent(x);
        Wide { mantissa: ldexp(x, -e), exponent: e + k }
    }

    /// Whether this is 0.
    pub(crate) fn is_zero(self) -> bool {
        self.mantissa == 0.0
    }

    /// This number in units of `2^k`; 0 where it is far below.
    fn in_units_of(self, k: i32) -> f64 {
        ldexp(self.mantissa, self.exponent - k)
    }
}

impl Add for Wide {
    type Output = Wide;

    fn add(self, other: Wide) -> Wide {
        let k = self.exponent.max(other.exponent);
        Wide::new(self.in_units_of(k) + other.in_units_of(k), k)
    }
}

/// `a*b - c*d` with a relative error of at most 1.5 ulp, and so zero only where it is exactly zero:
/// Kahan's form, proven in Jeannerod, Louvet, Muller, *Further analysis of Kahan's algorithm for the
/// accurate computation of 2x2 determinants*, Math. Comp. 82 (2013), on factors near 1.
fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> Wide {
    let [a, b, c, d] = [a, b, c, d].map(|x| Wide::new(x, 0));
    let (ab, cd) = (a.exponent + b.exponent, c.exponent + d.exponent);
    let k = ab.max(cd);
    let (a, c) = (ldexp(a.mantissa, ab - k), ldexp(c.mantissa, cd - k));
    let cd = c * d.mantissa;
    let error = (-c).mul_add(d.mantissa, cd);
    Wide::new(a.mul_add(b.mantissa, -cd) + error, k)
}

/// `a x b` of any two finite vectors, each component by [`difference_of_products`].
fn cross(a: DVec3, b: DVec3) -> [Wide; 3] {
    [
        difference_of_products(a.y, b.z, a.z, b.y),
        difference_of_products(a.z, b.x, a.x, b.z),
        difference_of_products(a.x, b.y, a.y, b.x),
    ]
}

/// `(a + rest) x b`, where `rest` is what rounding left out of `a`.
pub(crate) fn cross_with_rest(a: DVec3, rest: DVec3, b: DVec3) -> [Wide; 3] {
    let (of_a, of_rest) = (cross(a, b), cross(rest, b));
    std::array::from_fn(|i| of_a[i] + of_rest[i])
}

/// The vector in `f64`.
pub(crate) fn to_f64(v: [Wide; 3]) -> DVec3 {
    DVec3::from_array(v.map(|x| x.in_units_of(0)))
}

/// `(m, k)` with the vector `m * 2^k` and the largest `|m_i|` in `[1, 2)`; `None` for zero.
pub(crate) fn split(v: [Wide; 3]) -> Option<(DVec3, i32)> {
    let k = v[0].exponent.max(v[1].exponent).max(v[2].exponent);
    let scaled = DVec3::from_array(v.map(|x| x.in_units_of(k)));
    (!v.iter().all(|x| x.is_zero())).then_some((scaled, k))
}
