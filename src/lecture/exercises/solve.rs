//! The right answers, and those that mistakes give.

use pinhole_core::{Basis, Camera, DVec2, DVec3, Orientation, Plane, Ray};

use super::judge::is_near;
use super::wanted::Wanted;
use super::{Answer, Asked, Given, Part, camera as camera_of, turned};
use super::{bases, objects, rays};
use crate::mistakes::Mistake;

/// A wrong answer: each of the things asked for that a mistake changes.
pub(super) struct Wrong {
    pub(super) mistake: Mistake,
    pub(super) answers: Vec<(Asked, Answer)>,
}

/// What a question asks for, and the answers that mistakes give.
pub(super) type Parts = (Vec<Part>, Vec<Wrong>);

/// What a question asks for; nothing where a basis cannot be found or a sphere is not met. A mistake
/// that changes nothing in its numbers is no wrong answer.
pub(super) fn parts(given: &Given) -> Option<Vec<Part>> {
    let (mut parts, wrongs) = match *given {
        Given::Uv(uv) => rays::of_uv(uv),
        Given::UvAndWall { uv, z } => rays::and_wall(uv, z),
        Given::Distance { uv, distance, z } => rays::at_distance(uv, distance, z),
        Given::Turned { right, uv, z } => bases::turned_by_hand(right, uv, z),
        Given::ViewUp { .. } | Given::EyeAtUp { .. } => bases::constructed(given)?,
        Given::Sphere { ray, sphere } => objects::sphere(&ray, &sphere)?,
        Given::Lines { line, origin, direction } => objects::lines(line, origin, direction),
    };
    for Wrong { mistake, answers } in wrongs {
        for (asked, answer) in answers {
            let part = parts.iter_mut().find(|part| part.asked == asked);
            if let Some(part) = part.filter(|part| is_another(&part.truth, &answer)) {
                part.mistakes.push((mistake, answer));
            }
        }
    }
    Some(parts)
}

fn is_another(truth: &Answer, answer: &Answer) -> bool {
    match (truth, answer) {
        (Answer::Numbers(truth), Answer::Numbers(answer)) => {
            answer.iter().all(|x| x.is_finite()) && !is_near(answer, truth)
        }
        (truth, answer) => truth != answer,
    }
}

/// The camera of a question, whose ray through its (u, v) is the question's.
pub(super) fn camera(given: &Given) -> Option<Camera> {
    let looking = |view| Orientation::View { view, up: DVec3::Y };
    Some(match *given {
        Given::Uv(_) | Given::UvAndWall { .. } => Camera::CANONICAL,
        Given::Distance { distance, .. } => camera_of(DVec3::ZERO, looking(DVec3::NEG_Z), distance),
        Given::Turned { right, .. } => {
            camera_of(DVec3::ZERO, Orientation::Basis(turned(right)), 1.0)
        }
        Given::ViewUp { view, up } => camera_of(DVec3::ZERO, Orientation::View { view, up }, 1.0),
        Given::EyeAtUp { eye, at, up } => camera_of(eye, Orientation::At { at, up }, 1.0),
        Given::Sphere { ray: Ray { origin, direction }, .. } => {
            let up = if direction.x == 0.0 && direction.z == 0.0 { DVec3::Z } else { DVec3::Y };
            let orientation = Orientation::View { view: direction, up };
            camera_of(origin, orientation, direction.length())
        }
        Given::Lines { .. } => return None,
    })
}

/// The plane at this z, facing the origin.
pub(super) fn wall(z: f64) -> Plane {
    Plane { point: DVec3::new(0.0, 0.0, z), normal: DVec3::new(0.0, 0.0, -z.signum()) }
}

pub(super) fn part(asked: Asked, truth: Answer) -> Part {
    Part {
        asked,
        truth,
        may_be_scaled: false,
        mistakes: Vec::new(),
        orthogonal_to: Vec::new(),
        wanted: Vec::new(),
    }
}

/// A part whose answer has to fulfil these.
pub(super) fn wanting(asked: Asked, truth: Answer, wanted: Vec<Wanted>) -> Part {
    Part { wanted, ..part(asked, truth) }
}

pub(super) fn number(x: f64) -> Answer {
    Answer::Numbers(vec![x])
}

pub(super) fn vector(v: DVec3) -> Answer {
    Answer::Numbers(v.to_array().to_vec())
}

pub(super) fn place(v: DVec2) -> Answer {
    Answer::Numbers(v.to_array().to_vec())
}

pub(super) fn one(mistake: Mistake, asked: Asked, answer: Answer) -> Wrong {
    Wrong { mistake, answers: vec![(asked, answer)] }
}

/// The ray from the origin through a place in the viewport: `u U + v V - distance W`.
pub(super) fn view_ray(basis: Basis, distance: f64, uv: DVec2) -> Ray {
    let Basis { u, v, w } = basis;
    Ray { origin: DVec3::ZERO, direction: uv.x * u + uv.y * v - distance * w }
}

/// Where a ray from the origin meets the plane at this z, to which no question's ray is parallel: u is
/// below 1, so `-distance w` outweighs `u U` in z.
pub(super) fn t_of_wall(ray: &Ray, z: f64) -> f64 {
    z / ray.direction.z
}

/// The wrong t, each with the point that is found with it.
pub(super) fn wrong_t(mistake: Mistake, t: f64, point: Answer) -> Wrong {
    Wrong { mistake, answers: vec![(Asked::T, number(t)), (Asked::Point, point)] }
}
