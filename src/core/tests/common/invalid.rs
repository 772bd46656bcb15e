//! Invalid inputs, each with a text that says what is invalid about it.

use pinhole_reference::{Camera, Object, Orientation, RayCase};

use super::bases::BasisCase;

/// Numbers that are not finite.
const STRANGE: [(&str, f64); 3] =
    [("NaN", f64::NAN), ("infinity", f64::INFINITY), ("-infinity", f64::NEG_INFINITY)];

const BALL: Object = Object::Sphere { center: [0.0, 0.0, -5.0], radius: 1.0 };
const WALL: Object = Object::Plane { point: [0.0, 0.0, -6.0], normal: [0.0, 0.0, 1.0] };
const VIEW: [f64; 3] = [0.0, 0.0, -1.0];
const UP: [f64; 3] = [0.0, 1.0, 0.0];

/// Returns cases in which one coordinate of the vector `v` is NaN or infinite: each coordinate in turn,
/// with each such number.
fn spoilt<T>(name: &str, v: [f64; 3], case: impl Fn([f64; 3]) -> T) -> Vec<(String, T)> {
    let mut all = Vec::new();
    for (what, value) in STRANGE {
        for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let mut spoilt = v;
            spoilt[i] = value;
            all.push((format!("{name}.{axis} is {what}"), case(spoilt)));
        }
    }
    all
}

/// Returns cases with a ball, a wall and a ray, in each of which one number (or a zero vector) is
/// invalid.
pub(crate) fn rays() -> Vec<(String, RayCase)> {
    let case = |objects: [Object; 2], origin, direction| RayCase {
        objects: objects.to_vec(),
        origin,
        direction,
    };
    let with = |ball, wall| case([ball, wall], [0.0; 3], VIEW);
    let mut all = vec![
        ("direction is 0".to_owned(), case([BALL, WALL], [0.0; 3], [0.0; 3])),
        ("direction is -0".to_owned(), case([BALL, WALL], [0.0; 3], [-0.0; 3])),
    ];
    let both = [BALL, WALL];
    all.extend(spoilt("origin", [0.0; 3], |origin| case(both, origin, VIEW)));
    all.extend(spoilt("direction", VIEW, |direction| case(both, [0.0; 3], direction)));
    let ball = |center| Object::Sphere { center, radius: 1.0 };
    all.extend(spoilt("center", [0.0, 0.0, -5.0], |center| with(ball(center), WALL)));
    let sizes = [("0", 0.0), ("-0", -0.0), ("negative", -1.0), ("negative", -f64::from_bits(1))];
    for (what, radius) in sizes.into_iter().chain(STRANGE) {
        let ball = Object::Sphere { center: [0.0, 0.0, -5.0], radius };
        all.push((format!("radius is {what}"), with(ball, WALL)));
    }
    let wall = |point, normal| with(BALL, Object::Plane { point, normal });
    let (point, normal) = ([0.0, 0.0, -6.0], [0.0, 0.0, 1.0]);
    all.extend(spoilt("point", point, |point| wall(point, normal)));
    all.extend(spoilt("normal", normal, |normal| wall(point, normal)));
    for (what, normal) in [("0", [0.0; 3]), ("-0", [-0.0; 3])] {
        all.push((format!("normal is {what}"), wall(point, normal)));
    }
    all
}

/// Returns positions and orientations of cameras in which one number is not finite. Those with finite
/// numbers but without a basis are the family `no-basis`.
pub(crate) fn bases() -> Vec<(String, BasisCase)> {
    let case = |eye, orientation| BasisCase { eye, orientation };
    let at_origin = |orientation| case([0.0; 3], orientation);
    let [u, v, w] = [[1.0, 0.0, 0.0], UP, [0.0, 0.0, 1.0]];
    let all = [
        spoilt("eye", [0.0; 3], |eye| case(eye, Orientation::At { at: VIEW, up: UP })),
        spoilt("at", VIEW, |at| at_origin(Orientation::At { at, up: UP })),
        spoilt("view", VIEW, |view| at_origin(Orientation::View { view, up: UP })),
        spoilt("up", UP, |up| at_origin(Orientation::At { at: VIEW, up })),
        spoilt("up", UP, |up| at_origin(Orientation::View { view: VIEW, up })),
        spoilt("basis.u", u, |u| at_origin(Orientation::Basis { u, v, w })),
        spoilt("basis.v", v, |v| at_origin(Orientation::Basis { u, v, w })),
        spoilt("basis.w", w, |w| at_origin(Orientation::Basis { u, v, w })),
    ];
    all.concat()
}

/// Returns cameras whose basis is valid, but whose viewport or image is not.
pub(crate) fn cameras() -> Vec<(String, Camera)> {
    let valid = Camera {
        eye: [0.0; 3],
        orientation: Orientation::View { view: VIEW, up: UP },
        width: 1.0,
        height: 1.0,
        distance: 1.0,
        columns: 4,
        rows: 4,
    };
    let mut all = vec![
        ("columns is 0".to_owned(), Camera { columns: 0, ..valid }),
        ("rows is 0".to_owned(), Camera { rows: 0, ..valid }),
    ];
    let sizes = [("0", 0.0), ("-0", -0.0), ("negative", -1.0)];
    for (what, size) in sizes.into_iter().chain(STRANGE) {
        all.push((format!("width is {what}"), Camera { width: size, ..valid }));
        all.push((format!("height is {what}"), Camera { height: size, ..valid }));
        all.push((format!("distance is {what}"), Camera { distance: size, ..valid }));
    }
    all
}
