//! The window's panels, one `ui` function a file. Each edits what it is given in place and says
//! nothing else to anyone.

pub(crate) mod accuracy;
pub(crate) mod answers;
pub(crate) mod camera;
pub(crate) mod compare;
pub mod dialogs;
pub(crate) mod exercises;
pub mod export;
pub(crate) mod formula;
pub(crate) mod frame;
pub(crate) mod framing;
pub(crate) mod handles;
pub(crate) mod key_sheet;
pub(crate) mod ledger;
pub(crate) mod lesson_strip;
pub(crate) mod lines;
pub(crate) mod look;
mod marked_text;
pub(crate) mod mistakes;
pub(crate) mod navigation;
mod notation;
mod number;
pub(crate) mod objects;
pub(crate) mod palette;
pub(crate) mod places;
pub(crate) mod play;
pub(crate) mod plot;
pub(crate) mod readouts;
pub(crate) mod selection;
mod sign;
mod teaching;
pub(crate) mod top_bar;
pub(crate) mod translator;
pub(crate) mod views;
mod walking;
mod words;
