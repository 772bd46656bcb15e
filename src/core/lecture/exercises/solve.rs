//! The right answers, and those that mistakes give.

use glam::{DVec2, DVec3};

use super::{Answer, Asked, Given, Part, Slip, camera as camera_of, turned};
use crate::basis::Basis;
use crate::camera::{Camera, Orientation};
use crate::lecture::mistakes::{Mistake, WrongCamera};
use crate::plane::Plane;
use crate::ray::Ray;
use crate::roots::Roots;
use crate::sphere::Sphere;

/// A wrong answer: each of the things asked for that a mistake changes.
struct Wrong {
    slip: Slip,
    answers: Vec<(Asked, Answer)>,
}

/// What a question asks for. A mistake that changes nothing in its numbers is no wrong answer.
pub(super) fn parts(given: &Given) -> Vec<Part> {
    let (mut parts, wrongs) = match *given {
        Given::Uv(uv) => ray_parts(uv),
        Given::UvAndWall { uv, z } => wall_parts(given, uv, z),
        Given::Distance { uv, distance, z } => distance_parts(given, uv, distance, z),
        Given::Turned { right, uv, z } => turned_parts(given, right, uv, z),
        Given::ViewUp { .. } | Given::EyeAtUp { .. } => basis_parts(given),
        Given::Sphere { ray, sphere } => sphere_parts(&ray, &sphere),
        Given::Lines { line, origin, direction } => line_parts(line, origin, direction),
    };
    for Wrong { slip, answers } in wrongs {
        for (asked, answer) in answers {
            let part = parts.iter_mut().find(|part| part.asked == asked);
            if let Some(part) = part.filter(|part| is_another(&part.truth, &answer)) {
                part.slips.push((slip, answer));
            }
        }
    }
    parts
}

fn is_another(truth: &Answer, answer: &Answer) -> bool {
    match (truth, answer) {
        (Answer::Numbers(truth), Answer::Numbers(answer)) => {
            let is_near = |(x, y): (&f64, &f64)| (x - y).abs() <= 1e-6 * y.abs().max(1.0);
            answer.iter().all(|x| x.is_finite()) && !truth.iter().zip(answer).all(is_near)
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

fn part(asked: Asked, truth: Answer) -> Part {
    let may_be_scaled = false;
    Part { asked, truth, may_be_scaled, slips: Vec::new(), orthogonal_to: Vec::new() }
}

fn number(x: f64) -> Answer {
    Answer::Numbers(vec![x])
}

fn vector(v: DVec3) -> Answer {
    Answer::Numbers(v.to_array().to_vec())
}

fn place(v: DVec2) -> Answer {
    Answer::Numbers(v.to_array().to_vec())
}

fn one(slip: Slip, asked: Asked, answer: Answer) -> Wrong {
    Wrong { slip, answers: vec![(asked, answer)] }
}

/// The first root; every question has one.
fn first(roots: Roots) -> f64 {
    match roots {
        Roots::None => f64::NAN,
        Roots::One(t) | Roots::Two(t, _) => t,
    }
}

/// The question's view ray; every question's camera has one.
fn view_ray(given: &Given, uv: DVec2) -> Ray {
    let posed = camera(given).and_then(|camera| camera.posed().ok());
    let none = Ray { origin: DVec3::ZERO, direction: DVec3::ZERO };
    posed.map_or(none, |posed| posed.ray(uv))
}

fn ray_parts(uv: DVec2) -> (Vec<Part>, Vec<Wrong>) {
    let ray = view_ray(&Given::Uv(uv), uv);
    let direction = |x, y, z| vector(DVec3::new(x, y, z));
    let parts = vec![
        part(Asked::Origin, vector(ray.origin)),
        Part { may_be_scaled: true, ..part(Asked::Direction, vector(ray.direction)) },
    ];
    let (u, v) = (uv.x, uv.y);
    let d = |slip, x, y, z| one(slip, Asked::Direction, direction(x, y, z));
    let wrongs = vec![
        one(Slip::ViewportForEye, Asked::Origin, direction(0.0, 0.0, -1.0)),
        one(Slip::ViewportForEye, Asked::Origin, direction(u, v, -1.0)),
        d(Slip::SignOfZ, u, v, 1.0),
        d(Slip::FlatDirection, u, v, 0.0),
        d(Slip::UvSwapped, v, u, -1.0),
        d(Slip::VDown, u, -v, -1.0),
    ];
    (parts, wrongs)
}

/// What is often given for the t of a wall.
fn wrong_t_of_wall(ray: &Ray, t: f64, z: f64) -> Vec<Wrong> {
    [
        (Slip::CoordinateForT, z),
        (Slip::SignOfT, -t),
        (Slip::TForDistance, ray.distance_along(t)),
        (Slip::TInverted, 1.0 / t),
    ]
    .map(|(slip, t)| one(slip, Asked::T, number(t)))
    .into()
}

fn wall_parts(given: &Given, uv: DVec2, z: f64) -> (Vec<Part>, Vec<Wrong>) {
    let ray = view_ray(given, uv);
    let t = first(wall(z).roots(&ray));
    let point = ray.at(t);
    let parts = vec![part(Asked::T, number(t)), part(Asked::Point, vector(point))];
    let mut wrongs = wrong_t_of_wall(&ray, t, z);
    wrongs.push(one(Slip::SignOfT, Asked::Point, vector(ray.at(-t))));
    let far = ray.at(ray.distance_along(t));
    wrongs.push(one(Slip::TForDistance, Asked::Point, vector(far)));
    wrongs.push(one(Slip::UvSwapped, Asked::Point, vector(DVec3::new(point.y, point.x, z))));
    (parts, wrongs)
}

fn distance_parts(given: &Given, uv: DVec2, distance: f64, z: f64) -> (Vec<Part>, Vec<Wrong>) {
    let ray = view_ray(given, uv);
    let t = first(wall(z).roots(&ray));
    let parts = vec![part(Asked::Direction, vector(ray.direction)), part(Asked::T, number(t))];
    let d = |x, y, z| vector(DVec3::new(x, y, z));
    let both = |slip, direction, t| Wrong {
        slip,
        answers: vec![(Asked::Direction, direction), (Asked::T, number(t))],
    };
    let (u, v) = (uv.x, uv.y);
    let mut wrongs = vec![
        both(Slip::Camera(Mistake::DistanceDropped), d(u, v, -1.0), -z),
        both(Slip::DistanceOnAll, d(distance * u, distance * v, -distance), -z / distance),
        one(Slip::SignOfZ, Asked::Direction, d(u, v, distance)),
        one(Slip::UvSwapped, Asked::Direction, d(v, u, -distance)),
        one(Slip::VDown, Asked::Direction, d(u, -v, -distance)),
    ];
    wrongs.extend(wrong_t_of_wall(&ray, t, z));
    (parts, wrongs)
}

fn turned_parts(given: &Given, right: DVec3, uv: DVec2, z: f64) -> (Vec<Part>, Vec<Wrong>) {
    let Basis { u, v, w } = turned(right);
    let ray = view_ray(given, uv);
    let t = first(wall(z).roots(&ray));
    let parts = vec![
        Part { orthogonal_to: vec![("w", w)], ..part(Asked::U, vector(u)) },
        Part { orthogonal_to: vec![("u", u), ("w", w)], ..part(Asked::V, vector(v)) },
        Part { orthogonal_to: vec![("u", u)], ..part(Asked::W, vector(w)) },
        part(Asked::Direction, vector(ray.direction)),
        part(Asked::T, number(t)),
    ];
    let wrong = |slip, answers: Vec<(Asked, DVec3)>| Wrong {
        slip,
        answers: answers.into_iter().map(|(asked, v)| (asked, vector(v))).collect(),
    };
    let sign = |v: DVec3| v.signum() * v.abs().ceil();
    let mut wrongs = vec![
        wrong(Slip::Camera(Mistake::WAsPrinted), vec![(Asked::W, -w)]),
        wrong(Slip::UAndWSwapped, vec![(Asked::U, w), (Asked::W, u)]),
        wrong(Slip::Unnormalized, vec![(Asked::U, sign(u)), (Asked::W, sign(w))]),
        wrong(Slip::PlusW, vec![(Asked::Direction, uv.x * u + uv.y * v + w)]),
        wrong(Slip::BasisForgotten, vec![(Asked::Direction, uv.extend(-1.0))]),
        wrong(Slip::UvSwapped, vec![(Asked::Direction, uv.y * u + uv.x * v - w)]),
        wrong(Slip::VDown, vec![(Asked::Direction, uv.x * u - uv.y * v - w)]),
        wrong(Slip::UAndWSwapped, vec![(Asked::Direction, uv.x * w + uv.y * v - u)]),
        wrong(Slip::FlatDirection, vec![(Asked::Direction, uv.x * u + uv.y * v)]),
    ];
    wrongs.extend(wrong_t_of_wall(&ray, t, z));
    (parts, wrongs)
}

fn basis_parts(given: &Given) -> (Vec<Part>, Vec<Wrong>) {
    // Every question's camera has a basis.
    let Some(camera) = camera(given) else { return Default::default() };
    let Ok(Basis { u, v, w }) = camera.basis() else { return Default::default() };
    let up = camera.up();
    // In the order in which they are found.
    let parts = vec![
        part(Asked::W, vector(w)),
        Part { orthogonal_to: vec![("up", up), ("w", w)], ..part(Asked::U, vector(u)) },
        Part { orthogonal_to: vec![("w", w), ("u", u)], ..part(Asked::V, vector(v)) },
    ];
    let basis = |slip, u, v, w| Wrong {
        slip,
        answers: vec![(Asked::U, vector(u)), (Asked::V, vector(v)), (Asked::W, vector(w))],
    };
    let mistakes = [
        Mistake::WAsPrinted,
        Mistake::WIsAtMinusEye,
        Mistake::VIsUCrossW,
        Mistake::UIsWCrossUp,
        Mistake::LeftHanded,
        Mistake::NotNormalized,
        Mistake::WNotNormalized,
        Mistake::UpAsV,
    ];
    let is_at = matches!(camera.orientation, Orientation::At { .. });
    // Given points, at - eye is what is taken for w.
    let fits = |mistake: &Mistake| !(is_at && *mistake == Mistake::WAsPrinted);
    let mut wrongs: Vec<Wrong> = mistakes
        .into_iter()
        .filter(fits)
        .filter_map(|mistake| {
            let wrong = WrongCamera::new(&camera, mistake).ok()?;
            Some(basis(Slip::Camera(mistake), wrong.u(), wrong.v(), wrong.w()))
        })
        .collect();
    wrongs.push(basis(Slip::UAndVSwapped, v, u, w));
    if let Orientation::At { at, up } = camera.orientation
        && let Ok(wrong) = Basis::from_eye_at_up(DVec3::ZERO, at, up)
    {
        wrongs.push(basis(Slip::EyeForgotten, wrong.u, wrong.v, wrong.w));
    }
    (parts, wrongs)
}

fn sphere_parts(ray: &Ray, sphere: &Sphere) -> (Vec<Part>, Vec<Wrong>) {
    let roots = sphere.roots(ray);
    let t = first(roots);
    let normal = |point: DVec3| (point - sphere.center) / sphere.radius;
    let point = ray.at(t);
    let parts = vec![
        part(Asked::T, number(t)),
        part(Asked::Point, vector(point)),
        part(Asked::Normal, vector(normal(point))),
    ];
    let oc = ray.origin - sphere.center;
    let (a, b) = (ray.direction.length_squared(), ray.direction.dot(oc));
    let c = oc.length_squared() - sphere.radius * sphere.radius;
    // Where D is below 0 there is no such answer.
    let wrong_ts = [
        (Slip::BForHalfB, (-2.0 * b - (4.0 * b * b - a * c).sqrt()) / a),
        (
            Slip::RadiusNotSquared,
            (-b - (b * b - a * (oc.length_squared() - sphere.radius)).sqrt()) / a,
        ),
        (Slip::ALeftOut, -b - (b * b - c).sqrt()),
        (Slip::TForDistance, ray.distance_along(t)),
        (Slip::SignOfT, -t),
    ];
    let mut wrongs: Vec<Wrong> = Vec::new();
    if let Roots::Two(_, far) = roots {
        wrongs.push(Wrong {
            slip: Slip::FarRoot,
            answers: vec![
                (Asked::T, number(far)),
                (Asked::Point, vector(ray.at(far))),
                (Asked::Normal, vector(normal(ray.at(far)))),
            ],
        });
    }
    wrongs.extend(wrong_ts.into_iter().map(|(slip, t)| Wrong {
        slip,
        answers: vec![(Asked::T, number(t)), (Asked::Point, vector(ray.at(t)))],
    }));
    let n = normal(point);
    wrongs.push(one(Slip::NormalInwards, Asked::Normal, vector(-n)));
    wrongs.push(one(Slip::Unnormalized, Asked::Normal, vector(sphere.radius * n)));
    if let Some(from_origin) = point.try_normalize() {
        wrongs.push(one(Slip::NormalFromOrigin, Asked::Normal, vector(from_origin)));
    }
    (parts, wrongs)
}

fn line_parts(line: DVec3, origin: DVec2, direction: DVec2) -> (Vec<Part>, Vec<Wrong>) {
    let (normal, c) = (line.truncate(), line.z);
    let (gap, step) = (normal.dot(origin) + c, normal.dot(direction));
    let at = |t: f64| place(origin + t * direction);
    let t = -gap / step;
    let parts = vec![
        part(Asked::T, number(t)),
        part(Asked::Point, at(t)),
        part(Asked::Hits, Answer::Yes(t > 0.0)),
    ];
    let mut wrongs: Vec<Wrong> = [
        (Slip::SignOfT, -t),
        (Slip::CLeftOut, -normal.dot(origin) / step),
        (Slip::SignOfC, (c - normal.dot(origin)) / step),
        (Slip::OriginLeftOut, -c / step),
        (Slip::TInverted, 1.0 / t),
    ]
    .into_iter()
    .map(|(slip, t)| Wrong { slip, answers: vec![(Asked::T, number(t)), (Asked::Point, at(t))] })
    .collect();
    wrongs.push(one(Slip::OriginLeftOut, Asked::Point, place(t * direction)));
    wrongs.push(one(Slip::LineForRay, Asked::Hits, Answer::Yes(t <= 0.0)));
    (parts, wrongs)
}
