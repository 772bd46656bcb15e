//! Families of difficult rays, each with a parameter, its knob, that sets how difficult they are.

mod draw;
mod rays;

pub use draw::{Draw, decade, moved_by_ulps};

use std::sync::LazyLock;

use self::draw::scaled;
use crate::object::Object;

/// A single ray, and the objects to intersect it with.
#[derive(Clone, Debug, PartialEq)]
pub struct RayCase {
    /// Spheres first, then planes.
    pub objects: Vec<Object>,
    /// The point at which the ray starts.
    pub origin: [f64; 3],
    /// The ray's direction, not normalized.
    pub direction: [f64; 3],
}

/// Cases that are difficult for the same reason, with a parameter, the knob, that sets how difficult
/// they are.
///
/// A case is determined by the seed, the family's name, the value of the knob, and the case's number.
/// It is the same on every machine, however many cases are requested.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// The family's name, in kebab-case.
    pub name: &'static str,
    /// A sentence that says what the family's cases have in common.
    pub about: &'static str,
    /// The knob's meaning, with its unit.
    pub knob_name: &'static str,
    /// The knob's values, in ascending order.
    pub knobs: &'static [f64],
    /// The function that makes a case.
    make: fn(&mut Draw, f64) -> RayCase,
}

const ULPS: [f64; 3] = [-1.0, 0.0, 1.0];
const OFFSETS: [f64; 4] = [3.0, 6.0, 9.0, 12.0];
const TO_ROUNDING: [f64; 8] = [-16.0, -14.0, -12.0, -10.0, -8.0, -6.0, -3.0, -1.0];
const SMALL: [f64; 6] = [-12.0, -10.0, -8.0, -6.0, -3.0, -1.0];
const PLANETS: [f64; 6] = [3.0, 4.0, 5.0, 6.0, 7.0, 8.0];

/// A family: its name, the meaning of its knob (the parameter that sets the difficulty), the knob's
/// values, and the function that makes a case.
type FamilyRow = (&'static str, &'static str, &'static [f64], fn(&mut Draw, f64) -> RayCase);

/// For each family's name, a sentence that says what its cases have in common.
const ABOUT: [(&str, &str); 23] = [
    ("ordinary", "A sphere of everyday size, seen from a few radii away."),
    ("course-floor", "The course's floor: a sphere of radius 5000 whose top is 1 below the eye."),
    ("several", "Spheres and planes of everyday size: which one is first?"),
    ("tiny-far", "A sphere tiny for its distance: what decides is lost in squares subtracted."),
    ("planet", "The eye 0.001 to 10 above a huge sphere: its height is lost in squares."),
    ("grazing", "A line that passes the sphere's outline closely, inside or outside."),
    ("tangent", "A line that touches the sphere exactly, and radii one ulp beside."),
    (
        "eye-near-surface",
        "The eye just above or below the surface: is the near root ahead or behind?",
    ),
    (
        "eye-on-surface",
        "The eye exactly on the surface, where t = 0 is no hit, and radii one ulp beside.",
    ),
    ("eye-inside", "The eye inside the sphere, up to its centre: the far root is seen."),
    ("direction-length", "An everyday sphere and a direction far from length 1."),
    ("world-offset", "An everyday sphere and ray, far from the world's origin."),
    ("extreme-range", "Lengths, direction or both so large or small that squares leave the range."),
    ("mixed-range", "Eye, centre, radius, direction of any sizes from the largest to its inverse."),
    ("near-parallel-plane", "A ray at a small angle to a plane: n·d nearly cancels."),
    ("parallel-plane", "A ray parallel to a plane, in it or beside it, and normals one ulp off."),
    ("plane-offset", "An everyday plane and ray, far from the world's origin."),
    (
        "plane-range",
        "Normal, direction or lengths so large or small that products leave the range.",
    ),
    ("ties-concentric", "Two spheres with the same centre, alike or an ulp apart: which is first?"),
    (
        "ties-touching-inside",
        "A sphere that touches another from inside, and a ray through the contact.",
    ),
    ("ties-touching-outside", "Spheres that touch from outside, and a ray through the contact."),
    ("ties-sphere-plane", "A plane that touches a sphere, and a ray through the contact."),
    ("ties-planes", "The same plane twice, or planes that cross where the ray goes."),
];

static ALL: LazyLock<Vec<Family>> = LazyLock::new(|| {
    let family = |(name, knob_name, knobs, make)| {
        let about = ABOUT.iter().find(|(known, _)| *known == name).map_or("", |(_, about)| about);
        Family { name, about, knob_name, knobs, make }
    };
    rays::FAMILIES.into_iter().map(family).collect()
});

impl Family {
    /// Returns all families.
    pub fn all() -> impl Iterator<Item = &'static Family> {
        ALL.iter()
    }

    /// Returns the family with this name; `None` if there is none.
    pub fn named(name: &str) -> Option<&'static Family> {
        Family::all().find(|family| family.name == name)
    }

    /// Returns the first `count` cases for one value of the [knob](Family::knobs).
    pub fn rays(&self, knob: f64, seed: u64, count: usize) -> Vec<RayCase> {
        let case = |mut draw: Draw| (self.make)(&mut draw, knob);
        Draw::cases(seed, self.name, knob, count).map(case).collect()
    }
}

impl Object {
    /// Returns the object with its points, its normal and its radius mapped by these functions.
    #[must_use]
    pub fn map(
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
}

impl RayCase {
    /// Returns the case with all lengths multiplied by `scale`, and the direction multiplied by
    /// `stretch`.
    fn scaled(self, scale: f64, stretch: f64) -> RayCase {
        let length = |v| scaled(v, scale);
        let objects = self.objects.into_iter();
        RayCase {
            objects: objects.map(|object| object.map(length, |n| n, |r| r * scale)).collect(),
            origin: length(self.origin),
            direction: scaled(self.direction, stretch),
        }
    }
}
