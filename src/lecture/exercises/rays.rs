//! The questions about a canonical camera's ray, and the wall that it meets.

use pinhole_core::{Basis, DVec2, DVec3, Ray};

use super::judge::{Condition, Surface};
use super::question::{Asked, QuestionPart};
use super::solve::{
    Parts, Wrong, number, one_wrong, part_with, t_of_wall, vector, view_ray, wrong_t,
};
use crate::mistakes::Mistake;

pub(super) fn of_uv(uv: DVec2) -> Parts {
    let ray = view_ray(Basis::CANONICAL, 1.0, uv);
    let parts = vec![
        part_with(Asked::Origin, vector(ray.origin), vec![Condition::Eye(ray.origin)]),
        QuestionPart {
            may_be_scaled: true,
            ..part_with(Asked::Direction, vector(ray.direction), vec![through(1.0, uv)])
        },
    ];
    let p =
        |x, y, z| one_wrong(Mistake::ViewportForEye, Asked::Origin, vector(DVec3::new(x, y, z)));
    let mut wrongs = vec![p(0.0, 0.0, -1.0), p(uv.x, uv.y, -1.0), p(uv.x, uv.y, 0.0)];
    let d = |(mistake, d)| one_wrong(mistake, Asked::Direction, vector(d));
    wrongs.extend(wrong_directions(uv, 1.0).map(d));
    (parts, wrongs)
}

/// u, v and w of the canonical camera.
const AXES: [DVec3; 3] = [DVec3::X, DVec3::Y, DVec3::Z];

fn through(distance: f64, uv: DVec2) -> Condition {
    Condition::Through { basis: Basis::CANONICAL, distance, uv }
}

/// Directions that are often given for a canonical camera's ray.
fn wrong_directions(uv: DVec2, distance: f64) -> impl Iterator<Item = (Mistake, DVec3)> {
    let DVec2 { x: u, y: v } = uv;
    let flat = Mistake::FlatDirection;
    [
        (Mistake::SignOfZ, DVec3::new(u, v, distance)),
        (flat, flat.usual().direction(AXES, distance, uv)),
        (Mistake::UvSwapped, DVec3::new(v, u, -distance)),
        (Mistake::VDown, DVec3::new(u, -v, -distance)),
        (Mistake::ULeft, DVec3::new(-u, v, -distance)),
        (Mistake::UvLeftOut, DVec3::new(0.0, 0.0, -distance)),
    ]
    .into_iter()
}

/// Numbers that are often given for the t of a wall, each with the point where it is.
pub(super) fn wrong_t_of_wall(ray: &Ray, t: f64, z: f64) -> Vec<Wrong> {
    [
        (Mistake::SignOfT, -t),
        (Mistake::CoordinateForT, z),
        (Mistake::CoordinateForT, -z),
        (Mistake::TForDistance, ray.distance_along(t)),
        (Mistake::TInverted, 1.0 / t),
        (Mistake::FromViewport, t - 1.0),
    ]
    .map(|(mistake, t)| wrong_t(mistake, t, vector(ray.at(t))))
    .into()
}

pub(super) fn and_wall(uv: DVec2, z: f64) -> Parts {
    let ray = view_ray(Basis::CANONICAL, 1.0, uv);
    let t = t_of_wall(&ray, z);
    let point = ray.at(t);
    let parts = vec![
        part_with(Asked::T, number(t), vec![Condition::Meets(ray, Surface::Wall(z))]),
        part_with(
            Asked::Point,
            vector(point),
            vec![Condition::On(Surface::Wall(z)), Condition::OnRay(ray)],
        ),
    ];
    let mut wrongs = wrong_t_of_wall(&ray, t, z);
    // The wrong ray's t, and the wrong ray's point.
    wrongs.extend(wrong_directions(uv, 1.0).map(|(mistake, d)| {
        let t = z / d.z;
        wrong_t(mistake, t, vector(t * d))
    }));
    // d's z from a right t, and t from a right z.
    wrongs.push(one_wrong(
        Mistake::SignOfZ,
        Asked::Point,
        vector(DVec3::new(point.x, point.y, -z)),
    ));
    wrongs.push(one_wrong(Mistake::UvUnscaled, Asked::Point, vector(uv.extend(z))));
    (parts, wrongs)
}

pub(super) fn at_distance(uv: DVec2, distance: f64, z: f64) -> Parts {
    let ray = view_ray(Basis::CANONICAL, distance, uv);
    let t = t_of_wall(&ray, z);
    let parts = vec![
        part_with(Asked::Direction, vector(ray.direction), vec![through(distance, uv)]),
        part_with(Asked::T, number(t), vec![Condition::Meets(ray, Surface::Wall(z))]),
    ];
    let scaled = distance * uv;
    let wrong = |(mistake, d): (Mistake, DVec3)| Wrong {
        mistake,
        answers: vec![(Asked::Direction, vector(d)), (Asked::T, number(z / d.z))],
    };
    let dropped = Mistake::DistanceDropped;
    let of_distance = [
        (dropped, dropped.usual().direction(AXES, distance, uv)),
        (Mistake::DistanceOnAll, scaled.extend(-distance)),
        (Mistake::DistanceOnUv, scaled.extend(-1.0)),
        (Mistake::ViewportAtOne, (uv / distance).extend(-1.0)),
    ];
    let mut wrongs: Vec<Wrong> =
        of_distance.into_iter().chain(wrong_directions(uv, distance)).map(wrong).collect();
    wrongs.extend(wrong_t_of_wall(&ray, t, z));
    wrongs.push(one_wrong(Mistake::FromViewport, Asked::T, number(-z - distance)));
    (parts, wrongs)
}
