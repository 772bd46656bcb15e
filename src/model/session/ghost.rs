//! The ghost: a frozen camera for comparison with the current camera. Pure.

use pinhole_core::{Camera, CameraError, ResolvedCamera};

/// A frozen camera and the picture beside the camera view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ghost {
    /// The camera as given.
    pub camera: Camera,
    /// The picture beside the camera view.
    pub beside: Beside,
}

/// A picture beside the camera view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Beside {
    /// The ghost's picture.
    #[default]
    Picture,
    /// The pixels that see another object than the ghost's pixels.
    Differences,
}

/// Resolves the ghost with the current camera's image size, as the comparison needs it.
///
/// # Errors
/// Returns an error if the ghost is an invalid camera.
pub fn resolve(ghost: &Camera, now: &Camera) -> Result<ResolvedCamera, CameraError> {
    Camera { image: now.image, ..*ghost }.resolve()
}
