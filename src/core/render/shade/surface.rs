//! The numbers of a surface that colours need, for one ray or several side by side: normals in
//! `f64`, without `t` where it can be.
//!
//! No closures here: what a closure does in vectors is not always put into the loop around it, and
//! then costs ten times as much.

use glam::DVec3;

use crate::exact::error_free::Lane;
use crate::scene::sphere::Sphere;

/// Number of radii of distance up to which `p + t d - center` keeps a normal's digits within 1e-6
/// even from a `t` in `f32`.
const NEAR: f64 = 8.0;

/// Number of radii of distance up to which the ray's point nearest to the centre keeps a normal's
/// digits within 1e-6.
const FAR: f64 = 1e6;

/// A `t` that has its digits in `f32` too.
pub(crate) const PLAIN_T: std::ops::Range<f64> = 1e-37..1e38;

/// The eye and a sphere, of measures that need no scaling.
#[derive(Clone, Copy)]
pub(crate) struct Ball {
    /// The way from the centre to the eye.
    pub(crate) q: DVec3,
    pub(crate) radius: f64,
    /// True if the normal is kept by `q + t d`.
    pub(crate) is_near: bool,
}

impl Ball {
    /// `None` where the sphere is too far for its size, or of extreme measures.
    #[inline(always)]
    pub(crate) fn new(sphere: &Sphere, eye: DVec3) -> Option<Ball> {
        let (q, radius) = (eye - sphere.center, sphere.radius);
        let (near, far) = (NEAR * radius, FAR * radius);
        let away = q.length_squared();
        let is_plain = away < far * far && (1e-60..1e60).contains(&radius);
        is_plain.then_some(Ball { q, radius, is_near: away < near * near })
    }
}

#[inline(always)]
pub(crate) fn dot<L: Lane>(a: [L; 3], b: [L; 3]) -> L {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross<L: Lane>(a: [L; 3], b: [L; 3]) -> [L; 3] {
    [a[1] * b[2] - b[1] * a[2], a[2] * b[0] - b[2] * a[0], a[0] * b[1] - b[0] * a[1]]
}

#[inline(always)]
fn over<L: Lane>(a: [L; 3], b: L) -> [L; 3] {
    [a[0] / b, a[1] / b, a[2] / b]
}

/// `|n.d| / |d|` where the ray of direction d meets the sphere of radius r whose centre is at -q:
/// `sqrt(1 - |q x d|^2 / (d.d r^2))`, at both roots; 0 where rounding has moved the ray past it.
///
/// The error of the square is a few roundings times `(|q| / r)^2`, that of q itself left aside.
#[inline(always)]
pub(crate) fn sphere_cosine<L: Lane>(q: [L; 3], r_squared: L, d: [L; 3], one: L) -> L {
    let across = cross(q, d);
    (one - dot(across, across) / (dot(d, d) * r_squared)).not_negative().sqrt()
}

/// `|n.d| / |d|` of a plane's unit normal n.
#[inline(always)]
pub(crate) fn plane_cosine<L: Lane>(n: [L; 3], d: [L; 3]) -> L {
    let along = dot(n, d);
    (along * along / dot(d, d)).sqrt()
}

/// The outward unit normal at `q + t d`, of a sphere nearby.
#[inline(always)]
pub(crate) fn near_normal<L: Lane>(q: [L; 3], d: [L; 3], t: L) -> [L; 3] {
    let offset = [q[0] + t * d[0], q[1] + t * d[1], q[2] + t * d[2]];
    let length = dot(offset, offset).sqrt();
    over(offset, length)
}

/// The outward unit normal at the nearer root, of a sphere that is seen from outside, far away: from
/// the ray's point nearest to the centre and half the chord,
/// `n = (m - sqrt(r^2 - |m|^2) d / |d|) / r` with `m = d x (q x d) / d.d`.
#[inline(always)]
pub(crate) fn far_normal<L: Lane>(q: [L; 3], r: L, d: [L; 3]) -> [L; 3] {
    let length_squared = dot(d, d);
    let middle = over(cross(d, cross(q, d)), length_squared);
    let half_chord = (r * r - dot(middle, middle)).not_negative().sqrt();
    let share = half_chord / length_squared.sqrt();
    let [x, y, z] = [middle[0] - share * d[0], middle[1] - share * d[1], middle[2] - share * d[2]];
    over([x, y, z], r)
}
