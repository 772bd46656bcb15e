//! What the lecture works out step by step, with every number in between: for teaching, where the rest
//! of this crate is for tracing.
//!
//! - [`BasisDerivation`]: from eye, at (or view) and up to u, v, w.
//! - [`RayDerivation`]: from a pixel to (u, v), and from there to the view ray.
//! - [`ObjectDerivation`]: from the ray and an object to t, point and normal; [`AlongRay`] is the
//!   object's implicit function along the ray, to be plotted.
//! - [`lines`]: lines in two dimensions, implicit and parametric, and one put into the other.
//! - [`NumberForm`], [`VectorForm`]: numbers such as `5 sqrt 2` and `(5, 0, -7)/sqrt 74`, recognised.
//! - [`Camera::swung`](crate::Camera::swung) and the other verbs: cameras that differ in one thing.
//! - [`mistakes`]: the classic wrong cameras, what they see, and the checks that find them.
//! - [`exercises`]: questions, their answers, and what is to be said of a wrong one.
//!
//! A step that does not exist (u of a camera whose up is parallel to its view) is `None`, and the
//! reason is told beside it: no number here is NaN for want of an answer.

mod along;
mod basis;
pub mod exercises;
mod form;
pub mod lines;
pub mod mistakes;
mod objects;
mod ray;
mod vector_form;
mod verbs;

pub use along::{AlongRay, Unit, UnitOf, Vertex};
pub use basis::{
    BasisByHand, BasisDerivation, BasisFromUp, Cross, DotCheck, HandednessCheck, LengthCheck,
    Measured,
};
pub use form::NumberForm;
pub use objects::{
    ObjectDerivation, PlaneDerivation, PlaneMeeting, SphereDerivation, SphereMeeting,
};
pub use ray::{PixelShares, RayDerivation};
pub use vector_form::VectorForm;
pub use verbs::VerbError;
