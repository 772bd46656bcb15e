//! The magnet where up meets the view direction: there a camera has no basis, and no hand would find
//! the exact position.

use pinhole_core::steering::Keep;
use pinhole_core::{Camera, DVec2, DVec3, Orientation};

use super::drag::HandleDrag;
use crate::model::session::hand::Handle;

/// Distance from the line at which the magnet draws, in points.
const REACH: f64 = 9.0;

/// Steps along the line: a share with few digits, so that up and view are parallel without rounding
/// where they are short numbers.
const STEPS: f64 = 16.0;

/// Returns the camera with its dragged handle on the line where up and the view meet, if the pointer, at
/// `uv` in the observer's viewport, is near that line. A moved eye or at meets up only if up is kept.
pub(super) fn drawn_on(drag: &HandleDrag<'_>, uv: DVec2) -> Option<Camera> {
    let camera = drag.start.before.camera;
    let (handle, length) = (drag.start.grasp.handle, drag.start.grasp.length);
    let (eye, view, up) = (camera.eye, camera.view(), camera.up());
    let turns_view = drag.options.keeps_up && drag.options.eye == Keep::At;
    let (origin, direction) = match handle {
        Handle::Up => (eye, length * view),
        Handle::Eye if turns_view => (eye + view, up),
        Handle::At if drag.options.keeps_up => (eye, up),
        _ => return None,
    };
    let share = nearest(drag, uv, origin, direction)?;
    let orientation = match (handle, camera.orientation) {
        (_, Orientation::Basis(_)) => return None,
        (Handle::Up, Orientation::At { at, .. }) => Orientation::At { at, up: share * view },
        (Handle::Up, Orientation::View { view, .. }) => {
            Orientation::View { view, up: share * view }
        }
        (Handle::At, Orientation::At { up, .. }) => Orientation::At { at: eye + share * up, up },
        (Handle::At, Orientation::View { up, .. }) => Orientation::View { view: share * up, up },
        (_, Orientation::View { up, .. }) => Orientation::View { view: -share * up, up },
        (_, at) => at,
    };
    let eye = if handle == Handle::Eye { origin + share * direction } else { eye };
    Some(Camera { eye, orientation, ..camera })
}

/// Returns the s of the point `origin + s direction` that the observer sees nearest to `uv`, if it is
/// near enough.
fn nearest(drag: &HandleDrag<'_>, uv: DVec2, origin: DVec3, direction: DVec3) -> Option<f64> {
    let ray = drag.observer.ray(uv);
    // The feet of the common perpendicular of the two lines.
    let normal = direction.cross(ray.direction);
    let share = (ray.origin - origin).cross(ray.direction).dot(normal) / normal.length_squared();
    let share = (STEPS * share).round() / STEPS;
    if !share.is_finite() || share == 0.0 {
        return None;
    }
    let seen = drag.observer.project(origin + share * direction);
    let dots = f64::from(drag.observer.image().height()) / drag.observer.viewport().height;
    let is_near = dots * seen.uv.distance(uv) < REACH * f64::from(drag.scale);
    (seen.depth > 0.0 && is_near).then_some(share)
}
