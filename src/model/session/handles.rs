//! The handles of the world view, and the drag in progress.

use pinhole_core::{Camera, DVec2, DVec3, Object, Selection, Viewport};
use pinhole_exchange::document::Document;

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

/// A corner of the viewport, as the camera sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Corner {
    /// True on the right, where u is positive.
    pub is_right: bool,
    /// True at the top, where v is positive.
    pub is_top: bool,
}

impl Corner {
    /// All four, row by row.
    pub const ALL: [Corner; 4] = [
        Corner { is_right: false, is_top: true },
        Corner { is_right: true, is_top: true },
        Corner { is_right: false, is_top: false },
        Corner { is_right: true, is_top: false },
    ];

    /// Returns the signs of its u and v.
    pub fn signs(self) -> DVec2 {
        let sign = |is_positive| if is_positive { 1.0 } else { -1.0 };
        DVec2::new(sign(self.is_right), sign(self.is_top))
    }

    /// Returns its position in the viewport.
    pub fn uv(self, viewport: &Viewport) -> DVec2 {
        0.5 * self.signs() * DVec2::new(viewport.width, viewport.height)
    }
}

impl Handle {
    /// Returns the index of the object that the handle belongs to.
    pub fn object(self) -> Option<usize> {
        match self {
            Handle::Center(k) | Handle::Radius(k) | Handle::Point(k) => Some(k),
            _ => None,
        }
    }

    /// Returns the overlay item that must be shown, in addition to the handles, so that this handle
    /// exists.
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
    /// The objects whose handles are shown: the selected one and the hovered one.
    pub objects: [Option<usize>; 2],
    /// True until the pointer's button is released, once it was pressed for a drag.
    pub is_busy: bool,
}

/// The object of a drag: a handle or the camera view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grabbed {
    /// A handle of the world view.
    Handle(Handle),
    /// The camera view, to look around.
    Look,
    /// The camera view, to orbit around the pivot.
    Orbit,
}

/// A drag, with the state at its beginning. Its effect is always computed from that state, so that
/// dragging back to the start changes nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag {
    /// The handle or view that is dragged.
    pub grabbed: Grabbed,
    /// The values that the drag changes.
    pub before: HandleValues,
    /// Position where the pointer was, in the viewport of the observer, or of the camera in its own
    /// view.
    pub begun_at: DVec2,
    /// Position of the handle in the world.
    pub at: DVec3,
    /// Length in the world at which an up vector of length 1 was drawn. With this length, the tip of up stays
    /// under the pointer. 1 for other handles.
    pub length: f64,
    /// Unit vector from a sphere's centre to the dragged point of its surface. It follows the
    /// pointer.
    pub toward: DVec3,
}

impl Drag {
    /// Returns the handle that is dragged.
    pub fn handle(&self) -> Option<Handle> {
        match self.grabbed {
            Grabbed::Handle(handle) => Some(handle),
            Grabbed::Look | Grabbed::Orbit => None,
        }
    }
}

/// The part of document and session that a drag can change, either before or after the change.
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
    /// Returns the current values, with the object of this index.
    pub fn read(document: &Document, selection: Selection, object: Option<usize>) -> HandleValues {
        let object = object.and_then(|k| Some((k, document.object(k)?)));
        HandleValues { camera: document.camera, selection, object }
    }

    /// Writes this part into document and session.
    pub fn put(&self, document: &mut Document, selection: &mut Selection) {
        (document.camera, *selection) = (self.camera, self.selection);
        if let Some((k, object)) = self.object {
            document.set_object(k, object);
        }
    }
}
