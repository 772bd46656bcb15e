//! The ray tracer that students write first, as a rival: in `f32`, it intersects each pixel's ray with
//! every sphere by solving the quadratic equation. Rows are traced in parallel.

use glam::Vec3;
use pinhole_core::{NO_OBJECT, ResolvedCamera, Scene, Sphere};
use rayon::prelude::*;

use super::frames::{Buffers, Rays};

/// A sphere in `f32`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ball {
    pub(crate) center: Vec3,
    pub(crate) radius: f32,
}

/// The nearest hit so far.
#[derive(Clone, Copy)]
pub(crate) struct Nearest {
    pub(crate) t: f32,
    pub(crate) object: u32,
}

impl Nearest {
    pub(crate) const NONE: Nearest = Nearest { t: f32::INFINITY, object: NO_OBJECT };
}

/// Rounds the spheres of a scene.
pub(crate) fn balls(scene: &Scene) -> Vec<Ball> {
    let ball =
        |sphere: &Sphere| Ball { center: sphere.center.as_vec3(), radius: sphere.radius as f32 };
    scene.spheres().iter().map(ball).collect()
}

/// Traces a frame.
pub(crate) fn trace(balls: &[Ball], camera: &ResolvedCamera, buffers: &mut Buffers) {
    let rays = Rays::new(camera);
    each_pixel(buffers, |row, column| {
        let direction = rays.direction(row, column);
        let mut nearest = Nearest::NONE;
        for (object, ball) in (0..).zip(balls) {
            if let Some(t) = ball.first_root(rays.eye, direction)
                && t < nearest.t
            {
                nearest = Nearest { t, object };
            }
        }
        nearest
    });
}

/// Fills the buffers, with rows in parallel.
pub(crate) fn each_pixel(buffers: &mut Buffers, hit: impl Fn(usize, usize) -> Nearest + Sync) {
    let Buffers { width, t, object } = buffers;
    let rows = t.par_chunks_mut(*width).zip(object.par_chunks_mut(*width)).enumerate();
    rows.for_each(|(row, (t, object))| {
        for (column, (t, object)) in t.iter_mut().zip(object).enumerate() {
            let nearest = hit(row, column);
            (*t, *object) = (nearest.t, nearest.object);
        }
    });
}

impl Ball {
    /// Returns the smallest positive root of `a t^2 + b t + c = 0` with
    ///
    /// ```text
    /// a = d.d    b = 2 oc.d    c = oc.oc - r^2    t = (-b -+ sqrt(b^2 - 4ac)) / 2a
    /// ```
    ///
    /// Glassner (ed.), An Introduction to Ray Tracing (1989), section 2.1.
    #[inline]
    pub(crate) fn first_root(&self, origin: Vec3, direction: Vec3) -> Option<f32> {
        let from_center = origin - self.center;
        let a = direction.dot(direction);
        let b = 2.0 * from_center.dot(direction);
        let c = from_center.dot(from_center) - self.radius * self.radius;
        let discriminant = b * b - 4.0 * a * c;
        if discriminant < 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        let near = (-b - root) / (2.0 * a);
        if near > 0.0 {
            return Some(near);
        }
        let far = (-b + root) / (2.0 * a);
        (far > 0.0).then_some(far)
    }
}
