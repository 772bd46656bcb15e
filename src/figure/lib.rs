//! What Pinhole draws, without a window: the camera in its scene and the camera's picture with their marks, the
//! derivation as formulas, charts, and all of it as pixels, SVG or PDF.
//!
//! - [`concept`], [`symbols`]: what is taught, and how it is written; [`given`]: the numbers that are given rather than
//!   computed; [`inspection`]: the selected ray with all its numbers; [`readings`]: these as they are written.
//! - [`observer`]: from where the world view is drawn.
//! - [`overlay`]: the one list of what is drawn, and the two views that draw it; [`overlay_items`]: its switches;
//!   [`answer_mark`]: answers as marks; [`scheme`]: colours that tell things apart.
//! - [`derivation`], [`formula`]: the derivation as formulas, and their layout; [`typesetting`]: text on the screen.
//! - [`chart`]: axes, ticks and curves.
//! - [`painter`], [`headless`]: what egui draws as pixels, without a graphics adapter or a window.
//! - [`export`]: figures as files.
//!
//! Nothing here knows a session, a lesson or a file of the user's; drawing is a function of what is to be drawn.

pub mod answer_mark;
pub mod chart;
pub mod concept;
pub mod derivation;
pub mod export;
pub mod fault;
pub mod formula;
pub mod given;
pub mod headless;
pub mod inspection;
pub mod observer;
pub mod overlay;
pub mod overlay_items;
pub mod painter;
pub mod readings;
pub mod scheme;
pub mod symbols;
pub mod typesetting;

pub use answer_mark::{AnswerMark, MarkShape};
pub use concept::{Concept, EquationStep, HoverSource, Hovered};
pub use derivation::sections::{DerivationSection, DerivationSections, Formulas};
pub use fault::Fault;
pub use given::{Given, GivenVector, Givens};
pub use inspection::Inspection;
pub use observer::{Observer, ViewSize};
pub use overlay_items::{Item, OverlayItems};
pub use readings::NumberStyle;
pub use scheme::Scheme;
