//! What is compared with the edited camera, dashed: the ghost, which is another camera (its eye, basis, frustum and
//! viewport, with a prime after each name), and a student's answers.

use pinhole_core::{DVec2, DVec3, Ray, ResolvedCamera};
use pinhole_lecture::mistakes::WrongCamera;
use pinhole_lecture::numbers::written;

use super::camera::{BASIS, corners};
use super::{Form, Length, Parts, Place, Toward};
use crate::overlay::{
    BOLD_POINT, Head, LABEL_DIGITS, LabelFont, LineStyle, MARK, MEDIUM, POINT, THIN, VECTOR, unit,
};
use crate::{AnswerMark, Item, MarkShape};

/// Length at which the ghost's frustum edges are drawn, as a multiple of the distance from the eye to the
/// viewport's corner.
const FRUSTUM: f64 = 2.2;

/// Length up to which a basis vector of the ghost is drawn to scale; longer ones are cut off here. The
/// vectors of a wrong camera may have any length.
const LONGEST: f64 = 2.0;

/// Radius of the arc from a vector of the ghost's basis to the edited camera's, as a multiple of the basis arrows' length.
const TURN: f64 = 0.7;

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
}

/// Range of lengths within which a vector in an answer is drawn to scale. A unit vector has length 1.
const LENGTHS: (f64, f64) = (0.3, 1.5);

/// The overlay item to which all answers belong. It has no checkbox on this page, since the answers are its
/// subject.
const ITEM: Item = Item::Eye;

impl Parts<'_> {
    /// Adds the ghost, without an eye or arrows that are the edited camera's own.
    pub(super) fn ghost(&mut self, ghost: &GhostCamera) {
        let GhostCamera { eye, corners, .. } = *ghost;
        let (figure, ink) = (self.figure, self.colors.ink);
        let item = |item| if ghost.is_answer { ITEM } else { item };
        let edge = LineStyle::new(item(Item::Frustum), ink, THIN).dashed();
        let outline = LineStyle::new(item(Item::Viewport), ink, MEDIUM).dashed();
        for corner in corners {
            let part = self.line([eye, eye + FRUSTUM * corner], edge);
            part.is_endless = !figure.shows(Item::Frustum);
        }
        let part = self.sides(corners.map(|corner| eye + corner), outline);
        if ghost.is_wrong {
            let outward = Toward::along(corners[2] - corners[0]);
            part.labelled("wrong camera", POINT, outward).label_at(eye + corners[2]);
        }
        let own = figure.resolved.filter(|own| own.eye() == eye).map(|own| *own.basis());
        let own = own.map_or([None; 3], |own| [own.u, own.v, own.w].map(Some));
        let arrows = ghost.basis.into_iter().zip(own).zip(BASIS).zip(self.colors.basis);
        for (((vector, own), (_, name, head)), color) in arrows {
            let Some(vector) = vector.filter(|vector| Some(*vector) != own) else { continue };
            let pen = LineStyle::new(Item::Basis, color, MEDIUM).dashed();
            let vector = vector.clamp_length_max(LONGEST);
            // One that lies on an axis of the world is drawn beside it, on the other side than the camera's own.
            let is_on_axis = figure.shows(Item::Axes)
                && eye == DVec3::ZERO
                && DVec3::AXES.iter().any(|axis| axis.dot(vector) > 1.0 - 1e-9);
            let part = self.arrow_from(eye, vector, head, pen).named(format!("{name}′"), VECTOR);
            part.beside = own.filter(|_| is_on_axis);
            if let Some(own) = own {
                self.turned(eye, [vector, own]);
            }
        }
        if eye != figure.camera.eye {
            let pen = LineStyle::new(Item::Eye, ink, 2.0);
            self.point(eye, 4.5, pen).named_toward("eye′", 0.6, 1.0);
        }
        if ghost.is_turned {
            let pen = LineStyle::new(item(Item::Marks), self.colors.mark, 2.0);
            let toward = Toward::Screen(DVec2::new(-0.6, -1.0));
            self.point(eye + corners[0], 3.6, pen).labelled("(0, 0)′", MARK, toward);
        }
    }

    /// Adds the arc from a vector to where it has turned, with the angle.
    fn turned(&mut self, eye: DVec3, [from, to]: [DVec3; 2]) {
        let angle = from.angle_between(to);
        let Some(side) = unit(to - to.dot(from) / from.length_squared() * from) else { return };
        let pen = LineStyle::new(Item::RightAngles, self.colors.ink, THIN).on_top();
        let points = [0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0].map(|share: f64| {
            let (sin, cos) = (share * angle).sin_cos();
            Place { at: eye, along: TURN * (cos * from + sin * side), length: Length::Arrow }
        });
        let middle = points[4];
        let text = format!("{}°", written(angle.to_degrees(), LABEL_DIGITS));
        let part = self.line(points, pen.without_halo());
        part.labelled(text, POINT, Toward::along(middle.along)).label_at(middle);
    }

    /// Adds the answers: first the right ones, so that the student's lie on top.
    pub(super) fn answers(&mut self) {
        let mut marks: Vec<&AnswerMark> = self.figure.answers.iter().collect();
        marks.sort_by_key(|mark| mark.is_dashed);
        for mark in marks {
            self.answer(mark);
        }
    }

    fn answer(&mut self, mark: &AnswerMark) {
        let colors = self.colors;
        let pen = |color, width: f32| match mark.is_dashed {
            true => LineStyle::new(ITEM, color, 0.85 * width).dashed(),
            false => LineStyle::new(ITEM, color, width),
        };
        let ray_pen = pen(colors.ray, 3.0);
        match mark.shape {
            MarkShape::BasisVector(index, vector) => {
                let (eye, (_, _, head)) = (self.figure.camera.eye, BASIS[index]);
                let pen = pen(colors.basis[index], 3.4);
                self.answer_vector(mark, (eye, vector, Length::Arrow), head, pen, VECTOR);
            }
            MarkShape::Direction(ray) => {
                let ends = [ray.origin, ray.at(1.0)];
                self.arrow(ends, Head::Filled, ray_pen).named(&*mark.label, BOLD_POINT);
            }
            MarkShape::Ray(ray, t) => self.answer_ray(mark, &ray, t, ray_pen),
            MarkShape::OnRay(ray, t) => {
                let line = LineStyle { width: THIN, ..ray_pen }.without_halo();
                self.line([ray.origin, ray.at(t)], line);
                self.answer_point(mark, ray.at(t), ray_pen);
            }
            MarkShape::Point(at) => self.answer_point(mark, at, ray_pen),
            MarkShape::Normal(at, normal) => {
                let from = (at, normal, Length::Normal);
                self.answer_vector(mark, from, Head::Filled, pen(colors.hit, 2.4), BOLD_POINT);
            }
        }
    }

    /// Adds a vector of an answer as an arrow from a point.
    fn answer_vector(
        &mut self,
        mark: &AnswerMark,
        (at, vector, length): (DVec3, DVec3, Length),
        head: Head,
        pen: LineStyle,
        font: LabelFont,
    ) {
        let Some(direction) = unit(vector) else { return };
        let along = vector.length().clamp(LENGTHS.0, LENGTHS.1) * direction;
        self.arrow([at.into(), Place { at, along, length }], head, pen).named(&*mark.label, font);
    }

    /// Adds a ray of an answer up to `t` or, if that is `None`, up to its first hit. The label is where the ray passes
    /// through the viewport.
    fn answer_ray(&mut self, mark: &AnswerMark, ray: &Ray, t: Option<f64>, pen: LineStyle) {
        let hit = t.or_else(|| self.scene.first_hit(ray).map(|hit| hit.t));
        let end = hit.map_or(self.end_of(ray), |t| ray.at(t));
        let toward = Toward::Screen(DVec2::new(0.3, -1.0));
        let part = self.line([ray.origin, end], pen);
        part.labelled(&*mark.label, BOLD_POINT, toward).label_at(ray.at(1.0));
        part.is_endless = hit.is_none();
        if hit.is_some() {
            self.add(answer_form(mark, 5.0), &[end.into()], pen);
        }
    }

    fn answer_point(&mut self, mark: &AnswerMark, at: DVec3, pen: LineStyle) {
        let toward = Toward::Screen(DVec2::new(0.5, 1.0));
        let part = self.add(answer_form(mark, 5.5), &[at.into()], pen);
        part.labelled(&*mark.label, BOLD_POINT, toward);
    }
}

/// Returns the form of a point of an answer: a ring for a student's answer, a disc for the right one.
fn answer_form(mark: &AnswerMark, radius: f32) -> Form {
    if mark.is_dashed { Form::Ring(radius) } else { Form::Point(radius) }
}
