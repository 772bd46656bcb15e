//! Handles that are dragged in the world view: eye, at, the tip of up, the viewport, spheres and
//! planes. This module is pure; pointer input is handled in `ui::scene::handles`.
//!
//! - `positions`: the handles and their positions on the screen; `hit`: hit test.
//! - `values`: the values that a handle changes, before and after; `drag`: from the pointer to a
//!   point of the world, and on to those values through [`pinhole_core::steering`].
//! - `text`: names and values; `marks`: marks for the overlay.
//!
//! No gizmo crate is used: those for egui edit one transform at a time, where a viewport has corners
//! and a sphere a radius, and paint past the overlay, whose marks go into figures.

mod drag;
mod hit;
mod magnet;
mod marks;
mod positions;
mod text;
mod values;

pub use drag::{DragOptions, DragStart, Dragged, HandleDrag, step_of, turned_by};
pub use hit::{Hit, hit};
pub use marks::drawn;
pub use positions::{Grip, Stage, grips};
pub use text::{label, value, vector};
pub use values::{HandleValues, Solid};
