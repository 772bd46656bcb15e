//! The handles of the world view and their positions on the screen.

use pinhole_core::steering::ViewportCorner;
use pinhole_core::{Camera, DVec2, DVec3, Orientation, ResolvedCamera, Selection};
use pinhole_exchange::document::Document;

use crate::model::observer::UP_LENGTH;
use crate::model::overlay_items::{Item, OverlayItems};
use crate::model::session::hand::{Grasp, Hand, Handle};
use crate::view::overlay;

/// Distance from an arrow's tip to its handle, in points.
const BEYOND: f64 = 10.0;

/// The document and the observer for which handles are placed.
#[derive(Clone, Copy)]
pub struct Stage<'a> {
    /// The document.
    pub document: &'a Document,
    /// The document's camera, if it has a basis.
    pub resolved: Option<&'a ResolvedCamera>,
    /// The selected ray.
    pub selection: Selection,
    /// The overlay items that are drawn.
    pub items: OverlayItems,
    /// The observer.
    pub observer: &'a ResolvedCamera,
    /// Dots per point.
    pub scale: f32,
}

/// A handle with its position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grip {
    /// The handle.
    pub handle: Handle,
    /// The position in the world.
    pub at: DVec3,
    /// The position on the observer's screen, in dots.
    pub spot: DVec2,
}

/// Returns all handles that the observer sees, drawn or not. If several are at the same position, the first one
/// is preferred.
pub fn grips(stage: &Stage, hand: &Hand) -> Vec<Grip> {
    if !stage.items.shows(Item::Handles) {
        return Vec::new();
    }
    let of_camera = [Handle::Eye, Handle::At, Handle::Up, Handle::Roll, Handle::Dolly];
    let corners = ViewportCorner::ALL.map(Handle::Corner);
    let of_object = |k: usize| {
        if k < stage.document.sphere_count() {
            [Handle::Center(k), Handle::Radius(k)]
        } else {
            [Handle::Point(k), Handle::Normal(k)]
        }
    };
    // Who has chosen an object wants to move it, even where at is its centre.
    let [chosen, pointed_at] = hand.objects.map(|k| k.into_iter().flat_map(of_object));
    let handles = chosen.chain(of_camera).chain(corners).chain([Handle::Distance]);
    let handles = handles.chain(pointed_at).chain([Handle::Pixel]);
    let is_held = |handle| hand.held.is_some_and(|grasp| grasp.handle == handle);
    let is_small = stage.is_viewport_small();
    let shown = handles.filter(|handle| {
        let in_the_way = is_small && handle.is_on_viewport() && !is_held(*handle);
        stage.items.shows(handle.item()) && !in_the_way
    });
    let placed = shown.filter_map(|handle| {
        let held = hand.held.filter(|grasp| grasp.handle == handle);
        let at = stage.position(handle, held.or_else(|| stage.grasp(handle))?)?;
        Some(Grip { handle, at, spot: stage.spot(at)? })
    });
    placed.collect()
}

impl Stage<'_> {
    fn camera(&self) -> &Camera {
        &self.document.camera
    }

    /// Returns true if there is no room for handles on the viewport.
    fn is_viewport_small(&self) -> bool {
        let Some(resolved) = self.resolved else { return false };
        let corner = |corner: ViewportCorner| {
            let uv = corner.uv(resolved.viewport());
            self.spot(resolved.viewport_point(uv))
        };
        let [Some(a), Some(b), Some(c), Some(d)] = ViewportCorner::ALL.map(corner) else {
            return false;
        };
        a.distance(d).max(b.distance(c)) < overlay::SMALL_VIEWPORT * f64::from(self.scale)
    }

    /// Returns the length of the arrows at the eye; `None` if it is not seen.
    pub(super) fn arrow(&self) -> Option<f64> {
        let arrow = overlay::arrow_length(self.observer, self.camera().eye, self.scale);
        (arrow > 0.0 && arrow.is_finite()).then_some(arrow)
    }

    /// Returns the distance, in the world, of a handle from its arrow's tip; the arrow's head stays
    /// visible.
    pub(super) fn beyond(&self, base: DVec3) -> f64 {
        overlay::length_of_points(self.observer, base, BEYOND, self.scale)
    }

    /// Returns the grasp with which a handle is taken now; `None` if it is not there.
    pub fn grasp(&self, handle: Handle) -> Option<Grasp> {
        let per_length = |drawn: f64, vector: DVec3| {
            let length = vector.length();
            (length > 0.0 && length.is_finite()).then_some(drawn / length)
        };
        let beyond = |at: DVec3| self.beyond(at);
        let eye = self.camera().eye;
        let length = match handle {
            Handle::Up => per_length(UP_LENGTH * self.arrow()? + beyond(eye), self.camera().up())?,
            Handle::Roll | Handle::Dolly => self.arrow()? + beyond(eye),
            Handle::Normal(k) => {
                let plane = self.plane(k)?;
                let arrow = overlay::normal_length(self.observer, plane.point, self.scale);
                per_length(arrow + beyond(plane.point), plane.normal)?
            }
            _ => 1.0,
        };
        Some(Grasp { handle, length, toward: self.observer.basis().u })
    }

    /// Returns the position of a handle in the world.
    pub fn position(&self, handle: Handle, Grasp { length, toward, .. }: Grasp) -> Option<DVec3> {
        let camera = self.camera();
        let on_viewport = |uv: DVec2| Some(self.resolved?.viewport_point(uv));
        match handle {
            Handle::Eye => Some(camera.eye),
            Handle::At => match camera.orientation {
                Orientation::At { at, .. } => Some(at),
                Orientation::View { view, .. } => Some(camera.eye + view),
                Orientation::Basis(_) => None,
            },
            Handle::Up => match camera.orientation {
                Orientation::At { up, .. } | Orientation::View { up, .. } => {
                    Some(camera.eye + length * up)
                }
                Orientation::Basis(_) => None,
            },
            Handle::Roll => Some(camera.eye + length * self.resolved?.basis().v),
            Handle::Dolly => Some(camera.eye + length * self.resolved?.basis().w),
            Handle::Corner(corner) => on_viewport(corner.uv(&camera.viewport)),
            Handle::Distance => on_viewport(DVec2::new(0.0, -0.5 * camera.viewport.height)),
            Handle::Pixel => on_viewport(self.selection.inside(camera.image).uv(self.resolved?)),
            Handle::Center(k) => Some(self.document.spheres.get(k)?.shape.center),
            Handle::Radius(k) => {
                let sphere = self.document.spheres.get(k)?.shape;
                Some(sphere.center + sphere.radius * toward)
            }
            Handle::Point(k) => Some(self.plane(k)?.point),
            Handle::Normal(k) => {
                let plane = self.plane(k)?;
                Some(plane.point + length * plane.normal)
            }
        }
    }

    fn plane(&self, k: usize) -> Option<pinhole_core::Plane> {
        let position = k.checked_sub(self.document.sphere_count())?;
        Some(self.document.planes.get(position)?.shape)
    }

    /// Returns the position of a point on the observer's screen, in dots; `None` outside the
    /// picture.
    pub fn spot(&self, at: DVec3) -> Option<DVec2> {
        let seen = self.observer.project(at);
        let image = self.observer.image();
        let size = [image.width() as usize, image.height() as usize];
        let [x, y] = overlay::camera_position_of_uv(self.observer, size, seen.uv);
        let spot = DVec2::new(x.into(), y.into());
        let extent = DVec2::new(f64::from(image.width()), f64::from(image.height()));
        let inside = spot.cmpge(DVec2::ZERO).all() && spot.cmple(extent).all();
        (seen.is_in_front() && inside).then_some(spot)
    }
}
