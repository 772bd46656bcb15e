//! Every number on the way from a camera to a hit, step by step.

mod basis;
mod objects;
mod ray;

pub use basis::{BasisByHand, BasisCheck, BasisDerivation, BasisFromUp, Cross, VectorAndLength};
pub use objects::{
    ImplicitUnit, ObjectDerivation, PlaneDerivation, PlaneMeeting, SphereDerivation, SphereMeeting,
    UnitOrigin,
};
pub use ray::RayDerivation;
