//! The faults that a document can have.

use std::fmt;

use pinhole_core::{CameraError, SceneError};

/// A reason why there is no new picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// The camera is invalid.
    Camera(CameraError),
    /// An object is invalid.
    Scene(SceneError),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Camera(e) => e.fmt(f),
            Fault::Scene(e) => e.fmt(f),
        }
    }
}
