//! Moves a camera's eye or at to a point of the world, as when its handle is dragged. If the view
//! direction comes close to up, up is turned along with it.

use std::f64::consts::PI;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::camera::basis::{Basis, BasisError};
use crate::camera::fine_basis::Aim;
use crate::camera::{Camera, Orientation};
use crate::exact::scale::{angle_between, ldexp3, split, unit};
use crate::steering::{CONE, SteerError, Steered, Turn, orthonormal, steady};

/// What stays fixed when the eye is moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Keep {
    /// The point that the camera looks at, its [pivot](Camera::orbited): the view turns.
    At,
    /// The view direction: `at` moves with the eye.
    View,
}

impl Keep {
    /// Returns the other value.
    #[must_use]
    pub fn other(self) -> Keep {
        match self {
            Keep::At => Keep::View,
            Keep::View => Keep::At,
        }
    }
}

impl Camera {
    /// Returns the camera with its eye set to a point of the world. The result need not have a basis.
    /// With [`Keep::View`], `at` moves with the eye; with [`Keep::At`], `view` still ends at the same
    /// point.
    #[must_use]
    pub fn with_eye(&self, point: DVec3, keep: Keep) -> Camera {
        let by = point - self.eye;
        let orientation = match (self.orientation, keep) {
            (Orientation::At { at, up }, Keep::View) => Orientation::At { at: at + by, up },
            (Orientation::View { view, up }, Keep::At) => Orientation::View { view: view - by, up },
            (given, _) => given,
        };
        Camera { eye: point, orientation, ..*self }
    }

    /// Returns the camera with `at`, or the end of `view`, set to a point of the world. The result need
    /// not have a basis. A camera whose basis is set by hand is returned unchanged.
    #[must_use]
    pub fn with_at(&self, point: DVec3) -> Camera {
        let orientation = match self.orientation {
            Orientation::At { up, .. } => Orientation::At { at: point, up },
            Orientation::View { up, .. } => Orientation::View { view: point - self.eye, up },
            basis => basis,
        };
        Camera { orientation, ..*self }
    }

    /// Returns the camera after a drag of its eye or at. `moved` is the camera with the dragged field
    /// already set, by [`Camera::with_eye`] or [`Camera::with_at`].
    ///
    /// With [`Keep::At`], up turns with the view while the view is close to up (within [`CONE`]), and
    /// otherwise stays. A basis set by hand is turned by the smallest angle that aims it at its
    /// [pivot](Camera::orbited) again. With [`Keep::View`], the basis stays.
    ///
    /// If this camera has no basis, the result is `moved`, which may have one.
    ///
    /// # Errors
    /// Returns an error if the result would have no basis (because the eye is at the pivot), or if
    /// rounding would turn the basis ([`SteerError::Unsteady`]).
    pub fn led_to(&self, moved: Camera, keep: Keep) -> Result<Steered, SteerError> {
        let stays = |camera: Camera| Ok(Steered { camera, up_went_along: false });
        let Ok(basis) = self.basis() else {
            moved.basis()?;
            return stays(moved);
        };
        if keep == Keep::View || moved == *self {
            return stays(steady(moved, &basis)?);
        }
        let (aim, up) = match moved.orientation {
            Orientation::At { at, up } => (Aim::from_to(moved.eye, at, up)?, up),
            Orientation::View { view, up } => (Aim::along(view, up)?, up),
            Orientation::Basis(_) => return stays(self.frame_led_to(moved, &basis)?),
        };
        let to = unit(aim.view.rounded());
        let Some((direction, v)) = up_carried(&basis, self.up_angle()?.angle, to) else {
            moved.basis()?;
            return stays(moved);
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

    /// Returns the moved camera, whose basis is set by hand, turned to look at this camera's pivot.
    fn frame_led_to(&self, moved: Camera, basis: &Basis) -> Result<Camera, SteerError> {
        let view = (self.eye - moved.eye) - self.reach()? * basis.w;
        if !view.is_finite() {
            return Err(BasisError::NotFinite { field: "view", value: view }.into());
        }
        if view == DVec3::ZERO {
            return Err(BasisError::EyeIsAt { point: moved.eye }.into());
        }
        let turned = orthonormal(&frame_carried(&orthonormal(basis), unit(view)));
        let camera = Camera { orientation: Orientation::Basis(turned), ..moved };
        camera.basis()?;
        Ok(camera)
    }
}

/// Allowance for rounding, in radians: a view direction this close to the rim of the cone around up
/// counts as on it.
const SLACK: f64 = 1e-9;

/// The path of a view from one direction to another, along the great circle between them. The view takes
/// this path when eye or at moves in a straight line. All directions have length 1.
struct Way {
    from: DVec3,
    /// The great circle's axis.
    axis: DVec3,
    /// The path's length in radians.
    turn: f64,
}

impl Way {
    /// Creates the path between two directions. If they are equal or opposite, the path turns about v.
    fn new(from: DVec3, to: DVec3, v: DVec3) -> Way {
        let across = from.cross(to);
        let axis = if across == DVec3::ZERO { unit(v) } else { unit(across) };
        Way { from, axis, turn: angle_between(from, to) }
    }

    /// Returns a direction parallel-transported from the start of the path by `arc` radians along it.
    fn carried(&self, direction: DVec3, arc: f64) -> DVec3 {
        Turn::about(self.axis, arc).turned(direction)
    }

    /// Returns the direction in which the view moves at the beginning of the path.
    fn heading(&self) -> DVec3 {
        self.axis.cross(self.from)
    }
}

/// Returns the basis parallel-transported, by the smallest turn, to look along `to`.
pub(super) fn frame_carried(frame: &Basis, to: DVec3) -> Basis {
    let way = Way::new(-frame.w, to, frame.v);
    Basis { w: -to, ..Turn::about(way.axis, way.turn).turned_frame(frame) }
}

/// Returns up, of length 1, and v after the view of a camera with this basis has turned to the direction
/// `to`. Returns `None` if up stays as it is. `angle` is the angle between up and the view at the start.
///
/// On its path the view passes through up to three stretches:
///
/// 1. Inside the cone of half-angle [`CONE`] around up (or -up): v is parallel-transported. The angle to
///    up stays constant if the view turns towards up. If the view turns away, the angle grows as fast as
///    it would if up stayed, at the constant rate `-v . heading`. So a camera can get out of the cone
///    again.
/// 2. Outside the cones: up stays. Let a and b be the components of up along the view and along the
///    direction in which the view turns, both at the start of this stretch. After `arc` radians, the
///    view is at the angle `acos(a cos(arc) + b sin(arc)) = acos(A cos(arc - arc_0))` to up. It meets
///    the cones' rims at `arc_0 +- acos(cos(CONE) / A)`, and half a turn on.
/// 3. From the point at which the view enters a cone to the end: up is parallel-transported ahead of the
///    view.
pub(super) fn up_carried(basis: &Basis, angle: f64, to: DVec3) -> Option<(DVec3, DVec3)> {
    let way = Way::new(-basis.w, to, basis.v);
    // The sign selects up or -up, whichever is nearer to the view; v points towards one and away from
    // the other.
    let (sign, gap) = if angle <= 0.5 * PI { (1.0, angle) } else { (-1.0, PI - angle) };
    let up_at = |v: DVec3, gap: f64, view: DVec3| sign * gap.cos() * view + gap.sin() * v;

    let mut begun = 0.0;
    let mut up = up_at(basis.v, gap, way.from);
    if gap < CONE + SLACK {
        let away = -sign * basis.v.dot(way.heading());
        let leaves = if away > 0.0 { (CONE + SLACK - gap) / away } else { f64::INFINITY };
        begun = leaves.min(way.turn);
        let v = way.carried(basis.v, begun);
        up = up_at(v, gap + away.max(0.0) * begun, way.carried(way.from, begun));
        if begun == way.turn {
            return (way.turn > 0.0).then_some((up, v));
        }
    }
    let rest = way.turn - begun;
    let (view, heading) = (way.carried(way.from, begun), way.carried(way.heading(), begun));
    let Some(entry) = entry_into_cone(up.dot(view), up.dot(heading)).filter(|x| *x < rest) else {
        // The part of up at right angles to the view.
        return (begun > 0.0).then(|| (up, unit(up - up.dot(to) * to)));
    };
    let view = way.carried(view, entry);
    let v = unit(up - up.dot(view) * view);
    Some((way.carried(up, rest - entry), way.carried(v, rest - entry)))
}

/// Finds the `arc > 0` at which a view with `up . view = a cos(arc) + b sin(arc)` first enters the cone
/// around up or -up; `None` if it enters neither.
fn entry_into_cone(a: f64, b: f64) -> Option<f64> {
    let share = CONE.cos() / a.hypot(b);
    if share >= 1.0 {
        return None;
    }
    let enters = b.atan2(a) - share.acos();
    Some(enters.rem_euclid(PI))
}
