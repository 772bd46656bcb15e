//! Rays in parametric form.

use std::fmt;

use glam::DVec3;

use crate::exact::decimal::triple;
use crate::exact::scale::{ldexp, split};

/// `origin + t * direction`. The direction is not normalized: `t` is in units of its length.
///
/// Any values may stand here; a ray that does not pass [`Ray::check`] meets nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// The point at `t = 0`, the lecture's p.
    pub origin: DVec3,
    /// The lecture's **d**.
    pub direction: DVec3,
}

/// Reason why numbers make no ray.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum RayError {
    /// A coordinate of the named field is NaN or infinite.
    NotFinite {
        /// `origin` or `direction`.
        field: &'static str,
        /// The value.
        value: DVec3,
    },
    /// The direction is `(0, 0, 0)`.
    DirectionIsZero,
}

impl fmt::Display for RayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RayError::NotFinite { field, value } => {
                write!(f, "{field} is {}: every coordinate must be a finite number", triple(*value))
            }
            RayError::DirectionIsZero => {
                write!(f, "direction is (0, 0, 0): it must point somewhere")
            }
        }
    }
}

impl std::error::Error for RayError {}

impl Ray {
    /// A checked ray, from whatever makes a [`DVec3`]: `[f64; 3]`, `(f64, f64, f64)`. Numbers in
    /// `f32` are widened first, which changes none.
    ///
    /// # Errors
    /// Returns an error if a coordinate is not finite or the direction is zero.
    ///
    /// ```
    /// use pinhole_core::*;
    /// let ray = Ray::new([0.0, 0.0, 0.0], [0.0, 0.0, -2.0])?;
    /// assert_eq!(ray.at(2.0), DVec3::new(0.0, 0.0, -4.0));
    /// // Of f32, by number or by vector.
    /// let direction = [0.25_f32, -0.5, -1.0];
    /// let ray = Ray::new([0.0; 3], direction.map(f64::from))?;
    /// assert_eq!(ray.direction, DVec3::new(0.25, -0.5, -1.0));
    /// assert_eq!(Ray::new([0.0; 3], [0.0; 3]), Err(RayError::DirectionIsZero));
    /// # Ok::<(), RayError>(())
    /// ```
    pub fn new(origin: impl Into<DVec3>, direction: impl Into<DVec3>) -> Result<Ray, RayError> {
        let ray = Ray { origin: origin.into(), direction: direction.into() };
        ray.check().map(|()| ray)
    }

    /// Checks that origin and direction are finite and the direction is not zero.
    ///
    /// # Errors
    /// Returns what is wrong.
    pub fn check(&self) -> Result<(), RayError> {
        for (field, value) in [("origin", self.origin), ("direction", self.direction)] {
            if !value.is_finite() {
                return Err(RayError::NotFinite { field, value });
            }
        }
        if self.direction == DVec3::ZERO { Err(RayError::DirectionIsZero) } else { Ok(()) }
    }

    /// `origin + t * direction`.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }

    /// `t * |direction|`: how far from the origin, in world units, `t` is.
    pub fn distance_along(&self, t: f64) -> f64 {
        if self.check().is_err() {
            return t * self.direction.length();
        }
        let (direction, k) = split(self.direction);
        ldexp(t * direction.length(), k)
    }
}
