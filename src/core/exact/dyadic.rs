//! Exact arithmetic with dyadic numbers, `m * 2^k` with integers m of arbitrary length, for the last
//! step of [the ladder](crate#the-ladder).

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use glam::DVec3;
use num_bigint::{BigInt, BigUint, Sign};

use crate::exact::double_double::DoubleDouble;
use crate::exact::scale::ldexp;

/// The number `mantissa * 2^exponent`. Every finite `f64` is a dyadic number, and so are sums and
/// products of dyadic numbers.
#[derive(Clone, Debug)]
pub struct Dyadic {
    mantissa: BigInt,
    exponent: i32,
}

impl From<f64> for Dyadic {
    /// Converts a finite `f64`, exactly.
    fn from(x: f64) -> Dyadic {
        let biased = ((x.to_bits() >> 52) & 0x7ff) as i32;
        let fraction = x.to_bits() & ((1 << 52) - 1);
        let mantissa = if biased == 0 { fraction } else { fraction | 1 << 52 };
        if mantissa == 0 {
            return Dyadic::zero();
        }
        let even = mantissa.trailing_zeros();
        let magnitude = BigInt::from(mantissa >> even);
        Dyadic {
            mantissa: if x < 0.0 { -magnitude } else { magnitude },
            exponent: biased.max(1) - 1075 + even as i32,
        }
    }
}

impl Dyadic {
    pub(crate) fn zero() -> Dyadic {
        Dyadic { mantissa: BigInt::ZERO, exponent: 0 }
    }

    /// Returns the sign: less than, equal to or greater than 0.
    pub fn sign(&self) -> Ordering {
        match self.mantissa.sign() {
            Sign::Minus => Ordering::Less,
            Sign::NoSign => Ordering::Equal,
            Sign::Plus => Ordering::Greater,
        }
    }

    /// Returns whether the number is 0.
    pub fn is_zero(&self) -> bool {
        self.mantissa.sign() == Sign::NoSign
    }

    /// Returns `(m, k)` with the number `m * 2^k`.
    pub(crate) fn parts(&self) -> (&BigInt, i32) {
        (&self.mantissa, self.exponent)
    }

    /// Returns the mantissa that the number has if it is written with the given exponent, which must be
    /// at most the number's own.
    fn aligned(&self, exponent: i32) -> BigInt {
        &self.mantissa << (self.exponent - exponent) as u32
    }

    /// Returns the number times itself.
    pub fn square(&self) -> Dyadic {
        self * self
    }

    /// Returns `floor(log2 |self|)`, or a large negative number for 0.
    pub(crate) fn log2(&self) -> i32 {
        if self.is_zero() {
            return i32::MIN / 4;
        }
        self.mantissa.bits() as i32 - 1 + self.exponent
    }

    /// Returns `self * 2^places`, rounded towards 0.
    pub(crate) fn fixed(&self, places: i32) -> BigInt {
        shifted(&self.mantissa, self.exponent + places)
    }

    /// Returns `floor(sqrt(self) * 2^places)`. The number must not be negative.
    pub(crate) fn fixed_root(&self, places: i32) -> BigInt {
        let square = shifted(&self.mantissa, self.exponent + 2 * places);
        debug_assert!(square.sign() != Sign::Minus);
        BigInt::from(square.magnitude().sqrt())
    }

    /// Returns a double-double and an exponent k, so that the number is the double-double times `2^k`,
    /// with a relative error of at most `2^-105`.
    pub(crate) fn to_double_double(&self) -> (DoubleDouble, i32) {
        ratio(&self.mantissa, &BigInt::from(1), self.exponent)
    }

    /// Returns `self * 2^k` as the nearest `f64`, ties to even.
    pub fn rounded_times(&self, k: i32) -> f64 {
        round(&self.mantissa, self.exponent + k)
    }
}

/// Returns `m * 2^k`, rounded towards 0.
pub(crate) fn shifted(m: &BigInt, k: i32) -> BigInt {
    if k >= 0 {
        return m << k as u32;
    }
    // Shifting a negative BigInt would round down, not towards 0, so the magnitude is shifted.
    BigInt::from_biguint(m.sign(), m.magnitude() >> k.unsigned_abs())
}

/// Returns `m * 2^k` as the nearest `f64`, ties to even, infinite where it overflows.
fn round(m: &BigInt, k: i32) -> f64 {
    let (sign, magnitude) = (m.sign(), m.magnitude());
    let bits = magnitude.bits() as i32;
    if bits == 0 {
        return 0.0;
    }
    // Keeps as many bits as the result can hold, and one more that is set if any lower bit was set.
    let smallest = (-1074 - 1).max(bits + k - 55);
    let cut = smallest - k;
    let kept = if cut > 0 {
        let kept: BigUint = magnitude >> cut as u32;
        let is_rest = magnitude.trailing_zeros().is_some_and(|zeros| zeros < cut as u64);
        (kept << 1_u32) | BigUint::from(u32::from(is_rest))
    } else {
        magnitude << 1_u32
    };
    let lowest = k + cut.max(0) - 1;
    // At most 57 bits, rounded to odd, which are then rounded to nearest.
    let kept = kept.iter_u64_digits().next().unwrap_or(0);
    let x = round_to_odd(kept, lowest);
    if sign == Sign::Minus { -x } else { x }
}

/// Returns the `f64` nearest to a number whose leading bits, at most 57, are `m * 2^k`. The lowest bit
/// of m must be 1 if any bit that was dropped below it was 1 (rounding to odd).
fn round_to_odd(m: u64, k: i32) -> f64 {
    if m == 0 {
        return 0.0;
    }
    let top = 63 - m.leading_zeros() as i32 + k;
    // The exponent of the result's last bit.
    let last = (top - 52).max(-1074);
    let drop = last - k;
    if drop <= 0 {
        return ldexp(m as f64, k);
    }
    if drop > 63 {
        return 0.0;
    }
    let (whole, rest, half) = (m >> drop, m & ((1 << drop) - 1), 1_u64 << (drop - 1));
    let up = rest > half || (rest == half && whole & 1 == 1);
    ldexp((whole + u64::from(up)) as f64, last)
}

/// Returns `numerator / denominator` as the nearest `f64`, ties to even. The denominator must not be 0.
pub fn rounded_quotient(numerator: &Dyadic, denominator: &Dyadic) -> f64 {
    // Enough for the 53 bits of a result; the lowest bit is set if there is a remainder.
    let widen = (64 + denominator.mantissa.bits()).saturating_sub(numerator.mantissa.bits());
    let widened = &numerator.mantissa << widen;
    let quotient = &widened / &denominator.mantissa;
    let is_rest = &quotient * &denominator.mantissa != widened;
    let sign = if widened.sign() == denominator.mantissa.sign() { 1 } else { -1 };
    let quotient = (quotient << 1_u32) + BigInt::from(sign * i32::from(is_rest));
    round(&quotient, numerator.exponent - denominator.exponent - widen as i32 - 1)
}

/// Returns `sqrt(numerator / denominator)` within an ulp, or infinity if the denominator is 0. Neither
/// number may be negative.
pub fn root_of_quotient(numerator: &Dyadic, denominator: &Dyadic) -> f64 {
    if numerator.is_zero() {
        return 0.0;
    }
    if denominator.is_zero() {
        return f64::INFINITY;
    }
    let ((n, n_scale), (d, d_scale)) =
        (numerator.to_double_double(), denominator.to_double_double());
    let (quotient, k) = (n / d, n_scale - d_scale);
    // The root of an even power of two is exact.
    let odd = k.rem_euclid(2);
    ldexp(quotient.scaled(odd).square_root().hi, (k - odd) / 2)
}

/// Returns a double-double x and an exponent e so that `numerator / denominator * 2^k = x * 2^e`, with a
/// relative error of at most `2^-105`. The magnitude of x's high part lies in `[1/2, 2]`, unless x is 0.
pub(crate) fn ratio(numerator: &BigInt, denominator: &BigInt, k: i32) -> (DoubleDouble, i32) {
    const DIGITS: i32 = 128;
    if numerator.sign() == Sign::NoSign {
        return (DoubleDouble::default(), 0);
    }
    let excess = numerator.bits() as i32 - denominator.bits() as i32;
    let quotient = if denominator.magnitude() == &BigUint::from(1_u32) {
        let numerator = shifted(numerator, DIGITS - excess);
        if denominator.sign() == Sign::Minus { -numerator } else { numerator }
    } else {
        shifted(numerator, DIGITS - excess) / denominator
    };
    let hi = round(&quotient, -DIGITS);
    let rest = quotient - Dyadic::from(hi).fixed(DIGITS);
    let lo = round(&rest, -DIGITS);
    (DoubleDouble { hi, lo }, excess + k)
}

impl Add for &Dyadic {
    type Output = Dyadic;

    fn add(self, other: &Dyadic) -> Dyadic {
        if self.is_zero() {
            return other.clone();
        }
        if other.is_zero() {
            return self.clone();
        }
        let exponent = self.exponent.min(other.exponent);
        Dyadic { mantissa: self.aligned(exponent) + other.aligned(exponent), exponent }
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;

    fn sub(self, other: &Dyadic) -> Dyadic {
        self + &-other
    }
}

impl Neg for &Dyadic {
    type Output = Dyadic;

    fn neg(self) -> Dyadic {
        Dyadic { mantissa: -&self.mantissa, exponent: self.exponent }
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;

    fn mul(self, other: &Dyadic) -> Dyadic {
        if self.is_zero() || other.is_zero() {
            return Dyadic::zero();
        }
        Dyadic {
            mantissa: &self.mantissa * &other.mantissa,
            exponent: self.exponent + other.exponent,
        }
    }
}

/// A vector of exact numbers.
pub type Exact3 = [Dyadic; 3];

/// Converts a finite vector, exactly.
pub fn exact3(v: DVec3) -> Exact3 {
    v.to_array().map(Dyadic::from)
}

/// Returns `a - b`.
pub fn minus(a: &Exact3, b: &Exact3) -> Exact3 {
    std::array::from_fn(|i| &a[i] - &b[i])
}

/// Returns `a . b`.
pub fn dot(a: &Exact3, b: &Exact3) -> Dyadic {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

/// Returns `a x b`.
pub fn cross(a: &Exact3, b: &Exact3) -> Exact3 {
    let minor = |i: usize, j: usize| &(&a[i] * &b[j]) - &(&a[j] * &b[i]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// Returns `x v`.
pub(crate) fn times(v: &Exact3, x: &Dyadic) -> Exact3 {
    std::array::from_fn(|i| &v[i] * x)
}
