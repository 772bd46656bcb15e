//! The camera taken in the hand: what a drag, a turn of the wheel or a key does to it, as functions
//! from one camera to the next. How the camera is given (by at, by view, by hand) stays.
//!
//! - *Turns*: [`Camera::orbited`], [`Camera::looked_round`]: a turntable about up and u;
//!   [`Viewport::orbit_of_drag`](crate::Viewport::orbit_of_drag) and
//!   [`Viewport::look_of_drag`](crate::Viewport::look_of_drag) say by how much.
//! - *Moves*: [`Camera::dollied`], [`Camera::zoomed`].
//! - *A single parameter*: [`Camera::swung`] rolls, [`Camera::up_tilted`] changes up,
//!   [`Camera::scaled_picture`] is the d-lock.
//! - *Handles*: [`Camera::with_eye_at`], [`Camera::with_at`].
//! - *Pointer*: [`ResolvedCamera::dragged`](crate::ResolvedCamera::dragged): from a position in the
//!   observer's picture to a point of the world.
//! - *Readable numbers*: [`snapped`], [`nice_step`], [`rounded_to`], by [`pixel_in_world`].
//!
//! Every result is a camera with a basis, or a typed error with the numbers; never NaN.
//!
//! # At the poles
//!
//! Where the view is parallel to up there is no basis, and near it a small turn of the view is a large
//! turn of v, by up to `1 / sin(angle)`. No rule takes this away altogether: a v for every view
//! direction is a field of tangents on the sphere, and such a field jumps somewhere (H.
//! Poincaré 1885, L. E. J. Brouwer 1912: the hairy ball). So:
//!
//! - Turns stop [`POLE_GAP`] short of up and of -up, and v turns by at most `|yaw| + |pitch|`.
//! - Handles, which may be dragged anywhere, push up before them: within [`CONE`] of up or -up, up
//!   goes along, so that v turns exactly as the view does (is transported in parallel); outside, up
//!   stays to the bit and v turns by at most `1 / sin(CONE)`, 11.5, times as much. So a small drag
//!   is a small change, from any camera; and of two drags from the same camera that end side by
//!   side, the v of one may differ if its way touched the cone and the other's passed beside it.
//!
//! Rounding of the result may turn the basis further by [`ROUNDING_TURN`] at most, and for cameras of
//! everyday sizes by 1e-12; where it would be more (eye and at are much closer to each other than to the
//! origin, up nearly parallel to the view) the answer is [`SteerError::Unsteady`].

mod handles;
mod moves;
mod pointer;
mod pole;
mod single_parameter;
mod snap;
mod steered;
mod turns;

#[cfg(doc)]
use crate::camera::Camera;

pub use handles::Keep;
pub use pointer::{DragAlong, FARTHEST, LEAST_ANGLE, pixel_in_world};
pub use snap::{nice_step, rounded_to, snapped};
pub use steered::{CONE, POLE_GAP, ROUNDING_TURN, SteerError, Steered};
