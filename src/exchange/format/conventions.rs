//! Differences of a format's conventions from those here.

use pinhole_core::DVec3;

use super::export_scene::ExportScene;
use super::text::BEYOND;

/// Direction of an axis of a format's camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Its letter with its sign: `u`, `−w`.
    pub name: &'static str,
    /// The direction in words: `right`, `up`, `backwards` and their opposites.
    pub meaning: &'static str,
    /// Its vector, in coordinates (u, v, w).
    pub direction: DVec3,
}

/// A format's count of pixels, and the position of their centres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PixelConvention {
    /// x right, y down from the image's corner: centres at halves. As here.
    Corner,
    /// x right, y down, centres at whole numbers.
    AtCentre,
    /// y up from the lower left corner, centres at halves.
    FromBottom,
    /// Rows and columns from 1.
    FromOne,
    /// Row and column from 0, the column first.
    ColumnFirst,
    /// -1 to 1 across the image, y up.
    Device,
}

/// A format's conventions.
#[derive(Debug)]
pub struct Conventions {
    /// Directions of its camera's x, y and z.
    pub axes: [Axis; 3],
    /// Numbers that the camera is given by.
    pub given_by: &'static str,
    /// Places of its pixels.
    pub pixels: PixelConvention,
    /// Measure of the field of view.
    pub view: &'static str,
    /// Its number for a camera.
    pub(crate) field: fn(&ExportScene) -> String,
    /// Counterpart of the viewport's distance.
    pub distance: &'static str,
    /// Shapes of pixels that it can have.
    pub shape: &'static str,
    /// Precision that it computes in.
    pub lengths: &'static str,
}

#[allow(missing_docs, reason = "u, v, w of the camera, and their opposites")]
impl Axis {
    pub const U: Axis = Axis { name: "u", meaning: "right", direction: DVec3::X };
    pub const V: Axis = Axis { name: "v", meaning: "up", direction: DVec3::Y };
    pub const W: Axis = Axis { name: "w", meaning: "backwards", direction: DVec3::Z };
    pub const MINUS_U: Axis = Axis { name: "−u", meaning: "left", direction: DVec3::NEG_X };
    pub const MINUS_V: Axis = Axis { name: "−v", meaning: "down", direction: DVec3::NEG_Y };
    pub const MINUS_W: Axis = Axis { name: "−w", meaning: "forwards", direction: DVec3::NEG_Z };

    /// Returns true for the opposites of u, v and w.
    pub fn is_flipped(self) -> bool {
        self.direction.element_sum() < 0.0
    }
}

impl Conventions {
    /// The axes of a camera here.
    pub const OURS: [Axis; 3] = [Axis::U, Axis::V, Axis::W];

    /// Returns true where its camera's axes are right-handed.
    pub fn is_right_handed(&self) -> bool {
        let [x, y, z] = self.axes.map(|axis| axis.direction);
        x.cross(y).dot(z) > 0.0
    }

    /// The number of the field of view for a camera, or several.
    pub fn field_of_view(&self, subject: &ExportScene) -> String {
        (self.field)(subject).replace(BEYOND, "beyond f64")
    }
}
