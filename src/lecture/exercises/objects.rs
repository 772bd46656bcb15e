//! The questions about what a ray meets: a sphere, and in two dimensions a line.

use pinhole_core::{DVec2, DVec3, Ray, Roots, Sphere};

use super::solve::{Parts, Wrong, number, one, part, place, vector, wanting, wrong_t};
use super::wanted::{Surface, Wanted};
use super::{Answer, Asked, Slip};

/// Nothing where the ray's line misses the sphere.
pub(super) fn sphere(ray: &Ray, sphere: &Sphere) -> Option<Parts> {
    let roots = sphere.roots(ray);
    let t = roots.iter().next()?;
    let normal = |point: DVec3| (point - sphere.center) / sphere.radius;
    let point = ray.at(t);
    let n = normal(point);
    let surface = Surface::Sphere(*sphere);
    let parts = vec![
        wanting(Asked::T, number(t), vec![Wanted::Meets(*ray, surface)]),
        wanting(Asked::Point, vector(point), vec![Wanted::On(surface), Wanted::OnRay(*ray)]),
        part(Asked::Normal, vector(n)),
    ];
    let mut wrongs: Vec<Wrong> = Vec::new();
    if let Roots::Two(_, far) = roots {
        let mut wrong = wrong_t(Slip::FarRoot, far, vector(ray.at(far)));
        wrong.answers.push((Asked::Normal, vector(normal(ray.at(far)))));
        wrongs.push(wrong);
        wrongs.push(wrong_t(Slip::SignOfB, -far, vector(ray.at(-far))));
    }
    let ts = wrong_roots(ray, sphere).into_iter().chain([
        (Slip::TForDistance, ray.distance_along(t)),
        (Slip::SignOfT, -t),
        (Slip::DividedBy2A, 0.5 * t),
        (Slip::DividedByA, 2.0 * t),
    ]);
    wrongs.extend(ts.map(|(slip, t)| wrong_t(slip, t, vector(ray.at(t)))));
    let of_normal = |(slip, n)| one(slip, Asked::Normal, vector(n));
    let normals = [
        (Slip::NormalInwards, -n),
        (Slip::NormalInwards, -sphere.radius * n),
        (Slip::Unnormalized, sphere.radius * n),
        (Slip::NormalAgainstRay, -ray.direction.normalize()),
        (Slip::NormalFromOrigin, point.normalize_or_zero()),
    ];
    wrongs.extend(normals.map(of_normal));
    Some((parts, wrongs))
}

/// Wrong solutions of `a t^2 + 2 b t + c = 0`; NaN where D is below 0.
fn wrong_roots(ray: &Ray, sphere: &Sphere) -> [(Slip, f64); 5] {
    let oc = ray.origin - sphere.center;
    let (a, b) = (ray.direction.length_squared(), ray.direction.dot(oc));
    let c = oc.length_squared() - sphere.radius * sphere.radius;
    let unsquared = oc.length_squared() - sphere.radius;
    [
        (Slip::BForHalfB, (-2.0 * b - (4.0 * b * b - a * c).sqrt()) / a),
        (Slip::HalfBForB, (-b - (b * b - 4.0 * a * c).sqrt()) / (2.0 * a)),
        (Slip::RadiusNotSquared, (-b - (b * b - a * unsquared).sqrt()) / a),
        (Slip::ALeftOut, -b - (b * b - c).sqrt()),
        (Slip::RootLeftOut, -b / a),
    ]
}

pub(super) fn lines(line: DVec3, origin: DVec2, direction: DVec2) -> Parts {
    let (normal, c) = (line.truncate(), line.z);
    let (gap, step) = (normal.dot(origin) + c, normal.dot(direction));
    let at = |t: f64| place(origin + t * direction);
    let t = -gap / step;
    let ray = Ray { origin: origin.extend(0.0), direction: direction.extend(0.0) };
    let surface = Surface::Line(line);
    let parts = vec![
        wanting(Asked::T, number(t), vec![Wanted::Meets(ray, surface)]),
        wanting(Asked::Point, at(t), vec![Wanted::On(surface), Wanted::OnRay(ray)]),
        part(Asked::Hits, Answer::Yes(t > 0.0)),
    ];
    let mut wrongs: Vec<Wrong> = [
        (Slip::SignOfT, -t),
        (Slip::CLeftOut, -normal.dot(origin) / step),
        (Slip::SignOfC, (c - normal.dot(origin)) / step),
        (Slip::OriginLeftOut, -c / step),
        (Slip::TInverted, 1.0 / t),
        (Slip::NotDivided, -gap),
        (Slip::TermLeftOut, -gap / (normal.x * direction.x)),
        (Slip::TermLeftOut, -gap / (normal.y * direction.y)),
        (Slip::PAndDSwapped, -(step + c) / normal.dot(origin)),
    ]
    .into_iter()
    .map(|(slip, t)| wrong_t(slip, t, at(t)))
    .collect();
    wrongs.push(one(Slip::OriginLeftOut, Asked::Point, place(t * direction)));
    wrongs.push(one(Slip::LineForRay, Asked::Hits, Answer::Yes(t <= 0.0)));
    (parts, wrongs)
}
