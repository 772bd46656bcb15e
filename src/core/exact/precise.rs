//! A root's `t`, with more digits and a wider range than those of `f64`.

use std::cmp::Ordering;

use crate::exact::double_double::{DoubleDouble, U2};
use crate::exact::dyadic::Dyadic;
use crate::exact::scale::ldexp;

/// The largest relative error of a [`Precise`]: just below 2^-93, which is 2^-40 of an ulp of `f64`.
pub(crate) const T_DOUBT: f64 = 0.98 * 8192.0 * U2;

/// Returns whether a sum `t d + term`, in which the two terms cancel, is so small compared with `term`
/// that it may be nothing but the error of t. Callers replace such a sum by 0.
pub(crate) fn is_noise(sum: f64, term: f64) -> bool {
    sum.abs() < 2.0 * T_DOUBT * term.abs()
}

/// Rounds a number to the nearest `f64`, ties to even. The number must lie between the two given `f64`,
/// which are neighbours, or slightly beyond one of them. `compare` compares the number with their
/// midpoint.
pub(crate) fn rounded([low, high]: [f64; 2], compare: impl FnOnce(&Dyadic) -> Ordering) -> f64 {
    let half = |x: f64| &Dyadic::from(x) * &Dyadic::from(0.5);
    // The distance to the number after the largest one would equal that to the number before it.
    let middle = if low.is_infinite() {
        &Dyadic::from(high) + &half(high - high.next_up())
    } else if high.is_infinite() {
        &Dyadic::from(low) + &half(low - low.next_down())
    } else {
        &half(low) + &half(high)
    };
    match compare(&middle) {
        Ordering::Less => low,
        Ordering::Equal if low.to_bits().is_multiple_of(2) => low,
        Ordering::Equal | Ordering::Greater => high,
    }
}

/// The number `value * 2^scale`, with a relative error of at most [`T_DOUBT`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Precise {
    pub(crate) value: DoubleDouble,
    pub(crate) scale: i32,
}

impl Precise {
    /// The number 0, exactly.
    pub(crate) const ZERO: Precise = Precise { value: DoubleDouble { hi: 0.0, lo: 0.0 }, scale: 0 };

    pub(crate) fn new(value: DoubleDouble, scale: i32) -> Precise {
        Precise { value, scale }
    }

    /// Returns the nearest `f64`. A number too large for `f64` becomes infinite. One too small becomes
    /// the smallest positive `f64`. Both keep their sign.
    pub(crate) fn to_f64(self) -> f64 {
        let Precise { value, scale } = self;
        let rounded = ldexp(value.hi, scale);
        if value.hi == 0.0 || rounded.is_normal() && rounded.abs() > f64::MIN_POSITIVE {
            return rounded;
        }
        if rounded.is_infinite() {
            return rounded;
        }
        // Subnormal: both parts are rounded together, once.
        let sum = &Dyadic::from(value.hi) + &Dyadic::from(value.lo);
        let rounded = sum.rounded_times(scale);
        if rounded == 0.0 { f64::from_bits(1).copysign(value.hi) } else { rounded }
    }

    /// Returns the smallest and the largest `f64` to which the exact number may round, given that `self`
    /// is known to approximate it with a relative error of at most `doubt`.
    pub(crate) fn nearest(self, doubt: f64) -> [f64; 2] {
        let off = DoubleDouble::from(1.01 * doubt * self.value.hi.abs());
        [self.value - off, self.value + off].map(|value| Precise { value, ..self }.to_f64())
    }

    /// Compares two numbers; returns `None` if their difference is smaller than their errors.
    pub(crate) fn compare(self, other: Precise) -> Option<Ordering> {
        use std::cmp::Ordering::{Greater, Less};
        let sign = |x: f64| x.total_cmp(&0.0);
        let (x, y) = (self.value.hi + 0.0, other.value.hi + 0.0);
        if x == 0.0 || y == 0.0 || sign(x) != sign(y) {
            return if x == y { None } else { Some(if x < y { Less } else { Greater }) };
        }
        let Some((difference, doubt, _)) = self.difference(other) else {
            let is_larger = (other.scale < self.scale) == (x > 0.0);
            return Some(if is_larger { Greater } else { Less });
        };
        (difference.abs() > doubt).then_some(if difference < 0.0 { Less } else { Greater })
    }

    /// Returns `self - other`, an error bound, and the sum of the absolute values of both, all in the
    /// same unit. Returns `None` if one number is so much larger that the other is negligible.
    pub(crate) fn difference(self, other: Precise) -> Option<(f64, f64, f64)> {
        let k = other.scale - self.scale;
        if k.abs() > 2000 {
            return None;
        }
        let (a, b) = if k < 0 {
            (self.value, other.value.scaled(k))
        } else {
            (self.value.scaled(-k), other.value)
        };
        let sizes = a.hi.abs() + b.hi.abs();
        Some(((a - b).hi, 2.0 * T_DOUBT * sizes, sizes))
    }
}
