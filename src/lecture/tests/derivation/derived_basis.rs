//! The basis's derivation.

use std::f64::consts::{FRAC_PI_2, PI};

use pinhole_core::*;
use pinhole_lecture::{BasisByHand, BasisDerivation, BasisFromUp};
use pinhole_reference::{Real, basis};
use proptest::prelude::*;

use super::{EXERCISE, vector};
use crate::common::oracle::{Big, Big3, big, near};
use crate::common::{assert_ulps, assert_ulps3, bases, given, vec3};
use crate::config;

fn from_up(camera: &Camera) -> BasisFromUp {
    match BasisDerivation::new(camera) {
        BasisDerivation::FromUp(from_up) => from_up,
        BasisDerivation::ByHand(_) => panic!("{camera:?} has an up"),
    }
}

fn by_hand(u: DVec3, v: DVec3, w: DVec3) -> BasisByHand {
    let orientation = Orientation::Basis(Basis { u, v, w });
    match BasisDerivation::new(&Camera { orientation, ..Camera::CANONICAL }) {
        BasisDerivation::ByHand(by_hand) => by_hand,
        BasisDerivation::FromUp(_) => panic!("u, v, w are set by hand"),
    }
}

fn looking(view: DVec3, up: DVec3) -> Camera {
    Camera { orientation: Orientation::View { view, up }, ..Camera::CANONICAL }
}

#[test]
fn the_exercise_line_by_line() {
    let derived = from_up(&EXERCISE);
    assert_eq!((derived.eye, derived.at), (vec3(20.0, 4.0, 10.0), Some(vec3(-1.0, 0.0, -5.0))));
    let view = derived.view.unwrap();
    assert_eq!((view.vector, view.length), (vec3(-21.0, -4.0, -15.0), 682_f64.sqrt()));
    assert_eq!(derived.backwards, Some(vec3(21.0, 4.0, 15.0)));
    let w = derived.w.unwrap();
    assert_ulps3(w, vec3(21.0, 4.0, 15.0) / 682_f64.sqrt(), 1);
    let up = derived.up.unwrap();
    assert_eq!((up.vector, up.length), (DVec3::Y, 1.0));
    let across = derived.up_cross_w.unwrap();
    assert_eq!((across.first, across.second.vector, across.second.length), (up, w, 1.0));
    assert_ulps3(across.product, vec3(15.0, 0.0, -21.0) / 682_f64.sqrt(), 1);
    assert_ulps(across.area, (666.0_f64 / 682.0).sqrt(), 1);
    assert_eq!(across.sine, Some(across.area));
    assert_ulps(across.angle.unwrap(), (4.0 / 682_f64.sqrt()).acos(), 2);
    assert_ulps3(derived.u.unwrap(), vec3(5.0, 0.0, -7.0) / 74_f64.sqrt(), 1);
    let last = derived.w_cross_u.unwrap();
    assert_eq!((last.first.vector, last.second.vector), (w, derived.u.unwrap()));
    assert_ulps3(last.product, vec3(-14.0, 111.0, -10.0) / 12617_f64.sqrt(), 1);
    assert_eq!((last.area, last.sine, last.angle), (1.0, Some(1.0), Some(FRAC_PI_2)));
    let found = derived.basis.unwrap();
    assert_eq!(Ok(found), EXERCISE.basis());
    assert_eq!([derived.u, derived.w, Some(last.product)], [found.u, found.w, found.v].map(Some));
}

#[test]
fn a_tilted_up_makes_a_parallelogram() {
    // 60 degrees between up and backwards, lengths 4 and 2.
    let derived = from_up(&looking(vec3(0.0, 0.0, -2.0), vec3(0.0, 2.0 * 3_f64.sqrt(), 2.0)));
    let across = derived.up_cross_w.unwrap();
    assert_ulps(across.first.length, 4.0, 1);
    assert_ulps(across.angle.unwrap(), PI / 3.0, 2);
    assert_ulps(across.sine.unwrap(), 0.75_f64.sqrt(), 1);
    assert_ulps(across.area, 12_f64.sqrt(), 1);
    assert_ulps3(across.product, vec3(12_f64.sqrt(), 0.0, 0.0), 1);
    assert_eq!(derived.backwards, Some(vec3(0.0, 0.0, 2.0)));
    assert_eq!(derived.u, Some(DVec3::X));
}

/// Tests at which step the derivation of an impossible basis stops, and with which reason.
#[test]
fn a_derivation_goes_as_far_as_it_can() {
    let at = vec3(1.0, 2.0, 3.0);
    let camera =
        Camera { eye: at, orientation: Orientation::At { at, up: DVec3::Y }, ..Camera::CANONICAL };
    let derived = from_up(&camera);
    assert_eq!(derived.view.map(|view| (view.vector, view.length)), Some((DVec3::ZERO, 0.0)));
    assert_eq!((derived.backwards, derived.w), (Some(DVec3::ZERO), None));
    assert_eq!((derived.up_cross_w, derived.u, derived.w_cross_u), (None, None, None));
    assert_eq!(derived.basis, Err(BasisError::EyeIsAt { point: at }));

    for (factor, angle) in [(3.0, PI), (-0.1, 0.0)] {
        let view = vec3(1.0, 2.0, 2.0);
        let up = factor * view;
        let derived = from_up(&looking(view, up));
        assert_ulps3(derived.w.unwrap(), vec3(-1.0, -2.0, -2.0) / 3.0, 0);
        let across = derived.up_cross_w.unwrap();
        assert_eq!((across.product, across.area), (DVec3::ZERO, 0.0));
        assert_eq!((across.sine, across.angle), (Some(0.0), Some(angle)));
        assert_eq!((derived.u, derived.w_cross_u), (None, None));
        assert_eq!(derived.basis, Err(BasisError::UpParallelToView { up, view }));
    }

    let derived = from_up(&looking(DVec3::NEG_Z, DVec3::ZERO));
    let across = derived.up_cross_w.unwrap();
    assert_eq!((derived.w, across.product, across.area), (Some(DVec3::Z), DVec3::ZERO, 0.0));
    assert_eq!((across.angle, across.sine), (None, None));
    assert_eq!(derived.basis, Err(BasisError::UpIsZero));

    let derived = from_up(&looking(vec3(f64::NAN, 0.0, 0.0), DVec3::Y));
    assert_eq!((derived.view, derived.w, derived.up_cross_w), (None, None, None));
    assert!(matches!(derived.basis, Err(BasisError::NotFinite { field: "view", .. })));
    let derived = from_up(&looking(DVec3::NEG_Z, vec3(0.0, f64::INFINITY, 0.0)));
    assert_eq!((derived.w, derived.up, derived.up_cross_w), (Some(DVec3::Z), None, None));
    assert!(matches!(derived.basis, Err(BasisError::NotFinite { field: "up", .. })));
}

/// Returns `|x - truth|` in ulps at `truth`.
fn ulps_off(x: f64, truth: &Big) -> f64 {
    let unit = near(truth).abs().max(f64::MIN_POSITIVE);
    let unit = unit.next_up() - unit;
    (near(&(truth - big(x))) / unit).abs()
}

fn check_against_oracle(camera: &Camera, view: &Big3, up: DVec3) -> Result<(), TestCaseError> {
    let derived = from_up(camera);
    prop_assert_eq!(derived.basis, camera.basis());
    let up = Big3::from(up);
    let root = |x: Big| x.sqrt();
    let w = view.times(&big(-1.0)).unit();
    let across = up.cross(&w);
    let length = root(view.dot(view));
    let given = derived.view.unwrap();
    prop_assert!(ulps_off(given.length, &length) <= 0.51);
    let found = derived.up_cross_w.unwrap();
    let area = root(across.dot(&across));
    prop_assert!(ulps_off(found.area, &area) <= 0.51, "{} {}", found.area, near(&area));
    prop_assert!(ulps_off(found.first.length, &root(up.dot(&up))) <= 0.51);
    let sine = &area / root(up.dot(&up));
    prop_assert!(ulps_off(found.sine.unwrap(), &sine) <= 0.51);
    for i in 0..3 {
        prop_assert!(ulps_off(given.vector[i], &view.0[i]) <= 0.5);
        prop_assert!(ulps_off(found.product[i], &across.0[i]) <= 0.51, "{:?}", found.product);
        prop_assert!(ulps_off(derived.w.unwrap()[i], &w.0[i]) <= 0.51);
    }
    // The angle, by its sine and cosine.
    let angle = found.angle.unwrap();
    let cosine = near(&(up.dot(&w) / root(up.dot(&up))));
    prop_assert!((angle.cos() - cosine).abs() < 1e-15);
    prop_assert!((angle.sin() - near(&sine)).abs() < 1e-15);
    Ok(())
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn every_number_is_right_of_any_lengths(
        view in vector(-290.0..290.0), up in vector(-290.0..290.0),
        eye in vector(-3.0..3.0), at in vector(-3.0..3.0),
    ) {
        check_against_oracle(&looking(view, up), &view.into(), up)?;
        let orientation = Orientation::At { at, up };
        let camera = Camera { eye, orientation, ..Camera::CANONICAL };
        check_against_oracle(&camera, &Big3::from(at).minus(&eye.into()), up)?;
    }

    /// No digits of `up x w` are lost by cancellation, even if up is nearly parallel to the view.
    #[test]
    fn an_up_close_to_the_view_costs_no_digits(
        view in vector(-2.0..2.0), aside in vector(-2.0..2.0), power in -15.0..0.0_f64,
        side in prop::bool::ANY,
    ) {
        let up = if side { view } else { -view } + aside * 10_f64.powf(power);
        let camera = looking(view, up);
        prop_assume!(camera.basis().is_ok());
        check_against_oracle(&camera, &view.into(), up)?;
    }

    /// The checks of a basis that is set by hand, taken together, accept it if and only if
    /// [`Basis::by_hand`] does.
    #[test]
    fn the_checks_by_hand_decide_as_the_door_does(
        view in vector(-1.0..1.0), up in vector(-1.0..1.0), noise in vector(-14.0..-6.0),
        k in 0..3_usize, mirrored in prop::bool::ANY,
    ) {
        let Basis { u, v, w } = Basis::from_view_up(view, up).unwrap();
        let mut set = [if mirrored { -u } else { u }, v, w];
        set[k] += noise;
        let [u, v, w] = set;
        let checked = by_hand(u, v, w);
        let passes = checked.lengths.iter().flatten().all(|check| check.passes)
            && checked.dots.iter().flatten().all(|check| check.passes)
            && checked.handedness.unwrap().passes;
        prop_assert_eq!(passes, checked.basis.is_ok(), "{:?}", checked);
        prop_assert_eq!(checked.basis, Basis::by_hand(u, v, w));
        let length = Big3::from(u).dot(&u.into()).sqrt();
        prop_assert!(ulps_off(checked.lengths[0].unwrap().value, &length) <= 0.51);
        let product = Big3::from(v).dot(&w.into());
        prop_assert!(ulps_off(checked.dots[1].unwrap().value, &product) <= 0.5);
        prop_assert_eq!(checked.handedness.unwrap().value > 0.0, !mirrored);
    }
}

/// Compares the derived vectors with those of the exact reference for difficult cameras: eye and at far
/// from the origin, up nearly parallel to the view, extreme lengths.
#[test]
fn the_vectors_are_those_of_the_reference() {
    let mut vectors = 0;
    for family in &bases::FAMILIES {
        for &knob in family.knobs {
            for case in family.cases(knob, 5, 10) {
                let orientation = given::orientation(&case.orientation);
                let camera = Camera { eye: case.eye.into(), orientation, ..Camera::CANONICAL };
                let BasisDerivation::FromUp(derived) = BasisDerivation::new(&camera) else {
                    continue;
                };
                let Ok([u, v, w]) = basis(case.eye, &case.orientation) else {
                    assert!(derived.basis.is_err() && derived.u.is_none());
                    continue;
                };
                let across = derived.w_cross_u.unwrap();
                let found = [derived.u.unwrap(), across.product, derived.w.unwrap()];
                for (truth, found) in [u, v, w].iter().zip(found) {
                    let off = |i: usize| truth[i].minus(&Real::from(found[i])).to_f64().abs();
                    assert!((0..3).all(|i| off(i) <= 1.2e-16), "{camera:?}");
                    vectors += 1;
                }
                // Each step is a number, whatever the lengths.
                let up_cross_w = derived.up_cross_w.unwrap();
                assert!(up_cross_w.area > 0.0 && up_cross_w.sine.unwrap() > 0.0);
                assert!(up_cross_w.product.is_finite() && up_cross_w.product != DVec3::ZERO);
            }
        }
    }
    assert!(vectors > 300, "{vectors}");
}

#[test]
fn extreme_lengths_do_not_overflow() {
    let derived = from_up(&looking(vec3(3e300, 0.0, -4e300), vec3(0.0, 1e-300, 0.0)));
    assert_ulps(derived.view.unwrap().length, 5e300, 1);
    let across = derived.up_cross_w.unwrap();
    assert_eq!(across.area, 1e-300);
    assert_ulps3(across.product, vec3(8e-301, 0.0, 6e-301), 1);
    let derived = from_up(&looking(vec3(3e-300, 0.0, -4e-300), vec3(0.0, 1e300, 0.0)));
    assert_ulps(derived.view.unwrap().length, 5e-300, 1);
    assert_eq!(derived.up_cross_w.unwrap().area, 1e300);
}

#[test]
fn a_basis_by_hand_is_checked_number_by_number() {
    let s = 0.5_f64.sqrt();
    let right = by_hand(vec3(s, 0.0, -s), DVec3::Y, vec3(s, 0.0, s));
    assert!(right.basis.is_ok());
    assert_eq!(right.dots.map(|check| check.unwrap().value), [0.0; 3]);
    assert!(right.lengths.iter().all(|check| (check.unwrap().value - 1.0).abs() < 2e-16));
    assert!((right.handedness.unwrap().value - 1.0).abs() < 4e-16);

    // Typed from the blackboard: 0.7071 is not 1/sqrt 2.
    let x = 7071.0 / 10_000.0;
    let typed = by_hand(vec3(x, 0.0, -x), DVec3::Y, vec3(x, 0.0, x));
    let [u, v, w] = typed.lengths.map(Option::unwrap);
    assert_eq!((u.passes, v.passes, w.passes), (false, true, false));
    assert_ulps(u.value, 2_f64.sqrt() * x, 1);
    assert!(typed.dots.iter().all(|check| check.unwrap().passes));
    assert!(matches!(typed.basis, Err(BasisError::NotUnit { vector: "u", .. })));

    let mirrored = by_hand(DVec3::NEG_X, DVec3::Y, DVec3::Z);
    let handedness = mirrored.handedness.unwrap();
    assert_eq!(handedness.value, -1.0);
    assert!(!handedness.passes);
    assert_eq!(mirrored.basis, Err(BasisError::LeftHanded));

    let broken = by_hand(vec3(f64::NAN, 0.0, 0.0), DVec3::Y, DVec3::Z);
    assert_eq!((broken.lengths[0], broken.dots[0], broken.handedness), (None, None, None));
    assert!(broken.dots[1].unwrap().passes && broken.basis.is_err());
    // Sums of products of 1e308 are not NaN.
    let huge = by_hand(vec3(1e200, 1e200, 0.0), vec3(1e200, -1e200, 0.0), DVec3::Z);
    assert_eq!(huge.dots[0].unwrap().value, 0.0);
    assert!(!huge.lengths[0].unwrap().passes);
}
