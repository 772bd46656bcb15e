//! Eye and at put to a point of the world.

use glam::DVec3;

use super::pole::{frame_carried, up_carried};
use super::steered::{SteerError, Steered, orthonormal, steady};
use crate::camera::basis::{Basis, BasisError};
use crate::camera::fine_basis::Aim;
use crate::camera::{Camera, Orientation};
use crate::exact::double_double::difference_with_rest;
use crate::exact::scale::{ldexp3, split, unit};

/// The quantity that stays fixed when the eye is moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Keep {
    /// The point it looks at, the [pivot](Camera::pivot): the view turns.
    At,
    /// The view direction: at moves along, the camera travels.
    View,
}

impl Keep {
    /// The other one.
    #[must_use]
    pub fn other(self) -> Keep {
        match self {
            Keep::At => Keep::View,
            Keep::View => Keep::At,
        }
    }
}

impl Camera {
    /// The camera with its eye at a point of the world.
    ///
    /// With [`Keep::At`] the pivot stays and the view turns, the short way; by view, its length becomes
    /// that from the eye to the pivot; a basis set by hand turns by the least turn that aims it at the
    /// pivot. With [`Keep::View`] the basis stays, and `at` keeps its position before the eye.
    ///
    /// A camera without a basis is led out of that: its fields are set and nothing else.
    ///
    /// # Errors
    /// Returns an error if there is no basis afterwards (the eye is put to the pivot), or rounding
    /// would turn it ([`SteerError::Unsteady`]).
    pub fn with_eye_at(&self, point: DVec3, keep: Keep) -> Result<Steered, SteerError> {
        check_point("eye", point)?;
        let moved = Camera { eye: point, ..*self };
        if keep == Keep::View {
            return self.travelled_to(point);
        }
        match self.orientation {
            Orientation::At { .. } => self.led_to(moved),
            Orientation::View { view, up } => {
                let orientation = Orientation::View { view: view + (self.eye - point), up };
                self.led_to(Camera { orientation, ..moved })
            }
            Orientation::Basis(basis) => {
                let view = (self.eye - point) - self.reach()? * basis.w;
                self.frame_led_to(moved, &basis, view)
            }
        }
    }

    /// The camera that looks at a point of the world from where it stands: `at`, or by view
    /// `view = point - eye`; a basis set by hand turns by the least turn that aims it there.
    ///
    /// A camera without a basis is led out of that: its fields are set and nothing else.
    ///
    /// # Errors
    /// Returns an error if the point is the eye, or there is no basis.
    pub fn with_at(&self, point: DVec3) -> Result<Steered, SteerError> {
        check_point("at", point)?;
        let view = difference_with_rest(point, self.eye).0;
        let orientation = match self.orientation {
            Orientation::At { up, .. } => Orientation::At { at: point, up },
            Orientation::View { up, .. } => Orientation::View { view, up },
            Orientation::Basis(basis) if view == DVec3::ZERO => {
                Basis::by_hand(basis.u, basis.v, basis.w)?;
                return Err(BasisError::EyeIsAt { point }.into());
            }
            Orientation::Basis(basis) => return self.frame_led_to(*self, &basis, view),
        };
        self.led_to(Camera { orientation, ..*self })
    }

    /// Eye and at moved together.
    fn travelled_to(&self, eye: DVec3) -> Result<Steered, SteerError> {
        let orientation = match self.orientation {
            Orientation::At { at, up } if eye != self.eye => {
                Orientation::At { at: at + (eye - self.eye), up }
            }
            given => given,
        };
        let moved = Camera { eye, orientation, ..*self };
        let camera = match self.basis() {
            Ok(basis) => steady(moved, &basis)?,
            Err(_) => moved.basis().map(|_| moved)?,
        };
        Ok(Steered { camera, up_went_along: false })
    }

    /// The camera after eye, at or view have been set by hand, up as it was: it goes along where the
    /// view comes near it.
    fn led_to(&self, moved: Camera) -> Result<Steered, SteerError> {
        let stays = |camera: Camera| Steered { camera, up_went_along: false };
        let (aim, up) = match moved.orientation {
            Orientation::At { at, up } => (Aim::from_to(moved.eye, at, up)?, up),
            Orientation::View { view, up } => (Aim::along(view, up)?, up),
            Orientation::Basis(_) => return Ok(stays(moved)),
        };
        let Ok(basis) = self.basis() else {
            moved.basis()?;
            return Ok(stays(moved));
        };
        if moved == *self {
            return Ok(stays(moved));
        }
        let to = unit(aim.view.rounded());
        let Some((direction, v)) = up_carried(&basis, self.up_angle()?.angle, to) else {
            moved.basis()?;
            return Ok(stays(moved));
        };
        let (m, k) = split(up);
        let up = ldexp3(m.length() * unit(direction), k);
        let orientation = match moved.orientation {
            Orientation::At { at, .. } => Orientation::At { at, up },
            _ => Orientation::View { view: moved.view(), up },
        };
        let meant = Basis { u: to.cross(v), v, w: -to };
        let camera = steady(Camera { orientation, ..moved }, &meant)?;
        Ok(Steered { camera, up_went_along: true })
    }

    /// The camera with a basis set by hand turned to look along `view`.
    fn frame_led_to(
        &self,
        moved: Camera,
        basis: &Basis,
        view: DVec3,
    ) -> Result<Steered, SteerError> {
        let basis = Basis::by_hand(basis.u, basis.v, basis.w)?;
        if !view.is_finite() {
            return Err(BasisError::NotFinite { field: "view", value: view }.into());
        }
        if view == DVec3::ZERO {
            return Err(BasisError::EyeIsAt { point: moved.eye }.into());
        }
        let straight = orthonormal(&basis);
        let turned = orthonormal(&frame_carried(&straight, unit(view)));
        let camera = Camera { orientation: Orientation::Basis(turned), ..moved };
        camera.basis()?;
        Ok(Steered { camera, up_went_along: false })
    }
}

fn check_point(field: &'static str, value: DVec3) -> Result<(), SteerError> {
    match value.is_finite() {
        true => Ok(()),
        false => Err(BasisError::NotFinite { field, value }.into()),
    }
}
