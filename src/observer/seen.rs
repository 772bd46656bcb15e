//! Which of a scene's objects the observer's picture is traced with.

use std::borrow::Cow;

use pinhole_core::{DVec3, Scene, Sphere};

/// Indices of the spheres that would hide the camera from the observer, ascending: those that lie
/// around the camera's eye and not around the observer's.
pub fn enclosing(scene: &Scene, camera_eye: DVec3, observer_eye: DVec3) -> Vec<u32> {
    let hides = |sphere: &Sphere| encloses(sphere, camera_eye, observer_eye);
    (0..)
        .zip(scene.spheres())
        .filter_map(|(index, sphere)| hides(sphere).then_some(index))
        .collect()
}

/// The scene as the world view traces it: the spheres alone, with their indices.
///
/// A plane has no end. Traced, it would fill the picture up to its horizon and, seen from behind,
/// hide the camera; the overlay draws the part of it near the target instead. A sphere
/// [around the camera](enclosing) hides it likewise, and is shrunk to a point where it stands,
/// so that the others keep their indices; the overlay draws its outline.
pub fn seen_scene<'a>(scene: &'a Scene, enclosing: &[u32]) -> Cow<'a, Scene> {
    if scene.planes().is_empty() && enclosing.is_empty() {
        return Cow::Borrowed(scene);
    }
    let mut spheres = scene.spheres().to_vec();
    for index in enclosing {
        if let Some(sphere) = spheres.get_mut(*index as usize) {
            sphere.radius = f64::MIN_POSITIVE;
        }
    }
    // Checked spheres make a scene; without one, the whole scene is still no lie.
    Scene::new(spheres, Vec::new()).map_or(Cow::Borrowed(scene), Cow::Owned)
}

/// Whether a sphere lies around the camera's eye but not around the observer's.
fn encloses(sphere: &Sphere, camera_eye: DVec3, observer_eye: DVec3) -> bool {
    sphere.implicit(camera_eye) < 0.0 && sphere.implicit(observer_eye) >= 0.0
}
