//! Pictures in which outlines touch pixel centres exactly, and objects coincide.

use crate::camera::{Camera, Orientation};
use crate::families::FrameCase;
use crate::families::draw::{Draw, cross, dot, plus, scaled};
use crate::object::Object;

/// Pixels from the middle to the edge, in a picture with a pixel in the middle.
const HALF: i64 = 12;

/// Distance of the viewport of a picture with pixels of size 1: many whole numbers divide it.
const DISTANCE: f64 = 12.0;

/// `[x, y, z]` in a frame of three vectors.
fn in_frame(frame: &[[f64; 3]; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    plus(plus(scaled(frame[0], x), y, frame[1]), z, frame[2])
}

/// A camera with pixels of one power of two in size, the first of them in the middle of the picture.
fn camera(draw: &mut Draw, eye: [f64; 3], orientation: Orientation, distance: f64) -> Camera {
    let pixel = draw.power_of_two(-10, 10);
    let side = 2 * HALF as u32 + 1;
    let extent = f64::from(side) * pixel;
    Camera {
        eye,
        orientation,
        width: extent,
        height: extent,
        distance: distance * pixel,
        columns: side,
        rows: side,
    }
}

/// Spheres whose outlines go exactly through pixel centres, and radii one ulp beside.
pub(crate) fn tangent(draw: &mut Draw, ulps: f64) -> FrameCase {
    let case = if draw.once_in(2) {
        by_rational_basis(draw, ulps)
    } else {
        by_irrational_basis(draw, ulps)
    };
    case.scaled(draw.power_of_two(-16, 16))
}

/// A camera whose basis is a whole frame divided by its length, so that all of its rays have rational
/// directions, and spheres that each touch the ray of a pixel.
fn by_rational_basis(draw: &mut Draw, ulps: f64) -> FrameCase {
    let (world, length) = draw.whole_frame(2);
    let eye = draw.whole_vector(100);
    let mut objects = Vec::new();
    while objects.len() < 3 {
        // In the camera's coordinates, in pixels.
        let ([along, out, _], size) = draw.whole_frame(2);
        let depth = along[2].abs();
        let reaches = |x: f64| x.abs() * DISTANCE / depth <= HALF as f64;
        if depth == 0.0 || DISTANCE % depth != 0.0 || !reaches(along[0]) || !reaches(along[1]) {
            continue;
        }
        let t = -along[2].signum() * draw.whole(1, 16);
        let radii = draw.sign() * draw.whole(1, 8);
        let center = plus(scaled(along, t), radii, out);
        let radius = draw.moved_by_ulps(radii.abs() * size * length, ulps);
        objects.push(Object::Sphere { center: plus(eye, 1.0, in_frame(&world, center)), radius });
    }
    let view = scaled(world[2], -draw.whole(1, 5));
    let up = plus(scaled(world[1], draw.whole(1, 5)), draw.whole(-3, 3), world[2]);
    let orientation = draw.aimed(eye, view, up);
    FrameCase { camera: camera(draw, eye, orientation, DISTANCE), objects }
}

/// A camera turned by 45 degrees out of a whole frame, so that its basis has the square root of 2 in
/// it. In the middle row the ray of column x is [`of_column`].
fn half_turned(draw: &mut Draw, world: &[[f64; 3]; 3], eye: [f64; 3]) -> Camera {
    let view = in_frame(world, scaled([-1.0, 0.0, -1.0], draw.whole(1, 5)));
    let up = plus(scaled(world[1], draw.whole(1, 5)), draw.whole(-3, 3), view);
    let orientation = draw.aimed(eye, view, up);
    camera(draw, eye, orientation, DISTANCE)
}

/// The direction of the ray of column x in the middle row of [`half_turned`], in the frame's
/// coordinates, but for a factor.
fn of_column(x: f64) -> [f64; 3] {
    [x - DISTANCE, 0.0, -x - DISTANCE]
}

/// Spheres that touch rays of the middle row from above and below.
fn by_irrational_basis(draw: &mut Draw, ulps: f64) -> FrameCase {
    let (world, length) = draw.whole_frame(2);
    let eye = draw.whole_vector(100);
    let mut objects = Vec::new();
    for _ in 0..3 {
        let along = scaled(of_column(draw.whole(-HALF, HALF)), draw.whole(1, 8));
        let radii = draw.sign() * draw.whole(1, 40);
        let center = plus(along, radii, [0.0, 1.0, 0.0]);
        let radius = draw.moved_by_ulps(radii.abs() * length, ulps);
        objects.push(Object::Sphere { center: plus(eye, 1.0, in_frame(&world, center)), radius });
    }
    FrameCase { camera: half_turned(draw, &world, eye), objects }
}

/// Two spheres, one inside the other, and a plane that all touch in the point where the ray of a pixel
/// of [`half_turned`] enters them.
pub(crate) fn touching(draw: &mut Draw, ulps: f64) -> FrameCase {
    let (world, length) = draw.whole_frame(2);
    let eye = draw.whole_vector(100);
    let along = of_column(draw.whole(-HALF, HALF));
    // Toward the eye.
    let (out, size) = loop {
        let ([out, ..], size) = draw.whole_frame(2);
        if dot(out, along) != 0.0 {
            break (scaled(out, -dot(out, along).signum()), size);
        }
    };
    let contact = scaled(along, draw.whole(1, 8));
    let small = draw.whole(1, 6);
    let sphere = |radii: f64, ulps| {
        let center = plus(eye, 1.0, in_frame(&world, plus(contact, -radii, out)));
        Object::Sphere { center, radius: draw.moved_by_ulps(radii * size * length, ulps) }
    };
    let inner = sphere(small, ulps);
    let outer = sphere(2.0 * small + 1.0, 0.0);
    let point = plus(eye, 1.0, in_frame(&world, contact));
    let plane = Object::Plane { point, normal: in_frame(&world, out) };
    let objects =
        if draw.once_in(2) { vec![inner, outer, plane] } else { vec![outer, inner, plane] };
    let camera = half_turned(draw, &world, eye);
    FrameCase { camera, objects }.scaled(draw.power_of_two(-16, 16))
}

/// Coincident spheres and coincident planes: in each pixel the first listed wins.
pub(crate) fn ties(draw: &mut Draw, ulps: f64) -> FrameCase {
    let center = draw.whole_vector(20);
    let radius = draw.whole(4, 12);
    let second = draw.moved_by_ulps(radius, ulps);
    let (point, normal) = (plus(center, 1.0, draw.whole_vector(6)), draw.whole_vector(9));
    let in_plane = cross(normal, draw.whole_vector(9));
    let other_point = plus(point, draw.whole(-3, 3), in_plane);
    let other_normal = scaled(normal, draw.sign() * draw.whole(1, 7));
    let eye = plus(center, draw.between(1.5, 3.0) * radius, draw.direction());
    let eye = draw.given3(eye);
    let up = draw.direction();
    let orientation = Orientation::At { at: center, up };
    let half = draw.whole(6, HALF) as u32;
    let camera = Camera { columns: 2 * half, rows: half, ..camera(draw, eye, orientation, 30.0) };
    let objects = vec![
        Object::Sphere { center, radius },
        Object::Sphere { center, radius: second },
        Object::Plane { point, normal },
        Object::Plane { point: other_point, normal: other_normal },
    ];
    FrameCase { camera, objects }
}
