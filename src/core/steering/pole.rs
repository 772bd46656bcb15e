//! Poles: up, when the view is led near it.

use std::f64::consts::PI;

use glam::DVec3;

use super::steered::{CONE, Turn};
use crate::camera::basis::Basis;
use crate::exact::scale::{angle_between, unit};

/// A camera this little outside the cone is on it: rounding may have put it there.
const SLACK: f64 = 1e-9;

/// A view that is led from one direction to another, along the great circle between them: that is how
/// the direction turns when eye or at move straight ahead. All directions are of length 1.
struct Way {
    from: DVec3,
    /// The great circle's axis.
    axis: DVec3,
    /// Its length in radians.
    turn: f64,
}

impl Way {
    /// The way between two directions; to the opposite one it goes about v.
    fn new(from: DVec3, to: DVec3, v: DVec3) -> Way {
        let across = from.cross(to);
        let axis = if across == DVec3::ZERO { unit(v) } else { unit(across) };
        Way { from, axis, turn: angle_between(from, to) }
    }

    /// A direction carried along to this place of the way, in parallel.
    fn carried(&self, direction: DVec3, arc: f64) -> DVec3 {
        Turn::about(self.axis, arc).turned(direction)
    }

    /// The direction in which the view turns at the beginning.
    fn heading(&self) -> DVec3 {
        self.axis.cross(self.from)
    }
}

/// A frame that looks along `to`, carried there in parallel: by the least turn.
pub(super) fn frame_carried(frame: &Basis, to: DVec3) -> Basis {
    let way = Way::new(-frame.w, to, frame.v);
    Basis { w: -to, ..Turn::about(way.axis, way.turn).turned_frame(frame) }
}

/// Returns up, of length 1, and v, where the view of a camera with this basis is led to another
/// direction and takes up along; `None` where up stays. `angle` is that between up and the view.
///
/// On its way the view meets up to three stretches:
///
/// 1. From within the cone round up (or -up): v is carried in parallel. The angle to up stays where
///    the view turns towards up, and grows where it turns away, as fast as it would if up stayed: with
///    v carried along, its rate is the constant `-v . heading`. So a camera gets out of the cone
///    again.
/// 2. Outside: up stays. The view at `arc` is at the angle
///    `acos(a cos(arc) + b sin(arc)) = acos(A cos(arc - arc_0))` to up, which meets the cones' rims at
///    `arc_0 +- acos(cos(CONE) / A)`, and half a turn on.
/// 3. From where it enters a cone: up is carried in parallel, in front of the view, to the end.
pub(super) fn up_carried(basis: &Basis, angle: f64, to: DVec3) -> Option<(DVec3, DVec3)> {
    let way = Way::new(-basis.w, to, basis.v);
    // Of up and -up the one that the view is nearer to; v points to the one and away from the other.
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
        // The part of up across the view.
        return (begun > 0.0).then(|| (up, unit(up - up.dot(to) * to)));
    };
    let view = way.carried(view, entry);
    let v = unit(up - up.dot(view) * view);
    Some((way.carried(up, rest - entry), way.carried(v, rest - entry)))
}

/// Finds where, at `arc > 0`, a view with `up . view = a cos(arc) + b sin(arc)` first enters a cone.
fn entry_into_cone(a: f64, b: f64) -> Option<f64> {
    let share = CONE.cos() / a.hypot(b);
    if share >= 1.0 {
        return None;
    }
    let enters = b.atan2(a) - share.acos();
    Some(enters.rem_euclid(PI))
}
