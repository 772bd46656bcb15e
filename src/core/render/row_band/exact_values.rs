//! Values of single pixels by the ladder: `t` in `f64`, and normals, of hits that are known.

use std::ops::Range;

use glam::DVec3;

use crate::render::frame::NO_OBJECT;
use crate::render::plan::Plan;
use crate::render::polynomial::frame_rays::PixelRays;
use crate::scene::object_from_origin::{ObjectFromOrigin, plane_normal};

/// Fills in `t` and normals of the pixels in some rows, whose objects are known; neither where there
/// is no room for it.
pub(crate) fn fill_exactly(
    plan: &Plan,
    rows: Range<usize>,
    object: &[u32],
    t: &mut [f64],
    normals: &mut [DVec3],
) {
    if t.is_empty() && normals.is_empty() {
        return;
    }
    let (camera, width) = (plan.rays.camera(), plan.axes.width());
    let rays = PixelRays::new(&plan.rays);
    let mut known: Option<(u32, ObjectFromOrigin)> = None;
    for (row, start) in rows.zip((0..).step_by(width)) {
        let part = rays.row_part(row);
        for column in 0..width {
            let (place, index) = (start + column, object[start + column]);
            if index == NO_OBJECT {
                if let Some(t) = t.get_mut(place) {
                    *t = f64::INFINITY;
                }
                continue;
            }
            let seen = match known.take() {
                Some((known, seen)) if known == index => seen,
                _ => match plan.scene.object(index) {
                    Some(object) => ObjectFromOrigin::new(&object, camera.eye()),
                    None => continue,
                },
            };
            let root = seen.root_of_hit();
            if let Some(t) = t.get_mut(place) {
                *t = seen.t(&rays.ray((row, &part), column), root).to_f64();
            }
            if let Some(normal) = normals.get_mut(place) {
                *normal = match &seen {
                    ObjectFromOrigin::Plane(seen) => plane_normal(seen.plane().normal),
                    ObjectFromOrigin::Sphere(seen) => {
                        seen.normal(&camera.exact_ray(plan.rays.pixel(row, column)), root)
                    }
                };
            }
            known = Some((index, seen));
        }
    }
}
