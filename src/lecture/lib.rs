//! The lecture, worked out: every step with its numbers, the classic mistakes, exercises,
//! and students' answers graded. It knows no window and no file; the exact answers are those of
//! [`pinhole_core`].
//!
//! # What is where
//!
//! | for | there are |
//! | --- | --- |
//! | eye, at (or view) and up to u, v, w | [`BasisDerivation`] |
//! | a pixel to (u, v), and from there to the view ray | [`RayDerivation`] |
//! | a ray and an object to t, point and normal | [`ObjectDerivation`]; [`ImplicitUnit`], to plot the object's implicit function in |
//! | lines in two dimensions | [`lines`]: implicit and parametric, and one put into the other |
//! | numbers for readers | [`numbers`] |
//! | numbers such as `5√2` and `(5, 0, -7)/√74` | [`NumberForm`], [`VectorForm`] |
//! | the classic mistakes | [`mistakes`]: what each is, the wrong camera that it makes, what that sees, and the checks that find it |
//! | exercises | [`exercises`]: questions, their answers, and what is to be said of a wrong one |
//! | students' answers | [`grading`]: against the truth, and the mistakes that explain them |
//!
//! A step that does not exist (u of a camera whose up is parallel to its view) is `None`, and the
//! reason is told beside it: no number here is NaN for want of an answer.
//!
//! # What stays
//!
//! What pinhole-core's changelog says. [`Mistake`](mistakes::Mistake), [`Check`](mistakes::Check),
//! errors and derivations may grow; the [`exercises`] with their verdicts are
//! complete: whoever shows them all wants to be told of a new one by the compiler.

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
pub use forms::{NumberForm, VectorForm};

/// The README's example is run with the others.
#[cfg(doctest)]
#[doc = include_str!("README.md")]
struct Readme;

/// Errors that may grow cannot be matched as if they were complete.
///
/// ```compile_fail,E0004
/// fn number_of(error: pinhole_lecture::lines::LineError) -> u8 {
///     use pinhole_lecture::lines::LineError::*;
///     match error { NotFinite { .. } | NoNormal { .. } | NoDirection { .. } | SamePoint { .. } => 0 }
/// }
/// ```
/// ```compile_fail,E0004
/// fn number_of(error: pinhole_lecture::mistakes::NoWrongCamera) -> u8 {
///     use pinhole_lecture::mistakes::NoWrongCamera::*;
///     match error {
///         Camera(_) | GivenByHand(_) | NotGivenByAt | ChangesNothing(_) => 0,
///         OutOfRange(_) => 1,
///     }
/// }
/// ```
#[cfg(doctest)]
struct Stays;
