//! Steers a camera: functions that return the camera after a drag, a turn of the wheel, or a key.
//! The camera remains given in the same way (by at, by view, or by a basis).
//!
//! - *Turns*: [`Camera::orbited`], [`Camera::looked_round`]: a turntable about up and u, by the angles
//!   of [`Viewport::orbit_of_drag`](crate::Viewport::orbit_of_drag) and
//!   [`Viewport::look_of_drag`](crate::Viewport::look_of_drag).
//! - *Moves*: [`Camera::dollied`], [`Camera::zoomed`].
//! - *A single parameter*: [`Camera::swung`] rolls, [`Camera::up_tilted`] changes up,
//!   [`Camera::scaled_picture`] is the d-lock.
//! - *Handles*: [`Camera::led_to`], from the fields that [`Camera::with_eye`] or [`Camera::with_at`] sets.
//! - *Pointer*: [`ResolvedCamera::dragged`](crate::ResolvedCamera::dragged) returns the point of the
//!   world for a position in the observer's picture.
//! - *Readable numbers*: [`snapped`], [`nice_step`], [`rounded_to`], given the size [`pixel_in_world`].
//!
//! A steered camera always has a basis; otherwise the function returns a typed error with the numbers.
//! No result is NaN.
//!
//! # At the poles
//!
//! Where the view is parallel to up there is no basis, and close to up a small turn of the view is a
//! large turn of v, by up to `1 / sin(angle)`. No rule can avoid such turns altogether: a v for every
//! view direction is a field of tangents on the sphere, and such a field jumps somewhere (H. Poincaré
//! 1885, L. E. J. Brouwer 1912: the hairy ball). Therefore:
//!
//! - Turns stop [`POLE_GAP`] short of up and of -up, and v turns by at most `|yaw| + |pitch|`.
//! - Handles, which may be dragged anywhere, push up ahead of the view: within [`CONE`] of up or -up, up
//!   turns with the view, so that v turns exactly as the view does (it is transported in parallel);
//!   outside, up stays to the bit and v turns by at most `1 / sin(CONE)`, 11.5, times as much. So a small
//!   drag is a small change, from any camera; and two drags from the same camera that end close together
//!   may give different v if the path of one touched the cone and the path of the other did not.
//!
//! Rounding of the result may turn the basis further, by at most [`ROUNDING_TURN`], and for cameras of
//! everyday sizes by 1e-12. Where rounding would turn the basis by more (eye and at are much closer to
//! each other than to the origin, or up is nearly parallel to the view), the functions return
//! [`SteerError::Unsteady`].

use glam::DVec3;
use thiserror::Error;

use crate::camera::basis::Basis;
use crate::camera::{Camera, CameraError};
use crate::exact::scale::{angle_between, shortest, unit};

pub use handles::Keep;
pub use pointer::{
    DragAlong, FARTHEST, LEAST_ANGLE, nice_step, pixel_in_world, rounded_to, snapped,
};

mod handles;
mod moves;
mod pointer;

/// The smallest angle between up, or -up, and the view to which [`Camera::orbited`] and
/// [`Camera::looked_round`] turn, in radians: 1 degree.
pub const POLE_GAP: f64 = std::f64::consts::PI / 180.0;

/// The angle to up, or to -up, within which dragging a handle also turns up, in radians: 5 degrees.
pub const CONE: f64 = 5.0 * std::f64::consts::PI / 180.0;

/// The maximum turn of u, v and w by rounding, in addition to the intended turn, in radians.
pub const ROUNDING_TURN: f64 = 1e-6;

/// A camera after the drag of a handle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steered {
    /// The camera after the drag.
    pub camera: Camera,
    /// True if up was changed, because the view came within [`CONE`] of up or -up.
    pub up_went_along: bool,
}

/// Reason why a camera cannot be steered, or a point cannot be dragged.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SteerError {
    /// The camera is invalid before or after the change.
    #[error(transparent)]
    Camera(CameraError),
    /// A number is NaN or infinite.
    #[error("{field} is {}: it must be a finite number", shortest(*.value))]
    NotFinite {
        /// The number's name: `yaw`, `pitch`, `forward`, `value`.
        field: &'static str,
        /// The invalid number.
        value: f64,
    },
    /// A number is not positive and finite.
    #[error("{field} is {}: it must be finite and greater than 0", shortest(*.value))]
    NotPositive {
        /// The number's name: `factor`, `scale`, `step`, `pixel`.
        field: &'static str,
        /// The invalid number.
        value: f64,
    },
    /// A coordinate would be beyond the range of `f64`.
    #[error(
        "the camera would be beyond the range of numbers: move eye, at and up nearer to the origin"
    )]
    OutOfRange,
    /// The camera's basis is set by hand, so there is no up to drag.
    #[error("the basis is set by hand: there is no up to drag")]
    NoUp,
    /// Rounding eye, at or up would turn the camera by more than [`ROUNDING_TURN`].
    #[error(
        "rounded, eye, at and up would turn the camera by {turn:.1e} radians: move eye and at \
         apart or nearer to the origin, or up away from the view direction"
    )]
    Unsteady {
        /// The turn in radians.
        turn: f64,
    },
    /// The dragged point is not in front of the observer.
    #[error("the handle is at depth {}: not in front", shortest(*.depth))]
    NotInFront {
        /// The point's depth, 0 or negative.
        depth: f64,
    },
    /// The axis of a drag points at the observer, or its plane is seen from its edge.
    #[error(
        "seen along the axis or plane of the drag, {:.1} degrees from it: look from aside",
        .angle.to_degrees()
    )]
    OnEdge {
        /// The angle to the line of sight, in radians, less than [`LEAST_ANGLE`].
        angle: f64,
    },
    /// The pointer is past the horizon of the drag's axis or plane, or nearly there.
    #[error("past the horizon of the drag's axis or plane")]
    PastHorizon,
}

impl<E: Into<CameraError>> From<E> for SteerError {
    fn from(e: E) -> Self {
        SteerError::Camera(e.into())
    }
}

fn check_finite(field: &'static str, value: f64) -> Result<(), SteerError> {
    if value.is_finite() { Ok(()) } else { Err(SteerError::NotFinite { field, value }) }
}

fn check_positive(field: &'static str, value: f64) -> Result<(), SteerError> {
    let is_positive = value.is_finite() && value > 0.0;
    if is_positive { Ok(()) } else { Err(SteerError::NotPositive { field, value }) }
}

/// A right-handed rotation about an axis of length 1: `x cos + (k x x) sin + k (k . x) (1 - cos)` (O.
/// Rodrigues 1840), written so that a small angle keeps its digits.
#[derive(Clone, Copy, Debug)]
struct Turn {
    axis: DVec3,
    sin: f64,
    one_minus_cos: f64,
}

impl Turn {
    fn about(axis: DVec3, radians: f64) -> Turn {
        let half = (0.5 * radians).sin();
        Turn { axis, sin: radians.sin(), one_minus_cos: 2.0 * half * half }
    }

    fn turned(&self, x: DVec3) -> DVec3 {
        let across = self.axis.cross(x);
        x + self.sin * across + self.one_minus_cos * self.axis.cross(across)
    }

    fn turned_frame(&self, Basis { u, v, w }: &Basis) -> Basis {
        Basis { u: self.turned(*u), v: self.turned(*v), w: self.turned(*w) }
    }
}

/// Returns the nearest basis with the same w: its vectors are unit and orthogonal but for one rounding
/// of each coordinate.
fn orthonormal(basis: &Basis) -> Basis {
    let w = unit(basis.w);
    let u = unit(basis.v.cross(w));
    // Added to 0, a negative zero is 0, which readers expect to see.
    Basis { u: u + DVec3::ZERO, v: w.cross(u) + DVec3::ZERO, w: w + DVec3::ZERO }
}

/// Returns the camera if its basis equals `meant` but for rounding, or [`SteerError::Unsteady`].
fn steady(camera: Camera, meant: &Basis) -> Result<Camera, SteerError> {
    let found = camera.basis()?;
    let turn = angle_between(found.v, meant.v).max(angle_between(found.w, meant.w));
    if turn <= ROUNDING_TURN { Ok(camera) } else { Err(SteerError::Unsteady { turn }) }
}
