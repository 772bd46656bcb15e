//! Computes everything that the window shows from the document and the session, with pure functions.
//! [`derive`](mod@derive) combines them and caches the results.

pub mod accuracy;
pub mod adaptive_resolution;
pub(crate) mod chart;
pub mod derivation;
pub mod derive;
pub mod formula;
pub mod handle_drag;
pub mod handles;
pub mod headless;
pub mod lines;
pub mod overlay;
pub mod painter;
pub mod plot;
pub mod typesetting;
