//! Vectors such as `(5, 0, -7)/sqrt 74`, recognised.

use std::fmt;

use pinhole_core::DVec3;

use super::number::{LARGEST_SHORT, NumberForm, fraction_near, gcd};

/// A vector written with whole numbers and roots.
///
/// ```
/// use pinhole_core::DVec3;
/// use pinhole_lecture::VectorForm;
/// let form = |v: DVec3| VectorForm::recognise(v).map(|form| form.to_string());
/// assert_eq!(
///     form(DVec3::new(5.0, 0.0, -7.0) / 74.0_f64.sqrt()).as_deref(),
///     Some("(5, 0, -7)/sqrt 74")
/// );
/// let s = 0.5_f64.sqrt();
/// assert_eq!(form(DVec3::new(s, 0.0, -s)).as_deref(), Some("(1/sqrt 2, 0, -1/sqrt 2)"));
/// assert_eq!(form(DVec3::new(-4.0, -s, -6.0)).as_deref(), Some("(-4, -1/sqrt 2, -6)"));
/// assert_eq!(form(DVec3::new(0.2, -0.1, -1.0)).as_deref(), Some("(2, -1, -10)/10"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum VectorForm {
    /// Each coordinate by itself: where they are whole, where one form goes for all that are not 0,
    /// and where they share nothing.
    Entries([NumberForm; 3]),
    /// Whole numbers times one factor.
    Common {
        /// The coordinates without the factor.
        whole: [i64; 3],
        /// `1/m`, `1/sqrt k`, `sqrt k` or `sqrt k/m`: its numerator is 1.
        factor: NumberForm,
    },
}

/// Error bound of the quotient of two coordinates, as a share: 4 ulps of each, and rounding.
const RATIO_NOISE: f64 = 10.0 * f64::EPSILON;

/// Largest whole numbers before the factor's numerator is multiplied in.
const LARGEST_WHOLE: u64 = 1 << 10;

/// The limit for single numbers, but the coordinates' quotients have to be fractions too, which is
/// unlikely enough. A unit vector's factor is `1/sqrt k` with `k = n1^2 + n2^2 + n3^2`.
const FACTOR_LIMIT: u64 = 1 << 22;

impl VectorForm {
    /// The form of a vector whose coordinates are within 4 ulps of one: whole numbers up to 1024
    /// times a factor that is a small fraction or the root of one; or, without a common factor,
    /// three [`NumberForm`]s. `None` of any other.
    ///
    /// Random digits have a form by chance less than once in 1e15. Fewer of them are random where a
    /// coordinate is exactly 0: of a unit vector with one such once in 1e9, of a vector along an
    /// axis once in 3e8.
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

    /// Each coordinate's own form.
    pub fn entries(self) -> [NumberForm; 3] {
        match self {
            VectorForm::Entries(entries) => entries,
            VectorForm::Common { whole, factor } => whole.map(|n| factor.times(n)),
        }
    }

    /// Returns true if the form is shorter to read than decimals: each coordinate's form
    /// [is](NumberForm::is_short), or the whole numbers have at most two digits and their factor's
    /// form is short.
    pub fn is_short(self) -> bool {
        match self {
            VectorForm::Entries(entries) => entries.into_iter().all(NumberForm::is_short),
            VectorForm::Common { whole, factor } => {
                factor.is_short() && whole.iter().all(|n| n.unsigned_abs() <= LARGEST_SHORT)
            }
        }
    }

    /// Decimals of the coordinates where they say all of them, see
    /// [`NumberForm::decimals`].
    pub fn decimals(self) -> Option<u32> {
        let [x, y, z] = self.entries().map(NumberForm::decimals);
        Some(x?.max(y?).max(z?))
    }

    /// The vector in `f64`, each coordinate within an ulp and a half.
    pub fn value(self) -> DVec3 {
        DVec3::from_array(self.entries().map(NumberForm::value))
    }
}

/// The form with one factor for all coordinates; `Entries` where that is simpler.
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
    // The largest coordinate's whole number is the others' common denominator.
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
        factor.numerator() * if v[i] < 0.0 { -n } else { n }
    });
    let entries = VectorForm::Entries(whole.map(|n| factor.over_numerator().times(n)));
    let factor = factor.over_numerator();
    let is_plain = factor.root() == 1 && factor.denominator() == 1;
    let is_signs = whole.iter().all(|n| n.abs() <= 1);
    Some(if is_plain || is_signs { entries } else { VectorForm::Common { whole, factor } })
}

impl fmt::Display for VectorForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            VectorForm::Entries([x, y, z]) => write!(f, "({x}, {y}, {z})"),
            VectorForm::Common { whole: [x, y, z], factor } => {
                let (k, m) = (factor.root(), factor.denominator());
                if factor.is_root_below() {
                    return write!(f, "({x}, {y}, {z})/sqrt {k}");
                }
                if k > 1 {
                    write!(f, "sqrt {k} ")?;
                }
                write!(f, "({x}, {y}, {z})")?;
                if m > 1 { write!(f, "/{m}") } else { Ok(()) }
            }
        }
    }
}
