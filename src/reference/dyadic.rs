//! Exact binary numbers `m * 2^e`, and their rounded quotients and roots.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use dashu_int::ops::{Abs, BitTest, SquareRootRem};
use dashu_int::{IBig, Sign, UBig};

/// The exact number `mantissa * 2^exponent`. The mantissa is odd or, for the number 0, both parts are
/// 0. Equal numbers therefore have equal parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Dyadic {
    mantissa: IBig,
    exponent: i64,
}

/// The direction in which a result is rounded if it has too many bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Toward {
    /// To the next number below, towards minus infinity.
    Below,
    /// To the next number above, towards plus infinity.
    Above,
}

impl Dyadic {
    pub(crate) const ZERO: Dyadic = Dyadic { mantissa: IBig::ZERO, exponent: 0 };

    pub(crate) fn new(mantissa: IBig, exponent: i64) -> Dyadic {
        match mantissa.trailing_zeros() {
            None => Dyadic::ZERO,
            Some(0) => Dyadic { mantissa, exponent },
            Some(zeros) => {
                Dyadic { mantissa: mantissa >> zeros, exponent: exponent + zeros as i64 }
            }
        }
    }

    pub(crate) fn power_of_two(exponent: i64) -> Dyadic {
        Dyadic { mantissa: IBig::ONE, exponent }
    }

    /// Converts a finite `f64` exactly.
    ///
    /// # Panics
    /// Panics if `x` is NaN or infinite.
    pub(crate) fn from_f64(x: f64) -> Dyadic {
        assert!(x.is_finite(), "{x} is not a finite number");
        let bits = x.to_bits();
        let (field, fraction) = ((bits >> 52 & 0x7ff) as i64, bits & ((1 << 52) - 1));
        let (mantissa, exponent) =
            if field == 0 { (fraction, -1074) } else { (fraction | 1 << 52, field - 1075) };
        let mantissa = IBig::from(mantissa);
        Dyadic::new(if x < 0.0 { -mantissa } else { mantissa }, exponent)
    }

    pub(crate) fn sign(&self) -> Ordering {
        match self.mantissa.sign() {
            _ if self.is_zero() => Ordering::Equal,
            Sign::Positive => Ordering::Greater,
            Sign::Negative => Ordering::Less,
        }
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.mantissa.is_zero()
    }

    pub(crate) fn abs(&self) -> Dyadic {
        Dyadic { mantissa: (&self.mantissa).abs(), exponent: self.exponent }
    }

    pub(crate) fn square(&self) -> Dyadic {
        self * self
    }

    /// Returns `self * 2^k`.
    pub(crate) fn shifted(&self, k: i64) -> Dyadic {
        if self.is_zero() {
            return Dyadic::ZERO;
        }
        Dyadic { mantissa: self.mantissa.clone(), exponent: self.exponent + k }
    }

    /// Returns `floor(log2 |self|)`; `None` for 0.
    pub(crate) fn log2(&self) -> Option<i64> {
        if self.is_zero() {
            return None;
        }
        Some(self.exponent + self.length() as i64 - 1)
    }

    /// Returns `floor(|self| / 2^unit)`, and whether the remainder of this division is less than, equal
    /// to or greater than half of `2^unit` (`None` if the remainder is 0).
    pub(crate) fn in_units(&self, unit: i64) -> (UBig, Option<Ordering>) {
        let magnitude = self.magnitude();
        let drop = unit - self.exponent;
        if self.is_zero() || drop <= 0 {
            return (magnitude << usize::try_from(-drop).unwrap_or(0), None);
        }
        let drop = usize::try_from(drop).unwrap_or(usize::MAX);
        let whole = if drop > magnitude.bit_len() { UBig::ZERO } else { &magnitude >> drop };
        // The mantissa is odd, so the remainder is exactly half a unit only if a single bit was
        // dropped.
        let half = match magnitude.bit(drop - 1) {
            false => Ordering::Less,
            true if drop == 1 => Ordering::Equal,
            true => Ordering::Greater,
        };
        (whole, Some(half))
    }

    /// Returns the number of significant bits.
    pub(crate) fn length(&self) -> usize {
        self.mantissa.bit_len()
    }

    fn magnitude(&self) -> UBig {
        self.mantissa.clone().into_parts().1
    }

    /// Returns the number rounded to at most `bits` significant bits, in the direction `toward`.
    pub(crate) fn rounded(&self, bits: usize, toward: Toward) -> Dyadic {
        let drop = self.length() as i64 - bits as i64;
        if drop <= 0 {
            return self.clone();
        }
        let is_negative = self.mantissa.sign() == Sign::Negative;
        let mut magnitude = self.magnitude() >> drop as usize;
        // The mantissa is odd, so the dropped bits are not 0.
        if is_negative == (toward == Toward::Below) {
            magnitude += UBig::ONE;
        }
        Dyadic::new(signed(magnitude, is_negative), self.exponent + drop)
    }

    /// Returns `self / divisor` rounded to at most `bits` significant bits, in the direction `toward`.
    ///
    /// # Panics
    /// Panics if `divisor` is 0.
    pub(crate) fn divided(&self, divisor: &Dyadic, bits: usize, toward: Toward) -> Dyadic {
        assert!(!divisor.is_zero(), "division by zero");
        let (n, d) = (self.magnitude(), divisor.magnitude());
        let widen = (bits + 2 + d.bit_len()).saturating_sub(n.bit_len());
        let n = n << widen;
        let quotient = &n / &d;
        let is_exact = &quotient * &d == n;
        let is_negative = (self.sign() == Ordering::Less) != (divisor.sign() == Ordering::Less);
        let exponent = self.exponent - divisor.exponent - widen as i64;
        with_rest(quotient, is_exact, is_negative, exponent).rounded(bits, toward)
    }

    /// Returns the square root, rounded to at most `bits` significant bits in the direction `toward`.
    ///
    /// # Panics
    /// Panics if the number is negative.
    pub(crate) fn sqrt(&self, bits: usize, toward: Toward) -> Dyadic {
        assert!(self.sign() != Ordering::Less, "square root of a negative number");
        let m = self.magnitude();
        let mut widen = (2 * bits + 4).saturating_sub(m.bit_len());
        if (self.exponent - widen as i64) % 2 != 0 {
            widen += 1;
        }
        let (root, rest) = (m << widen).sqrt_rem();
        let exponent = (self.exponent - widen as i64) / 2;
        with_rest(root, rest.is_zero(), false, exponent).rounded(bits, toward)
    }
}

/// Returns `magnitude * 2^exponent`. If bits of the magnitude were cut off, a final 1 bit (a sticky
/// bit) is appended, so that later rounding gives the same result as for the exact number.
fn with_rest(magnitude: UBig, is_exact: bool, is_negative: bool, exponent: i64) -> Dyadic {
    if is_exact {
        return Dyadic::new(signed(magnitude, is_negative), exponent);
    }
    Dyadic::new(signed((magnitude << 1) + UBig::ONE, is_negative), exponent - 1)
}

fn signed(magnitude: UBig, is_negative: bool) -> IBig {
    IBig::from_parts(if is_negative { Sign::Negative } else { Sign::Positive }, magnitude)
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
        let (high, low) =
            if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        let shift = (high.exponent - low.exponent) as usize;
        Dyadic::new((&high.mantissa << shift) + &low.mantissa, low.exponent)
    }
}

impl Neg for &Dyadic {
    type Output = Dyadic;
    fn neg(self) -> Dyadic {
        Dyadic { mantissa: -&self.mantissa, exponent: self.exponent }
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;
    fn sub(self, other: &Dyadic) -> Dyadic {
        self + &-other
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: &Dyadic) -> Dyadic {
        if self.is_zero() || other.is_zero() {
            return Dyadic::ZERO;
        }
        // The product of two odd mantissas is odd.
        Dyadic {
            mantissa: &self.mantissa * &other.mantissa,
            exponent: self.exponent + other.exponent,
        }
    }
}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Dyadic) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Dyadic {
    fn cmp(&self, other: &Dyadic) -> Ordering {
        let signs = self.sign().cmp(&other.sign());
        if signs != Ordering::Equal || self.is_zero() { signs } else { (self - other).sign() }
    }
}

/// The coordinates of a vector or point.
pub(crate) type Vector = [Dyadic; 3];

pub(crate) fn vector(v: [f64; 3]) -> Vector {
    v.map(Dyadic::from_f64)
}

pub(crate) fn minus(a: &Vector, b: &Vector) -> Vector {
    [&a[0] - &b[0], &a[1] - &b[1], &a[2] - &b[2]]
}

pub(crate) fn dot(a: &Vector, b: &Vector) -> Dyadic {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

pub(crate) fn cross(a: &Vector, b: &Vector) -> Vector {
    let minor = |i: usize, j: usize| &(&a[i] * &b[j]) - &(&a[j] * &b[i]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

pub(crate) fn is_zero(v: &Vector) -> bool {
    v.iter().all(Dyadic::is_zero)
}
