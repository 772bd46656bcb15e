//! Handles of points and vectors: where they are, and what a drag changes.

pub mod drag;
pub mod placed;
pub mod state;

pub use state::HandleState;
