//! Documents that no picture can be drawn of.

use std::fmt;

use pinhole_core::{CameraError, SceneError};

/// An error in a document that prevents a new picture from being drawn.
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
