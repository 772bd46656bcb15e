//! Every checked door, each case with its whole message.

use pinhole_core::*;

use crate::common::{plane, roots_of, sphere, vec3};

const NAN: f64 = f64::NAN;
const INF: f64 = f64::INFINITY;

#[track_caller]
fn assert_says<T: std::fmt::Debug>(result: Result<T, impl std::error::Error>, message: &str) {
    assert_eq!(result.unwrap_err().to_string(), message);
}

#[test]
fn basis_from_view_and_up() {
    let along = Basis::from_view_up;
    assert_says(
        along(vec3(NAN, 0.0, -1.0), DVec3::Y),
        "view is (NaN, 0, -1): every coordinate must be a finite number",
    );
    assert_says(
        along(DVec3::NEG_Z, vec3(0.0, INF, 0.0)),
        "up is (0, inf, 0): every coordinate must be a finite number",
    );
    assert_says(
        along(vec3(0.0, -0.0, 0.0), DVec3::Y),
        "view is (0, 0, 0): it must point somewhere",
    );
    assert_says(along(DVec3::NEG_Z, DVec3::ZERO), "up is (0, 0, 0): it must point somewhere");
    assert_says(along(DVec3::ZERO, DVec3::ZERO), "view is (0, 0, 0): it must point somewhere");
    assert_says(
        along(vec3(0.25, 0.5, -0.75), vec3(-1.0, -2.0, 3.0)),
        "up (-1, -2, 3) is parallel to the view direction (0.25, 0.5, -0.75): turn one of them",
    );
}

/// Only exactly parallel vectors are rejected. The `f64` numbers 0.1, 0.2, 0.3 are not exactly in the
/// ratio 1 : 2 : 3.
#[test]
fn almost_parallel_is_no_error() {
    assert!(Basis::from_view_up(vec3(0.1, 0.2, 0.3), vec3(1.0, 2.0, 3.0)).is_ok());
    assert!(Basis::from_view_up(vec3(1.0, 0.0, 0.0), vec3(1e300, 1e-300, 0.0)).is_ok());
    assert!(Basis::from_view_up(vec3(0.0, 1.0, 5e-324), vec3(0.0, 1e308, -5e-324)).is_ok());
}

#[test]
fn basis_from_eye_at_and_up() {
    let (eye, at) = (vec3(1.0, 2.0, 3.0), vec3(1.0, 2.0, -4.0));
    let looking = Basis::from_eye_at_up;
    assert_says(
        looking(vec3(1.0, -INF, 3.0), at, DVec3::Y),
        "eye is (1, -inf, 3): every coordinate must be a finite number",
    );
    assert_says(
        looking(eye, vec3(1.0, 2.0, NAN), DVec3::Y),
        "at is (1, 2, NaN): every coordinate must be a finite number",
    );
    assert_says(
        looking(eye, eye, vec3(NAN, 0.0, 0.0)),
        "up is (NaN, 0, 0): every coordinate must be a finite number",
    );
    assert_says(
        looking(eye, eye, DVec3::Y),
        "eye and at are the same point (1, 2, 3): move one of them",
    );
    assert_says(looking(eye, at, DVec3::ZERO), "up is (0, 0, 0): it must point somewhere");
    assert_says(
        looking(eye, at, vec3(0.0, 0.0, 1e-300)),
        "up (0, 0, 1e-300) is parallel to the view direction (0, 0, -7): turn one of them",
    );
}

#[test]
fn basis_by_hand() {
    let by_hand = Basis::by_hand;
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    assert_says(
        by_hand(vec3(INF, 0.0, 0.0), y, z),
        "basis.u is (inf, 0, 0): every coordinate must be a finite number",
    );
    assert_says(
        by_hand(x, vec3(0.0, NAN, 0.0), z),
        "basis.v is (0, NaN, 0): every coordinate must be a finite number",
    );
    assert_says(
        by_hand(x, y, vec3(0.0, 0.0, -INF)),
        "basis.w is (0, 0, -inf): every coordinate must be a finite number",
    );
    assert_says(by_hand(2.0 * x, y, z), "u has length 2: it must be 1 within 1e-9");
    assert_says(by_hand(x, DVec3::ZERO, z), "v has length 0: it must be 1 within 1e-9");
    assert_says(by_hand(x, y, 1e300 * z), "w has length 1e300: it must be 1 within 1e-9");
    assert_says(by_hand(vec3(0.8, 0.6, 0.0), y, z), "u . v is 0.6: it must be 0 within 1e-9");
    assert_says(by_hand(x, y, vec3(0.0, -0.6, 0.8)), "v . w is -0.6: it must be 0 within 1e-9");
    assert_says(by_hand(x, y, vec3(1e-8, 0.0, 1.0)), "w . u is 1e-8: it must be 0 within 1e-9");
    let left_handed = "the basis is left-handed: u x v is -w and must be w, which points backwards";
    assert_says(by_hand(x, y, -z), left_handed);
    assert_says(by_hand(y, x, z), left_handed);
}

#[expect(clippy::approx_constant, reason = "as a student types 1 / sqrt 2")]
#[test]
fn basis_by_hand_is_taken_to_the_bit_within_the_tolerance() {
    let ten_digits = 0.7071067812;
    let (u, w) = (vec3(ten_digits, 0.0, -ten_digits), vec3(ten_digits, 0.0, ten_digits));
    assert_eq!(Basis::by_hand(u, DVec3::Y, w), Ok(Basis { u, v: DVec3::Y, w }));
    let four_digits = u / ten_digits * 0.7071;
    assert!(matches!(
        Basis::by_hand(four_digits, DVec3::Y, w),
        Err(BasisError::NotUnit { vector: "u", .. })
    ));
}

#[test]
fn camera() {
    let nowhere = Camera { eye: vec3(0.0, NAN, 0.0), ..Camera::CANONICAL };
    for orientation in [
        Camera::CANONICAL.orientation,
        Orientation::View { view: DVec3::NEG_Z, up: DVec3::Y },
        Orientation::Basis(Basis::CANONICAL),
    ] {
        let message = "eye is (0, NaN, 0): every coordinate must be a finite number";
        assert_says(Camera { orientation, ..nowhere }.resolve(), message);
        assert_says(Camera { orientation, ..nowhere }.basis(), message);
        assert_says(Camera { orientation, ..nowhere }.up_angle(), message);
    }
    let mirrored = Basis { w: DVec3::NEG_Z, ..Basis::CANONICAL };
    let camera = Camera { orientation: Orientation::Basis(mirrored), ..Camera::CANONICAL };
    assert_eq!(camera.resolve(), Err(CameraError::Basis(BasisError::LeftHanded)));
    let image_error: CameraError = ImageSize::new(0, 1).unwrap_err().into();
    assert_eq!(image_error.to_string(), "image width is 0: it must be 1 to 16384 pixels");
}

#[test]
fn viewport() {
    let ok = Viewport::CANONICAL;
    for (value, text) in
        [(0.0, "0"), (-0.0, "0"), (-1.5, "-1.5"), (NAN, "NaN"), (INF, "inf"), (-5e-324, "-5e-324")]
    {
        for (field, viewport) in [
            ("width", Viewport { width: value, ..ok }),
            ("height", Viewport { height: value, ..ok }),
            ("distance", Viewport { distance: value, ..ok }),
        ] {
            let message =
                format!("viewport {field} is {text}: it must be finite and greater than 0");
            assert_says(viewport.check(), &message);
            assert_says(Camera { viewport, ..Camera::CANONICAL }.resolve(), &message);
        }
    }
    assert_eq!(Viewport { width: 1e-12, height: 1e12, distance: 1e-300 }.check(), Ok(()));
}

#[test]
fn image() {
    assert_says(ImageSize::new(0, 0), "image width is 0: it must be 1 to 16384 pixels");
    assert_says(ImageSize::new(16_385, 1), "image width is 16385: it must be 1 to 16384 pixels");
    assert_says(ImageSize::new(1, 0), "image height is 0: it must be 1 to 16384 pixels");
    assert_says(
        ImageSize::new(16_384, u32::MAX),
        "image height is 4294967295: it must be 1 to 16384 pixels",
    );
    let largest = ImageSize::new(16_384, 1).unwrap();
    assert_eq!((largest.width(), largest.height()), (16_384, 1));
}

#[test]
fn scene() {
    let scene =
        |spheres: &[Sphere], planes: &[Plane]| Scene::new(spheres.to_vec(), planes.to_vec());
    let (ball, wall) = (sphere([0.0; 3], 1.0), plane([0.0; 3], [0.0, 0.0, 1.0]));
    assert_says(
        scene(&[ball, sphere([0.0, INF, 1.0], 1.0)], &[]),
        "sphere 1: center is (0, inf, 1): every coordinate must be a finite number",
    );
    for (radius, text) in [(0.0, "0"), (-2.0, "-2"), (NAN, "NaN"), (INF, "inf")] {
        let message = format!("sphere 0: radius is {text}: it must be finite and greater than 0");
        assert_says(scene(&[sphere([0.0; 3], radius)], &[wall]), &message);
    }
    assert_says(
        scene(&[ball], &[wall, wall, plane([NAN, 0.0, 0.0], [0.0, 0.0, 1.0])]),
        "plane 3: point is (NaN, 0, 0): every coordinate must be a finite number",
    );
    assert_says(
        scene(&[], &[plane([0.0; 3], [0.0, -INF, 0.5])]),
        "plane 0: normal is (0, -inf, 0.5): every coordinate must be a finite number",
    );
    assert_says(
        scene(&[], &[plane([0.0; 3], [0.0, -0.0, 0.0])]),
        "plane 0: normal is (0, 0, 0): it must point somewhere",
    );
    assert!(scene(&[sphere([0.0; 3], 5e-324)], &[plane([0.0; 3], [5e-324, 0.0, 0.0])]).is_ok());
}

#[test]
fn ray() {
    let ray = |origin: [f64; 3], direction: [f64; 3]| Ray {
        origin: DVec3::from_array(origin),
        direction: DVec3::from_array(direction),
    };
    assert_says(
        ray([0.0, INF, 0.0], [0.0; 3]).check(),
        "origin is (0, inf, 0): every coordinate must be a finite number",
    );
    assert_says(
        ray([0.0; 3], [0.1, NAN, 0.0]).check(),
        "direction is (0.1, NaN, 0): every coordinate must be a finite number",
    );
    assert_says(
        ray([0.0; 3], [0.0, 0.0, -0.0]).check(),
        "direction is (0, 0, 0): it must point somewhere",
    );
    assert_eq!(ray([1e300; 3], [0.0, 0.0, 5e-324]).check(), Ok(()));
}

/// An invalid ray that was not checked with [`Ray::check`] hits nothing, and does not cause a panic.
#[test]
fn an_unchecked_ray_meets_nothing() {
    let scene = Scene::new(
        vec![sphere([0.0, 0.0, -5.0], 1.0), sphere([0.0; 3], 1e300)],
        vec![plane([0.0, 0.0, -6.0], [0.0, 0.0, 1.0])],
    )
    .unwrap();
    let sound = Ray { origin: DVec3::ZERO, direction: DVec3::NEG_Z };
    assert_eq!(roots_of(&scene, &sound).len(), 5);
    for bad in [NAN, INF, -INF] {
        for axis in 0..3 {
            let mut ray = sound;
            ray.origin[axis] = bad;
            assert_eq!(roots_of(&scene, &ray), []);
            let mut ray = sound;
            ray.direction[axis] = bad;
            assert_eq!(roots_of(&scene, &ray), []);
            assert_eq!(scene.first_hit(&ray), None);
        }
    }
    assert_eq!(roots_of(&scene, &Ray { direction: DVec3::ZERO, ..sound }), []);
}
