//! A student's answers in the world view, dashed, beside the right ones.

use egui::Color32;
use pinhole_core::{DVec2, DVec3, Ray};

use crate::model::overlay_items::Item;
use crate::model::practice::answer_marks::{AnswerMark, MarkShape};
use crate::view::overlay::space::screen::unit;
use crate::view::overlay::space::sketch::{Head, Pen, Sketch};
use crate::view::overlay::style::{POINT_TEXT, VECTOR_TEXT};
use crate::view::overlay::world_view::WorldView;

/// Length, in unit vectors, between which an answer is drawn as long as it is.
const LENGTHS: (f64, f64) = (0.3, 1.5);

/// The pens of answers. They are switched by no checkbox, because they are what the page is about.
const ITEM: Item = Item::Eye;

impl Sketch<'_> {
    /// Draws the answers, on top of what belongs to the camera.
    pub(crate) fn answer_marks(&mut self, view: &WorldView) {
        // The right ones first: a student's lies over them.
        let mut marks: Vec<&AnswerMark> = view.answer_marks.iter().collect();
        marks.sort_by_key(|mark| mark.is_dashed);
        for mark in marks {
            self.answer_mark(mark, view);
        }
    }

    fn answer_mark(&mut self, mark: &AnswerMark, view: &WorldView) {
        let pen = |color: Color32, width: f32| {
            let pen = Pen::new(ITEM, color, if mark.is_dashed { 0.85 * width } else { width });
            if mark.is_dashed { pen.dashed() } else { pen }
        };
        let ray_pen = pen(self.colors.ray, 3.0);
        match mark.shape {
            MarkShape::BasisVector(index, vector) => {
                let (eye, color) = (view.camera.eye, self.colors.basis[index]);
                let head = [Head::Filled, Head::Open, Head::Double][index];
                let arrow = (eye, vector, self.arrow_length(eye));
                self.mark_vector(mark, arrow, head, pen(color, 3.4), VECTOR_TEXT);
            }
            MarkShape::Direction(ray) => {
                let tip = self.arrow(ray.origin, ray.at(1.0), Head::Filled, ray_pen);
                let font = (ray_pen.color, POINT_TEXT, true);
                self.label_tip(ray_pen, mark.label.as_str(), tip, font);
            }
            MarkShape::Ray(ray, t) => self.mark_ray(mark, ray, t, ray_pen, view),
            MarkShape::OnRay(ray, t) => {
                let at = ray.at(t);
                self.line(ray.origin, at, Pen { width: 1.6, ..ray_pen }.without_halo());
                self.mark_point(mark, at, ray_pen);
            }
            MarkShape::Point(at) => self.mark_point(mark, at, ray_pen),
            MarkShape::Normal(at, normal) => {
                let (arrow, pen) =
                    ((at, normal, self.normal_length(at)), pen(self.colors.hit, 2.4));
                self.mark_vector(mark, arrow, Head::Filled, pen, POINT_TEXT);
            }
        }
    }

    /// Draws an arrow from a point; `unit_length` is the length of a unit vector.
    fn mark_vector(
        &mut self,
        mark: &AnswerMark,
        (from, vector, unit_length): (DVec3, DVec3, f64),
        head: Head,
        pen: Pen,
        text_size: f32,
    ) {
        let Some(direction) = unit(vector) else { return };
        let reach = vector.length().clamp(LENGTHS.0, LENGTHS.1);
        let tip = self.arrow(from, from + unit_length * reach * direction, head, pen);
        self.label_tip(pen, mark.label.as_str(), tip, (pen.color, text_size, true));
    }

    /// Draws a ray up to its t, or to what it hits, and names it where it passes the viewport.
    fn mark_ray(
        &mut self,
        mark: &AnswerMark,
        ray: Ray,
        t: Option<f64>,
        pen: Pen,
        view: &WorldView,
    ) {
        let hit = t.or_else(|| view.scene.first_hit(&ray).map(|hit| hit.t));
        let end = match (hit, unit(ray.direction)) {
            (Some(t), _) => ray.at(t),
            (None, Some(d)) => ray.origin + 100.0 * view.observer.distance() * d,
            (None, None) => return,
        };
        self.line(ray.origin, end, pen);
        if hit.is_some() {
            self.ring_or_disc(mark, end, 5.0, pen);
        }
        if let Some(spot) = self.screen.spot(ray.at(1.0)) {
            let font = (pen.color, POINT_TEXT, true);
            self.label(pen, mark.label.as_str(), spot.at, DVec2::new(0.3, -1.0), font);
        }
    }

    fn mark_point(&mut self, mark: &AnswerMark, at: DVec3, pen: Pen) {
        self.ring_or_disc(mark, at, 5.5, pen);
        if let Some(spot) = self.screen.spot(at) {
            let font = (pen.color, POINT_TEXT, true);
            self.label(pen, mark.label.as_str(), spot.at, DVec2::new(0.5, 1.0), font);
        }
    }

    /// Draws a point: the right one as a disc, a student's as a ring.
    fn ring_or_disc(&mut self, mark: &AnswerMark, at: DVec3, radius: f32, pen: Pen) {
        if mark.is_dashed {
            self.ring(at, radius + 2.0, pen);
        } else {
            self.point(at, radius, pen);
        }
    }
}
