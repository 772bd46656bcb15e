//! Planes, and the terms of their intersection with a ray.

use glam::DVec3;

use crate::scene::error::ObjectError;

/// A plane: all points `q` with `normal . (q - point) = 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Any point of the plane.
    pub point: DVec3,
    /// Any non-zero vector at right angles to the plane.
    pub normal: DVec3,
}

/// The terms of a ray-plane intersection: `t = offset / rate`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneTerms {
    /// `normal . d` for the ray's direction d, the rate at which the ray approaches the plane; 0 if the
    /// ray is parallel to the plane.
    pub rate: f64,
    /// `normal . (point - p)`, the distance from the ray's origin p to the plane along the normal, times
    /// the normal's length.
    pub offset: f64,
}

impl Plane {
    /// Creates a plane through a point, at right angles to a normal of any length, and checks it. The
    /// arguments may be of any type that converts into [`DVec3`].
    ///
    /// # Errors
    /// Returns an error if a coordinate is not finite or the normal is zero.
    ///
    /// ```
    /// use pinhole_core::*;
    /// let wall = Plane::new([0.0, 0.0, -6.0], [0.0, 0.0, 1.0])?;
    /// let normal = [0.0_f32, 0.0, 0.1];
    /// let of_f32 = Plane::new([0.0, 0.0, -6.0], normal.map(f64::from))?;
    /// assert!(of_f32.is_same(&wall));
    /// assert_eq!(Plane::new([0.0; 3], [0.0; 3]), Err(ObjectError::NormalIsZero));
    /// # Ok::<(), ObjectError>(())
    /// ```
    pub fn new(point: impl Into<DVec3>, normal: impl Into<DVec3>) -> Result<Plane, ObjectError> {
        let plane = Plane { point: point.into(), normal: normal.into() };
        plane.check().map(|()| plane)
    }

    /// Checks that point and normal are finite and the normal is not zero.
    ///
    /// # Errors
    /// Returns an error if the plane is invalid.
    pub fn check(&self) -> Result<(), ObjectError> {
        for (field, value) in [("point", self.point), ("normal", self.normal)] {
            if !value.is_finite() {
                return Err(ObjectError::NotFinite { field, value });
            }
        }
        if self.normal == DVec3::ZERO {
            return Err(ObjectError::NormalIsZero);
        }
        Ok(())
    }
}
