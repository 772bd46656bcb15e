//! Everything that the window shows, as pure functions of the document and the session.
//! [`derive`](mod@derive) combines them and caches what has not changed.

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
