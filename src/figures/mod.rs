//! Figures for slides: what the window shows, as SVG, PDF and PNG.
//!
//! All of it is drawn by the window's own code. The overlay's marks come from its
//! [`Drawing`](crate::view::overlay::Drawing); labels, the derivation and the lab of lines are drawn into an
//! egui pass without a window. PNG is painted from both as the window is, dot for dot. For SVG and PDF,
//! both become the same primitives: paths and texts. So what is on the screen is what is in the file.
//!
//! - `order`: what is asked for, and the figure that it becomes;
//! - `figure`: a figure and its formats;
//! - `animation`: a GIF with a figure for each phase of what plays;
//! - `vector`: SVG and PDF, behind the feature `figures`.

mod animation;
mod figure;
mod order;
#[cfg(feature = "figures")]
mod vector;

pub use self::animation::{Animation, Frames, Recorder, check_animation_path};
pub use self::figure::{Figure, Format};
pub use self::order::{Content, MARGIN, Order, Subject, derivation_of, scale_of};
