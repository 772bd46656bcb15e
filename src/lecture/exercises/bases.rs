//! The questions about a basis: set by hand, or found from view or at, and up.

use pinhole_core::{Basis, Camera, DVec2, DVec3, Orientation};

use super::judge::{Condition, Surface};
use super::question::{Answer, Asked, Given, QuestionPart};
use super::rays::wrong_t_of_wall;
use super::solve::{
    Parts, Wrong, camera, number, part, part_with, t_of_wall, turned, vector, view_ray,
};
use crate::mistakes::{GivenCamera, Mistake, PipelineCamera};

pub(super) fn turned_by_hand(right: DVec3, uv: DVec2, z: f64) -> Parts {
    let Basis { u, v, w } = turned(right);
    let ray = view_ray(Basis { u, v, w }, 1.0, uv);
    let t = t_of_wall(&ray, z);
    let through = Condition::Through { basis: Basis { u, v, w }, distance: 1.0, uv };
    let parts = vec![
        QuestionPart { orthogonal_to: vec![("w", w)], ..part(Asked::U, vector(u)) },
        QuestionPart { orthogonal_to: vec![("u", u), ("w", w)], ..part(Asked::V, vector(v)) },
        QuestionPart { orthogonal_to: vec![("u", u)], ..part(Asked::W, vector(w)) },
        part_with(Asked::Direction, vector(ray.direction), vec![through]),
        part_with(Asked::T, number(t), vec![Condition::Meets(ray, Surface::Wall(z))]),
    ];
    // The wall's t is along the wrong direction.
    let direction = |mistake, d: DVec3| Wrong {
        mistake,
        answers: vec![(Asked::Direction, vector(d)), (Asked::T, number(z / d.z))],
    };
    let basis = |mistake, u: DVec3, v: DVec3, w: DVec3| {
        let mut wrong = direction(mistake, uv.x * u + uv.y * v - w);
        wrong.answers.extend(basis_answers(u, v, w));
        wrong
    };
    // Of length √2, and of length √½: the two axes' sum, and their mean.
    let sum = |v: DVec3| v.signum() * v.abs().ceil();
    let other_way = turned(DVec3::new(right.x, right.y, -right.z));
    let mut wrongs = vec![
        basis(Mistake::WForwards, u, v, -w),
        basis(Mistake::ULeftwards, -u, v, w),
        basis(Mistake::VIsUCrossW, u, -v, w),
        basis(Mistake::UAndWSwapped, w, v, u),
        basis(Mistake::TurnedOtherWay, other_way.u, other_way.v, other_way.w),
        basis(Mistake::BasisUnnormalized, sum(u), v, sum(w)),
        basis(Mistake::BasisUnnormalized, 0.5 * sum(u), v, 0.5 * sum(w)),
        direction(
            Mistake::DistanceAdded,
            Mistake::DistanceAdded.usual().direction([u, v, w], 1.0, uv),
        ),
        direction(Mistake::BasisForgotten, uv.extend(-1.0)),
        direction(Mistake::ZIsMinusDistance, DVec3 { z: -1.0, ..ray.direction }),
        direction(Mistake::UvSwapped, uv.y * u + uv.x * v - w),
        direction(Mistake::VDown, uv.x * u - uv.y * v - w),
        direction(Mistake::ULeft, -uv.x * u + uv.y * v - w),
        direction(Mistake::FlatDirection, uv.x * u + uv.y * v),
        direction(Mistake::UvLeftOut, -w),
    ];
    wrongs.extend(wrong_t_of_wall(&ray, t, z));
    (parts, wrongs)
}

fn basis_answers(u: DVec3, v: DVec3, w: DVec3) -> [(Asked, Answer); 3] {
    [(Asked::U, vector(u)), (Asked::V, vector(v)), (Asked::W, vector(w))]
}

/// The parts of a question about a basis found from view or at, and up; `None` where up does not
/// fix one.
pub(super) fn constructed(given: &Given) -> Option<Parts> {
    let camera = camera(given)?;
    let Basis { u, v, w } = camera.basis().ok()?;
    // In the order in which they are found.
    let parts = vec![
        part(Asked::W, vector(w)),
        QuestionPart {
            orthogonal_to: vec![("up", camera.up()), ("w", w)],
            ..part(Asked::U, vector(u))
        },
        QuestionPart { orthogonal_to: vec![("w", w), ("u", u)], ..part(Asked::V, vector(v)) },
    ];
    let basis =
        |mistake, u, v, w| Wrong { mistake, answers: basis_answers(u, v, w).into_iter().collect() };
    // What is seen comes before what may have led to it.
    let mut wrongs = vec![basis(Mistake::ULeftwards, -u, v, w)];
    wrongs.extend(
        wrong_cameras(&camera).map(|(mistake, made)| basis(mistake, made.u, made.v, made.w)),
    );
    wrongs.push(basis(Mistake::UAndVSwapped, v, u, w));
    wrongs.extend(wrong_points(&camera).filter_map(|(mistake, back)| {
        let Basis { u, v, w } = Basis::from_view_up(-back, camera.up()).ok()?;
        Some(basis(mistake, u, v, w))
    }));
    Some((parts, wrongs))
}

/// The cameras that an answer can come from, with the mistake that makes them.
fn wrong_cameras(camera: &Camera) -> impl Iterator<Item = (Mistake, PipelineCamera)> {
    const USUAL: usize = 1;
    let is_at = camera.orientation.has_at();
    // Given points, at - eye is what is taken for w.
    let w_forwards = if is_at { Mistake::WIsAtMinusEye } else { Mistake::WAsPrinted };
    let mistakes = [
        (w_forwards, USUAL),
        (Mistake::VIsUCrossW, USUAL),
        (Mistake::UIsWCrossUp, USUAL),
        (Mistake::LeftHanded, USUAL),
        (Mistake::NotNormalized, USUAL),
        (Mistake::WNotNormalized, USUAL),
        (Mistake::UpAsV, usize::MAX),
        (Mistake::NothingNormalized, usize::MAX),
        (Mistake::WIsView, usize::MAX),
    ];
    let given = GivenCamera::new(camera).ok();
    given.into_iter().flat_map(move |given| {
        mistakes.into_iter().flat_map(move |(mistake, ways)| {
            let pipelines = mistake.pipelines().take(ways);
            pipelines.map(move |pipeline| (mistake, given.camera_of(pipeline)))
        })
    })
}

/// Vectors that are often taken for eye - at.
fn wrong_points(camera: &Camera) -> impl Iterator<Item = (Mistake, DVec3)> {
    let eye = camera.eye;
    let wrong = move |at: DVec3| {
        [(Mistake::EyeForgotten, -at), (Mistake::AtForgotten, eye), (Mistake::EyePlusAt, eye + at)]
    };
    let at = match camera.orientation {
        Orientation::At { at, .. } => Some(at),
        _ => None,
    };
    at.into_iter().flat_map(wrong)
}
