//! Finds the points where a ray meets an object, and the first object that a ray hits.

use std::cmp::Ordering;

use crate::dyadic::{Dyadic, Vector, vector};
use crate::object::{AtRoot, Object, ObjectFromEye};
use crate::quotient::Quotient;
use crate::real::Real;
use crate::surd::{Field, Surd};

/// The first hit of a ray.
#[derive(Clone, Debug, PartialEq)]
pub struct Hit {
    /// The object's index, counted from 0.
    pub object: usize,
    /// The hit's position on the ray, in multiples of the direction's length; greater than 0.
    pub t: Real,
    /// The unit normal at the hit. It points outwards on a sphere, and along `normal` on a plane.
    pub normal: [Real; 3],
    /// The hit point, `origin + t * direction`.
    pub point: [Real; 3],
}

/// Objects, with the exact values that all rays from one point share.
#[derive(Debug)]
pub(crate) struct SceneFromEye {
    origin: Vector,
    objects: Vec<ObjectFromEye>,
}

/// A direction whose coordinates may contain square roots. To avoid division, it is stored as
/// `multiple`, which is the true direction times the positive factor `per_multiple`. A `t` computed
/// with `multiple` must be multiplied by this factor.
pub(crate) struct Direction<'a> {
    pub(crate) field: &'a Field,
    pub(crate) multiple: [Surd; 3],
    pub(crate) per_multiple: Surd,
}

impl Direction<'_> {
    /// Converts the `t` of the multiple to the true `t`.
    fn true_t(&self, t: &Quotient) -> Real {
        let times = |x: &Surd| self.field.times(x, &self.per_multiple);
        Quotient { p: times(&t.p), q: times(&t.q), e: t.e.clone(), d: t.d.clone() }
            .value(self.field)
    }

    /// Returns the true direction. A coordinate x of `multiple` is divided by the factor m as x m /
    /// m^2, since m may contain roots.
    pub(crate) fn values(&self) -> [Real; 3] {
        let square = self.field.square(&self.per_multiple);
        [0, 1, 2].map(|i| {
            let p = self.field.times(&self.multiple[i], &self.per_multiple);
            Quotient::without_root(p, square.clone()).value(self.field)
        })
    }
}

impl SceneFromEye {
    pub(crate) fn new(objects: &[Object], origin: Vector) -> SceneFromEye {
        let objects = objects.iter().map(|object| ObjectFromEye::new(object, &origin)).collect();
        SceneFromEye { origin, objects }
    }

    pub(crate) fn roots(&self, object: usize, direction: &Direction) -> Vec<Real> {
        let Direction { field, multiple, .. } = direction;
        let roots = self.objects[object].roots(field, multiple, &field.dot(multiple, multiple));
        roots.iter().map(|t| direction.true_t(t)).collect()
    }

    /// Finds the hit with the smallest `t > 0`. Of objects with equal `t`, the one listed first wins.
    pub(crate) fn first_hit(&self, direction: &Direction) -> Option<Hit> {
        let Direction { field, multiple, .. } = direction;
        let a = field.dot(multiple, multiple);
        let is_ahead = |t: &Quotient| t.sign(field) == Ordering::Greater;
        let mut first: Option<(usize, Quotient)> = None;
        for (index, object) in self.objects.iter().enumerate() {
            let roots = object.roots(field, multiple, &a);
            let Some(t) = roots.into_iter().find(is_ahead) else { continue };
            if first.as_ref().is_none_or(|(_, best)| t.cmp(best, field) == Ordering::Less) {
                first = Some((index, t));
            }
        }
        let (object, t) = first?;
        let root = AtRoot::new(field, multiple, &t);
        let one = Dyadic::power_of_two(0);
        Some(Hit {
            object,
            t: direction.true_t(&t),
            normal: self.objects[object].normal(&root),
            point: std::array::from_fn(|i| root.coordinate(&self.origin[i], i, &one)),
        })
    }
}

fn exact(field: &Field, direction: [f64; 3]) -> Direction<'_> {
    Direction {
        field,
        multiple: vector(direction).map(Surd::rational),
        per_multiple: Surd::rational(Dyadic::power_of_two(0)),
    }
}

/// Returns all `t` at which the line `origin + t * direction` meets the object, in ascending order and
/// including negative values and 0. There is one `t` if the line touches a sphere. There is none if the
/// line is parallel to a plane, even if it lies within the plane, and none if the direction is 0.
///
/// # Panics
/// Panics if a number is NaN or infinite.
pub fn roots(object: &Object, origin: [f64; 3], direction: [f64; 3]) -> Vec<Real> {
    let field = Field::rational();
    SceneFromEye::new(&[*object], vector(origin)).roots(0, &exact(&field, direction))
}

/// Finds the hit of the ray `origin + t * direction` with the smallest `t > 0`. Of objects with equal
/// `t`, the one listed first wins. A ray that touches a sphere hits it. A ray that is parallel to a
/// plane does not hit it, even if it lies within the plane. Returns `None` if nothing is hit, and for a
/// direction of 0.
///
/// # Panics
/// Panics if a number is NaN or infinite.
pub fn first_hit(objects: &[Object], origin: [f64; 3], direction: [f64; 3]) -> Option<Hit> {
    SceneFromEye::new(objects, vector(origin)).first_hit(&exact(&Field::rational(), direction))
}
