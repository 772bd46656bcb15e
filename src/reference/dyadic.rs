//! Exact binary numbers `m * 2^e`, and their rounded quotients and roots.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use dashu_float::ops::Abs;
use dashu_float::round::mode::Zero;
use dashu_float::round::{ErrorBounds, Round};
use dashu_float::{Context, FBig, Repr};
use dashu_int::ops::BitTest;
use dashu_int::{IBig, UBig};

/// An exact number: its precision has no limit, and 0 has no sign.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Dyadic(FBig<Zero, 2>);

impl Dyadic {
    pub(crate) const ZERO: Dyadic = Dyadic(FBig::from_repr_const(Repr::zero()));

    /// Returns `mantissa * 2^exponent`.
    pub(crate) fn new(mantissa: IBig, exponent: i64) -> Dyadic {
        Dyadic::of(Repr::new(mantissa, exponent as isize))
    }

    fn of(repr: Repr<2>) -> Dyadic {
        let repr = if repr.significand().is_zero() { Repr::zero() } else { repr };
        Dyadic(FBig::from_repr(repr, Context::new(0)))
    }

    pub(crate) fn power_of_two(exponent: i64) -> Dyadic {
        Dyadic::new(IBig::ONE, exponent)
    }

    /// Converts a finite `f64` exactly.
    ///
    /// # Panics
    /// Panics if `x` is NaN or infinite.
    pub(crate) fn from_f64(x: f64) -> Dyadic {
        assert!(x.is_finite(), "{x} is not a finite number");
        Dyadic::of(Repr::try_from(x).unwrap_or(Repr::zero()))
    }

    pub(crate) fn sign(&self) -> Ordering {
        self.cmp(&Dyadic::ZERO)
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.repr().significand().is_zero()
    }

    pub(crate) fn abs(&self) -> Dyadic {
        Dyadic(self.0.clone().abs())
    }

    pub(crate) fn square(&self) -> Dyadic {
        self * self
    }

    /// Returns `self * 2^k`.
    pub(crate) fn shifted(&self, k: i64) -> Dyadic {
        Dyadic(self.0.clone() << k as isize)
    }

    /// Returns `floor(log2 |self|)`; `None` for 0.
    pub(crate) fn log2(&self) -> Option<i64> {
        (!self.is_zero()).then(|| self.0.repr().exponent() as i64 + self.length() as i64 - 1)
    }

    /// Returns `floor(|self| / 2^unit)`, and whether the remainder of this division is less than, equal
    /// to or greater than half of `2^unit` (`None` if the remainder is 0).
    pub(crate) fn in_units(&self, unit: i64) -> (UBig, Option<Ordering>) {
        let magnitude = self.0.repr().significand().clone().into_parts().1;
        let drop = unit - self.0.repr().exponent() as i64;
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
        self.0.repr().digits()
    }

    /// Returns the number rounded to at most `bits` significant bits.
    pub(crate) fn rounded<R: Round>(&self, bits: usize) -> Dyadic {
        let number = self.0.clone().with_rounding::<R>();
        Dyadic::of(number.with_precision(bits).value().into_repr())
    }

    /// Returns `self / divisor` rounded to at most `bits` significant bits.
    ///
    /// # Panics
    /// Panics if `divisor` is 0.
    pub(crate) fn divided<R: Round>(&self, divisor: &Dyadic, bits: usize) -> Dyadic {
        assert!(!divisor.is_zero(), "division by zero");
        let context = Context::<R>::new(bits);
        let quotient = context.div(self.0.repr(), divisor.0.repr());
        Dyadic::of(context.unwrap_fp(quotient).into_repr())
    }

    /// Returns the square root, rounded to at most `bits` significant bits.
    ///
    /// # Panics
    /// Panics if the number is negative.
    pub(crate) fn sqrt<R: ErrorBounds>(&self, bits: usize) -> Dyadic {
        let context = Context::<R>::new(bits);
        Dyadic::of(context.unwrap_fp(context.sqrt(self.0.repr())).into_repr())
    }
}

impl Add for &Dyadic {
    type Output = Dyadic;
    fn add(self, other: &Dyadic) -> Dyadic {
        Dyadic(&self.0 + &other.0)
    }
}

impl Neg for &Dyadic {
    type Output = Dyadic;
    fn neg(self) -> Dyadic {
        Dyadic::of(-self.0.repr().clone())
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;
    fn sub(self, other: &Dyadic) -> Dyadic {
        Dyadic(&self.0 - &other.0)
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: &Dyadic) -> Dyadic {
        Dyadic::of((&self.0 * &other.0).into_repr())
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
