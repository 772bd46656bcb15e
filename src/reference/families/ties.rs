//! Families of any rays that meet several objects at the same t.
//!
//! The cases consist of whole numbers: a contact point P, and three perpendicular whole vectors of
//! the same whole length n (see [`Draw::whole_frame`]). A sphere of radius k n around P + k N
//! touches P if N is one of the three vectors.

use crate::families::draw::{Draw, Sizes, cross, plus, scaled};
use crate::families::{RayCase, Row, ULPS};
use crate::object::Object;

pub(crate) const FAMILIES: [Row<RayCase>; 5] = [
    (
        "ties-concentric",
        "second radius, ulps from first",
        &[-1000.0, -1.0, 0.0, 1.0, 1000.0],
        concentric,
    ),
    ("ties-touching-inside", "second radius, in ulps from touching", &ULPS, touching_inside),
    ("ties-touching-outside", "second radius, in ulps from touching", &ULPS, touching_outside),
    ("ties-sphere-plane", "radius, in ulps from touching", &ULPS, sphere_plane),
    ("ties-planes", "second point, in ulps", &ULPS, planes),
];

/// A contact point and the vectors there, all whole.
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
    // No coordinate is 0: each of them has a neighbour.
    let point = [0; 3].map(|_| draw.sign() * draw.whole(1, extent));
    Contact { point, along, out, aside, length, steps }
}

impl Contact {
    /// Returns the sphere through the contact point whose centre is `radii` times the vector `out`
    /// away from the point.
    fn sphere(&self, draw: &Draw, radii: f64, ulps: f64) -> Object {
        let radius = draw.moved_by_ulps(radii.abs() * self.length, ulps);
        Object::Sphere { center: plus(self.point, radii, self.out), radius }
    }

    /// Draws a vector that points outward from the contact point.
    fn outward(&self, draw: &mut Draw) -> [f64; 3] {
        let (a, b) = (draw.whole(-4, 4), draw.whole(-4, 4));
        plus(plus(self.out, a, self.along), b, self.aside)
    }

    /// Draws a vector perpendicular to `out`.
    fn across(&self, draw: &mut Draw) -> [f64; 3] {
        let (a, b) = (draw.whole(-4, 4), draw.whole(1, 4));
        plus(scaled(self.along, a), b, self.aside)
    }
}

/// Returns the case with the objects in a random order (but spheres before planes), and all lengths
/// multiplied by a power of two.
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

/// Makes a case with two spheres with the same centre, coincident or one ulp apart: the first
/// listed wins.
fn concentric(draw: &mut Draw, ulps: f64) -> RayCase {
    let center = draw.in_box(4.0);
    let center = draw.given3(center);
    let radius = draw.between(0.5, 3.0);
    let radius = draw.given(radius);
    let other = draw.moved_by_ulps(radius, ulps);
    let origin = plus(center, draw.between(0.0, 5.0), draw.direction());
    let origin = draw.given3(origin);
    let direction = plus(plus(center, -1.0, origin), 0.7 * radius, draw.direction());
    let direction = draw.given3(direction);
    let [first, second] = [radius, other].map(|radius| Object::Sphere { center, radius });
    shuffled(draw, [first, second], origin, direction)
}

/// Makes a case with a sphere that touches another from inside, and a ray through the contact.
fn touching_inside(draw: &mut Draw, ulps: f64) -> RayCase {
    let contact = contact(draw);
    let [small, more] = [(); 2].map(|()| draw.whole(1, contact.steps / 2));
    let outer = contact.sphere(draw, -small - more, 0.0);
    let inner = contact.sphere(draw, -small, ulps);
    let outward = contact.outward(draw);
    let origin = plus(contact.point, draw.whole(1, contact.steps), outward);
    shuffled(draw, [outer, inner], origin, scaled(outward, -1.0))
}

/// Makes a case with spheres that touch from outside, and a ray through the contact from inside one
/// or along both.
fn touching_outside(draw: &mut Draw, ulps: f64) -> RayCase {
    let contact = contact(draw);
    let other = draw.whole(1, contact.steps);
    let (a, b) = (draw.whole(-2, 2), draw.whole(-2, 2));
    let beyond = contact.sphere(draw, other, ulps);
    let back = draw.whole(1, 8);
    if draw.once_in(3) {
        let radii = draw.whole(1, contact.steps);
        let around = contact.sphere(draw, -radii, 0.0);
        let across = contact.across(draw);
        return shuffled(draw, [around, beyond], plus(contact.point, -back, across), across);
    }
    // From D = out + a along + b aside back inside the sphere of k radii: | k out - j D | < k n holds
    // where j (1 + a^2 + b^2) < 2 k.
    let outward = plus(plus(contact.out, a, contact.along), b, contact.aside);
    let around = contact.sphere(draw, -back * (1.0 + a * a + b * b), 0.0);
    shuffled(draw, [around, beyond], plus(contact.point, -back, outward), outward)
}

/// Makes a case with a plane that touches a sphere, and a ray through the contact.
fn sphere_plane(draw: &mut Draw, ulps: f64) -> RayCase {
    let contact = contact(draw);
    let radii = draw.whole(1, contact.steps);
    let sphere = contact.sphere(draw, -radii, ulps);
    let point = plus(contact.point, draw.whole(-9, 9), contact.across(draw));
    let normal = scaled(contact.out, draw.sign() * draw.whole(1, 5));
    let outward = contact.outward(draw);
    let origin = plus(contact.point, draw.whole(1, contact.steps), outward);
    shuffled(draw, [sphere, Object::Plane { point, normal }], origin, scaled(outward, -1.0))
}

/// Makes a case with one plane given by two points and normals, or with planes that cross where the ray
/// goes.
fn planes(draw: &mut Draw, ulps: f64) -> RayCase {
    let contact = contact(draw);
    let first = Object::Plane { point: contact.point, normal: contact.out };
    let (normal, in_plane) = if draw.once_in(2) {
        (scaled(contact.out, draw.sign() * draw.whole(1, 7)), contact.across(draw))
    } else {
        let normal = draw.whole_vector(9);
        (normal, cross(normal, draw.whole_vector(9)))
    };
    let mut point = plus(contact.point, draw.whole(-9, 9), in_plane);
    // A coordinate that counts.
    if let Some(i) = (0..3).find(|&i| normal[i] * point[i] != 0.0) {
        point[i] = draw.moved_by_ulps(point[i], ulps);
    }
    let outward = contact.outward(draw);
    let origin = plus(contact.point, draw.whole(1, contact.steps), outward);
    shuffled(draw, [first, Object::Plane { point, normal }], origin, scaled(outward, -1.0))
}
