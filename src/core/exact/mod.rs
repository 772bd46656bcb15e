//! Numbers that decisions can rest on: rounding errors that are known, numbers with bounds of their
//! error, and exact ones. No object and no camera; vectors and numbers alone.
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
