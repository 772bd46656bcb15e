//! The point of the world under the pointer in the world view, which stays there while the view is zoomed.

use pinhole_core::{DVec3, Frame, Plane, Ray, ResolvedCamera, Scene};

use super::{pick, world_position_of};
use crate::view::overlay::{camera_uv_at, wide};

/// A point of the world that the world view shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointShown {
    /// The point.
    pub point: DVec3,
    /// The size of the camera or of the sphere that it belongs to; `None` for other points.
    pub size: Option<f64>,
}

/// Distance from the target within which planes are drawn, as a fraction of the target's distance from the
/// observer.
const FAR: f64 = 0.5;

/// Returns the point at a position of the world view, in screen pixels: on the camera's viewport, at its eye
/// if that is within `reach`, on a sphere, or on a plane. Where there is nothing,
/// returns the observer's `target`: zooming to it keeps the scene in sight.
pub fn point_at(
    scene: &Scene,
    camera: Option<&ResolvedCamera>,
    frame: &Frame<f32>,
    target: DVec3,
    (position, reach): ([f32; 2], f32),
) -> PointShown {
    let observer = frame.camera();
    let image = observer.image();
    let size = [image.width(), image.height()].map(|n| n as usize);
    let sight = observer.ray(camera_uv_at(observer, size, position));
    let on_camera = camera.and_then(|camera| on_camera(camera, frame, (position, reach)));
    let on_sphere = || {
        let [column, row] = position.map(|x| x as usize);
        let index = row * size[0] + column;
        let sphere = scene.spheres().get(*frame.object.get(index)? as usize)?;
        let point = sight.at(f64::from(*frame.t.get(index)?));
        Some(PointShown { point, size: Some(sphere.radius) })
    };
    let farthest = FAR * target.distance(observer.eye());
    let on_plane = || {
        let point =
            scene.planes().iter().filter_map(|plane| plane_hit(plane, &sight)).reduce(f64::min);
        let point = point.map(|t| sight.at(t)).filter(|point| point.distance(target) < farthest);
        PointShown { point: point.unwrap_or(target), size: None }
    };
    on_camera.or_else(on_sphere).unwrap_or_else(on_plane)
}

/// Returns the point of the camera at a position: on its viewport, or its eye.
fn on_camera(
    camera: &ResolvedCamera,
    frame: &Frame<f32>,
    (position, reach): ([f32; 2], f32),
) -> Option<PointShown> {
    let viewport = camera.viewport();
    let size = viewport.width.max(viewport.height).max(viewport.distance);
    let point = match pick(camera, frame, position) {
        Some(uv) => camera.ray(uv).at(1.0),
        None => {
            let eye = world_position_of(frame, camera.eye())?;
            let is_near = wide(eye).distance(wide(position)) <= reach.into();
            is_near.then(|| camera.eye())?
        }
    };
    Some(PointShown { point, size: Some(size) })
}

/// Returns the t at which the line of sight meets a plane in front of the observer.
fn plane_hit(plane: &Plane, sight: &Ray) -> Option<f64> {
    let t = (plane.point - sight.origin).dot(plane.normal) / sight.direction.dot(plane.normal);
    (t > 0.0).then_some(t)
}
