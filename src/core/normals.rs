//! Outward normals of many hits, in `f64`: as exact as colours need.

use glam::DVec3;

use crate::exact_ray::ExactRay;
use crate::precise::T_DOUBT;
use crate::ray::Ray;
use crate::scale::{PLAIN_LENGTH_SQUARED, is_plain_direction, unit};
use crate::scene::Scene;
use crate::seen::ObjectSeen;
use crate::sphere::Sphere;
use crate::sphere_seen::SphereSeen;
use crate::steps::Steps;

/// The outward normals of a scene's objects, for many hits.
pub(crate) struct Normals<'a> {
    spheres: &'a [Sphere],
    of_planes: Vec<DVec3>,
}

impl<'a> Normals<'a> {
    pub(crate) fn new(scene: &'a Scene) -> Self {
        let of_planes = scene.planes().iter().map(|plane| unit(plane.normal)).collect();
        Normals { spheres: scene.spheres(), of_planes }
    }

    /// The outward unit normal where the ray meets the object at the root `t`; zero for an object that the scene does not have.
    #[inline(always)]
    pub(crate) fn at(&self, object: u32, ray: &Ray, t: f64) -> DVec3 {
        let index = object as usize;
        match self.spheres.get(index) {
            Some(sphere) => normal(sphere, ray, t),
            None => self.of_planes.get(index - self.spheres.len()).copied().unwrap_or_default(),
        }
    }

    /// `|n.d| / |d|` of the same normal n. Not by way of [`Normals::at`], because a vector that
    /// either arm may make goes through memory, which costs more than all the arithmetic.
    #[inline(always)]
    pub(crate) fn cosine(&self, object: u32, ray: &Ray, t: f64) -> f64 {
        let (index, direction) = (object as usize, ray.direction);
        match self.spheres.get(index) {
            Some(sphere) => cosine(sphere, ray, t),
            None => match self.of_planes.get(index - self.spheres.len()) {
                Some(normal) if is_plain_direction(direction) => {
                    normal.dot(direction).abs() / direction.length()
                }
                Some(normal) => normal.dot(unit(direction)).abs(),
                None => 0.0,
            },
        }
    }
}

/// The outward unit normal where the ray meets the sphere at the root `t`.
#[inline(always)]
fn normal(sphere: &Sphere, ray: &Ray, t: f64) -> DVec3 {
    // A copy for the rare case: a ray whose address is taken would live in memory, and going there
    // costs more than all the arithmetic here.
    let copy = *ray;
    let (offset, length) = offset(sphere, ray.origin, ray.direction, t);
    if length > 0.0 { offset / length } else { normal_from_afar(sphere, copy, t) }
}

/// `|n.d| / |d|` of that normal n.
#[inline(always)]
fn cosine(sphere: &Sphere, ray: &Ray, t: f64) -> f64 {
    let Ray { origin, direction } = *ray;
    let (offset, length) = offset(sphere, origin, direction, t);
    if length > 0.0 && is_plain_direction(direction) {
        offset.dot(direction).abs() / (length * direction.length())
    } else {
        normal_from_afar(sphere, Ray { origin, direction }, t).dot(unit(direction)).abs()
    }
}

/// `p + t d - center` and its length; a length of 0 where the digits of the normal are lost.
#[inline(always)]
fn offset(sphere: &Sphere, origin: DVec3, direction: DVec3, t: f64) -> (DVec3, f64) {
    /// Up to this many radii away, `p + t d - center` keeps a normal's digits within 1e-6 even from
    /// a `t` in `f32`.
    const NEAR: f64 = 8.0;
    let from_center = origin - sphere.center;
    let near = NEAR * sphere.radius;
    let offset = from_center + t * direction;
    let length_squared = offset.length_squared();
    let is_kept = from_center.length_squared() < near * near
        && PLAIN_LENGTH_SQUARED.contains(&length_squared);
    (offset, if is_kept { length_squared.sqrt() } else { 0.0 })
}

/// The normal of a sphere that is seen from outside, far away: from the ray's point nearest to the
/// centre and half the chord, `n = (m - sqrt(r^2 - |m|^2) d / |d|) / r` with
/// `m = d x ((p - center) x d) / d.d`, which needs no t.
fn normal_from_afar(sphere: &Sphere, ray: Ray, t: f64) -> DVec3 {
    /// Up to this many radii away, m keeps a normal's digits within 1e-6.
    const FAR: f64 = 1e6;
    let (from_center, d, r) = (ray.origin - sphere.center, ray.direction, sphere.radius);
    let far = FAR * r;
    let distance_squared = from_center.length_squared();
    if !(is_plain_direction(d) && distance_squared < far * far && (1e-60..1e60).contains(&r)) {
        return normal_of_nearest_root(sphere, ray, t);
    }
    let middle = d.cross(from_center.cross(d)) / d.length_squared();
    let half_chord = (r * r - middle.length_squared()).max(0.0).sqrt();
    unit(middle - half_chord * unit(d))
}

/// The normal at whichever of the ray's roots is nearest to `t`; against the ray where rounding the
/// ray's direction has moved it past the sphere.
#[cold]
fn normal_of_nearest_root(sphere: &Sphere, ray: Ray, t: f64) -> DVec3 {
    let Ok(exact) = ExactRay::of(&ray) else { return DVec3::ZERO };
    let seen = SphereSeen::new(sphere, ray.origin);
    let ends = ObjectSeen::Sphere(seen.clone()).ends(&exact, &mut Steps::default());
    let apart = |end| (seen.t(&exact, end, T_DOUBT).to_f64() - t).abs();
    match ends.iter().copied().min_by(|a, b| apart(*a).total_cmp(&apart(*b))) {
        Some(end) => seen.normal(&exact, end),
        None => -unit(ray.direction),
    }
}
