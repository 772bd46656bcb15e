//! Families of difficult cases that are single rays: against one sphere, several objects, or one plane;
//! and with two objects that the ray meets at the same t, or nearly so.
//!
//! The last kind of case is built from integers: a point of contact P, and three perpendicular integer
//! vectors of the same integer length n (see [`Draw::whole_frame`]). If N is one of these vectors, and
//! k an integer, a sphere of radius k n around P + k N passes exactly through P, without rounding.

use crate::families::draw::{Draw, Sizes, cross, decade, dot, moved_by_ulps, plus, scaled};
use crate::families::{FamilyRow, OFFSETS, PLANETS, RayCase, SMALL, TO_ROUNDING, ULPS};
use crate::object::Object;

pub(crate) const FAMILIES: [FamilyRow; 23] = [
    ("ordinary", "distance from centre / radius", &[0.0, 0.5, 0.9, 0.99, 1.01, 2.0], everyday),
    ("course-floor", "slope (0.02 touches)", &[0.019, 0.0201, 0.03, 0.1, 0.3, 1.0], course_floor),
    ("several", "number of objects", &[2.0, 5.0, 20.0], several),
    ("tiny-far", "log10 of radius / distance", &SMALL, tiny_far),
    ("planet", "log10 of the radius", &PLANETS, planet),
    ("grazing", "log10 of the gap to the outline / radius", &TO_ROUNDING, grazing),
    ("tangent", "radius, in ulps from tangent", &ULPS, tangent),
    ("eye-near-surface", "log10 of height / radius", &TO_ROUNDING, eye_near_surface),
    ("eye-on-surface", "radius, in ulps from the eye", &ULPS, eye_on_surface),
    ("eye-inside", "distance from centre / radius", &[0.0, 1e-9, 0.1, 0.5, 0.9, 0.999], eye_inside),
    (
        "direction-length",
        "log10 of the direction's length",
        &[-20.0, -10.0, -5.0, 0.0, 5.0, 10.0, 20.0],
        direction_length,
    ),
    ("world-offset", "log10 of the offset", &OFFSETS, world_offset),
    (
        "extreme-range",
        "log10 of the scale",
        &[-320.0, -300.0, -150.0, -100.0, 100.0, 150.0, 300.0, 307.0],
        extreme_range,
    ),
    ("mixed-range", "log10 of the largest size", &[10.0, 30.0, 100.0, 300.0], mixed_range),
    ("near-parallel-plane", "log10 of the angle, in radians", &TO_ROUNDING, near_parallel_plane),
    ("parallel-plane", "normal, in ulps from parallel", &ULPS, parallel_plane),
    ("plane-offset", "log10 of the offset", &OFFSETS, plane_offset),
    (
        "plane-range",
        "log10 of the scale",
        &[-320.0, -300.0, -150.0, 150.0, 300.0, 307.0],
        plane_range,
    ),
    (
        "ties-concentric",
        "second radius, ulps from first",
        &[-1000.0, -1.0, 0.0, 1.0, 1000.0],
        concentric,
    ),
    ("ties-touching-inside", "second radius, in ulps from touching", &ULPS, touching_inside),
    ("ties-touching-outside", "second radius, in ulps from touching", &ULPS, touching_outside),
    ("ties-sphere-plane", "radius, in ulps from touching", &ULPS, sphere_plane),
    ("ties-planes", "second point, in ulps", &ULPS, coincident_planes),
];

fn one_sphere(center: [f64; 3], radius: f64, origin: [f64; 3], direction: [f64; 3]) -> RayCase {
    RayCase { objects: vec![Object::Sphere { center, radius }], origin, direction }
}

/// Returns the direction of a line from `origin` that passes `center` at the distance `by`, which must
/// be less than the distance from `origin` to `center`.
fn past(draw: &mut Draw, origin: [f64; 3], center: [f64; 3], by: f64) -> [f64; 3] {
    let to = plus(center, -1.0, origin);
    let square = dot(to, to);
    let aside = by / (1.0 - by * by / square).sqrt();
    plus(to, aside, draw.across(to))
}

/// Makes a case with a sphere of ordinary size, and an origin 2.5 to 8 radii away from its centre. The
/// line passes the centre at the distance `impact`, in radii.
fn everyday(draw: &mut Draw, impact: f64) -> RayCase {
    let radius = draw.between(0.25, 1.0);
    let center = draw.in_box(4.0);
    let away = draw.between(2.5, 8.0);
    let origin = plus(center, radius * away, draw.direction());
    let direction = past(draw, origin, center, impact * radius);
    let length = draw.between(0.05, 0.5);
    one_sphere(center, radius, origin, scaled(direction, length))
}

fn any_impact(draw: &mut Draw) -> RayCase {
    let impact = draw.between(0.0, 1.2);
    everyday(draw, impact)
}

/// Makes a case with the floor that ray tracing courses use, a sphere of radius 5000 around (0, -5001,
/// 0), seen from the origin along a ray with this downward slope.
fn course_floor(draw: &mut Draw, slope: f64) -> RayCase {
    let level = draw.across([0.0, 1.0, 0.0]);
    let direction = plus(level, -slope, [0.0, 1.0, 0.0]);
    let length = draw.between(0.5, 2.0);
    one_sphere([0.0, -5001.0, 0.0], 5000.0, [0.0; 3], scaled(direction, length))
}

/// Makes a case with `count` spheres and planes of ordinary size.
fn several(draw: &mut Draw, count: f64) -> RayCase {
    let planes = draw.whole(0, (count as i64 + 2) / 4);
    let spheres = (count - planes) as usize;
    let mut objects: Vec<Object> = (0..spheres)
        .map(|_| Object::Sphere { center: draw.in_box(5.0), radius: draw.between(0.2, 2.0) })
        .collect();
    objects.extend(
        (0..planes as usize)
            .map(|_| Object::Plane { point: draw.in_box(8.0), normal: draw.in_box(3.0) }),
    );
    let (origin, toward) = (draw.in_box(8.0), draw.in_box(4.0));
    RayCase { objects, origin, direction: plus(toward, -1.0, origin) }
}

/// Makes a case with a sphere that is tiny compared with its distance, so that the two terms of the
/// discriminant b^2 - a c nearly cancel.
fn tiny_far(draw: &mut Draw, k: f64) -> RayCase {
    let origin = draw.in_box(10.0);
    let distance = draw.between(1.0, 100.0);
    let center = plus(origin, distance, draw.direction());
    let radius = distance * decade(k);
    // Occasionally, use the exact line from 0 through the centre.
    if draw.once_in(8) {
        return one_sphere(center, radius, [0.0; 3], scaled(center, draw.power_of_two(-8, 8)));
    }
    let impact = draw.between(0.0, 1.2);
    let direction = past(draw, origin, center, impact * radius);
    let length = draw.between(0.01, 1.0);
    one_sphere(center, radius, origin, scaled(direction, length))
}

/// Makes a case with the eye a little above a huge sphere, so that the squares in c = |origin -
/// center|^2 - radius^2 nearly cancel.
fn planet(draw: &mut Draw, k: f64) -> RayCase {
    let radius = decade(k) * draw.between(1.0, 2.0);
    let height = draw.of_any_size(1e-3, 10.0);
    let origin = draw.in_box(3.0);
    let down = draw.direction();
    let center = plus(origin, radius + height, down);
    // The horizon is sqrt(2 height / radius) below the horizontal.
    let slope = if draw.once_in(3) {
        draw.between(0.0, 5.0)
    } else {
        (2.0 * height / radius).sqrt() * draw.between(0.9, 2.0)
    };
    let direction = plus(draw.across(down), slope, down);
    one_sphere(center, radius, origin, direction)
}

/// Makes a case with a line that passes close to the sphere's outline, inside or outside.
fn grazing(draw: &mut Draw, k: f64) -> RayCase {
    let impact = 1.0 + draw.sign() * decade(k);
    everyday(draw, impact)
}

/// Makes a case with a line that touches the sphere exactly. The radius is then changed by `ulps` units
/// in the last place.
fn tangent(draw: &mut Draw, ulps: f64) -> RayCase {
    let Sizes { quaternion, extent, steps } = draw.sizes();
    let ([along, out, _], length) = draw.whole_frame(quaternion);
    let touched = [0; 3].map(|_| draw.whole(-extent, extent));
    let (back, radii) = (draw.whole(1, steps), draw.whole(1, steps));
    let radius = moved_by_ulps(radii * length, ulps);
    let scale = draw.binary_scale();
    let stretch = draw.power_of_two(-8, 8);
    one_sphere(plus(touched, radii, out), radius, plus(touched, -back, along), along)
        .scaled(scale, stretch)
}

/// Makes a case with the ray's origin just outside or inside the sphere, so that it is hard to decide
/// whether the near root is ahead of the origin or behind it.
fn eye_near_surface(draw: &mut Draw, k: f64) -> RayCase {
    let radius = draw.between(0.5, 4.0);
    let center = draw.in_box(4.0);
    let height = draw.sign() * decade(k);
    let origin = plus(center, radius * (1.0 + height), draw.direction());
    one_sphere(center, radius, origin, draw.in_box(1.0))
}

/// Makes a case with the ray's origin exactly on the sphere, where t = 0 is not a hit. The radius is
/// then changed by `ulps` units in the last place.
fn eye_on_surface(draw: &mut Draw, ulps: f64) -> RayCase {
    let Sizes { quaternion, extent, steps } = draw.sizes();
    let ([along, out, aside], length) = draw.whole_frame(quaternion);
    let origin = [0; 3].map(|_| draw.whole(-extent, extent));
    let radii = draw.whole(1, steps);
    let radius = moved_by_ulps(radii * length, ulps);
    let direction = match draw.whole(0, 3) as i64 {
        0 => along,
        1 => out,
        2 => plus(cross([1.0, 2.0, 3.0], out), draw.whole(-3, 3), aside),
        _ => draw.whole_vector(9),
    };
    let direction = if direction == [0.0; 3] { out } else { direction };
    one_sphere(plus(origin, radii, out), radius, origin, direction).scaled(draw.binary_scale(), 1.0)
}

/// Makes a case with the ray's origin inside the sphere or at its centre, so that the far root is the
/// hit.
fn eye_inside(draw: &mut Draw, share: f64) -> RayCase {
    let radius = draw.of_any_size(0.01, 100.0);
    let center = draw.in_box(4.0);
    let origin = plus(center, radius * share, draw.direction());
    one_sphere(center, radius, origin, draw.direction())
}

/// Makes a case with an ordinary sphere and a direction whose length is far from 1.
fn direction_length(draw: &mut Draw, k: f64) -> RayCase {
    let case = any_impact(draw);
    let length = dot(case.direction, case.direction).sqrt();
    let scale = decade(k) / length;
    RayCase { direction: scaled(case.direction, scale), ..case }
}

/// Makes a case with an ordinary sphere and ray, far from the world's origin.
fn world_offset(draw: &mut Draw, k: f64) -> RayCase {
    let mut case = any_impact(draw);
    let offset = scaled(draw.in_box(1.0), decade(k));
    for object in &mut case.objects {
        if let Object::Sphere { center, .. } = object {
            *center = plus(*center, 1.0, offset);
        }
    }
    // Aim again, because rounding of the sum may have moved the sphere by more than its size.
    let Some(Object::Sphere { center, radius }) = case.objects.first().copied() else {
        return case;
    };
    let origin = plus(case.origin, 1.0, offset);
    let to = plus(center, -1.0, origin);
    if dot(to, to) > 2.0 * radius * radius {
        let impact = draw.between(0.0, 1.2);
        let length = draw.between(0.05, 0.5);
        case.direction = scaled(past(draw, origin, center, impact * radius), length);
    }
    RayCase { origin, ..case }
}

/// Makes a case in which the lengths, the direction, or both are so large or small that their squares
/// overflow or underflow in `f64`.
fn extreme_range(draw: &mut Draw, k: f64) -> RayCase {
    let case = any_impact(draw);
    let (scale, inverse) = (decade(k), decade(-k.clamp(-300.0, 300.0)));
    let (lengths, direction) = match draw.whole(0, 3) as i64 {
        0 => (scale, 1.0),
        1 => (1.0, scale),
        2 => (scale, scale),
        _ => (scale, inverse),
    };
    case.scaled(lengths, direction)
}

/// Makes a case whose origin, centre, radius and direction have independent orders of magnitude.
fn mixed_range(draw: &mut Draw, k: f64) -> RayCase {
    let (large, small) = (decade(k), decade(-k));
    let mut size = || draw.of_any_size(small.sqrt(), large.sqrt());
    let sizes = [size(), size(), size(), size()];
    // These are square roots of the sizes, so that a ratio above f64's largest number is never formed.
    let [origin, center, radius, direction] = sizes.map(|x| x * x);
    let origin = scaled(draw.direction(), origin);
    let center = scaled(draw.direction(), center);
    let direction = if draw.once_in(2) {
        scaled(draw.direction(), direction)
    } else {
        plus(center, -1.0, origin)
    };
    one_sphere(center, radius, origin, direction)
}

fn one_plane(point: [f64; 3], normal: [f64; 3], origin: [f64; 3], direction: [f64; 3]) -> RayCase {
    RayCase { objects: vec![Object::Plane { point, normal }], origin, direction }
}

/// Makes a case with a ray at a small angle to a plane, so that the terms of the dot product of normal
/// and direction nearly cancel.
fn near_parallel_plane(draw: &mut Draw, k: f64) -> RayCase {
    let normal = draw.direction();
    let slope = draw.sign() * decade(k) * draw.between(0.3, 3.0);
    let direction = plus(draw.across(normal), slope, normal);
    let length = draw.between(0.5, 3.0);
    let normal = scaled(normal, draw.between(0.5, 3.0));
    one_plane(draw.in_box(4.0), normal, draw.in_box(4.0), scaled(direction, length))
}

/// Makes a case with a ray that is exactly parallel to a plane, in it or at some distance. A coordinate
/// of the normal is then changed by `ulps` units in the last place.
fn parallel_plane(draw: &mut Draw, ulps: f64) -> RayCase {
    let Sizes { quaternion, extent, steps } = draw.sizes();
    let ([along, mut normal, aside], _) = draw.whole_frame(quaternion);
    let point = [0; 3].map(|_| draw.whole(-extent, extent));
    let height = if draw.once_in(3) { 0.0 } else { draw.whole(-steps, steps) };
    let inside = plus(plus(point, draw.whole(-steps, steps), along), draw.whole(-3, 3), aside);
    let origin = plus(inside, height, normal);
    // Change a coordinate that contributes to the product.
    if let Some(i) = (0..3).find(|&i| normal[i] * along[i] != 0.0) {
        normal[i] = moved_by_ulps(normal[i], ulps);
    }
    one_plane(point, normal, origin, along).scaled(draw.binary_scale(), 1.0)
}

fn everyday_plane(draw: &mut Draw) -> RayCase {
    let (point, origin, normal) = (draw.in_box(4.0), draw.in_box(8.0), draw.direction());
    // Make nearly all rays point towards the plane.
    let toward = dot(normal, plus(point, -1.0, origin));
    let sense = if draw.once_in(8) { -toward } else { toward };
    let direction = draw.direction();
    let flip = if dot(direction, normal) * sense < 0.0 { -1.0 } else { 1.0 };
    let length = flip * draw.between(0.5, 2.0);
    one_plane(point, normal, origin, scaled(direction, length))
}

/// Makes a case with an ordinary plane and ray, far from the world's origin.
fn plane_offset(draw: &mut Draw, k: f64) -> RayCase {
    let RayCase { objects, origin, direction } = everyday_plane(draw);
    let offset = scaled(draw.in_box(1.0), decade(k));
    let moved = |point| plus(point, 1.0, offset);
    let objects = objects.into_iter().map(|plane| plane.map(moved, |normal| normal, |r| r));
    RayCase { objects: objects.collect(), origin: moved(origin), direction }
}

/// Makes a case with a plane, in which the normal, the direction or the lengths are so large or small
/// that products overflow or underflow in `f64`.
fn plane_range(draw: &mut Draw, k: f64) -> RayCase {
    let RayCase { objects, origin, direction } = everyday_plane(draw);
    let scale = decade(k);
    let factor = |draw: &mut Draw| if draw.once_in(2) { scale } else { 1.0 };
    let (lengths, normals, directions) = (factor(draw), factor(draw), factor(draw));
    let length = |point| scaled(point, lengths);
    let objects = objects.into_iter().map(|o| o.map(length, |n| scaled(n, normals), |r| r));
    RayCase {
        objects: objects.collect(),
        origin: length(origin),
        direction: scaled(direction, directions),
    }
}

/// A point where two objects touch, and three perpendicular vectors of equal length there, all with
/// integer coordinates.
struct Contact {
    point: [f64; 3],
    along: [f64; 3],
    out: [f64; 3],
    aside: [f64; 3],
    length: f64,
    steps: i64,
}

fn contact(draw: &mut Draw) -> Contact {
    let Sizes { quaternion, extent, steps } = draw.sizes();
    let ([along, out, aside], length) = draw.whole_frame(quaternion);
    // No coordinate is 0, so that each of them can be changed by an ulp.
    let point = [0; 3].map(|_| draw.sign() * draw.whole(1, extent));
    Contact { point, along, out, aside, length, steps }
}

impl Contact {
    /// Returns the sphere that passes through the contact point and has its centre at `point + radii *
    /// out`. Its radius is then changed by `ulps` units in the last place.
    fn sphere(&self, radii: f64, ulps: f64) -> Object {
        let radius = moved_by_ulps(radii.abs() * self.length, ulps);
        Object::Sphere { center: plus(self.point, radii, self.out), radius }
    }

    /// Returns a random vector on the side of the contact point to which `out` points.
    fn outward(&self, draw: &mut Draw) -> [f64; 3] {
        let (a, b) = (draw.whole(-4, 4), draw.whole(-4, 4));
        plus(plus(self.out, a, self.along), b, self.aside)
    }

    /// Returns a random vector that is perpendicular to `out`.
    fn across(&self, draw: &mut Draw) -> [f64; 3] {
        let (a, b) = (draw.whole(-4, 4), draw.whole(1, 4));
        plus(scaled(self.along, a), b, self.aside)
    }
}

/// Returns a case of these two objects and this ray. The objects are in random order, but spheres come
/// before planes. All lengths, and the direction's length once more, are multiplied by random powers of
/// two.
fn shuffled(
    draw: &mut Draw,
    objects: [Object; 2],
    origin: [f64; 3],
    direction: [f64; 3],
) -> RayCase {
    let [first, second] = objects;
    let same_kind =
        matches!(first, Object::Sphere { .. }) == matches!(second, Object::Sphere { .. });
    let objects = if same_kind && draw.once_in(2) { [second, first] } else { [first, second] };
    let scale = draw.binary_scale();
    let stretch = draw.power_of_two(-8, 8);
    RayCase { objects: objects.to_vec(), origin, direction }.scaled(scale, stretch)
}

/// Makes a case with two concentric spheres whose radii are equal or differ by `ulps` units in the last
/// place. Of two equal spheres, the one listed first is hit.
fn concentric(draw: &mut Draw, ulps: f64) -> RayCase {
    let center = draw.in_box(4.0);
    let radius = draw.between(0.5, 3.0);
    let other = moved_by_ulps(radius, ulps);
    let origin = plus(center, draw.between(0.0, 5.0), draw.direction());
    let direction = plus(plus(center, -1.0, origin), 0.7 * radius, draw.direction());
    let [first, second] = [radius, other].map(|radius| Object::Sphere { center, radius });
    shuffled(draw, [first, second], origin, direction)
}

/// Makes a case with a sphere that touches another one from inside, and a ray through the contact
/// point.
fn touching_inside(draw: &mut Draw, ulps: f64) -> RayCase {
    let contact = contact(draw);
    let [small, more] = [(); 2].map(|()| draw.whole(1, contact.steps / 2));
    let outer = contact.sphere(-small - more, 0.0);
    let inner = contact.sphere(-small, ulps);
    let outward = contact.outward(draw);
    let origin = plus(contact.point, draw.whole(1, contact.steps), outward);
    shuffled(draw, [outer, inner], origin, scaled(outward, -1.0))
}

/// Makes a case with two spheres that touch from outside, so that each lies outside the other. The ray
/// passes through the contact point, either from inside one of the spheres or tangentially to both.
fn touching_outside(draw: &mut Draw, ulps: f64) -> RayCase {
    let contact = contact(draw);
    let other = draw.whole(1, contact.steps);
    let (a, b) = (draw.whole(-2, 2), draw.whole(-2, 2));
    let beyond = contact.sphere(other, ulps);
    let back = draw.whole(1, 8);
    if draw.once_in(3) {
        let radii = draw.whole(1, contact.steps);
        let around = contact.sphere(-radii, 0.0);
        let across = contact.across(draw);
        return shuffled(draw, [around, beyond], plus(contact.point, -back, across), across);
    }
    // From D = out + a along + b aside back into the sphere of k radii: | k out - j D | < k n holds if
    // j (1 + a^2 + b^2) < 2 k.
    let outward = plus(plus(contact.out, a, contact.along), b, contact.aside);
    let around = contact.sphere(-back * (1.0 + a * a + b * b), 0.0);
    shuffled(draw, [around, beyond], plus(contact.point, -back, outward), outward)
}

/// Makes a case with a plane that touches a sphere, and a ray through the contact point.
fn sphere_plane(draw: &mut Draw, ulps: f64) -> RayCase {
    let contact = contact(draw);
    let radii = draw.whole(1, contact.steps);
    let sphere = contact.sphere(-radii, ulps);
    let point = plus(contact.point, draw.whole(-9, 9), contact.across(draw));
    let normal = scaled(contact.out, draw.sign() * draw.whole(1, 5));
    let outward = contact.outward(draw);
    let origin = plus(contact.point, draw.whole(1, contact.steps), outward);
    shuffled(draw, [sphere, Object::Plane { point, normal }], origin, scaled(outward, -1.0))
}

/// Makes a case with two planes, which are either the same plane, given by different points and
/// normals, or intersect in a line that the ray meets.
fn coincident_planes(draw: &mut Draw, ulps: f64) -> RayCase {
    let contact = contact(draw);
    let first = Object::Plane { point: contact.point, normal: contact.out };
    let (normal, in_plane) = if draw.once_in(2) {
        (scaled(contact.out, draw.sign() * draw.whole(1, 7)), contact.across(draw))
    } else {
        let normal = draw.whole_vector(9);
        (normal, cross(normal, draw.whole_vector(9)))
    };
    let mut point = plus(contact.point, draw.whole(-9, 9), in_plane);
    // Change a coordinate that contributes to the plane's position.
    if let Some(i) = (0..3).find(|&i| normal[i] * point[i] != 0.0) {
        point[i] = moved_by_ulps(point[i], ulps);
    }
    let outward = contact.outward(draw);
    let origin = plus(contact.point, draw.whole(1, contact.steps), outward);
    shuffled(draw, [first, Object::Plane { point, normal }], origin, scaled(outward, -1.0))
}
