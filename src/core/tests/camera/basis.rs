//! Tests of the camera's basis against arithmetic of 1200 binary digits, and of conversions between the
//! ways to specify an orientation.

use pinhole_core::*;
use proptest::prelude::*;

use crate::common::oracle::Big3;
use crate::common::seed::config;
use crate::common::{oracle, up_angle, vec3};

/// Maximum error of the coordinates of u, v and w; twice as much is allowed for the deviation of their
/// dot products from 0 and 1.
const BASIS_TOLERANCE: f64 = 6e-16;

fn direction() -> impl Strategy<Value = DVec3> {
    let coordinate = || prop_oneof![4 => -1.0..1.0_f64, 1 => Just(0.0), 1 => Just(1.0)];
    [coordinate(), coordinate(), coordinate()]
        .prop_map(DVec3::from_array)
        .prop_filter("points somewhere", |d| d.length() > 1e-3)
}

/// Generates lengths, half of them ordinary and half of them from 1e-300 to 1e300.
fn length() -> impl Strategy<Value = f64> {
    prop_oneof![(-3.0..3.0), (-300.0..300.0)].prop_map(|e: f64| 10_f64.powf(e))
}

/// Generates view and up vectors of any lengths, at angles down to 1e-8 rad.
fn view_and_up() -> impl Strategy<Value = (DVec3, DVec3)> {
    (direction(), direction(), prop_oneof![Just(1.0), (-8.0..0.0).prop_map(|e| 10_f64.powf(e))])
        .prop_filter("has an angle", |(view, other, _)| {
            view.normalize().cross(other.normalize()).length() > 1e-2
        })
        .prop_flat_map(|(view, other, angle)| {
            let up = view.normalize() + angle * other.normalize();
            (Just(view), Just(up), length(), length(), any::<bool>())
        })
        .prop_map(|(view, up, view_length, up_length, opposite)| {
            (view * view_length, up * if opposite { -up_length } else { up_length })
        })
}

#[track_caller]
fn assert_exact(basis: &Basis, exact: &[Big3; 3]) {
    for (vector, exact) in [basis.u, basis.v, basis.w].into_iter().zip(exact) {
        let error = exact.error_of(vector);
        assert!(error <= BASIS_TOLERANCE, "{vector:?} is {error:e} off in {basis:?}");
    }
    let Basis { u, v, w } = *basis;
    for (a, b, expected) in
        [(u, u, 1.0), (v, v, 1.0), (w, w, 1.0), (u, v, 0.0), (v, w, 0.0), (w, u, 0.0)]
    {
        let defect = (a.dot(b) - expected).abs();
        assert!(defect <= 2.0 * BASIS_TOLERANCE, "defect {defect:e} in {basis:?}");
    }
    assert!(u.cross(v).dot(w) > 0.0, "left-handed: {basis:?}");
}

proptest! {
    #![proptest_config(config(3000))]

    #[test]
    fn from_view_and_up((view, up) in view_and_up()) {
        let exact = oracle::basis(&view.into(), &up.into()).unwrap();
        assert_exact(&Basis::from_view_up(view, up).unwrap(), &exact);
    }

    #[test]
    fn coordinates_are_the_exact_ones_rounded((view, up) in view_and_up()) {
        assert_rounded(view, up);
    }

    #[test]
    fn from_eye_at_and_up(
        (view, up) in view_and_up(), eye in direction(), share in -12.0..14.0_f64,
    ) {
        // The eye is up to 1e14 times the view's length away from the origin, so `at - eye` is not
        // exact in `f64`; the basis must be exact all the same.
        let eye = eye * view.length() * 10_f64.powf(share);
        let at = eye + view;
        prop_assume!(at.is_finite() && at != eye);
        let exact_view = Big3::from(at).minus(&eye.into());
        match oracle::basis(&exact_view, &up.into()) {
            Some(exact) => assert_exact(&Basis::from_eye_at_up(eye, at, up).unwrap(), &exact),
            None => {
                let parallel = Basis::from_eye_at_up(eye, at, up);
                assert!(matches!(parallel, Err(BasisError::UpParallelToView { .. })), "{parallel:?}");
            }
        }
    }

    /// Vectors of small integers are often parallel. They are reported as parallel if and only if they
    /// are exactly so.
    #[test]
    fn parallel_is_exactly_parallel(
        view in [-3..4_i32, -3..4, -3..4], up in [-3..4_i32, -3..4, -3..4],
        a in -900..900_i32, b in -900..900_i32,
    ) {
        let scaled = |v: [i32; 3], k: i32| DVec3::from_array(v.map(f64::from)) * 2_f64.powi(k);
        let (view, up) = (scaled(view, a), scaled(up, b));
        prop_assume!(view != DVec3::ZERO && up != DVec3::ZERO);
        let exact = oracle::basis(&view.into(), &up.into());
        match (Basis::from_view_up(view, up), exact) {
            (Ok(basis), Some(exact)) => assert_exact(&basis, &exact),
            (Err(BasisError::UpParallelToView { .. }), None) => {}
            (basis, exact) => panic!("{basis:?}, exactly {exact:?}"),
        }
    }

    #[test]
    fn angle_and_conditioning((view, up) in view_and_up()) {
        let UpAngle { angle, conditioning } = up_angle(view, up).unwrap();
        let (a, b) = (Big3::from(view).unit(), Big3::from(up).unit());
        let cross = a.cross(&b);
        let sine = oracle::near(&cross.dot(&cross).sqrt());
        let cosine = oracle::near(&a.dot(&b));
        prop_assert!((angle - sine.atan2(cosine)).abs() <= 1e-15 * angle);
        prop_assert!((conditioning * sine - 1.0).abs() <= 1e-15);
    }
}

/// Asserts that each coordinate of the basis is the `f64` nearest to the exact one.
#[track_caller]
fn assert_rounded(view: DVec3, up: DVec3) {
    let [view_given, up_given] = [view, up].map(|v| v.to_array());
    let orientation = pinhole_reference::Orientation::View { view: view_given, up: up_given };
    let exact = pinhole_reference::basis([0.0; 3], &orientation).unwrap();
    let Basis { u, v, w } = Basis::from_view_up(view, up).unwrap();
    for (vector, exact) in [u, v, w].into_iter().zip(&exact) {
        let rounded = exact.each_ref().map(|x| x.to_f64() + 0.0);
        assert_eq!(
            vector.to_array().map(f64::to_bits),
            rounded.map(f64::to_bits),
            "{view:?} {up:?}"
        );
    }
}

#[test]
fn coordinates_that_cancel_are_rounded_once() {
    assert_rounded(
        vec3(0.5819291090097687, 0.7869026585197236, -0.46707756089566654),
        vec3(-0.49370439915520836, -0.2754363501509441, -0.1978375597648636),
    );
    // Here, v.y is 1e-40 and 1e-17 times the other coordinates.
    assert_rounded(vec3(1.0, 1e-40, 0.0), vec3(1.0, 1e-40, 1.0));
    assert_rounded(vec3(0.1, 0.2, 0.3), vec3(0.3, 0.6, 0.9 + 1e-16));
}

#[test]
fn directions_are_the_exact_ones_rounded() {
    let camera = Camera {
        eye: vec3(3.0, 4.0, 5.0),
        orientation: Orientation::View { view: vec3(-1e-300, 0.3, -2.5e-3), up: DVec3::Y },
        viewport: Viewport { width: 2e300, height: 1.5, distance: 1e297 },
        ..Camera::CANONICAL
    };
    let resolved = camera.resolve().unwrap();
    let exact = pinhole_reference::Camera {
        eye: camera.eye.to_array(),
        orientation: pinhole_reference::Orientation::View {
            view: [-1e-300, 0.3, -2.5e-3],
            up: [0.0, 1.0, 0.0],
        },
        width: 2e300,
        height: 1.5,
        distance: 1e297,
        columns: camera.image.width(),
        rows: camera.image.height(),
    };
    let exact = exact.prepare(&[]).unwrap();
    for (row, column) in [(0, 0), (199, 200), (7, 399)] {
        let ray = resolved.exact_ray(Pixel { row, column }).rounded();
        let direction = exact.direction_of_pixel(row, column).map(|x| x.to_f64() + 0.0);
        assert_eq!(ray.direction.to_array(), direction, "{row}, {column}");
    }
}

#[test]
fn up_almost_parallel_to_view_is_still_exact() {
    for up in [vec3(1e-14, 0.0, -1.0), vec3(1e-300, 0.0, -1.0), vec3(5e-324, 0.0, 1e300)] {
        let basis = Basis::from_view_up(DVec3::NEG_Z, up).unwrap();
        // Up leans to +x, which is therefore up in the image.
        assert_eq!(basis, Basis { u: DVec3::NEG_Y, v: DVec3::X, w: DVec3::Z });
    }
}

#[test]
fn extreme_angles_are_numbers() {
    let between = |up| up_angle(DVec3::NEG_Z, up).unwrap();
    let quarter = between(DVec3::X);
    assert_eq!(quarter, UpAngle { angle: std::f64::consts::FRAC_PI_2, conditioning: 1.0 });
    assert_eq!(between(vec3(1e-300, 0.0, -1.0)).angle, 1e-300);
    assert_eq!(between(vec3(1e-300, 0.0, 1.0)).angle, std::f64::consts::PI);
    assert_eq!(between(vec3(5e-324, 0.0, -1e300)).conditioning, f64::MAX);
}

fn assert_same_basis(before: &Camera, after: &Camera, tolerance: f64) {
    let (a, b) = (before.basis().unwrap(), after.basis().unwrap());
    for (a, b) in [(a.u, b.u), (a.v, b.v), (a.w, b.w)] {
        let turned = (a - b).abs().max_element();
        assert!(turned <= tolerance, "{turned:e} from {before:?} to {after:?}");
    }
    assert_eq!(
        (before.eye, before.viewport, before.image),
        (after.eye, after.viewport, after.image)
    );
}

const KINDS: [OrientationKind; 3] =
    [OrientationKind::At, OrientationKind::View, OrientationKind::Basis];

proptest! {
    #![proptest_config(config(1000))]

    /// Two conversions in succession, between any ways to specify an orientation, turn the basis by at
    /// most a few ulps times the condition number of up.
    #[test]
    fn switching_converts_and_nothing_jumps(
        (view, up) in view_and_up(), eye in direction(), reach in -12.0..13.0_f64,
        first in 0..3_usize, second in 0..3_usize, third in 0..3_usize,
    ) {
        let eye = eye * 10_f64.powf(reach);
        let camera = Camera { eye, orientation: Orientation::View { view, up }, ..Camera::CANONICAL };
        let mut camera = camera.given_by(KINDS[first]).unwrap();
        for kind in [KINDS[second], KINDS[third]] {
            let converted = camera.given_by(kind).unwrap();
            prop_assert_eq!(converted.orientation.kind(), kind);
            let conditioning = camera.up_angle().unwrap().conditioning;
            assert_same_basis(&camera, &converted, 3.0 * Camera::TURN_TOLERANCE * conditioning);
            camera = converted;
        }
    }
}

#[test]
fn at_is_a_view_away_where_that_keeps_the_direction() {
    let given = |eye, view| {
        let orientation = Orientation::View { view, up: DVec3::Y };
        let camera = Camera { eye, orientation, ..Camera::CANONICAL };
        let Orientation::At { at, .. } = camera.given_by(OrientationKind::At)?.orientation else {
            panic!("not given by at")
        };
        Ok::<DVec3, BasisError>(at)
    };
    let (eye, view) = (vec3(20.0, 4.0, 10.0), vec3(-21.0, -4.0, -15.0));
    assert_eq!(given(eye, view), Ok(vec3(-1.0, 0.0, -5.0)));
    // Rounding `eye + view` at 1e12 would turn the direction by 1e-5, so at is placed farther away, by
    // a power of two.
    let (eye, view) = (vec3(1e12, 0.0, 0.0), vec3(0.6, 0.0, -0.8));
    let at = given(eye, view).unwrap();
    let reach = (at.z / -0.8).log2();
    assert_eq!(reach.fract(), 0.0);
    assert!(reach > 30.0 && reach < 41.0, "2^{reach} views away");
    // If the point would be beyond the largest `f64`, there is none to look at.
    let eye = vec3(f64::MAX, 0.0, 0.0);
    assert_eq!(given(eye, DVec3::X), Err(BasisError::EyeIsAt { point: eye }));
}

#[test]
fn a_camera_without_a_basis_converts_and_still_has_none() {
    let with = |orientation| Camera { orientation, ..Camera::CANONICAL };
    let parallel = with(Orientation::View { view: DVec3::NEG_Z, up: DVec3::Z });
    let at = parallel.given_by(OrientationKind::At).unwrap();
    assert_eq!(at.orientation, Orientation::At { at: DVec3::NEG_Z, up: DVec3::Z });
    assert_eq!(at.given_by(OrientationKind::View).unwrap(), parallel);
    let error = BasisError::UpParallelToView { up: DVec3::Z, view: DVec3::NEG_Z };
    assert_eq!(parallel.given_by(OrientationKind::Basis), Err(error));
    assert_eq!(at.basis(), Err(error));

    let nowhere = with(Orientation::View { view: DVec3::ZERO, up: DVec3::Y });
    let at = nowhere.given_by(OrientationKind::At).unwrap();
    assert_eq!(at.basis(), Err(BasisError::EyeIsAt { point: DVec3::ZERO }));
    assert_eq!(at.given_by(OrientationKind::View).unwrap(), nowhere);

    // A left-handed basis becomes the right-handed one with the same view and up.
    let mirrored = Basis { u: DVec3::NEG_X, ..Basis::CANONICAL };
    let camera = with(Orientation::Basis(mirrored));
    assert_eq!(camera.basis(), Err(BasisError::LeftHanded));
    let converted = camera.given_by(OrientationKind::At).unwrap();
    assert_eq!(converted.basis(), Ok(Basis::CANONICAL));
}

#[test]
fn eye_and_at_at_the_ends_of_the_range() {
    let (eye, at) = (vec3(-1.7e308, 0.0, 1.7e308), vec3(1.7e308, 0.0, 1.7e308));
    let basis = Basis::from_eye_at_up(eye, at, DVec3::Y).unwrap();
    assert_eq!(basis, Basis { u: DVec3::Z, v: DVec3::Y, w: DVec3::NEG_X });
    let camera =
        Camera { eye, orientation: Orientation::At { at, up: DVec3::Y }, ..Camera::CANONICAL };
    let view = camera.given_by(OrientationKind::View).unwrap();
    assert_eq!(view.basis(), Ok(basis));
    let (eye, at) = (vec3(5e-324, 0.0, 0.0), DVec3::ZERO);
    let basis = Basis::from_eye_at_up(eye, at, vec3(0.0, 1e300, 0.0)).unwrap();
    assert_eq!(basis, Basis { u: DVec3::NEG_Z, v: DVec3::Y, w: DVec3::X });
}
