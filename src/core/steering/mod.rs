//! The camera taken in the hand: what a drag, a turn of the wheel or a key does to it, as functions
//! from one camera to the next. How the camera is given (by at, by view, by hand) stays.
//!
//! - *Turns*: [`Camera::orbited`], [`Camera::looked_round`]: a turntable about up and u;
//!   [`Viewport::orbit_of_drag`](crate::Viewport::orbit_of_drag) and
//!   [`Viewport::look_of_drag`](crate::Viewport::look_of_drag) say by how much.
//! - *Moves*: [`Camera::dollied`], [`Camera::zoomed`], [`Camera::travelled`].
//! - *One thing alone*: [`Camera::swung`] rolls, [`Camera::up_tilted`] and [`Camera::up_tipped`] change
//!   up, [`Camera::scaled_picture`] is the d-lock.
//! - *Handles*: [`Camera::with_eye_at`], [`Camera::with_at`], [`Camera::with_up_tip`],
//!   [`Camera::with_viewport_corner`], [`Camera::with_viewport_through`]; spheres and planes have their
//!   own.
//! - *Pointer*: [`Drag`]: from a place in the observer's picture to a point of the world.
//! - *Readable numbers*: [`snapped`], [`nice_step`], [`rounded_to`], by [`pixel_in_world`].
//!
//! Every result is a camera with a basis, or a typed error with the numbers; never NaN.
//!
//! # At the poles
//!
//! Where the view is parallel to up there is no basis, and near it a small turn of the view is a large
//! turn of v, by up to `1 / sin(angle)`. No rule takes this away altogether: a v for every view
//! direction is a field of tangents on the sphere, and such a field has a place where it jumps (H.
//! Poincaré 1885, L. E. J. Brouwer 1912: the hairy ball). So:
//!
//! - Turns stop [`POLE_GAP`] short of up and of -up, and v turns by at most `|yaw| + |pitch|`.
//! - Handles, which may be dragged anywhere, push up before them: within [`CONE`] of up or -up,
//!   up goes along, so that v turns exactly as the view does (is transported in parallel);
//!   outside, up stays to the bit and v turns by at most `1 / sin(CONE)`, 11.5, times as much. So a small
//!   drag is a small change, from any camera; and of two drags from the same camera that end side by
//!   side, the v of one may differ if its way touched the cone and the other's passed beside it.
//!
//! Rounding of the result may turn the basis further by [`ROUNDING_TURN`] at most, and for cameras of
//! everyday sizes by 1e-12; where it would be more (eye and at are much closer to each other than to the
//! origin, up nearly parallel to the view) the answer is [`SteerError::Unsteady`].

mod handles;
mod moves;
mod objects;
mod one_thing;
mod pointer;
mod pole;
mod snap;
mod turns;

use std::fmt;

use glam::DVec3;

pub use handles::{CornerKeeps, DistanceKeeps, Keep, ViewportCorner};
pub use pointer::{Drag, DragAlong, DragError, FARTHEST, LEAST_ANGLE, pixel_in_world};
pub use snap::{nice_step, rounded_point, rounded_to, snapped};

use crate::basis::{Basis, BasisError};
use crate::camera::{Camera, CameraError};
use crate::number::shortest;
use crate::scale::unit;
use crate::viewport::ViewportError;

/// The smallest angle between up, or -up, and the view that [`Camera::orbited`] and
/// [`Camera::looked_round`] go to, in radians: 1 degree.
pub const POLE_GAP: f64 = std::f64::consts::PI / 180.0;

/// Within this angle of up, or of -up, a handle that is dragged takes up along, in radians:
/// 5 degrees.
pub const CONE: f64 = 5.0 * std::f64::consts::PI / 180.0;

/// The most that rounding may turn u, v and w besides what the hand did, in radians.
pub const ROUNDING_TURN: f64 = 1e-6;

/// What a drag of a handle made of a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Steered {
    /// The camera after it.
    pub camera: Camera,
    /// Whether up was changed, because the view came within [`CONE`] of it.
    pub up_went_along: bool,
}

/// Why a camera cannot be steered so.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SteerError {
    /// There would be no camera, or there was none before.
    Camera(CameraError),
    /// A number that is NaN or infinite.
    NotFinite {
        /// What it stands for: `yaw`, `pitch`, `forward`, `value`, `the angle`.
        field: &'static str,
        /// The value.
        value: f64,
    },
    /// A number that is not positive and finite.
    NotPositive {
        /// What it stands for: `factor`, `scale`, `step`, `pixel`.
        field: &'static str,
        /// The value.
        value: f64,
    },
    /// The camera's basis is set by hand: it has no up to change.
    NoUp,
    /// Rounding eye, at or up would turn the camera by more than [`ROUNDING_TURN`].
    Unsteady {
        /// By how many radians.
        turn: f64,
    },
}

impl fmt::Display for SteerError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SteerError::Camera(e) => e.fmt(f),
            SteerError::NotFinite { field, value } => {
                write!(f, "{field} is {}: it must be a finite number", shortest(*value))
            }
            SteerError::NotPositive { field, value } => {
                write!(f, "{field} is {}: it must be finite and greater than 0", shortest(*value))
            }
            SteerError::NoUp => write!(f, "the basis is set by hand: there is no up to change"),
            SteerError::Unsteady { turn } => write!(
                f,
                "rounded, eye, at and up would turn the camera by {turn:.1e} radians: move eye and at \
                 apart or nearer to the origin, or up away from the view direction"
            ),
        }
    }
}

impl std::error::Error for SteerError {}

impl From<CameraError> for SteerError {
    fn from(e: CameraError) -> Self {
        SteerError::Camera(e)
    }
}

impl From<BasisError> for SteerError {
    fn from(e: BasisError) -> Self {
        SteerError::Camera(e.into())
    }
}

impl From<ViewportError> for SteerError {
    fn from(e: ViewportError) -> Self {
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

/// A turn about an axis of length 1, right-handed: `x cos + (k x x) sin + k (k . x) (1 - cos)` (O.
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

    fn of(&self, x: DVec3) -> DVec3 {
        let across = self.axis.cross(x);
        x + self.sin * across + self.one_minus_cos * self.axis.cross(across)
    }

    fn of_frame(&self, Basis { u, v, w }: &Basis) -> Basis {
        Basis { u: self.of(*u), v: self.of(*v), w: self.of(*w) }
    }
}

/// The nearest basis with this w: unit and orthogonal but for one rounding of each coordinate.
fn orthonormal(basis: &Basis) -> Basis {
    let w = unit(basis.w);
    let u = unit(basis.v.cross(w));
    // Added to 0, a negative zero is 0, which readers expect to see.
    Basis { u: u + DVec3::ZERO, v: w.cross(u) + DVec3::ZERO, w: w + DVec3::ZERO }
}

/// The angle between two directions of length 1, accurate also where it is small.
pub(crate) fn angle_between(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// The camera, if its basis is this one but for rounding.
fn steady(camera: Camera, meant: &Basis) -> Result<Camera, SteerError> {
    let found = camera.basis()?;
    let turn = angle_between(found.v, meant.v).max(angle_between(found.w, meant.w));
    if turn <= ROUNDING_TURN { Ok(camera) } else { Err(SteerError::Unsteady { turn }) }
}
