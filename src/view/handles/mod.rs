//! What one takes in the hand in the world view: eye, at, the tip of up, the viewport, spheres and
//! planes. Pure: who presses what is known to `panels::handles`.
//!
//! - `places`: which handles there are, and where they are seen; `hit`: which one is meant.
//! - `part`: what a handle changes, as it was before and as it is after; `pull`: from the pointer to
//!   a point of the world, and from there, through [`pinhole_core::steering`], to the part.
//! - `words`: names and values; `marks`: what the overlay draws.

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
