//! The scene workspace: the world view and the camera view, dragging in them, and the numbers
//! below.

pub mod compare;
pub mod handles;
pub mod navigation;
pub mod pen;
pub mod readouts;
pub mod view_rects;
pub mod views;
pub mod walking;
