//! Arithmetic for reliable decisions: with known rounding errors, with error bounds, and exact. This
//! folder contains no scene objects and no cameras, only numbers and vectors.
//!
//! From the ground up: [`double_double`], with the error-free sums and products on which it is based,
//! for scalars and SIMD vectors ([`lanes`]); [`quadratic`], the equation of a ray and a sphere with
//! error bounds; [`dyadic`] numbers of arbitrary length, [`surd`]s with square roots, and [`big_ray`], a
//! ray in exact numbers.

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
