//! How well `t` is determined by its problem, and how large a change of the problem explains a method's
//! `t`: the condition number and the backward error (Higham, *Accuracy and Stability of Numerical
//! Algorithms*, 2nd ed., SIAM 2002, sections 1.5 and 1.6). Their product bounds the relative error of
//! `t`, so that what the method loses is told from what the problem does.
//!
//! The root of `|o + t d - c| = r` moves, to first order, by
//!
//! ```text
//! dt = -(n.(do + t dd - dc) - dr) / n.d        n the unit normal where the ray meets the sphere
//! ```
//!
//! Let every vector change by at most the share e of its length, and r by e r. The worst is a change of
//! all of them along n: `|dt| / t <= e k` with
//!
//! ```text
//! k = (|o| + |c| + t |d| + r) / (t |n.d|)
//! ```
//!
//! Turned round, a computed t' is the exact root of a problem changed by the share
//! `| |o + t' d - c| - r | / (|o| + |c| + t' |d| + r)`, and of none changed by less: the theorem of Rigal
//! and Gaches (Higham, theorem 7.1) for one equation. A plane `n.(o + t d - q) = 0` has `|p - q|` in
//! place of r: what a change of its normal does.

use pinhole_core::{DVec3, Object, Ray};
use pinhole_reference::Hit;

/// Unit roundoff of `f64`, 2^-53: backward errors are counted in it, as errors in `t` are in ulps. An
/// error in ulps is at most the condition number times the backward error.
const UNIT: f64 = 0.5 * f64::EPSILON;

/// One ray's root of one object, at the truth.
pub(super) struct Problem {
    /// True `t`.
    t: f64,
    /// Length of the direction.
    speed: f64,
    /// Cosine of the angle between direction and normal.
    cosine: f64,
    /// `|o| + |c|`, or `|o| + |q|`.
    fixed: f64,
    shape: Shape,
}

enum Shape {
    /// A sphere of this radius.
    Sphere(f64),
    /// A plane; distance of the hit from its given point.
    Plane(f64),
}

impl Problem {
    /// The first hit's.
    pub(super) fn new(ray: &Ray, object: &Object, truth: &Hit) -> Problem {
        let of_reals = |reals: &[pinhole_reference::Real; 3]| {
            DVec3::new(reals[0].to_f64(), reals[1].to_f64(), reals[2].to_f64())
        };
        let speed = length(ray.direction);
        let (anchor, shape) = match object {
            Object::Sphere(sphere) => (sphere.center, Shape::Sphere(sphere.radius)),
            Object::Plane(plane) => {
                (plane.point, Shape::Plane(length(of_reals(&truth.point) - plane.point)))
            }
        };
        Problem {
            t: truth.t.to_f64(),
            speed,
            cosine: of_reals(&truth.normal).dot(ray.direction / speed),
            fixed: length(ray.origin) + length(anchor),
            shape,
        }
    }

    /// Sum of the sizes of all that may change, at a hit at `t`.
    fn size(&self, t: f64) -> f64 {
        let (Shape::Sphere(own) | Shape::Plane(own)) = self.shape;
        self.fixed + t * self.speed + own
    }

    /// The condition number of `t`; `None` at a tangent, where it is infinite, and where sizes leave the
    /// range of `f64`.
    pub(super) fn condition(&self) -> Option<f64> {
        let condition = self.size(self.t) / (self.t * self.speed) / self.cosine.abs();
        condition.is_finite().then_some(condition)
    }

    /// The backward error of a computed `t`, in units of 2^-53.
    pub(super) fn backward_error(&self, truth: &Hit, t: f64) -> Option<f64> {
        if !t.is_finite() {
            return None;
        }
        // The difference is exact: what the distance from the surface loses by cancelling is not.
        let moved = -truth.t.minus_f64(t).to_f64() * self.speed;
        let off = match self.shape {
            Shape::Sphere(radius) => {
                let share = moved / radius;
                let grown = share * (2.0 * self.cosine + share);
                radius * grown / (1.0 + (1.0 + grown).max(0.0).sqrt())
            }
            Shape::Plane(_) => moved * self.cosine,
        };
        let error = off.abs() / self.size(t) / UNIT;
        error.is_finite().then_some(error)
    }
}

/// The length of a vector of any size.
fn length(v: DVec3) -> f64 {
    let largest = v.abs().max_element();
    if largest > 0.0 { largest * (v / largest).length() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use pinhole_core::{Plane, Sphere};
    use pinhole_reference as reference;

    use super::*;

    fn problem(ray: Ray, object: Object) -> (Problem, Hit) {
        let given = match object {
            Object::Sphere(Sphere { center, radius }) => {
                reference::Object::Sphere { center: center.to_array(), radius }
            }
            Object::Plane(Plane { point, normal }) => {
                reference::Object::Plane { point: point.to_array(), normal: normal.to_array() }
            }
        };
        let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
        let truth = reference::first_hit(&[given], origin, direction).unwrap();
        (Problem::new(&ray, &object, &truth), truth)
    }

    /// Each input in turn is changed by a small share in the worst direction; together, t moves by the
    /// condition number times the share.
    #[test]
    fn the_condition_number_is_how_much_t_moves_at_worst() {
        let ray = Ray { origin: DVec3::new(1.0, 2.0, 3.0), direction: DVec3::new(0.5, 0.25, -2.0) };
        let sphere = Sphere { center: DVec3::new(2.0, 3.0, -5.0), radius: 1.5 };
        let (known, truth) = problem(ray, Object::Sphere(sphere));
        let normal = DVec3::from_array(truth.normal.clone().map(|x| x.to_f64()));
        let share = 1e-6;
        let along = |v: DVec3, sign: f64| v + sign * share * v.length() * normal;
        let changed = Ray { origin: along(ray.origin, 1.0), direction: along(ray.direction, 1.0) };
        let center = along(sphere.center, -1.0);
        let radius = sphere.radius * (1.0 - share);
        let (_, moved) = problem(changed, Object::Sphere(Sphere { center, radius }));
        let t = truth.t.to_f64();
        let expected = (moved.t.to_f64() - t).abs() / t / share;
        let condition = known.condition().unwrap();
        assert!((condition / expected - 1.0).abs() < 1e-4, "{condition} {expected}");
    }

    #[test]
    fn the_error_is_at_most_condition_times_backward_error() {
        let ray = Ray { origin: DVec3::ZERO, direction: DVec3::new(0.19, 0.0, -1.0) };
        let ball = Object::Sphere(Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 });
        let floor = Object::Plane(Plane {
            point: DVec3::new(3.0, 0.0, -9.0),
            normal: DVec3::new(0.1, 0.0, 1.0),
        });
        for object in [ball, floor] {
            let (known, truth) = problem(ray, object);
            let t = truth.t.to_f64();
            for factor in [1.0 - 1e-9, 1.0 + 1e-9, 1.0 + 1e-13] {
                let error = (t * factor - t).abs() / t / UNIT;
                let backward = known.backward_error(&truth, t * factor).unwrap();
                let bound = known.condition().unwrap() * backward;
                assert!((0.999..1.01).contains(&(bound / error)), "{error} {bound}");
            }
        }
    }
}
