//! The objects that the observer's picture is traced with.

use pinhole_core::{DVec3, Scene, Sphere};

/// Returns the indices, ascending, of the spheres that would hide the camera from the observer:
/// those that contain the camera's eye but not the observer's.
pub fn enclosing(scene: &Scene, camera_eye: DVec3, observer_eye: DVec3) -> Vec<u32> {
    let mut around = scene.spheres_around(camera_eye);
    around.retain(|index| scene.spheres()[*index as usize].implicit(observer_eye) >= 0.0);
    around
}

/// Returns the scene that the world view traces: the spheres without the planes, with the same
/// indices.
///
/// A plane has no end. Traced, it would fill the picture up to its horizon and, seen from behind,
/// hide the camera; the overlay draws the part of it near the target instead. A sphere
/// [around the camera](enclosing) would hide it too, and is [`hidden`] so that the others keep
/// their indices; the overlay draws its outline.
pub fn traced_scene(scene: &Scene, enclosing: &[u32]) -> Scene {
    let mut seen = scene.without_planes();
    for &index in enclosing {
        if let Some(sphere) = scene.spheres().get(index as usize) {
            // A checked sphere stays valid; if one is not replaced, the picture is still correct.
            let _ = seen.replace_sphere(index, hidden(sphere));
        }
    }
    seen
}

/// Returns the sphere shrunk to a point at its centre.
pub fn hidden(sphere: &Sphere) -> Sphere {
    Sphere { radius: f64::MIN_POSITIVE, ..*sphere }
}
