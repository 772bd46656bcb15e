//! The ghost in the world view: its eye, basis, frustum and viewport, all dashed, with a prime
//! after each name.

use pinhole_core::{DVec2, DVec3, ResolvedCamera};
use pinhole_lecture::mistakes::WrongCamera;

use crate::model::overlay_items::Item;
use crate::view::overlay::space::sketch::{Head, Pen, Sketch};
use crate::view::overlay::style::{MARK_TEXT, POINT_TEXT, VECTOR_TEXT};
use crate::view::overlay::world_view::camera_in_space::corners;

/// Length of the drawn frustum edges, in viewport distances.
const FRUSTUM: f64 = 2.2;

/// Greatest length of a basis vector that is drawn as long as it is; a wrong one may have any.
const LONGEST: f64 = 2.0;

/// A camera to compare with: a frozen one, or the one that a mistake makes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GhostCamera {
    eye: DVec3,
    /// u, v and w, where they are drawn.
    basis: [Option<DVec3>; 3],
    /// From the eye to the viewport's corners, from that of pixel (0, 0) clockwise in the image.
    corners: [DVec3; 4],
    /// True if it is a camera of its own, with another eye; a mistake's has the right one.
    is_frozen: bool,
    /// True if another corner than the right camera's is that of pixel (0, 0).
    is_turned: bool,
}

impl GhostCamera {
    /// Returns a frozen camera as a ghost.
    pub fn frozen(camera: &ResolvedCamera) -> GhostCamera {
        let basis = camera.basis();
        GhostCamera {
            eye: camera.eye(),
            basis: [basis.u, basis.v, basis.w].map(Some),
            corners: corners(camera).map(|uv| camera.ray(uv).direction),
            is_frozen: true,
            is_turned: false,
        }
    }

    /// Returns a mistake's camera as a ghost: of its basis only what is wrong.
    pub fn of_mistake(wrong: &WrongCamera) -> GhostCamera {
        let right = wrong.right_camera();
        let [u, v, w] = wrong.wrong_vectors();
        let first = corners(right).map(|uv| right.ray(uv).direction)[0];
        let corners = wrong.corner_directions();
        GhostCamera {
            eye: right.eye(),
            basis: [u.then(|| wrong.u()), v.then(|| wrong.v()), w.then(|| wrong.w())],
            corners,
            is_frozen: false,
            is_turned: (corners[0] - first).length() > 0.25 * first.length(),
        }
    }
}

impl Sketch<'_> {
    /// Draws the ghost, below everything that belongs to the edited camera.
    pub(crate) fn ghost(&mut self, ghost: &GhostCamera) {
        let GhostCamera { eye, corners, .. } = *ghost;
        let ink = self.colors.ink;
        let edge = Pen::new(Item::Frustum, ink, 1.8).dashed();
        let outline = Pen::new(Item::Viewport, ink, 2.4).dashed();
        for corner in corners {
            self.line(eye, eye + FRUSTUM * corner, edge);
        }
        self.sides(corners.map(|corner| eye + corner), outline);
        let length = self.arrow_length(eye);
        let heads = [("u", Head::Filled), ("v", Head::Open), ("w", Head::Double)];
        for ((vector, (name, head)), color) in
            ghost.basis.into_iter().zip(heads).zip(self.colors.basis)
        {
            let Some(vector) = vector else { continue };
            let pen = Pen::new(Item::Basis, color, 2.6).dashed();
            let tip = self.arrow(eye, eye + length * vector.clamp_length_max(LONGEST), head, pen);
            self.label_tip(pen, format!("{name}′"), tip, (color, VECTOR_TEXT, true));
        }
        let pen = Pen::new(Item::Eye, ink, 2.0);
        if ghost.is_frozen
            && let Some(spot) = self.point(eye, 4.5, pen)
        {
            let font = (ink, POINT_TEXT, false);
            self.label(pen, "eye′", spot.at, DVec2::new(0.6, 1.0), font);
        }
        let pen = Pen::new(Item::Marks, self.colors.mark, 2.0);
        if ghost.is_turned
            && let Some(spot) = self.point(eye + corners[0], 3.6, pen)
        {
            let font = (self.colors.mark, MARK_TEXT, false);
            self.label(pen, "(0, 0)′", spot.at, DVec2::new(-0.6, -1.0), font);
        }
    }
}
