//! Serialization by [serde](https://serde.rs): the feature `serde`.
//!
//! Fields and variants have their names in code, variants in small letters; a vector is a list of its
//! coordinates. What is read passes the check that it passes in code, and is refused with its error.

use glam::DVec3;
use serde::de::Error as _;
use serde::ser::SerializeStruct as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Fields and variants again, under the names of the crate's own types: messages have them.
#[derive(Serialize, Deserialize)]
#[serde(remote = "crate::Camera")]
struct Camera {
    eye: DVec3,
    orientation: crate::Orientation,
    viewport: crate::Viewport,
    image: crate::ImageSize,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "crate::Orientation", rename_all = "lowercase")]
enum Orientation {
    At { at: DVec3, up: DVec3 },
    View { view: DVec3, up: DVec3 },
    Basis(crate::Basis),
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "crate::OrientationKind", rename_all = "lowercase")]
enum OrientationKind {
    At,
    View,
    Basis,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "crate::Basis")]
struct Basis {
    u: DVec3,
    v: DVec3,
    w: DVec3,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "crate::Viewport")]
struct Viewport {
    width: f64,
    height: f64,
    distance: f64,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "crate::Pixel")]
struct Pixel {
    row: u32,
    column: u32,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "crate::Intrinsics")]
struct Intrinsics {
    fx: f64,
    fy: f64,
    cx: f64,
    cy: f64,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "crate::Ray")]
struct Ray {
    origin: DVec3,
    direction: DVec3,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "crate::Sphere")]
struct Sphere {
    center: DVec3,
    radius: f64,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "crate::Plane")]
struct Plane {
    point: DVec3,
    normal: DVec3,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "crate::Object", rename_all = "lowercase")]
enum Object {
    Sphere(crate::Sphere),
    Plane(crate::Plane),
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "crate::Outputs")]
struct Outputs {
    t: bool,
    object: bool,
    normal: bool,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "crate::Shade", rename_all = "lowercase")]
enum Shade {
    Lambert,
    Normal,
    T,
    Object,
}

/// Writes by the fields, and reads by them what then passes the check.
macro_rules! by_fields {
    ($($name:ident $check:expr,)*) => {$(
        impl Serialize for crate::$name {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                $name::serialize(self, serializer)
            }
        }

        impl<'de> Deserialize<'de> for crate::$name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let read = $name::deserialize(deserializer)?;
                let check: fn(&Self) -> Result<(), _> = $check;
                check(&read).map_err(D::Error::custom)?;
                Ok(read)
            }
        }
    )*};
}

by_fields! {
    Camera |camera| camera.resolve().map(drop),
    Orientation any,
    OrientationKind any,
    Basis |&crate::Basis { u, v, w }| crate::Basis::by_hand(u, v, w).map(drop),
    Viewport crate::Viewport::check,
    Pixel any,
    Intrinsics any,
    Ray crate::Ray::check,
    Sphere crate::Sphere::check,
    Plane crate::Plane::check,
    Object any,
    Outputs any,
    Shade any,
}

/// The check of what any value may stand in.
fn any<T>(_: &T) -> Result<(), std::convert::Infallible> {
    Ok(())
}

#[derive(Serialize, Deserialize)]
struct ImageSize {
    width: u32,
    height: u32,
}

impl Serialize for crate::ImageSize {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        ImageSize { width: self.width(), height: self.height() }.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for crate::ImageSize {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let ImageSize { width, height } = ImageSize::deserialize(deserializer)?;
        crate::ImageSize::new(width, height).map_err(D::Error::custom)
    }
}

/// A scene as it is read: its objects are checked together, so that the message says which one it is.
#[derive(Deserialize)]
struct Scene {
    spheres: Vec<AnySphere>,
    planes: Vec<AnyPlane>,
}

#[derive(Deserialize)]
struct AnySphere(#[serde(with = "Sphere")] crate::Sphere);

#[derive(Deserialize)]
struct AnyPlane(#[serde(with = "Plane")] crate::Plane);

impl Serialize for crate::Scene {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut scene = serializer.serialize_struct("Scene", 2)?;
        scene.serialize_field("spheres", self.spheres())?;
        scene.serialize_field("planes", self.planes())?;
        scene.end()
    }
}

impl<'de> Deserialize<'de> for crate::Scene {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Scene { spheres, planes } = Scene::deserialize(deserializer)?;
        let spheres = spheres.into_iter().map(|AnySphere(sphere)| sphere).collect();
        let planes = planes.into_iter().map(|AnyPlane(plane)| plane).collect();
        crate::Scene::new(spheres, planes).map_err(D::Error::custom)
    }
}
