//! Handles that are dragged in the world view: eye, at, the tip of up, the viewport, spheres and
//! planes. This module is pure; pointer input is handled in `ui::scene::handles`.
//!
//! - `places`: the handles and their positions on the screen; `hit`: hit test.
//! - `part`: the values that a handle changes, before and after; `pull`: from the pointer to a
//!   point of the world, and on to those values through [`pinhole_core::steering`].
//! - `words`: names and values; `marks`: marks for the overlay.

mod hit;
mod marks;
mod part;
mod places;
mod pull;
mod words;

pub use hit::{Hit, hit};
pub use marks::drawn;
pub use part::{Part, Solid};
pub use places::{Grip, Stage, grips};
pub use pull::{How, Pull, Pulled, Start, step_of, turned_by};
pub use words::{label, value, vector};
