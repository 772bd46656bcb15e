//! Cameras that differ from a given one in a single parameter: rolled, with up tilted, with the same
//! picture at another distance.

use glam::DVec3;

use crate::camera::basis::{Basis, BasisError};
use crate::camera::viewport::{Viewport, ViewportError};
use crate::camera::{Camera, Orientation};
use crate::exact::scale::{ldexp3, length, split};
use crate::steering::steered::{SteerError, check_finite};

impl Camera {
    /// The camera rolled by an angle: up (by hand: u and v) turned about the view axis,
    /// counter-clockwise as the camera sees it, so that the picture turns clockwise.
    ///
    /// ```text
    /// up = s V + k W     becomes     s (cos V - sin U) + k W
    /// ```
    ///
    /// View and w stay to the bit; up's length and its angle to the view stay but for rounding, which
    /// turns the camera by at most 5e-16 times the [conditioning](crate::UpAngle). A whole number of turns
    /// changes nothing.
    ///
    /// # Errors
    /// Returns an error if the angle is not finite, or there is no basis before or (up within
    /// rounding of the view) after.
    pub fn swung(&self, degrees: f64) -> Result<Camera, SteerError> {
        let (sin, cos) = sin_cos_of_degrees(degrees)?;
        let basis = self.basis()?;
        let Basis { u, v, w } = basis;
        if cos == 1.0 {
            return Ok(*self);
        }
        if let Orientation::Basis(_) = self.orientation {
            let turned = Basis::by_hand(cos * u + sin * v, cos * v - sin * u, w)?;
            return Ok(Camera { orientation: Orientation::Basis(turned), ..*self });
        }
        self.with_up(|up| {
            let (across, along) = (up.dot(v), up.dot(w));
            across * (cos * v - sin * u) + along * w
        })
    }

    /// The camera with up turned towards the view, or away from it, until the angle between the two
    /// is this: up moves in the plane of both and keeps its length, so that u, v and w stay but for
    /// rounding, which turns them by at most 5e-16 times the [conditioning](crate::UpAngle).
    ///
    /// ```text
    /// up = |up| (sin(angle) V - cos(angle) W)
    /// ```
    ///
    /// # Errors
    /// Returns an error if the angle is not finite or not between 0 and 180 degrees (up would be
    /// parallel to the view at either), or so close to these that up is parallel once it is
    /// rounded; where there is no basis before, or one set by hand.
    pub fn up_tilted(&self, degrees: f64) -> Result<Camera, SteerError> {
        let (sin, cos) = sin_cos_of_degrees(degrees)?;
        let Basis { v, w, .. } = self.basis()?;
        if !(degrees > 0.0 && degrees < 180.0) {
            let up = (-w * cos) * length(self.up());
            return Err(BasisError::UpParallelToView { up, view: self.view() }.into());
        }
        self.with_up(|up| up.length() * (sin * v - cos * w))
    }

    /// The camera with its viewport at another distance, and width and height scaled with it: the
    /// same picture, but every t is divided by what distance is multiplied by.
    ///
    /// # Errors
    /// Returns an error if the viewport is none, before or after.
    pub fn scaled_picture(&self, distance: f64) -> Result<Camera, ViewportError> {
        let old = self.viewport;
        old.check()?;
        // x / old first: a width equal to the distance stays so, to the bit.
        let scaled = |x: f64| {
            let ratio = x / old.distance;
            if ratio.is_normal() { ratio * distance } else { x * (distance / old.distance) }
        };
        let viewport = Viewport { width: scaled(old.width), height: scaled(old.height), distance };
        viewport.check()?;
        Ok(Camera { viewport, ..*self })
    }

    /// The camera with its picture scaled so that the measure of its viewport that is not the same in
    /// `edited` and `before` becomes the edited one; see [`Camera::scaled_picture`]. Of several, it is
    /// the distance, or else the width.
    ///
    /// # Errors
    /// Returns an error if the viewport is none, before or after.
    pub fn picture_scaled_as(
        &self,
        before: &Viewport,
        edited: &Viewport,
    ) -> Result<Camera, ViewportError> {
        let Viewport { width, height, distance } = self.viewport;
        self.scaled_picture(if edited.distance != before.distance {
            edited.distance
        } else if edited.width != before.width {
            distance * (edited.width / width)
        } else {
            distance * (edited.height / height)
        })
    }

    /// The camera with up changed; the change is made at about length 1, so that nothing overflows.
    fn with_up(&self, change: impl Fn(DVec3) -> DVec3) -> Result<Camera, SteerError> {
        let changed = |up: DVec3| {
            let (up, k) = split(up);
            // Added to 0, a negative zero is 0.
            ldexp3(change(up), k) + DVec3::ZERO
        };
        let orientation = match self.orientation {
            Orientation::At { at, up } => Orientation::At { at, up: changed(up) },
            Orientation::View { view, up } => Orientation::View { view, up: changed(up) },
            Orientation::Basis(_) => return Err(SteerError::NoUp),
        };
        let camera = Camera { orientation, ..*self };
        camera.basis()?;
        Ok(camera)
    }
}

/// Sine and cosine of an angle in degrees, exact at whole quarters of a turn.
fn sin_cos_of_degrees(degrees: f64) -> Result<(f64, f64), SteerError> {
    check_finite("the angle", degrees)?;
    // To the nearest quarter: the rest is exact.
    let turn = degrees % 360.0;
    let quarters = (turn / 90.0).round();
    let (sin, cos) = (turn - 90.0 * quarters).to_radians().sin_cos();
    Ok(match quarters.rem_euclid(4.0) {
        0.0 => (sin, cos),
        1.0 => (cos, -sin),
        2.0 => (-sin, -cos),
        _ => (-cos, sin),
    })
}
