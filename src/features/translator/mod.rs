//! The camera in other programs' terms.

pub mod state;
pub mod ui;

pub use state::Translator;
