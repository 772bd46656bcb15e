//! Families of difficult cases that are whole pictures, like those of rays in
//! `pinhole_reference::Family`. In some of them, outlines of spheres pass exactly through pixel
//! centres, or objects coincide.

use pinhole_reference::{Camera, Draw, Object, Orientation, decade, moved_by_ulps};

/// A whole picture.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FrameCase {
    /// The camera, with a small image.
    pub(crate) camera: Camera,
    /// Spheres first, then planes.
    pub(crate) objects: Vec<Object>,
}

/// Pictures that are difficult for the same reason, with a parameter, the knob, that sets how difficult
/// they are.
pub(crate) struct FrameFamily {
    /// Its name, in kebab-case.
    pub(crate) name: &'static str,
    /// The knob's values, in ascending order.
    pub(crate) knobs: &'static [f64],
    make: fn(&mut Draw, f64) -> FrameCase,
}

impl FrameFamily {
    /// Returns the family with this name.
    pub(crate) fn named(name: &str) -> &'static FrameFamily {
        FAMILIES.iter().find(|family| family.name == name).expect("a family")
    }

    /// Returns `count` cases for one value of the knob.
    pub(crate) fn cases(&self, knob: f64, seed: u64, count: usize) -> Vec<FrameCase> {
        let case = |mut draw: Draw| (self.make)(&mut draw, knob);
        Draw::cases(seed, self.name, knob, count).map(case).collect()
    }
}

impl FrameCase {
    /// Returns the case with its points and radii mapped by these functions.
    fn map(
        self,
        map_point: impl Fn([f64; 3]) -> [f64; 3],
        radius: impl Fn(f64) -> f64,
    ) -> FrameCase {
        let orientation = match self.camera.orientation {
            Orientation::At { at, up } => Orientation::At { at: map_point(at), up },
            other => other,
        };
        let camera = Camera { eye: map_point(self.camera.eye), orientation, ..self.camera };
        let objects =
            self.objects.into_iter().map(|object| object.map(&map_point, |normal| normal, &radius));
        FrameCase { camera, objects: objects.collect() }
    }

    /// Returns the case with all lengths of the world multiplied by `scale`, but not those of the
    /// viewport. Only t changes.
    fn scaled(self, scale: f64) -> FrameCase {
        self.map(|v| scaled(v, scale), |radius| radius * scale)
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn scaled(a: [f64; 3], s: f64) -> [f64; 3] {
    a.map(|x| x * s)
}

/// Returns `a + s b`.
fn plus(a: [f64; 3], s: f64, b: [f64; 3]) -> [f64; 3] {
    [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]]
}

const ULPS: [f64; 3] = [-1.0, 0.0, 1.0];
const TO_ROUNDING: [f64; 8] = [-16.0, -14.0, -12.0, -10.0, -8.0, -6.0, -3.0, -1.0];

/// All families of pictures.
pub(crate) const FAMILIES: [FrameFamily; 12] = [
    // The knob: number of objects.
    FrameFamily { name: "frame-ordinary", knobs: &[1.0, 3.0, 8.0], make: everyday },
    // The knob: radius, in ulps from tangent.
    FrameFamily { name: "frame-tangent", knobs: &ULPS, make: tangent },
    // The knob: second radius, ulps from first.
    FrameFamily { name: "frame-ties", knobs: &ULPS, make: ties },
    // The knob: inner radius, in ulps from touching.
    FrameFamily { name: "frame-touching", knobs: &ULPS, make: touching },
    // The knob: log10 of the radius.
    FrameFamily { name: "frame-planet", knobs: &[3.0, 4.0, 5.0, 6.0, 7.0, 8.0], make: planet },
    // The knob: log10 of radius / distance.
    FrameFamily {
        name: "frame-tiny-far",
        knobs: &[-12.0, -10.0, -8.0, -6.0, -3.0, -1.0],
        make: tiny_far,
    },
    // The knob: log10 of height / radius.
    FrameFamily { name: "frame-eye-near-surface", knobs: &TO_ROUNDING, make: eye_near_surface },
    // The knob: log10 of the offset.
    FrameFamily { name: "frame-offset", knobs: &[3.0, 6.0, 9.0, 12.0], make: offset },
    // The knob: log10 of the angle, in radians.
    FrameFamily { name: "frame-up-near-view", knobs: &TO_ROUNDING, make: up_near_view },
    // The knob: log10 of its pixels.
    FrameFamily { name: "frame-long-thin", knobs: &[0.0, 1.0, 2.0, 3.0, 4.0], make: long_thin },
    // The knob: log10 of the size.
    FrameFamily {
        name: "viewport-extreme",
        knobs: &[-12.0, -6.0, -3.0, 3.0, 6.0, 12.0],
        make: viewport_extreme,
    },
    // The knob: log10 of the scale.
    FrameFamily {
        name: "frame-range",
        knobs: &[-300.0, -150.0, -100.0, 100.0, 150.0, 300.0],
        make: range,
    },
];

/// Returns a camera at `eye` that looks at a point, with 16 to 24 pixels along each side of the image.
fn camera(draw: &mut Draw, eye: [f64; 3], at: [f64; 3]) -> Camera {
    let up = draw.direction();
    let view = plus(at, -1.0, eye);
    let orientation = match draw.whole(0, 5) as i64 {
        0 | 1 => Orientation::View { view, up },
        2 => {
            let [u, v, w] = rounded_basis(view, up);
            Orientation::Basis { u, v, w }
        }
        _ => Orientation::At { at, up },
    };
    let [columns, rows] = [(); 2].map(|()| draw.whole(16, 24) as u32);
    Camera {
        eye,
        orientation,
        width: draw.between(0.5, 2.0),
        height: draw.between(0.5, 2.0),
        distance: draw.between(0.5, 2.0),
        columns,
        rows,
    }
}

/// Makes a case with an ordinary camera and scene.
fn everyday(draw: &mut Draw, count: f64) -> FrameCase {
    let planes = draw.whole(0, (count as i64 + 1) / 4) as usize;
    let mut objects: Vec<Object> = (planes..count as usize)
        .map(|_| Object::Sphere { center: draw.in_box(2.0), radius: draw.between(0.3, 1.5) })
        .collect();
    objects.extend(
        (0..planes).map(|_| Object::Plane { point: draw.in_box(3.0), normal: draw.in_box(2.0) }),
    );
    let eye = scaled(draw.direction(), draw.between(4.0, 8.0));
    let at = draw.in_box(0.5);
    FrameCase { camera: camera(draw, eye, at), objects }
}

/// Makes a case with the horizon of a huge sphere just below the eye.
fn planet(draw: &mut Draw, k: f64) -> FrameCase {
    let radius = decade(k) * draw.between(1.0, 2.0);
    let height = draw.of_any_size(1e-3, 10.0);
    let eye = draw.in_box(3.0);
    let down = draw.direction();
    let center = plus(eye, radius + height, down);
    let level = plus(draw.across(down), draw.between(-0.2, 0.4), down);
    let ball = Object::Sphere { center: plus(eye, 4.0, level), radius: draw.between(0.2, 1.0) };
    let camera = camera(draw, eye, plus(eye, 1.0, level));
    FrameCase { camera, objects: vec![Object::Sphere { center, radius }, ball] }
}

/// Returns the basis, with rounding errors.
fn rounded_basis(view: [f64; 3], up: [f64; 3]) -> [[f64; 3]; 3] {
    let unit = |v| scaled(v, 1.0 / dot(v, v).sqrt());
    let (u, w) = (unit(cross(view, up)), unit(scaled(view, -1.0)));
    [u, cross(w, u), w]
}

/// Returns the direction of a pixel's ray, with rounding errors.
fn direction_of_pixel(camera: &Camera, row: f64, column: f64) -> [f64; 3] {
    let [u, v, w] = match camera.orientation {
        Orientation::At { at, up } => rounded_basis(plus(at, -1.0, camera.eye), up),
        Orientation::View { view, up } => rounded_basis(view, up),
        Orientation::Basis { u, v, w } => [u, v, w],
    };
    let x = camera.width * ((column + 0.5) / f64::from(camera.columns) - 0.5);
    let y = camera.height * (0.5 - (row + 0.5) / f64::from(camera.rows));
    plus(plus(scaled(u, x), y, v), -camera.distance, w)
}

/// Makes a case with spheres that are tiny compared with their distance. Each lies near the ray of a
/// pixel, within about its own size.
fn tiny_far(draw: &mut Draw, k: f64) -> FrameCase {
    let (eye, at) = (draw.in_box(4.0), draw.in_box(4.0));
    let camera = camera(draw, eye, at);
    let ratio = decade(k);
    let mut objects = Vec::new();
    for _ in 0..6 {
        let row = draw.whole(0, i64::from(camera.rows) - 1);
        let column = draw.whole(0, i64::from(camera.columns) - 1);
        let direction = direction_of_pixel(&camera, row, column);
        let t = draw.between(1.0, 50.0);
        let radius = t * dot(direction, direction).sqrt() * ratio;
        let aside = draw.between(0.0, 1.2) * radius;
        let center = plus(plus(camera.eye, t, direction), aside, draw.across(direction));
        objects.push(Object::Sphere { center, radius });
    }
    FrameCase { camera, objects }
}

/// Makes a case with the eye just outside or inside a sphere's surface.
fn eye_near_surface(draw: &mut Draw, k: f64) -> FrameCase {
    let (center, radius) = (draw.in_box(4.0), draw.between(0.5, 4.0));
    let height = draw.sign() * decade(k);
    let eye = plus(center, radius * (1.0 + height), draw.direction());
    let at = plus(eye, 1.0, draw.direction());
    let other = Object::Sphere { center: plus(eye, 3.0, draw.direction()), radius: 1.0 };
    FrameCase {
        camera: camera(draw, eye, at),
        objects: vec![Object::Sphere { center, radius }, other],
    }
}

/// Makes a case with an ordinary camera and scene, far from the world's origin.
fn offset(draw: &mut Draw, k: f64) -> FrameCase {
    let mut case = everyday(draw, 3.0);
    // Given by a view direction, because rounding may move the point at to the eye.
    if let Orientation::At { at, up } = case.camera.orientation {
        case.camera.orientation = Orientation::View { view: plus(at, -1.0, case.camera.eye), up };
    }
    let offset = scaled(draw.direction(), decade(k));
    case.map(|point| plus(point, 1.0, offset), |radius| radius)
}

/// Makes a case with an ordinary scene and a camera whose up vector is nearly parallel to its view.
fn up_near_view(draw: &mut Draw, k: f64) -> FrameCase {
    let mut case = everyday(draw, 3.0);
    let angle = decade(k) * draw.between(0.3, 3.0);
    let length = draw.sign() * draw.between(0.3, 2.0);
    let eye = case.camera.eye;
    case.camera.orientation = match case.camera.orientation {
        Orientation::At { at, .. } => {
            Orientation::At { at, up: tipped(draw, plus(at, -1.0, eye), angle, length) }
        }
        Orientation::View { view, .. } => {
            Orientation::View { view, up: tipped(draw, view, angle, length) }
        }
        Orientation::Basis { w, .. } => {
            let view = scaled(w, -1.0);
            Orientation::View { view, up: tipped(draw, view, angle, length) }
        }
    };
    case
}

fn tipped(draw: &mut Draw, view: [f64; 3], angle: f64, length: f64) -> [f64; 3] {
    scaled(plus(view, angle * dot(view, view).sqrt(), draw.across(view)), length)
}

/// Makes a case whose picture has only one row or one column.
fn long_thin(draw: &mut Draw, k: f64) -> FrameCase {
    let mut case = everyday(draw, 2.0);
    let pixels = decade(k) as u32;
    let [columns, rows] = if draw.once_in(2) { [pixels, 1] } else { [1, pixels] };
    case.camera = Camera { columns, rows, ..case.camera };
    case
}

/// Makes a case in which the viewport's size, its distance, or both are extreme.
fn viewport_extreme(draw: &mut Draw, k: f64) -> FrameCase {
    let mut case = everyday(draw, 3.0);
    let size = decade(k);
    let (extent, distance) = match draw.whole(0, 2) as i64 {
        0 => (size, 1.0),
        1 => (1.0, size),
        _ => (size, size),
    };
    case.camera.width *= extent;
    case.camera.height *= extent;
    case.camera.distance *= distance;
    case
}

/// Makes a case whose camera and scene are so large or small that the squares of lengths overflow or
/// underflow in `f64`.
fn range(draw: &mut Draw, k: f64) -> FrameCase {
    let case = everyday(draw, 3.0);
    case.scaled(decade(k))
}

/// Number of pixels from the middle pixel to the edge of the picture.
const HALF: i64 = 12;

/// Distance of the viewport, in units of a pixel's size. It has many divisors, so that rays through
/// pixel centres often have integer directions.
const DISTANCE: f64 = 12.0;

/// Returns the vector whose coordinates are `[x, y, z]` with respect to the three vectors of `frame`.
fn in_frame(frame: &[[f64; 3]; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    plus(plus(scaled(frame[0], x), y, frame[1]), z, frame[2])
}

/// Returns a camera whose pixel size is a power of two, and whose picture has a pixel in the middle.
fn centred_camera(
    draw: &mut Draw,
    eye: [f64; 3],
    orientation: Orientation,
    distance: f64,
) -> Camera {
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

/// Makes a case with spheres whose outlines pass exactly through pixel centres. The radii are then
/// changed by `ulps` units in the last place.
pub(crate) fn tangent(draw: &mut Draw, ulps: f64) -> FrameCase {
    let case = if draw.once_in(2) {
        by_rational_basis(draw, ulps)
    } else {
        by_irrational_basis(draw, ulps)
    };
    case.scaled(draw.power_of_two(-16, 16))
}

/// Makes a case with spheres that each touch the ray of a pixel. The camera's basis consists of
/// perpendicular vectors with integer coordinates, divided by their integer length (see
/// [`Draw::whole_frame`]), so that all rays have rational directions.
fn by_rational_basis(draw: &mut Draw, ulps: f64) -> FrameCase {
    let (world, length) = draw.whole_frame(2);
    let eye = draw.whole_vector(100);
    let mut objects = Vec::new();
    while objects.len() < 3 {
        // In the camera's coordinates, in units of pixels.
        let ([along, out, _], size) = draw.whole_frame(2);
        let depth = along[2].abs();
        let reaches = |x: f64| x.abs() * DISTANCE / depth <= HALF as f64;
        if depth == 0.0 || DISTANCE % depth != 0.0 || !reaches(along[0]) || !reaches(along[1]) {
            continue;
        }
        let t = -along[2].signum() * draw.whole(1, 16);
        let radii = draw.sign() * draw.whole(1, 8);
        let center = plus(scaled(along, t), radii, out);
        let radius = moved_by_ulps(radii.abs() * size * length, ulps);
        objects.push(Object::Sphere { center: plus(eye, 1.0, in_frame(&world, center)), radius });
    }
    let view = scaled(world[2], -draw.whole(1, 5));
    let up = plus(scaled(world[1], draw.whole(1, 5)), draw.whole(-3, 3), world[2]);
    let orientation = draw.aimed(eye, view, up);
    FrameCase { camera: centred_camera(draw, eye, orientation, DISTANCE), objects }
}

/// Returns a camera that is turned by 45 degrees from the three perpendicular integer vectors `world`,
/// so that its basis contains the square root of 2. [`of_column`] gives the directions of the rays in
/// its middle row.
fn half_turned(draw: &mut Draw, world: &[[f64; 3]; 3], eye: [f64; 3]) -> Camera {
    let view = in_frame(world, scaled([-1.0, 0.0, -1.0], draw.whole(1, 5)));
    let up = plus(scaled(world[1], draw.whole(1, 5)), draw.whole(-3, 3), view);
    let orientation = draw.aimed(eye, view, up);
    centred_camera(draw, eye, orientation, DISTANCE)
}

/// Returns the direction, up to a factor, of the ray through the pixel x columns to the right of the
/// centre of the camera [`half_turned`], in coordinates with respect to that camera's integer vectors.
fn of_column(x: f64) -> [f64; 3] {
    [x - DISTANCE, 0.0, -x - DISTANCE]
}

/// Makes a case with spheres that touch rays of the middle row from above and below. The camera's basis
/// is irrational.
fn by_irrational_basis(draw: &mut Draw, ulps: f64) -> FrameCase {
    let (world, length) = draw.whole_frame(2);
    let eye = draw.whole_vector(100);
    let mut objects = Vec::new();
    for _ in 0..3 {
        let along = scaled(of_column(draw.whole(-HALF, HALF)), draw.whole(1, 8));
        let radii = draw.sign() * draw.whole(1, 40);
        let center = plus(along, radii, [0.0, 1.0, 0.0]);
        let radius = moved_by_ulps(radii.abs() * length, ulps);
        objects.push(Object::Sphere { center: plus(eye, 1.0, in_frame(&world, center)), radius });
    }
    FrameCase { camera: half_turned(draw, &world, eye), objects }
}

/// Makes a case with two spheres, one inside the other, and a plane, all of which touch at one point.
/// The ray of a pixel of the camera [`half_turned`] hits all three there.
pub(crate) fn touching(draw: &mut Draw, ulps: f64) -> FrameCase {
    let (world, length) = draw.whole_frame(2);
    let eye = draw.whole_vector(100);
    let along = of_column(draw.whole(-HALF, HALF));
    // The direction towards the eye.
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
        Object::Sphere { center, radius: moved_by_ulps(radii * size * length, ulps) }
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

/// Makes a case with two concentric spheres and the same plane given twice. The second sphere's radius
/// is changed by `ulps` units in the last place. Of coincident objects, the one listed first is hit.
pub(crate) fn ties(draw: &mut Draw, ulps: f64) -> FrameCase {
    let center = draw.whole_vector(20);
    let radius = draw.whole(4, 12);
    let second = moved_by_ulps(radius, ulps);
    let (point, normal) = (plus(center, 1.0, draw.whole_vector(6)), draw.whole_vector(9));
    let in_plane = cross(normal, draw.whole_vector(9));
    let other_point = plus(point, draw.whole(-3, 3), in_plane);
    let other_normal = scaled(normal, draw.sign() * draw.whole(1, 7));
    let eye = plus(center, draw.between(1.5, 3.0) * radius, draw.direction());
    let up = draw.direction();
    let orientation = Orientation::At { at: center, up };
    let half = draw.whole(6, HALF) as u32;
    let camera =
        Camera { columns: 2 * half, rows: half, ..centred_camera(draw, eye, orientation, 30.0) };
    let objects = vec![
        Object::Sphere { center, radius },
        Object::Sphere { center, radius: second },
        Object::Plane { point, normal },
        Object::Plane { point: other_point, normal: other_normal },
    ];
    FrameCase { camera, objects }
}
