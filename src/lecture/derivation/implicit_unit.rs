//! The unit in which an object's implicit function is plotted.

use pinhole_core::{AlongRay, Object};

/// The unit of an object's implicit function along a ray: with it, spheres and
/// planes of all sizes fit on one scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImplicitUnit {
    /// A normal number greater than 0.
    pub value: f64,
    /// The number that it comes from.
    pub origin: UnitOrigin,
}

/// The number that an [`ImplicitUnit`] comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnitOrigin {
    /// A sphere's `r^2`: f at the centre is minus that.
    SquaredRadius,
    /// A plane's `|f(0)|`, at the ray's origin.
    RayOrigin,
    /// `|f(1)|` of a plane through the ray's origin.
    OneStep,
    /// The number 1, where what should be the unit is 0 or out of range.
    One,
}

impl ImplicitUnit {
    /// The unit for an object and its function along a ray.
    pub fn new(object: &Object, along: &AlongRay) -> ImplicitUnit {
        let (value, origin) = match object {
            Object::Sphere(sphere) => (sphere.radius * sphere.radius, UnitOrigin::SquaredRadius),
            Object::Plane(_) => match along.value(0.0).abs() {
                0.0 => (along.value(1.0).abs(), UnitOrigin::OneStep),
                at_origin => (at_origin, UnitOrigin::RayOrigin),
            },
        };
        match value.is_normal() {
            true => ImplicitUnit { value, origin },
            false => ImplicitUnit { value: 1.0, origin: UnitOrigin::One },
        }
    }
}
