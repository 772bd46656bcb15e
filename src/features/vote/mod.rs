//! A vote on which mistake a picture shows.

pub mod state;
pub mod ui;

pub use state::OpenVote;
