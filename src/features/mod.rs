//! The features, a folder each: what a feature remembers, what it computes from that, and what it shows. Only files named
//! `ui…` use the window's parts in [`crate::ui`]. The window in `ui/app` puts the features together.

pub mod accuracy;
pub mod answers;
pub mod class;
pub mod exercises;
pub mod export;
pub mod handles;
pub mod lines;
pub mod mistakes;
pub mod play;
pub mod plot;
pub mod share;
pub mod translator;
pub mod vote;
