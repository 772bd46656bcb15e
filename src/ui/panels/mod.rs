//! The window's panels, one `ui` function per file. Each edits the values it is given in place, and
//! has no other effects.

pub(crate) mod camera;
pub(crate) mod lesson_strip;
pub(crate) mod objects;
pub(crate) mod play;
pub(crate) mod selection;
mod teaching;
pub(crate) mod top_bar;
