//! A scene: spheres, then planes, and what a ray meets of them.

use std::fmt;

use glam::DVec3;

use crate::exact_ray::ExactRay;
use crate::number::{shortest, triple};
use crate::plane::Plane;
use crate::ray::Ray;
use crate::roots::Roots;
use crate::seen::{Hit, ObjectSeen};
use crate::sphere::Sphere;
use crate::sphere_seen::{End, SphereSeen};
use crate::steps::{Step, Steps};

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
    /// A checked sphere, from whatever makes a [`DVec3`].
    ///
    /// # Errors
    /// Where the centre is not finite or the radius not positive and finite.
    ///
    /// ```
    /// use pinhole_core::*;
    /// let ball = Sphere::new([0.0, 0.0, -5.0], 1.0)?;
    /// let (center, radius) = ([0.5_f32, 0.0, -5.0], 1.5_f32);
    /// let of_f32 = Sphere::new(center.map(f64::from), f64::from(radius))?;
    /// assert_eq!(of_f32.center.x, 0.5);
    /// assert_eq!(Sphere::new([0.0; 3], -1.0), Err(ObjectError::Radius { value: -1.0 }));
    /// # assert_eq!(ball.radius, 1.0);
    /// # Ok::<(), ObjectError>(())
    /// ```
    pub fn new(center: impl Into<DVec3>, radius: f64) -> Result<Sphere, ObjectError> {
        let sphere = Sphere { center: center.into(), radius };
        sphere.check().map(|()| sphere)
    }

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
    /// A checked plane through a point, at right angles to a normal of any length, from whatever
    /// makes a [`DVec3`].
    ///
    /// # Errors
    /// Where a coordinate is not finite or the normal is zero.
    ///
    /// ```
    /// use pinhole_core::*;
    /// let wall = Plane::new([0.0, 0.0, -6.0], [0.0, 0.0, 1.0])?;
    /// let normal = [0.0_f32, 0.0, 0.1];
    /// let of_f32 = Plane::new([0.0, 0.0, -6.0], normal.map(f64::from))?;
    /// assert!(of_f32.is_same(&wall));
    /// assert_eq!(Plane::new([0.0; 3], [0.0; 3]), Err(ObjectError::NormalIsZero));
    /// # Ok::<(), ObjectError>(())
    /// ```
    pub fn new(point: impl Into<DVec3>, normal: impl Into<DVec3>) -> Result<Plane, ObjectError> {
        let plane = Plane { point: point.into(), normal: normal.into() };
        plane.check().map(|()| plane)
    }

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
    /// `t` in the order of objects. A tangent's double root stands once. Order and ties are exact,
    /// for the numbers as given; a ray that does not pass [`Ray::check`] has no roots.
    pub fn roots(&self, ray: &Ray) -> Vec<Root> {
        ExactRay::of(ray).map_or_else(|_| Vec::new(), |ray| self.roots_of(&ray))
    }

    /// [`Scene::roots`] of a ray with all its digits: a camera's view ray, or any other.
    pub fn roots_of(&self, ray: &ExactRay) -> Vec<Root> {
        let seen: Vec<ObjectSeen> = self.seen_by(ray).collect();
        let steps = &mut Steps::default();
        let mut hits = Vec::new();
        for (index, seen) in (0..).zip(&seen) {
            hits.extend(seen.ends(ray, steps).iter().map(|&end| Hit { index, seen, end }));
        }
        // Stable, so that equal roots stay in the order of objects.
        hits.sort_by(|a, b| a.compare(b, ray, steps));
        hits.iter().map(|hit| hit.root(ray)).collect()
    }

    /// The first hit: the root with the smallest `t > 0`; of equal ones, the object listed first.
    /// Exact for the numbers as given; a ray that does not pass [`Ray::check`] hits nothing.
    pub fn first_hit(&self, ray: &Ray) -> Option<Root> {
        self.first_hit_of(&ExactRay::of(ray).ok()?)
    }

    /// [`Scene::first_hit`] of a ray with all its digits: a camera's view ray, or any other.
    pub fn first_hit_of(&self, ray: &ExactRay) -> Option<Root> {
        self.first_hit_counting(ray, &mut Steps::default())
    }

    /// [`Scene::first_hit_of`], which adds its decisions to `steps`.
    pub fn first_hit_counting(&self, ray: &ExactRay, steps: &mut Steps) -> Option<Root> {
        let mut first: Option<(u32, ObjectSeen, End)> = None;
        // At least the first hit's t, as far as it is known.
        let mut nearest = f64::INFINITY;
        for (index, object) in (0..).zip(self.objects()) {
            if let Object::Sphere(sphere) = &object
                && SphereSeen::is_passed(sphere, ray, nearest)
            {
                steps.count(Step::F64);
                continue;
            }
            let seen = ObjectSeen::by(&object, ray);
            if seen.side_step() > Step::F64 {
                steps.count(seen.side_step());
            }
            let Some(end) = seen.first_end(ray, steps) else { continue };
            let is_first = first.as_ref().is_none_or(|(first_index, first_seen, first_end)| {
                let first = Hit { index: *first_index, seen: first_seen, end: *first_end };
                Hit { index, seen: &seen, end }.is_before(&first, ray, steps)
            });
            if is_first {
                nearest = seen.rough_t(ray, end).map_or(f64::INFINITY, |(t, off)| t + off * t);
                first = Some((index, seen, end));
            }
        }
        first.map(|(index, seen, end)| seen.root(index, ray, end))
    }

    fn seen_by(&self, ray: &ExactRay) -> impl Iterator<Item = ObjectSeen> {
        self.objects().map(|object| ObjectSeen::by(&object, ray))
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

    /// Checks what [`Scene::new`] checks.
    ///
    /// # Errors
    /// What is wrong.
    pub fn check(&self) -> Result<(), ObjectError> {
        match self {
            Object::Sphere(sphere) => sphere.check(),
            Object::Plane(plane) => plane.check(),
        }
    }

    /// The first hit of the ray with this object alone, which is given `index`; none of an object
    /// that does not pass [`Object::check`].
    pub fn first_hit(&self, index: u32, ray: &ExactRay) -> Option<Root> {
        self.check().ok()?;
        let seen = ObjectSeen::by(self, ray);
        let end = seen.first_end(ray, &mut Steps::default())?;
        Some(seen.root(index, ray, end))
    }

    /// The implicit function, see [`Sphere::implicit`] and [`Plane::implicit`].
    pub fn implicit(&self, q: DVec3) -> f64 {
        match self {
            Object::Sphere(sphere) => sphere.implicit(q),
            Object::Plane(plane) => plane.implicit(q),
        }
    }
}
