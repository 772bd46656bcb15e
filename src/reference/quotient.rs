//! Solutions of quadratic equations whose coefficients are [`Surd`]s: `(p + q sqrt(e)) / d`.

use std::cmp::Ordering;

use crate::dyadic::Dyadic;
use crate::interval::Interval;
use crate::real::Real;
use crate::surd::{Field, Surd, bits_of_level, product, sign_of_sum};

/// The number `(p + q sqrt(e)) / d`, with `e >= 0` and `d > 0`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Quotient {
    pub(crate) p: Surd,
    pub(crate) q: Surd,
    pub(crate) e: Surd,
    pub(crate) d: Surd,
}

/// Number of precisions (see [`bits_of_level`]) with which interval arithmetic tries to find the sign
/// of a sum that contains square roots, before algebra decides it.
const SIGN_LEVELS: usize = 2;

impl Quotient {
    pub(crate) fn without_root(p: Surd, d: Surd) -> Quotient {
        Quotient { p, q: Surd::ZERO, e: Surd::ZERO, d }
    }

    /// Returns the proven sign of the number.
    pub(crate) fn sign(&self, field: &Field) -> Ordering {
        for level in 0..SIGN_LEVELS {
            if let Some(sign) = self.numerator(field, level).sign() {
                return sign;
            }
        }
        sign_with_root(field, &self.p, &self.q, &self.e)
    }

    fn numerator(&self, field: &Field, level: usize) -> Interval {
        field
            .interval(&self.p, level)
            .plus(&root_term(field, &self.q, &self.e, level), bits_of_level(level))
    }

    /// Returns the proven order of two numbers.
    pub(crate) fn cmp(&self, other: &Quotient, field: &Field) -> Ordering {
        if self == other {
            return Ordering::Equal;
        }
        // self - other = (p + q sqrt(e) + r sqrt(f)) / (d d')
        let (p, q, r) = if self.d == other.d {
            (self.p.minus(&other.p), self.q.clone(), other.q.negated())
        } else {
            let p = field.times(&self.p, &other.d).minus(&field.times(&other.p, &self.d));
            (p, field.times(&self.q, &other.d), field.times(&other.q, &self.d).negated())
        };
        sign_with_roots(field, &p, (&q, &self.e), (&r, &other.e))
    }

    /// Returns an interval around the number, computed with the bits of this level (see
    /// [`bits_of_level`]). Returns `None` if they are too few to distinguish `d` from 0.
    pub(crate) fn interval(&self, field: &Field, level: usize) -> Option<Interval> {
        let d = field.interval(&self.d, level);
        (d.sign() == Some(Ordering::Greater))
            .then(|| self.numerator(field, level).over(&d, bits_of_level(level)))
    }

    /// Returns the number with at least 440 significant bits.
    pub(crate) fn value(&self, field: &Field) -> Real {
        let mut is_known_not_zero = false;
        for level in 1.. {
            let numerator = self.numerator(field, level);
            match numerator.sign() {
                Some(Ordering::Equal) => break,
                Some(_) => {
                    let value = self.interval(field, level);
                    if let Some(value) = value.as_ref().and_then(Real::within) {
                        return value;
                    }
                }
                None if is_known_not_zero => {}
                None if self.sign(field) == Ordering::Equal => break,
                None => is_known_not_zero = true,
            }
        }
        Real(Dyadic::ZERO)
    }
}

fn root_term(field: &Field, factor: &Surd, radicand: &Surd, level: usize) -> Interval {
    let bits = bits_of_level(level);
    if factor.is_zero() {
        return Interval::exactly(&Dyadic::ZERO, bits);
    }
    field.interval(factor, level).times(&field.interval(radicand, level).sqrt(bits), bits)
}

/// Returns the sign of `p + q sqrt(e)`, which is found by squaring; see [`crate::surd`].
fn sign_with_root(field: &Field, p: &Surd, q: &Surd, e: &Surd) -> Ordering {
    sign_of_sum(field.sign(p), product(field.sign(q), field.sign(e)), || {
        field.sign(&field.square(p).minus(&field.times(&field.square(q), e)))
    })
}

/// Returns the sign of `p + q sqrt(e) + r sqrt(f)`. Let `x = p + q sqrt(e)` and `y = r sqrt(f)`. If
/// they have opposite signs, the result is the sign of x times that of
/// `x^2 - y^2 = (p^2 + q^2 e - r^2 f) + 2 p q sqrt(e)`, which contains one root less.
fn sign_with_roots(
    field: &Field,
    p: &Surd,
    (q, e): (&Surd, &Surd),
    (r, f): (&Surd, &Surd),
) -> Ordering {
    for level in 0..SIGN_LEVELS {
        let bits = bits_of_level(level);
        let roots = root_term(field, q, e, level).plus(&root_term(field, r, f, level), bits);
        if let Some(sign) = field.interval(p, level).plus(&roots, bits).sign() {
            return sign;
        }
    }
    sign_of_sum(sign_with_root(field, p, q, e), product(field.sign(r), field.sign(f)), || {
        let squares = field.square(p).plus(&field.times(&field.square(q), e));
        let without = squares.minus(&field.times(&field.square(r), f));
        let with = field.times(p, q).scaled(&Dyadic::power_of_two(1));
        sign_with_root(field, &without, &with, e)
    })
}
