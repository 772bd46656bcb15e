//! Draws, dashed, what the world view compares with the edited camera: the ghost, which is another camera
//! (its eye, basis, frustum and viewport, with a prime after each name), and a student's answers.

use egui::Color32;
use pinhole_core::{DVec2, DVec3, Ray, ResolvedCamera};
use pinhole_lecture::mistakes::WrongCamera;

use crate::model::{AnswerMark, Item, MarkShape, OverlayItems};
use crate::view::overlay::{
    BASIS, BOLD_POINT, Head, LabelFont, LineStyle, MARK, MEDIUM, POINT, Shape, Sketch, THIN,
    VECTOR, corners, unit,
};

/// Length at which the ghost's frustum edges are drawn, as a multiple of the distance from the eye to the
/// viewport's corner.
const FRUSTUM: f64 = 2.2;

/// Length up to which a basis vector of the ghost is drawn to scale; longer ones are cut off here. The
/// vectors of a wrong camera may have any length.
const LONGEST: f64 = 2.0;

/// The ghost, a camera that is compared with the edited one: a frozen camera, or a camera with a mistake.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GhostCamera {
    eye: DVec3,
    /// The vectors u, v and w; `None` for a vector that is not drawn.
    basis: [Option<DVec3>; 3],
    /// Vectors from the eye to the viewport's corners, clockwise in the image, starting at the corner
    /// of pixel (0, 0).
    corners: [DVec3; 4],
    /// True if this is a camera with a mistake rather than a frozen camera.
    is_wrong: bool,
    /// True if this is a student's camera, which is drawn whatever else is hidden.
    is_answer: bool,
    /// True if the corner of pixel (0, 0) lies at another place than that of the edited camera.
    is_turned: bool,
}

impl GhostCamera {
    /// Creates the ghost of a frozen camera.
    pub fn frozen(camera: &ResolvedCamera) -> GhostCamera {
        let basis = camera.basis();
        GhostCamera {
            eye: camera.eye(),
            basis: [basis.u, basis.v, basis.w].map(Some),
            corners: corners(camera).map(|uv| camera.ray(uv).direction),
            is_wrong: false,
            is_answer: false,
            is_turned: false,
        }
    }

    /// Creates the ghost that shows a camera with a mistake. Of its basis, only the wrong vectors are
    /// drawn.
    pub fn of_mistake(wrong: &WrongCamera) -> GhostCamera {
        let right = wrong.right_camera();
        let [u, v, w] = wrong.wrong_vectors();
        let first = corners(right).map(|uv| right.ray(uv).direction)[0];
        let corners = wrong.corner_directions();
        GhostCamera {
            eye: right.eye(),
            basis: [u.then(|| wrong.u()), v.then(|| wrong.v()), w.then(|| wrong.w())],
            corners,
            is_wrong: true,
            is_answer: false,
            is_turned: (corners[0] - first).length() > 0.25 * first.length(),
        }
    }

    /// Creates the ghost of a student's camera with a mistake. The vectors of its basis have marks of their own.
    pub fn of_answer(wrong: &WrongCamera) -> GhostCamera {
        GhostCamera { basis: [None; 3], is_answer: true, ..GhostCamera::of_mistake(wrong) }
    }

    /// Returns the eye, and the ends of the frustum's edges or else the viewport's corners.
    pub(crate) fn points(&self, items: OverlayItems) -> impl Iterator<Item = DVec3> {
        let reach = if items.shows(Item::Frustum) { FRUSTUM } else { 1.0 };
        let ends = self.corners.map(|corner| self.eye + reach * corner);
        ends.into_iter().chain([self.eye])
    }

    /// Returns the drawn vectors of the basis: their directions, and their lengths as multiples of the basis
    /// arrows' length.
    pub(crate) fn arrows(&self) -> impl Iterator<Item = (DVec3, f64)> {
        let vectors = self.basis.into_iter().flatten();
        vectors.filter_map(|vector| Some((unit(vector)?, vector.length().min(LONGEST))))
    }
}

impl Sketch<'_> {
    /// Draws the ghost, without an eye or arrows that are the edited camera's own. This must be done before
    /// the edited camera is drawn, which then covers it.
    pub(crate) fn ghost(&mut self, ghost: &GhostCamera) {
        let GhostCamera { eye, corners, .. } = *ghost;
        let ink = self.colors.ink;
        let item = |item| if ghost.is_answer { ITEM } else { item };
        let edge = LineStyle::new(item(Item::Frustum), ink, THIN).dashed();
        let outline = LineStyle::new(item(Item::Viewport), ink, MEDIUM).dashed();
        for corner in corners {
            self.line(eye, eye + FRUSTUM * corner, edge);
        }
        self.sides(corners.map(|corner| eye + corner), outline);
        if ghost.is_wrong
            && let Some(spot) = self.screen.spot(eye + corners[2])
        {
            let outward = self.on_screen(eye + corners[2], corners[2] - corners[0]);
            self.label(outline, "wrong camera", [spot.at, outward], POINT);
        }
        let length = self.screen.arrow_length(eye);
        let own = self.view.resolved.filter(|own| own.eye() == eye).map(|own| *own.basis());
        let own = own.map_or([None; 3], |own| [own.u, own.v, own.w].map(Some));
        let arrows = ghost.basis.into_iter().zip(own).zip(BASIS).zip(self.colors.basis);
        for (((vector, own), (_, name, head)), color) in arrows {
            let Some(vector) = vector.filter(|vector| Some(*vector) != own) else { continue };
            let pen = LineStyle::new(Item::Basis, color, MEDIUM).dashed();
            let tip = eye + length * vector.clamp_length_max(LONGEST);
            self.named_arrow([eye, tip], head, pen, &format!("{name}′"), VECTOR);
        }
        let pen = LineStyle::new(Item::Eye, ink, 2.0);
        if eye != self.view.camera.eye {
            self.named_point(eye, 4.5, pen, "eye′", [0.6, 1.0]);
        }
        let pen = LineStyle::new(item(Item::Marks), self.colors.mark, 2.0);
        if ghost.is_turned
            && let Some(spot) = self.point(eye + corners[0], 3.6, pen)
        {
            self.label(pen, "(0, 0)′", [spot.at, DVec2::new(-0.6, -1.0)], MARK);
        }
    }
}

/// Range of lengths within which a vector in an answer is drawn to scale. A unit vector has length 1.
const LENGTHS: (f64, f64) = (0.3, 1.5);

/// The overlay item to which all answers belong. It has no checkbox on this page, since the answers are its
/// subject.
const ITEM: Item = Item::Eye;

impl Sketch<'_> {
    /// Draws the answers on top of the camera's marks.
    pub(crate) fn answer_marks(&mut self) {
        // The right answers are drawn first, so that the student's answers lie on top.
        let mut marks: Vec<&AnswerMark> = self.view.answer_marks.iter().collect();
        marks.sort_by_key(|mark| mark.is_dashed);
        for mark in marks {
            self.answer_mark(mark);
        }
    }

    fn answer_mark(&mut self, mark: &AnswerMark) {
        let pen = |color: Color32, width: f32| {
            let pen =
                LineStyle::new(ITEM, color, if mark.is_dashed { 0.85 * width } else { width });
            if mark.is_dashed { pen.dashed() } else { pen }
        };
        let ray_pen = pen(self.colors.ray, 3.0);
        match mark.shape {
            MarkShape::BasisVector(index, vector) => {
                let (eye, color) = (self.view.camera.eye, self.colors.basis[index]);
                let (_, _, head) = BASIS[index];
                let arrow = (eye, vector, self.screen.arrow_length(eye));
                self.mark_vector(mark, arrow, head, pen(color, 3.4), VECTOR);
            }
            MarkShape::Direction(ray) => {
                let ends = [ray.origin, ray.at(1.0)];
                self.named_arrow(ends, Head::Filled, ray_pen, &mark.label, BOLD_POINT);
            }
            MarkShape::Ray(ray, t) => self.mark_ray(mark, ray, t, ray_pen),
            MarkShape::OnRay(ray, t) => {
                let at = ray.at(t);
                self.line(ray.origin, at, LineStyle { width: THIN, ..ray_pen }.without_halo());
                self.mark_point(mark, at, ray_pen);
            }
            MarkShape::Point(at) => self.mark_point(mark, at, ray_pen),
            MarkShape::Normal(at, normal) => {
                let arrow = (at, normal, self.screen.normal_length(at));
                let pen = pen(self.colors.hit, 2.4);
                self.mark_vector(mark, arrow, Head::Filled, pen, BOLD_POINT);
            }
        }
    }

    /// Draws a vector of an answer as an arrow that starts at the point `from`. `unit_length` is the length
    /// at which a unit vector is drawn.
    fn mark_vector(
        &mut self,
        mark: &AnswerMark,
        (from, vector, unit_length): (DVec3, DVec3, f64),
        head: Head,
        pen: LineStyle,
        font: LabelFont,
    ) {
        let Some(direction) = unit(vector) else { return };
        let reach = vector.length().clamp(LENGTHS.0, LENGTHS.1);
        let tip = from + unit_length * reach * direction;
        self.named_arrow([from, tip], head, pen, &mark.label, font);
    }

    /// Draws a ray of an answer up to `t` or, if that is `None`, up to its first hit. Puts the label where
    /// the ray passes through the viewport.
    fn mark_ray(&mut self, mark: &AnswerMark, ray: Ray, t: Option<f64>, pen: LineStyle) {
        let hit = t.or_else(|| self.scene.first_hit(&ray).map(|hit| hit.t));
        let end = match (hit, unit(ray.direction)) {
            (Some(t), _) => ray.at(t),
            (None, Some(d)) => ray.origin + 100.0 * self.view.observer.distance() * d,
            (None, None) => return,
        };
        self.line(ray.origin, end, pen);
        if hit.is_some() {
            self.ring_or_disc(mark, end, 5.0, pen);
        }
        self.label_at(ray.at(1.0), pen, &mark.label, DVec2::new(0.3, -1.0), BOLD_POINT);
    }

    fn mark_point(&mut self, mark: &AnswerMark, at: DVec3, pen: LineStyle) {
        self.ring_or_disc(mark, at, 5.5, pen);
        self.label_at(at, pen, &mark.label, DVec2::new(0.5, 1.0), BOLD_POINT);
    }

    /// Draws a point of an answer: as a ring for a student's answer, as a disc for the right one.
    fn ring_or_disc(&mut self, mark: &AnswerMark, at: DVec3, radius: f32, pen: LineStyle) {
        if !mark.is_dashed {
            self.point(at, radius, pen);
        } else if let Some(spot) = self.screen.spot(at).filter(|_| self.items.shows(pen.item)) {
            let scale = self.drawing.scale;
            let ring = Shape::ring(spot.at, ((radius + 2.0) * scale).into(), 24, 2.4 * scale);
            self.drawing.marks.push(pen.mark(ring, self.colors.halo));
        }
    }
}
