//! Interval arithmetic: lower and upper bounds of a number that is not known exactly, such as a square
//! root.

use std::cmp::Ordering;

use dashu_float::round::mode::{Down, Up};

use crate::dyadic::Dyadic;

/// All numbers from `low` to `high`. Each operation rounds its bounds outwards to `bits` significant
/// bits, so that the interval contains the true result (Moore, *Interval Analysis*, 1966).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Interval {
    pub(crate) low: Dyadic,
    pub(crate) high: Dyadic,
}

impl Interval {
    pub(crate) fn exactly(x: &Dyadic, bits: usize) -> Interval {
        Interval { low: x.rounded::<Down>(bits), high: x.rounded::<Up>(bits) }
    }

    pub(crate) fn plus(&self, other: &Interval, bits: usize) -> Interval {
        Interval {
            low: (&self.low + &other.low).rounded::<Down>(bits),
            high: (&self.high + &other.high).rounded::<Up>(bits),
        }
    }

    pub(crate) fn times(&self, other: &Interval, bits: usize) -> Interval {
        let corners = [
            &self.low * &other.low,
            &self.low * &other.high,
            &self.high * &other.low,
            &self.high * &other.high,
        ];
        let [mut low, mut high] = [&corners[0]; 2];
        for corner in &corners[1..] {
            low = low.min(corner);
            high = high.max(corner);
        }
        Interval { low: low.rounded::<Down>(bits), high: high.rounded::<Up>(bits) }
    }

    /// Returns `self / divisor`. All numbers in the divisor must be positive.
    pub(crate) fn over(&self, divisor: &Interval, bits: usize) -> Interval {
        let farther = |x: &Dyadic, outward: Ordering| {
            if x.sign() == outward { &divisor.low } else { &divisor.high }
        };
        let (low, high) = (&self.low, &self.high);
        Interval {
            low: low.divided::<Down>(farther(low, Ordering::Less), bits),
            high: high.divided::<Up>(farther(high, Ordering::Greater), bits),
        }
    }

    /// Returns an interval around the square root. The true number must be known not to be negative,
    /// although the interval's lower bound may be.
    pub(crate) fn sqrt(&self, bits: usize) -> Interval {
        Interval {
            low: (&self.low).max(&Dyadic::ZERO).sqrt::<Down>(bits),
            high: (&self.high).max(&Dyadic::ZERO).sqrt::<Up>(bits),
        }
    }

    /// Returns the sign of the numbers in the interval if it is the same for all of them; otherwise
    /// `None`.
    pub(crate) fn sign(&self) -> Option<Ordering> {
        let sign = self.low.sign();
        (sign == self.high.sign() && (sign != Ordering::Equal || self.low == self.high))
            .then_some(sign)
    }

    /// Returns true if the relative difference of any two numbers in the interval is at most `2^-bits`.
    pub(crate) fn is_narrow(&self, bits: i64) -> bool {
        if self.low == self.high {
            return true;
        }
        if self.sign().is_none() {
            return false;
        }
        let width = (&self.high - &self.low).log2();
        width.zip(self.low.log2().min(self.high.log2())).is_some_and(|(w, x)| w < x - bits)
    }

    /// Returns the number in the interval that has the fewest significant bits. If the true number has
    /// few bits, such as a `t` of 4 or 0.25, it is recovered exactly, although square roots were
    /// computed on the way.
    pub(crate) fn shortest(&self) -> Dyadic {
        if self.low == self.high {
            return self.low.clone();
        }
        if self.sign().is_none() {
            return Dyadic::ZERO;
        }
        // Rounding up to more bits never gives a larger number.
        let (mut too_few, mut enough) = (0, self.low.length());
        while enough - too_few > 1 {
            let bits = (too_few + enough) / 2;
            if self.low.rounded::<Up>(bits) <= self.high {
                enough = bits;
            } else {
                too_few = bits;
            }
        }
        self.low.rounded::<Up>(enough)
    }
}
