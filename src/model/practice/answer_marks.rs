//! Answers as marks in the world view: the answers typed in the open exercise, and the right
//! answers once they are no longer secret.

use pinhole_core::{DVec2, DVec3, Ray};
use pinhole_lecture::exercises::{Answer, Asked, Given};

use crate::model::overlay_items::{Item, OverlayItems};
use crate::model::practice::exercises::{Exercises, Feedback, TypedAnswer};

/// A student's answer or the right answer, as the world view draws it, with its label.
#[derive(Clone, Debug, PartialEq)]
pub struct AnswerMark {
    /// The shape that is drawn.
    pub shape: MarkShape,
    /// The label next to it.
    pub label: String,
    /// True for a student's answer, which is drawn dashed; false for the right answer.
    pub is_dashed: bool,
}

/// The shape of an answer in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MarkShape {
    /// u, v or w (0, 1 or 2), as an arrow from the eye.
    BasisVector(usize, DVec3),
    /// A direction, drawn from a point as an arrow of the direction's own length.
    Direction(Ray),
    /// A ray up to this t, or up to the object that it hits if there is no t.
    Ray(Ray, Option<f64>),
    /// The point of a ray at this t.
    OnRay(Ray, f64),
    /// A point that is hit.
    Point(DVec3),
    /// A normal at a point.
    Normal(DVec3, DVec3),
}

impl AnswerMark {
    /// Returns a right answer.
    pub fn right(shape: MarkShape, label: impl Into<String>) -> AnswerMark {
        AnswerMark { shape, label: label.into(), is_dashed: false }
    }

    /// Returns a student's answer, labelled `your u` for the name `u`.
    pub fn yours(shape: MarkShape, name: &str) -> AnswerMark {
        AnswerMark { shape, label: format!("your {name}"), is_dashed: true }
    }
}

/// Describes the marks for screen readers: `drawn: u, your u (dashed)`.
pub fn spoken(marks: &[AnswerMark]) -> String {
    let word = |mark: &AnswerMark| match mark.is_dashed {
        true => format!("{} (dashed)", mark.label),
        false => mark.label.clone(),
    };
    match marks {
        [] => "no answer is drawn".to_owned(),
        _ => format!("drawn: {}", marks.iter().map(word).collect::<Vec<_>>().join(", ")),
    }
}

/// The vectors of a basis, in the order in which [`MarkShape::BasisVector`] numbers them.
const BASIS: [Asked; 3] = [Asked::U, Asked::V, Asked::W];

/// A part of the question with its answers.
struct Answered<'a> {
    typed: Option<Vec<f64>>,
    /// The right numbers, once they may be seen.
    right: Option<&'a [f64]>,
    /// The typed numbers, unless they are known to be right.
    yours: Option<Vec<f64>>,
}

impl Answered<'_> {
    fn right_vector(&self) -> Option<DVec3> {
        self.right.and_then(vector)
    }

    fn your_vector(&self) -> Option<DVec3> {
        self.yours.as_deref().and_then(vector)
    }

    fn typed_vector(&self) -> Option<DVec3> {
        self.typed.as_deref().and_then(vector)
    }
}

fn vector(numbers: &[f64]) -> Option<DVec3> {
    let vector = DVec3::from_array(numbers.try_into().ok()?);
    vector.is_finite().then_some(vector)
}

impl Exercises {
    /// Returns true if the right answer to this part may be seen.
    fn may_be_seen(&self, typed: &TypedAnswer) -> bool {
        self.is_solved || typed.feedback.as_ref().is_some_and(Feedback::is_good)
    }

    fn answered(&self, asked: Asked) -> Option<Answered<'_>> {
        let mut parts = self.question().parts.iter().zip(&self.answers);
        let (part, answer) = parts.find(|(part, _)| part.asked == asked)?;
        let right = match &part.truth {
            Answer::Numbers(numbers) if self.may_be_seen(answer) => Some(numbers.as_slice()),
            _ => None,
        };
        let is_right = answer.feedback.as_ref().is_some_and(Feedback::is_good);
        let typed = answer.numbers();
        let yours = typed.clone().filter(|_| !is_right);
        Some(Answered { typed, right, yours })
    }

    /// Returns those of the `usual` overlay items that do not give the answers away.
    pub(crate) fn items(&self, usual: OverlayItems) -> OverlayItems {
        use Item::*;
        let hidden = [Handles, Loupe, Ray, Hit, Picture, PixelGrid, Marks];
        let items = hidden.into_iter().fold(usual, |items, item| items.with(item, false));
        let asked = BASIS.map(|asked| self.answered(asked));
        if asked.iter().all(Option::is_none) {
            return items;
        }
        // Frustum and viewport show all three vectors.
        let is_secret = asked.iter().flatten().any(|answer| answer.right.is_none());
        let items = items.with(Item::Basis, false);
        let shows = |item| items.shows(item) && !is_secret;
        items.with(Item::Frustum, shows(Item::Frustum)).with(Item::Viewport, shows(Item::Viewport))
    }

    /// Returns the answers to draw in the scene of [`Exercises::document`].
    pub(crate) fn answer_marks(&self) -> Vec<AnswerMark> {
        let mut marks = Vec::new();
        for (index, (asked, name)) in BASIS.into_iter().zip(["u", "v", "w"]).enumerate() {
            let Some(answer) = self.answered(asked) else { continue };
            let shape = |vector| MarkShape::BasisVector(index, vector);
            marks.extend(answer.right_vector().map(|u| AnswerMark::right(shape(u), name)));
            marks.extend(answer.your_vector().map(|u| AnswerMark::yours(shape(u), name)));
        }
        self.mark_rays(&mut marks);
        self.mark_hits(&mut marks);
        marks
    }

    /// Returns the ray that the question gives, or the ray of its camera through its (u, v).
    fn given_ray(&self) -> Option<Ray> {
        match self.question().given {
            Given::Sphere { ray, .. } => Some(ray),
            _ => Some(self.question().camera()?.resolve().ok()?.ray(self.question().uv()?)),
        }
    }

    /// Adds the rays, and the points on them at the answered t.
    fn mark_rays(&self, marks: &mut Vec<AnswerMark>) {
        let Some(given) = self.given_ray() else { return };
        let t = self.answered(Asked::T);
        let on_ray = |ray: Ray| {
            let at = t.as_ref()?.yours.as_ref()?[0];
            Some(AnswerMark::yours(MarkShape::OnRay(ray, at), "t"))
        };
        let Some(direction) = self.answered(Asked::Direction) else {
            marks.push(AnswerMark::right(MarkShape::Direction(given), "d"));
            marks.extend(on_ray(given));
            return;
        };
        let yours = direction.your_vector();
        if let Some(d) = direction.right_vector() {
            let ray = Ray { direction: d, ..given };
            let right_t = t.as_ref().and_then(|t| t.right).map(|t| t[0]);
            marks.push(AnswerMark::right(MarkShape::Ray(ray, right_t), "ray"));
            marks.extend(on_ray(ray).filter(|_| yours.is_none()));
        }
        let p = self.answered(Asked::Origin);
        let origin = p.as_ref().and_then(Answered::typed_vector).unwrap_or(given.origin);
        if let Some(ray) = yours.and_then(|d| Ray::new(origin, d).ok()) {
            let typed_t = t.as_ref().and_then(|t| t.typed.as_ref()).map(|t| t[0]);
            marks.push(AnswerMark::yours(MarkShape::Ray(ray, typed_t), "ray"));
        } else if let Some(at) = p.and_then(|p| p.your_vector()) {
            marks.push(AnswerMark::yours(MarkShape::Point(at), "p"));
        }
    }

    /// Adds the points that the rays hit, and the normals there.
    fn mark_hits(&self, marks: &mut Vec<AnswerMark>) {
        let point = self.answered(Asked::Point);
        let right = point.as_ref().and_then(Answered::right_vector);
        marks.extend(right.map(|at| AnswerMark::right(MarkShape::Point(at), "hit")));
        let yours = point.as_ref().and_then(Answered::your_vector);
        marks.extend(yours.map(|at| AnswerMark::yours(MarkShape::Point(at), "hit")));
        let Some(normal) = self.answered(Asked::Normal) else { return };
        // The typed point, if there is one, gives no answer away.
        let typed = point.as_ref().and_then(Answered::typed_vector);
        if let (Some(at), Some(n)) = (right, normal.right_vector()) {
            marks.push(AnswerMark::right(MarkShape::Normal(at, n), "n"));
        }
        if let (Some(at), Some(n)) = (typed.or(right), normal.your_vector()) {
            marks.push(AnswerMark::yours(MarkShape::Normal(at, n), "n"));
        }
    }

    /// Returns the typed points of a question in two dimensions, with their labels.
    pub(crate) fn points_in_plane(&self) -> Vec<(String, DVec2)> {
        let Given::Lines { origin, direction, .. } = self.question().given else {
            return Vec::new();
        };
        let mut points = Vec::new();
        for (asked, name) in [(Asked::T, "t"), (Asked::Point, "point")] {
            let Some(answer) = self.answered(asked) else { continue };
            let at = match answer.yours.as_deref() {
                Some([t]) => origin + *t * direction,
                Some([x, y]) => DVec2::new(*x, *y),
                _ => continue,
            };
            points.push((format!("your {name}"), at));
        }
        points.retain(|(_, at)| at.is_finite());
        points
    }

    /// Returns the right t, if it is asked for.
    pub(crate) fn right_t(&self) -> Option<f64> {
        let part = self.question().parts.iter().find(|part| part.asked == Asked::T)?;
        match &part.truth {
            Answer::Numbers(numbers) => numbers.first().copied(),
            Answer::Yes(_) => None,
        }
    }

    /// Returns true if all right answers may be seen.
    pub(crate) fn shows_all(&self) -> bool {
        self.answers.iter().all(|typed| self.may_be_seen(typed))
    }
}
