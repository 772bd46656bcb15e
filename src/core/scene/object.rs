//! An object of a scene, and its roots: the points at which a ray's line meets it.

use std::cmp::Ordering;

use glam::DVec3;

use crate::scene::error::{ObjectError, SceneError};
use crate::scene::plane::Plane;
use crate::scene::sphere::Sphere;

/// One object of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Object {
    /// A sphere.
    Sphere(Sphere),
    /// A plane.
    Plane(Plane),
}

/// One point at which a ray's line meets an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// The object's index in the scene.
    pub object: u32,
    /// Position on the ray, in units of the direction's length. It may be negative or 0.
    pub t: f64,
    /// The root's position in world coordinates.
    pub point: DVec3,
    /// The outward unit normal at the root.
    pub normal: DVec3,
}

/// A root of a ray's line with a scene, and its rank among all of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RankedRoot {
    /// The root.
    pub root: Root,
    /// The root's position when all roots are sorted by ascending `t`, counted from 0; roots at exactly
    /// equal `t` share a rank. Roots at different `t` have different ranks, even if the rounded `t` are
    /// equal.
    pub rank: u32,
    /// `t |d|`, rounded once: the distance of the root from the ray's origin, in world units; negative
    /// behind the origin.
    pub distance: f64,
}

/// The roots of a ray's line with one object, and the side of the object on which the origin lies.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct LineRoots {
    /// The sign of the object's implicit function at the ray's origin: `Less` inside a sphere, `Equal`
    /// on the surface of a sphere or plane.
    pub side: Ordering,
    /// The points at which the line meets the object, by ascending `t`. A tangent's root is listed once.
    pub roots: [Option<Root>; 2],
    /// The index in `roots` of the hit, the smallest `t > 0`; `None` if there is none.
    pub first: Option<usize>,
}

impl Object {
    /// Checks the object like [`Scene::new`](crate::Scene::new).
    ///
    /// # Errors
    /// Returns an error if the object is invalid.
    pub fn check(&self) -> Result<(), ObjectError> {
        match self {
            Object::Sphere(sphere) => sphere.check(),
            Object::Plane(plane) => plane.check(),
        }
    }

    /// Checks the object. `index` is its index among all objects of a scene.
    ///
    /// # Errors
    /// Returns an error that names the object if it is invalid.
    pub fn check_at(&self, index: usize) -> Result<(), SceneError> {
        let kind = if matches!(self, Object::Sphere(_)) { "sphere" } else { "plane" };
        self.check().map_err(|error| SceneError { kind, index, error })
    }
}

/// The roots of a ray's line with a surface, in ascending order. A `t` too large for `f64` (for example,
/// with a direction of length 1e-300 and a sphere at distance 1e10) becomes infinite, with its sign. A
/// `t` too small for `f64` becomes the smallest positive `f64`, with its sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Roots {
    /// The line misses the surface.
    None,
    /// One root: the line touches a sphere, or crosses a plane.
    One(f64),
    /// Two roots.
    Two(f64, f64),
}

impl Roots {
    /// Returns the roots in ascending order.
    pub fn iter(self) -> impl Iterator<Item = f64> {
        let (first, second) = match self {
            Roots::None => (None, None),
            Roots::One(t) => (Some(t), None),
            Roots::Two(t0, t1) => (Some(t0), Some(t1)),
        };
        first.into_iter().chain(second)
    }

    /// Returns the smallest root greater than 0, or `None` if there is none.
    pub fn first_positive(self) -> Option<f64> {
        self.iter().find(|t| *t > 0.0)
    }
}
