//! The values that a handle changes.

use pinhole_core::{Camera, Plane, Selection, Sphere};
use pinhole_exchange::document::Document;

use crate::model::session::hand::Handle;

/// The part of document and session that a handle can change, either before or after the change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandleValues {
    /// The edited camera.
    pub camera: Camera,
    /// The selected ray.
    pub selection: Selection,
    /// The handle's object, with its index in the document.
    pub object: Option<(usize, Solid)>,
}

/// A sphere or a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs, reason = "what they hold is their name")]
pub enum Solid {
    Sphere(Sphere),
    Plane(Plane),
}

impl HandleValues {
    /// Returns the current values of the part that this handle can change.
    pub fn read(handle: Handle, document: &Document, selection: Selection) -> HandleValues {
        let solid = |k: usize| {
            let sphere = document.spheres.get(k).map(|item| Solid::Sphere(item.shape));
            let k = k.checked_sub(document.sphere_count());
            sphere.or_else(|| Some(Solid::Plane(document.planes.get(k?)?.shape)))
        };
        let object = handle.object().and_then(|k| Some((k, solid(k)?)));
        HandleValues { camera: document.camera, selection, object }
    }

    /// Writes this part into document and session.
    pub fn put(&self, document: &mut Document, selection: &mut Selection) {
        document.camera = self.camera;
        *selection = self.selection;
        let first_plane = document.sphere_count();
        match self.object {
            Some((k, Solid::Sphere(sphere))) => {
                document.spheres.get_mut(k).into_iter().for_each(|item| item.shape = sphere);
            }
            Some((k, Solid::Plane(plane))) => {
                let item = k.checked_sub(first_plane).and_then(|k| document.planes.get_mut(k));
                item.into_iter().for_each(|item| item.shape = plane);
            }
            None => {}
        }
    }

    pub(super) fn sphere(&self) -> Option<Sphere> {
        match self.object {
            Some((_, Solid::Sphere(sphere))) => Some(sphere),
            _ => None,
        }
    }

    pub(super) fn plane(&self) -> Option<Plane> {
        match self.object {
            Some((_, Solid::Plane(plane))) => Some(plane),
            _ => None,
        }
    }
}
