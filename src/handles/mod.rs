//! What one takes in the hand in the world view: eye, at, the tip of up, the viewport, spheres and
//! planes. Pure: who presses what is known to `panels::handles`.
//!
//! - `places`: which handles there are, and where they are seen; `hit`: which one is meant.
//! - `part`: what a handle changes, as it was before and as it is after; `pull`: from the pointer to
//!   a point of the world, and from there, through [`pinhole_core::steering`], to the part.
//! - `words`: names and values; `marks`: what the overlay draws.

mod hit;
mod marks;
mod part;
mod places;
mod pull;
mod words;

use pinhole_core::steering::{CornerKeeps, DistanceKeeps, Keep, ViewportCorner};
use pinhole_core::{DVec3, ResolvedCamera};

pub use hit::{Hit, hit};
pub use marks::drawn;
pub use part::{Part, Solid};
pub use places::{Grip, Stage, grips};
pub use pull::{How, Pull, Pulled, Start, step_of, turned_by};
pub use words::{label, value, vector};

use crate::overlay::Item;
use crate::session::Settings;

/// Something to take hold of. Objects by their place in the document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Handle {
    /// The camera's position.
    Eye,
    /// What it looks at; by view, where view ends.
    At,
    /// The tip of up.
    Up,
    /// The tip of v, round w: the camera rolls.
    Roll,
    /// The tip of w, along w: the camera dollies.
    Dolly,
    /// A corner of the viewport: width and height.
    Corner(ViewportCorner),
    /// The middle of the viewport's lower edge: its distance.
    Distance,
    /// The centre of a sphere.
    Center(usize),
    /// A point of its surface: the radius.
    Radius(usize),
    /// The point that a plane is given by.
    Point(usize),
    /// The tip of its normal.
    Normal(usize),
    /// The selected pixel.
    Pixel,
}

impl Handle {
    /// The object that it belongs to.
    pub fn object(self) -> Option<usize> {
        match self {
            Handle::Center(k) | Handle::Radius(k) | Handle::Point(k) | Handle::Normal(k) => Some(k),
            _ => None,
        }
    }

    /// What must be drawn for the handle to be there, besides the handles themselves.
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

    /// Whether it lies on the viewport's rectangle.
    pub fn is_on_viewport(self) -> bool {
        matches!(self, Handle::Corner(_) | Handle::Distance | Handle::Pixel)
    }

    /// Whether it goes wherever it is dragged, and so along x, y, z too; the others know one way.
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
    /// The world's three, then the camera's.
    pub const ALL: [Axis; 6] = [Axis::X, Axis::Y, Axis::Z, Axis::U, Axis::V, Axis::W];

    /// Its letter.
    pub fn name(self) -> &'static str {
        ["x", "y", "z", "u", "v", "w"][self as usize]
    }

    /// Its direction; the camera's are there where it has a basis.
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

    /// The other two of its three.
    pub fn others(self) -> [Axis; 2] {
        match self {
            Axis::X => [Axis::Y, Axis::Z],
            Axis::Y => [Axis::Z, Axis::X],
            Axis::Z => [Axis::X, Axis::Y],
            Axis::U => [Axis::V, Axis::W],
            Axis::V => [Axis::W, Axis::U],
            Axis::W => [Axis::U, Axis::V],
        }
    }
}

/// To what a drag is held.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Along {
    /// The plane of the observer's picture.
    #[default]
    View,
    /// An axis.
    Axis(Axis),
    /// The plane of the other two axes.
    Without(Axis),
}

/// How the handles are looked at and held, of the session.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hand {
    /// What the pointer or the keyboard is on.
    pub over: Option<Handle>,
    /// How many handles lie together there.
    pub together: usize,
    /// What is held.
    pub held: Option<Grasp>,
    /// The objects whose handles are shown: the chosen one, and the one pointed at.
    pub objects: [Option<usize>; 2],
    /// To what the drag is held.
    pub along: Along,
    /// The pointer's button belongs to a handle until it is let go.
    pub is_busy: bool,
}

/// A handle that is held, and what stays of how it was drawn when it was taken: so it is under the
/// pointer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grasp {
    /// Which.
    pub handle: Handle,
    /// How long, in the world, an arrow of length 1 is drawn whose tip is held.
    pub length: f64,
    /// From a sphere's centre to the point of its surface, of length 1.
    pub toward: DVec3,
}

/// What settings say of drags. `other` is the modifier that swaps what a moved eye keeps.
pub fn keeps_of(settings: &Settings, other: bool) -> (Keep, CornerKeeps, DistanceKeeps) {
    let eye = if other { settings.eye_keeps.other() } else { settings.eye_keeps };
    let corner = if settings.keep_pixel_shape { CornerKeeps::Ratio } else { CornerKeeps::Nothing };
    let distance = if settings.keep_picture { DistanceKeeps::Picture } else { DistanceKeeps::Size };
    (eye.into(), corner, distance)
}
