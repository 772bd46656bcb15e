//! Turning the camera: round what it looks at, and on the spot.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::steered::{POLE_GAP, SteerError, Turn, check_finite, orthonormal, steady};
use crate::camera::basis::{Basis, BasisError};
use crate::camera::viewport::Viewport;
use crate::camera::{Camera, Orientation};
use crate::exact::double_double::difference_with_rest;
use crate::exact::scale::{ldexp, length, unit};

impl Camera {
    /// The point that [`Camera::orbited`] turns round: `at`; by view `eye + view`; by hand the middle
    /// of the viewport, `eye - distance*w`.
    ///
    /// # Errors
    /// Returns an error if the camera has no basis, by hand also where it has no viewport.
    pub fn pivot(&self) -> Result<DVec3, SteerError> {
        let w = self.basis()?.w;
        let (field, value) = match self.orientation {
            Orientation::At { at, .. } => ("at", at),
            Orientation::View { view, .. } => ("eye + view", self.eye + view),
            Orientation::Basis(_) => ("eye - distance*w", self.eye - self.reach()? * w),
        };
        if value.is_finite() {
            Ok(value)
        } else {
            Err(BasisError::NotFinite { field, value }.into())
        }
    }

    /// The camera orbiting round its [pivot](Camera::pivot), in radians: the basis turns as in
    /// [`Camera::looked_round`], and the eye with it, so that the pivot stays where it is in the
    /// picture. A positive yaw takes the eye to the camera's right, a positive pitch takes it down.
    ///
    /// ```text
    /// eye' = pivot + |eye - pivot| w'
    /// ```
    ///
    /// `at` stays to the bit, and so do up and the length of `view`. The distance from eye to pivot
    /// stays within 4 ulps, besides half an ulp in each of the eye's coordinates.
    ///
    /// # Errors
    /// As [`Camera::looked_round`], and where the eye's coordinates overflow.
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

    /// The camera looking round from where it stands, in radians: turned about up by yaw (positive:
    /// to the left, counter-clockwise as seen from the tip of up), and about u by pitch (positive:
    /// upwards).
    ///
    /// ```text
    /// (u', v', w') = R(up, yaw) R(u, pitch) (u, v, w)
    /// ```
    ///
    /// Eye and up stay to the bit, so the camera stays level; `at` keeps its distance, and `view` its
    /// length. The pitch stops [`POLE_GAP`] short of up and of -up; a camera that is nearer already may
    /// stay there or go away, but not nearer. v turns by at most `|yaw| + |pitch|`.
    ///
    /// A basis set by hand knows no level and no pole: it is turned as a frame, about the one axis
    /// `pitch*u + yaw*v`, by `sqrt(pitch^2 + yaw^2)`, and made orthonormal.
    ///
    /// Turned there and back, by `(yaw, pitch)` and `(-yaw, -pitch)`, the camera is as before but for
    /// rounding, unless the pitch was stopped.
    ///
    /// # Errors
    /// Returns an error if an angle is not finite, there is no basis, or rounding would turn it
    /// more than the hand ([`SteerError::Unsteady`]).
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

    /// Distance of the pivot from the eye.
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

    /// u, v, w after yaw and pitch; `None` where nothing turns.
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

    /// Returns as much of the pitch as leads no nearer to a pole than [`POLE_GAP`], or than the
    /// camera is.
    fn pitch_short_of_poles(&self, pitch: f64) -> Result<f64, SteerError> {
        let angle = self.up_angle()?.angle;
        let (nearest, farthest) = (angle.min(POLE_GAP), angle.max(PI - POLE_GAP));
        Ok(pitch.clamp(angle - farthest, angle - nearest))
    }
}

impl Viewport {
    /// Yaw and pitch by which [`Camera::looked_round`] takes the picture along when it is dragged from
    /// one (u, v) to another:
    ///
    /// ```text
    /// yaw = atan(u' / distance) - atan(u / distance)     pitch = atan(v / distance) - atan(v' / distance)
    /// ```
    ///
    /// What is taken stays under the pointer exactly on the picture's middle lines (of a camera that is
    /// level), and nearly elsewhere. Not finite where the viewport is none.
    pub fn look_of_drag(&self, from: DVec2, to: DVec2) -> (f64, f64) {
        let angle = |x: f64| x.atan2(self.distance);
        (angle(to.x) - angle(from.x), angle(from.y) - angle(to.y))
    }

    /// Yaw and pitch by which [`Camera::orbited`] follows a drag from one (u, v) to another: half a
    /// turn for the viewport's height, so that the near side of what is orbited goes with the hand. Not
    /// finite where the viewport is none.
    pub fn orbit_of_drag(&self, from: DVec2, to: DVec2) -> (f64, f64) {
        let share = (to - from) / self.height;
        (-PI * share.x, PI * share.y)
    }
}
