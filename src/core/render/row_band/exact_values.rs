//! Values of single pixels by the ladder: `t` in `f64`, and normals, of hits that are known.

use std::ops::Range;

use glam::DVec3;

use crate::exact::steps::Steps;
use crate::render::frame::NO_OBJECT;
use crate::render::plan::Plan;
use crate::scene::object_from_origin::{ObjectFromOrigin, plane_normal};

/// Fills in `t` and normals of the pixels in some rows, whose objects are known; neither where there
/// is no room for it. Returns the steps that `t` took.
pub(crate) fn fill_exactly(
    plan: &Plan,
    rows: Range<usize>,
    object: &[u32],
    t: &mut [f64],
    normals: &mut [DVec3],
) -> Steps {
    let mut steps = Steps::default();
    if t.is_empty() && normals.is_empty() {
        return steps;
    }
    let (camera, width) = (plan.rays.camera(), plan.axes.width());
    let mut known: Option<(u32, ObjectFromOrigin)> = None;
    for (offset, object) in object.iter().copied().enumerate() {
        if object == NO_OBJECT {
            if let Some(t) = t.get_mut(offset) {
                *t = f64::INFINITY;
            }
            if let Some(normal) = normals.get_mut(offset) {
                *normal = DVec3::ZERO;
            }
            continue;
        }
        if known.as_ref().is_none_or(|(index, _)| *index != object) {
            let given = plan.scene.object(object);
            known = given.map(|given| (object, ObjectFromOrigin::new(&given, camera.eye())));
        }
        let Some((_, seen)) = &known else { continue };
        let ray = camera.exact_ray(plan.rays.pixel(rows.start + offset / width, offset % width));
        let root = seen.root_of_hit();
        if let Some(t) = t.get_mut(offset) {
            *t = seen.rounded_t_counting(&ray, root, &mut steps);
        }
        if let Some(normal) = normals.get_mut(offset) {
            *normal = match seen {
                ObjectFromOrigin::Plane(seen) => plane_normal(seen.plane().normal),
                ObjectFromOrigin::Sphere(seen) => seen.normal(&ray, root),
            };
        }
    }
    steps
}
