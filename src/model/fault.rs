//! What is wrong with a document.

use std::fmt;

use pinhole_core::{CameraError, SceneError};

/// Why there is no new picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// The camera sees nothing.
    Camera(CameraError),
    /// An object is none.
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
