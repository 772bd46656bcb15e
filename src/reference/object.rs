//! Spheres and planes, the exact values that all rays from one origin share, and the points where a ray
//! meets an object.

use std::cmp::Ordering;

use crate::dyadic::{Dyadic, Vector, dot, minus, vector};
use crate::interval::Interval;
use crate::quotient::Quotient;
use crate::real::Real;
use crate::surd::{Field, Surd, bits_of_level};

/// An object that a ray can hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Object {
    /// A sphere: all points at the distance `radius` from `center`.
    Sphere {
        /// The centre, in world units.
        center: [f64; 3],
        /// The radius, in world units; positive.
        radius: f64,
    },
    /// A plane: all points `q` with `normal . (q - point) = 0`.
    Plane {
        /// Any point of the plane.
        point: [f64; 3],
        /// Any nonzero vector perpendicular to the plane.
        normal: [f64; 3],
    },
}

impl Object {
    /// Returns the exact sign of the object's implicit function at `q`, which is 0 on the object. For a
    /// sphere, `|q - center|^2 - radius^2` is negative inside. For a plane, `normal . (q - point)` is
    /// positive on the side to which the normal points.
    ///
    /// # Panics
    /// Panics if a number is NaN or infinite.
    pub fn side_of(&self, q: [f64; 3]) -> Ordering {
        match ObjectFromEye::new(self, &vector(q)) {
            ObjectFromEye::Sphere { c, .. } => c.sign(),
            ObjectFromEye::Plane { offset, .. } => offset.sign().reverse(),
        }
    }
}

/// An object, with the exact values that all rays from one origin share.
#[derive(Clone, Debug)]
pub(crate) enum ObjectFromEye {
    Sphere {
        radius: Dyadic,
        /// `origin - center`
        from_center: Vector,
        /// `|origin - center|^2 - radius^2`
        c: Dyadic,
    },
    Plane {
        normal: Vector,
        /// `normal . (point - origin)`
        offset: Dyadic,
    },
}

impl ObjectFromEye {
    pub(crate) fn new(object: &Object, origin: &Vector) -> ObjectFromEye {
        match object {
            Object::Sphere { center, radius } => {
                let (center, radius) = (vector(*center), Dyadic::from_f64(*radius));
                let from_center = minus(origin, &center);
                let c = &dot(&from_center, &from_center) - &radius.square();
                ObjectFromEye::Sphere { radius, from_center, c }
            }
            Object::Plane { point, normal } => {
                let normal = vector(*normal);
                let offset = dot(&normal, &minus(&vector(*point), origin));
                ObjectFromEye::Plane { normal, offset }
            }
        }
    }

    /// Returns all `t` at which the line from the origin along `direction` meets the object, in
    /// ascending order, and none if the direction is 0. `a` is `|direction|^2`.
    pub(crate) fn roots(&self, field: &Field, direction: &[Surd; 3], a: &Surd) -> Vec<Quotient> {
        match self {
            ObjectFromEye::Sphere { from_center, c, .. } => {
                let b = Surd::dot(direction, from_center);
                if a.is_zero() { Vec::new() } else { sphere_roots(field, a, &b, c) }
            }
            ObjectFromEye::Plane { normal, offset } => {
                let rate = Surd::dot(direction, normal);
                let (p, d) = match field.sign(&rate) {
                    Ordering::Equal => return Vec::new(),
                    Ordering::Greater => (offset.clone(), rate),
                    Ordering::Less => (-offset, rate.negated()),
                };
                vec![Quotient::without_root(Surd::rational(p), d)]
            }
        }
    }

    /// Returns the unit normal at a root. It points outwards on a sphere, and along `normal` on a
    /// plane.
    pub(crate) fn normal(&self, root: &AtRoot) -> [Real; 3] {
        match self {
            ObjectFromEye::Sphere { from_center, radius, .. } => {
                std::array::from_fn(|i| root.coordinate(&from_center[i], i, radius))
            }
            // n / |n| = n |n| / |n|^2
            ObjectFromEye::Plane { normal, .. } => {
                let square = Surd::rational(dot(normal, normal));
                std::array::from_fn(|i| {
                    let q = Surd::rational(normal[i].clone());
                    Quotient { p: Surd::ZERO, q, e: square.clone(), d: square.clone() }
                        .value(root.field)
                })
            }
        }
    }
}

/// A ray at one of its roots.
pub(crate) struct AtRoot<'a> {
    field: &'a Field,
    direction: &'a [Surd; 3],
    t: &'a Quotient,
    /// An interval around `t`, narrow enough for nearly all computations; `None` if it could not be
    /// computed.
    interval: Option<Interval>,
}

/// The level of precision of [`AtRoot::interval`]; see [`bits_of_level`].
const LEVEL: usize = 1;

impl<'a> AtRoot<'a> {
    pub(crate) fn new(field: &'a Field, direction: &'a [Surd; 3], t: &'a Quotient) -> AtRoot<'a> {
        AtRoot { field, direction, t, interval: t.interval(field, LEVEL) }
    }

    /// Returns the coordinate `i` of `(origin + t * direction) / divisor`.
    pub(crate) fn coordinate(&self, origin: &Dyadic, i: usize, divisor: &Dyadic) -> Real {
        let (bits, direction) = (bits_of_level(LEVEL), &self.direction[i]);
        let quick = self.interval.as_ref().and_then(|t| {
            let moved = t.times(&self.field.interval(direction, LEVEL), bits);
            let coordinate = Interval::exactly(origin, bits).plus(&moved, bits);
            Real::within(&coordinate.over(&Interval::exactly(divisor, bits), bits))
        });
        // (o + (p + q sqrt(e)) / d * v) / r as a single quotient.
        let exact = || Quotient {
            p: self.t.d.scaled(origin).plus(&self.field.times(&self.t.p, direction)),
            q: self.field.times(&self.t.q, direction),
            e: self.t.e.clone(),
            d: self.t.d.scaled(divisor),
        };
        quick.unwrap_or_else(|| exact().value(self.field))
    }
}

/// Returns the roots of `a t^2 + 2 b t + c = 0`: `(-b -+ sqrt(b^2 - a c)) / a`.
fn sphere_roots(field: &Field, a: &Surd, b: &Surd, c: &Dyadic) -> Vec<Quotient> {
    let discriminant = field.square(b).minus(&a.scaled(c));
    let minus_b = b.negated();
    match field.sign(&discriminant) {
        Ordering::Less => Vec::new(),
        Ordering::Equal => vec![Quotient::without_root(minus_b, a.clone())],
        Ordering::Greater => {
            let one = Surd::rational(Dyadic::power_of_two(0));
            let root =
                |q| Quotient { p: minus_b.clone(), q, e: discriminant.clone(), d: a.clone() };
            vec![root(one.negated()), root(one)]
        }
    }
}
