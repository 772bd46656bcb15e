//! The ghost: a frozen camera for comparison with the current camera. Pure.

use pinhole_core::{Camera, CameraError, ResolvedCamera};

/// A frozen camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ghost {
    /// The camera as given.
    pub camera: Camera,
    /// True if the map of the pixels that see another object is shown in place of its picture.
    pub shows_differences: bool,
}

/// Resolves the ghost with the current camera's image size, as the comparison needs it.
///
/// # Errors
/// Returns an error if the ghost is an invalid camera.
pub fn resolve(ghost: &Camera, now: &Camera) -> Result<ResolvedCamera, CameraError> {
    Camera { image: now.image, ..*ghost }.resolve()
}
