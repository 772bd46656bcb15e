//! The ghost in the world view: its eye, basis, frustum and viewport, all dashed, with a prime
//! after each name.

use pinhole_core::{DVec2, ResolvedCamera};

use crate::model::observer::ARROW_POINTS;
use crate::model::overlay_items::Item;
use crate::view::overlay::space::sketch::{Pen, Sketch};
use crate::view::overlay::style::{POINT_TEXT, VECTOR_TEXT};
use crate::view::overlay::world_view::camera_in_space::{basis_arrows, corners};

/// Length of the drawn frustum edges, in viewport distances.
const FRUSTUM: f64 = 2.2;

impl Sketch<'_> {
    /// Draws the ghost, below everything that belongs to the edited camera.
    pub(crate) fn ghost(&mut self, ghost: &ResolvedCamera) {
        let (eye, basis) = (ghost.eye(), ghost.basis());
        let ink = self.colors.ink;
        let edge = Pen::new(Item::Frustum, ink, 1.8).dashed();
        let outline = Pen::new(Item::Viewport, ink, 2.4).dashed();
        let corners = corners(ghost);
        for k in 0..4 {
            self.line(eye, ghost.ray(corners[k]).at(FRUSTUM), edge);
            let ends = [corners[k], corners[(k + 1) % 4]].map(|uv| ghost.viewport_point(uv));
            self.line(ends[0], ends[1], outline);
        }
        let length = self.length_of_points(eye, ARROW_POINTS);
        for ((_, name, vector, head), color) in basis_arrows(basis).zip(self.colors.basis) {
            let pen = Pen::new(Item::Basis, color, 2.6).dashed();
            let tip = self.arrow(eye, eye + length * vector, head, pen);
            self.label_tip(pen, format!("{name}′"), tip, (color, VECTOR_TEXT, true));
        }
        let pen = Pen::new(Item::Eye, ink, 2.0);
        if let Some(spot) = self.point(eye, 4.5, pen) {
            let font = (ink, POINT_TEXT, false);
            self.label(pen, "eye′", spot.at, DVec2::new(0.6, 1.0), font);
        }
    }
}
