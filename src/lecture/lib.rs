//! The calculations of a lecture on cameras and ray tracing: every step with its numbers, the classic
//! mistakes, exercises, and the grading of students' answers. The crate has no user interface and reads
//! no files; [`pinhole_core`] computes the exact answers.
//!
//! # What is where
//!
//! | for | there are |
//! | --- | --- |
//! | eye, at (or view) and up to u, v, w | [`BasisDerivation`] |
//! | a pixel to (u, v), and from there to the view ray | [`RayDerivation`] |
//! | a ray and an object to t, point and normal | [`ObjectDerivation`]; [`ImplicitUnit`], to plot the object's implicit function in |
//! | lines in two dimensions | [`lines`]: implicit and parametric, and the substitution of one into the other |
//! | numbers for readers | [`numbers`] |
//! | numbers such as `5√2` and `(5, 0, -7)/√74` | [`NumberForm`], [`VectorForm`] |
//! | the classic mistakes | [`mistakes`]: a description of each, its wrong camera and picture, and the checks that find it |
//! | exercises | [`exercises`]: questions, their answers, and verdicts on wrong answers |
//! | students' answers | [`grading`]: a comparison with the truth, and the mistakes that explain them |
//!
//! A value that does not exist, such as u of a camera whose up is parallel to its view, is `None`, and
//! an error gives the reason. No number is NaN because a value is missing.
//!
//! # What stays
//!
//! The stability rules are those in pinhole-core's changelog. [`Mistake`], [`Check`](mistakes::Check)
//! and the derivations may be extended, and the texts of errors may change. The enums of [`exercises`]
//! and verdicts are exhaustive, so that the compiler reports a new variant to code that must show them
//! all.

mod derivation;
pub mod exercises;
mod forms;
pub mod grading;
pub mod lines;
pub mod mistakes;
pub mod numbers;

pub use derivation::{
    BasisByHand, BasisCheck, BasisDerivation, BasisFromUp, Cross, ImplicitUnit, ObjectDerivation,
    PlaneDerivation, PlaneMeeting, RayDerivation, SphereDerivation, SphereMeeting, UnitOrigin,
    VectorAndLength,
};
pub use exercises::{Exercise, LARGEST_SEED, next_seed};
pub use forms::{NumberForm, VectorForm};
pub use grading::AnswerKind;
pub use lines::{ImplicitLine, ParametricLine};
pub use mistakes::{Mistake, Vote};
pub use numbers::Rounding;

/// Runs the README's example as a test.
#[cfg(doctest)]
#[doc = include_str!("README.md")]
struct Readme;
