//! Families of camera bases.

use crate::camera::Orientation;
use crate::families::draw::{Draw, plus, scaled};
use crate::families::family::{BasisCase, Family, OFFSETS, TO_ROUNDING, ULPS, bases};

pub(crate) static FAMILIES: [Family; 7] = [
    bases(
        "basis-ordinary",
        "An everyday eye, view and up.",
        "angle between up and view in degrees, about",
        &[10.0, 45.0, 90.0, 135.0, 170.0],
        ordinary,
    ),
    bases(
        "up-near-view",
        "An up that is nearly parallel to the view.",
        "log10 of the angle between up and view in radians",
        &TO_ROUNDING,
        up_near_view,
    ),
    bases(
        "up-parallel",
        "An up that is parallel to the view, and one ulp beside.",
        "one coordinate of up, in ulps from parallel",
        &ULPS,
        up_parallel,
    ),
    bases(
        "no-basis",
        "What has no basis, by each reason.",
        "0: eye is at, 1: view is 0, 2: up is 0, 3: up is parallel to view",
        &[0.0, 1.0, 2.0, 3.0],
        no_basis,
    ),
    bases(
        "view-length",
        "A view of an extreme length.",
        "log10 of |at - eye|",
        &[-320.0, -300.0, -150.0, -30.0, -3.0, 3.0, 30.0, 150.0, 300.0, 307.0],
        view_length,
    ),
    bases(
        "up-length",
        "An up of an extreme length.",
        "log10 of the length of up",
        &[-320.0, -300.0, -150.0, -30.0, -3.0, 3.0, 30.0, 150.0, 300.0, 307.0],
        up_length,
    ),
    bases(
        "camera-offset",
        "An everyday camera, far from the world's origin.",
        "log10 of the offset",
        &OFFSETS,
        camera_offset,
    ),
];

/// An orientation along `view`, by a point or by the vector. Where `at - eye` is to be `view` exactly, both must be
/// whole numbers.
pub(crate) fn aimed(draw: &mut Draw, eye: [f64; 3], view: [f64; 3], up: [f64; 3]) -> Orientation {
    if draw.once_in(3) {
        Orientation::View { view, up }
    } else {
        Orientation::At { at: plus(eye, 1.0, view), up }
    }
}

fn seen_from(draw: &mut Draw, eye: [f64; 3], view: [f64; 3], up: [f64; 3]) -> BasisCase {
    let eye = draw.given3(eye);
    BasisCase { eye, orientation: aimed(draw, eye, view, up) }
}

/// `cos` and `sin` of a multiple of 5 degrees, from those of 5 degrees: no library's last bit is in
/// them.
fn by_degrees(degrees: f64) -> (f64, f64) {
    let (c, s) = (0.996_194_698_091_745_5, 0.087_155_742_747_658_17);
    let turns = (degrees / 5.0) as usize;
    (0..turns).fold((1.0, 0.0), |(x, y), _| (x * c - y * s, x * s + y * c))
}

/// Everyday cameras.
fn ordinary(draw: &mut Draw, degrees: f64) -> BasisCase {
    let (eye, view) = (draw.in_box(10.0), draw.direction());
    let (along, across) = by_degrees(degrees);
    let up = plus(scaled(view, along), across, draw.across(view));
    let up = scaled(up, draw.between(0.5, 2.0));
    let view = scaled(view, draw.between(0.5, 20.0));
    seen_from(draw, eye, view, up)
}

/// An up nearly parallel to the view: their cross product nearly cancels.
fn up_near_view(draw: &mut Draw, k: f64) -> BasisCase {
    let eye = draw.in_box(10.0);
    let eye = draw.given3(eye);
    let view = scaled(draw.direction(), draw.between(0.5, 20.0));
    let at = draw.given3(plus(eye, 1.0, view));
    // The view that is meant is the one that rounding left.
    let is_at_a_point = draw.once_in(2);
    let view = if is_at_a_point { plus(at, -1.0, eye) } else { draw.given3(view) };
    let angle = draw.decade(k) * draw.between(0.3, 3.0);
    let length = draw.sign() * draw.between(0.1, 2.0);
    let square = view.iter().map(|x| x * x).sum::<f64>();
    let up = scaled(plus(view, angle * square.sqrt(), draw.across(view)), length);
    let orientation =
        if is_at_a_point { Orientation::At { at, up } } else { Orientation::View { view, up } };
    BasisCase { eye, orientation }
}

/// Whole numbers that add and multiply exactly in `f32`.
fn whole_eye_and_view(draw: &mut Draw) -> ([f64; 3], [f64; 3]) {
    (draw.whole_vector(1000), draw.whole_vector(1000))
}

/// An up exactly along or against the view, where there is no basis, and one ulp beside.
fn up_parallel(draw: &mut Draw, ulps: f64) -> BasisCase {
    let (eye, view) = whole_eye_and_view(draw);
    let factor = draw.sign() * draw.whole(1, 1000) * draw.power_of_two(-20, 20);
    let mut up = scaled(view, factor);
    // Where the view has one coordinate alone, no length of it makes a basis.
    let i = draw.whole(0, 2) as usize;
    if up[i] != 0.0 {
        up[i] = draw.moved_by_ulps(up[i], ulps);
    }
    let scale = draw.power_of_two(-20, 20);
    seen_from(draw, scaled(eye, scale), scaled(view, scale), up)
}

/// Cameras without a basis.
fn no_basis(draw: &mut Draw, which: f64) -> BasisCase {
    let (eye, view) = whole_eye_and_view(draw);
    let up = draw.whole_vector(9);
    let zero = scaled([0.0; 3], draw.sign());
    let factor = draw.sign() * draw.power_of_two(-60, 60);
    let orientation = match which as i64 {
        0 => Orientation::At { at: eye, up },
        1 => Orientation::View { view: zero, up },
        2 => aimed(draw, eye, view, zero),
        _ => aimed(draw, eye, view, scaled(view, factor)),
    };
    BasisCase { eye, orientation }
}

/// Eye and at very close together, or very far apart.
fn view_length(draw: &mut Draw, k: f64) -> BasisCase {
    let length = draw.decade(k);
    // An eye far larger than the view would swallow it.
    let eye = scaled(draw.in_box(0.5), length);
    let view = scaled(draw.direction(), length);
    let up = draw.in_box(1.0);
    seen_from(draw, eye, view, up)
}

/// Very long and very short up vectors.
fn up_length(draw: &mut Draw, k: f64) -> BasisCase {
    let (eye, view) = (draw.in_box(10.0), draw.in_box(10.0));
    let up = scaled(draw.direction(), draw.decade(k));
    seen_from(draw, eye, view, up)
}

/// An everyday camera far from the world's origin: at - eye cancels.
fn camera_offset(draw: &mut Draw, k: f64) -> BasisCase {
    let eye = scaled(draw.direction(), draw.decade(k));
    let (view, up) = (draw.in_box(10.0), draw.in_box(1.0));
    seen_from(draw, eye, view, up)
}
