//! The questions about what a ray meets: a sphere, and in two dimensions a line.

use pinhole_core::{DVec2, DVec3, Ray, Roots, Sphere};

use super::judge::{Condition, Surface};
use super::question::{Answer, Asked};
use super::solve::{Parts, Wrong, number, one_wrong, pair, part, part_with, vector, wrong_t};
use crate::mistakes::Mistake;

/// The parts of a question about a ray and a sphere; `None` where the ray's line misses it.
pub(super) fn sphere(ray: &Ray, sphere: &Sphere) -> Option<Parts> {
    let roots = sphere.roots(ray);
    let t = roots.iter().next()?;
    let normal = |point: DVec3| (point - sphere.center) / sphere.radius;
    let point = ray.at(t);
    let n = normal(point);
    let surface = Surface::Sphere(*sphere);
    let parts = vec![
        part_with(Asked::T, number(t), vec![Condition::Meets(*ray, surface)]),
        part_with(
            Asked::Point,
            vector(point),
            vec![Condition::On(surface), Condition::OnRay(*ray)],
        ),
        part(Asked::Normal, vector(n)),
    ];
    let mut wrongs: Vec<Wrong> = Vec::new();
    if let Roots::Two(_, far) = roots {
        let mut wrong = wrong_t(Mistake::FarRoot, far, vector(ray.at(far)));
        wrong.answers.push((Asked::Normal, vector(normal(ray.at(far)))));
        wrongs.push(wrong);
    }
    let ts = wrong_roots(ray, sphere)
        .into_iter()
        .chain([(Mistake::TForDistance, ray.distance_along(t)), (Mistake::SignOfT, -t)]);
    wrongs.extend(ts.map(|(mistake, t)| wrong_t(mistake, t, vector(ray.at(t)))));
    let of_normal = |(mistake, n)| one_wrong(mistake, Asked::Normal, vector(n));
    let normals = [
        (Mistake::NormalInwards, -n),
        (Mistake::NormalInwards, -sphere.radius * n),
        (Mistake::Unnormalized, sphere.radius * n),
        (Mistake::NormalAgainstRay, -ray.direction.normalize()),
        (Mistake::NormalFromOrigin, point.normalize_or_zero()),
    ];
    wrongs.extend(normals.map(of_normal));
    Some((parts, wrongs))
}

/// Wrong solutions of `a t^2 + 2 b t + c = 0`; NaN where D is below 0.
fn wrong_roots(ray: &Ray, sphere: &Sphere) -> [(Mistake, f64); 8] {
    let oc = ray.origin - sphere.center;
    let (a, b) = (ray.direction.length_squared(), ray.direction.dot(oc));
    let c = oc.length_squared() - sphere.radius * sphere.radius;
    let unsquared = oc.length_squared() - sphere.radius;
    let by_formula = |mistake: Mistake| {
        let quadratic = mistake.usual().quadratic;
        let roots = quadratic.roots(quadratic.a(a), b, c);
        (mistake, roots.map_or(f64::NAN, |[near, _]| near))
    };
    [
        by_formula(Mistake::SignOfB),
        by_formula(Mistake::BForHalfB),
        by_formula(Mistake::HalfBForB),
        (Mistake::RadiusNotSquared, (-b - (b * b - a * unsquared).sqrt()) / a),
        by_formula(Mistake::ALeftOut),
        (Mistake::RootLeftOut, -b / a),
        by_formula(Mistake::DividedBy2A),
        by_formula(Mistake::DividedByA),
    ]
}

pub(super) fn lines(line: DVec3, origin: DVec2, direction: DVec2) -> Parts {
    let (normal, c) = (line.truncate(), line.z);
    let (gap, step) = (normal.dot(origin) + c, normal.dot(direction));
    let at = |t: f64| pair(origin + t * direction);
    let t = -gap / step;
    let ray = Ray { origin: origin.extend(0.0), direction: direction.extend(0.0) };
    let surface = Surface::Line(line);
    let parts = vec![
        part_with(Asked::T, number(t), vec![Condition::Meets(ray, surface)]),
        part_with(Asked::Point, at(t), vec![Condition::On(surface), Condition::OnRay(ray)]),
        part(Asked::Hits, Answer::Yes(t > 0.0)),
    ];
    let mut wrongs: Vec<Wrong> = [
        (Mistake::SignOfT, -t),
        (Mistake::CLeftOut, -normal.dot(origin) / step),
        (Mistake::SignOfC, (c - normal.dot(origin)) / step),
        (Mistake::OriginLeftOut, -c / step),
        (Mistake::TInverted, 1.0 / t),
        (Mistake::NotDivided, -gap),
        (Mistake::TermLeftOut, -gap / (normal.x * direction.x)),
        (Mistake::TermLeftOut, -gap / (normal.y * direction.y)),
        (Mistake::PAndDSwapped, -(step + c) / normal.dot(origin)),
    ]
    .into_iter()
    .map(|(mistake, t)| wrong_t(mistake, t, at(t)))
    .collect();
    wrongs.push(one_wrong(Mistake::OriginLeftOut, Asked::Point, pair(t * direction)));
    wrongs.push(one_wrong(Mistake::LineForRay, Asked::Hits, Answer::Yes(t <= 0.0)));
    (parts, wrongs)
}
