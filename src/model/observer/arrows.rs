//! The arrows of the world view: their lengths, and where their tips are.

use pinhole_core::{Camera, DVec3, extent_of_fov};

use super::FOV;
use super::fit::{Ball, ViewSize};
use crate::model::overlay_items::{Item, OverlayItems};

/// Length of the basis arrows on the screen, in points: at least and at most. Between the two it is
/// one world unit.
const ARROW_POINTS: (f64, f64) = (62.0, 125.0);

/// Their least length in a small view, as a share of its height or width.
const ARROW_SHARE: f64 = 0.28;

/// Length of the up arrow, as a multiple of the basis arrows' length.
pub const UP_LENGTH: f64 = 1.35;

/// Length of the view arrow, likewise. It differs from the others' so that arrows in one direction do
/// not hide each other.
pub const VIEW_LENGTH: f64 = 1.6;

/// Length of the arrows of the world's axes, likewise.
pub const AXIS_LENGTH: f64 = 1.6;

/// Room beyond an arrow's tip for its handle and its label, in points, and at most as a share of the
/// view's height.
const TIP_ROOM: f64 = 26.0;
const TIP_ROOM_SHARE: f64 = 0.08;

impl ViewSize {
    /// Returns the length of the basis arrows, in points: at least and at most. Normals have the least.
    pub fn arrow_points(self) -> (f64, f64) {
        let (least, most) = ARROW_POINTS;
        (least.min(ARROW_SHARE * self.width.min(self.height)).max(1.0), most)
    }

    /// Returns the world length that covers a point on the screen at this depth.
    fn world_per_point(self, depth: f64) -> f64 {
        extent_of_fov(FOV, depth) / self.height.max(1.0)
    }
}

/// The arrows that are drawn: the unit vectors of those at the eye, with their lengths as multiples
/// of the basis arrows'; and the axes at the origin, if they are beside the camera.
pub(super) struct Arrows {
    at_eye: Vec<(DVec3, f64)>,
    has_axes: bool,
}

impl Arrows {
    pub(super) fn new(camera: &Camera, items: OverlayItems) -> Arrows {
        let mut at_eye = Vec::new();
        let mut has_axes = false;
        if let Ok(resolved) = camera.resolve() {
            let (basis, viewport) = (resolved.basis(), resolved.viewport());
            if items.shows(Item::Basis) {
                at_eye.extend([basis.u, basis.v, basis.w].map(|axis| (axis, 1.0)));
            }
            let near = viewport.width.max(viewport.height).max(viewport.distance);
            has_axes = items.shows(Item::Axes) && camera.eye.length() <= near;
        }
        if items.shows(Item::ViewAndUp) && camera.orientation.has_up() {
            let given = [(camera.view(), VIEW_LENGTH), (camera.up(), UP_LENGTH)];
            at_eye.extend(given.into_iter().filter_map(|(vector, times)| {
                let scaled = vector / vector.abs().max_element();
                scaled.is_finite().then(|| (scaled.normalize(), times))
            }));
        }
        if items.shows(Item::Eye) {
            // No arrow, but a label.
            at_eye.push((DVec3::ZERO, 0.0));
        }
        Arrows { at_eye, has_axes }
    }

    /// Returns the tips, with room for their labels, for an observer at this depth from the eye.
    pub(super) fn tips(
        &self,
        eye: DVec3,
        depth: f64,
        size: ViewSize,
    ) -> impl Iterator<Item = Ball> + '_ {
        let per_point = size.world_per_point(depth.max(1e-12));
        let (least, most) = size.arrow_points();
        let length = 1.0_f64.clamp(least * per_point, most * per_point);
        let axes = DVec3::AXES.map(|axis| AXIS_LENGTH * length * axis);
        let axes = axes.into_iter().filter(|_| self.has_axes);
        let tips = self.at_eye.iter().map(move |(axis, times)| eye + times * length * *axis);
        let room = TIP_ROOM.min(TIP_ROOM_SHARE * size.height);
        tips.chain(axes).map(move |center| Ball { center, radius: room * per_point })
    }
}
