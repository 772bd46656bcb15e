//! Numbers on which decisions can rest: known rounding errors, numbers with error bounds, and exact
//! numbers. This folder has no objects and no cameras, only vectors and numbers.
//!
//! From the ground up: [`error_free`] sums and products, in one number or several side by side
//! ([`lanes`]); [`double_double`]; [`quadratic`], a ray and a sphere with a bound of the error;
//! [`dyadic`] numbers of any length, [`surd`]s with square roots, and [`big_ray`], which is exact.

pub(crate) mod big_ray;
pub(crate) mod bounded;
pub(crate) mod double_double;
pub(crate) mod dyadic;
pub(crate) mod lanes;
pub(crate) mod precise;
pub(crate) mod quadratic;
pub(crate) mod scale;
pub(crate) mod steps;
pub(crate) mod surd;

#[cfg(test)]
mod tests;
