//! Formulas for numbers, vectors and the lecture's names.
//!
//! A number is written in its exact form (such as `1/sqrt(2)`) if the settings ask for exact forms and a
//! short one is recognised ([`NumberForm::is_short`]). Otherwise it is written as a decimal.
//!
//! `=` is used only between exact values: exact forms, given numbers with all their digits, and terminating
//! decimals. All other decimals are rounded, and `≈` is before and after them.

use pinhole_core::{DVec3, Pixel};
use pinhole_lecture::{NumberForm, Rounding, VectorForm};

use crate::formula::{
    Formula, Operator, SymbolInk, fraction, given, negative, number, parentheses, power, rounded,
    row, square_root, tuple, word,
};
use crate::given::{Given, GivenVector};

/// The format of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NumberFormat {
    /// The rounding of decimals.
    pub rounding: Rounding,
    /// True if numbers with a short exact form are written in that form instead of as decimals.
    pub exact: bool,
    /// True if rows and columns are counted from 1, as some courses do.
    pub from_one: bool,
}

impl NumberFormat {
    /// Returns a number as a formula, in decimals. It is marked as rounded unless the decimals are exact.
    pub(super) fn decimal(self, x: f64) -> Formula {
        let digits = self.rounding.text(x);
        if self.rounding.is_exact(x) { number(&digits) } else { rounded(&digits) }
    }

    /// Returns the formula of a number that the user has given. It counts as exact if all its digits are
    /// shown.
    pub(super) fn given(self, name: Given, x: f64) -> Formula {
        let digits = self.rounding.text(x);
        let shown = match self.form(x) {
            _ if digits.parse() == Ok(x) => number(&digits),
            Some(form) => exact(form),
            None => self.decimal(x),
        };
        given(name, shown)
    }

    /// Returns a given vector as a formula.
    pub(super) fn given_vector(self, name: GivenVector, v: DVec3) -> Formula {
        let coordinates = name.coordinates().into_iter().zip(v.to_array());
        tuple(coordinates.map(|(name, x)| self.given(name, x)))
    }

    /// Returns the vector with its coordinates as decimals.
    pub(super) fn decimals(self, v: DVec3) -> Formula {
        tuple(v.to_array().map(|x| self.decimal(x)))
    }

    /// Returns the number's exact form. Returns `None` if the settings do not ask for exact forms, if the
    /// number has no short one, or if its decimal is exact already.
    fn form(self, x: f64) -> Option<NumberForm> {
        let recognised = || NumberForm::recognise(x).filter(|form| form.is_short());
        if self.exact { recognised().filter(|_| !self.rounding.is_exact(x)) } else { None }
    }

    fn vector_form(self, v: DVec3) -> Option<VectorForm> {
        let recognised = || VectorForm::recognise(v).filter(|form| form.is_short());
        let are_whole = || v.to_array().into_iter().all(|x| self.rounding.is_exact(x));
        if self.exact { recognised().filter(|_| !are_whole()) } else { None }
    }

    /// Returns a number as a formula: in exact form, such as `1/sqrt(2)`, if the settings ask for it and a
    /// short one is recognised; otherwise as a decimal.
    pub(super) fn scalar(self, x: f64) -> Formula {
        self.form(x).map_or_else(|| self.decimal(x), exact)
    }

    /// Returns a vector as a formula: in exact form, such as `(1, 0, 1)/sqrt(2)`, if the settings ask for it
    /// and a short one is recognised; otherwise with its coordinates as decimals.
    pub(super) fn vector(self, v: DVec3) -> Formula {
        self.vector_form(v).map_or_else(|| self.decimals(v), |form| self.exact_vector(form))
    }

    /// Returns a number as the formula of a denominator: in exact form, as [`NumberFormat::scalar`] does, if
    /// that is not itself a fraction; otherwise as a decimal.
    pub(super) fn divisor(self, x: f64) -> Formula {
        let form = self.form(x).filter(|form| !form.is_root_below && form.denominator == 1);
        form.map_or_else(|| self.decimal(x), exact)
    }

    /// Returns the formula of a vector whose exact form was recognised. Coordinates that decimals give
    /// exactly are written as decimals.
    fn exact_vector(self, form: VectorForm) -> Formula {
        let VectorForm::Common { whole, factor } = form else {
            return tuple(form.entries().map(|entry| self.scalar(entry.value())));
        };
        let (k, m) = (factor.root, factor.denominator);
        let whole = tuple(whole.map(|n| number(&n.to_string())));
        if factor.is_root_below {
            return fraction(whole, square_root(number(&k.to_string())));
        }
        let above = if k > 1 { row([square_root(number(&k.to_string())), whole]) } else { whole };
        if m > 1 { fraction(above, number(&m.to_string())) } else { above }
    }

    /// Returns `a t² + b t + c` as it is written by hand: without terms that are 0, and without a factor
    /// of 1.
    pub(super) fn quadratic(self, coefficients: [f64; 3]) -> Formula {
        let powers = [Some(power(T, "2")), Some(T), None];
        let terms = coefficients.into_iter().zip(powers).filter(|(factor, _)| *factor != 0.0);
        let terms = terms.map(|(factor, power)| {
            let size = self.scalar(factor.abs());
            let is_one = power.is_some() && size == number("1");
            (factor < 0.0, row((!is_one).then_some(size).into_iter().chain(power)))
        });
        let sum = terms.fold(None, |sum, (is_negative, term)| match (sum, is_negative) {
            (None, false) => Some(term),
            (None, true) => Some(negative(term)),
            (Some(sum), false) => Some(joined(sum, Operator::Plus, term)),
            (Some(sum), true) => Some(minus(sum, term)),
        });
        sum.unwrap_or_else(|| number("0"))
    }

    /// Converts an angle in radians to a formula in degrees.
    pub(super) fn degrees(self, angle: f64) -> Formula {
        match self.decimal(angle.to_degrees()) {
            Formula::Number(digits) => Formula::Number(digits + "°"),
            Formula::Rounded(digits) => Formula::Rounded(digits + "°"),
            other => other,
        }
    }

    /// Returns a pixel's row and column, counted from 0 or 1 according to the setting.
    pub(super) fn counted(self, pixel: Pixel) -> (u32, u32) {
        let from = u32::from(self.from_one);
        (pixel.row + from, pixel.column + from)
    }
}

/// Returns the formula of a recognised number.
fn exact(form: NumberForm) -> Formula {
    let (n, k, m) = (form.numerator, form.root, form.denominator);
    let size = n.unsigned_abs();
    let sign = (n < 0).then(|| Formula::from(Operator::Negative));
    let whole = || number(&size.to_string());
    let radical = || square_root(number(&k.to_string()));
    let magnitude = if form.is_root_below {
        fraction(whole(), radical())
    } else {
        let above = match (size, k) {
            (_, 1) => whole(),
            (1, _) => radical(),
            _ => row([whole(), radical()]),
        };
        if m == 1 { above } else { fraction(above, number(&m.to_string())) }
    };
    row(sign.into_iter().chain([magnitude]))
}

pub(super) const U: Formula = Formula::Vector("u", SymbolInk::U);
pub(super) const V: Formula = Formula::Vector("v", SymbolInk::V);
pub(super) const W: Formula = Formula::Vector("w", SymbolInk::W);
pub(super) const EYE: Formula = Formula::Vector("eye", SymbolInk::Text);
pub(super) const AT: Formula = Formula::Vector("at", SymbolInk::Given);
pub(super) const VIEW: Formula = Formula::Vector("view", SymbolInk::Given);
pub(super) const UP: Formula = Formula::Vector("up", SymbolInk::Given);
pub(super) const P: Formula = Formula::Vector("p", SymbolInk::Ray);
pub(super) const D: Formula = Formula::Vector("d", SymbolInk::Ray);
pub(super) const N: Formula = Formula::Vector("n", SymbolInk::Text);
pub(super) const CENTRE: Formula = Formula::Vector("centre", SymbolInk::Text);
pub(super) const POINT: Formula = Formula::Vector("point", SymbolInk::Text);
pub(super) const HIT: Formula = Formula::Vector("hit", SymbolInk::Text);
pub(super) const T: Formula = Formula::Scalar("t");
pub(super) const DISTANCE: Formula = Formula::Scalar("distance");

/// Returns `left = right`, or `left ≈ right` if one of the two sides is rounded.
pub(super) fn equation(left: Formula, right: Formula) -> Formula {
    let is_rounded = left.ends_rounded() || right.begins_rounded();
    let relation = if is_rounded { Operator::Approximately } else { Operator::Equals };
    joined(left, relation, right)
}

/// Returns `left sign right`.
pub(super) fn joined(left: Formula, sign: Operator, right: Formula) -> Formula {
    row([left, sign.into(), right])
}

/// Returns `a − b`.
pub(super) fn minus(a: Formula, b: Formula) -> Formula {
    joined(a, Operator::Minus, b)
}

/// Returns `a × b`.
pub(super) fn times(a: Formula, b: Formula) -> Formula {
    joined(a, Operator::Times, b)
}

/// Returns `a · b`.
pub(super) fn dot(a: Formula, b: Formula) -> Formula {
    joined(a, Operator::Dot, b)
}

/// Returns `normalize(x)`.
pub(super) fn normalize(inner: Formula) -> Formula {
    row([word("normalize"), parentheses(inner)])
}
