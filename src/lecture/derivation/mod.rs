//! Every number on the way from a camera to a hit, step by step.

mod basis;
mod implicit_unit;
mod objects;
mod ray;

pub use basis::{BasisByHand, BasisCheck, BasisDerivation, BasisFromUp, Cross, VectorAndLength};
pub use implicit_unit::{ImplicitUnit, UnitOrigin};
pub use objects::{
    ObjectDerivation, PlaneDerivation, PlaneMeeting, SphereDerivation, SphereMeeting,
};
pub use ray::{PixelShares, RayDerivation};
