//! The errors of invalid spheres and planes.

use glam::DVec3;
use thiserror::Error;

use crate::exact::scale::{shortest, triple};

/// The reason why an object is invalid.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ObjectError {
    /// A coordinate of `center`, `point` or `normal` is NaN or infinite.
    #[error("{field} is {}: every coordinate must be a finite number", triple(*.value))]
    NotFinite {
        /// The field's name.
        field: &'static str,
        /// The invalid vector.
        value: DVec3,
    },
    /// A sphere's radius is not a positive, finite number.
    #[error("radius is {}: it must be finite and greater than 0", shortest(*.value))]
    Radius {
        /// The invalid radius.
        value: f64,
    },
    /// A plane's normal is `(0, 0, 0)`.
    #[error("normal is (0, 0, 0): it must point somewhere")]
    NormalIsZero,
}

/// An invalid object of a scene, and the reason why it is invalid.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("{kind} {index}: {error}")]
pub struct SceneError {
    /// `sphere` or `plane`.
    pub kind: &'static str,
    /// The object's index among all objects: spheres first.
    pub index: usize,
    /// The reason why the object is invalid.
    pub error: ObjectError,
}
