//! Placing eye or at at a point of the world; up turns with the view where the view comes close to up.

use std::f64::consts::PI;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::camera::basis::{Basis, BasisError};
use crate::camera::fine_basis::Aim;
use crate::camera::{Camera, Orientation};
use crate::exact::double_double::difference_with_rest;
use crate::exact::scale::{angle_between, ldexp3, split, unit};
use crate::steering::{CONE, SteerError, Steered, Turn, orthonormal, steady};

/// The quantity that stays fixed when the eye is moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Keep {
    /// The point that the camera looks at, its [pivot](Camera::pivot): the view turns.
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
    /// Returns the camera with its eye moved to a point of the world.
    ///
    /// With [`Keep::At`] the pivot stays and the view turns by the smallest angle. For a camera given by
    /// view, the length of `view` becomes the distance from the eye to the pivot; a basis set by hand
    /// makes the smallest turn that aims it at the pivot. With [`Keep::View`] the basis stays, and `at`
    /// keeps its position relative to the eye.
    ///
    /// A camera without a basis only has its fields set, which may give it a basis.
    ///
    /// # Errors
    /// Returns an error if there is no basis afterwards (the eye is at the pivot), or if rounding would
    /// turn the basis ([`SteerError::Unsteady`]).
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

    /// Returns the camera aimed at a point of the world, with its eye in place. Sets `at`, or
    /// `view = point - eye` for a camera given by view; a basis set by hand makes the smallest turn that
    /// aims it at the point.
    ///
    /// A camera without a basis only has its fields set, which may give it a basis.
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

    /// Returns the camera with eye and at moved together.
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

    /// Returns the camera after eye, at or view have been set. Up turns with the view where the view
    /// comes close to up, and otherwise stays.
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

    /// Returns the camera with its basis, set by hand, turned to look along `view`.
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

/// Tolerance within which a camera outside the cone counts as on the cone, because of rounding.
const SLACK: f64 = 1e-9;

/// The path of a view from one direction to another along the great circle between them, as the view turns
/// when eye or at moves on a straight line. All directions are of length 1.
struct Way {
    from: DVec3,
    /// The great circle's axis.
    axis: DVec3,
    /// The path's length in radians.
    turn: f64,
}

impl Way {
    /// Makes the path between two directions; to the opposite direction it turns about v.
    fn new(from: DVec3, to: DVec3, v: DVec3) -> Way {
        let across = from.cross(to);
        let axis = if across == DVec3::ZERO { unit(v) } else { unit(across) };
        Way { from, axis, turn: angle_between(from, to) }
    }

    /// Returns a direction transported in parallel to a position on the path.
    fn carried(&self, direction: DVec3, arc: f64) -> DVec3 {
        Turn::about(self.axis, arc).turned(direction)
    }

    /// Returns the direction in which the view turns at the beginning of the path.
    fn heading(&self) -> DVec3 {
        self.axis.cross(self.from)
    }
}

/// Returns the basis transported in parallel, by the smallest turn, to look along `to`.
pub(super) fn frame_carried(frame: &Basis, to: DVec3) -> Basis {
    let way = Way::new(-frame.w, to, frame.v);
    Basis { w: -to, ..Turn::about(way.axis, way.turn).turned_frame(frame) }
}

/// Returns up, of length 1, and v after the view of a camera with this basis has turned to another
/// direction, if up turns with the view; `None` if up stays. `angle` is the angle between up and the
/// view.
///
/// On its path the view passes through up to three stretches:
///
/// 1. From within the cone round up (or -up): v is carried in parallel. The angle to up stays where
///    the view turns towards up, and grows where it turns away, as fast as it would if up stayed: with
///    v carried along, its rate is the constant `-v . heading`. So a camera gets out of the cone
///    again.
/// 2. Outside: up stays. The view at `arc` is at the angle
///    `acos(a cos(arc) + b sin(arc)) = acos(A cos(arc - arc_0))` to up, which meets the cones' rims at
///    `arc_0 +- acos(cos(CONE) / A)`, and half a turn on.
/// 3. From where the view enters a cone: up is carried in parallel, in front of the view, to the end.
pub(super) fn up_carried(basis: &Basis, angle: f64, to: DVec3) -> Option<(DVec3, DVec3)> {
    let way = Way::new(-basis.w, to, basis.v);
    // Of up and -up, the one nearer to the view; v points towards one and away from the other.
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

/// Finds the `arc > 0` at which a view with `up . view = a cos(arc) + b sin(arc)` first enters a cone;
/// `None` if it enters none.
fn entry_into_cone(a: f64, b: f64) -> Option<f64> {
    let share = CONE.cos() / a.hypot(b);
    if share >= 1.0 {
        return None;
    }
    let enters = b.atan2(a) - share.acos();
    Some(enters.rem_euclid(PI))
}
