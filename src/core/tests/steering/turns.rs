//! Orbit and look round.

use std::f64::consts::{FRAC_PI_2, PI};

use pinhole_core::steering::*;
use pinhole_core::*;
use proptest::prelude::*;

use super::{
    angle, any_camera, assert_valid, calm_camera, given_up, is_calm, pivot, pole_gap, v_turn, vec3,
};
use crate::common::seed::config;

type Turning = fn(&Camera, f64, f64) -> Result<Camera, SteerError>;

const TURNS: [Turning; 2] = [Camera::orbited, Camera::looked_round];

fn small_or_large_angle() -> impl Strategy<Value = f64> {
    prop_oneof![-7.0..7.0_f64, -0.05..0.05_f64, Just(0.0)]
}

fn by_view(view: DVec3, up: DVec3) -> Camera {
    Camera { orientation: Orientation::View { view, up }, ..Camera::CANONICAL }
}

/// The canonical camera, given in all three ways.
fn canonical() -> [Camera; 3] {
    [OrientationKind::At, OrientationKind::View, OrientationKind::Basis]
        .map(|kind| Camera::CANONICAL.given_by(kind).unwrap())
}

#[test]
fn a_positive_yaw_orbits_to_the_right_and_looks_to_the_left() {
    for camera in canonical() {
        let orbited = camera.orbited(FRAC_PI_2, 0.0).unwrap();
        assert!((orbited.eye - vec3(1.0, 0.0, -1.0)).length() < 1e-15);
        assert!((orbited.view() - DVec3::NEG_X).length() < 1e-15);
        let looking = camera.looked_round(FRAC_PI_2, 0.0).unwrap();
        assert!((looking.view() - DVec3::NEG_X).length() < 1e-15);
        assert_eq!(looking.eye, DVec3::ZERO);
    }
}

#[test]
fn a_positive_pitch_orbits_down_and_looks_up() {
    for camera in canonical() {
        let down = camera.orbited(0.0, 0.5).unwrap().eye;
        assert!((down - vec3(0.0, -0.5_f64.sin(), 0.5_f64.cos() - 1.0)).length() < 1e-15);
        let up = camera.looked_round(0.0, 0.5).unwrap().view();
        assert!((up - vec3(0.0, 0.5_f64.sin(), -0.5_f64.cos())).length() < 1e-15);
    }
}

#[test]
fn turns_stop_short_of_the_poles() {
    for turn in TURNS {
        for (pitch, expected) in [(3.0, POLE_GAP), (-3.0, PI - POLE_GAP)] {
            let camera = turn(&Camera::CANONICAL, 0.0, pitch).unwrap();
            assert!((camera.up_angle().unwrap().angle - expected).abs() < 1e-13);
        }
        // Nearer already: not nearer still, but away.
        let steep = by_view(vec3(0.0, 1.0, -1e-3), DVec3::Y);
        assert_eq!(turn(&steep, 0.0, 0.5).unwrap(), steep);
        let away = turn(&steep, 0.0, -0.5).unwrap();
        assert!((pole_gap(&away) - 0.5 - 1e-3_f64.atan()).abs() < 1e-13);
    }
}

#[test]
fn a_camera_by_hand_orbits_at_its_viewport_distance() {
    let viewport = Viewport { distance: 0.0, ..Viewport::CANONICAL };
    let orientation = Orientation::Basis(Basis::CANONICAL);
    let no_viewport = Camera { orientation, viewport, ..Camera::CANONICAL };
    assert!(matches!(no_viewport.orbited(1.0, 0.0), Err(SteerError::Camera(_))));
    assert!(no_viewport.looked_round(1.0, 0.0).is_ok());
}

#[test]
fn what_cannot_be_turned_is_refused() {
    for turn in TURNS {
        let error = turn(&Camera::CANONICAL, f64::NAN, 0.0).unwrap_err();
        assert_eq!(error.to_string(), "yaw is NaN: it must be a finite number");
        let by_hand = Camera::CANONICAL.given_by(OrientationKind::Basis).unwrap();
        assert!(turn(&by_hand, 1e308, 1.7e308).is_err());
        let broken = by_view(DVec3::Y, DVec3::Y);
        assert_eq!(turn(&broken, 0.1, 0.1), Err(broken.basis().unwrap_err().into()));
    }
    // A world unit away from at, 1e17 from the origin: the eye cannot turn by less than that.
    let far = Camera {
        eye: vec3(1e17, 0.0, 0.0),
        orientation: Orientation::At { at: vec3(1e17, 0.0, -1.0), up: DVec3::Y },
        ..Camera::CANONICAL
    };
    assert!(matches!(far.orbited(0.3, 0.0), Err(SteerError::Unsteady { .. })));
    assert_eq!(far.orbited(0.0, 0.0), Ok(far));
}

#[test]
fn a_drag_in_the_picture_takes_it_along() {
    let camera = Camera::CANONICAL;
    let project = |camera: &Camera, point| camera.resolve().unwrap().project(point).uv;
    // What is level with the eye, and what is straight above the middle.
    for (from, to) in [((0.3, 0.0), (-0.4, 0.0)), ((0.0, -0.1), (0.0, 0.45))] {
        let (from, to) = (DVec2::from(from), DVec2::from(to));
        let (yaw, pitch) = camera.viewport.look_of_drag(from, to);
        let looked = camera.looked_round(yaw, pitch).unwrap();
        assert!(project(&looked, from.extend(-1.0)).distance(to) < 1e-15);
        // The near side of what is orbited follows the hand.
        let (yaw, pitch) = camera.viewport.orbit_of_drag(from, to);
        let orbited = camera.orbited(yaw, pitch).unwrap();
        let near = vec3(0.0, 0.0, -0.9);
        let moved = project(&orbited, near) - project(&camera, near);
        assert!(moved.normalize().dot((to - from).normalize()) > 1.0 - 1e-12);
    }
    let once = camera.viewport.orbit_of_drag(DVec2::ZERO, DVec2::new(1.0, 0.5));
    assert_eq!(once, (-PI, FRAC_PI_2));
}

proptest! {
    #![proptest_config(config(10_000))]

    #[test]
    fn v_turns_by_no_more_than_the_hand(
        camera in any_camera(),
        yaw in small_or_large_angle(),
        pitch in small_or_large_angle(),
        kind in 0..2_usize,
    ) {
        let calm = is_calm(&camera);
        let turned = match TURNS[kind](&camera, yaw, pitch) {
            Ok(turned) => turned,
            Err(error) => {
                prop_assert!(!calm && matches!(error, SteerError::Unsteady { .. }), "{}", error);
                return Ok(());
            }
        };
        assert_valid(&turned);
        let rounding = if calm { 1e-12 } else { ROUNDING_TURN };
        prop_assert!(v_turn(&camera, &turned) <= yaw.abs() + pitch.abs() + rounding);
        prop_assert_eq!(given_up(&camera).is_some(), given_up(&turned).is_some());
        if let Some(up) = given_up(&camera) {
            prop_assert_eq!(Some(up), given_up(&turned));
            let least = pole_gap(&camera).min(POLE_GAP);
            prop_assert!(pole_gap(&turned) >= least - rounding);
        }
        if kind == 1 {
            prop_assert_eq!(camera.eye, turned.eye);
        } else if let Orientation::At { .. } = camera.orientation {
            prop_assert_eq!(camera.orientation, turned.orientation);
        }
    }

    #[test]
    fn an_orbit_keeps_its_distance(
        camera in any_camera(), yaw in small_or_large_angle(), pitch in small_or_large_angle(),
    ) {
        let Ok(turned) = camera.orbited(yaw, pitch) else {
            return Ok(());
        };
        let (before, after) = match camera.orientation {
            Orientation::At { at, .. } => ((camera.eye - at).length(), (turned.eye - at).length()),
            _ => (camera.view().length(), turned.view().length()),
        };
        let coordinates = match camera.orientation {
            Orientation::At { .. } => turned.eye.abs().to_array().map(|x| 0.5 * x * f64::EPSILON),
            _ => [0.0; 3],
        };
        let rounding = DVec3::from_array(coordinates).length();
        prop_assert!((before - after).abs() <= 4.0 * f64::EPSILON * before + rounding);
        let (from, to) = (pivot(&camera), pivot(&turned));
        let far = camera.eye.length() + before;
        prop_assert!((from - to).length() <= 32.0 * f64::EPSILON * far);
    }

    #[test]
    fn there_and_back_again(
        camera in calm_camera(), yaw in -3.0..3.0_f64, pitch in -3.0..3.0_f64, kind in 0..2_usize,
    ) {
        let angle = camera.up_angle().unwrap().angle;
        let is_by_hand = given_up(&camera).is_none();
        let is_between = |angle| (POLE_GAP..PI - POLE_GAP).contains(&angle);
        let goes_free = is_between(angle) && is_between(angle - pitch);
        if !(is_by_hand || goes_free) {
            return Ok(());
        }
        let turn = TURNS[kind];
        let back = turn(&turn(&camera, yaw, pitch).unwrap(), -yaw, -pitch).unwrap();
        let far = camera.eye.length() + camera.eye.distance(pivot(&camera));
        prop_assert!((back.eye - camera.eye).length() <= 1e-12 * far);
        prop_assert!(v_turn(&back, &camera) < 1e-11);
    }

    #[test]
    fn turns_that_differ_little_end_alike(
        camera in calm_camera(),
        yaw in small_or_large_angle(),
        pitch in small_or_large_angle(),
        differ in (-1e-6..1e-6_f64, -1e-6..1e-6_f64),
        kind in 0..2_usize,
    ) {
        let a = TURNS[kind](&camera, yaw, pitch).unwrap();
        let b = TURNS[kind](&camera, yaw + differ.0, pitch + differ.1).unwrap();
        let most = differ.0.abs() + differ.1.abs() + 1e-11;
        prop_assert!(v_turn(&a, &b) <= most);
        prop_assert!(angle(a.view(), b.view()) <= most);
        prop_assert!(a.eye.distance(b.eye) <= most * camera.eye.distance(pivot(&camera)));
    }
}
