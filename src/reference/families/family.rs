//! Cases, and a family of them.

use crate::camera::{Camera, Orientation};
use crate::families::draw::Draw;
use crate::object::Object;

/// Any ray against objects.
#[derive(Clone, Debug, PartialEq)]
pub struct RayCase {
    /// Spheres first, then planes.
    pub objects: Vec<Object>,
    /// The point where the ray starts.
    pub origin: [f64; 3],
    /// Its direction, not normalized.
    pub direction: [f64; 3],
}

/// A camera's place and orientation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BasisCase {
    /// Its position.
    pub eye: [f64; 3],
    /// The way it is turned.
    pub orientation: Orientation,
}

/// A whole picture.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameCase {
    /// The camera, with a small image.
    pub camera: Camera,
    /// Spheres first, then planes.
    pub objects: Vec<Object>,
}

/// The kind of a family's cases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Any rays: [`Family::rays`].
    Rays,
    /// Bases: [`Family::bases`].
    Bases,
    /// Whole pictures: [`Family::frames`].
    Frames,
}

/// The way a case is made, from its random numbers and the knob.
type Make<C> = fn(&mut Draw, f64) -> C;

#[derive(Clone, Copy, Debug)]
enum AnyMake {
    Ray(Make<RayCase>),
    Basis(Make<BasisCase>),
    Frame(Make<FrameCase>),
}

/// Cases that are hard for one reason, and a knob for how hard.
///
/// A case is made from the seed, the family's name, the knob and the case's number: the same on every
/// machine, and the first cases of many are those of few.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    name: &'static str,
    about: &'static str,
    knob_name: &'static str,
    knobs: &'static [f64],
    make: AnyMake,
}

type Text = &'static str;
type Knobs = &'static [f64];

/// A family of any rays.
pub(super) const fn rays(
    name: Text,
    about: Text,
    knob_name: Text,
    knobs: Knobs,
    make: Make<RayCase>,
) -> Family {
    Family { name, about, knob_name, knobs, make: AnyMake::Ray(make) }
}

/// A family of bases.
pub(super) const fn bases(
    name: Text,
    about: Text,
    knob_name: Text,
    knobs: Knobs,
    make: Make<BasisCase>,
) -> Family {
    Family { name, about, knob_name, knobs, make: AnyMake::Basis(make) }
}

/// A family of whole pictures.
pub(super) const fn frames(
    name: Text,
    about: Text,
    knob_name: Text,
    knobs: Knobs,
    make: Make<FrameCase>,
) -> Family {
    Family { name, about, knob_name, knobs, make: AnyMake::Frame(make) }
}

pub(super) const ULPS: [f64; 3] = [-1.0, 0.0, 1.0];
pub(super) const OFFSETS: [f64; 4] = [3.0, 6.0, 9.0, 12.0];
pub(super) const TO_ROUNDING: [f64; 8] = [-16.0, -14.0, -12.0, -10.0, -8.0, -6.0, -3.0, -1.0];
pub(super) const SMALL: [f64; 6] = [-12.0, -10.0, -8.0, -6.0, -3.0, -1.0];
pub(super) const PLANETS: [f64; 6] = [3.0, 4.0, 5.0, 6.0, 7.0, 8.0];

impl Family {
    /// Its name, in kebab-case.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Returns what its cases have in common, in a sentence.
    pub fn about(&self) -> &'static str {
        self.about
    }

    /// Returns what the knob is, with its unit.
    pub fn knob_name(&self) -> &'static str {
        self.knob_name
    }

    /// The knob's values, in rising order.
    pub fn knobs(&self) -> &'static [f64] {
        self.knobs
    }

    /// Returns the kind of its cases.
    pub fn kind(&self) -> Kind {
        match self.make {
            AnyMake::Ray(_) => Kind::Rays,
            AnyMake::Basis(_) => Kind::Bases,
            AnyMake::Frame(_) => Kind::Frames,
        }
    }

    /// Cases of a family of rays for one of its [knobs](Family::knobs); none of another family. With
    /// `single`, all numbers are exact in `f32`, units in the last place are those of `f32`, and
    /// powers of ten beyond its range are brought into it.
    pub fn rays(&self, knob: f64, seed: u64, count: usize, single: bool) -> Vec<RayCase> {
        let AnyMake::Ray(make) = self.make else { return Vec::new() };
        let given = |mut draw: Draw| {
            let RayCase { objects, origin, direction } = make(&mut draw, knob);
            RayCase {
                objects: objects.into_iter().map(|object| object.given(&draw)).collect(),
                origin: draw.given3(origin),
                direction: draw.given3(direction),
            }
        };
        self.draws(knob, seed, count, single).map(given).collect()
    }

    /// Cases of a family of bases, as [`Family::rays`] says.
    pub fn bases(&self, knob: f64, seed: u64, count: usize, single: bool) -> Vec<BasisCase> {
        let AnyMake::Basis(make) = self.make else { return Vec::new() };
        let given = |mut draw: Draw| {
            let BasisCase { eye, orientation } = make(&mut draw, knob);
            BasisCase { eye: draw.given3(eye), orientation: orientation.map(|v| draw.given3(v)) }
        };
        self.draws(knob, seed, count, single).map(given).collect()
    }

    /// Cases of a family of frames, as [`Family::rays`] says.
    pub fn frames(&self, knob: f64, seed: u64, count: usize, single: bool) -> Vec<FrameCase> {
        let AnyMake::Frame(make) = self.make else { return Vec::new() };
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
        self.draws(knob, seed, count, single).map(given).collect()
    }

    fn draws(
        &self,
        knob: f64,
        seed: u64,
        count: usize,
        single: bool,
    ) -> impl Iterator<Item = Draw> {
        let name = self.name;
        (0..count).map(move |index| Draw::new(seed, name, knob, index, single))
    }
}

impl Object {
    /// Returns it with other places, normals and radii.
    pub(super) fn map(
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

    /// All its lengths multiplied.
    pub(super) fn scaled(self, scale: f64) -> Object {
        self.map(|v| v.map(|x| x * scale), |normal| normal, |radius| radius * scale)
    }
}

impl Orientation {
    fn map(self, given: impl Fn([f64; 3]) -> [f64; 3]) -> Orientation {
        match self {
            Orientation::At { at, up } => Orientation::At { at: given(at), up: given(up) },
            Orientation::View { view, up } => {
                Orientation::View { view: given(view), up: given(up) }
            }
            Orientation::Basis { u, v, w } => {
                Orientation::Basis { u: given(u), v: given(v), w: given(w) }
            }
        }
    }
}

impl FrameCase {
    /// The same picture with other places and radii.
    pub(super) fn map(
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

    /// All lengths of the world multiplied, not those of the viewport: t alone changes.
    pub(super) fn scaled(self, scale: f64) -> FrameCase {
        self.map(|v| v.map(|x| x * scale), |radius| radius * scale)
    }
}
