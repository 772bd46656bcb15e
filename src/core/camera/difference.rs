//! The difference between two cameras: the distance of their eyes, the turn and roll from one to the other,
//! and the differences of their viewports.

use glam::DVec3;

use crate::camera::basis::{Basis, BasisError};
use crate::camera::{Camera, Orientation};
use crate::exact::scale::{angle_between, unit};

/// The difference of one camera from another; lengths are in world units, angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct CameraDifference {
    /// Vector from the other camera's eye to this camera's eye.
    pub eye: DVec3,
    /// Vector from the other camera's at to this camera's at; `None` unless both cameras have one.
    pub at: Option<DVec3>,
    /// Angle between the ups of the two cameras.
    pub up: f64,
    /// Angles between the two cameras' u, v and w.
    pub basis: [f64; 3],
    /// Angle of the rotation about a single axis that takes one basis to the other (L. Euler 1775).
    pub turn: f64,
    /// Angle, in (-180, 180], by which this camera is rolled about its view, as by [`Camera::swung`],
    /// from the camera that looks the same way and is held level by the other's up. `None` where the
    /// other's up is parallel to this view.
    pub roll: Option<f64>,
    /// This viewport's distance minus the other's.
    pub distance: f64,
    /// This viewport's width and height minus the other's.
    pub extent: [f64; 2],
}

impl Camera {
    /// Returns the difference of this camera from another one.
    ///
    /// ```text
    /// turn = atan2(|u' x u + v' x v + w' x w|, u' . u + v' . v + w' . w - 1)
    /// roll = atan2(-v . u'', v . v'')       u'', v'': this view with the other's up
    /// ```
    ///
    /// The arguments of the first `atan2` are `2 sin(turn)` and `2 cos(turn)` of the rotation's matrix,
    /// which keep the digits of small turns and of turns near 180 degrees.
    ///
    /// # Errors
    /// Returns an error if one of the two has no basis.
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
