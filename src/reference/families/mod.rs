//! Families of hard cases, each with a knob that makes it harder.

mod draw;
mod frames;
mod planes;
mod spheres;
mod ties;

pub use draw::Draw;

use crate::camera::{Camera, Orientation};
use crate::object::Object;

/// A single ray and the objects to intersect.
#[derive(Clone, Debug, PartialEq)]
pub struct RayCase {
    /// Spheres first, then planes.
    pub objects: Vec<Object>,
    /// The point where the ray starts.
    pub origin: [f64; 3],
    /// The ray's direction, not normalized.
    pub direction: [f64; 3],
}

/// A whole picture.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameCase {
    /// The camera, with a small image.
    pub camera: Camera,
    /// Spheres first, then planes.
    pub objects: Vec<Object>,
}

/// The function that makes a case from random numbers and the knob.
#[derive(Clone, Copy, Debug)]
pub enum Make {
    /// Single rays: [`Family::rays`].
    Rays(fn(&mut Draw, f64) -> RayCase),
    /// Whole pictures: [`Family::frames`].
    Frames(fn(&mut Draw, f64) -> FrameCase),
}

/// Cases that are hard for one reason, and a knob for how hard.
///
/// A case is made from the seed, the family's name, the knob and the case's number. It is the same on every
/// machine, and a longer list of cases begins with the shorter one.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// The family's name, in kebab-case.
    pub name: &'static str,
    /// A sentence about what the family's cases have in common.
    pub about: &'static str,
    /// The knob's meaning, with its unit.
    pub knob_name: &'static str,
    /// The knob's values, in ascending order.
    pub knobs: &'static [f64],
    /// The function that makes a case.
    pub make: Make,
}

const ULPS: [f64; 3] = [-1.0, 0.0, 1.0];
const OFFSETS: [f64; 4] = [3.0, 6.0, 9.0, 12.0];
const TO_ROUNDING: [f64; 8] = [-16.0, -14.0, -12.0, -10.0, -8.0, -6.0, -3.0, -1.0];
const SMALL: [f64; 6] = [-12.0, -10.0, -8.0, -6.0, -3.0, -1.0];
const PLANETS: [f64; 6] = [3.0, 4.0, 5.0, 6.0, 7.0, 8.0];

/// The families of single rays, then those of frames.
static ALL: [&[Family]; 4] =
    [&spheres::FAMILIES, &planes::FAMILIES, &ties::FAMILIES, &frames::FAMILIES];

impl Family {
    /// Returns all families: first the families of rays, then the families of frames.
    pub fn all() -> impl Iterator<Item = &'static Family> {
        ALL.into_iter().flatten()
    }

    /// Returns the family with this name; `None` if there is none.
    pub fn named(name: &str) -> Option<&'static Family> {
        Family::all().find(|family| family.name == name)
    }

    /// Returns cases of a family of rays for one of its [knobs](Family::knobs); empty for a family
    /// of frames. With `single`, all numbers are exact in `f32`, units in the last place are those
    /// of `f32`, and powers of ten beyond the range of `f32` are brought into it.
    pub fn rays(&self, knob: f64, seed: u64, count: usize, single: bool) -> Vec<RayCase> {
        let Make::Rays(make) = self.make else { return Vec::new() };
        let given = |mut draw: Draw| {
            let RayCase { objects, origin, direction } = make(&mut draw, knob);
            RayCase {
                objects: objects.into_iter().map(|object| object.given(&draw)).collect(),
                origin: draw.given3(origin),
                direction: draw.given3(direction),
            }
        };
        Draw::cases(seed, self.name, knob, count, single).map(given).collect()
    }

    /// Returns cases of a family of frames, as [`Family::rays`] does for rays; empty for a family
    /// of rays.
    pub fn frames(&self, knob: f64, seed: u64, count: usize, single: bool) -> Vec<FrameCase> {
        let Make::Frames(make) = self.make else { return Vec::new() };
        let given = |mut draw: Draw| {
            let FrameCase { camera, objects } = make(&mut draw, knob);
            let camera = Camera {
                eye: draw.given3(camera.eye),
                orientation: camera.orientation.map(|v| draw.given3(v)),
                width: draw.given(camera.width),
                height: draw.given(camera.height),
                distance: draw.given(camera.distance),
                ..camera
            };
            let objects = objects.into_iter().map(|object| object.given(&draw)).collect();
            FrameCase { camera, objects }
        };
        Draw::cases(seed, self.name, knob, count, single).map(given).collect()
    }
}

impl Object {
    /// Returns the object with its positions, normals and radii mapped.
    fn map(
        self,
        map_point: impl Fn([f64; 3]) -> [f64; 3],
        normal: impl Fn([f64; 3]) -> [f64; 3],
        radius: impl Fn(f64) -> f64,
    ) -> Object {
        match self {
            Object::Sphere { center, radius: r } => {
                Object::Sphere { center: map_point(center), radius: radius(r) }
            }
            Object::Plane { point, normal: n } => {
                Object::Plane { point: map_point(point), normal: normal(n) }
            }
        }
    }

    fn given(self, draw: &Draw) -> Object {
        self.map(|v| draw.given3(v), |v| draw.given3(v), |x| draw.given(x))
    }

    /// Returns the object with all lengths multiplied by `scale`.
    fn scaled(self, scale: f64) -> Object {
        self.map(|v| v.map(|x| x * scale), |normal| normal, |radius| radius * scale)
    }
}

impl Orientation {
    /// Returns the orientation with each of its vectors mapped.
    #[must_use]
    pub fn map(self, vector: impl Fn([f64; 3]) -> [f64; 3]) -> Orientation {
        match self {
            Orientation::At { at, up } => Orientation::At { at: vector(at), up: vector(up) },
            Orientation::View { view, up } => {
                Orientation::View { view: vector(view), up: vector(up) }
            }
            Orientation::Basis { u, v, w } => {
                Orientation::Basis { u: vector(u), v: vector(v), w: vector(w) }
            }
        }
    }
}

impl FrameCase {
    /// Returns the same picture with its positions and radii mapped.
    fn map(
        self,
        map_point: impl Fn([f64; 3]) -> [f64; 3],
        radius: impl Fn(f64) -> f64,
    ) -> FrameCase {
        let orientation = match self.camera.orientation {
            Orientation::At { at, up } => Orientation::At { at: map_point(at), up },
            other => other,
        };
        let camera = Camera { eye: map_point(self.camera.eye), orientation, ..self.camera };
        let objects =
            self.objects.into_iter().map(|object| object.map(&map_point, |normal| normal, &radius));
        FrameCase { camera, objects: objects.collect() }
    }

    /// Returns the case with all lengths of the world multiplied by `scale`, but not the
    /// viewport's: only t changes.
    fn scaled(self, scale: f64) -> FrameCase {
        self.map(|v| v.map(|x| x * scale), |radius| radius * scale)
    }
}
