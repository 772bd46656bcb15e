//! The errors of invalid spheres and planes.

use std::fmt;

use glam::DVec3;

use crate::exact::scale::{shortest, triple};

/// The fault of an invalid object.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ObjectError {
    /// A coordinate of `center`, `point` or `normal` is NaN or infinite.
    NotFinite {
        /// The field's name.
        field: &'static str,
        /// The invalid vector.
        value: DVec3,
    },
    /// A sphere's radius is not a positive, finite number.
    Radius {
        /// The invalid radius.
        value: f64,
    },
    /// A plane's normal is `(0, 0, 0)`.
    NormalIsZero,
}

/// The invalid object of a scene, and what is wrong with it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SceneError {
    /// A sphere is invalid.
    Sphere {
        /// The sphere's index among all objects: spheres first.
        index: usize,
        /// The sphere's fault.
        error: ObjectError,
    },
    /// A plane is invalid.
    Plane {
        /// The plane's index among all objects: spheres first.
        index: usize,
        /// The plane's fault.
        error: ObjectError,
    },
    /// The index of a sphere to be replaced is not that of a sphere.
    NoSphere {
        /// The index that was given.
        index: usize,
    },
    /// The index of a plane to be replaced is not that of a plane.
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
