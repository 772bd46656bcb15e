//! Families of any rays against one plane.

use crate::families::draw::{Draw, Sizes, dot, plus, scaled};
use crate::families::{OFFSETS, RayCase, Row, TO_ROUNDING, ULPS};
use crate::object::Object;

pub(crate) const FAMILIES: [Row<RayCase>; 4] = [
    ("near-parallel-plane", "log10 of the angle, in radians", &TO_ROUNDING, near_parallel),
    ("parallel-plane", "normal, in ulps from parallel", &ULPS, parallel),
    ("plane-offset", "log10 of the offset", &OFFSETS, offset),
    ("plane-range", "log10 of the scale", &[-320.0, -300.0, -150.0, 150.0, 300.0, 307.0], range),
];

fn one_plane(point: [f64; 3], normal: [f64; 3], origin: [f64; 3], direction: [f64; 3]) -> RayCase {
    RayCase { objects: vec![Object::Plane { point, normal }], origin, direction }
}

/// Makes a case with a ray at a small angle to a plane: normal . direction nearly cancels.
fn near_parallel(draw: &mut Draw, k: f64) -> RayCase {
    let normal = draw.direction();
    let slope = draw.sign() * draw.decade(k) * draw.between(0.3, 3.0);
    let direction = plus(draw.across(normal), slope, normal);
    let length = draw.between(0.5, 3.0);
    let normal = scaled(normal, draw.between(0.5, 3.0));
    one_plane(draw.in_box(4.0), normal, draw.in_box(4.0), scaled(direction, length))
}

/// Makes a case with a ray exactly parallel to a plane, inside it or next to it, and normals one
/// ulp off.
fn parallel(draw: &mut Draw, ulps: f64) -> RayCase {
    let Sizes { quaternion, extent, steps } = draw.sizes();
    let ([along, mut normal, aside], _) = draw.whole_frame(quaternion);
    let point = [0; 3].map(|_| draw.whole(-extent, extent));
    let height = if draw.once_in(3) { 0.0 } else { draw.whole(-steps, steps) };
    let inside = plus(plus(point, draw.whole(-steps, steps), along), draw.whole(-3, 3), aside);
    let origin = plus(inside, height, normal);
    // A coordinate that counts in the product.
    if let Some(i) = (0..3).find(|&i| normal[i] * along[i] != 0.0) {
        normal[i] = draw.moved_by_ulps(normal[i], ulps);
    }
    one_plane(point, normal, origin, along).scaled(draw.binary_scale(), 1.0)
}

fn everyday(draw: &mut Draw) -> RayCase {
    let (point, origin, normal) = (draw.in_box(4.0), draw.in_box(8.0), draw.direction());
    // Nearly all rays go toward the plane.
    let toward = dot(normal, plus(point, -1.0, origin));
    let sense = if draw.once_in(8) { -toward } else { toward };
    let direction = draw.direction();
    let flip = if dot(direction, normal) * sense < 0.0 { -1.0 } else { 1.0 };
    let length = flip * draw.between(0.5, 2.0);
    one_plane(point, normal, origin, scaled(direction, length))
}

/// Makes a case with an everyday plane and ray, far from the world's origin.
fn offset(draw: &mut Draw, k: f64) -> RayCase {
    let RayCase { objects, origin, direction } = everyday(draw);
    let offset = scaled(draw.in_box(1.0), draw.decade(k));
    let moved = |point| plus(point, 1.0, offset);
    let objects = objects.into_iter().map(|plane| plane.map(moved, |normal| normal, |r| r));
    RayCase { objects: objects.collect(), origin: moved(origin), direction }
}

/// Makes a case with a normal, a direction or lengths that are so large or small that products
/// leave f64's range.
fn range(draw: &mut Draw, k: f64) -> RayCase {
    let RayCase { objects, origin, direction } = everyday(draw);
    let scale = draw.decade(k);
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
