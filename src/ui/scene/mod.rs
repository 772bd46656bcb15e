//! The scene workspace: the world view and the camera view, dragging in them, and the numbers below them.

pub mod compare;
pub mod dragging;
pub(crate) mod gizmo;
pub mod readouts;
pub mod steps;
pub mod view_rects;
pub mod views;

use dragging::WorldArea;
pub(crate) use dragging::{Dragging, ViewInput};
pub(crate) use view_rects::{Divider, ViewRects};
