//! Objects with the values precomputed for all rays from one origin, and the exact order of a ray's
//! hits.

use std::borrow::Cow;
use std::cmp::Ordering;

use glam::DVec3;

use crate::camera::ray::{ExactRay, Ray};
use crate::exact::big_ray::{BigRay, BigRoot};
use crate::exact::bounded::dot;
use crate::exact::double_double::DoubleDouble;
use crate::exact::precise::{Precise, T_DOUBT, is_noise, rounded};
use crate::exact::quadratic::{LARGEST_SHARE, Quadratic};
use crate::exact::scale::{exponent, ldexp, split};
use crate::exact::steps::{Step, Steps};
use crate::scene::error::ObjectError;
use crate::scene::object::{LineRoots, Object, Root, Roots};
use crate::scene::plane::Plane;
use crate::scene::plane_predicates::PlaneFromOrigin;
use crate::scene::sphere::Sphere;
use crate::scene::sphere_predicates::{RootSide, SphereFromOrigin};

/// An object with the values precomputed for all rays from one origin.
#[derive(Clone, Debug)]
pub(crate) enum ObjectFromOrigin {
    Sphere(SphereFromOrigin),
    Plane(PlaneFromOrigin),
}

impl ObjectFromOrigin {
    pub(crate) fn new(object: &Object, origin: DVec3) -> ObjectFromOrigin {
        match object {
            Object::Sphere(sphere) => {
                ObjectFromOrigin::Sphere(SphereFromOrigin::new(sphere, origin))
            }
            Object::Plane(plane) => ObjectFromOrigin::Plane(PlaneFromOrigin::new(plane, origin)),
        }
    }

    /// Returns the step that decided on which side of the object the origin is.
    pub(crate) fn side_step(&self) -> Step {
        match self {
            ObjectFromOrigin::Sphere(seen) => seen.side_step,
            ObjectFromOrigin::Plane(seen) => seen.side_step,
        }
    }

    /// Returns at which of its roots the ray first hits the object, or `None` if it does not.
    pub(crate) fn first_root(&self, ray: &ExactRay, steps: &mut Steps) -> Option<RootSide> {
        match self {
            ObjectFromOrigin::Sphere(seen) => seen.first_root(ray, steps),
            ObjectFromOrigin::Plane(seen) => seen.is_hit(ray, steps).then_some(RootSide::Near),
        }
    }

    /// Returns the root at which any ray that hits the object hits it first. It depends only on the
    /// origin.
    pub(crate) fn root_of_hit(&self) -> RootSide {
        match self {
            ObjectFromOrigin::Sphere(seen) => seen.root_of_hit(),
            ObjectFromOrigin::Plane(_) => RootSide::Near,
        }
    }

    /// Returns the roots of the ray's line with the object, in ascending order of `t`.
    pub(crate) fn root_sides(&self, ray: &ExactRay, steps: &mut Steps) -> &'static [RootSide] {
        match self {
            ObjectFromOrigin::Sphere(seen) => match seen.meets(ray, steps) {
                Ordering::Less => &[],
                Ordering::Equal => &[RootSide::Near],
                Ordering::Greater => &[RootSide::Near, RootSide::Far],
            },
            ObjectFromOrigin::Plane(seen) => match seen.rate(ray, steps) {
                Ordering::Equal => &[],
                _ => &[RootSide::Near],
            },
        }
    }

    /// Returns `t` at a root, with more digits than `f64` has.
    pub(crate) fn t(&self, ray: &ExactRay, root: RootSide) -> Precise {
        self.t_within(ray, root, T_DOUBT)
    }

    /// Returns the exact `t` at a root, rounded to the nearest `f64`, and counts the step that computed
    /// it.
    pub(crate) fn rounded_t(&self, ray: &ExactRay, root: RootSide, steps: &mut Steps) -> f64 {
        if let ObjectFromOrigin::Sphere(seen) = self
            && let Some(t) = seen.rounded_t(ray, root)
        {
            steps.count(Step::DoubleDouble);
            return t;
        }
        let (t, step) = match self {
            ObjectFromOrigin::Sphere(seen) => seen.t(ray, root, T_DOUBT),
            ObjectFromOrigin::Plane(seen) => seen.t(ray, T_DOUBT),
        };
        let [low, high] = t.nearest(T_DOUBT);
        if low == high {
            steps.count(step);
            return low;
        }
        steps.count(Step::Exact);
        let big = ray.big();
        let root = self.big_root(&big, root);
        rounded([low, high], |middle| big.compare_t(&root, middle))
    }

    /// Returns `t` at a root, with a relative error of at most `doubt`.
    pub(crate) fn t_within(&self, ray: &ExactRay, root: RootSide, doubt: f64) -> Precise {
        match self {
            ObjectFromOrigin::Sphere(seen) => seen.t(ray, root, doubt).0,
            ObjectFromOrigin::Plane(seen) => seen.t(ray, doubt).0,
        }
    }

    /// Returns `t` at a root in `f64` and its relative error; `None` if `f64` is not accurate enough or
    /// `t` is out of its range.
    pub(crate) fn rough_t(&self, ray: &ExactRay, root: RootSide) -> Option<(f64, f64)> {
        let ((t, share), scale) = match self {
            ObjectFromOrigin::Sphere(seen) => {
                let quadratic = Quadratic::new(&seen.rough, &ray.rough);
                (quadratic.root(&seen.rough, root == RootSide::Far)?, seen.scale)
            }
            ObjectFromOrigin::Plane(seen) => (seen.rough_t(&ray.rough)?, seen.scale),
        };
        let t = ldexp(t * ray.stretch, scale - ray.scale);
        (t.is_normal() && share < LARGEST_SHARE).then_some((t, share))
    }

    /// Returns the `t` of all roots, in ascending order.
    pub(crate) fn roots(&self, ray: &ExactRay) -> Roots {
        let steps = &mut Steps::default();
        match *self.root_sides(ray, steps) {
            [] => Roots::None,
            [root] => Roots::One(self.rounded_t(ray, root, steps)),
            [near, far, ..] => {
                Roots::Two(self.rounded_t(ray, near, steps), self.rounded_t(ray, far, steps))
            }
        }
    }

    fn big_root(&self, ray: &BigRay, root: RootSide) -> BigRoot {
        match self {
            ObjectFromOrigin::Sphere(seen) => seen.big_root(ray, root),
            ObjectFromOrigin::Plane(seen) => ray.plane_root(&seen.plane),
        }
    }

    /// Returns whether two objects are the same set of points, which every ray meets at the same
    /// `t`.
    pub(crate) fn is_same(&self, other: &ObjectFromOrigin) -> bool {
        match (self, other) {
            (ObjectFromOrigin::Sphere(one), ObjectFromOrigin::Sphere(other)) => {
                one.sphere == other.sphere
            }
            (ObjectFromOrigin::Plane(one), ObjectFromOrigin::Plane(other)) => {
                one.plane.is_same(&other.plane)
            }
            _ => false,
        }
    }

    /// Returns the root with its point and normal.
    ///
    /// A sphere's point is `center + r n`; a plane's is `origin + t direction`, rounded once. If a
    /// coordinate of the direction is 0, the point has the origin's coordinate. If the two terms of a
    /// coordinate cancel to no more than the rounding error of t, the coordinate is 0.
    pub(crate) fn root(&self, index: u32, ray: &ExactRay, root: RootSide) -> Root {
        let t = self.t(ray, root);
        let (point, normal) = match self {
            ObjectFromOrigin::Sphere(seen) => {
                let (sphere, normal) = (&seen.sphere, seen.normal(ray, root));
                let coordinate = |i: usize| {
                    if ray.fine.d[i].hi == 0.0 {
                        return ray.origin()[i];
                    }
                    let step = DoubleDouble::product(sphere.radius, normal[i]);
                    let sum = (step + DoubleDouble::from(sphere.center[i])).hi;
                    if sum.is_finite() { sum } else { sphere.center[i] + sphere.radius * normal[i] }
                };
                (DVec3::from_array(std::array::from_fn(coordinate)), normal)
            }
            ObjectFromOrigin::Plane(seen) => (point_at(ray, t), plane_normal(seen.plane.normal)),
        };
        Root { object: index, t: self.rounded_t(ray, root, &mut Steps::default()), point, normal }
    }
}

/// Returns `origin + t direction`, each coordinate rounded once.
fn point_at(ray: &ExactRay, t: Precise) -> DVec3 {
    let coordinate = |i: usize| {
        // A given coordinate has its own scale, so that it loses no digit.
        let (d, k) = match ray.given_direction() {
            Some(direction) if direction[i] != 0.0 => {
                let k = exponent(direction[i]);
                (DoubleDouble::from(ldexp(direction[i], -k)), k)
            }
            _ => (ray.fine.d[i], ray.scale),
        };
        let (step, k) = (d * t.value / DoubleDouble::from(ray.stretch), t.scale + k);
        let step = step.scaled(k);
        let sum = (step + DoubleDouble::from(ray.origin()[i])).hi;
        if is_noise(sum, ray.origin()[i]) {
            0.0
        } else if sum.is_finite() {
            sum
        } else {
            (ray.origin()[i] + step.hi).clamp(f64::MIN, f64::MAX)
        }
    };
    DVec3::from_array(std::array::from_fn(coordinate))
}

/// Returns `n / |n|`, each coordinate rounded once.
pub(crate) fn plane_normal(normal: DVec3) -> DVec3 {
    let (normal, _) = split(normal);
    let normal = normal.to_array().map(DoubleDouble::from);
    let length = dot(normal, normal).square_root();
    DVec3::from_array(normal.map(|x| (x / length).hi))
}

/// The hit of a ray with one object, to be compared with others.
#[derive(Clone, Debug)]
pub(crate) struct Hit<'a> {
    pub(crate) index: u32,
    pub(crate) object: Cow<'a, ObjectFromOrigin>,
    pub(crate) root: RootSide,
}

impl Hit<'_> {
    /// Compares the `t` of two hits of a ray, exactly.
    pub(crate) fn compare(&self, other: &Hit, ray: &ExactRay, steps: &mut Steps) -> Ordering {
        let rough = (self.object.rough_t(ray, self.root), other.object.rough_t(ray, other.root));
        if let (Some((t, share)), Some((other_t, other_share))) = rough {
            let doubt = 1.01 * (share * t.abs() + other_share * other_t.abs());
            if (t - other_t).abs() > doubt {
                steps.count(Step::F64);
                return t.total_cmp(&other_t);
            }
        }
        if self.root == other.root && self.object.is_same(&other.object) {
            steps.count(Step::F64);
            return Ordering::Equal;
        }
        let (t, other_t) = (self.object.t(ray, self.root), other.object.t(ray, other.root));
        if let Some(order) = t.compare(other_t) {
            steps.count(Step::DoubleDouble);
            return order;
        }
        steps.count(Step::Exact);
        let big = ray.big();
        let [one, other] = [self, other].map(|hit| hit.object.big_root(&big, hit.root));
        big.compare(&one, &other)
    }

    pub(crate) fn root(&self, ray: &ExactRay) -> Root {
        self.object.root(self.index, ray, self.root)
    }

    /// Returns `t |d|`, rounded once.
    pub(crate) fn distance(&self, ray: &ExactRay) -> f64 {
        let t = self.object.t(ray, self.root);
        let length = dot(ray.fine.d, ray.fine.d).square_root() / DoubleDouble::from(ray.stretch);
        let distance = Precise::new(t.value * length, t.scale + ray.scale);
        // The relative error of the length is about 2^-100.
        let [low, high] = distance.nearest(1.1 * T_DOUBT);
        if low == high {
            return low;
        }
        let big = ray.big();
        let root = self.object.big_root(&big, self.root);
        rounded([low, high], |middle| big.compare_distance(&root, middle))
    }
}

impl Sphere {
    /// Returns the `t` at which the ray's line meets the sphere. The decisions are exact for the given
    /// numbers, and each `t` is the exact value, rounded. A ray that does not pass [`Ray::check`], or a
    /// sphere that does not pass [`Sphere::check`], has no roots.
    pub fn roots(&self, ray: &Ray) -> Roots {
        Object::Sphere(*self).roots(ray)
    }
}

impl Plane {
    /// Returns the `t` at which the ray's line meets the plane: the exact value, rounded. A line
    /// parallel to the plane has no root, even if it lies in the plane. The decisions are exact for the
    /// given numbers. A ray that does not pass [`Ray::check`], or a plane that does not pass
    /// [`Plane::check`], has no roots.
    pub fn roots(&self, ray: &Ray) -> Roots {
        Object::Plane(*self).roots(ray)
    }
}

impl Object {
    /// Returns the `t` at which the ray's line meets the object, see [`Sphere::roots`] and
    /// [`Plane::roots`].
    pub fn roots(&self, ray: &Ray) -> Roots {
        ExactRay::from_ray(ray).map_or(Roots::None, |ray| self.roots_of(&ray))
    }

    /// Returns the `t` at which the line of an exact ray meets the object, see [`Object::roots`].
    pub fn roots_of(&self, ray: &ExactRay) -> Roots {
        if self.check().is_err() {
            return Roots::None;
        }
        ObjectFromOrigin::new(self, ray.origin()).roots(ray)
    }

    /// Returns the first hit of the ray with this object alone. The returned root has `index` as its
    /// object. Returns `None` if the ray misses the object, or if the object does not pass
    /// [`Object::check`].
    pub fn first_hit(&self, index: u32, ray: &ExactRay) -> Option<Root> {
        self.check().ok()?;
        let seen = ObjectFromOrigin::new(self, ray.origin());
        let root = seen.first_root(ray, &mut Steps::default())?;
        Some(seen.root(index, ray, root))
    }

    /// Returns the roots of the ray's line with the object. The decisions are exact. The returned roots
    /// have `index` as their object.
    ///
    /// # Errors
    /// Returns an error if the object is invalid, see [`Object::check`].
    pub fn line_roots(&self, index: u32, ray: &ExactRay) -> Result<LineRoots, ObjectError> {
        self.check()?;
        let (seen, steps) = (ObjectFromOrigin::new(self, ray.origin()), &mut Steps::default());
        let side = match &seen {
            ObjectFromOrigin::Sphere(sphere) => sphere.side,
            ObjectFromOrigin::Plane(plane) => plane.side.reverse(),
        };
        let (sides, hit) = (seen.root_sides(ray, steps), seen.first_root(ray, steps));
        let root = |n: usize| sides.get(n).map(|side| seen.root(index, ray, *side));
        let first = hit.and_then(|hit| sides.iter().position(|side| *side == hit));
        Ok(LineRoots { side, roots: [root(0), root(1)], first })
    }
}
