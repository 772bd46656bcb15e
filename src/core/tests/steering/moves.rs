//! Dolly and zoom.

use pinhole_core::steering::*;
use pinhole_core::*;
use proptest::prelude::*;

use super::{assert_valid, calm_camera, v_turn, vec3};
use crate::common::seed::config;

#[test]
fn a_dolly_never_reaches_at() {
    let camera = Camera {
        orientation: Orientation::At { at: vec3(0.0, 0.0, -8.0), up: DVec3::Y },
        ..Camera::CANONICAL
    };
    let near = camera.dollied(2_f64.ln()).unwrap();
    assert!((near.eye - vec3(0.0, 0.0, -4.0)).length() < 1e-14);
    assert_eq!(near.orientation, camera.orientation);
    let nearest = camera.dollied(30.0).unwrap();
    assert!(nearest.eye.z > -8.0);
    let error = camera.dollied(1000.0).unwrap_err();
    assert_eq!(error, BasisError::EyeIsAt { point: vec3(0.0, 0.0, -8.0) }.into());
    let error = camera.dollied(-1000.0).unwrap_err();
    assert!(matches!(
        error,
        SteerError::Camera(CameraError::Basis(BasisError::NotFinite { field: "eye", .. }))
    ));
}

#[test]
fn by_view_and_by_hand_the_dolly_travels() {
    let orientation = Orientation::View { view: vec3(0.0, 0.0, -2.0), up: DVec3::Y };
    let by_view = Camera { orientation, ..Camera::CANONICAL };
    assert_eq!(by_view.dollied(1.5).unwrap(), Camera { eye: vec3(0.0, 0.0, -3.0), ..by_view });
    let viewport = Viewport { distance: 4.0, ..Viewport::CANONICAL };
    let orientation = Orientation::Basis(Basis::CANONICAL);
    let by_hand = Camera { orientation, viewport, ..Camera::CANONICAL };
    assert_eq!(by_hand.dollied(-0.5).unwrap(), Camera { eye: vec3(0.0, 0.0, 2.0), ..by_hand });
}

#[test]
fn a_zoom_opens_the_field_of_view() {
    let wide = Camera::CANONICAL.zoomed(2.0).unwrap();
    assert_eq!(wide.viewport, Viewport { width: 2.0, height: 2.0, distance: 1.0 });
    assert_eq!(wide.viewport.vertical_fov(), std::f64::consts::FRAC_PI_2);
    assert_eq!(Camera { viewport: Viewport::CANONICAL, ..wide }, Camera::CANONICAL);
    for factor in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = Camera::CANONICAL.zoomed(factor);
        assert!(matches!(refused, Err(SteerError::NotPositive { field: "factor", .. })));
    }
    assert!(matches!(wide.zoomed(1e308), Err(SteerError::Camera(CameraError::Viewport(_)))));
}

proptest! {
    #![proptest_config(config(2000))]

    #[test]
    fn dollies_add_up_and_do_not_turn(camera in calm_camera(), a in -2.0..2.0_f64, b in -2.0..2.0_f64) {
        let at_once = camera.dollied(a + b).unwrap();
        let in_two = camera.dollied(a).unwrap().dollied(b).unwrap();
        let back = camera.dollied(a).unwrap().dollied(-a).unwrap();
        let reach = camera.eye.distance(camera.pivot().unwrap());
        let rounding = 1e-12 * (camera.eye.length() + 10.0 * reach);
        prop_assert!(at_once.eye.distance(in_two.eye) <= rounding);
        prop_assert!(back.eye.distance(camera.eye) <= rounding);
        assert_valid(&at_once);
        prop_assert!(v_turn(&camera, &at_once) < 1e-9);
    }

    #[test]
    fn a_small_dolly_is_a_small_step(camera in calm_camera(), forward in -1e-6..1e-6_f64) {
        let reach = camera.eye.distance(camera.pivot().unwrap());
        let step = camera.dollied(forward).unwrap().eye - camera.eye;
        let expected = -forward * reach * camera.basis().unwrap().w;
        prop_assert!((step - expected).length() <= 1e-12 * reach);
    }
}
