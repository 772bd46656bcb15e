//! The camera's basis u, v, w: computed from view and up, from eye, at and up, or from a quaternion, or
//! given by hand.

use glam::{DMat3, DQuat, DVec3};
use thiserror::Error;

use crate::exact::dyadic::{Dyadic, dot, exact3};
use crate::exact::scale::{length, shortest, triple, unit};

/// How far a basis given by hand may be from orthonormal: the maximum of `| |a| - 1 |` and `|a . b|` for
/// its vectors a and b.
///
/// This accepts values printed with ten digits, and rejects a typed `0.7071`.
pub const ORTHONORMAL_TOLERANCE: f64 = 1e-9;

/// The camera's coordinate frame in the world: right, up in the image, and *backwards*.
///
/// The basis is orthonormal and right-handed: `u x v = w`. Expressed in this basis, the camera looks
/// along -z with y up, like the canonical camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    /// Right in the image.
    pub u: DVec3,
    /// Points up in the image.
    pub v: DVec3,
    /// Backwards: opposite to the view direction.
    pub w: DVec3,
}

/// The angle between up and the view direction, and the conditioning of the basis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UpAngle {
    /// Angle between up and view in radians, between 0 and pi. Only rounding can make it 0 or pi.
    pub angle: f64,
    /// `1 / sin(angle)`: the number of degrees by which the camera rolls for each degree that up is
    /// tilted sideways.
    pub conditioning: f64,
}

/// The reason why a camera has no basis, with the invalid values.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum BasisError {
    /// A coordinate of the named field is NaN or infinite.
    #[error("{field} is {}: every coordinate must be a finite number", triple(*.value))]
    NotFinite {
        /// `eye`, `at`, `view`, `up`, or `basis.u`, `basis.v`, `basis.w`.
        field: &'static str,
        /// The invalid vector.
        value: DVec3,
    },
    /// `at` equals `eye`, so there is no view direction.
    #[error("eye and at are the same point {}: move one of them", triple(*.point))]
    EyeIsAt {
        /// The position of both eye and at.
        point: DVec3,
    },
    /// The given view direction is `(0, 0, 0)`.
    #[error("view is (0, 0, 0): it must point somewhere")]
    ViewIsZero,
    /// The given up vector is `(0, 0, 0)`.
    #[error("up is (0, 0, 0): it must point somewhere")]
    UpIsZero,
    /// Up is parallel to the view (`up x view` is zero), so it cannot keep the camera level.
    #[error(
        "up {} is parallel to the view direction {}: turn one of them",
        triple(*.up),
        triple(*.view)
    )]
    UpParallelToView {
        /// The up vector.
        up: DVec3,
        /// The view direction.
        view: DVec3,
    },
    /// A vector of a basis given by hand does not have length 1.
    #[error("{vector} has length {}: it must be 1 within {ORTHONORMAL_TOLERANCE:e}", shortest(*.length))]
    NotUnit {
        /// The name of the vector: `u`, `v` or `w`.
        vector: &'static str,
        /// The length of the vector.
        length: f64,
    },
    /// Two vectors of a basis given by hand are not orthogonal.
    #[error("{first} . {second} is {}: it must be 0 within {ORTHONORMAL_TOLERANCE:e}", shortest(*.dot))]
    NotOrthogonal {
        /// The name of the first vector: `u`, `v` or `w`.
        first: &'static str,
        /// The name of the second vector: `u`, `v` or `w`.
        second: &'static str,
        /// The dot product of the two vectors.
        dot: f64,
    },
    /// A basis given by hand is left-handed: its `u x v` is `-w`.
    #[error("the basis is left-handed: u x v is -w and must be w, which points backwards")]
    LeftHanded,
}

impl BasisError {
    /// Returns the name of the vector at fault: `eye`, `at`, `view`, `up`, `u`, `v` or `w`.
    pub fn vector(&self) -> &'static str {
        match self {
            BasisError::NotFinite { field, .. } => field.trim_start_matches("basis."),
            BasisError::EyeIsAt { .. } => "at",
            BasisError::ViewIsZero => "view",
            BasisError::UpIsZero | BasisError::UpParallelToView { .. } => "up",
            BasisError::NotUnit { vector: name, .. }
            | BasisError::NotOrthogonal { second: name, .. } => name,
            BasisError::LeftHanded => "w",
        }
    }
}

impl Basis {
    /// Returns how far u, v and w are from orthonormal: the sum of `| |a|^2 - 1 |` over the three
    /// vectors and of `|a . b|` over the three pairs.
    pub(crate) fn defect(&self) -> f64 {
        let Basis { u, v, w } = *self;
        let unit = [u, v, w].map(|a| (a.length_squared() - 1.0).abs());
        let right_angles = [u.dot(v), v.dot(w), w.dot(u)].map(f64::abs);
        unit.iter().chain(&right_angles).sum()
    }

    /// The canonical camera's basis: x right, y up, z backwards.
    pub const CANONICAL: Basis = Basis { u: DVec3::X, v: DVec3::Y, w: DVec3::Z };

    /// Creates a basis from vectors given by hand, which are used unchanged. They must have length 1 and
    /// be orthogonal, both within [`ORTHONORMAL_TOLERANCE`], and be right-handed.
    ///
    /// # Errors
    /// Returns an error that names a vector that is not finite or does not have length 1, or two vectors
    /// that are not orthogonal; or an error if the basis is left-handed.
    pub fn by_hand(u: DVec3, v: DVec3, w: DVec3) -> Result<Basis, BasisError> {
        for (field, value) in [("basis.u", u), ("basis.v", v), ("basis.w", w)] {
            check_finite(field, value)?;
        }
        for (vector, value) in [("u", u), ("v", v), ("w", w)] {
            if !is_unit(value) {
                return Err(BasisError::NotUnit { vector, length: length(value) });
            }
        }
        for (first, second, a, b) in [("u", "v", u, v), ("v", "w", v, w), ("w", "u", w, u)] {
            if !is_orthogonal(a, b) {
                return Err(BasisError::NotOrthogonal { first, second, dot: a.dot(b) });
            }
        }
        if u.cross(v).dot(w) < 0.0 {
            return Err(BasisError::LeftHanded);
        }
        Ok(Basis { u, v, w })
    }

    /// Converts a direction from coordinates in this basis to world coordinates: `x*u + y*v + z*w`.
    pub fn to_world_from_camera(&self, direction: DVec3) -> DVec3 {
        direction.x * self.u + direction.y * self.v + direction.z * self.w
    }

    /// Converts a direction p from world coordinates to coordinates in this basis: `(p.u, p.v, p.w)`.
    pub fn to_camera_from_world(&self, direction: DVec3) -> DVec3 {
        DVec3::new(direction.dot(self.u), direction.dot(self.v), direction.dot(self.w))
    }

    /// Returns the basis to which a quaternion `[w, x, y, z]` of any length rotates the world's axes.
    /// Returns `None` if the quaternion is zero or not finite.
    pub fn of_quaternion([w, x, y, z]: [f64; 4]) -> Option<Basis> {
        let q = DQuat::from_xyzw(x, y, z, w);
        let length = q.length();
        if !(length.is_finite() && length > 0.0) {
            return None;
        }
        let turn = DMat3::from_quat(DQuat::from_vec4(glam::DVec4::from(q) / length).normalize());
        Some(Basis { u: turn.x_axis, v: turn.y_axis, w: turn.z_axis })
    }

    /// Returns how far three vectors are from orthonormal: the largest of `| |a| - 1 |` of a vector and
    /// `|a . b|` of a pair.
    pub fn error_of(u: DVec3, v: DVec3, w: DVec3) -> f64 {
        let lengths = [u, v, w].map(|a| (a.length() - 1.0).abs());
        let angles = [u.dot(v), v.dot(w), w.dot(u)].map(f64::abs);
        lengths.into_iter().chain(angles).fold(0.0, f64::max)
    }

    /// Returns whether three vectors of any length are left-handed; false if one is zero or not finite.
    /// A camera with such vectors for right, up and backwards would show a mirror image.
    pub fn is_left_handed(u: DVec3, v: DVec3, w: DVec3) -> bool {
        let vectors = [u, v, w];
        if vectors.iter().any(|a| !a.is_finite() || *a == DVec3::ZERO) {
            return false;
        }
        let [u, v, w] = vectors.map(unit);
        u.cross(v).dot(w) < 0.0
    }
}

pub(crate) fn check_finite(field: &'static str, value: DVec3) -> Result<(), BasisError> {
    if value.is_finite() { Ok(()) } else { Err(BasisError::NotFinite { field, value }) }
}

/// Allowance for rounding: far more than the error of a length or a dot product of vectors whose lengths
/// are about 1.
const ROUNDING: f64 = 1e-15;

/// Returns whether `| |v| - 1 |` is at most [`ORTHONORMAL_TOLERANCE`]. The decision is exact: if
/// rounding could change it, `(1 - tolerance)^2 <= |v|^2 <= (1 + tolerance)^2` is decided in exact
/// numbers.
pub fn is_unit(v: DVec3) -> bool {
    let off = (length(v) - 1.0).abs();
    if (off - ORTHONORMAL_TOLERANCE).abs() > ROUNDING {
        return off < ORTHONORMAL_TOLERANCE;
    }
    let (one, tolerance) = (Dyadic::from(1.0), Dyadic::from(ORTHONORMAL_TOLERANCE));
    let v = exact3(v);
    let square = dot(&v, &v);
    let above = &(&one + &tolerance).square() - &square;
    let below = &square - &(&one - &tolerance).square();
    above.sign().is_ge() && below.sign().is_ge()
}

/// Returns whether `|a . b|` is at most [`ORTHONORMAL_TOLERANCE`]. The decision is exact.
pub fn is_orthogonal(a: DVec3, b: DVec3) -> bool {
    let off = a.dot(b).abs();
    if (off - ORTHONORMAL_TOLERANCE).abs() > ROUNDING {
        return off < ORTHONORMAL_TOLERANCE;
    }
    let exact = dot(&exact3(a), &exact3(b));
    let tolerance = Dyadic::from(ORTHONORMAL_TOLERANCE);
    (&tolerance - &exact).sign().is_ge() && (&tolerance + &exact).sign().is_ge()
}
