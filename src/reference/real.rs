//! The real numbers that the reference returns, and the error of a float relative to such a number.

use std::cmp::Ordering;
use std::fmt;

use dashu_float::round::mode::Down;

use crate::dyadic::{Dyadic, Vector, cross, dot};
use crate::interval::Interval;

/// A real number as the reference computes it, with at least 440 significant bits. It is exact if the
/// true number has no more than 440.
///
/// It differs from the true number by less than one part in `2^440`. Both therefore have the same
/// nearest `f64`, unless the true number is that close to the midpoint of two adjacent `f64` numbers
/// without being the midpoint.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Real(pub(crate) Dyadic);

/// Minimum number of significant bits of a [`Real`].
const BITS: i64 = 440;

/// A floating-point format: its precision and its range.
struct FloatFormat {
    digits: i64,
    /// `log2` of the smallest subnormal.
    smallest: i64,
    /// `log2` of the unit in the last place of the largest number.
    largest_unit: i64,
}

const DOUBLE: FloatFormat = FloatFormat { digits: 53, smallest: -1074, largest_unit: 971 };
const SINGLE: FloatFormat = FloatFormat { digits: 24, smallest: -149, largest_unit: 104 };

impl FloatFormat {
    /// Returns `log2` of the spacing of adjacent floats at `|x|`. Numbers beyond the largest float are
    /// treated as if the exponent had no upper limit.
    fn unit_at(&self, x: &Dyadic) -> i64 {
        x.log2().map_or(self.smallest, |log2| (log2 + 1 - self.digits).max(self.smallest))
    }

    /// Returns the bits of the float that is nearest to `|x|`, with ties to even. The bits of
    /// consecutive magnitudes are consecutive integers, from subnormals through all binades to
    /// infinity.
    fn nearest(&self, x: &Dyadic) -> u64 {
        let unit = self.unit_at(x);
        if unit > self.largest_unit {
            return self.infinity();
        }
        let (whole, rest) = x.in_units(unit);
        let mut units = u64::try_from(whole).unwrap_or(u64::MAX);
        let rounds_up = match rest {
            Some(Ordering::Greater) => true,
            Some(Ordering::Equal) => units % 2 == 1,
            _ => false,
        };
        units += u64::from(rounds_up);
        let below = ((unit - self.smallest) as u64) << (self.digits - 1);
        (below + units).min(self.infinity())
    }

    fn infinity(&self) -> u64 {
        ((self.largest_unit - self.smallest + 2) as u64) << (self.digits - 1)
    }

    /// Returns `|x - exact|` in units of the spacing of the floats at `|exact|`.
    fn ulps(&self, x: f64, exact: &Dyadic) -> f64 {
        if !x.is_finite() {
            return f64::INFINITY;
        }
        let unit = self.unit_at(exact).min(self.largest_unit);
        Real((&Dyadic::from_f64(x) - exact).shifted(-unit)).to_f64().abs()
    }
}

impl Real {
    /// Returns the number that the interval encloses; `None` if the interval is too wide to determine
    /// 440 bits of it.
    pub(crate) fn within(interval: &Interval) -> Option<Real> {
        interval.is_narrow(BITS).then(|| Real(interval.shortest()))
    }

    /// Returns the nearest `f64`, with ties to even, including subnormals. The result is infinite above
    /// the largest `f64`.
    pub fn to_f64(&self) -> f64 {
        let magnitude = f64::from_bits(DOUBLE.nearest(&self.0));
        if self.0.sign() == Ordering::Less { -magnitude } else { magnitude }
    }

    /// Returns true if the number is 0, or if `f64` has full precision at its magnitude, that is, from
    /// [`f64::MIN_POSITIVE`] to [`f64::MAX`].
    pub fn is_representable(&self) -> bool {
        self.is_within(f64::MIN_POSITIVE, f64::MAX)
    }

    /// Returns true if the number is 0, or if `f32` has full precision at its magnitude.
    pub fn is_representable_f32(&self) -> bool {
        self.is_within(f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX))
    }

    fn is_within(&self, smallest: f64, largest: f64) -> bool {
        let magnitude = self.0.abs();
        let (smallest, largest) = (Dyadic::from_f64(smallest), Dyadic::from_f64(largest));
        self.0.is_zero() || (smallest <= magnitude && magnitude <= largest)
    }

    /// Returns `|x - self|` in units in the last place of an `f64` at `self`. Such a unit is the
    /// spacing `2^(floor(log2 |self|) - 52)`, at least `2^-1074` and at most `2^971`. A correctly
    /// rounded `x` is within 0.5 units. The result is infinite if `x` is NaN or infinite.
    pub fn ulps_from(&self, x: f64) -> f64 {
        DOUBLE.ulps(x, &self.0)
    }

    /// Returns `|x - self|` in units in the last place of an `f32` at `self`:
    /// `2^(floor(log2 |self|) - 23)`, at least `2^-149` and at most `2^104`. See [`Real::ulps_from`].
    pub fn ulps_from_f32(&self, x: f32) -> f64 {
        SINGLE.ulps(f64::from(x), &self.0)
    }

    /// Returns `self + other` exactly.
    pub fn plus(&self, other: &Real) -> Real {
        Real(&self.0 + &other.0)
    }

    /// Returns `self - other` exactly.
    pub fn minus(&self, other: &Real) -> Real {
        Real(&self.0 - &other.0)
    }

    /// Returns `self * other` exactly.
    pub fn times(&self, other: &Real) -> Real {
        Real(&self.0 * &other.0)
    }

    /// Returns `self / other` as an `f64`, with a relative error of a few parts in `1e16`. The result
    /// is NaN or infinite if `other` is 0.
    pub fn over(&self, other: &Real) -> f64 {
        // Scale both numbers, so that the divisor is close to 1. Only their ratio matters.
        let scale = -other.0.log2().unwrap_or(0);
        Real(self.0.shifted(scale)).to_f64() / Real(other.0.shifted(scale)).to_f64()
    }

    /// Returns `(self - other) / (self + other)` as an `f64`. For positive numbers, this is their
    /// relative difference, with a relative error of a few parts in `1e16` and an absolute error of
    /// `2^-440`.
    pub fn relative_difference(&self, other: &Real) -> f64 {
        self.minus(other).over(&self.plus(other))
    }
}

impl From<f64> for Real {
    /// Converts a finite `f64` exactly.
    ///
    /// # Panics
    /// Panics if `x` is NaN or infinite.
    fn from(x: f64) -> Real {
        Real(Dyadic::from_f64(x))
    }
}

impl fmt::Debug for Real {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.to_f64())
    }
}

/// Returns the angle between two vectors of any lengths, in radians: `atan2(|a x b|, a . b)` with exact
/// products. It is accurate to a few parts in `1e16` even for small angles. The result is NaN if `b` is
/// not finite, or if one of the vectors is zero.
pub fn angle_between(a: &[Real; 3], b: [f64; 3]) -> f64 {
    if !b.iter().all(|x| x.is_finite()) || b == [0.0; 3] || a.iter().all(|x| x.0.is_zero()) {
        return f64::NAN;
    }
    let (a, b): (Vector, Vector) = (a.clone().map(|x| x.0), b.map(Dyadic::from_f64));
    let (across, along) = (cross(&a, &b), dot(&a, &b));
    let across = dot(&across, &across).sqrt::<Down>(120);
    // Scale both numbers, so that the larger one is close to 1. Only their ratio matters.
    let scale = -across.log2().max(along.log2()).unwrap_or(0);
    Real(across.shifted(scale)).to_f64().atan2(Real(along.shifted(scale)).to_f64())
}
