//! The known formulas for a ray and a sphere, and the textbook's for a ray and a plane. Each is
//! written once, for any [`Real`].
//!
//! With `oc = p - center` and `f(t) = |oc + t d|^2 - r^2`, all of them solve
//!
//! ```text
//! a t^2 + 2 b t + c = 0     a = d.d     b = d.oc     c = |oc|^2 - r^2     D = b^2 - a c
//! ```
//!
//! The formulas agree in real arithmetic. They differ in what rounding leaves of D.

use std::marker::PhantomData;

use crate::methods::number::{Fused, Real, RoundedPlane, RoundedSphere, Vector};

/// A way to intersect rays with a sphere.
///
/// A value holds the terms that all rays of one origin share for the sphere; [`Intersect::first_hit`] is
/// then called for each direction. Everything is inlined and written without branches, so that a loop
/// over directions can be vectorized.
pub(crate) trait Intersect: Send + Sync + 'static {
    /// The precision of every operation and of the answer.
    type Real: Real;

    /// Computes the terms of the sphere that the rays from `origin` share.
    fn new(sphere: &RoundedSphere<Self::Real>, origin: Vector<Self::Real>) -> Self;

    /// Returns the smallest t > 0 at which the method finds the sphere. Any other value means no hit:
    /// infinite, NaN, zero or negative; see [`is_hit`].
    fn first_hit(&self, direction: Vector<Self::Real>) -> Self::Real;
}

/// Returns whether an answer of [`Intersect::first_hit`] or [`PlaneByTextbook::first_hit`] is a
/// hit: positive and finite.
#[inline(always)]
pub(crate) fn is_hit<R: Real>(t: R) -> bool {
    t > R::ZERO && t < R::INFINITY
}

/// `oc`, `c` and `r` of a sphere and an origin.
#[derive(Clone, Copy)]
struct Shared<R> {
    from_center: Vector<R>,
    c: R,
    radius: R,
}

impl<R: Real> Shared<R> {
    #[inline(always)]
    fn new(sphere: &RoundedSphere<R>, origin: Vector<R>) -> Self {
        let RoundedSphere { center, radius } = *sphere;
        let from_center = origin - center;
        Shared { from_center, c: from_center.dot(from_center) - radius * radius, radius }
    }
}

/// Returns the smaller of two roots that is a hit; the roots may be in either order, or NaN.
#[inline(always)]
fn first_of<R: Real>(s: R, t: R) -> R {
    let s = if s > R::ZERO { s } else { R::INFINITY };
    let t = if t > R::ZERO { t } else { R::INFINITY };
    if s < t { s } else { t }
}

/// [`Formula::Textbook`](crate::methods::Formula::Textbook).
pub(crate) struct Textbook<R>(Shared<R>);

impl<R: Real> Intersect for Textbook<R> {
    type Real = R;

    #[inline(always)]
    fn new(sphere: &RoundedSphere<R>, origin: Vector<R>) -> Self {
        Textbook(Shared::new(sphere, origin))
    }

    #[inline(always)]
    fn first_hit(&self, direction: Vector<R>) -> R {
        let Shared { from_center, c, .. } = self.0;
        let a = direction.dot(direction);
        let half_b = direction.dot(from_center);
        let (b, two_a) = (half_b + half_b, a + a);
        let (two_c, minus_b) = (c + c, -b);
        let root = (b * b - two_a * two_c).sqrt();
        first_of((minus_b - root) / two_a, (minus_b + root) / two_a)
    }
}

/// A way to compute `D = b^2 - a c`.
pub(crate) trait Discriminant<R: Real>: Send + Sync + 'static {
    /// Computes D from `a`, `b`, `c`, `oc`, the direction and the radius.
    fn discriminant(quadratic: &DiscriminantTerms<R>) -> R;
}

/// The numbers that a [`Discriminant`] may use.
pub(crate) struct DiscriminantTerms<R> {
    /// `d.d`
    pub(crate) a: R,
    /// `d.oc`, half the linear coefficient.
    pub(crate) b: R,
    /// `|oc|^2 - r^2`
    pub(crate) c: R,
    /// `oc`, from the centre to the origin.
    pub(crate) from_center: Vector<R>,
    /// `d`
    pub(crate) direction: Vector<R>,
    /// `r`
    pub(crate) radius: R,
}

/// Computes the roots by q, see [`Formula::HalfB`](crate::methods::Formula::HalfB); the type `D` says
/// how D is computed.
pub(crate) struct ByQ<R, D> {
    shared: Shared<R>,
    discriminant: PhantomData<fn() -> D>,
}

impl<R: Real, D: Discriminant<R>> Intersect for ByQ<R, D> {
    type Real = R;

    #[inline(always)]
    fn new(sphere: &RoundedSphere<R>, origin: Vector<R>) -> Self {
        ByQ { shared: Shared::new(sphere, origin), discriminant: PhantomData }
    }

    #[inline(always)]
    fn first_hit(&self, direction: Vector<R>) -> R {
        let Shared { from_center, c, radius } = self.shared;
        let (a, b) = (direction.dot(direction), direction.dot(from_center));
        let discriminant =
            D::discriminant(&DiscriminantTerms { a, b, c, from_center, direction, radius });
        let q = -(b + discriminant.sqrt().copysign(b));
        first_of(q / a, c / q)
    }
}

/// Computes D as `b^2 - a c`, as in [`Formula::HalfB`](crate::methods::Formula::HalfB).
pub(crate) struct Plain;

impl<R: Real> Discriminant<R> for Plain {
    #[inline(always)]
    fn discriminant(&DiscriminantTerms { a, b, c, .. }: &DiscriminantTerms<R>) -> R {
        b * b - a * c
    }
}

/// Computes D as in [`Formula::Kahan`](crate::methods::Formula::Kahan).
pub(crate) struct Kahan;

impl<R: Fused> Discriminant<R> for Kahan {
    #[inline(always)]
    fn discriminant(&DiscriminantTerms { a, b, c, .. }: &DiscriminantTerms<R>) -> R {
        let product = a * c;
        let product_error = (-a).mul_add(c, product);
        b.mul_add(b, -product) + product_error
    }
}

/// Computes D as in [`Formula::Perpendicular`](crate::methods::Formula::Perpendicular).
pub(crate) struct Perpendicular;

impl<R: Real> Discriminant<R> for Perpendicular {
    #[inline(always)]
    fn discriminant(quadratic: &DiscriminantTerms<R>) -> R {
        let &DiscriminantTerms { a, b, from_center, direction, radius, .. } = quadratic;
        let perpendicular = from_center - direction.times(b / a);
        let length = perpendicular.dot(perpendicular).sqrt();
        a * ((radius + length) * (radius - length))
    }
}

/// Computes D as in [`Formula::Lagrange`](crate::methods::Formula::Lagrange).
pub(crate) struct Lagrange;

impl<R: Real> Discriminant<R> for Lagrange {
    #[inline(always)]
    fn discriminant(quadratic: &DiscriminantTerms<R>) -> R {
        let &DiscriminantTerms { a, from_center, direction, radius, .. } = quadratic;
        let moment = from_center.cross(direction);
        radius * radius * a - moment.dot(moment)
    }
}

/// [`Formula::ClosestPoint`](crate::methods::Formula::ClosestPoint).
pub(crate) struct ClosestPoint<R> {
    to_center: Vector<R>,
    radius: R,
}

impl<R: Real> Intersect for ClosestPoint<R> {
    type Real = R;

    #[inline(always)]
    fn new(sphere: &RoundedSphere<R>, origin: Vector<R>) -> Self {
        ClosestPoint { to_center: sphere.center - origin, radius: sphere.radius }
    }

    #[inline(always)]
    fn first_hit(&self, direction: Vector<R>) -> R {
        let a = direction.dot(direction);
        let closest = self.to_center.dot(direction) / a;
        let perpendicular = self.to_center - direction.times(closest);
        let squared = self.radius * self.radius - perpendicular.dot(perpendicular);
        let half_chord = (squared / a).sqrt();
        first_of(closest - half_chord, closest + half_chord)
    }
}

/// [`Formula::Recentred`](crate::methods::Formula::Recentred).
pub(crate) struct Recentred<R> {
    from_center: Vector<R>,
    radius_squared: R,
}

impl<R: Real> Intersect for Recentred<R> {
    type Real = R;

    #[inline(always)]
    fn new(sphere: &RoundedSphere<R>, origin: Vector<R>) -> Self {
        Recentred {
            from_center: origin - sphere.center,
            radius_squared: sphere.radius * sphere.radius,
        }
    }

    #[inline(always)]
    fn first_hit(&self, direction: Vector<R>) -> R {
        let a = direction.dot(direction);
        let moved_by = -(direction.dot(self.from_center) / a);
        let moved = self.from_center + direction.times(moved_by);
        let b = direction.dot(moved);
        let c = moved.dot(moved) - self.radius_squared;
        let root = (b * b - a * c).sqrt();
        first_of(moved_by + (-b - root) / a, moved_by + (-b + root) / a)
    }
}

/// The textbook's plane intersection, `t = n.(q - p) / n.d`, which all methods but the ladder use.
///
/// Source: Glassner (ed.), *An Introduction to Ray Tracing*, 1989, chapter 2, section 2.2.
///
/// The formula fails where n.d loses its digits, because the ray is nearly parallel to the plane.
pub(crate) struct PlaneByTextbook<R> {
    normal: Vector<R>,
    offset: R,
}

impl<R: Real> PlaneByTextbook<R> {
    /// Computes the terms of the plane that the rays from `origin` share.
    #[inline(always)]
    pub(crate) fn new(plane: &RoundedPlane<R>, origin: Vector<R>) -> Self {
        PlaneByTextbook { normal: plane.normal, offset: plane.normal.dot(plane.point - origin) }
    }

    /// Returns `t`, by the same convention as [`Intersect::first_hit`].
    #[inline(always)]
    pub(crate) fn first_hit(&self, direction: Vector<R>) -> R {
        self.offset / self.normal.dot(direction)
    }
}
