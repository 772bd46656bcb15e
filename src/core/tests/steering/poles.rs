//! Tests of dragging eye and at anywhere, including over the poles, where the view is parallel to up.

use std::f64::consts::FRAC_PI_2;

use pinhole_core::steering::*;
use pinhole_core::*;
use proptest::prelude::*;
use proptest::strategy::ValueTree;

use super::{
    any_camera, assert_valid, calm_camera, direction, given_up, is_calm, pivot, pole_gap, v_turn,
    vec3, view_turn,
};
use crate::common::seed::config;

fn eye_dragged(camera: &Camera, point: DVec3, keep: Keep) -> Result<Steered, SteerError> {
    camera.led_to(camera.with_eye(point, keep), keep)
}

fn at_dragged(camera: &Camera, point: DVec3) -> Result<Steered, SteerError> {
    camera.led_to(camera.with_at(point), Keep::At)
}

/// Drags the eye (if `is_eye` is true) or at by `offset`, in units of the distance between them.
fn dragged(camera: &Camera, offset: DVec3, is_eye: bool) -> Result<Steered, SteerError> {
    let pivot = super::pivot(camera);
    let offset = offset * camera.eye.distance(pivot);
    if is_eye {
        eye_dragged(camera, camera.eye + offset, Keep::At)
    } else {
        at_dragged(camera, pivot + offset)
    }
}

/// Generates short and long offsets for [`dragged`], from 1e-6 to 10 times the distance from eye to at.
fn offset() -> impl Strategy<Value = DVec3> {
    (direction(), -6.0..1.0_f64).prop_map(|(direction, power)| 10_f64.powf(power) * direction)
}

/// Returns a position of the eye on the unit sphere around at: on a vertical circle whose highest point
/// is `beside` degrees away from straight above at, and `degrees` along the circle from there.
fn eye_over_the_top(degrees: f64, beside: f64) -> DVec3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let (aside, along) = beside.to_radians().sin_cos();
    vec3(aside, along * cos, along * sin)
}

fn over_the_top(degrees: f64, beside: f64) -> Camera {
    Camera {
        eye: eye_over_the_top(degrees, beside),
        orientation: Orientation::At { at: DVec3::ZERO, up: 3.0 * DVec3::Y },
        ..Camera::CANONICAL
    }
}

#[test]
fn an_eye_dragged_over_the_top_takes_up_along_and_does_not_flip() {
    for beside in [0.0, 1.0, 4.9, 5.1, 30.0] {
        let (mut camera, mut went_along) = (over_the_top(60.0, beside), false);
        let start = camera;
        for step in 1..=1200 {
            let eye = eye_over_the_top(60.0 - 0.1 * f64::from(step), beside);
            let next = eye_dragged(&camera, eye, Keep::At).unwrap();
            let turn = view_turn(&camera, &next.camera);
            let most = if next.up_went_along { turn + 1e-12 } else { turn / CONE.sin() };
            // The step that enters or leaves the cone does both.
            let crosses = next.up_went_along != went_along;
            let most = if crosses { turn / CONE.sin() } else { most };
            assert!(v_turn(&camera, &next.camera) <= most, "{beside} {step}");
            assert!(pole_gap(&next.camera) > CONE - 1e-9);
            (camera, went_along) = (next.camera, next.up_went_along);
        }
        let up = given_up(&camera).unwrap();
        if beside >= 5.0 {
            assert_eq!(camera.orientation, start.orientation);
        } else {
            // Upside down on the other side, and as far from upright as up was pushed.
            assert!(camera.basis().unwrap().v.y < 0.0 && went_along, "{beside}");
            assert!((up.length() - 3.0).abs() < 1e-12);
        }
    }
}

#[test]
fn in_one_go_or_in_many_steps_straight_over_the_top() {
    let start = over_the_top(60.0, 0.0);
    let at_once = eye_dragged(&start, eye_over_the_top(-60.0, 0.0), Keep::At).unwrap();
    assert!(at_once.up_went_along);
    let mut camera = start;
    for degrees in (-60..60).rev() {
        let eye = eye_over_the_top(f64::from(degrees), 0.0);
        camera = eye_dragged(&camera, eye, Keep::At).unwrap().camera;
    }
    assert!(v_turn(&camera, &at_once.camera) < 1e-12);
    let (one, other) = (given_up(&camera).unwrap(), given_up(&at_once.camera).unwrap());
    assert!(one.distance(other) < 1e-12);
    // Pushed from where the eye came within 5 degrees of the top: by 60 degrees and 5.
    let (sin, cos) = 65_f64.to_radians().sin_cos();
    assert!(other.distance(3.0 * vec3(0.0, cos, -sin)) < 1e-12);
    assert!((v_turn(&start, &camera) - 120_f64.to_radians()).abs() < 1e-12);
}

#[test]
fn a_camera_within_the_cone_gets_out_again() {
    let start = over_the_top(1.0, 0.0);
    for beside in [0.0, 20.0, -20.0] {
        let out = eye_dragged(&start, eye_over_the_top(40.0, beside), Keep::At).unwrap();
        assert!(out.up_went_along);
        assert!(pole_gap(&out.camera) > 30_f64.to_radians());
    }
    // Straight away from the pole, up stays but for rounding.
    let away = eye_dragged(&start, eye_over_the_top(40.0, 0.0), Keep::At).unwrap().camera;
    assert!(given_up(&away).unwrap().distance(3.0 * DVec3::Y) < 1e-12);
    assert_eq!(eye_dragged(&away, away.eye, Keep::At).unwrap().camera, away);
}

#[test]
fn straight_through_at_it_turns_round_and_stays_upright() {
    let camera = Camera { eye: DVec3::Z, ..over_the_top(0.0, 0.0) };
    let turned = eye_dragged(&camera, DVec3::NEG_Z, Keep::At).unwrap();
    assert!(!turned.up_went_along);
    assert_eq!(turned.camera.basis().unwrap().v, DVec3::Y);
    let by_hand = camera.given_by(OrientationKind::Basis).unwrap();
    let pivot = super::pivot(&by_hand);
    let turned = eye_dragged(&by_hand, pivot - 5.0 * DVec3::Z, Keep::At).unwrap().camera;
    assert_eq!(turned.basis().unwrap().v, DVec3::Y);
    assert!((turned.basis().unwrap().w - DVec3::NEG_Z).length() < 1e-15);
}

#[test]
fn a_basis_by_hand_turns_by_the_least_turn() {
    let by_hand = Camera { orientation: Orientation::Basis(Basis::CANONICAL), ..Camera::CANONICAL };
    // Straight up from two units below the pivot.
    let up = eye_dragged(&by_hand, vec3(0.0, -2.0, -1.0), Keep::At).unwrap();
    assert!(!up.up_went_along);
    let Basis { u, v, w } = up.camera.basis().unwrap();
    assert_eq!(u, DVec3::X);
    assert!((v - DVec3::Z).length() < 1e-15 && (w - DVec3::NEG_Y).length() < 1e-15);
    let pivoted = eye_dragged(&by_hand, vec3(1.0, 0.0, -1.0), Keep::At).unwrap().camera;
    assert!((pivoted.view() - DVec3::NEG_X).length() < 1e-15);
    assert!((pivot(&pivoted) - pivot(&by_hand)).length() < 1e-15);
}

#[test]
fn eye_on_at_is_an_error_with_its_numbers() {
    let camera = over_the_top(60.0, 0.0);
    let error = eye_dragged(&camera, DVec3::ZERO, Keep::At).unwrap_err();
    assert_eq!(error.to_string(), "eye and at are the same point (0, 0, 0): move one of them");
    assert_eq!(
        at_dragged(&camera, camera.eye),
        Err(BasisError::EyeIsAt { point: camera.eye }.into())
    );
    for kind in [OrientationKind::View, OrientationKind::Basis] {
        let canonical = Camera::CANONICAL.given_by(kind).unwrap();
        assert!(eye_dragged(&canonical, DVec3::NEG_Z, Keep::At).is_err());
        let is_by_hand = kind == OrientationKind::Basis;
        assert_eq!(at_dragged(&canonical, canonical.eye).is_ok(), is_by_hand);
        assert_eq!(at_dragged(&canonical, vec3(f64::NAN, 0.0, 0.0)).is_ok(), is_by_hand);
    }
}

#[test]
fn a_camera_without_a_basis_is_led_out_of_it() {
    let collapsed = Camera { eye: DVec3::ZERO, ..over_the_top(60.0, 0.0) };
    assert!(collapsed.basis().is_err());
    let eye = vec3(1.0, 2.0, 3.0);
    for keep in [Keep::At, Keep::View] {
        let led = eye_dragged(&collapsed, eye, keep);
        assert_eq!(led.is_ok(), keep == Keep::At);
    }
    let led = eye_dragged(&collapsed, eye, Keep::At).unwrap();
    assert_eq!((led.camera, led.up_went_along), (Camera { eye, ..collapsed }, false));
    let parallel = over_the_top(0.0, 0.0);
    assert!(parallel.basis().is_err());
    assert!(at_dragged(&parallel, DVec3::X).is_ok());
    assert!(at_dragged(&parallel, vec3(0.0, -7.0, 0.0)).is_err());
}

/// Makes one drag, of one of five kinds, and returns the camera and the maximum angle by which it may
/// turn v, apart from rounding errors.
fn one_drag(camera: &Camera, kind: usize, offset: DVec3) -> Result<(Camera, f64), SteerError> {
    let DVec3 { x: yaw, y: pitch, .. } = offset;
    let hand = yaw.abs() + pitch.abs();
    Ok(match kind {
        0 => (camera.orbited(yaw, pitch)?, hand),
        1 => (camera.looked_round(yaw, pitch)?, hand),
        2 => {
            let reach = camera.eye.distance(pivot(camera));
            (eye_dragged(camera, camera.eye + reach * offset, Keep::View)?.camera, 0.0)
        }
        _ => {
            let after = dragged(camera, offset, kind == 3)?.camera;
            let view = view_turn(camera, &after);
            (after, if given_up(camera).is_some() { view / CONE.sin() } else { view })
        }
    })
}

/// A camera stays valid while it is dragged 10,000 times in succession.
#[test]
fn ten_thousand_drags_leave_a_valid_camera() {
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    for kind in [OrientationKind::At, OrientationKind::View, OrientationKind::Basis] {
        let mut camera = over_the_top(60.0, 10.0).given_by(kind).unwrap();
        let mut refused = 0;
        for _ in 0..10_000 {
            let (which, offset) = (0..5_usize, offset()).new_tree(&mut runner).unwrap().current();
            let Ok((after, most)) = one_drag(&camera, which, offset) else {
                refused += 1;
                continue;
            };
            assert_valid(&after);
            assert!(v_turn(&camera, &after) <= most + 1e-8, "{which} {offset} {camera:?}");
            let reach = after.eye.distance(pivot(&after));
            // Not off into the distance, nor into at.
            if (1e-2..1e2).contains(&reach) && after.eye.length() < 1e3 {
                camera = after;
            }
        }
        assert_eq!(refused, 0);
    }
}

proptest! {
    #![proptest_config(config(10_000))]

    /// However far, however near the poles.
    #[test]
    fn v_turns_by_no_more_than_the_view_over_the_sine_of_the_cone(
        camera in any_camera(), offset in offset(), is_eye in any::<bool>(),
    ) {
        let steered = match dragged(&camera, offset, is_eye) {
            Ok(steered) => steered,
            Err(error) => {
                prop_assert!(matches!(error, SteerError::Unsteady { .. }), "{}", error);
                prop_assert!(!is_calm(&camera));
                return Ok(());
            }
        };
        let after = steered.camera;
        assert_valid(&after);
        let (turn, view) = (v_turn(&camera, &after), view_turn(&camera, &after));
        let rounding = if is_calm(&camera) && is_calm(&after) { 1e-12 } else { ROUNDING_TURN };
        match given_up(&camera) {
            // By hand, the least turn.
            None => prop_assert!(turn <= view + rounding),
            Some(up) => {
                prop_assert!(turn <= view / CONE.sin() + rounding, "{} {}", turn, view);
                let within = [&camera, &after].iter().all(|camera| pole_gap(camera) < CONE);
                if within && view < FRAC_PI_2 {
                    prop_assert!(turn <= view + rounding, "{} {}", turn, view);
                }
                if steered.up_went_along {
                    let length = given_up(&after).unwrap().length();
                    prop_assert!((length / up.length() - 1.0).abs() < 1e-15);
                } else {
                    prop_assert_eq!(given_up(&after), Some(up));
                    prop_assert!(pole_gap(&after) >= CONE - 1e-9);
                }
            }
        }
    }

    /// A small drag never makes a camera jump.
    #[test]
    fn a_small_drag_is_a_small_change(
        camera in any_camera(), direction in direction(), is_eye in any::<bool>(),
    ) {
        let Ok(steered) = dragged(&camera, 1e-6 * direction, is_eye) else {
            prop_assert!(!is_calm(&camera));
            return Ok(());
        };
        let turn = v_turn(&camera, &steered.camera);
        prop_assert!(turn <= 1.01e-6 / CONE.sin() + ROUNDING_TURN);
        let calm = is_calm(&camera) && pole_gap(&camera) > 2e-3;
        prop_assert!(!calm || turn <= 1.01e-6 / CONE.sin() + 1e-11);
    }

    /// A drag to a point and back ends with the camera with which it began, unless it changed up.
    #[test]
    fn outside_the_cone_there_and_back_again(
        camera in calm_camera(), offset in offset(), is_eye in any::<bool>(),
    ) {
        let Ok(steered) = dragged(&camera, offset, is_eye) else {
            return Ok(());
        };
        if given_up(&camera).is_none() || steered.up_went_along {
            return Ok(());
        }
        let back = match (is_eye, camera.orientation) {
            (true, _) => eye_dragged(&steered.camera, camera.eye, Keep::At),
            (false, Orientation::At { at, .. }) => at_dragged(&steered.camera, at),
            (false, _) => at_dragged(&steered.camera, camera.eye + camera.view()),
        }
        .unwrap();
        prop_assert!(!back.up_went_along);
        prop_assert_eq!(back.camera.eye, camera.eye);
        prop_assert!(v_turn(&camera, &back.camera) < 1e-11);
    }

    #[test]
    fn a_travelling_eye_turns_nothing(camera in calm_camera(), offset in offset()) {
        let reach = camera.eye.distance(pivot(&camera));
        let eye = camera.eye + reach * offset;
        let Steered { camera: after, up_went_along, .. } =
            eye_dragged(&camera, eye, Keep::View).unwrap();
        prop_assert!(!up_went_along);
        prop_assert_eq!(after.eye, eye);
        prop_assert!(v_turn(&camera, &after) < 1e-10);
        prop_assert!(after.view().distance(camera.view()) < 1e-12 * (reach + eye.length()));
        prop_assert_eq!(after.viewport, camera.viewport);
    }
}
