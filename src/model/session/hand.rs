//! The handles of the world view, and the constraints of a drag.

use pinhole_core::steering::ViewportCorner;
use pinhole_core::{DVec3, ResolvedCamera};

use crate::model::overlay_items::Item;

/// A handle in the world view. Objects are given by their index in the document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Handle {
    /// The camera's position.
    Eye,
    /// The point that the camera looks at; for a camera given by view, the tip of view.
    At,
    /// The tip of up.
    Up,
    /// The tip of v, which turns about w: rolls the camera.
    Roll,
    /// The tip of w, which moves along w: dollies the camera.
    Dolly,
    /// A corner of the viewport: changes width and height.
    Corner(ViewportCorner),
    /// The middle of the viewport's lower edge: changes the distance.
    Distance,
    /// The centre of a sphere.
    Center(usize),
    /// A point of a sphere's surface: changes the radius.
    Radius(usize),
    /// The point that defines a plane.
    Point(usize),
    /// The tip of a plane's normal.
    Normal(usize),
    /// The selected pixel.
    Pixel,
}

impl Handle {
    /// Returns the index of the object that the handle belongs to.
    pub fn object(self) -> Option<usize> {
        match self {
            Handle::Center(k) | Handle::Radius(k) | Handle::Point(k) | Handle::Normal(k) => Some(k),
            _ => None,
        }
    }

    /// Returns the overlay item that must be shown, besides the handles, for this handle to be
    /// there.
    pub fn item(self) -> Item {
        match self {
            Handle::Eye => Item::Eye,
            Handle::At => Item::At,
            Handle::Up => Item::ViewAndUp,
            Handle::Roll | Handle::Dolly => Item::Basis,
            Handle::Corner(_) | Handle::Distance => Item::Viewport,
            Handle::Center(_) | Handle::Radius(_) => Item::Handles,
            Handle::Point(_) | Handle::Normal(_) => Item::Planes,
            Handle::Pixel => Item::Ray,
        }
    }

    /// Returns true if the handle lies on the viewport's rectangle.
    pub fn is_on_viewport(self) -> bool {
        matches!(self, Handle::Corner(_) | Handle::Distance | Handle::Pixel)
    }

    /// Returns true if the handle can be dragged in any direction, and so also along x, y, z; the
    /// others move in one fixed way.
    pub fn is_free(self) -> bool {
        !self.is_on_viewport() && !matches!(self, Handle::Roll | Handle::Dolly)
    }
}

/// An axis to drag along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the world's axes and the camera's, as everywhere")]
pub enum Axis {
    X,
    Y,
    Z,
    U,
    V,
    W,
}

impl Axis {
    /// All axes: the world's three, then the camera's three.
    pub const ALL: [Axis; 6] = [Axis::X, Axis::Y, Axis::Z, Axis::U, Axis::V, Axis::W];

    /// Returns the axis's letter.
    pub fn name(self) -> &'static str {
        ["x", "y", "z", "u", "v", "w"][self as usize]
    }

    /// Returns the axis's direction; `None` for an axis of the camera if there is no camera.
    pub fn direction(self, camera: Option<&ResolvedCamera>) -> Option<DVec3> {
        let basis = camera.map(ResolvedCamera::basis);
        match self {
            Axis::X => Some(DVec3::X),
            Axis::Y => Some(DVec3::Y),
            Axis::Z => Some(DVec3::Z),
            Axis::U => basis.map(|basis| basis.u),
            Axis::V => basis.map(|basis| basis.v),
            Axis::W => basis.map(|basis| basis.w),
        }
    }

    /// Returns the other two axes of the same frame.
    pub fn others(self) -> [Axis; 2] {
        let (frame, k) = (self as usize / 3 * 3, self as usize % 3);
        [Axis::ALL[frame + (k + 1) % 3], Axis::ALL[frame + (k + 2) % 3]]
    }
}

/// The constraint of a drag.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Along {
    /// The plane parallel to the observer's image.
    #[default]
    View,
    /// An axis.
    Axis(Axis),
    /// The plane of the other two axes of its frame.
    Without(Axis),
}

/// The state of the handles in a session.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hand {
    /// The handle under the pointer or with the keyboard focus.
    pub over: Option<Handle>,
    /// Number of handles that lie together there.
    pub together: usize,
    /// The handle that is held.
    pub held: Option<Grasp>,
    /// The objects whose handles are shown: the selected one and the hovered one.
    pub objects: [Option<usize>; 2],
    /// The constraint of the drag.
    pub along: Along,
    /// True until the pointer's button is released, once it was pressed on a handle.
    pub is_busy: bool,
}

/// A handle that is held, with the sizes that it was drawn with when it was grabbed: they keep it
/// under the pointer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grasp {
    /// The handle.
    pub handle: Handle,
    /// Length in the world at which an arrow of length 1 is drawn, if its tip is held.
    pub length: f64,
    /// Unit vector from a sphere's centre to the held point of its surface.
    pub toward: DVec3,
}
