//! Figures for slides: what the window shows, as SVG, PDF and PNG.
//!
//! All of it is drawn by the window's own code. The overlay's marks come from its
//! [`Drawing`](crate::view::overlay::Drawing), and labels, the derivation and the lab of lines are drawn by the
//! window's own code into an egui pass without a window. PNG is painted from both as the window is. For
//! SVG and PDF, both become the same `Primitive`s: paths, text and one picture. So what is on the screen is
//! what is in the file.
//!
//! - `figure`: a figure, its look and its formats;
//! - `order`: what is asked for;
//! - `animation`: many figures, one for each phase of what plays;
//! - `views`: figures of the two views; `panes`: of the derivation and the lab of lines;
//! - `vector`: SVG and PDF, behind the feature `figures`.

mod animation;
mod figure;
mod order;
mod panes;
#[cfg(feature = "figures")]
mod vector;
mod views;

pub use self::animation::{Animation, Frames, Recorder, Reel};
pub use self::figure::{Figure, Format, Look};
pub use self::order::{Content, Order, Subject, derivation_of};
pub use self::panes::MARGIN;
pub use self::views::{View, of_view, scale_of};
