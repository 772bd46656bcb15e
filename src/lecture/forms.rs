//! Recognises numbers such as `5√2` and `1/√74`, and vectors such as `(5, 0, -7)/√74`.

use std::fmt;

use pinhole_core::DVec3;

/// A number written with integers and at most one square root: `n sqrt k / m`, or `n / sqrt k`.
///
/// Each number has only one form. n and m have no common divisor, and k is square-free (has no square
/// divisor). If the number times `sqrt k` is an integer, the root is in the denominator, as in the
/// lecture's bases (`1/sqrt 2`, `5/sqrt 2`, `2/sqrt 14`), unless the number is an integer multiple of
/// the root (`5 sqrt 2`).
///
/// ```
/// use pinhole_lecture::NumberForm;
/// let form = |x: f64| NumberForm::recognise(x).map(|form| form.to_string());
/// assert_eq!(form(50.0_f64.sqrt()).as_deref(), Some("5√2"));
/// assert_eq!(form(-0.5_f64.sqrt()).as_deref(), Some("−1/√2"));
/// assert_eq!(form(0.75_f64.sqrt()).as_deref(), Some("√3/2"));
/// assert_eq!(form(-0.15).as_deref(), Some("−3/20"));
/// assert_eq!(form(0.123_456_789), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct NumberForm {
    /// n, with the number's sign.
    pub numerator: i64,
    /// k, the square-free number under the root; 1 if there is no root.
    pub root: u64,
    /// m; 1 if the root is in the denominator.
    pub denominator: u64,
    /// True if the form is `n / sqrt k` rather than `n sqrt k / m`.
    pub is_root_below: bool,
}

/// Maximum relative difference between a number and a form that counts as its form. It allows for an
/// error of 4 ulps in the number, each at most the spacing of `f64` at 1, and for rounding errors of
/// the comparison.
const NOISE: f64 = 6.0 * f64::EPSILON;

/// Maximum product P of numerator and denominator of a recognised fraction. A number is recognised if
/// it or its square is such a fraction.
///
/// P is small enough for chance matches to be rare. Between a number and e times that number, there are
/// about `P / 2` pairs with `N M <= P`, and a fraction `6 / pi^2` of them have no common divisor, which
/// makes about `0.3 P` fractions N/M. Each matches the numbers within a relative difference of
/// [`NOISE`], and the numbers whose square is within twice that. In total, a number with random digits
/// is mistaken for a form with a probability below 3e-9.
const LIMIT: u64 = 1 << 20;

/// Maximum whole number, and maximum number under a root, in a form that [is
/// short](NumberForm::is_short).
const LARGEST_SHORT: u64 = 99;
const LARGEST_SHORT_ROOT: u64 = 999;

impl NumberForm {
    /// The number 0.
    pub const ZERO: NumberForm =
        NumberForm { numerator: 0, root: 1, denominator: 1, is_root_below: false };

    /// Returns the form of a number that is within 4 ulps of a fraction n/m with `n m <= 2^20`, or of
    /// the square root of such a fraction. Returns `None` for any other number. A number with random
    /// digits has a form with a probability of 1 in 3e8.
    ///
    /// The method is that of continued fractions: a fraction so close to a number is one of the
    /// number's convergents (Legendre; Hardy, Wright, *An Introduction to the Theory of Numbers*, 6th
    /// ed., theorem 184).
    pub fn recognise(x: f64) -> Option<NumberForm> {
        NumberForm::within(x, NOISE, LIMIT)
    }

    /// Does the same as [`NumberForm::recognise`] with other limits: the form may differ from the
    /// number by a relative difference of `noise`, and is made from a fraction n/m with `n m <= limit`.
    fn within(x: f64, noise: f64, limit: u64) -> Option<NumberForm> {
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

    /// Creates the unique form of `n sqrt k / m`. k must be square-free.
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

    /// Returns the number with the opposite sign.
    #[must_use]
    pub fn negated(self) -> NumberForm {
        NumberForm { numerator: -self.numerator, ..self }
    }

    /// Returns the number times the integer `factor`, in its unique form.
    fn times(self, factor: i64) -> NumberForm {
        let NumberForm { numerator, root, denominator, is_root_below } = self;
        let n = numerator * factor;
        if n == 0 {
            return NumberForm::ZERO;
        }
        let m = if is_root_below { root } else { denominator };
        let form = NumberForm::new(n.unsigned_abs(), root, m);
        if n < 0 { form.negated() } else { form }
    }

    /// Returns the number divided by its numerator. The numerator must not be 0.
    fn over_numerator(self) -> NumberForm {
        NumberForm { numerator: 1, ..self }
    }

    /// Returns true if the form is easier to read than decimals: numerator and denominator have at most
    /// two digits, and the number under the root has at most three, as in the lecture's own `w = (21,
    /// 4, 15)/sqrt 682`.
    pub fn is_short(self) -> bool {
        let NumberForm { numerator, root, denominator, .. } = self;
        numerator.unsigned_abs() <= LARGEST_SHORT
            && denominator <= LARGEST_SHORT
            && root <= LARGEST_SHORT_ROOT
    }

    /// Returns the number of decimals with which the number can be written exactly: 0 for an integer, 2
    /// for 1/4. Returns `None` if there is a root, or if more than 9 decimals or infinitely many are
    /// needed.
    pub fn decimals(self) -> Option<u32> {
        let ends = |places: &u32| 10_u64.pow(*places).is_multiple_of(self.denominator);
        if self.root > 1 { None } else { (0..=9).find(ends) }
    }

    /// Returns the number as an `f64`, accurate to within one and a half ulps.
    pub fn value(self) -> f64 {
        let (n, root) = (self.numerator as f64, (self.root as f64).sqrt());
        if self.is_root_below { n / root } else { n * root / self.denominator as f64 }
    }
}

impl fmt::Display for NumberForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let NumberForm { numerator, root, denominator, is_root_below } = *self;
        let sign = if numerator < 0 { "−" } else { "" };
        match numerator.unsigned_abs() {
            n if is_root_below => return write!(f, "{sign}{n}/√{root}"),
            n if root == 1 => write!(f, "{sign}{n}")?,
            1 => write!(f, "{sign}√{root}")?,
            n => write!(f, "{sign}{n}√{root}")?,
        }
        if denominator > 1 { write!(f, "/{denominator}") } else { Ok(()) }
    }
}

/// Returns the first convergent `(n, m)` of the continued fraction of `x` with a relative difference of
/// at most `noise`. `x` must be positive. Returns `None` if no such convergent has `n m <= limit`.
fn fraction_near(x: f64, noise: f64, limit: u64) -> Option<(u64, u64)> {
    let most = limit as f64;
    if !(0.9 / most..=1.1 * most).contains(&x) {
        return None;
    }
    // x = numerator / denominator, exactly, because x is not subnormal and not above 2^52.
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

/// Returns `(s, k)` such that `x = s^2 k` and k is square-free.
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

/// Returns the greatest common divisor.
fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// A vector whose coordinates are written with integers and square roots, such as `(5, 0, -7)/√74`.
///
/// ```
/// use pinhole_core::DVec3;
/// use pinhole_lecture::VectorForm;
/// let form = VectorForm::recognise(DVec3::new(5.0, 0.0, -7.0) / 74.0_f64.sqrt());
/// let Some(VectorForm::Common { whole, factor }) = form else { panic!("{form:?}") };
/// assert_eq!((whole, factor.to_string().as_str()), ([5, 0, -7], "1/√74"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum VectorForm {
    /// A separate form for each coordinate. This is used if all coordinates are integers, if all
    /// nonzero ones have the same form, or if they have no common factor.
    Entries([NumberForm; 3]),
    /// Whole numbers times one factor.
    Common {
        /// The coordinates without the factor.
        whole: [i64; 3],
        /// `1/m`, `1/sqrt k`, `sqrt k` or `sqrt k/m`; its numerator is 1.
        factor: NumberForm,
    },
}

/// Maximum relative error of the quotient of two coordinates: 4 ulps of each, and rounding.
const RATIO_NOISE: f64 = 10.0 * f64::EPSILON;

/// Maximum magnitude of the integers that remain when a common factor is taken out of a vector, before
/// they are multiplied by the factor's numerator.
const LARGEST_WHOLE: u64 = 1 << 10;

/// The limit that replaces [`LIMIT`] for a vector's common factor. It is larger, because the quotients
/// of the coordinates must be fractions, too, which makes a match by chance unlikely enough. The factor
/// of a unit vector with the integers n1, n2, n3 is `1/sqrt k` with `k = n1^2 + n2^2 + n3^2`.
const FACTOR_LIMIT: u64 = 1 << 22;

impl VectorForm {
    /// Returns the form of a vector whose coordinates are within 4 ulps of that form. It consists of
    /// three integers up to 1024 and their common factor, which is a small fraction or the square root
    /// of one. If there is no common factor, it consists of three [`NumberForm`]s. Returns `None` for
    /// any other vector.
    ///
    /// A vector with random digits has a form with a probability below 1 in 1e15. If a coordinate is
    /// exactly 0, fewer digits are random: the probability is 1 in 1e9 for a unit vector with one zero
    /// coordinate, and 1 in 3e8 for a vector along an axis.
    pub fn recognise(v: DVec3) -> Option<VectorForm> {
        if !v.is_finite() {
            return None;
        }
        match common(v) {
            Some(common) => Some(common),
            None => {
                let [x, y, z] = v.to_array().map(NumberForm::recognise);
                Some(VectorForm::Entries([x?, y?, z?]))
            }
        }
    }

    /// Returns the form of each coordinate.
    pub fn entries(self) -> [NumberForm; 3] {
        match self {
            VectorForm::Entries(entries) => entries,
            VectorForm::Common { whole, factor } => whole.map(|n| factor.times(n)),
        }
    }

    /// Returns true if the form is easier to read than decimals: either each coordinate's form [is
    /// short](NumberForm::is_short), or the integers have at most two digits and the form of their
    /// common factor is short.
    pub fn is_short(self) -> bool {
        match self {
            VectorForm::Entries(entries) => entries.into_iter().all(NumberForm::is_short),
            VectorForm::Common { whole, factor } => {
                factor.is_short() && whole.iter().all(|n| n.unsigned_abs() <= LARGEST_SHORT)
            }
        }
    }
}

/// Returns the form with a common factor for all coordinates, or [`VectorForm::Entries`] if that is
/// simpler. Returns `None` if there is no common factor.
fn common(v: DVec3) -> Option<VectorForm> {
    let largest = v.abs().max_element();
    if largest == 0.0 {
        return Some(VectorForm::Entries([NumberForm::ZERO; 3]));
    }
    let mut ratios = [(0, 1); 3];
    for (ratio, x) in ratios.iter_mut().zip(v.to_array()) {
        if x != 0.0 {
            let limit = LARGEST_WHOLE * LARGEST_WHOLE;
            *ratio = fraction_near((x / largest).abs(), RATIO_NOISE, limit)?;
        }
    }
    // The whole number of the largest coordinate is the common denominator of the other ratios.
    let denominator = ratios.iter().fold(1, |all, (_, m)| all / gcd(all, *m) * m);
    if denominator > LARGEST_WHOLE {
        return None;
    }
    let factor = match v.to_array().iter().filter(|x| **x != 0.0).count() {
        1 => NumberForm::recognise(largest)?,
        _ => NumberForm::within(largest / denominator as f64, RATIO_NOISE, FACTOR_LIMIT)?,
    };
    let whole: [i64; 3] = std::array::from_fn(|i| {
        let (n, m) = ratios[i];
        let n = (n * (denominator / m)) as i64;
        factor.numerator * if v[i] < 0.0 { -n } else { n }
    });
    let entries = VectorForm::Entries(whole.map(|n| factor.over_numerator().times(n)));
    let factor = factor.over_numerator();
    let is_plain = factor.root == 1 && factor.denominator == 1;
    let is_signs = whole.iter().all(|n| n.abs() <= 1);
    Some(if is_plain || is_signs { entries } else { VectorForm::Common { whole, factor } })
}
