//! Outward normals of hits, for one ray or a SIMD vector of rays, in `f64` and as accurate as colours
//! need. Where possible, they are computed without `t`.
//!
//! The SIMD code has no closures: the compiler does not always inline a closure's body into the loop
//! around it, and the loop then costs ten times as much.

use glam::DVec3;

use crate::camera::ray::{ExactRay, Ray};
use crate::exact::bounded::{cross, dot};
use crate::exact::double_double::Lane;
use crate::exact::scale::{is_plain_direction, unit};
use crate::exact::steps::Steps;
use crate::scene::Scene;
use crate::scene::object_from_origin::ObjectFromOrigin;
use crate::scene::sphere::Sphere;
use crate::scene::sphere_predicates::SphereFromOrigin;

/// The outward normals of a scene's objects.
pub(crate) struct Normals<'a> {
    spheres: &'a [Sphere],
    of_planes: Vec<DVec3>,
}

/// An object with the data from which its normals are computed.
pub(crate) enum Surface<'a> {
    Sphere(&'a Sphere),
    /// A plane's unit normal.
    Plane(DVec3),
}

impl<'a> Normals<'a> {
    pub(crate) fn new(scene: &'a Scene) -> Self {
        let of_planes = scene.planes().iter().map(|plane| unit(plane.normal)).collect();
        Normals { spheres: scene.spheres(), of_planes }
    }

    /// Returns the object of this index; `None` if the scene has none.
    #[inline(always)]
    pub(crate) fn surface(&self, object: u32) -> Option<Surface<'a>> {
        let index = object as usize;
        match self.spheres.get(index) {
            Some(sphere) => Some(Surface::Sphere(sphere)),
            None => self.of_planes.get(index - self.spheres.len()).copied().map(Surface::Plane),
        }
    }
}

impl Surface<'_> {
    /// Returns the outward unit normal where the ray first hits the object, at `t`.
    pub(crate) fn normal(&self, ray: &Ray, t: f64) -> DVec3 {
        let sphere = match self {
            Surface::Plane(normal) => return *normal,
            Surface::Sphere(sphere) => sphere,
        };
        let d = ray.direction;
        match Ball::new(sphere, ray.origin).filter(|_| is_plain_direction(d)) {
            Some(Ball { q, is_near: true, .. }) if PLAIN_T.contains(&t) => {
                near_normal(q.into(), d.into(), t).into()
            }
            Some(Ball { q, radius, is_near: false }) => {
                far_normal(q.into(), radius, d.into()).into()
            }
            _ => normal_of_first_hit(sphere, ray),
        }
    }

    /// Returns `|n.d| / |d|` for the ray's direction d and the outward unit normal n where the ray first
    /// hits the object.
    pub(crate) fn cosine(&self, ray: &Ray) -> f64 {
        let d = ray.direction;
        match self {
            Surface::Plane(normal) if is_plain_direction(d) => {
                plane_cosine(normal.to_array(), d.to_array())
            }
            Surface::Plane(normal) => normal.dot(unit(d)).abs(),
            Surface::Sphere(sphere) => {
                match Ball::new(sphere, ray.origin).filter(|_| is_plain_direction(d)) {
                    Some(Ball { q, radius, .. }) => {
                        sphere_cosine(q.to_array(), radius * radius, d.to_array(), 1.0)
                    }
                    None => normal_of_first_hit(sphere, ray).dot(unit(d)).abs(),
                }
            }
        }
    }
}

/// Returns the normal at the ray's first hit, from exact decisions. If rounding the ray's direction has
/// moved it past the sphere, the normal points against the ray.
#[cold]
fn normal_of_first_hit(sphere: &Sphere, ray: &Ray) -> DVec3 {
    let Ok(exact) = ExactRay::from_ray(ray) else { return DVec3::ZERO };
    let seen = SphereFromOrigin::new(sphere, ray.origin);
    match ObjectFromOrigin::Sphere(seen.clone()).first_root(&exact, &mut Steps::default()) {
        Some(end) => seen.normal(&exact, end),
        None => -unit(ray.direction),
    }
}

/// Distance of the eye from a sphere's centre, in radii, up to which `p + t d - center` gives a normal
/// within 1e-6, even from a `t` in `f32`.
const NEAR: f64 = 8.0;

/// Distance of the eye from a sphere's centre, in radii, up to which [`far_normal`] gives a normal
/// within 1e-6.
const FAR: f64 = 1e6;

/// The range of `t` that keeps its digits in `f32`, too.
pub(crate) const PLAIN_T: std::ops::Range<f64> = 1e-37..1e38;

/// A sphere as seen from the eye, if its size and distance need no scaling to avoid overflow and
/// underflow.
#[derive(Clone, Copy)]
pub(crate) struct Ball {
    /// The vector from the centre to the eye.
    pub(crate) q: DVec3,
    pub(crate) radius: f64,
    /// True if `q + t d` is accurate enough to compute the normal from it.
    pub(crate) is_near: bool,
}

impl Ball {
    /// Computes q. Returns `None` if the sphere is too far away for its size, or its size is extreme.
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
fn over<L: Lane>(a: [L; 3], b: L) -> [L; 3] {
    [a[0] / b, a[1] / b, a[2] / b]
}

/// Returns `|n.d| / |d|` where a ray of direction d from the origin meets the sphere of radius r around
/// -q, with the normal n: `sqrt(1 - |q x d|^2 / (d.d r^2))`, at either root; 0 if rounding has moved the
/// ray past the sphere.
///
/// The error of the square is a few roundings times `(|q| / r)^2`, not counting the error of q itself.
#[inline(always)]
pub(crate) fn sphere_cosine<L: Lane>(q: [L; 3], r_squared: L, d: [L; 3], one: L) -> L {
    let across = cross(q, d);
    (one - dot(across, across) / (dot(d, d) * r_squared)).not_negative().sqrt()
}

/// Returns `|n.d| / |d|` for a plane's unit normal n.
#[inline(always)]
pub(crate) fn plane_cosine<L: Lane>(n: [L; 3], d: [L; 3]) -> L {
    let along = dot(n, d);
    (along * along / dot(d, d)).sqrt()
}

/// Returns the outward unit normal at `q + t d`, of a nearby sphere.
#[inline(always)]
pub(crate) fn near_normal<L: Lane>(q: [L; 3], d: [L; 3], t: L) -> [L; 3] {
    let offset = [q[0] + t * d[0], q[1] + t * d[1], q[2] + t * d[2]];
    let length = dot(offset, offset).sqrt();
    over(offset, length)
}

/// Returns the outward unit normal of a distant sphere at the nearer root of a ray from outside:
/// `n = (m - sqrt(r^2 - |m|^2) d / |d|) / r`, from half the chord and the vector
/// `m = d x (q x d) / d.d` from the centre to the ray's point nearest to it. q is the vector from the
/// centre to the eye.
#[inline(always)]
pub(crate) fn far_normal<L: Lane>(q: [L; 3], r: L, d: [L; 3]) -> [L; 3] {
    let length_squared = dot(d, d);
    let middle = over(cross(d, cross(q, d)), length_squared);
    let half_chord = (r * r - dot(middle, middle)).not_negative().sqrt();
    let share = half_chord / length_squared.sqrt();
    let [x, y, z] = [middle[0] - share * d[0], middle[1] - share * d[1], middle[2] - share * d[2]];
    over([x, y, z], r)
}
