//! A reference implementation that computes the true results for a pinhole camera, and families of
//! rays for which they are hard to compute.
//!
//! The reference uses the formulas of the textbook with arbitrary-precision arithmetic, on the exact
//! values of the given `f64` numbers. It shares no code with the program that it checks. What it
//! decides (hit or miss, and which object is first) is proven: signs and comparisons are found by
//! interval arithmetic with increasing precision and, if that is inconclusive, by exact algebra. Its
//! numeric results are [`Real`]s of at least 440 bits.
//!
//! ```
//! use pinhole_reference::*;
//!
//! let ball = Object::Sphere { center: [0.0, 0.0, -5.0], radius: 1.0 };
//! let hit = first_hit(&[ball], [0.0; 3], [0.0, 0.0, -1.0]).expect("the ball is ahead");
//! assert_eq!(hit.t.to_f64(), 4.0);
//! assert_eq!(hit.t.ulps_from(4.0_f64.next_up()), 1.0);
//! ```

mod camera;
mod dyadic;
mod families;
mod interval;
mod object;
mod quotient;
mod real;
mod surd;
mod trace;

pub use camera::{Camera, Orientation, Status, View, basis};
pub use families::{Draw, Family, RayCase, decade, moved_by_ulps};
pub use object::Object;
pub use real::{Real, angle_between};
pub use trace::{Hit, first_hit, roots};

#[cfg(test)]
extern crate self as pinhole_reference;
#[cfg(test)]
mod tests;
