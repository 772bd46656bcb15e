//! Inputs that must be refused at the door, with what is wrong about each.

use crate::camera::{Camera, Orientation};
use crate::families::family::{BasisCase, RayCase};
use crate::object::Object;

/// Numbers that are not finite.
const STRANGE: [(&str, f64); 3] =
    [("NaN", f64::NAN), ("infinity", f64::INFINITY), ("-infinity", f64::NEG_INFINITY)];

const BALL: Object = Object::Sphere { center: [0.0, 0.0, -5.0], radius: 1.0 };
const WALL: Object = Object::Plane { point: [0.0, 0.0, -6.0], normal: [0.0, 0.0, 1.0] };
const VIEW: [f64; 3] = [0.0, 0.0, -1.0];
const UP: [f64; 3] = [0.0, 1.0, 0.0];

/// Each coordinate of a vector in turn made not finite.
fn spoilt(name: &str, v: [f64; 3]) -> Vec<(String, [f64; 3])> {
    let mut all = Vec::new();
    for (what, value) in STRANGE {
        for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let mut spoilt = v;
            spoilt[i] = value;
            all.push((format!("{name}.{axis} is {what}"), spoilt));
        }
    }
    all
}

/// A ball, a wall and a ray of which one number is at fault.
pub fn invalid_rays() -> Vec<(String, RayCase)> {
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
    for (what, origin) in spoilt("origin", [0.0; 3]) {
        all.push((what, case([BALL, WALL], origin, VIEW)));
    }
    for (what, direction) in spoilt("direction", VIEW) {
        all.push((what, case([BALL, WALL], [0.0; 3], direction)));
    }
    for (what, center) in spoilt("center", [0.0, 0.0, -5.0]) {
        all.push((what, with(Object::Sphere { center, radius: 1.0 }, WALL)));
    }
    let sizes = [("0", 0.0), ("-0", -0.0), ("negative", -1.0), ("negative", -f64::from_bits(1))];
    for (what, radius) in sizes.into_iter().chain(STRANGE) {
        let ball = Object::Sphere { center: [0.0, 0.0, -5.0], radius };
        all.push((format!("radius is {what}"), with(ball, WALL)));
    }
    for (what, point) in spoilt("point", [0.0, 0.0, -6.0]) {
        all.push((what, with(BALL, Object::Plane { point, normal: [0.0, 0.0, 1.0] })));
    }
    for (what, normal) in spoilt("normal", [0.0, 0.0, 1.0]) {
        all.push((what, with(BALL, Object::Plane { point: [0.0, 0.0, -6.0], normal })));
    }
    for (what, normal) in [("0", [0.0; 3]), ("-0", [-0.0; 3])] {
        let wall = Object::Plane { point: [0.0, 0.0, -6.0], normal };
        all.push((format!("normal is {what}"), with(BALL, wall)));
    }
    all
}

/// Cameras' places and orientations of which one number is not finite. Those whose numbers are
/// finite but that have no basis are the family `no-basis`.
pub fn invalid_bases() -> Vec<(String, BasisCase)> {
    let mut all = Vec::new();
    let mut add = |what, eye, orientation| all.push((what, BasisCase { eye, orientation }));
    for (what, eye) in spoilt("eye", [0.0; 3]) {
        add(what, eye, Orientation::At { at: VIEW, up: UP });
    }
    for (what, at) in spoilt("at", VIEW) {
        add(what, [0.0; 3], Orientation::At { at, up: UP });
    }
    for (what, view) in spoilt("view", VIEW) {
        add(what, [0.0; 3], Orientation::View { view, up: UP });
    }
    for (what, up) in spoilt("up", UP) {
        add(what.clone(), [0.0; 3], Orientation::At { at: VIEW, up });
        add(what, [0.0; 3], Orientation::View { view: VIEW, up });
    }
    let [u, v, w] = [[1.0, 0.0, 0.0], UP, [0.0, 0.0, 1.0]];
    for (what, u) in spoilt("basis.u", u) {
        add(what, [0.0; 3], Orientation::Basis { u, v, w });
    }
    for (what, v) in spoilt("basis.v", v) {
        add(what, [0.0; 3], Orientation::Basis { u, v, w });
    }
    for (what, w) in spoilt("basis.w", w) {
        add(what, [0.0; 3], Orientation::Basis { u, v, w });
    }
    all
}

/// Cameras with a basis whose viewport or image is at fault.
pub fn invalid_cameras() -> Vec<(String, Camera)> {
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
