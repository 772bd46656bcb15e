//! The wrong camera and its ray, and a student's graded answer, as the world view draws them beside the
//! right ones.

use pinhole_core::{Pixel, Ray, ResolvedCamera, Scene, Selection};
use pinhole_lecture::grading::{Answers, GivenHit, Graded};
use pinhole_lecture::mistakes::WrongCamera;

use super::{Derived, Inputs};
use crate::model::practice::answer_marks::{AnswerMark, MarkShape};
use crate::model::session::ViewLayout;
use crate::model::session::ghost::resolve;
use crate::view::overlay::GhostCamera;

/// Returns the camera to compare with in the world view: a mistake's, or the frozen one.
pub(super) fn ghost(
    Inputs { document, session, .. }: Inputs<'_>,
    derived: &Derived,
) -> Option<GhostCamera> {
    if session.settings.layout == ViewLayout::Mistakes {
        // It would give away what the class is asked for.
        let is_secret = session.is_asking || !session.mistakes_view.is_revealed();
        let wrong = derived.wrong_camera().filter(|_| !is_secret && derived.fault.is_none())?;
        return wrong.camera.as_ref().ok().map(GhostCamera::of_mistake);
    }
    let ghost = session.ghost.as_ref()?;
    resolve(&ghost.camera, &document.camera).ok().as_ref().map(GhostCamera::frozen)
}

/// Returns the wrong camera's ray for the selected pixel.
pub(super) fn of_mistake(
    wrong: &WrongCamera,
    scene: &Scene,
    selection: Selection,
) -> Vec<AnswerMark> {
    let ray = match selection.inside(wrong.image()) {
        Selection::Pixel(pixel) => wrong.ray(pixel),
        Selection::Uv(uv) => wrong.ray_at(uv),
    };
    let Ok(ray) = ray else { return Vec::new() };
    let t = scene.first_hit(&ray).map(|hit| hit.t);
    vec![AnswerMark::yours(MarkShape::Ray(ray, t), "ray′")]
}

/// Returns the student's answer for the selected pixel where it is wrong. Where the file has none for
/// it, returns the worst answer with the right one beside it.
pub(super) fn of_answers(
    graded: &Graded,
    camera: &ResolvedCamera,
    scene: &Scene,
    selection: Selection,
) -> Vec<AnswerMark> {
    if let Answers::Basis(vectors) = &graded.answers {
        let names = ["your u", "your v", "your w"];
        let is_wrong = |index: &usize| !graded.grade.is_right[*index];
        let mark = |index: usize| {
            AnswerMark::yours(MarkShape::BasisVector(index, vectors[index].value), names[index])
        };
        return (0..vectors.len()).filter(is_wrong).map(mark).collect();
    }
    let selected = match selection {
        Selection::Pixel(pixel) => index_of(graded, pixel),
        Selection::Uv(_) => None,
    };
    if let Some(index) = selected {
        let is_right = graded.grade.is_right.get(index).copied().unwrap_or(true);
        return match (is_right, graded.pixel(index)) {
            (false, Some(pixel)) => yours(graded, index, &camera.ray_of_pixel(pixel), scene),
            _ => Vec::new(),
        };
    }
    let (Some(worst), Some(pixel)) = (&graded.grade.worst, graded.worst_pixel()) else {
        return Vec::new();
    };
    let ray = camera.ray_of_pixel(pixel);
    let mut marks = yours(graded, worst.index, &ray, scene);
    if !marks.is_empty() {
        let t = scene.first_hit(&ray).map(|hit| hit.t);
        marks.push(AnswerMark::right(MarkShape::Ray(ray, t), "right ray"));
    }
    marks
}

fn index_of(graded: &Graded, pixel: Pixel) -> Option<usize> {
    let count = graded.grade.is_right.len();
    (0..count).find(|index| graded.pixel(*index) == Some(pixel))
}

/// Returns an answer's own ray or hit. A hit of which only t is given lies on the right ray.
fn yours(graded: &Graded, index: usize, right: &Ray, scene: &Scene) -> Vec<AnswerMark> {
    let shape = match &graded.answers {
        Answers::Rays(rays) => {
            let Ok(ray) = Ray::new(rays[index].origin.value, rays[index].direction.value) else {
                return Vec::new();
            };
            let t = scene.first_hit(&ray).map(|hit| hit.t);
            return vec![AnswerMark::yours(MarkShape::Ray(ray, t), "your ray")];
        }
        Answers::Hits(hits) => match hits[index].hit {
            Some(GivenHit { point: Some(point), .. }) => MarkShape::Point(point.value),
            Some(GivenHit { t: Some(t), .. }) => MarkShape::OnRay(*right, t.value),
            _ => return Vec::new(),
        },
        Answers::Basis(_) | Answers::Picture(_) => return Vec::new(),
    };
    vec![AnswerMark::yours(shape, "your hit")]
}
