//! The known formulas for a ray and a sphere, and the textbook's for a ray and a plane. Each is
//! written once, for any [`Real`].
//!
//! With `oc = p - center` and `f(t) = |oc + t d|^2 - r^2`, all of them solve
//!
//! ```text
//! a t^2 + 2 b t + c = 0     a = d.d     b = d.oc     c = |oc|^2 - r^2     D = b^2 - a c
//! ```
//!
//! They agree in real arithmetic. They differ in what rounding leaves of D.

use std::marker::PhantomData;

use crate::method_real::{Fused, Real, RoundedPlane, RoundedSphere, Vector};

/// A way to intersect rays with a sphere.
///
/// The value holds what all rays of one origin share of the sphere; [`Intersect::first_hit`] is then
/// asked for each direction. Everything is inlined, and written without branches, so that a loop over
/// directions can be vectorized.
pub trait Intersect: Send + Sync + 'static {
    /// The precision of every operation and of the answer.
    type Real: Real;

    /// What the rays from `origin` share of the sphere.
    fn new(sphere: &RoundedSphere<Self::Real>, origin: Vector<Self::Real>) -> Self;

    /// The smallest t > 0 at which the method finds the sphere. No hit is anything else: infinite,
    /// NaN, zero or negative; [`is_hit`] tells.
    fn first_hit(&self, direction: Vector<Self::Real>) -> Self::Real;
}

/// Whether an answer of [`Intersect::first_hit`] or [`PlaneByTextbook::first_hit`] is a hit: positive
/// and finite.
#[inline(always)]
pub fn is_hit<R: Real>(t: R) -> bool {
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

/// Of two roots, the smallest that is a hit; either may be the smaller one, or NaN.
#[inline(always)]
fn first_of<R: Real>(s: R, t: R) -> R {
    let s = if s > R::ZERO { s } else { R::INFINITY };
    let t = if t > R::ZERO { t } else { R::INFINITY };
    if s < t { s } else { t }
}

/// The textbook's `t = (-b -+ sqrt(b^2 - 4 a c)) / (2 a)` with `b = 2 d.oc`, both roots.
///
/// Source: Glassner (ed.), *An Introduction to Ray Tracing*, Academic Press 1989, chapter 2, section
/// 2.1; Marschner, Shirley, *Fundamentals of Computer Graphics*, 4th ed., section 4.4.1.
///
/// Fails where b^2 and 4 a c are much larger than their difference: distant or grazed spheres, and
/// where b and the root nearly cancel: the near root of a large sphere close to the eye.
pub struct Textbook<R>(Shared<R>);

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
pub trait Discriminant<R: Real>: Send + Sync + 'static {
    /// D from `a`, `b`, `c`, `oc`, the direction and the radius.
    fn discriminant(quadratic: &Quadratic<R>) -> R;
}

/// What a [`Discriminant`] may use.
pub struct Quadratic<R> {
    /// `d.d`
    pub a: R,
    /// `d.oc`, half the linear coefficient.
    pub b: R,
    /// `|oc|^2 - r^2`
    pub c: R,
    /// `oc`, from the centre to the origin.
    pub from_center: Vector<R>,
    /// `d`
    pub direction: Vector<R>,
    /// `r`
    pub radius: R,
}

/// Half the linear coefficient, and the roots `q / a` and `c / q` with `q = -(b + sign(b) sqrt D)`,
/// in which nothing cancels but what is in D. `D` says how that is computed.
///
/// Source: Press, Teukolsky, Vetterling, Flannery, *Numerical Recipes*, 3rd ed., section 5.6,
/// equations 5.6.4 and 5.6.5.
pub struct ByQ<R, D> {
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
        let discriminant = D::discriminant(&Quadratic { a, b, c, from_center, direction, radius });
        let q = -(b + discriminant.sqrt().copysign(b));
        first_of(q / a, c / q)
    }
}

/// `b^2 - a c` as it stands.
///
/// Fails like [`Textbook`] where b^2 and a c nearly cancel; the near root of a large sphere is good
/// as long as c is.
pub struct Plain;

impl<R: Real> Discriminant<R> for Plain {
    #[inline(always)]
    fn discriminant(&Quadratic { a, b, c, .. }: &Quadratic<R>) -> R {
        b * b - a * c
    }
}

/// Kahan's `b^2 - a c` with fused multiply-adds: `w = a c`, `(b b - w) + (w - a c)`, within 1.5 ulp
/// of the exact value for the a, b, c at hand.
///
/// Source: Jeannerod, Louvet, Muller, *Further analysis of Kahan's algorithm for the accurate
/// computation of 2 x 2 determinants*, Mathematics of Computation 82 (2013), pages 2245-2264.
///
/// Fails like [`Plain`]: a, b and c are rounded before, and that error is as large as the one that is
/// avoided.
pub struct Kahan;

impl<R: Fused> Discriminant<R> for Kahan {
    #[inline(always)]
    fn discriminant(&Quadratic { a, b, c, .. }: &Quadratic<R>) -> R {
        let product = a * c;
        let product_error = (-a).mul_add(c, product);
        b.mul_add(b, -product) + product_error
    }
}

/// `a (r + l)(r - l)` with l the length of `oc - (b / a) d`, the vector from the centre at right
/// angles to the ray.
///
/// Source: Haines, Guenther, Akenine-Moeller, *Precision improvements for ray/sphere intersection*,
/// Ray Tracing Gems (2019), chapter 7, pages 87-94; with r^2 - l^2 factored as in Pharr, Jakob,
/// Humphreys, *Physically Based Rendering*, 4th ed., section 6.8.3.
///
/// Fails where that vector loses its digits, because `oc` is much longer than it: tiny far spheres.
pub struct Perpendicular;

impl<R: Real> Discriminant<R> for Perpendicular {
    #[inline(always)]
    fn discriminant(quadratic: &Quadratic<R>) -> R {
        let &Quadratic { a, b, from_center, direction, radius, .. } = quadratic;
        let perpendicular = from_center - direction.times(b / a);
        let length = perpendicular.dot(perpendicular).sqrt();
        a * ((radius + length) * (radius - length))
    }
}

/// `r^2 a - |oc x d|^2`, because `a |oc|^2 - b^2 = |oc x d|^2`.
///
/// Source: Lagrange's identity, *Solutions analytiques de quelques problemes sur les pyramides
/// triangulaires*, 1773 (Steele, *The Cauchy-Schwarz Master Class*, 2004, chapter 3).
///
/// Fails where `oc x d` loses its digits, which is late, and near the surface of a large sphere,
/// where D is small against both terms.
pub struct Lagrange;

impl<R: Real> Discriminant<R> for Lagrange {
    #[inline(always)]
    fn discriminant(quadratic: &Quadratic<R>) -> R {
        let &Quadratic { a, from_center, direction, radius, .. } = quadratic;
        let moment = from_center.cross(direction);
        radius * radius * a - moment.dot(moment)
    }
}

/// The ray's point closest to the centre, and half the chord: `t = -b / a -+ sqrt((r^2 - l^2) / a)`
/// with l the distance of that point from the centre.
///
/// Source: Embree (Wald, Woop, Benthin, Johnson, Ernst, *Embree: a kernel framework for efficient CPU
/// ray tracing*, ACM Transactions on Graphics 33(4), 2014), `kernels/geometry/sphere_intersector.h`.
///
/// Fails like [`Perpendicular`], and where the two terms nearly cancel: the near root of a large
/// sphere close to the eye.
pub struct ClosestPoint<R> {
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

/// Moves the origin along the ray to the point nearest to the centre, `t0 = -b / a`, and solves the
/// half-b equation from there, where b is almost 0: `t = t0 + (-b' -+ sqrt(b'^2 - a c')) / a`.
///
/// Source: Embree, which does so for curves ("move ray closer to make intersection stable",
/// `kernels/geometry/curve_intersector_sweep.h`).
///
/// Fails where the moved origin loses its digits (tiny far spheres) and where t0 and the rest nearly
/// cancel (a large sphere close to the eye).
pub struct Recentred<R> {
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

/// A plane by the textbook: `t = n.(q - p) / n.d`, which all methods but the ladder use.
///
/// Source: Glassner (ed.), *An Introduction to Ray Tracing*, 1989, chapter 2, section 2.2.
///
/// Fails where n.d loses its digits, because the ray is nearly parallel to the plane.
pub struct PlaneByTextbook<R> {
    normal: Vector<R>,
    offset: R,
}

impl<R: Real> PlaneByTextbook<R> {
    /// What the rays from `origin` share of the plane.
    #[inline(always)]
    pub fn new(plane: &RoundedPlane<R>, origin: Vector<R>) -> Self {
        PlaneByTextbook { normal: plane.normal, offset: plane.normal.dot(plane.point - origin) }
    }

    /// As [`Intersect::first_hit`].
    #[inline(always)]
    pub fn first_hit(&self, direction: Vector<R>) -> R {
        self.offset / self.normal.dot(direction)
    }
}
