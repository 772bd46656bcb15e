//! What of the parts must be in sight, so that an observer can be found who sees it.

use std::sync::Arc;

use pinhole_core::{Camera, DVec3, Scene, Selection, Sphere};
use pinhole_exchange::document::Document;

use super::{DrawnPart, Figure, Form, Part};
use crate::concept::{Concepts, Directed};
use crate::observer::{Drawn, Length, Place, Surroundings, ViewSize};
use crate::overlay::{GhostCamera, Highlighted, LABEL_DIGITS, Same};
use crate::{Concept, Inspection, Item, Observer, OverlayItems};

/// Depth behind the eye that is kept free for the camera's body, which is drawn if the viewport is small, as a multiple of
/// the basis arrows' length.
const BODY_ROOM: f64 = 0.5;

/// Returns what is drawn with the `items`: of the camera and, if there is a `ray` with the t of the point marked on it,
/// of that, of the highlighted concept, and of the ghost.
pub fn drawn<'a>(
    camera: &'a Camera,
    scene: &'a Scene,
    items: OverlayItems,
    ray: Option<(Selection, Option<f64>)>,
    highlighted: Option<Concept>,
    ghost: Option<&GhostCamera>,
) -> Drawn<'a> {
    // Objects must be in sight anyway, but for planes, which have no end.
    let lit = highlighted.map(Concept::in_views);
    let lit = lit.filter(|concept| !matches!(concept, Concept::Object(_)));
    let parts = figure(camera, scene, items, ray, lit, ghost).parts(scene, &[]);
    let places = parts.iter().flat_map(|drawn| drawn.part.in_sight(camera)).collect();
    Drawn { camera, scene, has_frustum: items.shows(Item::Frustum), places }
}

/// Returns what is drawn of what the newest line of a derivation is about, and of what its lines have spoken of.
pub fn subject<'a>(
    camera: &'a Camera,
    scene: &'a Scene,
    items: OverlayItems,
    ray: (Selection, Option<f64>),
    directed: Directed,
    ghost: Option<&GhostCamera>,
) -> Drawn<'a> {
    let lit = directed.concept.in_views();
    let mut figure = figure(camera, scene, items, Some(ray), Some(lit), ghost);
    if let Some(lit) = &mut figure.highlighted {
        (lit.spoken, lit.is_of_step) = (directed.spoken, directed.is_of_step);
    }
    let parts = figure.parts(scene, &[]);
    let is_spoken = |concept| directed.spoken.contains(concept);
    let is_subject = |drawn: &&DrawnPart| {
        let is_compared = directed.is_of_step && drawn.is_behind;
        is_compared || drawn.emphasis.is_on_top() || drawn.part.pen.concept.is_some_and(is_spoken)
    };
    let places = parts.iter().filter(is_subject).flat_map(|drawn| drawn.part.in_sight(camera));
    let object = lit.object().or(directed.object);
    let sphere = object.and_then(|index| scene.spheres().get(index as usize));
    // A planet need not be in sight.
    let in_scale = Surroundings::new(camera, scene).spheres;
    let is_in_scale = |sphere: &&Sphere| in_scale.iter().any(|ball| ball.center == sphere.center);
    let sphere = sphere.filter(is_in_scale);
    let sides = sphere.into_iter().flat_map(|sphere| {
        let axes = DVec3::AXES.map(|axis| sphere.radius * axis);
        axes.into_iter().flat_map(|axis| [sphere.center - axis, sphere.center + axis])
    });
    // A plane has no end: where the ray's line meets it is in sight.
    let inspection = figure.inspection.as_ref().filter(|_| sphere.is_none());
    let roots = inspection.into_iter().flat_map(|inspection| &inspection.0.roots);
    let roots = roots.filter(|root| Some(root.object) == object).map(|root| root.point);
    let ends = sides.chain(roots.filter(|point| point.is_finite()));
    let places = places.chain(ends.map(|end| (Place::from(end), false))).collect();
    Drawn { camera, scene, has_frustum: false, places }
}

/// Returns the figure of a camera whose parts must be in sight.
fn figure(
    camera: &Camera,
    scene: &Scene,
    items: OverlayItems,
    ray: Option<(Selection, Option<f64>)>,
    lit: Option<Concept>,
    ghost: Option<&GhostCamera>,
) -> Figure {
    let resolved = camera.resolve().ok();
    let inspection = resolved
        .zip(ray)
        .map(|(resolved, (selection, _))| Inspection::new(&resolved, scene, selection));
    let highlighted = lit.map(|concept| Highlighted {
        concept,
        camera: *camera,
        digits: LABEL_DIGITS,
        dims: false,
        spoken: Concepts::default(),
        is_of_step: false,
        growth: 1.0,
    });
    let near = resolved.map_or(1.0, |resolved| {
        let viewport = resolved.viewport();
        viewport.width.max(viewport.height).max(viewport.distance)
    });
    // The axes take no room if the camera is elsewhere.
    let has_axes = camera.eye.length() <= near;
    Figure {
        inspection: inspection.map(|inspection| Same(Arc::new(inspection))),
        ray_point_t: ray.and_then(|(_, t)| t),
        ghost: ghost.copied(),
        items: items.with(Item::Axes, items.shows(Item::Axes) && has_axes),
        highlighted,
        shows_normal: false,
        ..Figure::new(*camera, Observer::new(camera.eye, 0.0, 0.0, near))
    }
}

/// Returns the observer with which a document opens in a view of this size: its own, or one that is fitted to its
/// scene.
pub fn observer_of(document: &Document, scene: &Scene, size: ViewSize) -> Observer {
    let fitted = || Observer::frame_all(&drawn_of(&document.camera, scene), size);
    document.observer.map_or_else(fitted, Observer::from)
}

/// Returns what is drawn of a camera without a ray.
pub fn drawn_of<'a>(camera: &'a Camera, scene: &'a Scene) -> Drawn<'a> {
    drawn(camera, scene, OverlayItems::default(), None, None, None)
}

impl Part {
    /// Returns the places of the part that must be in sight, each with whether it has a label.
    fn in_sight(&self, camera: &Camera) -> Vec<(Place, bool)> {
        let count = self.places.len();
        let shown = match self.form {
            Form::Body => {
                let along = -BODY_ROOM * camera.view().normalize_or_zero();
                return vec![(Place { at: camera.eye, along, length: Length::Arrow }, false)];
            }
            // Of the frustum, what is drawn nearer.
            Form::Face(_) => 0,
            Form::Sides if self.is_endless => 0,
            _ if self.is_endless => count - 1,
            _ => count,
        };
        let label = self.label.as_ref();
        let is_named = label.is_some_and(|label| label.at.is_none())
            && (matches!(self.form, Form::Arrow(_)) || self.pen.item == Item::Eye);
        let places = self.places.iter().take(shown).enumerate();
        // Somewhere beside a dimension line is its label.
        let has_label = |k: usize| match self.form {
            Form::Dimension => true,
            _ => is_named && k + 1 == count,
        };
        let places = places.map(|(k, place)| (*place, has_label(k)));
        places.chain(label.and_then(|label| Some((label.at?, true)))).collect()
    }
}
