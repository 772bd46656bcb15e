//! A scene of spheres and planes, and the points at which rays meet them: roots and first hits.

pub(crate) mod along_ray;
pub(crate) mod big_roots;
pub(crate) mod certificate;
pub(crate) mod error;
pub(crate) mod object;
pub(crate) mod object_from_origin;
pub(crate) mod objects_from_origin;
pub(crate) mod pair_order;
pub(crate) mod plane;
pub(crate) mod plane_predicates;
pub(crate) mod sphere;
pub(crate) mod sphere_index;
pub(crate) mod sphere_predicates;

use std::cmp::Ordering;
use std::sync::Arc;

use glam::DVec3;

use crate::camera::ray::{ExactRay, Ray};
use crate::exact::steps::Steps;
use crate::scene::error::SceneError;
use crate::scene::object::{Object, RankedRoot, Root};
use crate::scene::object_from_origin::Hit;
use crate::scene::objects_from_origin::{Line, ObjectsFromOrigin};
use crate::scene::plane::Plane;
use crate::scene::sphere::Sphere;
use crate::scene::sphere_index::{SphereIndex, Spheres};
use crate::scene::sphere_predicates::RootSide;

/// Checked spheres and planes. Objects are counted from 0: the spheres in order, then the planes.
///
/// The first frame of a scene with many spheres builds a spatial index over them, which the scene
/// keeps. Clones share the spheres and the spatial index, so cloning copies only the planes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    spheres: Arc<Spheres>,
    planes: Vec<Plane>,
}

impl Scene {
    /// Creates a scene of these objects.
    ///
    /// # Errors
    /// Returns an error that names the first invalid object: one with a centre, point or normal that is
    /// not finite, a radius that is not positive and finite, or a normal of zero.
    pub fn new(spheres: Vec<Sphere>, planes: Vec<Plane>) -> Result<Scene, SceneError> {
        Scene::of_shared(Arc::new(spheres), planes)
    }

    /// Creates a scene of these objects like [`Scene::new`]. The spheres stay shared, and are copied only if one
    /// of them is [replaced](Scene::replace).
    ///
    /// # Errors
    /// Returns the errors of [`Scene::new`].
    pub fn of_shared(spheres: Arc<Vec<Sphere>>, planes: Vec<Plane>) -> Result<Scene, SceneError> {
        let objects = spheres.iter().copied().map(Object::Sphere);
        let objects = objects.chain(planes.iter().copied().map(Object::Plane));
        for (index, object) in objects.enumerate() {
            object.check_at(index)?;
        }
        Ok(Scene { spheres: Arc::new(Spheres::new(spheres)), planes })
    }

    /// Returns the scene without its planes. The spheres are shared, not copied.
    #[must_use]
    pub fn without_planes(&self) -> Scene {
        Scene { spheres: Arc::clone(&self.spheres), planes: Vec::new() }
    }

    /// Replaces the object with this index by another one of the same kind. Objects are counted from
    /// 0, the spheres first, then the planes.
    ///
    /// This takes about a microsecond, however many spheres there are: if the spatial index over the
    /// spheres has been built, it is updated, not built again. But if clones of this scene exist when
    /// a sphere is replaced, all spheres and the spatial index are copied first (80 bytes per sphere),
    /// so that the clones do not change.
    ///
    /// # Errors
    /// Returns an error if the new object is invalid; the scene is then unchanged.
    ///
    /// # Panics
    /// Panics if no object of this kind has this index.
    ///
    /// ```
    /// use pinhole_core::*;
    /// let ball = Sphere::new([0.0, 0.0, -5.0], 1.0)?;
    /// let mut scene = Scene::new(vec![ball], vec![])?;
    /// scene.replace(0, Object::Sphere(Sphere { radius: 2.0, ..ball }))?;
    /// assert_eq!(scene.first_hit(&Ray::new([0.0; 3], [0.0, 0.0, -1.0])?).unwrap().t, 3.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn replace(&mut self, index: u32, object: Object) -> Result<(), SceneError> {
        let k = index as usize;
        object.check_at(k)?;
        let before = self.spheres().len();
        match object {
            Object::Sphere(sphere) => Arc::make_mut(&mut self.spheres).replace(index, sphere),
            Object::Plane(plane) => self.planes[k - before] = plane,
        }
        Ok(())
    }

    /// Returns the spheres. Their indices are 0, 1, ...
    pub fn spheres(&self) -> &[Sphere] {
        &self.spheres.list
    }

    /// Returns the spatial index over the spheres, or `None` if there are fewer than
    /// [`INDEX_FROM`](crate::scene::sphere_index::INDEX_FROM). The first call builds the spatial index
    /// in parallel. It must not be made from within parallel work: while a thread waits, it may take
    /// other work, and could then call this function again.
    pub(crate) fn index(&self) -> Option<&SphereIndex> {
        self.spheres.index()
    }

    /// Returns the indices of the spheres that strictly contain a point, in ascending order. The
    /// decisions are exact. With a spatial index, only spheres near the point are examined.
    pub fn spheres_around(&self, point: DVec3) -> Vec<u32> {
        let position = point.to_array();
        // Rounding keeps order: if a rounded difference is above `half`, so is the exact one.
        let mut around = self.spheres_where(|middle, half| {
            (0..3).all(|axis| (position[axis] - middle[axis]).abs() <= half[axis])
        });
        around.retain(|index| self.spheres()[*index as usize].implicit(point) < 0.0);
        around
    }

    /// Returns the indices of the spheres near the ray's line, in ascending order, possibly with a few
    /// others. A sphere is near if its distance from the line is less than `share` times a sum of
    /// sizes: the absolute coordinates of the ray's origin and of the vector to the sphere, and the
    /// radius.
    pub fn spheres_near(&self, ray: &ExactRay, share: f64) -> Vec<u32> {
        let (line, origin) = (Line::from_ray(ray), ray.origin().to_array());
        self.spheres_where(|middle, half| {
            let reach: f64 =
                (0..3).map(|i| (middle[i] - origin[i]).abs() + half[i] + origin[i].abs()).sum();
            line.may_meet(middle, half.map(|half| half + 2.0 * share * reach))
        })
    }

    /// Builds the spatial index over the spheres, if there are many; otherwise the first query builds
    /// it. Call this function before parallel work whose parts query the spatial index: a thread that
    /// waits for it could otherwise start another part, and query it again.
    pub fn make_index(&self) {
        let _ = self.index();
    }

    /// Returns the planes, whose indices follow those of the spheres.
    pub fn planes(&self) -> &[Plane] {
        &self.planes
    }

    /// Returns the number of objects.
    pub fn len(&self) -> usize {
        self.spheres().len() + self.planes.len()
    }

    /// Returns whether the scene has no objects.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns the object with this index, or `None` if the scene has no such object. Objects are
    /// counted from 0, the spheres first, then the planes.
    pub fn object(&self, index: u32) -> Option<Object> {
        let index = index as usize;
        match self.spheres().get(index) {
            Some(sphere) => Some(Object::Sphere(*sphere)),
            None => self.planes.get(index - self.spheres().len()).copied().map(Object::Plane),
        }
    }

    /// Returns all objects, spheres first.
    pub fn objects(&self) -> impl Iterator<Item = Object> + '_ {
        let spheres = self.spheres().iter().copied().map(Object::Sphere);
        spheres.chain(self.planes.iter().copied().map(Object::Plane))
    }

    /// Returns every root of every object along the ray's line, even behind the origin, each with its
    /// rank and its distance. The roots are in ascending order of `t`; roots at equal `t` are in the
    /// order of the objects. A tangent's double root is listed once. Order and ties are decided exactly
    /// for the given numbers.
    pub fn ranked_roots_of(&self, ray: &ExactRay) -> Vec<RankedRoot> {
        let line = Line::from_ray(ray);
        let spheres = self.spheres_where(|middle, half| line.may_meet(middle, half));
        let planes = self.spheres().len() as u32..self.len() as u32;
        let objects = ObjectsFromOrigin::for_one_ray(self, ray);
        let steps = &mut Steps::default();
        let mut hits = Vec::new();
        for index in spheres.into_iter().chain(planes) {
            let Some(object) = objects.get(index) else { continue };
            let hit = |&root: &RootSide| Hit { index, object: object.clone(), root };
            hits.extend(object.root_sides(ray, steps).iter().map(hit));
        }
        // Stable, so that equal roots stay in the order of objects.
        hits.sort_by(|a, b| a.compare(b, ray, steps));
        let mut rank = 0;
        let mut ranked = Vec::with_capacity(hits.len());
        for (k, hit) in hits.iter().enumerate() {
            if k > 0 && hits[k - 1].compare(hit, ray, steps) != Ordering::Equal {
                rank += 1;
            }
            ranked.push(RankedRoot { root: hit.root(ray), rank, distance: hit.distance(ray) });
        }
        ranked
    }

    /// Returns the first hit: the root with the smallest `t > 0`; if several have this `t`, that of the
    /// object listed first. Returns `None` if nothing is hit. The decision is exact for the given
    /// numbers. A ray that does not pass [`Ray::check`] hits nothing.
    pub fn first_hit(&self, ray: &Ray) -> Option<Root> {
        self.first_hit_of(&ExactRay::from_ray(ray).ok()?)
    }

    /// Returns the [first hit](Scene::first_hit) of an exact ray: a camera's view ray, or any other.
    pub fn first_hit_of(&self, ray: &ExactRay) -> Option<Root> {
        self.first_hit_counting(ray, &mut Steps::default())
    }

    /// Returns the [first hit](Scene::first_hit_of) of an exact ray, and adds the decisions made to
    /// `steps`.
    pub fn first_hit_counting(&self, ray: &ExactRay, steps: &mut Steps) -> Option<Root> {
        let objects = ObjectsFromOrigin::for_one_ray(self, ray);
        Some(objects.first_hit(ray, steps)?.root(ray))
    }

    /// Returns the object that is hit first and its `t`, without point and normal, or `None` if nothing
    /// is hit. Adds the decisions made to `steps`, and one to the count in `steps_of_t` of the step that
    /// computed `t`.
    pub fn first_t_counting(
        &self,
        ray: &ExactRay,
        steps: &mut Steps,
        steps_of_t: &mut Steps,
    ) -> Option<(u32, f64)> {
        let objects = ObjectsFromOrigin::for_one_ray(self, ray);
        let Hit { index, object, root } = objects.first_hit(ray, steps)?;
        Some((index, object.rounded_t(ray, root, steps_of_t)))
    }

    /// Returns, in ascending order, the indices of the spheres whose bounding boxes satisfy `may`,
    /// which is called with the centre and the half extents of a box. If `may` is true for a box, it
    /// must be true for every box that contains that box.
    fn spheres_where(&self, may: impl Fn([f64; 3], [f64; 3]) -> bool) -> Vec<u32> {
        if let Some(index) = self.index() {
            return index.spheres_where(may);
        }
        let may = |sphere: &Sphere| may(sphere.center.to_array(), [sphere.radius; 3]);
        (0..).zip(self.spheres()).filter_map(|(i, sphere)| may(sphere).then_some(i)).collect()
    }
}

#[cfg(test)]
mod tests;
