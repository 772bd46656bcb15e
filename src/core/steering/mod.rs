//! Steers a camera: functions that return the camera after a drag, a turn of the wheel, or a key press.
//! The orientation of the result is given in the same way as that of the camera: by at, by view, or by a
//! basis.
//!
//! - *Turns*: [`Camera::orbited`], [`Camera::looked_round`] rotate about up and u, like a turntable, by
//!   the angles of [`Viewport::orbit_of_drag`](crate::Viewport::orbit_of_drag) and
//!   [`Viewport::look_of_drag`](crate::Viewport::look_of_drag).
//! - *A single parameter*: [`Camera::zoomed`] changes the field of view, [`Camera::swung`] rolls,
//!   [`Camera::up_tilted`] changes up, [`Camera::scaled_picture`] changes the distance without changing the
//!   picture.
//! - *Handles*: [`Camera::led_to`], given the camera that [`Camera::with_eye`] or [`Camera::with_at`]
//!   returns.
//! - *Pointer*: [`ResolvedCamera::dragged`](crate::ResolvedCamera::dragged) converts a position in the
//!   picture of an observer, another camera that shows the steered one, to a point of the world.
//! - *Readable numbers*: [`snapped`], [`nice_step`] and [`rounded_to`], for a pixel of the size
//!   [`pixel_in_world`].
//!
//! A steered camera always has a basis; otherwise the function returns a typed error with the invalid
//! numbers. No result is NaN.
//!
//! # At the poles
//!
//! If the view is parallel to up, there is no basis. If it is close to up, a small turn of the view is a
//! large turn of v, up to `1 / sin(angle)` times as large. No rule can avoid such turns altogether:
//! choosing a v for every view direction is choosing a tangent vector at every point of the sphere,
//! which cannot be done without a jump (H. Poincaré 1885, L. E. J. Brouwer 1912: the hairy ball).
//! Therefore:
//!
//! - Turns stop [`POLE_GAP`] short of up and of -up, and v turns by at most `|yaw| + |pitch|`.
//! - Handles may be dragged anywhere. Within [`CONE`] of up or -up, the view pushes up ahead of it: v is
//!   parallel-transported, so it turns exactly as much as the view. Outside, up stays bit for bit the
//!   same, and v turns at most `1 / sin(CONE) = 11.5` times as much as the view. So a small drag makes a
//!   small change, from any camera. But two drags from the same camera that end close together may give
//!   different v, if the path of one touched the cone and that of the other did not.
//!
//! Rounding of the result may turn the basis further, by at most [`ROUNDING_TURN`]; for cameras of
//! everyday sizes, by at most 1e-12. If it would turn the basis by more (because eye and at are much
//! closer to each other than to the origin, or up is nearly parallel to the view), the functions return
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

/// The angle between up, or -up, and the view within which dragging a handle also turns up, in radians:
/// 5 degrees.
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

/// The reason why a camera cannot be steered, or a point cannot be dragged.
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
    /// The axis of a drag points almost at the observer, or its plane is seen almost edge-on.
    #[error(
        "seen along the axis or plane of the drag, {:.1} degrees from it: look from the side",
        .angle.to_degrees()
    )]
    OnEdge {
        /// The angle between the axis or plane and the line of sight, in radians. It is less than
        /// [`LEAST_ANGLE`].
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

/// A right-handed rotation about an axis k of length 1, which turns a vector p to
/// `p cos + (k x p) sin + k (k . p) (1 - cos)` (O. Rodrigues 1840), written so that a small angle keeps
/// its digits.
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

/// Returns the nearest orthonormal basis with the same w. Each coordinate is rounded once.
fn orthonormal(basis: &Basis) -> Basis {
    let w = unit(basis.w);
    let u = unit(basis.v.cross(w));
    // Adding 0 turns a negative zero into 0, which readers expect to see.
    Basis { u: u + DVec3::ZERO, v: w.cross(u) + DVec3::ZERO, w: w + DVec3::ZERO }
}

/// Returns the camera if its basis equals `meant` except for rounding; otherwise
/// [`SteerError::Unsteady`].
fn steady(camera: Camera, meant: &Basis) -> Result<Camera, SteerError> {
    let found = camera.basis()?;
    let turn = angle_between(found.v, meant.v).max(angle_between(found.w, meant.w));
    if turn <= ROUNDING_TURN { Ok(camera) } else { Err(SteerError::Unsteady { turn }) }
}
