//! The camera as it is given and edited, before it is checked.

pub(crate) mod basis;
pub(crate) mod difference;
pub(crate) mod fine_basis;
pub(crate) mod ray;
pub(crate) mod resolved;
pub(crate) mod selection;
pub(crate) mod viewport;

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use thiserror::Error;

use crate::camera::basis::{Basis, BasisError, UpAngle};
use crate::camera::fine_basis::{Aim, FineBasis, angle_terms};
use crate::camera::resolved::ResolvedCamera;
use crate::camera::viewport::{ImageError, ImageSize, Viewport, ViewportError};
use crate::exact::double_double::difference_with_rest;
use crate::exact::scale::unit;

/// The camera's view direction and up, given in one of three ways.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Orientation {
    /// The camera looks at the point `at` and is held level by `up`.
    At {
        /// The point in the middle of the image.
        at: DVec3,
        /// The vector that keeps the camera level. It need not be at right angles to the view, as v is.
        up: DVec3,
    },
    /// The camera looks along `view` and is held level by `up`.
    View {
        /// The view direction, of any length.
        view: DVec3,
        /// The vector that keeps the camera level. It need not be at right angles to the view, as v is.
        up: DVec3,
    },
    /// The vectors u, v, w, set by hand and used unchanged.
    Basis(Basis),
}

/// The ways to give an [`Orientation`], without the values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum OrientationKind {
    /// A point to look at, and up.
    At,
    /// A direction to look along, and up.
    View,
    /// The vectors u, v, w.
    Basis,
}

/// A camera as it is given. Both the camera that is edited and the observer, from which the world around
/// that camera is shown, have this type.
///
/// The fields may have any values while they are edited; [`Camera::resolve`] checks them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The origin of every view ray.
    pub eye: DVec3,
    /// The direction in which the camera looks, and its up.
    pub orientation: Orientation,
    /// Width, height and distance of the viewport.
    pub viewport: Viewport,
    /// Width and height of the image, in pixels.
    pub image: ImageSize,
}

/// The reason why a camera cannot be resolved.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CameraError {
    /// The camera has no basis.
    #[error(transparent)]
    Basis(#[from] BasisError),
    /// The viewport's width, height or distance is not positive and finite.
    #[error(transparent)]
    Viewport(#[from] ViewportError),
    /// The image has no pixels, or too many.
    #[error(transparent)]
    Image(#[from] ImageError),
}

impl Default for Camera {
    fn default() -> Camera {
        Camera::CANONICAL
    }
}

impl Camera {
    /// The lecture's canonical camera: eye at the origin, looking along -z, viewport 1 x 1 at
    /// distance 1, 400 x 400 pixels.
    pub const CANONICAL: Camera = Camera {
        eye: DVec3::ZERO,
        orientation: Orientation::At { at: DVec3::NEG_Z, up: DVec3::Y },
        viewport: Viewport::CANONICAL,
        image: match ImageSize::new(400, 400) {
            Ok(size) => size,
            Err(_) => unreachable!(),
        },
    };

    /// Returns the camera's basis.
    ///
    /// # Errors
    /// Returns an error if the camera has no basis, see [`BasisError`].
    pub fn basis(&self) -> Result<Basis, BasisError> {
        Ok(self.aim()?.1.rounded())
    }

    /// Returns the view direction and up (`None` if the basis is given by hand), and the basis in
    /// double-double.
    fn aim(&self) -> Result<(Option<Aim>, FineBasis), BasisError> {
        if !self.eye.is_finite() {
            return Err(BasisError::NotFinite { field: "eye", value: self.eye });
        }
        let aim = match self.orientation {
            Orientation::At { at, up } => Aim::from_to(self.eye, at, up)?,
            Orientation::View { view, up } => Aim::along(view, up)?,
            Orientation::Basis(Basis { u, v, w }) => {
                return Ok((None, FineBasis::given(&Basis::by_hand(u, v, w)?)));
            }
        };
        Ok((Some(aim), aim.fine_basis()?))
    }

    /// Returns the angle between up and the view direction, `atan2(|up x view|, up . view)`, which
    /// unlike the arc cosine is accurate near 0 and pi; and the conditioning
    /// `|up| |view| / |up x view|`, capped at `f64::MAX`. The up of a basis given by hand is v, so the
    /// angle is a right angle and the conditioning is 1.
    ///
    /// # Errors
    /// Returns an error if the camera has no basis.
    pub fn up_angle(&self) -> Result<UpAngle, BasisError> {
        let (Some(Aim { view, up }), _) = self.aim()? else {
            return Ok(UpAngle { angle: FRAC_PI_2, conditioning: 1.0 });
        };
        let (right, along, lengths) = angle_terms(&view, up);
        let conditioning = (lengths / right).min(f64::MAX);
        Ok(UpAngle { angle: right.atan2(along), conditioning })
    }

    /// Returns the view direction as given: `view`, `at - eye` (a quarter of it if it would overflow),
    /// or `-w`.
    pub fn view(&self) -> DVec3 {
        match self.orientation {
            Orientation::At { at, .. } => difference_with_rest(at, self.eye).0,
            Orientation::View { view, .. } => view,
            Orientation::Basis(basis) => -basis.w,
        }
    }

    /// Returns the up vector as given; v for a basis given by hand.
    pub fn up(&self) -> DVec3 {
        match self.orientation {
            Orientation::At { up, .. } | Orientation::View { up, .. } => up,
            Orientation::Basis(basis) => basis.v,
        }
    }

    /// Checks the camera, and returns it with its basis, ready for view rays.
    ///
    /// # Errors
    /// Returns an error if the camera has no basis or its viewport is not a rectangle in front of the
    /// eye.
    pub fn resolve(&self) -> Result<ResolvedCamera, CameraError> {
        let (aim, basis) = self.aim()?;
        self.viewport.check()?;
        Ok(ResolvedCamera::new(self.eye, aim, basis, self.viewport, self.image))
    }

    /// Returns the same camera with its orientation given in the form `kind`: by at, by view, or by a
    /// basis.
    ///
    /// The eye and up are kept; the up of a basis is v. The new `at` is `eye + view`, or `eye - w` for a
    /// basis. If rounding that sum would change the direction (for example, with the eye at 1e12), `at`
    /// is the nearest of `eye + 2 view`, `eye + 4 view`, ... that keeps it. The direction changes by at
    /// most [`Camera::TURN_TOLERANCE`] in each coordinate, and the basis by at most that times the
    /// [conditioning](UpAngle::conditioning).
    ///
    /// A camera without a basis is converted, too; the result has no basis, either.
    ///
    /// # Errors
    /// Returns an error if a camera without a basis is converted to a basis, or if the eye is so far
    /// from the origin that no point in the direction of the view can be distinguished from it.
    pub fn given_by(&self, kind: OrientationKind) -> Result<Camera, BasisError> {
        let orientation = match (kind, self.orientation) {
            (kind, orientation) if kind == orientation.kind() => orientation,
            (OrientationKind::At, _) => {
                Orientation::At { at: point_ahead(self.eye, self.view())?, up: self.up() }
            }
            (OrientationKind::View, _) => Orientation::View { view: self.view(), up: self.up() },
            (OrientationKind::Basis, _) => Orientation::Basis(self.basis()?),
        };
        Ok(Camera { orientation, ..*self })
    }

    /// Maximum change of the view direction by [`Camera::given_by`], in each coordinate of the unit
    /// vector: 4 times the spacing of `f64` at 1.
    pub const TURN_TOLERANCE: f64 = 4.0 * f64::EPSILON;
}

/// Returns `eye + 2^k view` with the smallest `k >= 0` at which rounding turns the direction by no
/// more than [`Camera::TURN_TOLERANCE`].
fn point_ahead(eye: DVec3, view: DVec3) -> Result<DVec3, BasisError> {
    let has_direction = |v: DVec3| v.is_finite() && v != DVec3::ZERO;
    if !(has_direction(view) && eye.is_finite()) {
        return Ok(eye + view);
    }
    let direction = unit(view);
    let mut reach = view;
    while reach.is_finite() {
        let at = eye + reach;
        let seen = difference_with_rest(at, eye).0;
        if has_direction(seen)
            && (unit(seen) - direction).abs().max_element() <= Camera::TURN_TOLERANCE
        {
            return Ok(at);
        }
        reach *= 2.0;
    }
    Err(BasisError::EyeIsAt { point: eye })
}

impl Orientation {
    /// Returns whether the camera looks at a point, so that `at` is one of its inputs.
    #[must_use]
    pub fn has_at(&self) -> bool {
        matches!(self, Orientation::At { .. })
    }

    /// Returns whether up is one of the inputs: true unless the basis is set by hand.
    #[must_use]
    pub fn has_up(&self) -> bool {
        !matches!(self, Orientation::Basis(_))
    }

    /// Returns the way in which the orientation is given.
    pub fn kind(&self) -> OrientationKind {
        match self {
            Orientation::At { .. } => OrientationKind::At,
            Orientation::View { .. } => OrientationKind::View,
            Orientation::Basis(_) => OrientationKind::Basis,
        }
    }
}
