//! Comparison of the edited camera with the ghost: in numbers and as a map.

use egui::Color32;
use pinhole_core::{
    BasisError, Camera, CameraDifference, Frame, NO_OBJECT, ResolvedCamera, Scene, Selection,
};
use pinhole_lecture::mistakes::ComparedPixels;

use crate::model::inspection::Inspection;

/// The edited camera compared with the ghost.
#[derive(Clone, Debug, PartialEq)]
pub struct AgainstGhost {
    /// The ghost, with the edited camera's image, so that they are compared pixel by pixel.
    pub ghost: ResolvedCamera,
    /// The difference from the ghost to the edited camera.
    pub difference: CameraDifference,
    /// Number of shown pixels, and of those among them that see another object.
    pub seen: ComparedPixels,
    /// The ghost's ray through the selected position.
    pub inspection: Inspection,
}

impl AgainstGhost {
    /// Compares two cameras by their frames, which must have the same rows and columns and contain
    /// the objects.
    ///
    /// # Errors
    /// Returns an error if one of the cameras has no basis.
    pub fn new(
        (now, now_frame): (&Camera, &Frame<f32>),
        (then, ghost, ghost_frame): (&Camera, &ResolvedCamera, &Frame<f32>),
        scene: &Scene,
        selection: Selection,
    ) -> Result<AgainstGhost, BasisError> {
        let pairs = now_frame.object.iter().zip(&ghost_frame.object);
        let differing = pairs.filter(|(a, b)| a != b).count();
        Ok(AgainstGhost {
            ghost: *ghost,
            difference: now.difference_from(then)?,
            seen: ComparedPixels { pixels: now_frame.object.len(), differing },
            inspection: Inspection::new(ghost, scene, selection.inside(ghost.image())),
        })
    }
}

/// Returns the map of differences between what two cameras see: equal pixels are pale, pixels that see another object are dark.
pub(crate) fn difference_map(now: &[u32], ghost: &[u32]) -> Vec<Color32> {
    let color = |(now, ghost): (&u32, &u32)| match (now == ghost, *now == NO_OBJECT) {
        (true, true) => Color32::from_gray(0xf0),
        (true, false) => Color32::from_gray(0xc4),
        // An object where the ghost sees none, none where it sees one, and one instead of another.
        (false, _) if *ghost == NO_OBJECT => Color32::from_rgb(0xc8, 0x10, 0x58),
        (false, true) => Color32::from_rgb(0x00, 0x4a, 0x86),
        (false, false) => Color32::from_rgb(0x3a, 0x18, 0x40),
    };
    now.iter().zip(ghost).map(color).collect()
}
