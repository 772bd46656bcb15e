//! Families of difficult camera bases, like those of rays in `pinhole_reference::Family`.

use pinhole_reference::{Draw, Orientation, decade, moved_by_ulps};

/// A camera's place and orientation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BasisCase {
    /// Its position.
    pub(crate) eye: [f64; 3],
    /// The way it is turned.
    pub(crate) orientation: Orientation,
}

/// Camera bases that are difficult for the same reason, with a parameter, the knob, that sets how
/// difficult they are.
pub(crate) struct BasisFamily {
    /// Its name, in kebab-case.
    pub(crate) name: &'static str,
    /// The knob's values, in rising order.
    pub(crate) knobs: &'static [f64],
    make: fn(&mut Draw, f64) -> BasisCase,
}

impl BasisFamily {
    /// Returns `count` cases for one value of the knob.
    pub(crate) fn cases(&self, knob: f64, seed: u64, count: usize) -> Vec<BasisCase> {
        let case = |mut draw: Draw| (self.make)(&mut draw, knob);
        Draw::cases(seed, self.name, knob, count).map(case).collect()
    }
}

const LENGTHS: [f64; 10] = [-320.0, -300.0, -150.0, -30.0, -3.0, 3.0, 30.0, 150.0, 300.0, 307.0];

pub(crate) const FAMILIES: [BasisFamily; 7] = [
    BasisFamily {
        name: "basis-ordinary",
        knobs: &[10.0, 45.0, 90.0, 135.0, 170.0],
        make: ordinary,
    },
    BasisFamily {
        name: "up-near-view",
        knobs: &[-16.0, -14.0, -12.0, -10.0, -8.0, -6.0, -3.0, -1.0],
        make: up_near_view,
    },
    BasisFamily { name: "up-parallel", knobs: &[-1.0, 0.0, 1.0], make: up_parallel },
    BasisFamily { name: "no-basis", knobs: &[0.0, 1.0, 2.0, 3.0], make: no_basis },
    BasisFamily { name: "view-length", knobs: &LENGTHS, make: view_length },
    BasisFamily { name: "up-length", knobs: &LENGTHS, make: up_length },
    BasisFamily { name: "camera-offset", knobs: &[3.0, 6.0, 9.0, 12.0], make: camera_offset },
];

fn scaled(a: [f64; 3], s: f64) -> [f64; 3] {
    a.map(|x| x * s)
}

/// `a + s b`
fn plus(a: [f64; 3], s: f64, b: [f64; 3]) -> [f64; 3] {
    [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]]
}

fn seen_from(draw: &mut Draw, eye: [f64; 3], view: [f64; 3], up: [f64; 3]) -> BasisCase {
    BasisCase { eye, orientation: draw.aimed(eye, view, up) }
}

/// Returns the cosine and the sine of a multiple of 5 degrees, computed from constants, so that they do
/// not depend on the last bit of a math library.
fn by_degrees(degrees: f64) -> (f64, f64) {
    let (c, s) = (0.996_194_698_091_745_5, 0.087_155_742_747_658_17);
    let turns = (degrees / 5.0) as usize;
    (0..turns).fold((1.0, 0.0), |(x, y), _| (x * c - y * s, x * s + y * c))
}

/// Makes an ordinary camera. The knob is the approximate angle between up and view in degrees.
fn ordinary(draw: &mut Draw, degrees: f64) -> BasisCase {
    let (eye, view) = (draw.in_box(10.0), draw.direction());
    let (along, across) = by_degrees(degrees);
    let up = plus(scaled(view, along), across, draw.across(view));
    let up = scaled(up, draw.between(0.5, 2.0));
    let view = scaled(view, draw.between(0.5, 20.0));
    seen_from(draw, eye, view, up)
}

/// Makes a camera whose up is nearly parallel to its view, so that the terms of their cross product
/// nearly cancel. The knob is log10 of the angle in radians.
fn up_near_view(draw: &mut Draw, k: f64) -> BasisCase {
    let eye = draw.in_box(10.0);
    let view = scaled(draw.direction(), draw.between(0.5, 20.0));
    let at = plus(eye, 1.0, view);
    // Up must be nearly parallel to the view after rounding.
    let is_at_a_point = draw.once_in(2);
    let view = if is_at_a_point { plus(at, -1.0, eye) } else { view };
    let angle = decade(k) * draw.between(0.3, 3.0);
    let length = draw.sign() * draw.between(0.1, 2.0);
    let square = view.iter().map(|x| x * x).sum::<f64>();
    let up = scaled(plus(view, angle * square.sqrt(), draw.across(view)), length);
    let orientation =
        if is_at_a_point { Orientation::At { at, up } } else { Orientation::View { view, up } };
    BasisCase { eye, orientation }
}

/// Returns an eye and a view with integer coordinates whose sums are exact in `f32`.
fn whole_eye_and_view(draw: &mut Draw) -> ([f64; 3], [f64; 3]) {
    (draw.whole_vector(1000), draw.whole_vector(1000))
}

/// Makes a camera whose up is exactly parallel or opposite to its view, so that there is no basis. One
/// coordinate of up is then changed by as many ulps as the knob says.
fn up_parallel(draw: &mut Draw, ulps: f64) -> BasisCase {
    let (eye, view) = whole_eye_and_view(draw);
    let factor = draw.sign() * draw.whole(1, 1000) * draw.power_of_two(-20, 20);
    let mut up = scaled(view, factor);
    // If up has only one nonzero coordinate, changing it leaves up parallel to the view.
    let i = draw.whole(0, 2) as usize;
    if up[i] != 0.0 {
        up[i] = moved_by_ulps(up[i], ulps);
    }
    let scale = draw.power_of_two(-20, 20);
    seen_from(draw, scaled(eye, scale), scaled(view, scale), up)
}

/// Makes a camera without a basis. The knob is the reason: 0: eye equals at; 1: view is 0; 2: up is 0;
/// 3: up is parallel to view.
fn no_basis(draw: &mut Draw, which: f64) -> BasisCase {
    let (eye, view) = whole_eye_and_view(draw);
    let up = draw.whole_vector(9);
    let zero = scaled([0.0; 3], draw.sign());
    let factor = draw.sign() * draw.power_of_two(-60, 60);
    let orientation = match which as i64 {
        0 => Orientation::At { at: eye, up },
        1 => Orientation::View { view: zero, up },
        2 => draw.aimed(eye, view, zero),
        _ => draw.aimed(eye, view, scaled(view, factor)),
    };
    BasisCase { eye, orientation }
}

/// Makes a camera whose eye and at are very close together or very far apart. The knob is log10 of
/// their distance.
fn view_length(draw: &mut Draw, k: f64) -> BasisCase {
    let length = decade(k);
    // If the eye's coordinates were far larger than the view's, rounding would erase the view.
    let eye = scaled(draw.in_box(0.5), length);
    let view = scaled(draw.direction(), length);
    let up = draw.in_box(1.0);
    seen_from(draw, eye, view, up)
}

/// Makes a camera with a very long or very short up vector. The knob is log10 of its length.
fn up_length(draw: &mut Draw, k: f64) -> BasisCase {
    let (eye, view) = (draw.in_box(10.0), draw.in_box(10.0));
    let up = scaled(draw.direction(), decade(k));
    seen_from(draw, eye, view, up)
}

/// Makes an ordinary camera far from the world's origin, so that at - eye nearly cancels. The knob is
/// log10 of the distance.
fn camera_offset(draw: &mut Draw, k: f64) -> BasisCase {
    let eye = scaled(draw.direction(), decade(k));
    let (view, up) = (draw.in_box(10.0), draw.in_box(1.0));
    seen_from(draw, eye, view, up)
}
