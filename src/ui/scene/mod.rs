//! The scene workspace: the world view and the camera view, dragging in them, and the numbers
//! below.

pub mod compare;
pub mod drag_text;
pub mod dragging;
pub mod pen;
pub mod readouts;
pub mod steps;
pub mod view_rects;
pub mod views;
