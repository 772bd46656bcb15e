//! Answers to an exercise as marks in the world view: those that the student typed, and the right ones once
//! they have been revealed.

use pinhole_core::{DVec2, DVec3, Ray};
use pinhole_figure::{AnswerMark, Item, MarkShape, OverlayItems};
use pinhole_lecture::exercises::{Answer, Asked, Given};

use crate::features::exercises::{Exercises, Feedback, TypedAnswer};

/// Describes the marks for screen readers, for example `drawn: u, your u (dashed)`.
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

/// The typed and the right answer to one part of the question. All fields are `None` if the question has no
/// such part.
#[derive(Default)]
struct Answered {
    /// The numbers that were typed.
    typed: Option<Vec<f64>>,
    /// The right numbers, once they have been revealed.
    right: Option<Vec<f64>>,
    /// The numbers that were typed, unless the check found them to be right.
    yours: Option<Vec<f64>>,
}

/// Returns the numbers as a vector if there are three and all are finite; otherwise `None`.
fn vector(numbers: &Option<Vec<f64>>) -> Option<DVec3> {
    let vector = DVec3::from_array(numbers.as_deref()?.try_into().ok()?);
    vector.is_finite().then_some(vector)
}

fn first(numbers: &Option<Vec<f64>>) -> Option<f64> {
    numbers.as_ref()?.first().copied()
}

/// Creates the mark of a typed answer, with the label `your NAME`.
fn your(shape: MarkShape, name: &str) -> AnswerMark {
    AnswerMark::yours(shape, format!("your {name}"))
}

impl Exercises {
    /// Returns true if the right answer to a part of the question may be shown. `typed` is the student's
    /// answer to it.
    fn may_be_seen(&self, typed: &TypedAnswer) -> bool {
        self.is_solved || typed.feedback.as_ref().is_some_and(Feedback::is_good)
    }

    /// Returns true if the question asks for this quantity.
    pub(crate) fn asks(&self, asked: Asked) -> bool {
        self.question().parts.iter().any(|part| part.asked == asked)
    }

    fn answered(&self, asked: Asked) -> Answered {
        let mut parts = self.question().parts.iter().zip(&self.answers);
        let Some((part, answer)) = parts.find(|(part, _)| part.asked == asked) else {
            return Answered::default();
        };
        let right = match &part.truth {
            Answer::Numbers(numbers) if self.may_be_seen(answer) => Some(numbers.clone()),
            _ => None,
        };
        let is_right = answer.feedback.as_ref().is_some_and(Feedback::is_good);
        let typed = answer.numbers();
        Answered { yours: typed.clone().filter(|_| !is_right), typed, right }
    }

    /// Returns those of the overlay items `usual` that reveal no answer.
    pub(crate) fn items(&self, usual: OverlayItems) -> OverlayItems {
        use Item::{
            At, Axes, Eye, Floor, Frustum, Labels, Measures, Planes, UvLegs, ViewAndUp, Viewport,
        };
        let mut basis = BASIS.into_iter().filter(|asked| self.asks(*asked)).peekable();
        // Without a question about the basis, the camera is given by its viewport.
        let camera: &[Item] = if basis.peek().is_some() { &[At, ViewAndUp] } else { &[] };
        let is_secret = |asked| self.asks(asked) && self.answered(asked).right.is_none();
        // What is on the viewport shows all three vectors.
        let is_basis_secret = basis.any(is_secret);
        let viewport: &[Item] = if is_basis_secret { &[] } else { &[Frustum, Viewport, Measures] };
        let legs: &[Item] = if is_basis_secret || is_secret(Asked::Uv) { &[] } else { &[UvLegs] };
        let may_be_seen = [&[Eye, Axes, Planes, Labels, Floor], camera, viewport, legs].concat();
        let shown = may_be_seen.into_iter().filter(|item| usual.shows(*item));
        shown.fold(OverlayItems::NONE, |all, item| all.with(item, true))
    }

    /// Returns the answers as marks to draw in the scene of [`Exercises::document`].
    pub(crate) fn answer_marks(&self) -> Vec<AnswerMark> {
        let mut marks = Vec::new();
        for (index, (asked, name)) in BASIS.into_iter().zip(["u", "v", "w"]).enumerate() {
            let Answered { right, yours, .. } = self.answered(asked);
            let shape = |vector| MarkShape::BasisVector(index, vector);
            marks.extend(vector(&right).map(|u| AnswerMark::right(shape(u), name)));
            marks.extend(vector(&yours).map(|u| your(shape(u), name)));
        }
        self.mark_rays(&mut marks);
        self.mark_hits(&mut marks);
        marks
    }

    /// Returns the ray that the question gives or, if it gives none, the ray of its camera through the
    /// given (u, v). Returns `None` if it gives neither.
    fn given_ray(&self) -> Option<Ray> {
        match self.question().given {
            Given::Sphere { ray, .. } | Given::Coefficients { ray, .. } => Some(ray),
            _ => Some(self.question().camera()?.resolve().ok()?.ray(self.question().uv()?)),
        }
    }

    /// Adds marks for the rays in the answers, and for the points on them at the answered t.
    fn mark_rays(&self, marks: &mut Vec<AnswerMark>) {
        let Some(given) = self.given_ray() else { return };
        let t = self.answered(Asked::T);
        let on_ray = |ray| first(&t.yours).map(|at| your(MarkShape::OnRay(ray, at), "t"));
        if !self.asks(Asked::Direction) {
            marks.push(AnswerMark::right(MarkShape::Direction(given), "d"));
            let to_hit = first(&t.right).map(|t| MarkShape::Ray(given, Some(t)));
            marks.extend(to_hit.map(|shape| AnswerMark::right(shape, "ray")));
            marks.extend(on_ray(given));
            return;
        }
        let (p, d) = (self.answered(Asked::Origin), self.answered(Asked::Direction));
        let yours = vector(&d.yours);
        if let Some(direction) = vector(&d.right) {
            let ray = Ray { direction, ..given };
            marks.push(AnswerMark::right(MarkShape::Ray(ray, first(&t.right)), "ray"));
            marks.extend(on_ray(ray).filter(|_| yours.is_none()));
        }
        let origin = vector(&p.typed).unwrap_or(given.origin);
        if let Some(ray) = yours.and_then(|d| Ray::new(origin, d).ok()) {
            marks.push(your(MarkShape::Ray(ray, first(&t.typed)), "ray"));
        } else {
            marks.extend(vector(&p.yours).map(|p| your(MarkShape::Point(p), "p")));
        }
    }

    /// Adds marks for the hit points in the answers, and for the normals there.
    fn mark_hits(&self, marks: &mut Vec<AnswerMark>) {
        let (point, normal) = (self.answered(Asked::Point), self.answered(Asked::Normal));
        let name = if self.asks(Asked::T) { "hit" } else { "point" };
        let right = vector(&point.right);
        marks.extend(right.map(|at| AnswerMark::right(MarkShape::Point(at), name)));
        let yours = vector(&point.yours);
        marks.extend(yours.map(|at| your(MarkShape::Point(at), name)));
        // The viewport of a question about (u, v) is the canonical one.
        let on_viewport = |uv: &Option<Vec<f64>>| match uv.as_deref()? {
            [u, v] => {
                Some(DVec3::new(*u, *v, -1.0)).filter(|at| at.is_finite()).map(MarkShape::Point)
            }
            _ => None,
        };
        let uv = self.answered(Asked::Uv);
        marks.extend(on_viewport(&uv.right).map(|at| AnswerMark::right(at, "(u, v)")));
        marks.extend(on_viewport(&uv.yours).map(|at| your(at, "(u, v)")));
        if let (Some(at), Some(n)) = (right, vector(&normal.right)) {
            marks.push(AnswerMark::right(MarkShape::Normal(at, n), "n"));
        }
        // The typed normal is drawn at the typed point, if there is one, rather than at the right one.
        if let (Some(at), Some(n)) = (vector(&point.typed).or(right), vector(&normal.yours)) {
            marks.push(your(MarkShape::Normal(at, n), "n"));
        }
    }

    /// Returns the points that were typed in a two-dimensional question, with their labels.
    pub(crate) fn points_in_plane(&self) -> Vec<(String, DVec2)> {
        let Given::Lines { origin, direction, .. } = self.question().given else {
            return Vec::new();
        };
        let mut points = Vec::new();
        for (asked, name) in [(Asked::T, "t"), (Asked::Point, "point")] {
            let at = match self.answered(asked).yours.as_deref() {
                Some([t]) => origin + *t * direction,
                Some([x, y]) => DVec2::new(*x, *y),
                _ => continue,
            };
            points.push((format!("your {name}"), at));
        }
        points.retain(|(_, at)| at.is_finite());
        points
    }

    /// Returns the t that is the right answer; `None` if the question does not ask for t.
    pub(crate) fn right_t(&self) -> Option<f64> {
        let part = self.question().parts.iter().find(|part| part.asked == Asked::T)?;
        match &part.truth {
            Answer::Numbers(numbers) => numbers.first().copied(),
            Answer::Yes(_) => None,
        }
    }

    /// Returns true if all right answers may be revealed.
    pub(crate) fn shows_all(&self) -> bool {
        self.answers.iter().all(|typed| self.may_be_seen(typed))
    }
}
