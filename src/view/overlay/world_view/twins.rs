//! A student's answers in the world view, dashed, beside the right ones.

use egui::Color32;
use pinhole_core::{DVec2, DVec3, Ray};

use crate::model::overlay_items::Item;
use crate::model::practice::twin::{Twin, TwinShape};
use crate::view::overlay::space::screen::unit;
use crate::view::overlay::space::sketch::{Head, Pen, Sketch, Tip};
use crate::view::overlay::style::{POINT_TEXT, VECTOR_TEXT};
use crate::view::overlay::world_view::WorldView;

/// Length, in unit vectors, between which an answer is drawn as long as it is.
const LENGTHS: (f64, f64) = (0.3, 1.5);

/// The pens of answers. They are switched by no checkbox, because they are what the page is about.
const ITEM: Item = Item::Eye;

impl Sketch<'_> {
    /// Draws the answers, on top of what belongs to the camera.
    pub(crate) fn twins(&mut self, view: &WorldView) {
        // The right ones first: a student's lies over them.
        let mut twins: Vec<&Twin> = view.twins.iter().collect();
        twins.sort_by_key(|twin| twin.is_dashed);
        for twin in twins {
            self.twin(twin, view);
        }
    }

    fn twin(&mut self, twin: &Twin, view: &WorldView) {
        let pen = |color: Color32, width: f32| {
            let pen = Pen::new(ITEM, color, if twin.is_dashed { 0.85 * width } else { width });
            if twin.is_dashed { pen.dashed() } else { pen }
        };
        let ray_pen = pen(self.colors.ray, 3.0);
        match twin.shape {
            TwinShape::BasisVector(index, vector) => {
                let (eye, color) = (view.camera.eye, self.colors.basis[index]);
                let length = self.arrow_length(eye);
                let head = [Head::Filled, Head::Open, Head::Double][index];
                let Some(direction) = unit(vector) else { return };
                let reach = vector.length().clamp(LENGTHS.0, LENGTHS.1);
                let pen = pen(color, 3.4);
                let tip = self.arrow(eye, eye + length * reach * direction, head, pen);
                self.label_tip(pen, twin.label.as_str(), tip, (color, VECTOR_TEXT, true));
            }
            TwinShape::Direction(ray) => {
                let tip = self.arrow(ray.origin, ray.at(1.0), Head::Filled, ray_pen);
                self.name_tip(ray_pen, twin, tip);
            }
            TwinShape::Ray(ray, t) => self.twin_ray(twin, ray, t, ray_pen, view),
            TwinShape::OnRay(ray, t) => {
                let at = ray.at(t);
                self.line(ray.origin, at, Pen { width: 1.6, ..ray_pen }.without_halo());
                self.twin_point(twin, at, ray_pen);
            }
            TwinShape::Point(at) => self.twin_point(twin, at, ray_pen),
            TwinShape::Normal(at, normal) => {
                let Some(direction) = unit(normal) else { return };
                let length = self.normal_length(at);
                let pen = pen(self.colors.hit, 2.4);
                let reach = normal.length().clamp(LENGTHS.0, LENGTHS.1);
                let tip = self.arrow(at, at + length * reach * direction, Head::Filled, pen);
                self.name_tip(pen, twin, tip);
            }
        }
    }

    /// Draws a ray up to its t, or to what it hits, and names it where it passes the viewport.
    fn twin_ray(&mut self, twin: &Twin, ray: Ray, t: Option<f64>, pen: Pen, view: &WorldView) {
        let hit = t.or_else(|| view.scene.first_hit(&ray).map(|hit| hit.t));
        let end = match (hit, unit(ray.direction)) {
            (Some(t), _) => ray.at(t),
            (None, Some(d)) => ray.origin + 100.0 * view.observer.distance() * d,
            (None, None) => return,
        };
        self.line(ray.origin, end, pen);
        if hit.is_some() {
            self.ring_or_disc(twin, end, 5.0, pen);
        }
        if let Some(spot) = self.screen.spot(ray.at(1.0)) {
            let font = (pen.color, POINT_TEXT, true);
            self.label(pen, twin.label.as_str(), spot.at, DVec2::new(0.3, -1.0), font);
        }
    }

    fn twin_point(&mut self, twin: &Twin, at: DVec3, pen: Pen) {
        self.ring_or_disc(twin, at, 5.5, pen);
        if let Some(spot) = self.screen.spot(at) {
            let font = (pen.color, POINT_TEXT, true);
            self.label(pen, twin.label.as_str(), spot.at, DVec2::new(0.5, 1.0), font);
        }
    }

    /// Draws a point: the right one as a disc, a student's as a ring.
    fn ring_or_disc(&mut self, twin: &Twin, at: DVec3, radius: f32, pen: Pen) {
        if twin.is_dashed {
            self.ring(at, radius + 2.0, pen);
        } else {
            self.point(at, radius, pen);
        }
    }

    fn name_tip(&mut self, pen: Pen, twin: &Twin, tip: Option<Tip>) {
        self.label_tip(pen, twin.label.as_str(), tip, (pen.color, POINT_TEXT, true));
    }
}
