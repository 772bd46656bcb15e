//! Converts the reference's cases to this crate's types.

use pinhole_core::*;
use pinhole_reference as reference;

/// Scene of the reference's objects, spheres first.
pub(crate) fn scene(objects: &[reference::Object]) -> Scene {
    let (mut spheres, mut planes) = (Vec::new(), Vec::new());
    for object in objects {
        match *object {
            reference::Object::Sphere { center, radius } => {
                spheres.push(Sphere { center: center.into(), radius });
            }
            reference::Object::Plane { point, normal } => {
                planes.push(Plane { point: point.into(), normal: normal.into() });
            }
        }
    }
    Scene::new(spheres, planes).unwrap()
}

/// Converts the way a camera is turned.
pub(crate) fn orientation(given: &reference::Orientation) -> Orientation {
    match *given {
        reference::Orientation::At { at, up } => Orientation::At { at: at.into(), up: up.into() },
        reference::Orientation::View { view, up } => {
            Orientation::View { view: view.into(), up: up.into() }
        }
        reference::Orientation::Basis { u, v, w } => {
            Orientation::Basis(Basis { u: u.into(), v: v.into(), w: w.into() })
        }
    }
}

/// A camera.
pub(crate) fn camera(given: &reference::Camera) -> Camera {
    Camera {
        eye: given.eye.into(),
        orientation: orientation(&given.orientation),
        viewport: Viewport { width: given.width, height: given.height, distance: given.distance },
        image: ImageSize::new(given.columns, given.rows).unwrap(),
    }
}
