//! Moving the camera along its view, and opening and closing its field of view.

use super::steered::{SteerError, check_finite, check_positive, steady};
use crate::camera::basis::BasisError;
use crate::camera::viewport::Viewport;
use crate::camera::{Camera, Orientation};

impl Camera {
    /// The eye moved along w: forwards, towards what the camera looks at, by so many lengths of the way
    /// to its [pivot](Camera::pivot); negative: backwards. The basis stays.
    ///
    /// ```text
    /// by at:            eye' = at + e^(-forward) (eye - at)       at stays and is never reached
    /// by view, by hand: eye' = eye - forward |pivot - eye| w      the pivot moves along
    /// ```
    ///
    /// A small step is the same in all three. Steps add up: forward by a and by b is forward by a + b,
    /// and there and back again is where it began, but for rounding.
    ///
    /// # Errors
    /// Returns an error if `forward` is not finite, there is no basis, the eye overflows or has
    /// come so close to `at` that rounding makes them the same point or turns the view
    /// ([`SteerError::Unsteady`]).
    pub fn dollied(&self, forward: f64) -> Result<Camera, SteerError> {
        check_finite("forward", forward)?;
        let basis = self.basis()?;
        if forward == 0.0 {
            return Ok(*self);
        }
        let reach = self.reach()?;
        let eye = match self.orientation {
            Orientation::At { at, .. } => at + (-forward).exp() * reach * basis.w,
            Orientation::View { .. } | Orientation::Basis(_) => {
                self.eye - forward * reach * basis.w
            }
        };
        if !eye.is_finite() {
            return Err(BasisError::NotFinite { field: "eye", value: eye }.into());
        }
        steady(Camera { eye, ..*self }, &basis)
    }

    /// The viewport's width and height times a factor at the same distance: the field of view opens
    /// (factor above 1) or closes, and neither eye nor basis change. Zoomed by f and by 1/f, the
    /// viewport is as before but for rounding.
    ///
    /// # Errors
    /// Returns an error if the factor is not positive and finite, or the viewport is none, before
    /// or after.
    pub fn zoomed(&self, factor: f64) -> Result<Camera, SteerError> {
        check_positive("factor", factor)?;
        let Viewport { width, height, distance } = self.viewport;
        self.viewport.check()?;
        let viewport = Viewport { width: factor * width, height: factor * height, distance };
        viewport.check()?;
        Ok(Camera { viewport, ..*self })
    }
}
