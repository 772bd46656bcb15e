//! Numbers and vectors as formulas: exact where their form is recognised, to so many digits
//! otherwise, or both.

use pinhole_core::{DVec3, Pixel};
use pinhole_lecture::{NumberForm, VectorForm};

use crate::formula::{Formula, Operator, fraction, number, root, rounded, row, tuple};
use crate::number::significant;

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Numbers {
    /// Significant digits.
    pub(super) digits: usize,
    /// Rows and columns counted from 1, as the course does.
    pub(super) from_one: bool,
}

impl Numbers {
    /// The number to so many digits.
    pub(super) fn decimal(self, x: f64) -> Formula {
        let digits = significant(x, self.digits);
        if self.is_whole(x) { number(&digits) } else { rounded(&digits) }
    }

    /// Whether so many digits are all that it has, but for the noise of rounding.
    fn is_whole(self, x: f64) -> bool {
        let fits = |x: f64| significant(x, self.digits).parse() == Ok(x);
        let recognised = || NumberForm::recognise(x).filter(|form| form.decimals().is_some());
        fits(x) || recognised().is_some_and(|form| fits(form.value()))
    }

    /// To so many digits.
    pub(super) fn decimals(self, v: DVec3) -> Formula {
        tuple(v.to_array().map(|x| self.decimal(x)))
    }

    fn are_whole(self, v: DVec3) -> bool {
        v.to_array().into_iter().all(|x| self.is_whole(x))
    }

    /// Its exact form, where that says more than its digits.
    fn form(self, x: f64) -> Option<NumberForm> {
        NumberForm::recognise(x).filter(|_| !self.is_whole(x))
    }

    fn vector_form(self, v: DVec3) -> Option<VectorForm> {
        VectorForm::recognise(v).filter(|_| !self.are_whole(v))
    }

    /// In one form: the exact one, or to so many digits.
    pub(super) fn scalar(self, x: f64) -> Formula {
        self.form(x).map_or_else(|| self.decimal(x), exact)
    }

    /// In one form: the exact one, or to so many digits.
    pub(super) fn vector(self, v: DVec3) -> Formula {
        self.vector_form(v).map_or_else(|| self.decimals(v), |form| self.exact_vector(form))
    }

    /// As what something is divided by: exact if that is no fraction itself.
    pub(super) fn divisor(self, x: f64) -> Formula {
        let form = self.form(x).filter(|form| !form.is_root_below() && form.denominator() == 1);
        form.map_or_else(|| self.decimal(x), exact)
    }

    /// `= 5 sqrt 2 ≈ 7.0711`, `= 0.2`, `≈ 0.14286`: what stands behind a derivation.
    pub(super) fn equals(self, x: f64) -> Formula {
        let exact = self.form(x).map(exact);
        result(exact, self.decimal(x), self.is_whole(x))
    }

    /// The same of a vector.
    pub(super) fn equals_vector(self, v: DVec3) -> Formula {
        let exact = self.vector_form(v).map(|form| self.exact_vector(form));
        result(exact, self.decimals(v), self.are_whole(v))
    }

    /// A recognised vector; coordinates that so many digits suffice for are written with them.
    fn exact_vector(self, form: VectorForm) -> Formula {
        let VectorForm::Common { whole, factor } = form else {
            return tuple(form.entries().map(|entry| self.scalar(entry.value())));
        };
        let (k, m) = (factor.root(), factor.denominator());
        let whole = tuple(whole.map(|n| number(&n.to_string())));
        if factor.is_root_below() {
            return fraction(whole, root(number(&k.to_string())));
        }
        let above = if k > 1 { row([root(number(&k.to_string())), whole]) } else { whole };
        if m > 1 { fraction(above, number(&m.to_string())) } else { above }
    }

    /// An angle in radians, in degrees.
    pub(super) fn degrees(self, angle: f64) -> Formula {
        match self.decimal(angle.to_degrees()) {
            Formula::Number(digits) => Formula::Number(digits + "°"),
            Formula::Rounded(digits) => Formula::Rounded(digits + "°"),
            other => other,
        }
    }

    /// A pixel's row and column as they are counted.
    pub(super) fn counted(self, pixel: Pixel) -> (u32, u32) {
        let from = u32::from(self.from_one);
        (pixel.row + from, pixel.column + from)
    }
}

fn relation(is_whole: bool) -> Operator {
    if is_whole { Operator::Equals } else { Operator::Approximately }
}

fn result(exact: Option<Formula>, decimals: Formula, is_whole: bool) -> Formula {
    let exact = exact.map(|exact| row([Operator::Equals.into(), exact]));
    row(exact.into_iter().chain([relation(is_whole).into(), decimals]))
}

/// A recognised number.
fn exact(form: NumberForm) -> Formula {
    let (n, k, m) = (form.numerator(), form.root(), form.denominator());
    let size = n.unsigned_abs();
    let sign = (n < 0).then(|| Formula::from(Operator::Negative));
    let whole = || number(&size.to_string());
    let radical = || root(number(&k.to_string()));
    let magnitude = if form.is_root_below() {
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
