//! Which of a scene's objects the observer's picture is traced with.

use std::borrow::Cow;

use pinhole_core::{DVec3, Scene, Sphere};

/// The scene as the world view traces it: the spheres alone, with their indices.
///
/// A plane has no end. Traced, it would fill the picture up to its horizon and, seen from behind,
/// hide the camera; the overlay draws the part of it near the target instead. A sphere
/// that [encloses] the camera hides it likewise, and is shrunk to a point where it stands,
/// so that the others keep their indices; the overlay draws its outline.
pub fn seen_scene<'a>(scene: &'a Scene, camera_eye: DVec3, observer_eye: DVec3) -> Cow<'a, Scene> {
    let hides = |sphere: &Sphere| encloses(sphere, camera_eye, observer_eye);
    if scene.planes().is_empty() && !scene.spheres().iter().any(hides) {
        return Cow::Borrowed(scene);
    }
    let point = |sphere: &Sphere| Sphere { radius: f64::MIN_POSITIVE, ..*sphere };
    let spheres = scene.spheres().iter().map(|s| if hides(s) { point(s) } else { *s }).collect();
    // Checked spheres make a scene; without one, the whole scene is still no lie.
    Scene::new(spheres, Vec::new()).map_or(Cow::Borrowed(scene), Cow::Owned)
}

/// Whether a sphere lies around the camera's eye but not around the observer's.
pub fn encloses(sphere: &Sphere, camera_eye: DVec3, observer_eye: DVec3) -> bool {
    sphere.implicit(camera_eye) < 0.0 && sphere.implicit(observer_eye) >= 0.0
}
