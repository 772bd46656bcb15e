//! The difference between two cameras: the vector between their eyes, the turn and roll from one to the
//! other, and the differences between their viewports.

use glam::DVec3;

use crate::camera::basis::{Basis, BasisError};
use crate::camera::{Camera, Orientation};
use crate::exact::scale::{angle_between, unit};

/// The difference between a camera and another one. Lengths are in world units, angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct CameraDifference {
    /// Vector from the other camera's eye to this camera's eye.
    pub eye: DVec3,
    /// Vector from the other camera's at to this camera's at; `None` unless both cameras have one.
    pub at: Option<DVec3>,
    /// Angle between the two cameras' up vectors.
    pub up: f64,
    /// Angles between the two cameras' u, between their v, and between their w.
    pub basis: [f64; 3],
    /// Angle of the rotation about a single axis that takes one basis to the other (L. Euler 1775).
    pub turn: f64,
    /// The roll of this camera about its view ([`Camera::swung`]), in (-180, 180], relative to a camera
    /// that looks in the same direction but is held level by the other camera's up. `None` if the other
    /// camera's up is parallel to this view.
    pub roll: Option<f64>,
    /// This viewport's distance minus the other's.
    pub distance: f64,
    /// This viewport's width and height minus the other's.
    pub extent: [f64; 2],
}

impl Camera {
    /// Returns the difference between this camera and another one.
    ///
    /// ```text
    /// turn = atan2(|u' x u + v' x v + w' x w|, u' . u + v' . v + w' . w - 1)
    /// roll = atan2(-v . u'', v . v'')
    /// ```
    ///
    /// u, v, w are this camera's basis, u', v', w' the other camera's. u'' and v'' belong to a camera
    /// that looks along this camera's view and is held level by the other camera's up. The arguments of
    /// the first `atan2` are `2 sin(turn)` and `2 cos(turn)`, taken from the rotation's matrix. They are
    /// accurate even for small turns and for turns near 180 degrees.
    ///
    /// # Errors
    /// Returns an error if either camera has no basis.
    pub fn difference_from(&self, other: &Camera) -> Result<CameraDifference, BasisError> {
        let (here, there) = (self.basis()?, other.basis()?);
        let pairs = [(here.u, there.u), (here.v, there.v), (here.w, there.w)];
        let sin: DVec3 = pairs.iter().map(|(a, b)| b.cross(*a)).sum();
        let cos = pairs.iter().map(|(a, b)| b.dot(*a)).sum::<f64>() - 1.0;
        let at = match (self.orientation, other.orientation) {
            (Orientation::At { at, .. }, Orientation::At { at: from, .. }) => Some(at - from),
            _ => None,
        };
        let level = Basis::from_view_up(-here.w, other.up()).ok();
        let (now, then) = (self.viewport, other.viewport);
        Ok(CameraDifference {
            eye: self.eye - other.eye,
            at,
            up: angle_between(unit(self.up()), unit(other.up())).to_degrees(),
            basis: pairs.map(|(a, b)| angle_between(a, b).to_degrees()),
            turn: sin.length().atan2(cos).to_degrees(),
            roll: level
                .map(|level| (-here.v.dot(level.u)).atan2(here.v.dot(level.v)).to_degrees() + 0.0),
            distance: now.distance - then.distance,
            extent: [now.width - then.width, now.height - then.height],
        })
    }
}
