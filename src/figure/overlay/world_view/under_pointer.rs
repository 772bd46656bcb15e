//! The point of the world under the pointer in the world view, which stays there while the view is zoomed.

use pinhole_core::{DVec3, Frame, ResolvedCamera, Scene, Sphere};

use super::pick;
use crate::overlay::{camera_uv_at, wide, world_position_of};

/// A point of the world that the world view shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointShown {
    /// The point.
    pub point: DVec3,
    /// The object that it belongs to.
    pub of: Under,
}

/// What is under the pointer in the world view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Under {
    /// The camera: its viewport or its eye.
    Camera,
    /// A sphere.
    Sphere(Sphere),
    /// A plane, or nothing.
    Ground,
}

/// Distance from the target within which planes count, as a fraction of the target's distance from the
/// observer: planes are drawn in parts, near what the view shows.
const FAR: f64 = 0.5;

/// Returns the point at a position of the world view, in screen pixels: on the camera's viewport, at its eye
/// if that is within `reach`, on a sphere, or on a plane. Where there is nothing, returns the observer's
/// `target`: zooming to it keeps the scene in sight.
pub fn point_at(
    scene: Option<&Scene>,
    camera: Option<&ResolvedCamera>,
    frame: &Frame<f32>,
    target: DVec3,
    (position, reach): ([f32; 2], f32),
) -> PointShown {
    let observer = frame.camera();
    let size = [observer.image().width(), observer.image().height()].map(|n| n as usize);
    let sight = observer.ray(camera_uv_at(observer, size, position));
    let [column, row] = position.map(|x| x as usize);
    let index = row * size[0] + column;
    let traced_t = frame.t.get(index).map_or(f64::INFINITY, |t| f64::from(*t));
    let of_camera = camera.and_then(|camera| {
        let eye = || {
            let shown = world_position_of(observer, camera.eye())?;
            let is_near = shown.distance(wide(position)) <= reach.into();
            let depth = (observer.eye() - camera.eye()).dot(observer.basis().w);
            // What hides the eye is nearer to the pointer.
            (is_near && depth <= traced_t * observer.viewport().distance).then(|| camera.eye())
        };
        let point = pick(camera, frame, position).map(|uv| camera.ray(uv).at(1.0)).or_else(eye)?;
        Some(PointShown { point, of: Under::Camera })
    });
    let of_sphere = || {
        let sphere = scene?.spheres().get(*frame.object.get(index)? as usize)?;
        Some(PointShown { point: sight.at(traced_t), of: Under::Sphere(*sphere) })
    };
    let farthest = FAR * target.distance(observer.eye());
    let on_ground = || {
        let planes = scene.map_or(&[][..], |scene| scene.planes()).iter();
        let t = planes.filter_map(|plane| plane.roots(&sight).first_positive()).reduce(f64::min);
        let point = t.map(|t| sight.at(t)).filter(|point| point.distance(target) < farthest);
        PointShown { point: point.unwrap_or(target), of: Under::Ground }
    };
    of_camera.or_else(of_sphere).unwrap_or_else(on_ground)
}
