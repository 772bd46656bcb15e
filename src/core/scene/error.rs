//! What spheres and planes have to be, and what is said of those that are not.

use std::fmt;

use glam::DVec3;

use crate::exact::decimal::{shortest, triple};
use crate::scene::plane::Plane;
use crate::scene::sphere::Sphere;

/// What is wrong with one object.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ObjectError {
    /// A coordinate of `center`, `point` or `normal` is NaN or infinite.
    NotFinite {
        /// The field's name.
        field: &'static str,
        /// The value.
        value: DVec3,
    },
    /// A radius that is not a positive, finite number.
    Radius {
        /// The value.
        value: f64,
    },
    /// A plane's normal is `(0, 0, 0)`.
    NormalIsZero,
}

/// Which object of a scene is at fault, and why.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SceneError {
    /// A sphere.
    Sphere {
        /// Its index among all objects: spheres first.
        index: usize,
        /// What is wrong with it.
        error: ObjectError,
    },
    /// A plane.
    Plane {
        /// Its index among all objects: spheres first.
        index: usize,
        /// What is wrong with it.
        error: ObjectError,
    },
    /// An object to be replaced is no sphere, or not there.
    NoSphere {
        /// The index that was given.
        index: usize,
    },
    /// An object to be replaced is no plane, or not there.
    NoPlane {
        /// The index that was given.
        index: usize,
    },
}

impl fmt::Display for ObjectError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ObjectError::NotFinite { field, value } => {
                write!(f, "{field} is {}: every coordinate must be a finite number", triple(*value))
            }
            ObjectError::Radius { value } => {
                write!(f, "radius is {}: it must be finite and greater than 0", shortest(*value))
            }
            ObjectError::NormalIsZero => write!(f, "normal is (0, 0, 0): it must point somewhere"),
        }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneError::Sphere { index, error } => write!(f, "sphere {index}: {error}"),
            SceneError::Plane { index, error } => write!(f, "plane {index}: {error}"),
            SceneError::NoSphere { index } => write!(f, "object {index} is no sphere of the scene"),
            SceneError::NoPlane { index } => write!(f, "object {index} is no plane of the scene"),
        }
    }
}

impl std::error::Error for ObjectError {}
impl std::error::Error for SceneError {}

impl Sphere {
    /// A checked sphere, from whatever makes a [`DVec3`].
    ///
    /// # Errors
    /// Where the centre is not finite or the radius not positive and finite.
    ///
    /// ```
    /// use pinhole_core::*;
    /// let ball = Sphere::new([0.0, 0.0, -5.0], 1.0)?;
    /// let (center, radius) = ([0.5_f32, 0.0, -5.0], 1.5_f32);
    /// let of_f32 = Sphere::new(center.map(f64::from), f64::from(radius))?;
    /// assert_eq!(of_f32.center.x, 0.5);
    /// assert_eq!(Sphere::new([0.0; 3], -1.0), Err(ObjectError::Radius { value: -1.0 }));
    /// # assert_eq!(ball.radius, 1.0);
    /// # Ok::<(), ObjectError>(())
    /// ```
    pub fn new(center: impl Into<DVec3>, radius: f64) -> Result<Sphere, ObjectError> {
        let sphere = Sphere { center: center.into(), radius };
        sphere.check().map(|()| sphere)
    }

    /// Checks that the centre is finite and the radius positive and finite.
    ///
    /// # Errors
    /// What is wrong.
    pub fn check(&self) -> Result<(), ObjectError> {
        if !self.center.is_finite() {
            return Err(ObjectError::NotFinite { field: "center", value: self.center });
        }
        if !(self.radius.is_finite() && self.radius > 0.0) {
            return Err(ObjectError::Radius { value: self.radius });
        }
        Ok(())
    }
}

impl Plane {
    /// A checked plane through a point, at right angles to a normal of any length, from whatever
    /// makes a [`DVec3`].
    ///
    /// # Errors
    /// Where a coordinate is not finite or the normal is zero.
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
    /// What is wrong.
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
