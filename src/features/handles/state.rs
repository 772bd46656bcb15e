//! The handles of the world view, and the drag in progress.

use pinhole_core::{Camera, DVec2, DVec3, Object, Selection, Viewport};
use pinhole_exchange::document::Document;
use pinhole_figure::overlay_items::Item;

/// A handle in the world view. Variants for an object hold its index in the document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Handle {
    /// The camera's position.
    Eye,
    /// The point at which the camera looks or, for a camera given by view, the tip of the view vector.
    At,
    /// The tip of up.
    Up,
    /// A corner of the viewport: changes width and height.
    Corner(Corner),
    /// The middle of the viewport's lower edge: changes the distance.
    Distance,
    /// The centre of a sphere.
    Center(usize),
    /// A point of a sphere's surface: changes the radius.
    Radius(usize),
    /// The point that defines a plane.
    Point(usize),
    /// The selected pixel.
    Pixel,
}

/// A corner of the viewport, as seen by the camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Corner {
    /// True for the corners on the right, where u is positive.
    pub is_right: bool,
    /// True for the corners at the top, where v is positive.
    pub is_top: bool,
}

impl Corner {
    /// All four corners, row by row.
    pub const ALL: [Corner; 4] = [
        Corner { is_right: false, is_top: true },
        Corner { is_right: true, is_top: true },
        Corner { is_right: false, is_top: false },
        Corner { is_right: true, is_top: false },
    ];

    /// Returns the signs of the corner's u and v.
    pub fn signs(self) -> DVec2 {
        let sign = |is_positive| if is_positive { 1.0 } else { -1.0 };
        DVec2::new(sign(self.is_right), sign(self.is_top))
    }

    /// Returns the corner's position in the viewport.
    pub fn uv(self, viewport: &Viewport) -> DVec2 {
        0.5 * self.signs() * DVec2::new(viewport.width, viewport.height)
    }
}

impl Handle {
    /// Returns the index of the object to which the handle belongs; `None` if it belongs to none.
    pub fn object(self) -> Option<usize> {
        match self {
            Handle::Center(k) | Handle::Radius(k) | Handle::Point(k) => Some(k),
            _ => None,
        }
    }

    /// Returns the overlay item to which the handle belongs. The handle is available only if that item and
    /// the item *handles* are shown.
    pub fn item(self) -> Item {
        match self {
            Handle::Eye => Item::Eye,
            Handle::At => Item::At,
            Handle::Up => Item::ViewAndUp,
            Handle::Corner(_) | Handle::Distance => Item::Viewport,
            Handle::Center(_) | Handle::Radius(_) => Item::Handles,
            Handle::Point(_) => Item::Planes,
            Handle::Pixel => Item::Ray,
        }
    }

    /// Returns true if the handle lies on the viewport's rectangle.
    pub fn is_on_viewport(self) -> bool {
        matches!(self, Handle::Corner(_) | Handle::Distance | Handle::Pixel)
    }
}

/// The state of the handles in a session.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HandleState {
    /// The handle under the pointer or with the keyboard focus.
    pub over: Option<Handle>,
    /// The drag in progress.
    pub drag: Option<Drag>,
    /// The objects whose handles are shown: the selected one and the one under the pointer.
    pub objects: [Option<usize>; 2],
    /// True from the press that begins a drag until the mouse button is released.
    pub is_busy: bool,
}

/// What is dragged: a handle, or the camera view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grabbed {
    /// A handle of the world view.
    Handle(Handle),
    /// The camera view, to look around.
    Look,
    /// The camera view, to orbit around the pivot.
    Orbit,
}

/// A drag in progress, with the state at its beginning. Its effect is always computed from that state, so
/// dragging back to the start changes nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag {
    /// The dragged handle or view.
    pub grabbed: Grabbed,
    /// The values before the drag.
    pub before: HandleValues,
    /// Position of the pointer when the drag began, as a point (u, v) of the observer's viewport or, for a
    /// drag in the camera view, of the camera's viewport.
    pub begun_at: DVec2,
    /// Position of the handle in the world when the drag began.
    pub at: DVec3,
    /// Length in the world at which an up vector of length 1 was drawn when the drag began; 1 for other
    /// handles. It keeps the tip of up under the pointer.
    pub length: f64,
    /// Unit vector from a sphere's centre to the point of its surface that is dragged and follows the
    /// pointer.
    pub toward: DVec3,
    /// True if the tip of up began to move within the plane of up and view, in which it then stays; `None` until it has
    /// moved.
    pub is_beside_view: Option<bool>,
}

impl Drag {
    /// Returns the dragged handle; `None` if the camera view is dragged.
    pub fn handle(&self) -> Option<Handle> {
        match self.grabbed {
            Grabbed::Handle(handle) => Some(handle),
            Grabbed::Look | Grabbed::Orbit => None,
        }
    }
}

/// The values of the document and the session that a drag can change, at some moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandleValues {
    /// The edited camera.
    pub camera: Camera,
    /// The selected ray.
    pub selection: Selection,
    /// The handle's object, with its index in the document.
    pub object: Option<(usize, Object)>,
}

impl HandleValues {
    /// Reads the current values from the document and the session, including those of the object with this
    /// index.
    pub fn read(document: &Document, selection: Selection, object: Option<usize>) -> HandleValues {
        let object = object.and_then(|k| Some((k, document.object(k)?)));
        HandleValues { camera: document.camera, selection, object }
    }

    /// Writes the values into document and session.
    pub fn put(&self, document: &mut Document, selection: &mut Selection) {
        (document.camera, *selection) = (self.camera, self.selection);
        if let Some((k, object)) = self.object {
            document.set_object(k, object);
        }
    }
}
