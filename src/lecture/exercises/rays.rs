//! The questions about a canonical camera's ray, and the wall that it meets.

use pinhole_core::{Basis, DVec2, DVec3, Ray};

use super::solve::{Parts, Wrong, number, one, t_of_wall, vector, view_ray, wanting, wrong_t};
use super::wanted::{Surface, Wanted};
use super::{Asked, Part, Slip};

pub(super) fn of_uv(uv: DVec2) -> Parts {
    let ray = view_ray(Basis::CANONICAL, 1.0, uv);
    let parts = vec![
        wanting(Asked::Origin, vector(ray.origin), vec![Wanted::Eye(ray.origin)]),
        Part {
            may_be_scaled: true,
            ..wanting(Asked::Direction, vector(ray.direction), vec![through(1.0, uv)])
        },
    ];
    let p = |x, y, z| one(Slip::ViewportForEye, Asked::Origin, vector(DVec3::new(x, y, z)));
    let mut wrongs = vec![p(0.0, 0.0, -1.0), p(uv.x, uv.y, -1.0), p(uv.x, uv.y, 0.0)];
    let d = |(slip, d)| one(slip, Asked::Direction, vector(d));
    wrongs.extend(wrong_directions(uv, 1.0).map(d));
    (parts, wrongs)
}

fn through(distance: f64, uv: DVec2) -> Wanted {
    Wanted::Through { basis: Basis::CANONICAL, distance, uv }
}

/// What is often given for the direction of a canonical camera's ray.
fn wrong_directions(uv: DVec2, distance: f64) -> impl Iterator<Item = (Slip, DVec3)> {
    let DVec2 { x: u, y: v } = uv;
    [
        (Slip::SignOfZ, u, v, distance),
        (Slip::FlatDirection, u, v, 0.0),
        (Slip::UvSwapped, v, u, -distance),
        (Slip::VDown, u, -v, -distance),
        (Slip::ULeft, -u, v, -distance),
        (Slip::UvLeftOut, 0.0, 0.0, -distance),
    ]
    .into_iter()
    .map(|(slip, x, y, z)| (slip, DVec3::new(x, y, z)))
}

/// What is often given for the t of a wall, with the point where it is.
pub(super) fn wrong_t_of_wall(ray: &Ray, t: f64, z: f64) -> Vec<Wrong> {
    [
        (Slip::SignOfT, -t),
        (Slip::CoordinateForT, z),
        (Slip::CoordinateForT, -z),
        (Slip::TForDistance, ray.distance_along(t)),
        (Slip::TInverted, 1.0 / t),
        (Slip::FromViewport, t - 1.0),
    ]
    .map(|(slip, t)| wrong_t(slip, t, vector(ray.at(t))))
    .into()
}

pub(super) fn and_wall(uv: DVec2, z: f64) -> Parts {
    let ray = view_ray(Basis::CANONICAL, 1.0, uv);
    let t = t_of_wall(&ray, z);
    let point = ray.at(t);
    let parts = vec![
        wanting(Asked::T, number(t), vec![Wanted::Meets(ray, Surface::Wall(z))]),
        wanting(
            Asked::Point,
            vector(point),
            vec![Wanted::On(Surface::Wall(z)), Wanted::OnRay(ray)],
        ),
    ];
    let mut wrongs = wrong_t_of_wall(&ray, t, z);
    // The wrong ray's t, and the wrong ray's point.
    wrongs.extend(wrong_directions(uv, 1.0).map(|(slip, d)| {
        let t = z / d.z;
        wrong_t(slip, t, vector(t * d))
    }));
    // d's z from a right t, and t from a right z.
    wrongs.push(one(Slip::SignOfZ, Asked::Point, vector(DVec3::new(point.x, point.y, -z))));
    wrongs.push(one(Slip::UvUnscaled, Asked::Point, vector(uv.extend(z))));
    (parts, wrongs)
}

pub(super) fn at_distance(uv: DVec2, distance: f64, z: f64) -> Parts {
    let ray = view_ray(Basis::CANONICAL, distance, uv);
    let t = t_of_wall(&ray, z);
    let parts = vec![
        wanting(Asked::Direction, vector(ray.direction), vec![through(distance, uv)]),
        wanting(Asked::T, number(t), vec![Wanted::Meets(ray, Surface::Wall(z))]),
    ];
    let scaled = distance * uv;
    let wrong = |(slip, d): (Slip, DVec3)| Wrong {
        slip,
        answers: vec![(Asked::Direction, vector(d)), (Asked::T, number(z / d.z))],
    };
    let of_distance = [
        (Slip::DistanceDropped, uv.extend(-1.0)),
        (Slip::DistanceOnAll, scaled.extend(-distance)),
        (Slip::DistanceOnUv, scaled.extend(-1.0)),
        (Slip::ViewportAtOne, (uv / distance).extend(-1.0)),
    ];
    let mut wrongs: Vec<Wrong> =
        of_distance.into_iter().chain(wrong_directions(uv, distance)).map(wrong).collect();
    wrongs.extend(wrong_t_of_wall(&ray, t, z));
    wrongs.push(one(Slip::FromViewport, Asked::T, number(-z - distance)));
    (parts, wrongs)
}
