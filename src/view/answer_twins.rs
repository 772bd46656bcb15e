//! A graded answer of a student, or a wrong camera's ray, as the world view draws it beside the right
//! one.

use pinhole_core::{Pixel, Ray, ResolvedCamera, Scene, Selection};
use pinhole_lecture::grading::{Answers, GivenHit, Graded};
use pinhole_lecture::mistakes::WrongCamera;

use crate::model::practice::twin::{Twin, TwinShape};

/// Returns the wrong camera's ray for the selected pixel.
pub(crate) fn of_mistake(wrong: &WrongCamera, scene: &Scene, selection: Selection) -> Vec<Twin> {
    let ray = match selection.inside(wrong.image()) {
        Selection::Pixel(pixel) => wrong.ray(pixel),
        Selection::Uv(uv) => wrong.ray_at(uv),
    };
    let Ok(ray) = ray else { return Vec::new() };
    let t = scene.first_hit(&ray).map(|hit| hit.t);
    vec![Twin::yours(TwinShape::Ray(ray, t), "ray′")]
}

/// Returns the student's answer for the selected pixel where it is wrong. Where the file has none for
/// it, returns the worst answer with the right one beside it.
pub(crate) fn of_answers(
    graded: &Graded,
    camera: &ResolvedCamera,
    scene: &Scene,
    selection: Selection,
) -> Vec<Twin> {
    if let Answers::Basis(vectors) = &graded.answers {
        let names = ["your u", "your v", "your w"];
        let is_wrong = |index: &usize| !graded.grade.is_right[*index];
        let twin = |index: usize| {
            Twin::yours(TwinShape::BasisVector(index, vectors[index].value), names[index])
        };
        return (0..vectors.len()).filter(is_wrong).map(twin).collect();
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
    let mut twins = yours(graded, worst.index, &ray, scene);
    if !twins.is_empty() {
        let t = scene.first_hit(&ray).map(|hit| hit.t);
        twins.push(Twin::right(TwinShape::Ray(ray, t), "right ray"));
    }
    twins
}

fn index_of(graded: &Graded, pixel: Pixel) -> Option<usize> {
    let count = graded.grade.is_right.len();
    (0..count).find(|index| graded.pixel(*index) == Some(pixel))
}

/// Returns an answer's own ray or hit. A hit of which only t is given lies on the right ray.
fn yours(graded: &Graded, index: usize, right: &Ray, scene: &Scene) -> Vec<Twin> {
    let shape = match &graded.answers {
        Answers::Rays(rays) => {
            let Ok(ray) = Ray::new(rays[index].origin.value, rays[index].direction.value) else {
                return Vec::new();
            };
            let t = scene.first_hit(&ray).map(|hit| hit.t);
            return vec![Twin::yours(TwinShape::Ray(ray, t), "your ray")];
        }
        Answers::Hits(hits) => match hits[index].hit {
            Some(GivenHit { point: Some(point), .. }) => TwinShape::Point(point.value),
            Some(GivenHit { t: Some(t), .. }) => TwinShape::OnRay(*right, t.value),
            _ => return Vec::new(),
        },
        Answers::Basis(_) | Answers::Picture(_) => return Vec::new(),
    };
    vec![Twin::yours(shape, "your hit")]
}
