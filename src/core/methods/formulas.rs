//! The known formulas for a ray and a sphere, and the textbook formula for a ray and a plane. Each is
//! written once, for any [`Real`].
//!
//! For a ray `p + t d` and a sphere of radius r, with `oc = p - center` and `f(t) = |oc + t d|^2 - r^2`,
//! all formulas for spheres solve `f(t) = 0`:
//!
//! ```text
//! a t^2 + 2 b t + c = 0     a = d.d     b = d.oc     c = |oc|^2 - r^2     D = b^2 - a c
//! ```
//!
//! The formulas agree in real arithmetic. They differ in how much rounding changes D.

use crate::exact::bounded::{Vector, cross, dot};
use crate::methods::number::{Real, RoundedPlane, RoundedRay, RoundedSphere, minus, plus, times};

/// The values of a ray and a sphere from which a formula computes `t`. In a loop over rays from one
/// origin, the compiler hoists the values that do not depend on the direction out of the loop.
pub(crate) struct Terms<R> {
    /// `d`
    direction: Vector<R>,
    /// `oc`, from the centre to the ray's origin.
    from_center: Vector<R>,
    /// `r`
    radius: R,
    /// `d.d`
    a: R,
    /// `d.oc`, half the linear coefficient.
    b: R,
    /// `|oc|^2 - r^2`
    c: R,
}

impl<R: Real> Terms<R> {
    #[inline(always)]
    pub(crate) fn new(
        &RoundedSphere { center, radius }: &RoundedSphere<R>,
        &RoundedRay { origin, direction }: &RoundedRay<R>,
    ) -> Self {
        let from_center = minus(origin, center);
        Terms {
            direction,
            from_center,
            radius,
            a: dot(direction, direction),
            b: dot(direction, from_center),
            c: dot(from_center, from_center) - radius * radius,
        }
    }

    /// Returns `t` of the ray's point nearest to the sphere's centre, and the vector from the centre to that
    /// point.
    #[inline(always)]
    fn nearest_point(&self) -> (R, Vector<R>) {
        let t = -(self.b / self.a);
        (t, plus(self.from_center, times(t, self.direction)))
    }

    /// Returns `t` of the first hit, from the roots `q / a` and `c / q`, see
    /// [`Formula::HalfB`](crate::methods::Formula::HalfB).
    #[inline(always)]
    fn first_by_q(&self, discriminant: R) -> R {
        let q = -(self.b + discriminant.sqrt().copysign(self.b));
        first_of(q / self.a, self.c / q)
    }
}

/// A formula for the intersection of a ray and a sphere, in numbers of type `R`. It is inlined and
/// written without branches, so that a loop over directions can be vectorized.
pub(crate) trait Intersect<R: Real>: Send + Sync + 'static {
    /// Returns the smallest t > 0 at which the ray hits the sphere, as computed by the formula. An
    /// infinite, NaN, zero or negative result means no hit.
    fn first_hit(terms: &Terms<R>) -> R;
}

/// Returns the smaller positive one of two roots, or infinity if neither is positive. The roots may be
/// in either order, or NaN.
#[inline(always)]
fn first_of<R: Real>(s: R, t: R) -> R {
    let s = if s > R::ZERO { s } else { R::INFINITY };
    let t = if t > R::ZERO { t } else { R::INFINITY };
    if s < t { s } else { t }
}

/// [`Formula::Textbook`](crate::methods::Formula::Textbook).
pub(crate) struct Textbook;

impl<R: Real> Intersect<R> for Textbook {
    #[inline(always)]
    fn first_hit(&Terms { a, b, c, .. }: &Terms<R>) -> R {
        let (b, two_a, two_c) = (b + b, a + a, c + c);
        let root = (b * b - two_a * two_c).sqrt();
        first_of((-b - root) / two_a, (-b + root) / two_a)
    }
}

/// [`Formula::HalfB`](crate::methods::Formula::HalfB).
pub(crate) struct HalfB;

impl<R: Real> Intersect<R> for HalfB {
    #[inline(always)]
    fn first_hit(terms: &Terms<R>) -> R {
        terms.first_by_q(terms.b * terms.b - terms.a * terms.c)
    }
}

/// [`Formula::Kahan`](crate::methods::Formula::Kahan).
pub(crate) struct Kahan;

impl<R: Real> Intersect<R> for Kahan {
    #[inline(always)]
    fn first_hit(terms: &Terms<R>) -> R {
        let &Terms { a, b, c, .. } = terms;
        let product = a * c;
        let product_error = (-a).mul_add(c, product);
        terms.first_by_q(b.mul_add(b, -product) + product_error)
    }
}

/// [`Formula::Perpendicular`](crate::methods::Formula::Perpendicular).
pub(crate) struct Perpendicular;

impl<R: Real> Intersect<R> for Perpendicular {
    #[inline(always)]
    fn first_hit(terms: &Terms<R>) -> R {
        let (_, perpendicular) = terms.nearest_point();
        let (length, radius) = (dot(perpendicular, perpendicular).sqrt(), terms.radius);
        terms.first_by_q(terms.a * ((radius + length) * (radius - length)))
    }
}

/// [`Formula::Lagrange`](crate::methods::Formula::Lagrange).
pub(crate) struct Lagrange;

impl<R: Real> Intersect<R> for Lagrange {
    #[inline(always)]
    fn first_hit(terms: &Terms<R>) -> R {
        let moment = cross(terms.from_center, terms.direction);
        terms.first_by_q(terms.radius * terms.radius * terms.a - dot(moment, moment))
    }
}

/// [`Formula::ClosestPoint`](crate::methods::Formula::ClosestPoint).
pub(crate) struct ClosestPoint;

impl<R: Real> Intersect<R> for ClosestPoint {
    #[inline(always)]
    fn first_hit(terms: &Terms<R>) -> R {
        let (closest, perpendicular) = terms.nearest_point();
        let squared = terms.radius * terms.radius - dot(perpendicular, perpendicular);
        let half_chord = (squared / terms.a).sqrt();
        first_of(closest - half_chord, closest + half_chord)
    }
}

/// [`Formula::Recentred`](crate::methods::Formula::Recentred).
pub(crate) struct Recentred;

impl<R: Real> Intersect<R> for Recentred {
    #[inline(always)]
    fn first_hit(terms: &Terms<R>) -> R {
        let (a, (moved_by, moved)) = (terms.a, terms.nearest_point());
        let b = dot(terms.direction, moved);
        let c = dot(moved, moved) - terms.radius * terms.radius;
        let root = (b * b - a * c).sqrt();
        first_of(moved_by + (-b - root) / a, moved_by + (-b + root) / a)
    }
}

/// Returns `t` at which a ray `p + t d` meets a plane with normal n through the point q, by the textbook
/// formula `n.(q - p) / n.d`, which all methods but the ladder use. As with [`Intersect::first_hit`], an
/// infinite, NaN, zero or negative result means no hit.
///
/// Source: Glassner (ed.), *An Introduction to Ray Tracing*, 1989, chapter 2, section 2.2.
///
/// The formula fails if the ray is nearly parallel to the plane, so that cancellation leaves n.d few
/// correct digits.
#[inline(always)]
pub(crate) fn plane_by_textbook<R: Real>(
    &RoundedPlane { point, normal }: &RoundedPlane<R>,
    &RoundedRay { origin, direction }: &RoundedRay<R>,
) -> R {
    dot(normal, minus(point, origin)) / dot(normal, direction)
}
