//! The window's panels, one `ui` function a file. Each edits what it is given in place and says
//! nothing else to anyone.

pub(crate) mod accuracy;
pub(crate) mod camera;
pub mod dialogs;
pub(crate) mod exercises;
pub(crate) mod frame;
pub(crate) mod lesson_strip;
mod marked_text;
pub(crate) mod mistakes;
mod number;
pub(crate) mod objects;
pub(crate) mod places;
pub(crate) mod readouts;
pub(crate) mod selection;
mod sign;
pub(crate) mod top_bar;
pub(crate) mod views;
pub(crate) use number::significant;
