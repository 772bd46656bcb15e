//! Computes everything that the window shows from the document and the session, with pure functions.
//! [`derive`](mod@derive) combines them and caches the results.

pub mod accuracy;
pub mod adaptive_resolution;
pub mod animation;
pub mod derive;
pub mod figure_order;
pub mod handle_drag;
pub mod handles;
pub mod lines;
pub mod plot;
