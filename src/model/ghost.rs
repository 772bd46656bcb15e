//! The ghost: a camera frozen to be compared with the one at hand. Pure.

use pinhole_core::{Camera, CameraError, PosedCamera};

/// A frozen camera, and what of it stands beside the camera view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ghost {
    /// As it was given.
    pub camera: Camera,
    /// What is shown beside the camera view.
    pub beside: Beside,
}

/// What is shown beside the camera view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Beside {
    /// What the ghost sees.
    #[default]
    Picture,
    /// Which pixels see another object than the ghost's.
    Differences,
}

/// The ghost with the image that the camera at hand has, as it is compared.
///
/// # Errors
/// Where it sees nothing.
pub fn posed(ghost: &Camera, now: &Camera) -> Result<PosedCamera, CameraError> {
    Camera { image: now.image, ..*ghost }.posed()
}
