//! Numbers such as `5 sqrt 2` and `1/sqrt 74`, recognised.

use std::fmt;

/// A number written with whole numbers and at most one root: `n sqrt k / m`, or `n / sqrt k`.
///
/// One number has one form. n and m have no common divisor and k no square one; where the number
/// times `sqrt k` is whole, the root stands below (`1/sqrt 2`, as the lecture writes the entries of
/// a basis, `5/sqrt 2`, `2/sqrt 14`), but not of whole multiples of a root (`5 sqrt 2`).
///
/// ```
/// use pinhole_lecture::NumberForm;
/// let form = |x: f64| NumberForm::recognise(x).map(|form| form.to_string());
/// assert_eq!(form(50.0_f64.sqrt()).as_deref(), Some("5 sqrt 2"));
/// assert_eq!(form(-0.5_f64.sqrt()).as_deref(), Some("-1/sqrt 2"));
/// assert_eq!(form(0.75_f64.sqrt()).as_deref(), Some("sqrt 3/2"));
/// assert_eq!(form(-0.15).as_deref(), Some("-3/20"));
/// assert_eq!(form(0.123_456_789), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct NumberForm {
    numerator: i64,
    root: u64,
    denominator: u64,
    is_root_below: bool,
}

/// Largest distance of a number from its form, as a share: up to 4 ulps of noise, which are 4 times
/// the spacing of `f64` at 1 at most, and the roundings of the comparison.
const NOISE: f64 = 6.0 * f64::EPSILON;

/// The largest product of numerator and denominator of a number, or of its square, that counts as
/// recognised: 2^20.
///
/// Of the fractions N/M, about `0.3 * 2^20` lie between a number and e times it (the pairs with
/// `N M <= P` are `P / 2` an e-fold, of which `6 / pi^2` have no common divisor). Each catches the
/// numbers within a share [`NOISE`] of it, and those whose square is within twice that. Together, a
/// number with random digits is taken for a form with a probability below 3e-9.
const LIMIT: u64 = 1 << 20;

/// Largest whole number, and largest number under a root, of a form that [is
/// short](NumberForm::is_short).
pub(super) const LARGEST_SHORT: u64 = 99;
const LARGEST_SHORT_ROOT: u64 = 999;

impl NumberForm {
    /// The number 0.
    pub const ZERO: NumberForm =
        NumberForm { numerator: 0, root: 1, denominator: 1, is_root_below: false };

    /// The form of a number that is within 4 ulps of one: a fraction n/m with `n m <= 2^20`, or the
    /// root of one. `None` of any other number; one with random digits has a form by chance once in
    /// 3e8.
    ///
    /// Found by continued fractions: a fraction so close to a number is one of its convergents
    /// (Legendre; Hardy, Wright, *An Introduction to the Theory of Numbers*, 6th ed., theorem 184).
    pub fn recognise(x: f64) -> Option<NumberForm> {
        NumberForm::within(x, NOISE, LIMIT)
    }

    /// The form of a number that is off by a share `noise` of it, with fractions up to a limit.
    pub(crate) fn within(x: f64, noise: f64, limit: u64) -> Option<NumberForm> {
        if x == 0.0 {
            return Some(NumberForm::ZERO);
        }
        if !x.is_finite() {
            return None;
        }
        let magnitude = x.abs();
        let form = match fraction_near(magnitude, noise, limit) {
            Some((n, m)) => NumberForm::new(n, 1, m),
            None => {
                let (n, m) = fraction_near(magnitude * magnitude, 2.0 * noise, limit)?;
                // sqrt(n / m) = sqrt(n m) / m
                let (square, root) = square_part(n * m);
                NumberForm::new(square, root, m)
            }
        };
        Some(if x < 0.0 { form.negated() } else { form })
    }

    /// `n sqrt k / m` in its one form, for a square-free k.
    fn new(n: u64, k: u64, m: u64) -> NumberForm {
        let common = gcd(n, m);
        let (n, m) = (n / common, m / common);
        let form = |numerator: u64, denominator, is_root_below| NumberForm {
            numerator: numerator as i64,
            root: k,
            denominator,
            is_root_below,
        };
        // n sqrt k / m = n k / (m sqrt k)
        if m > 1 && k > 1 && k.is_multiple_of(m) {
            form(n * (k / m), 1, true)
        } else {
            form(n, m, false)
        }
    }

    /// The number with another sign.
    #[must_use]
    pub fn negated(self) -> NumberForm {
        NumberForm { numerator: -self.numerator, ..self }
    }

    /// A whole multiple of the number, in its one form.
    pub(crate) fn times(self, factor: i64) -> NumberForm {
        let NumberForm { numerator, root, denominator, is_root_below } = self;
        let n = numerator * factor;
        if n == 0 {
            return NumberForm::ZERO;
        }
        let m = if is_root_below { root } else { denominator };
        let form = NumberForm::new(n.unsigned_abs(), root, m);
        if n < 0 { form.negated() } else { form }
    }

    /// The number divided by its numerator, which must not be 0.
    pub(crate) fn over_numerator(self) -> NumberForm {
        NumberForm { numerator: 1, ..self }
    }

    /// n, with the number's sign.
    pub fn numerator(self) -> i64 {
        self.numerator
    }

    /// k, the number under the root, without a square divisor; 1 where there is no root.
    pub fn root(self) -> u64 {
        self.root
    }

    /// m; 1 where the root stands below.
    pub fn denominator(self) -> u64 {
        self.denominator
    }

    /// Returns whether this is `n / sqrt k`, and not `n sqrt k / m`.
    pub fn is_root_below(self) -> bool {
        self.is_root_below
    }

    /// Returns true if the form is shorter to read than its decimals: numerator and denominator have
    /// at most two digits, the number under the root at most three, as in the lecture's own
    /// `w = (21, 4, 15)/sqrt 682`.
    pub fn is_short(self) -> bool {
        let NumberForm { numerator, root, denominator, .. } = self;
        numerator.unsigned_abs() <= LARGEST_SHORT
            && denominator <= LARGEST_SHORT
            && root <= LARGEST_SHORT_ROOT
    }

    /// Decimals of the number where they say all of it: 0 of a whole number, 2 of 1/4. `None`
    /// with a root, and where they never end (or are more than 9).
    pub fn decimals(self) -> Option<u32> {
        let ends = |places: &u32| 10_u64.pow(*places).is_multiple_of(self.denominator);
        if self.root > 1 { None } else { (0..=9).find(ends) }
    }

    /// The number in `f64`, within an ulp and a half.
    pub fn value(self) -> f64 {
        let (n, root) = (self.numerator as f64, (self.root as f64).sqrt());
        if self.is_root_below { n / root } else { n * root / self.denominator as f64 }
    }
}

impl fmt::Display for NumberForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let NumberForm { numerator, root, denominator, is_root_below } = *self;
        if is_root_below {
            return write!(f, "{numerator}/sqrt {root}");
        }
        match (numerator, root) {
            (n, 1) => write!(f, "{n}")?,
            (1, k) => write!(f, "sqrt {k}")?,
            (-1, k) => write!(f, "-sqrt {k}")?,
            (n, k) => write!(f, "{n} sqrt {k}")?,
        }
        if denominator > 1 { write!(f, "/{denominator}") } else { Ok(()) }
    }
}

/// The fraction `(n, m)` with `n m <= limit` that is within a share `noise` of a number greater
/// than 0: the first of the continued fraction's convergents that is.
pub(crate) fn fraction_near(x: f64, noise: f64, limit: u64) -> Option<(u64, u64)> {
    let most = limit as f64;
    if !(0.9 / most..=1.1 * most).contains(&x) {
        return None;
    }
    // x = numerator / denominator, exactly: not subnormal, and not above 2^52.
    let exponent = ((x.to_bits() >> 52) & 0x7ff) as i32 - 1075;
    let numerator = u128::from(x.to_bits() & ((1 << 52) - 1) | 1 << 52);
    let (mut above, mut below) = (numerator, 1_u128 << exponent.unsigned_abs());
    let (mut before, mut convergent) = ((0_u128, 1_u128), (1_u128, 0_u128));
    while below != 0 {
        let whole = above / below;
        (above, below) = (below, above % below);
        let next = (whole * convergent.0 + before.0, whole * convergent.1 + before.1);
        (before, convergent) = (convergent, next);
        let (n, m) = convergent;
        if n * m > u128::from(limit) {
            return None;
        }
        if n > 0 && (n as f64 / m as f64 - x).abs() <= noise * x {
            return Some((n as u64, m as u64));
        }
    }
    None
}

/// `(s, k)` with `x = s^2 k` and k without a square divisor.
fn square_part(x: u64) -> (u64, u64) {
    let (mut square, mut free, mut rest, mut p) = (1, 1, x, 2);
    while p * p <= rest {
        while rest.is_multiple_of(p * p) {
            (square, rest) = (square * p, rest / (p * p));
        }
        if rest.is_multiple_of(p) {
            (free, rest) = (free * p, rest / p);
        }
        p += 1;
    }
    (square, free * rest)
}

/// The greatest common divisor.
pub(crate) fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}
