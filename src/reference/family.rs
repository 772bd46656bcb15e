//! The families of cases that are hard, each with a knob that makes it harder.

use crate::camera::{Camera, Orientation};
use crate::draw::Draw;
use crate::object::Object;
use crate::{bases, frames, planes, spheres, ties};

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
    /// Its place.
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

/// A case of a family.
#[derive(Clone, Debug, PartialEq)]
pub enum Case {
    /// See [`RayCase`].
    Ray(RayCase),
    /// See [`BasisCase`].
    Basis(BasisCase),
    /// See [`FrameCase`].
    Frame(FrameCase),
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
#[derive(Clone, Copy, Debug)]
pub(crate) enum Make {
    Ray(fn(&mut Draw, f64) -> RayCase),
    Basis(fn(&mut Draw, f64) -> BasisCase),
    Frame(fn(&mut Draw, f64) -> FrameCase),
}

/// Cases that are hard for one reason, and a knob for how hard.
///
/// A case is made from the seed, the family's name, the knob and the case's number: the same on every
/// machine, and the first cases of many are those of few.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    pub(crate) name: &'static str,
    pub(crate) about: &'static str,
    pub(crate) knob_name: &'static str,
    pub(crate) knobs: &'static [f64],
    pub(crate) make: Make,
}

/// All families of any rays, then of bases, then of frames.
static ALL: [&[Family]; 5] =
    [&spheres::FAMILIES, &planes::FAMILIES, &ties::FAMILIES, &bases::FAMILIES, &frames::FAMILIES];

impl Family {
    /// All of them: first those of rays, then of bases, then of frames.
    pub fn all() -> impl Iterator<Item = &'static Family> {
        ALL.into_iter().flatten()
    }

    /// The family of this name.
    pub fn named(name: &str) -> Option<&'static Family> {
        Family::all().find(|family| family.name == name)
    }

    /// Its name, in kebab-case.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Returns what is hard about it, in one sentence.
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
            Make::Ray(_) => Kind::Rays,
            Make::Basis(_) => Kind::Bases,
            Make::Frame(_) => Kind::Frames,
        }
    }

    /// Cases for one of its [knobs](Family::knobs). With `single`, all numbers are exact in `f32`,
    /// units in the last place are those of `f32`, and powers of ten beyond its range are brought
    /// into it.
    pub fn cases(&self, knob: f64, seed: u64, count: usize, single: bool) -> Vec<Case> {
        let rays = self.rays(knob, seed, count, single).into_iter().map(Case::Ray);
        let bases = self.bases(knob, seed, count, single).into_iter().map(Case::Basis);
        let frames = self.frames(knob, seed, count, single).into_iter().map(Case::Frame);
        rays.chain(bases).chain(frames).collect()
    }

    /// [`Family::cases`] of a family of rays; none of another.
    pub fn rays(&self, knob: f64, seed: u64, count: usize, single: bool) -> Vec<RayCase> {
        let Make::Ray(make) = self.make else { return Vec::new() };
        self.draws(knob, seed, count, single)
            .map(|mut draw| make(&mut draw, knob).given(&draw))
            .collect()
    }

    /// [`Family::cases`] of a family of bases; none of another.
    pub fn bases(&self, knob: f64, seed: u64, count: usize, single: bool) -> Vec<BasisCase> {
        let Make::Basis(make) = self.make else { return Vec::new() };
        self.draws(knob, seed, count, single)
            .map(|mut draw| make(&mut draw, knob).given(&draw))
            .collect()
    }

    /// [`Family::cases`] of a family of frames; none of another.
    pub fn frames(&self, knob: f64, seed: u64, count: usize, single: bool) -> Vec<FrameCase> {
        let Make::Frame(make) = self.make else { return Vec::new() };
        self.draws(knob, seed, count, single)
            .map(|mut draw| make(&mut draw, knob).given(&draw))
            .collect()
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
    fn given(self, draw: &Draw) -> Object {
        match self {
            Object::Sphere { center, radius } => {
                Object::Sphere { center: draw.given3(center), radius: draw.given(radius) }
            }
            Object::Plane { point, normal } => {
                Object::Plane { point: draw.given3(point), normal: draw.given3(normal) }
            }
        }
    }
}

impl RayCase {
    fn given(self, draw: &Draw) -> RayCase {
        RayCase {
            objects: self.objects.into_iter().map(|object| object.given(draw)).collect(),
            origin: draw.given3(self.origin),
            direction: draw.given3(self.direction),
        }
    }
}

impl Orientation {
    fn given(self, draw: &Draw) -> Orientation {
        let given = |v| draw.given3(v);
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

impl BasisCase {
    fn given(self, draw: &Draw) -> BasisCase {
        BasisCase { eye: draw.given3(self.eye), orientation: self.orientation.given(draw) }
    }
}

impl FrameCase {
    fn given(self, draw: &Draw) -> FrameCase {
        let camera = Camera {
            eye: draw.given3(self.camera.eye),
            orientation: self.camera.orientation.given(draw),
            width: draw.given(self.camera.width),
            height: draw.given(self.camera.height),
            distance: draw.given(self.camera.distance),
            ..self.camera
        };
        FrameCase {
            camera,
            objects: self.objects.into_iter().map(|object| object.given(draw)).collect(),
        }
    }
}
