//! Computes everything that the window shows from the document and the session, with pure functions.
//! [`derive`](mod@derive) combines them and caches the results.

pub mod adaptive_resolution;
pub mod derive;
