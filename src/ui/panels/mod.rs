//! The window's panels, one `ui` function a file. Each edits what it is given in place and says
//! nothing else to anyone.

pub(crate) mod camera;
pub(crate) mod lesson_strip;
pub(crate) mod objects;
pub(crate) mod play;
pub(crate) mod selection;
mod teaching;
pub(crate) mod top_bar;
