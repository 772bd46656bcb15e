//! Eye and axes of a camera as another program gives them, and mirrored worlds.

use pinhole_core::{Basis, DVec3, ORTHONORMAL_TOLERANCE, Orientation};

use super::affine::Affine;
use super::text::n;
use super::viewport::settled;

/// A camera's eye and axes as read: right, up and backwards of any length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pose {
    pub(crate) eye: DVec3,
    pub(crate) right: DVec3,
    pub(crate) up: DVec3,
    pub(crate) backwards: DVec3,
}

impl Pose {
    /// Returns the pose of a camera that looks along its own -z with y up, by its frame in the world.
    pub(crate) fn from_frame(frame: &Affine) -> Pose {
        Pose { eye: frame.at, right: frame.x, up: frame.y, backwards: frame.z }
    }

    /// The orientation and the eye, and whether they had to be mirrored for the world to be
    /// right-handed: a note says so, and what else is in this world must be mirrored, too.
    ///
    /// # Errors
    /// Returns the errors of `orientation`.
    pub(crate) fn right_handed(
        &self,
        notes: &mut Vec<String>,
    ) -> Result<(Orientation, DVec3, bool), String> {
        let is_mirrored = Basis::is_left_handed(self.right, self.up, self.backwards);
        let pose = if is_mirrored { self.mirrored() } else { *self };
        let orientation = pose.orientation(notes)?;
        if is_mirrored {
            notes.push(MIRRORED.to_owned());
        }
        Ok((orientation, pose.eye, is_mirrored))
    }

    /// The pose in a world with every z negated.
    pub(crate) fn mirrored(&self) -> Pose {
        Pose {
            eye: mirrored(self.eye),
            right: mirrored(self.right),
            up: mirrored(self.up),
            backwards: mirrored(self.backwards),
        }
    }

    /// The orientation, and what had to be straightened.
    ///
    /// # Errors
    /// Returns the fault of the three vectors, as "up and backwards are parallel".
    pub(crate) fn orientation(&self, notes: &mut Vec<String>) -> Result<Orientation, String> {
        let [right, up, backwards] = [self.right, self.up, self.backwards].map(without_noise);
        if let Ok(basis) = Basis::by_hand(right, up, backwards) {
            return Ok(Orientation::Basis(basis));
        }
        let unit = [right, up, backwards].map(|v| v.try_normalize());
        let [Some(u), Some(v), Some(w)] = unit else {
            return Err("one of its axes is (0, 0, 0): it must be a rotation".to_owned());
        };
        let off = Basis::error_of(u, v, w);
        if off > 0.02 {
            return Err(format!(
                "its axes are off a right angle by up to {}: it must be a rotation, without shear",
                n((off * 1e4).round() / 1e4)
            ));
        }
        let basis = Basis::from_view_up(-w, v).map_err(|error| error.to_string())?;
        if off > ORTHONORMAL_TOLERANCE {
            notes.push(format!(
                "its axes are off a right angle by {off:.0e}: w is as given, v and u straightened"
            ));
        }
        Ok(Orientation::Basis(basis))
    }
}

/// Note on a mirrored camera: the picture stays, the world is seen in a mirror.
pub const MIRRORED: &str = "its world is left-handed, Pinhole's is right-handed: every z is \
                                   negated, so that the picture is the same";

/// A point or direction of a world with every z negated.
pub(crate) fn mirrored(v: DVec3) -> DVec3 {
    DVec3::new(v.x, v.y, 0.0 - v.z)
}

/// An axis whose parts that are a rounding from -1, 0 or 1 of its length are just that.
fn without_noise(axis: DVec3) -> DVec3 {
    let roundings = 4.0 * f64::EPSILON;
    let length = axis.length();
    DVec3::from_array(axis.to_array().map(|x| match (x / length).round() * length {
        whole if (x - whole).abs() <= roundings * length => settled(x, roundings * length),
        _ => x,
    }))
}
