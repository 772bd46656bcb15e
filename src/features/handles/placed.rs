//! The handles that the user drags in the world view: at the eye, the target (at), the tip of the up
//! vector, the viewport, spheres and planes. This module is pure; `ui::scene::dragging` handles the
//! pointer.
//!
//! It places the handles on the screen, hit-tests them, formats their names and values, and creates the
//! marks that the overlay draws. [`drag`](crate::features::handles::drag) calculates the effect of a
//! drag.
//!
//! No gizmo crate is used, for two reasons. The gizmos for egui edit one transform at a time, but a
//! viewport has corners and a sphere has a radius. They also bypass the overlay, whose marks appear in
//! figures.

use pinhole_core::{DVec2, DVec3, Object, Orientation, ResolvedCamera, Selection};
use pinhole_exchange::document::Document;
use pinhole_figure::overlay::{self, HandleMark, Handles, Knob, KnobState};
use pinhole_figure::{Concept, Item};
use pinhole_lecture::numbers::{equated, equated_tuple};

use crate::features::handles::state::{Corner, Drag, Grabbed, Handle, HandleValues};
use crate::model::Session;

/// Distance from the tip of the up arrow to the handle beyond it, in points.
const BEYOND: f64 = 10.0;

/// Maximum distance between two handles that count as overlapping, as a fraction of the distance at which
/// the mouse grabs a handle.
const TOGETHER: f64 = 0.4;

/// The inputs from which the positions of handles are computed: the document and what is shown of it, and
/// the observer.
#[derive(Clone, Copy)]
pub struct HandleInputs<'a> {
    /// The document.
    pub document: &'a Document,
    /// What is shown of it.
    pub session: &'a Session,
    /// The document's camera, if it has a basis.
    pub resolved: Option<&'a ResolvedCamera>,
    /// The selected pixel or point of the viewport.
    pub selection: Selection,
    /// The observer.
    pub observer: &'a ResolvedCamera,
    /// Screen pixels per point.
    pub scale: f32,
}

/// A handle and its position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedHandle {
    /// The handle.
    pub handle: Handle,
    /// The position in the world.
    pub at: DVec3,
    /// The position on the observer's screen, in screen pixels.
    pub spot: DVec2,
    /// For the handle of up, the length in the world at which an up vector of length 1 is drawn; otherwise
    /// 1.
    pub length: f64,
    /// Unit vector from a sphere's centre to its radius handle.
    pub toward: DVec3,
}

impl PlacedHandle {
    /// Returns the drag that begins when this handle is grabbed with the pointer at `begun_at` in the
    /// observer's viewport.
    pub fn taken(&self, document: &Document, selection: Selection, begun_at: DVec2) -> Drag {
        let PlacedHandle { handle, at, length, toward, .. } = *self;
        let before = HandleValues::read(document, selection, handle.object());
        Drag {
            grabbed: Grabbed::Handle(handle),
            before,
            begun_at,
            at,
            length,
            toward,
            is_beside_view: None,
        }
    }
}

/// Returns all handles in the observer's picture, whether they are drawn or not, in order of preference: of
/// several handles at the same position, the first one is grabbed.
pub fn placed(inputs: &HandleInputs) -> Vec<PlacedHandle> {
    let (items, state) = (inputs.session.shown.setup.items, &inputs.session.live.handles);
    if !items.shows(Item::Handles) {
        return Vec::new();
    }
    let of_camera = [Handle::Eye, Handle::At, Handle::Up];
    let corners = Corner::ALL.map(Handle::Corner);
    let of_object = |k| match k < inputs.document.sphere_count() {
        true => vec![Handle::Center(k), Handle::Radius(k)],
        false => vec![Handle::Point(k)],
    };
    // The handles of a selected object come first, so that it can be moved even if the point at is its
    // centre.
    let [chosen, pointed_at] = state.objects.map(|k| k.into_iter().flat_map(of_object));
    let handles = chosen.chain(of_camera).chain(corners).chain([Handle::Distance]);
    let handles = handles.chain(pointed_at).chain([Handle::Pixel]);
    let is_small = inputs.is_viewport_small();
    let placed = handles.filter_map(|handle| {
        let held = state.drag.filter(|drag| drag.handle() == Some(handle));
        let in_the_way = is_small && handle.is_on_viewport() && held.is_none();
        if in_the_way || !items.shows(handle.item()) {
            return None;
        }
        let (length, toward) = match held {
            Some(drag) => (drag.length, drag.toward),
            None if handle == Handle::Up => (inputs.up_length()?, DVec3::ZERO),
            None => (1.0, inputs.observer.basis().u),
        };
        let at = inputs.position(handle, length, toward)?;
        Some(PlacedHandle { handle, at, spot: inputs.spot(at)?, length, toward })
    });
    placed.collect()
}

/// Returns the handle nearest to a position, if its distance is at most `reach`; both are in screen pixels.
/// Of overlapping handles, returns the first one.
pub fn hit(placed: &[PlacedHandle], at: DVec2, reach: f64) -> Option<PlacedHandle> {
    let near = placed.iter().filter(|other| other.spot.distance(at) <= reach);
    // `min_by` returns the first of equally near ones.
    let nearest = near.min_by(|a, b| a.spot.distance(at).total_cmp(&b.spot.distance(at)))?;
    let is_together = |other: &&PlacedHandle| other.spot.distance(nearest.spot) <= TOGETHER * reach;
    placed.iter().find(is_together).copied()
}

impl HandleInputs<'_> {
    /// Returns true if the viewport is drawn so small that its handles are left out.
    fn is_viewport_small(&self) -> bool {
        let Some(resolved) = self.resolved else { return false };
        let spot = |corner: Corner| {
            let uv = corner.uv(resolved.viewport());
            self.spot(resolved.viewport_point(uv))
        };
        let [Some(a), Some(b), Some(c), Some(d)] = Corner::ALL.map(spot) else { return false };
        a.distance(d).max(b.distance(c)) < overlay::SMALL_VIEWPORT * f64::from(self.scale)
    }

    /// Returns the distance in the world from the tip of the up arrow to its handle, which leaves the
    /// arrowhead visible.
    fn beyond_up(&self) -> f64 {
        let eye = self.document.camera.eye;
        overlay::length_of_points(self.observer, eye, BEYOND, self.scale)
    }

    /// Returns the length in the world at which an up vector of length 1 is drawn; `None` if the arrow of
    /// up is not drawn.
    fn up_length(&self) -> Option<f64> {
        let camera = &self.document.camera;
        let is_directed = self.session.live.directed.is_some();
        let arrow = overlay::arrow_length(self.observer, camera.eye, self.scale, is_directed);
        let length = camera.up().length();
        let is_drawn = [arrow, length].iter().all(|x| *x > 0.0 && x.is_finite());
        is_drawn.then(|| (overlay::UP_LENGTH * arrow + self.beyond_up()) / length)
    }

    /// Returns the position of a handle in the world.
    fn position(&self, handle: Handle, length: f64, toward: DVec3) -> Option<DVec3> {
        let camera = &self.document.camera;
        let on_viewport = |uv: DVec2| Some(self.resolved?.viewport_point(uv));
        match handle {
            Handle::Eye => Some(camera.eye),
            Handle::At | Handle::Up => match (camera.orientation, handle) {
                (Orientation::Basis(_), _) => None,
                (_, Handle::Up) => Some(camera.eye + length * camera.up()),
                (Orientation::At { at, .. }, _) => Some(at),
                (Orientation::View { view, .. }, _) => Some(camera.eye + view),
            },
            Handle::Corner(corner) => on_viewport(corner.uv(&camera.viewport)),
            Handle::Distance => on_viewport(DVec2::new(0.0, -0.5 * camera.viewport.height)),
            Handle::Pixel => on_viewport(self.selection.inside(camera.image).uv(self.resolved?)),
            Handle::Center(k) | Handle::Radius(k) | Handle::Point(k) => {
                Some(match (self.document.object(k)?, handle) {
                    (Object::Sphere(sphere), Handle::Radius(_)) => {
                        sphere.center + sphere.radius * toward
                    }
                    (Object::Sphere(sphere), _) => sphere.center,
                    (Object::Plane(plane), _) => plane.point,
                })
            }
        }
    }

    /// Returns the position of a point in the observer's picture, in screen pixels; `None` if it lies
    /// outside.
    fn spot(&self, at: DVec3) -> Option<DVec2> {
        let (spot, image) = (overlay::world_position_of(self.observer, at)?, self.observer.image());
        let extent = DVec2::new(f64::from(image.width()), f64::from(image.height()));
        (spot.cmpge(DVec2::ZERO).all() && spot.cmple(extent).all()).then_some(spot)
    }
}

/// Returns a handle's name: `eye`, `sphere 0 “ball”: radius`.
pub fn label(handle: Handle, document: &Document) -> String {
    let titled = |k: usize, what: &str| format!("{}: {what}", document.title_of(k));
    let name = match handle {
        Handle::Eye => "eye",
        Handle::At => match document.camera.orientation {
            Orientation::View { .. } => "view",
            _ => "at",
        },
        Handle::Up => "up",
        Handle::Corner(Corner { is_right, is_top }) => {
            let row = if is_top { "top" } else { "bottom" };
            let column = if is_right { "right" } else { "left" };
            return format!("viewport, {row} {column} corner");
        }
        Handle::Distance => "viewport's distance",
        Handle::Pixel => "selected pixel",
        Handle::Center(k) => return titled(k, "centre"),
        Handle::Radius(k) => return titled(k, "radius"),
        Handle::Point(k) => return titled(k, "point"),
    };
    name.to_owned()
}

/// Returns the text of a handle's value, such as `eye = (1, 0, 0)`. If `from_one` is true, rows and
/// columns are counted from 1.
pub fn value(handle: Handle, part: &HandleValues, digits: usize, from_one: bool) -> String {
    let camera = &part.camera;
    let is = |x: f64| equated(x, digits);
    let named = |name: &str, v: DVec3| format!("{name} {}", equated_tuple(&v.to_array(), digits));
    let at = match camera.orientation {
        Orientation::At { at, .. } => named("at", at),
        Orientation::View { view, .. } => named("view", view),
        Orientation::Basis(basis) => named("𝐰", basis.w),
    };
    let viewport = camera.viewport;
    match handle {
        Handle::Eye => named("eye", camera.eye),
        Handle::At => at,
        Handle::Up => named("up", camera.up()),
        Handle::Corner(_) => {
            format!("width {}, height {}", is(viewport.width), is(viewport.height))
        }
        Handle::Distance => format!("distance {}", is(viewport.distance)),
        Handle::Pixel => match part.selection {
            Selection::Pixel(pixel) => {
                let first = u32::from(from_one);
                format!("row {}, column {}", pixel.row + first, pixel.column + first)
            }
            Selection::Uv(uv) => format!("(u, v) {}", equated_tuple(&uv.to_array(), digits)),
        },
        Handle::Center(_) | Handle::Radius(_) | Handle::Point(_) => match (part.object, handle) {
            (Some((_, Object::Sphere(sphere))), Handle::Center(_)) => {
                named("centre", sphere.center)
            }
            (Some((_, Object::Sphere(sphere))), _) => format!("radius {}", is(sphere.radius)),
            (Some((_, Object::Plane(plane))), _) => named("point", plane.point),
            (None, _) => String::new(),
        },
    }
}

/// Returns the marks that the overlay draws for the handles. The handles of the eye, of at and of the tip
/// of up are always drawn, and so are those of a selected or hovered object. A handle of the viewport or of
/// the pixel is drawn if it is hovered or dragged, or if it changes one of the concepts that a lesson
/// mentions.
pub fn drawn(inputs: &HandleInputs) -> Handles {
    let (state, spoken) = (&inputs.session.live.handles, inputs.session.spoken_of());
    let mut placed = placed(inputs);
    let held = state.drag.and_then(|drag| drag.handle());
    placed.retain(|PlacedHandle { handle, .. }| {
        matches!(handle, Handle::Eye | Handle::At | Handle::Up)
            // Only chosen or hovered objects have handles.
            || handle.object().is_some()
            || [state.over, held].into_iter().flatten().any(|other| belong_together(*handle, other))
            || spoken.iter().any(|concept| is_about(*handle, *concept))
    });
    let find = |handle: Option<Handle>| placed.iter().find(|one| Some(one.handle) == handle);
    let (held, over) = (find(held), find(held).or_else(|| find(state.over)));
    let marks = placed.iter().map(|one| HandleMark {
        at: one.at,
        knob: knob(one.handle),
        state: match over {
            Some(over) if over.handle == one.handle && held.is_some() => KnobState::Held,
            Some(over) if over.handle == one.handle => KnobState::Over,
            _ => KnobState::Plain,
        },
    });
    let up = inputs.document.camera.up().length();
    Handles {
        marks: marks.collect(),
        up: held
            .filter(|held| held.handle == Handle::Up)
            .map(|held| held.length * up - inputs.beyond_up()),
    }
}

/// Returns true if the handles are the same, or if both belong to the viewport (its corners and its
/// distance).
fn belong_together(handle: Handle, other: Handle) -> bool {
    let is_of_viewport = |handle| matches!(handle, Handle::Corner(_) | Handle::Distance);
    handle == other || (is_of_viewport(handle) && is_of_viewport(other))
}

/// Returns true if the handle changes the value that the concept stands for.
fn is_about(handle: Handle, concept: Concept) -> bool {
    match handle {
        Handle::Corner(_) => concept == Concept::Viewport,
        Handle::Distance => matches!(concept, Concept::Viewport | Concept::Distance),
        Handle::Pixel => matches!(concept, Concept::Pixel | Concept::Ray | Concept::Direction),
        _ => false,
    }
}

fn knob(handle: Handle) -> Knob {
    match handle {
        Handle::Corner(_) | Handle::Pixel => Knob::Square,
        Handle::Distance | Handle::Radius(_) => Knob::Diamond,
        _ => Knob::Round,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(handle: Handle, x: f64, y: f64) -> PlacedHandle {
        let (at, toward) = (DVec3::ZERO, DVec3::X);
        PlacedHandle { handle, at, spot: DVec2::new(x, y), length: 1.0, toward }
    }

    #[track_caller]
    fn assert_hit(placed: &[PlacedHandle], at: [f64; 2], expected: Option<Handle>) {
        let found = hit(placed, DVec2::from_array(at), 10.0);
        assert_eq!(found.map(|hit| hit.handle), expected);
    }

    #[test]
    fn the_nearest_within_reach() {
        let placed = [at(Handle::Eye, 0.0, 0.0), at(Handle::At, 12.0, 0.0)];
        assert_hit(&placed, [5.0, 0.0], Some(Handle::Eye));
        assert_hit(&placed, [7.0, 0.0], Some(Handle::At));
        assert_hit(&placed, [23.0, 0.0], None);
        assert_hit(&[], [0.0, 0.0], None);
    }

    #[test]
    fn of_those_that_lie_together_the_first_is_taken() {
        let placed = [
            at(Handle::At, 1.0, 0.0),
            at(Handle::Center(0), 0.0, 0.0),
            at(Handle::Pixel, 0.0, 2.0),
        ];
        assert_hit(&placed, [0.0, 1.0], Some(Handle::At));
    }
}
