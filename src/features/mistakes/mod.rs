//! The classic mistakes as wrong cameras beside the right one.

mod state;
pub mod ui;
pub mod ui_gallery;

pub use state::MistakesView;
