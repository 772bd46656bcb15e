//! A vote, on which mistake a picture shows or on the question of a lesson's step.

pub mod state;
pub mod ui;

pub use state::OpenVote;
