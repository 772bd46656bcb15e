//! The condition number of `t`, which tells how sensitive the true `t` is to changes of the ray and
//! the object, and the backward error of a computed `t`, which is the smallest relative change of the
//! ray and the object for which it would be exact (Higham, *Accuracy and Stability of Numerical
//! Algorithms*, 2nd ed., SIAM 2002, sections 1.5 and 1.6). The product of the two numbers bounds the
//! relative error of `t`. They thus separate the sensitivity of the problem from the error of the
//! method.
//!
//! Let o and d be the ray's origin and direction, and c and r the sphere's centre and radius. If they
//! change by do, dd, dc and dr, the root of `|o + t d - c| = r` moves, to first order, by
//!
//! ```text
//! dt = -(n.(do + t dd - dc) - dr) / n.d        n the unit normal where the ray meets the sphere
//! ```
//!
//! Let every vector change by at most the fraction e of its length, and r by at most e r. In the worst
//! case all vectors change along n, so `|dt| / t <= e k` with
//!
//! ```text
//! k = (|o| + |c| + t |d| + r) / (t |n.d|)
//! ```
//!
//! Conversely, a computed t' is the exact root of a problem that is changed by the fraction `| |o + t'
//! d - c| - r | / (|o| + |c| + t' |d| + r)`, and of no problem that is changed by less. This is the
//! theorem of Rigal and Gaches (Higham, theorem 7.1) for one equation. For a plane `n.(o + t d - q) =
//! 0` through the point q, c is replaced by q, and r by `|p - q|`, the effect of a change of the
//! normal, where p is the hit point.

use pinhole_core::arithmetic::length;
use pinhole_core::{DVec3, Object, Ray};
use pinhole_reference::{Hit, Real};

/// The unit of backward errors: the unit roundoff of `f64`, 2^-53. In this unit, the condition number
/// times the backward error is an upper bound of the error in ulps.
const UNIT: f64 = 0.5 * f64::EPSILON;

/// The true hit of a ray with an object, given by the numbers from which condition number and backward
/// error are computed. All lengths are divided by the distance from the origin to the hit, so that
/// they stay in the range of `f64`.
pub(super) struct Problem {
    /// The true `t`.
    t: f64,
    /// Cosine of the angle between the ray's direction and the object's normal at the hit.
    cosine: f64,
    /// `|o| + |c| + r` for a sphere, `|o| + |q| + |p - q|` for a plane (for the symbols, see the
    /// module's documentation).
    fixed: f64,
    /// The sphere's radius; `None` for a plane.
    radius: Option<f64>,
}

/// The absolute value of [`Problem::cosine`] below which a sphere's two roots cannot be distinguished.
const ONE_ROOT: f64 = 1e-14;

impl Problem {
    /// Creates the problem whose solution is this first hit.
    pub(super) fn new(ray: &Ray, object: &Object, truth: &Hit) -> Problem {
        let of_reals = |reals: &[Real; 3]| DVec3::from_array(reals.each_ref().map(|x| x.to_f64()));
        let speed = length(ray.direction);
        let (anchor, own) = match object {
            Object::Sphere(sphere) => (sphere.center, sphere.radius),
            Object::Plane(plane) => (plane.point, length(of_reals(&truth.point) - plane.point)),
        };
        let t = truth.t.to_f64();
        // If the distance overflows, nothing can be computed, so all lengths become NaN.
        let distance = Some(t * speed).filter(|x| x.is_finite()).unwrap_or(f64::NAN);
        Problem {
            t,
            cosine: of_reals(&truth.normal).dot(ray.direction / speed),
            fixed: length(ray.origin) / distance + length(anchor) / distance + own / distance,
            radius: matches!(object, Object::Sphere(_)).then_some(own / distance),
        }
    }

    /// Returns the signed relative error `(t' - t) / t` of a computed `t'`, which is the argument,
    /// where t is the true one; `None` if the error is outside the range of `f64`.
    fn moved(&self, truth: &Hit, t: f64) -> Option<f64> {
        if !t.is_finite() {
            return None;
        }
        let half = truth.t.relative_difference(&Real::from(t));
        let moved = if half.abs() < 0.5 {
            -2.0 * half / (1.0 + half)
        } else {
            // This difference is exact, so nothing is lost to cancellation.
            -truth.t.minus(&Real::from(t)).to_f64() / self.t
        };
        moved.is_finite().then_some(moved)
    }

    /// Returns true if a computed t is closer to the other root of the same sphere than to the true
    /// one: less than half as far from it. Roots whose relative difference is only a few times `unit`,
    /// the spacing of floats at 1, count as one root.
    pub(super) fn is_other_root(&self, truth: &Hit, t: f64, unit: f64) -> bool {
        let (Some(radius), Some(moved)) = (self.radius, self.moved(truth, t)) else { return false };
        let to_other = -2.0 * self.cosine * radius;
        let are_two = self.cosine.abs() > ONE_ROOT && to_other.abs() > 8.0 * unit;
        are_two && (moved - to_other).abs() < 0.5 * moved.abs()
    }

    /// Returns the condition number of `t`: the largest relative change of `t` per relative change of
    /// the ray and the object, k in the module's documentation. Returns `None` if it is infinite,
    /// because the ray is tangent to the sphere, or if a length is outside the range of `f64`.
    pub(super) fn condition(&self) -> Option<f64> {
        let condition = (self.fixed + 1.0) / self.cosine.abs();
        condition.is_finite().then_some(condition)
    }

    /// Returns the backward error of a computed `t`, in units of 2^-53: the smallest relative change
    /// of the ray and the object for which this `t` is exact. Returns `None` if it is outside the
    /// range of `f64`.
    pub(super) fn backward_error(&self, truth: &Hit, t: f64) -> Option<f64> {
        let moved = self.moved(truth, t)?;
        let off = match self.radius {
            Some(radius) => {
                let share = moved / radius;
                let grown = share * (2.0 * self.cosine + share);
                radius * grown / (1.0 + (1.0 + grown).max(0.0).sqrt())
            }
            None => moved * self.cosine,
        };
        let error = off.abs() / (self.fixed + 1.0 + moved) / UNIT;
        error.is_finite().then_some(error)
    }
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

    /// All inputs are changed by the same small fraction of their sizes, in the worst directions. The
    /// relative change of t is then the condition number times this fraction.
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

    /// Tests lengths whose products underflow to zero.
    #[test]
    fn no_size_makes_the_backward_error_vanish() {
        let tiny = 1e-315;
        let ray = Ray { origin: DVec3::ZERO, direction: DVec3::new(0.1 * tiny, 0.0, -tiny) };
        let ball = Sphere { center: DVec3::new(0.0, 0.0, -5.0 * tiny), radius: tiny };
        let (known, truth) = problem(ray, Object::Sphere(ball));
        let t = truth.t.to_f64();
        let backward = known.backward_error(&truth, t.next_up()).unwrap();
        assert!((0.01..10.0).contains(&backward), "{backward}");
    }

    #[test]
    fn another_root_is_told_from_an_inexact_one() {
        let down = DVec3::NEG_Z;
        let is_other = |origin: DVec3, t: f64| {
            let ball = Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 };
            let (known, truth) = problem(Ray { origin, direction: down }, Object::Sphere(ball));
            known.is_other_root(&truth, t, f64::EPSILON)
        };
        // Roots at 4 and 6; just outside the surface, at 1e-12 and 2; inside, at -1 and 1; a tangent.
        for (origin, t) in [
            (DVec3::ZERO, 6.0),
            (DVec3::ZERO, 5.9),
            (DVec3::new(0.0, 0.0, -4.0 + 1e-12), 2.0),
            (DVec3::new(0.0, 0.0, -5.0), -1.0),
        ] {
            assert!(is_other(origin, t), "{origin} {t}");
        }
        for (origin, t) in [
            (DVec3::ZERO, 4.0),
            (DVec3::ZERO, 5.0),
            (DVec3::ZERO, 1e30),
            (DVec3::ZERO, f64::NAN),
            (DVec3::new(0.0, 0.0, -4.0 + 1e-12), 1e-3),
            (DVec3::new(1.0, 0.0, 0.0), 5.0f64.next_up()),
        ] {
            assert!(!is_other(origin, t), "{origin} {t}");
        }
    }

    /// In `f32`, the two roots are only a few floats apart, so rounding decides which of them t is
    /// nearer to.
    #[test]
    fn roots_that_the_precision_does_not_tell_apart_are_one() {
        let ray = Ray { origin: DVec3::ZERO, direction: DVec3::NEG_Z };
        let ball = Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1e-8 };
        let (known, truth) = problem(ray, Object::Sphere(ball));
        let other = 5.0 + 1e-8;
        assert!(known.is_other_root(&truth, other, f64::EPSILON));
        assert!(!known.is_other_root(&truth, other, f64::from(f32::EPSILON)));
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
