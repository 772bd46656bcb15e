//! Which of a scene's objects the observer's picture is traced with.

use pinhole_core::{DVec3, Scene, Sphere};

/// Indices of the spheres that would hide the camera from the observer, ascending: those that lie
/// around the camera's eye and not around the observer's.
pub fn enclosing(scene: &Scene, camera_eye: DVec3, observer_eye: DVec3) -> Vec<u32> {
    let mut around = scene.spheres_around(camera_eye);
    around.retain(|index| scene.spheres()[*index as usize].implicit(observer_eye) >= 0.0);
    around
}

/// The scene as the world view traces it: the spheres alone, with their indices.
///
/// A plane has no end. Traced, it would fill the picture up to its horizon and, seen from behind,
/// hide the camera; the overlay draws the part of it near the target instead. A sphere
/// [around the camera](enclosing) hides it likewise, and is [`hidden`] so that the others keep their
/// indices; the overlay draws its outline.
pub fn seen_scene(scene: &Scene, enclosing: &[u32]) -> Scene {
    let mut seen = scene.without_planes();
    for &index in enclosing {
        if let Some(sphere) = scene.spheres().get(index as usize) {
            // A checked sphere stays one; where none is replaced, the whole scene is still no lie.
            let _ = seen.replace_sphere(index, hidden(sphere));
        }
    }
    seen
}

/// A sphere that is shrunk to a point where it stands.
pub fn hidden(sphere: &Sphere) -> Sphere {
    Sphere { radius: f64::MIN_POSITIVE, ..*sphere }
}
