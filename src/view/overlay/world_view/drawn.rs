//! What the world view draws besides the camera and the objects, so that an observer can be found who has all
//! of it in sight: the selected ray with its points, the viewport's dimension lines, and the ghost.

use pinhole_core::{Camera, DVec2, DVec3, ResolvedCamera, Scene, Selection};

use crate::model::observer::Drawn;
use crate::model::{Inspection, Item, OverlayItems};
use crate::view::overlay::{GhostCamera, SphereFigure, corners, shows_where_it_looks, unit};

/// Depth of the camera's body behind the eye, and length of the ray's line there, as multiples of the basis
/// arrows' length.
const BODY: f64 = 0.5;
const BEHIND: f64 = 0.8;

/// Returns what is drawn of a ray and a ghost, with the `items`. `t` is that of the point marked on the ray.
pub fn drawn(
    camera: &Camera,
    scene: &Scene,
    items: OverlayItems,
    (selection, t): (Selection, Option<f64>),
    ghost: Option<&GhostCamera>,
) -> Drawn {
    let mut drawn = Drawn::from(items);
    if let Ok(resolved) = camera.resolve() {
        if items.shows(Item::Eye) && !shows_where_it_looks(items) {
            drawn.arrows.push((resolved.basis().w, BODY));
        }
        if items.shows(Item::Measures) {
            drawn.points.extend(measured_points(&resolved));
        }
        let of_ray = [Item::Ray, Item::SphereFigure, Item::Direction, Item::Roots];
        if items.shows_any(&of_ray) {
            let inspection = Inspection::new(&resolved, scene, selection);
            ray(&mut drawn, &inspection, scene);
            drawn.points.extend(t.map(|t| inspection.ray.at(t)));
        }
    }
    if let Some(ghost) = ghost {
        drawn.points.extend(ghost.points(items));
        drawn.arrows.extend(ghost.arrows());
    }
    drawn.points.retain(|point| point.is_finite());
    drawn
}

/// Adds the points of the selected ray: where it passes through the viewport, its drawn roots, and the
/// points of the sphere figure.
fn ray(drawn: &mut Drawn, inspection: &Inspection, scene: &Scene) {
    let ray = &inspection.ray;
    drawn.points.push(ray.at(1.0));
    let shows_planes = [Item::Planes, Item::Hit].into_iter().any(|item| drawn.items.shows(item));
    let is_drawn = |object: u32| shows_planes || (object as usize) < scene.spheres().len();
    let from = if drawn.items.shows_any(&[Item::SphereFigure, Item::Roots]) {
        drawn.arrows.extend(unit(-ray.direction).map(|back| (back, BEHIND)));
        0
    } else if inspection.first_hit().is_some_and(|hit| is_drawn(hit.object)) {
        inspection.first.unwrap_or(inspection.roots.len())
    } else {
        inspection.roots.len()
    };
    let roots = inspection.roots[from..].iter().filter(|root| is_drawn(root.object));
    drawn.points.extend(roots.map(|root| root.point));
    if drawn.items.shows(Item::SphereFigure)
        && let Some(figure) = SphereFigure::new(inspection, scene.spheres())
    {
        drawn.points.push(figure.foot());
    }
}

/// Returns the outer corners of the viewport with the dimension lines below it and to its right.
fn measured_points(resolved: &ResolvedCamera) -> [DVec3; 3] {
    let outer = corners(resolved)[1].abs()
        + 2.0 * 0.14 * resolved.viewport().width.min(resolved.viewport().height);
    let corners = [outer, outer * DVec2::new(1.0, -1.0), -outer];
    corners.map(|corner| resolved.viewport_point(corner))
}
