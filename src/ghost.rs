//! The ghost: a camera frozen to be compared with the one at hand. Pure.

use egui::Color32;
use pinhole_core::{
    BasisError, Camera, CameraDifference, CameraError, Frame, NO_OBJECT, PosedCamera, Scene,
};

use crate::inspection::Inspection;
use crate::session::Selection;
use pinhole_lecture::mistakes::ComparedPixels;

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

/// The camera at hand against the ghost.
#[derive(Clone, Debug, PartialEq)]
pub struct AgainstGhost {
    /// The ghost, with the image that the camera at hand has: pixel by pixel they are compared.
    pub ghost: PosedCamera,
    /// From the ghost to the camera at hand.
    pub difference: CameraDifference,
    /// How many pixels are shown, and how many of them see another object.
    pub seen: ComparedPixels,
    /// The ghost's ray through the selected place.
    pub inspection: Inspection,
}

/// The ghost with the image that the camera at hand has, as it is compared.
///
/// # Errors
/// Where it sees nothing.
pub fn posed(ghost: &Camera, now: &Camera) -> Result<PosedCamera, CameraError> {
    Camera { image: now.image, ..*ghost }.posed()
}

impl AgainstGhost {
    /// The frames are of the same rows and columns, with the objects that are seen.
    ///
    /// # Errors
    /// Where one of the cameras has no basis.
    pub fn new(
        (now, now_frame): (&Camera, &Frame<f32>),
        (then, ghost, ghost_frame): (&Camera, &PosedCamera, &Frame<f32>),
        scene: &Scene,
        selection: Selection,
    ) -> Result<AgainstGhost, BasisError> {
        let pairs = now_frame.object.iter().zip(&ghost_frame.object);
        let differing = pairs.filter(|(a, b)| a != b).count();
        Ok(AgainstGhost {
            ghost: *ghost,
            difference: now.difference_from(then)?,
            seen: ComparedPixels { pixels: now_frame.object.len(), differing },
            inspection: match selection.inside(ghost.image()) {
                Selection::Pixel(pixel) => Inspection::of_pixel(ghost, scene, pixel),
                Selection::Uv(uv) => Inspection::of_uv(ghost, scene, uv),
            },
        })
    }
}

/// What is the same, faded; what the camera sees another object in, dark on that.
pub(crate) fn difference_map(now: &Frame<f32>, ghost: &Frame<f32>) -> Vec<Color32> {
    let color = |(now, ghost): (&u32, &u32)| match (now == ghost, *now == NO_OBJECT) {
        (true, true) => Color32::from_gray(0xf0),
        (true, false) => Color32::from_gray(0xc4),
        // Something where the ghost sees nothing, the other way round, and one for another.
        (false, _) if *ghost == NO_OBJECT => Color32::from_rgb(0xc8, 0x10, 0x58),
        (false, true) => Color32::from_rgb(0x00, 0x4a, 0x86),
        (false, false) => Color32::from_rgb(0x3a, 0x18, 0x40),
    };
    now.object.iter().zip(&ghost.object).map(color).collect()
}
