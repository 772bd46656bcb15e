//! The ghost in the world view: its eye, basis, frustum and viewport, all dashed, with a prime at
//! each name.

use pinhole_core::{DVec2, ResolvedCamera};

use crate::overlay::camera_in_space::{ARROW_POINTS, POINT_TEXT, VECTOR_TEXT, corners};
use crate::overlay::items::Item;
use crate::overlay::sketch::{Head, Pen, Sketch};

/// How far the edges of its frustum are drawn, in distances of its viewport.
const FRUSTUM: f64 = 2.2;

impl Sketch<'_> {
    /// Below all that belongs to the camera at hand.
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
        let arrows = [
            ("u′", basis.u, Head::Filled),
            ("v′", basis.v, Head::Open),
            ("w′", basis.w, Head::Double),
        ];
        for ((name, vector, head), color) in arrows.into_iter().zip(self.colors.basis) {
            let pen = Pen::new(Item::Basis, color, 2.6).dashed();
            let tip = self.arrow(eye, eye + length * vector, head, pen);
            self.label_tip(pen, name, tip, (color, VECTOR_TEXT, true));
        }
        let pen = Pen::new(Item::Eye, ink, 2.0);
        if let Some(spot) = self.point(eye, 4.5, pen) {
            let font = (ink, POINT_TEXT, false);
            self.label(pen, "eye′", spot.at, DVec2::new(0.6, 1.0), font);
        }
    }
}
