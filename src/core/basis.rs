//! The camera's basis u, v, w: from view and up, from eye, at and up, or given by hand.

use std::fmt;

use glam::DVec3;

use crate::exact::{Dyadic, dot, exact3};
use crate::fine_basis::{FineBasis, ViewGiven, angle_parts, basis_of};
use crate::number::{shortest, triple};
use crate::scale::length;
use crate::steps::Step;

/// How far a basis given by hand may be from orthonormal: `| |a| - 1 |` and `|a . b|` of its vectors.
///
/// Wide enough for values printed with ten digits, far too narrow for a typed `0.7071`.
pub const ORTHONORMAL_TOLERANCE: f64 = 1e-9;

/// The camera's coordinate frame in the world: right, up in the image, and *backwards*.
///
/// Orthonormal and right-handed: `u x v = w`. In these coordinates the camera is canonical.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    /// Right in the image.
    pub u: DVec3,
    /// Up in the image.
    pub v: DVec3,
    /// Backwards: away from what the camera looks at.
    pub w: DVec3,
}

/// Which vector of a [`Basis`] a message is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BasisVector {
    /// Right in the image.
    U,
    /// Up in the image.
    V,
    /// Backwards.
    W,
}

impl fmt::Display for BasisVector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            BasisVector::U => "u",
            BasisVector::V => "v",
            BasisVector::W => "w",
        })
    }
}

/// How close up is to the view direction, and what that does to the basis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UpAngle {
    /// Angle between up and view in radians, between 0 and pi; never either but by rounding.
    pub angle: f64,
    /// `1 / sin(angle)`: degrees of roll for each degree that up is tipped sideways.
    pub conditioning: f64,
}

/// Why there is no basis. Each case carries the numbers at fault.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BasisError {
    /// A coordinate of the named field is NaN or infinite.
    NotFinite {
        /// `eye`, `at`, `view`, `up`, or `basis.u`, `basis.v`, `basis.w`.
        field: &'static str,
        /// The value.
        value: DVec3,
    },
    /// `at - eye` is zero, so there is no view direction.
    EyeIsAt {
        /// Where both are.
        point: DVec3,
    },
    /// The view direction given is `(0, 0, 0)`.
    ViewIsZero,
    /// The up vector given is `(0, 0, 0)`.
    UpIsZero,
    /// `up x view` is zero: up does not say which way round the camera is.
    UpParallelToView {
        /// The up vector.
        up: DVec3,
        /// The view direction.
        view: DVec3,
    },
    /// A vector of a basis given by hand is not of length 1.
    NotUnit {
        /// Which one.
        vector: BasisVector,
        /// Its length.
        length: f64,
    },
    /// Two vectors of a basis given by hand are not orthogonal.
    NotOrthogonal {
        /// One of them.
        first: BasisVector,
        /// The other.
        second: BasisVector,
        /// Their dot product.
        dot: f64,
    },
    /// `u x v` of a basis given by hand is `-w`.
    LeftHanded,
}

impl fmt::Display for BasisError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BasisError::NotFinite { field, value } => {
                write!(f, "{field} is {}: every coordinate must be a finite number", triple(*value))
            }
            BasisError::EyeIsAt { point } => {
                write!(f, "eye and at are the same point {}: move one of them", triple(*point))
            }
            BasisError::ViewIsZero => write!(f, "view is (0, 0, 0): it must point somewhere"),
            BasisError::UpIsZero => write!(f, "up is (0, 0, 0): it must point somewhere"),
            BasisError::UpParallelToView { up, view } => write!(
                f,
                "up {} is parallel to the view direction {}: turn one of them",
                triple(*up),
                triple(*view)
            ),
            BasisError::NotUnit { vector, length } => write!(
                f,
                "{vector} has length {}: it must be 1 within {ORTHONORMAL_TOLERANCE:e}",
                shortest(*length)
            ),
            BasisError::NotOrthogonal { first, second, dot } => write!(
                f,
                "{first} . {second} is {}: it must be 0 within {ORTHONORMAL_TOLERANCE:e}",
                shortest(*dot)
            ),
            BasisError::LeftHanded => {
                write!(
                    f,
                    "the basis is left-handed: u x v is -w and must be w, which points backwards"
                )
            }
        }
    }
}

impl std::error::Error for BasisError {}

impl Basis {
    /// How far the three are from orthonormal: the sum of `| |a|^2 - 1 |` and `|a . b|`.
    pub(crate) fn defect(&self) -> f64 {
        let Basis { u, v, w } = *self;
        let unit = [u, v, w].map(|a| (a.length_squared() - 1.0).abs());
        let right_angles = [u.dot(v), v.dot(w), w.dot(u)].map(f64::abs);
        unit.iter().chain(&right_angles).sum()
    }

    /// The canonical camera's: x right, y up, z backwards.
    pub const CANONICAL: Basis = Basis { u: DVec3::X, v: DVec3::Y, w: DVec3::Z };

    /// The basis of a camera that looks along `view`, level with respect to `up`:
    ///
    /// ```text
    /// w = -view / |view|     u = up x w / |up x w|     v = w x u
    /// ```
    ///
    /// (Marschner, Shirley, *Fundamentals of Computer Graphics*, 4th ed., section 4.3.) No length of
    /// `view` and `up` overflows or underflows, and an `up` close to `view` costs no accuracy: each
    /// coordinate of u, v and w is the exact one, rounded, however small the angle. Whether up is
    /// parallel to view is decided exactly.
    ///
    /// # Errors
    /// Where a value is not finite, a vector is zero, or up is parallel to view.
    pub fn from_view_up(view: DVec3, up: DVec3) -> Result<Basis, BasisError> {
        Ok(Aim::along(view, up)?.fine_basis()?.rounded())
    }

    /// The basis of a camera at `eye` that looks at the point `at`: [`Basis::from_view_up`] with
    /// `view = at - eye`, which is not rounded.
    ///
    /// # Errors
    /// Where a value is not finite, `eye` is `at`, `up` is zero, or up is parallel to `at - eye`.
    pub fn from_eye_at_up(eye: DVec3, at: DVec3, up: DVec3) -> Result<Basis, BasisError> {
        Ok(Aim::from_to(eye, at, up)?.fine_basis()?.rounded())
    }

    /// Takes a basis as given, to the bit, if it is one: unit and orthogonal within
    /// [`ORTHONORMAL_TOLERANCE`], right-handed.
    ///
    /// # Errors
    /// Which vector is not finite or not of length 1, which two are not orthogonal, or that the
    /// three are left-handed.
    pub fn by_hand(u: DVec3, v: DVec3, w: DVec3) -> Result<Basis, BasisError> {
        use BasisVector::{U, V, W};
        for (field, value) in [("basis.u", u), ("basis.v", v), ("basis.w", w)] {
            check_finite(field, value)?;
        }
        for (vector, value) in [(U, u), (V, v), (W, w)] {
            if !is_unit(value) {
                return Err(BasisError::NotUnit { vector, length: length(value) });
            }
        }
        for (first, second, a, b) in [(U, V, u, v), (V, W, v, w), (W, U, w, u)] {
            if !is_orthogonal(a, b) {
                return Err(BasisError::NotOrthogonal { first, second, dot: a.dot(b) });
            }
        }
        if u.cross(v).dot(w) < 0.0 {
            return Err(BasisError::LeftHanded);
        }
        Ok(Basis { u, v, w })
    }

    /// `x*u + y*v + z*w`: from coordinates in this basis to a direction in the world.
    pub fn to_world_from_camera(&self, direction: DVec3) -> DVec3 {
        direction.x * self.u + direction.y * self.v + direction.z * self.w
    }

    /// `(p.u, p.v, p.w)`: from a direction in the world to coordinates in this basis.
    pub fn to_camera_from_world(&self, direction: DVec3) -> DVec3 {
        DVec3::new(direction.dot(self.u), direction.dot(self.v), direction.dot(self.w))
    }
}

impl UpAngle {
    /// A basis given by hand has v for its up: a right angle, conditioning 1.
    pub const OF_BASIS_BY_HAND: UpAngle =
        UpAngle { angle: std::f64::consts::FRAC_PI_2, conditioning: 1.0 };

    /// The angle between `up` and `view`, by `atan2(|up x view|, up . view)` (accurate at both
    /// ends, where arc cosine is not), and `|up| |view| / |up x view|`, at most `f64::MAX`.
    ///
    /// # Errors
    /// As [`Basis::from_view_up`].
    pub fn between(view: DVec3, up: DVec3) -> Result<UpAngle, BasisError> {
        Aim::along(view, up)?.up_angle()
    }

    /// [`UpAngle::between`] of `up` and `at - eye`.
    ///
    /// # Errors
    /// As [`Basis::from_eye_at_up`].
    pub fn of_eye_at_up(eye: DVec3, at: DVec3, up: DVec3) -> Result<UpAngle, BasisError> {
        Aim::from_to(eye, at, up)?.up_angle()
    }
}

/// A checked view direction and up, neither of them zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Aim {
    pub(crate) view: ViewGiven,
    pub(crate) up: DVec3,
}

impl Aim {
    pub(crate) fn along(view: DVec3, up: DVec3) -> Result<Aim, BasisError> {
        check_finite("view", view)?;
        check_finite("up", up)?;
        if view == DVec3::ZERO {
            return Err(BasisError::ViewIsZero);
        }
        Aim { view: ViewGiven::Along(view), up }.with_up()
    }

    pub(crate) fn from_to(eye: DVec3, at: DVec3, up: DVec3) -> Result<Aim, BasisError> {
        for (field, value) in [("eye", eye), ("at", at), ("up", up)] {
            check_finite(field, value)?;
        }
        if eye == at {
            return Err(BasisError::EyeIsAt { point: eye });
        }
        Aim { view: ViewGiven::Between { from: eye, to: at }, up }.with_up()
    }

    fn with_up(self) -> Result<Aim, BasisError> {
        if self.up == DVec3::ZERO { Err(BasisError::UpIsZero) } else { Ok(self) }
    }

    pub(crate) fn fine_basis(&self) -> Result<FineBasis, BasisError> {
        Ok(self.fine_basis_up_to(Step::Exact)?.0)
    }

    /// With the ladder cut off after a step, and the step that it took.
    pub(crate) fn fine_basis_up_to(&self, last: Step) -> Result<(FineBasis, Step), BasisError> {
        basis_of(&self.view, self.up, last)
    }

    fn up_angle(&self) -> Result<UpAngle, BasisError> {
        self.fine_basis()?;
        let (right, along, lengths) = angle_parts(&self.view, self.up);
        let conditioning = (lengths / right).min(f64::MAX);
        Ok(UpAngle { angle: right.atan2(along), conditioning })
    }
}

fn check_finite(field: &'static str, value: DVec3) -> Result<(), BasisError> {
    if value.is_finite() { Ok(()) } else { Err(BasisError::NotFinite { field, value }) }
}

/// Far more than rounding makes of a length or a dot product of vectors of about length 1.
const ROUNDING: f64 = 1e-15;

/// Whether `| |v| - 1 | <= tolerance`, exactly: where rounding could decide, as
/// `(1 - tolerance)^2 <= |v|^2 <= (1 + tolerance)^2`.
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

/// Whether `|a . b| <= tolerance`, exactly.
pub fn is_orthogonal(a: DVec3, b: DVec3) -> bool {
    let off = a.dot(b).abs();
    if (off - ORTHONORMAL_TOLERANCE).abs() > ROUNDING {
        return off < ORTHONORMAL_TOLERANCE;
    }
    let exact = dot(&exact3(a), &exact3(b));
    let tolerance = Dyadic::from(ORTHONORMAL_TOLERANCE);
    (&tolerance - &exact).sign().is_ge() && (&tolerance + &exact).sign().is_ge()
}
