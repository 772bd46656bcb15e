//! The questions about a basis: set by hand, or found from view or at, and up.

use pinhole_core::{Basis, Camera, DVec2, DVec3, Orientation};

use super::rays::wrong_t_of_wall;
use super::solve::{Parts, Wrong, camera, number, part, t_of_wall, vector, view_ray, wanting};
use super::wanted::{Surface, Wanted};
use super::{Asked, Given, Part, Slip, turned};
use crate::mistakes::{Mistake, WrongCamera};

pub(super) fn turned_by_hand(right: DVec3, uv: DVec2, z: f64) -> Parts {
    let Basis { u, v, w } = turned(right);
    let ray = view_ray(Basis { u, v, w }, 1.0, uv);
    let t = t_of_wall(&ray, z);
    let through = Wanted::Through { basis: Basis { u, v, w }, distance: 1.0, uv };
    let parts = vec![
        Part { orthogonal_to: vec![("w", w)], ..part(Asked::U, vector(u)) },
        Part { orthogonal_to: vec![("u", u), ("w", w)], ..part(Asked::V, vector(v)) },
        Part { orthogonal_to: vec![("u", u)], ..part(Asked::W, vector(w)) },
        wanting(Asked::Direction, vector(ray.direction), vec![through]),
        wanting(Asked::T, number(t), vec![Wanted::Meets(ray, Surface::Wall(z))]),
    ];
    // The wall's t is along the wrong direction.
    let direction = |slip, d: DVec3| Wrong {
        slip,
        answers: vec![(Asked::Direction, vector(d)), (Asked::T, number(z / d.z))],
    };
    let basis = |slip, u: DVec3, v: DVec3, w: DVec3| {
        let mut wrong = direction(slip, uv.x * u + uv.y * v - w);
        wrong.answers.extend(basis_answers(u, v, w));
        wrong
    };
    // Of length √2, and of length √½: the two axes' sum, and their mean.
    let sum = |v: DVec3| v.signum() * v.abs().ceil();
    let other_way = turned(DVec3::new(right.x, right.y, -right.z));
    let mut wrongs = vec![
        basis(Slip::WForwards, u, v, -w),
        basis(Slip::ULeftwards, -u, v, w),
        basis(Slip::VIsUCrossW, u, -v, w),
        basis(Slip::UAndWSwapped, w, v, u),
        basis(Slip::TurnedOtherWay, other_way.u, other_way.v, other_way.w),
        basis(Slip::BasisUnnormalized, sum(u), v, sum(w)),
        basis(Slip::BasisUnnormalized, 0.5 * sum(u), v, 0.5 * sum(w)),
        direction(Slip::PlusW, uv.x * u + uv.y * v + w),
        direction(Slip::BasisForgotten, uv.extend(-1.0)),
        direction(Slip::ZIsMinusDistance, DVec3 { z: -1.0, ..ray.direction }),
        direction(Slip::UvSwapped, uv.y * u + uv.x * v - w),
        direction(Slip::VDown, uv.x * u - uv.y * v - w),
        direction(Slip::ULeft, -uv.x * u + uv.y * v - w),
        direction(Slip::FlatDirection, uv.x * u + uv.y * v),
        direction(Slip::UvLeftOut, -w),
    ];
    wrongs.extend(wrong_t_of_wall(&ray, t, z));
    (parts, wrongs)
}

fn basis_answers(u: DVec3, v: DVec3, w: DVec3) -> [(Asked, super::Answer); 3] {
    [(Asked::U, vector(u)), (Asked::V, vector(v)), (Asked::W, vector(w))]
}

/// Nothing where up does not fix a basis.
pub(super) fn constructed(given: &Given) -> Option<Parts> {
    let camera = camera(given)?;
    let Basis { u, v, w } = camera.basis().ok()?;
    // In the order in which they are found.
    let parts = vec![
        part(Asked::W, vector(w)),
        Part { orthogonal_to: vec![("up", camera.up()), ("w", w)], ..part(Asked::U, vector(u)) },
        Part { orthogonal_to: vec![("w", w), ("u", u)], ..part(Asked::V, vector(v)) },
    ];
    let basis =
        |slip, u, v, w| Wrong { slip, answers: basis_answers(u, v, w).into_iter().collect() };
    // What is seen comes before what may have led to it.
    let mut wrongs = vec![basis(Slip::ULeftwards, -u, v, w)];
    wrongs.extend(
        wrong_cameras(&camera).map(|(slip, wrong)| basis(slip, wrong.u(), wrong.v(), wrong.w())),
    );
    let (view, up) = (camera.view(), camera.up());
    wrongs.push(basis(Slip::UpAsV, u, up.normalize(), w));
    // Nothing is normalized; then with w = view, u or not.
    let plain_u = up.cross(-view);
    wrongs.push(basis(Slip::NothingNormalized, plain_u, (-view).cross(plain_u), -view));
    wrongs.push(basis(Slip::WIsView, -u, view.cross(-u), view));
    wrongs.push(basis(Slip::WIsView, -plain_u, view.cross(-plain_u), view));
    wrongs.push(basis(Slip::UAndVSwapped, v, u, w));
    wrongs.extend(wrong_points(&camera).filter_map(|(slip, back)| {
        let Basis { u, v, w } = Basis::from_view_up(-back, up).ok()?;
        Some(basis(slip, u, v, w))
    }));
    Some((parts, wrongs))
}

/// The gallery's wrong cameras that an answer can come from.
fn wrong_cameras(camera: &Camera) -> impl Iterator<Item = (Slip, WrongCamera)> {
    let mistakes = [
        (Slip::WAsPrinted, Mistake::WAsPrinted),
        (Slip::WIsAtMinusEye, Mistake::WIsAtMinusEye),
        (Slip::VIsUCrossW, Mistake::VIsUCrossW),
        (Slip::UIsWCrossUp, Mistake::UIsWCrossUp),
        (Slip::LeftHanded, Mistake::LeftHanded),
        (Slip::UNotNormalized, Mistake::NotNormalized),
        (Slip::WNotNormalized, Mistake::WNotNormalized),
        (Slip::UpAsV, Mistake::UpAsV),
    ];
    let is_at = matches!(camera.orientation, Orientation::At { .. });
    // Given points, at - eye is what is taken for w.
    let fits = move |(_, mistake): &(Slip, Mistake)| !(is_at && *mistake == Mistake::WAsPrinted);
    mistakes
        .into_iter()
        .filter(fits)
        .filter_map(|(slip, mistake)| Some((slip, WrongCamera::new(camera, mistake).ok()?)))
}

/// What is often taken for eye - at.
fn wrong_points(camera: &Camera) -> impl Iterator<Item = (Slip, DVec3)> {
    let eye = camera.eye;
    let of = move |at: DVec3| {
        [(Slip::EyeForgotten, -at), (Slip::AtForgotten, eye), (Slip::EyePlusAt, eye + at)]
    };
    let at = match camera.orientation {
        Orientation::At { at, .. } => Some(at),
        _ => None,
    };
    at.into_iter().flat_map(of)
}
