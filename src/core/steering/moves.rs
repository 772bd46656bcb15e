//! Turns a camera around its pivot or on the spot, and changes single parameters: the field of view, the
//! roll, up, or the distance of the viewport, with an unchanged picture.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use crate::camera::basis::{Basis, BasisError};
use crate::camera::viewport::{Viewport, ViewportError};
use crate::camera::{Camera, Orientation};
use crate::exact::double_double::difference_with_rest;
use crate::exact::scale::{ldexp, ldexp3, length, split, unit};
use crate::steering::{
    POLE_GAP, SteerError, Turn, check_finite, check_positive, orthonormal, steady,
};

impl Camera {
    /// Returns the camera with its viewport's width and height multiplied by a factor, at the same
    /// distance: the field of view becomes wider (factor above 1) or narrower, and eye and basis stay.
    /// Apart from rounding, zooming by f and then by 1/f restores the viewport.
    ///
    /// # Errors
    /// Returns an error if the factor is not positive and finite, or if the old or the new viewport is
    /// invalid.
    pub fn zoomed(&self, factor: f64) -> Result<Camera, SteerError> {
        check_positive("factor", factor)?;
        let Viewport { width, height, distance } = self.viewport;
        self.viewport.check()?;
        let viewport = Viewport { width: factor * width, height: factor * height, distance };
        viewport.check()?;
        Ok(Camera { viewport, ..*self })
    }

    /// Returns the camera after it has orbited around its pivot, by angles in radians. The pivot is `at`
    /// for a camera given by at; `eye + view` for one given by view; the middle of the viewport, `eye -
    /// distance*w`, for a basis set by hand.
    ///
    /// The basis turns as in [`Camera::looked_round`], and the eye moves with it, so that the pivot
    /// stays where it is in the picture. A positive yaw moves the eye to the camera's right, a positive
    /// pitch moves it down.
    ///
    /// ```text
    /// eye' = pivot + |eye - pivot| w'
    /// ```
    ///
    /// `at`, up and the length of `view` stay bit for bit the same. The distance from eye to pivot
    /// changes by at most 4 ulps, in addition to half an ulp in each of the eye's coordinates.
    ///
    /// # Errors
    /// Returns the errors of [`Camera::looked_round`], and an error if the eye's coordinates overflow.
    pub fn orbited(&self, yaw: f64, pitch: f64) -> Result<Camera, SteerError> {
        let Some(turned) = self.turned(yaw, pitch)? else {
            return Ok(*self);
        };
        let reach = self.reach()?;
        let (eye, orientation) = match self.orientation {
            Orientation::At { at, up } => (at + reach * turned.w, Orientation::At { at, up }),
            Orientation::View { view, up } => {
                let to_pivot = -reach * turned.w;
                (self.eye + (view - to_pivot), Orientation::View { view: to_pivot, up })
            }
            Orientation::Basis(old) => {
                (self.eye + reach * (turned.w - old.w), Orientation::Basis(turned))
            }
        };
        steady(Camera { eye, orientation, ..*self }, &turned)
    }

    /// Returns the camera turned on the spot, by angles in radians: about up by yaw (positive: to the left,
    /// counter-clockwise as seen from the tip of up), and about u by pitch (positive: upwards).
    ///
    /// ```text
    /// (u', v', w') = R(up, yaw) R(u, pitch) (u, v, w)
    /// ```
    ///
    /// Eye and up stay bit for bit the same, so the camera stays level; `at` keeps its distance, and
    /// `view` its length. The pitch stops [`POLE_GAP`] short of up and of -up. A camera that is already
    /// nearer may move away, but not come nearer. v turns by at most `|yaw| + |pitch|`.
    ///
    /// A basis set by hand has no up to keep level and no poles: it is turned as a whole about the axis
    /// `pitch*u + yaw*v`, by `sqrt(pitch^2 + yaw^2)`, and made orthonormal.
    ///
    /// Turning by `(yaw, pitch)` and then by `(-yaw, -pitch)` restores the camera, apart from rounding,
    /// unless the pitch was stopped.
    ///
    /// # Errors
    /// Returns an error if an angle is not finite, if there is no basis, or if rounding would turn the
    /// camera further by more than `ROUNDING_TURN` ([`SteerError::Unsteady`]).
    pub fn looked_round(&self, yaw: f64, pitch: f64) -> Result<Camera, SteerError> {
        let Some(turned) = self.turned(yaw, pitch)? else {
            return Ok(*self);
        };
        let ahead = || Ok::<_, SteerError>(-self.reach()? * turned.w);
        let orientation = match self.orientation {
            Orientation::At { up, .. } => Orientation::At { at: self.eye + ahead()?, up },
            Orientation::View { up, .. } => Orientation::View { view: ahead()?, up },
            Orientation::Basis(_) => Orientation::Basis(turned),
        };
        steady(Camera { orientation, ..*self }, &turned)
    }

    /// Returns the distance from the eye to the pivot.
    pub(super) fn reach(&self) -> Result<f64, SteerError> {
        let (field, value, reach) = match self.orientation {
            Orientation::At { at, .. } => {
                let (view, _, k) = difference_with_rest(at, self.eye);
                ("at - eye", at - self.eye, ldexp(length(view), k))
            }
            Orientation::View { view, .. } => ("view", view, length(view)),
            Orientation::Basis(_) => {
                self.viewport.check()?;
                return Ok(self.viewport.distance);
            }
        };
        if reach.is_finite() {
            Ok(reach)
        } else {
            Err(BasisError::NotFinite { field, value }.into())
        }
    }

    /// Returns u, v, w after yaw and the limited pitch; `None` if both are 0.
    fn turned(&self, yaw: f64, pitch: f64) -> Result<Option<Basis>, SteerError> {
        check_finite("yaw", yaw)?;
        check_finite("pitch", pitch)?;
        let basis = self.basis()?;
        if let Orientation::Basis(_) = self.orientation {
            let angle = yaw.hypot(pitch);
            check_finite("sqrt(pitch^2 + yaw^2)", angle)?;
            if angle == 0.0 {
                return Ok(None);
            }
            let straight = orthonormal(&basis);
            let axis = unit(pitch / angle * straight.u + yaw / angle * straight.v);
            return Ok(Some(orthonormal(&Turn::about(axis, angle).turned_frame(&straight))));
        }
        let pitch = self.pitch_short_of_poles(pitch)?;
        if yaw == 0.0 && pitch == 0.0 {
            return Ok(None);
        }
        let pitched = Turn::about(basis.u, pitch).turned_frame(&basis);
        Ok(Some(orthonormal(&Turn::about(unit(self.up()), yaw).turned_frame(&pitched))))
    }

    /// Returns the pitch, limited so that the view comes no nearer to a pole than [`POLE_GAP`] or, if it
    /// is already nearer, not any nearer.
    fn pitch_short_of_poles(&self, pitch: f64) -> Result<f64, SteerError> {
        let angle = self.up_angle()?.angle;
        let (nearest, farthest) = (angle.min(POLE_GAP), angle.max(PI - POLE_GAP));
        Ok(pitch.clamp(angle - farthest, angle - nearest))
    }

    /// Returns the camera rolled by an angle: up (or, for a basis set by hand, u and v) turns about the
    /// view axis, counter-clockwise as the camera sees it, so that the picture turns clockwise.
    ///
    /// ```text
    /// up = s V + k W     becomes     s (cos V - sin U) + k W
    /// ```
    ///
    /// Here s and k are the components of up along the vectors V and W, and the angle is that of the
    /// roll. View and w stay bit for bit the same. Up's length and its angle to the view stay, apart
    /// from rounding, which turns the camera by at most 5e-16 times the [conditioning](crate::UpAngle).
    /// A whole number of turns changes nothing.
    ///
    /// # Errors
    /// Returns an error if the angle is not finite, if there is no basis, or if there would be none
    /// afterwards because the rounded up would be parallel to the view.
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

    /// Returns the camera with up turned towards the view, or away from it, until the angle between them
    /// is `degrees`. Up moves in the plane of up and view and keeps its length. So u, v and w stay,
    /// apart from rounding, which turns them by at most 5e-16 times the [conditioning](crate::UpAngle).
    ///
    /// ```text
    /// up = |up| (sin(angle) V - cos(angle) W)
    /// ```
    ///
    /// # Errors
    /// Returns an error if there is no basis, or if the basis is set by hand. Returns an error if the
    /// angle is not finite or not between 0 and 180 degrees (at either of which up would be parallel to
    /// the view), or is so close to 0 or 180 that the rounded up is parallel to the view.
    pub fn up_tilted(&self, degrees: f64) -> Result<Camera, SteerError> {
        let (sin, cos) = sin_cos_of_degrees(degrees)?;
        let Basis { v, w, .. } = self.basis()?;
        if !(degrees > 0.0 && degrees < 180.0) {
            let up = (-w * cos) * length(self.up());
            return Err(BasisError::UpParallelToView { up, view: self.view() }.into());
        }
        self.with_up(|up| up.length() * (sin * v - cos * w))
    }

    /// Returns the camera with its viewport at another distance, and the viewport's width and height
    /// scaled by the same factor. The picture stays the same, but every t is divided by the factor.
    ///
    /// # Errors
    /// Returns an error if the old or the new viewport is invalid.
    pub fn scaled_picture(&self, distance: f64) -> Result<Camera, ViewportError> {
        let old = self.viewport;
        old.check()?;
        // x / old is computed first, so that a width equal to the distance stays exactly equal to it.
        let scaled = |x: f64| {
            let ratio = x / old.distance;
            if ratio.is_normal() { ratio * distance } else { x * (distance / old.distance) }
        };
        let viewport = Viewport { width: scaled(old.width), height: scaled(old.height), distance };
        viewport.check()?;
        Ok(Camera { viewport, ..*self })
    }

    /// Returns the camera with its viewport scaled by [`Camera::scaled_picture`], so that the width,
    /// height or distance in which `edited` differs from `before` gets its value in `edited`. If several
    /// of them differ, the distance takes precedence, then the width.
    ///
    /// # Errors
    /// Returns an error if the old or the new viewport is invalid.
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

    /// Returns the camera with up replaced by `change(up)`. `change` is applied to up scaled to a length
    /// of about 1, so that nothing overflows.
    fn with_up(&self, change: impl Fn(DVec3) -> DVec3) -> Result<Camera, SteerError> {
        let changed = |up: DVec3| {
            let (up, k) = split(up);
            // Adding 0 turns a negative zero into 0.
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

impl Viewport {
    /// Returns the yaw and pitch with which [`Camera::looked_round`] makes the picture follow a drag
    /// from (u, v) to (u', v'):
    ///
    /// ```text
    /// yaw = atan(u' / distance) - atan(u / distance)     pitch = atan(v / distance) - atan(v' / distance)
    /// ```
    ///
    /// If the camera is level, the dragged point stays exactly under the pointer on the picture's middle
    /// row and middle column, and nearly so elsewhere. The angles are not finite if the viewport is
    /// invalid.
    pub fn look_of_drag(&self, from: DVec2, to: DVec2) -> (f64, f64) {
        let angle = |x: f64| x.atan2(self.distance);
        (angle(to.x) - angle(from.x), angle(from.y) - angle(to.y))
    }

    /// Returns the yaw and pitch with which [`Camera::orbited`] follows a drag from one (u, v) to
    /// another: a drag over the viewport's height is half a turn, so that the near side of the orbited
    /// objects follows the pointer. The angles are not finite if the viewport is invalid.
    pub fn orbit_of_drag(&self, from: DVec2, to: DVec2) -> (f64, f64) {
        let share = (to - from) / self.height;
        (-PI * share.x, PI * share.y)
    }
}

/// Returns the sine and cosine of an angle in degrees. They are exact for multiples of 90 degrees.
fn sin_cos_of_degrees(degrees: f64) -> Result<(f64, f64), SteerError> {
    check_finite("the angle", degrees)?;
    // The angle is reduced by the nearest quarter turn; the remainder is exact.
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
