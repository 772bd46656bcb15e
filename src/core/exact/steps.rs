//! The steps of [the ladder](crate#the-ladder) of increasing precision, and counts of the decisions that
//! each step made.

use std::cmp::Ordering;
use std::ops::Add;

use serde::Serialize;

use crate::exact::double_double::DoubleDouble;

/// How many decisions each step of [the ladder](crate#the-ladder) made, or how many values of `t` each
/// step computed.
///
/// A decision is, for example, whether one ray hits one object, or which of two objects it hits first.
/// Each step but the last, which is exact, has an error bound, and passes on to the next step any
/// decision whose value lies within the bound.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize)]
#[non_exhaustive]
pub struct Steps {
    /// Decisions made in `f64`.
    pub f64: u64,
    /// Decisions that were in doubt in `f64` (the value was within its error bound) and made in
    /// double-double.
    pub double_double: u64,
    /// Decisions that were in doubt in double-double, too, and made in exact arithmetic.
    pub exact: u64,
}

/// One step of [the ladder](crate#the-ladder). The steps are ordered from the fastest to the exact one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Step {
    /// `f64` with an error bound.
    F64,
    /// Double-double with an error bound.
    DoubleDouble,
    /// Integers of any length.
    Exact,
}

impl Steps {
    /// Counts one more decision.
    pub(crate) fn count(&mut self, step: Step) {
        match step {
            Step::F64 => self.f64 += 1,
            Step::DoubleDouble => self.double_double += 1,
            Step::Exact => self.exact += 1,
        }
    }

    /// Returns the number of all decisions.
    pub fn total(&self) -> u64 {
        self.f64 + self.double_double + self.exact
    }

    /// Returns the number of decisions that were in doubt in `f64`.
    pub fn beyond_f64(&self) -> u64 {
        self.double_double + self.exact
    }
}

impl Add for Steps {
    type Output = Steps;

    fn add(self, other: Steps) -> Steps {
        Steps {
            f64: self.f64 + other.f64,
            double_double: self.double_double + other.double_double,
            exact: self.exact + other.exact,
        }
    }
}

/// Returns the sign of a number, and the step that decides it, given the number and the bound of its error in
/// `f64` and in double-double.
pub(crate) fn sign_by_steps(
    rough: (f64, f64),
    fine: impl FnOnce() -> (DoubleDouble, f64),
    exact: impl FnOnce() -> Ordering,
) -> (Ordering, Step) {
    let sure = |(x, doubt): (f64, f64)| (x.abs() > doubt).then(|| x.total_cmp(&0.0));
    if let Some(sign) = sure(rough) {
        return (sign, Step::F64);
    }
    let (x, doubt) = fine();
    sure((x.hi, doubt)).map_or_else(|| (exact(), Step::Exact), |sign| (sign, Step::DoubleDouble))
}

/// Returns the sign of a number; both 0 and -0 give `Equal`.
pub(crate) fn sign_of(x: f64) -> Ordering {
    (x + 0.0).total_cmp(&0.0)
}
