//! From the document to what is shown: pure functions of their arguments. [`derive`](mod@derive) puts
//! them together and remembers what has not changed.

pub mod accuracy;
pub mod adaptive_resolution;
pub mod derivation;
pub mod derive;
pub mod formula;
pub mod ghost;
pub mod handles;
pub mod headless;
pub mod lines;
pub mod overlay;
pub mod painter;
pub mod plot;
pub mod typesetting;
