//! Two lines in the plane, an implicit and a parametric one, and where they meet.

pub mod state;
pub mod ui;
pub mod view;

pub use state::LinesLab;
