//! Serialization by [serde](https://serde.rs): the feature `serde`.
//!
//! Fields and variants have their names in code, variants in small letters; a vector is a list of its
//! coordinates. Values that are read pass the same checks as values made in code, and are refused with
//! the same errors. This file holds the checks, which a derive on the type itself cannot make.

use glam::DVec3;
use serde::de::Error as _;
use serde::ser::SerializeStruct as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::{ImageSize as Size, Orientation};

/// Implements deserialization: reads a type's fields, and makes the type by the given expression, which
/// may refuse the fields. The helper struct has the name of the crate's own type, because messages
/// contain it.
macro_rules! checked {
    ($($name:ident { $($field:ident: $type:ty),* } => $made:expr;)*) => {$(
        #[derive(Deserialize)]
        struct $name { $($field: $type),* }

        impl<'de> Deserialize<'de> for crate::$name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let $name { $($field),* } = $name::deserialize(deserializer)?;
                $made.map_err(D::Error::custom)
            }
        }
    )*};
}

checked! {
    Camera { eye: DVec3, orientation: Orientation, viewport: crate::Viewport, image: Size } => {
        let camera = crate::Camera { eye, orientation, viewport, image };
        camera.resolve().map(|_| camera)
    };
    Basis { u: DVec3, v: DVec3, w: DVec3 } => crate::Basis::by_hand(u, v, w);
    Viewport { width: f64, height: f64, distance: f64 } => {
        let viewport = crate::Viewport { width, height, distance };
        viewport.check().map(|()| viewport)
    };
    ImageSize { width: u32, height: u32 } => Size::new(width, height);
    Ray { origin: DVec3, direction: DVec3 } => crate::Ray::new(origin, direction);
    Sphere { center: DVec3, radius: f64 } => crate::Sphere::new(center, radius);
    Plane { point: DVec3, normal: DVec3 } => crate::Plane::new(point, normal);
    // The objects are checked together, so that the message names the invalid one.
    Scene { spheres: Vec<Sphere>, planes: Vec<Plane> } => crate::Scene::new(
        spheres.into_iter().map(|Sphere { center, radius }| crate::Sphere { center, radius }).collect(),
        planes.into_iter().map(|Plane { point, normal }| crate::Plane { point, normal }).collect(),
    );
}

impl Serialize for crate::Scene {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut scene = serializer.serialize_struct("Scene", 2)?;
        scene.serialize_field("spheres", self.spheres())?;
        scene.serialize_field("planes", self.planes())?;
        scene.end()
    }
}
