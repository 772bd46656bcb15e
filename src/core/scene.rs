//! A scene: spheres, then planes, and what a ray meets of them.

use std::cmp::Ordering;
use std::fmt;

use glam::DVec3;

use crate::number::{shortest, triple};
use crate::plane::Plane;
use crate::ray::Ray;
use crate::roots::Roots;
use crate::scale::{is_plain_direction, unit};
use crate::sphere::Sphere;

/// Checked spheres and planes. Objects are counted from 0: the spheres in order, then the planes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    spheres: Vec<Sphere>,
    planes: Vec<Plane>,
}

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
    /// Where on the ray, in units of the direction's length; may be negative or 0.
    pub t: f64,
    /// Where in the world.
    pub point: DVec3,
    /// The outward unit normal there.
    pub normal: DVec3,
}

/// What is wrong with one object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ObjectError {
    /// A coordinate of `center`, `point` or `normal` is NaN or infinite.
    NotFinite {
        /// The field's name.
        field: &'static str,
        /// The value.
        value: DVec3,
    },
    /// A radius that is not a positive, finite number.
    Radius {
        /// The value.
        value: f64,
    },
    /// A plane's normal is `(0, 0, 0)`.
    NormalIsZero,
}

/// Which object of a scene is at fault, and why.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SceneError {
    /// A sphere.
    Sphere {
        /// Its index among all objects: spheres first.
        index: usize,
        /// What is wrong with it.
        error: ObjectError,
    },
    /// A plane.
    Plane {
        /// Its index among all objects: spheres first.
        index: usize,
        /// What is wrong with it.
        error: ObjectError,
    },
}

impl fmt::Display for ObjectError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ObjectError::NotFinite { field, value } => {
                write!(f, "{field} is {}: every coordinate must be a finite number", triple(*value))
            }
            ObjectError::Radius { value } => {
                write!(f, "radius is {}: it must be finite and greater than 0", shortest(*value))
            }
            ObjectError::NormalIsZero => write!(f, "normal is (0, 0, 0): it must point somewhere"),
        }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneError::Sphere { index, error } => write!(f, "sphere {index}: {error}"),
            SceneError::Plane { index, error } => write!(f, "plane {index}: {error}"),
        }
    }
}

impl std::error::Error for ObjectError {}
impl std::error::Error for SceneError {}

impl Sphere {
    /// Checks that the centre is finite and the radius positive and finite.
    ///
    /// # Errors
    /// What is wrong.
    pub fn check(&self) -> Result<(), ObjectError> {
        if !self.center.is_finite() {
            return Err(ObjectError::NotFinite { field: "center", value: self.center });
        }
        if !(self.radius.is_finite() && self.radius > 0.0) {
            return Err(ObjectError::Radius { value: self.radius });
        }
        Ok(())
    }
}

impl Plane {
    /// Checks that point and normal are finite and the normal is not zero.
    ///
    /// # Errors
    /// What is wrong.
    pub fn check(&self) -> Result<(), ObjectError> {
        for (field, value) in [("point", self.point), ("normal", self.normal)] {
            if !value.is_finite() {
                return Err(ObjectError::NotFinite { field, value });
            }
        }
        if self.normal == DVec3::ZERO {
            return Err(ObjectError::NormalIsZero);
        }
        Ok(())
    }
}

impl Scene {
    /// A scene of these objects.
    ///
    /// # Errors
    /// The first object that is none: a centre, point or normal that is not finite, a radius that is
    /// not positive, a normal of zero.
    pub fn new(spheres: Vec<Sphere>, planes: Vec<Plane>) -> Result<Scene, SceneError> {
        for (index, sphere) in spheres.iter().enumerate() {
            sphere.check().map_err(|error| SceneError::Sphere { index, error })?;
        }
        for (index, plane) in planes.iter().enumerate() {
            let index = spheres.len() + index;
            plane.check().map_err(|error| SceneError::Plane { index, error })?;
        }
        Ok(Scene { spheres, planes })
    }

    /// The spheres, objects 0, 1, ...
    pub fn spheres(&self) -> &[Sphere] {
        &self.spheres
    }

    /// The planes, the objects after the spheres.
    pub fn planes(&self) -> &[Plane] {
        &self.planes
    }

    /// How many objects there are.
    pub fn len(&self) -> usize {
        self.spheres.len() + self.planes.len()
    }

    /// Whether there is no object.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The object of this index, if there is one.
    pub fn object(&self, index: u32) -> Option<Object> {
        let index = index as usize;
        match self.spheres.get(index) {
            Some(sphere) => Some(Object::Sphere(*sphere)),
            None => self.planes.get(index - self.spheres.len()).copied().map(Object::Plane),
        }
    }

    /// All objects, spheres first.
    pub fn objects(&self) -> impl Iterator<Item = Object> + '_ {
        let spheres = self.spheres.iter().copied().map(Object::Sphere);
        spheres.chain(self.planes.iter().copied().map(Object::Plane))
    }

    /// Every root of every object along the ray's line, negative ones too, by ascending `t`; equal
    /// `t` in the order of objects. A tangent's double root stands once.
    pub fn roots(&self, ray: &Ray) -> Vec<Root> {
        let mut roots: Vec<Root> = (0..)
            .zip(self.objects())
            .flat_map(|(index, object)| {
                object.roots(ray).iter().map(move |t| object.root(index, ray, t))
            })
            .collect();
        roots.sort_by(|a, b| a.t.partial_cmp(&b.t).unwrap_or(Ordering::Equal));
        roots
    }

    /// The first hit: the root with the smallest `t > 0`; of equal ones, the object listed first.
    pub fn first_hit(&self, ray: &Ray) -> Option<Root> {
        let mut first: Option<(u32, f64, Object)> = None;
        for (index, object) in (0..).zip(self.objects()) {
            if let Some(t) = object.roots(ray).first_positive()
                && first.is_none_or(|(_, nearest, _)| t < nearest)
            {
                first = Some((index, t, object));
            }
        }
        first.map(|(index, t, object)| object.root(index, ray, t))
    }
}

impl Object {
    /// Where the ray's line meets the object.
    pub fn roots(&self, ray: &Ray) -> Roots {
        match self {
            Object::Sphere(sphere) => sphere.roots(ray),
            Object::Plane(plane) => plane.roots(ray),
        }
    }

    /// The implicit function, see [`Sphere::implicit`] and [`Plane::implicit`].
    pub fn implicit(&self, q: DVec3) -> f64 {
        match self {
            Object::Sphere(sphere) => sphere.implicit(q),
            Object::Plane(plane) => plane.implicit(q),
        }
    }

    /// Point and normal of a known root `t`.
    pub fn root(&self, index: u32, ray: &Ray, t: f64) -> Root {
        let (point, normal) = match self {
            Object::Sphere(sphere) => sphere.point_and_normal(ray, t),
            Object::Plane(plane) => plane.point_and_normal(ray, t),
        };
        Root { object: index, t, point, normal }
    }
}

/// The outward normals of a scene's objects, for many hits.
pub(crate) struct Normals<'a> {
    spheres: &'a [Sphere],
    of_planes: Vec<DVec3>,
}

impl<'a> Normals<'a> {
    pub(crate) fn new(scene: &'a Scene) -> Self {
        let of_planes = scene.planes.iter().map(|plane| unit(plane.normal)).collect();
        Normals { spheres: &scene.spheres, of_planes }
    }

    /// The outward unit normal where the ray meets the object at the root `t`, as
    /// [`Object::root`] gives it; zero for an object that the scene does not have.
    #[inline(always)]
    pub(crate) fn at(&self, object: u32, ray: &Ray, t: f64) -> DVec3 {
        let index = object as usize;
        match self.spheres.get(index) {
            Some(sphere) => sphere.normal(ray, t),
            None => self.of_planes.get(index - self.spheres.len()).copied().unwrap_or_default(),
        }
    }

    /// `|n.d| / |d|` of the same normal n. Not by way of [`Normals::at`], because a vector that
    /// either arm may make goes through memory, which costs more than all the arithmetic.
    #[inline(always)]
    pub(crate) fn cosine(&self, object: u32, ray: &Ray, t: f64) -> f64 {
        let (index, direction) = (object as usize, ray.direction);
        match self.spheres.get(index) {
            Some(sphere) => sphere.cosine(ray, t),
            None => match self.of_planes.get(index - self.spheres.len()) {
                Some(normal) if is_plain_direction(direction) => {
                    normal.dot(direction).abs() / direction.length()
                }
                Some(normal) => normal.dot(unit(direction)).abs(),
                None => 0.0,
            },
        }
    }
}
