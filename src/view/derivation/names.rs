//! Names and operators of the lecture's formulas.

use super::numbers::related;
use crate::view::formula::{Formula, Ink, Operator, parentheses, row, word};

pub(super) const U: Formula = Formula::Vector("u", Ink::U);
pub(super) const V: Formula = Formula::Vector("v", Ink::V);
pub(super) const W: Formula = Formula::Vector("w", Ink::W);
pub(super) const EYE: Formula = Formula::Vector("eye", Ink::Text);
pub(super) const AT: Formula = Formula::Vector("at", Ink::Given);
pub(super) const VIEW: Formula = Formula::Vector("view", Ink::Given);
pub(super) const UP: Formula = Formula::Vector("up", Ink::Given);
pub(super) const P: Formula = Formula::Vector("p", Ink::Ray);
pub(super) const D: Formula = Formula::Vector("d", Ink::Ray);
pub(super) const N: Formula = Formula::Vector("n", Ink::Text);
pub(super) const CENTRE: Formula = Formula::Vector("centre", Ink::Text);
pub(super) const POINT: Formula = Formula::Vector("point", Ink::Text);
pub(super) const HIT: Formula = Formula::Vector("hit", Ink::Text);
pub(super) const T: Formula = Formula::Scalar("t");
pub(super) const DISTANCE: Formula = Formula::Scalar("distance");

/// Returns `left = right`, or `left ≈ right` if digits are left out on the right.
pub(super) fn equation(left: Formula, right: Formula) -> Formula {
    row([left, related(right)])
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
