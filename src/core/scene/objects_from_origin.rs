//! A scene's objects with the values precomputed for all rays from one origin, and the search for the
//! first object that a ray hits. The search skips objects whose bounding boxes the ray's line certainly
//! misses.

use std::borrow::Cow;
use std::cmp::Ordering;

use glam::DVec3;

use crate::camera::ray::ExactRay;
use crate::exact::bounded::Vector;
use crate::exact::steps::{Step, Steps};
use crate::scene::Scene;
use crate::scene::object::Object;
use crate::scene::object_from_origin::{Hit, ObjectFromOrigin};
use crate::scene::sphere_predicates::SphereFromOrigin;

/// A scene's objects with the values that all rays from one origin share. The values of an object are
/// computed when they are needed or, for many rays, once in advance.
pub(crate) struct ObjectsFromOrigin<'a> {
    pub(crate) scene: &'a Scene,
    origin: DVec3,
    /// The first objects of the scene, with the values computed in advance; empty for a single ray.
    made: Vec<ObjectFromOrigin>,
}

/// Maximum number of objects whose values are computed in advance; for that many, they take some
/// megabytes.
const MOST_MADE: usize = 10_000;

impl<'a> ObjectsFromOrigin<'a> {
    /// Prepares the objects for a single ray.
    pub(crate) fn for_one_ray(scene: &'a Scene, ray: &ExactRay) -> ObjectsFromOrigin<'a> {
        ObjectsFromOrigin { scene, origin: ray.origin(), made: Vec::new() }
    }

    /// Prepares the objects for many rays from one origin.
    pub(crate) fn for_many_rays(scene: &'a Scene, origin: DVec3) -> ObjectsFromOrigin<'a> {
        let indices = 0..scene.len().min(MOST_MADE) as u32;
        let objects = indices.filter_map(|index| scene.object(index));
        let made = objects.map(|object| ObjectFromOrigin::new(&object, origin)).collect();
        ObjectsFromOrigin { scene, origin, made }
    }

    /// Returns the object of this index, or `None` if there is none.
    pub(crate) fn get(&self, index: u32) -> Option<Cow<'_, ObjectFromOrigin>> {
        if let Some(made) = self.made.get(index as usize) {
            return Some(Cow::Borrowed(made));
        }
        let object = self.scene.object(index)?;
        Some(Cow::Owned(ObjectFromOrigin::new(&object, self.origin)))
    }

    /// Finds the hit with the smallest `t > 0`; if several have this `t`, that of the object listed
    /// first. Adds the decisions made to `steps`. Returns `None` if nothing is hit.
    pub(crate) fn first_hit(&self, ray: &ExactRay, steps: &mut Steps) -> Option<Hit<'_>> {
        let scene = self.scene;
        let mut first: Option<Hit> = None;
        // An upper bound of the t of the first hit found so far.
        let mut nearest = f64::INFINITY;
        let line = Line::from_ray(ray);
        let near = scene.index().map(|index| index.spheres_where(|m, h| line.may_meet(m, h)));
        let count = scene.spheres().len() as u32;
        let passed = near.as_ref().map_or(0, |near| count - near.len() as u32);
        steps.f64 += u64::from(passed);
        let all = if near.is_some() { 0..0 } else { 0..count };
        let spheres = all.chain(near.into_iter().flatten());
        for index in spheres.chain(count..scene.len() as u32) {
            if let Some(Object::Sphere(sphere)) = &scene.object(index)
                && SphereFromOrigin::is_passed(sphere, ray, nearest)
            {
                steps.count(Step::F64);
                continue;
            }
            let Some(object) = self.get(index) else { continue };
            if object.side_step() > Step::F64 {
                steps.count(object.side_step());
            }
            let Some(root) = object.first_root(ray, steps) else { continue };
            let hit = Hit { index, object, root };
            let is_nearer = |first: &Hit| hit.compare(first, ray, steps) == Ordering::Less;
            if first.as_ref().is_none_or(is_nearer) {
                let t = hit.object.rough_t(ray, root);
                nearest = t.map_or(f64::INFINITY, |(t, off)| t + off * t);
                first = Some(hit);
            }
        }
        first
    }
}

/// A ray's line in `f64`, infinite in both directions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    origin: [f64; 3],
    /// The direction, scaled to a length that is far from 0 and from infinity.
    direction: Vector<f64>,
    /// Error bound of the cross product of the direction with another vector, relative to the size of
    /// that vector.
    doubt: f64,
}

impl Line {
    pub(crate) fn from_ray(ray: &ExactRay) -> Line {
        let rough = &ray.rough;
        let doubt = rough.length * (Line::DOUBT + 4.0 * rough.doubt);
        Line { origin: ray.origin().to_array(), direction: rough.d, doubt }
    }

    /// Returns false if the line certainly misses the box `middle +- half`, otherwise true.
    ///
    /// Let d be the line's direction, h the half extents, q the vector from the line's origin to the
    /// middle, and e_i the coordinate axes. Seen along the line, the box is a hexagon whose sides have
    /// the normals `e_i x d`. The line passes beside the box if, for some i and the other two axes j and
    /// k,
    ///
    /// ```text
    /// |(q x d)_i| > h_j |d_k| + h_k |d_j|
    /// ```
    ///
    /// Each side of the inequality is off by less than `16 u |d| (|q|_1 + |h|_1)` with the unit roundoff
    /// u, for two products, a sum and the rounding of q; and by the relative error of d. [`Line::DOUBT`]
    /// is far more than 16 u, because it does no harm to count a box as hit that the line just misses.
    /// Underflow changes a value by less than the smallest normal number. If a value overflows, the
    /// inequality decides nothing.
    pub(crate) fn may_meet(&self, middle: [f64; 3], half: [f64; 3]) -> bool {
        let d = self.direction;
        let q: [f64; 3] = std::array::from_fn(|i| middle[i] - self.origin[i]);
        let size: f64 = (0..3).map(|i| q[i].abs() + half[i]).sum();
        let doubt = self.doubt * size + f64::MIN_POSITIVE;
        let is_beside = |i: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let off = (q[j] * d[k] - q[k] * d[j]).abs();
            off.is_finite() && off > half[j] * d[k].abs() + half[k] * d[j].abs() + doubt
        };
        !(0..3).any(is_beside)
    }

    /// Allowance for errors, relative to `|d| (|q|_1 + |h|_1)`: a box that the line misses by no more
    /// counts as hit.
    const DOUBT: f64 = 1e-12;
}
