//! Outward normals of single hits, in `f64`: as exact as colours need.

use glam::DVec3;

use crate::camera::exact_ray::ExactRay;
use crate::camera::ray::Ray;
use crate::exact::scale::{is_plain_direction, unit};
use crate::exact::steps::Steps;
use crate::render::shade::surface::{
    Ball, PLAIN_T, far_normal, near_normal, plane_cosine, sphere_cosine,
};
use crate::scene::Scene;
use crate::scene::object_from_origin::ObjectFromOrigin;
use crate::scene::sphere::Sphere;
use crate::scene::sphere_predicates::SphereFromOrigin;

/// The outward normals of a scene's objects.
pub(crate) struct Normals<'a> {
    spheres: &'a [Sphere],
    of_planes: Vec<DVec3>,
}

/// An object, as its normals need it.
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

    /// The object, if the scene has it.
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
    /// The outward unit normal where the ray first hits the object, at `t`.
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

    /// `|n.d| / |d|` of that normal n.
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

/// The normal at the ray's first hit, from exact decisions; against the ray where rounding the ray's
/// direction has moved it past the sphere.
#[cold]
fn normal_of_first_hit(sphere: &Sphere, ray: &Ray) -> DVec3 {
    let Ok(exact) = ExactRay::from_ray(ray) else { return DVec3::ZERO };
    let seen = SphereFromOrigin::new(sphere, ray.origin);
    match ObjectFromOrigin::Sphere(seen.clone()).first_root(&exact, &mut Steps::default()) {
        Some(end) => seen.normal(&exact, end),
        None => -unit(ray.direction),
    }
}
