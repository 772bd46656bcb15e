//! Cameras that differ in a single parameter.

use pinhole_core::steering::SteerError;
use pinhole_core::*;
use pinhole_reference as reference;
use proptest::prelude::*;

use super::vec3;
use crate::common::seed::config;
use crate::common::{assert_ulps3, ulps, vector};

/// The lecture's exercise.
const EXERCISE: Camera = Camera {
    eye: DVec3::new(20.0, 4.0, 10.0),
    orientation: Orientation::At { at: DVec3::new(-1.0, 0.0, -5.0), up: DVec3::Y },
    ..Camera::CANONICAL
};

fn looking(view: DVec3, up: DVec3) -> Camera {
    Camera { orientation: Orientation::View { view, up }, ..Camera::CANONICAL }
}

/// Given by at, by view, by hand.
fn any_camera() -> impl Strategy<Value = Camera> {
    (vector(-3.0..3.0), vector(-3.0..3.0), vector(-1.0..1.0), 0..3_usize)
        .prop_map(|(view, up, eye, kind)| {
            let camera = Camera { eye, ..looking(view, up) };
            let kinds = [OrientationKind::At, OrientationKind::View, OrientationKind::Basis];
            camera.given_by(kinds[kind]).unwrap()
        })
        .prop_filter("up well away from the view", |camera| {
            camera.up_angle().is_ok_and(|up| up.conditioning < 100.0)
        })
}

#[test]
fn the_canonical_camera_swings() {
    let by_view = looking(DVec3::NEG_Z, vec3(0.0, 2.0, 0.0));
    let swung = by_view.swung(90.0).unwrap();
    let up = vec3(-2.0, 0.0, 0.0);
    assert_eq!(swung.orientation, Orientation::View { view: DVec3::NEG_Z, up });
    let Basis { u, v, w } = swung.basis().unwrap();
    assert_eq!((u, v, w), (DVec3::Y, DVec3::NEG_X, DVec3::Z));
    assert_eq!(by_view.swung(-270.0).unwrap(), swung);
    assert_eq!(by_view.swung(180.0).unwrap().up(), vec3(0.0, -2.0, 0.0));
    for whole in [0.0, 360.0, -720.0] {
        assert_eq!(EXERCISE.swung(whole), Ok(EXERCISE));
    }
    assert_ulps3(by_view.swung(45.0).unwrap().up(), vec3(-1.0, 1.0, 0.0) * 2_f64.sqrt(), 1);

    let by_hand = by_view.given_by(OrientationKind::Basis).unwrap().swung(90.0).unwrap();
    let basis = Basis { u: DVec3::Y, v: DVec3::NEG_X, w: DVec3::Z };
    assert_eq!(by_hand.orientation, Orientation::Basis(basis));
    assert!(matches!(
        EXERCISE.swung(f64::NAN),
        Err(SteerError::NotFinite { field: "the angle", .. })
    ));
    let broken = looking(DVec3::NEG_Z, DVec3::Z).swung(5.0).unwrap_err();
    assert_eq!(
        broken.to_string(),
        looking(DVec3::NEG_Z, DVec3::Z).basis().unwrap_err().to_string()
    );
}

#[test]
fn up_tilts_towards_the_view_and_breaks() {
    let camera = looking(DVec3::NEG_Z, DVec3::Y);
    let up = camera.up_tilted(30.0).unwrap().up();
    assert_ulps3(up, vec3(0.0, 0.5, -0.75_f64.sqrt()), 1);
    assert_eq!(camera.up_tilted(90.0).unwrap(), camera);
    let found = camera.up_tilted(1e-9).unwrap().up_angle().unwrap();
    assert!((found.angle.to_degrees() / 1e-9 - 1.0).abs() < 1e-15);
    for (degrees, up) in [(0.0, DVec3::NEG_Z), (180.0, DVec3::Z)] {
        let error = BasisError::UpParallelToView { up, view: DVec3::NEG_Z };
        assert_eq!(camera.up_tilted(degrees), Err(SteerError::Camera(error.into())));
    }
    for degrees in [-1.0, 181.0, 400.0] {
        assert!(camera.up_tilted(degrees).is_err());
    }
    // Closer than the rounding of up can say: a view that is on no axis.
    let slanted = looking(vec3(1.0, 2.0, 2.0), DVec3::Y);
    let tilted = slanted.up_tilted(1e-30);
    assert!(tilted.is_err() || tilted.unwrap().up_angle().unwrap().conditioning > 1e14);
    let by_hand = camera.given_by(OrientationKind::Basis).unwrap();
    assert_eq!(by_hand.up_tilted(30.0), Err(SteerError::NoUp));
}

proptest! {
    #![proptest_config(config(1000))]

    /// A swing of up turns u and v by the angle, and changes neither w nor the way in which the
    /// orientation is specified.
    #[test]
    fn a_swing_turns_u_and_v_about_w(camera in any_camera(), degrees in -400.0..400.0_f64) {
        let swung = camera.swung(degrees).unwrap();
        prop_assert_eq!(swung.orientation.kind(), camera.orientation.kind());
        prop_assert_eq!((swung.eye, swung.view()), (camera.eye, camera.view()));
        let (before, after) = (camera.basis().unwrap(), swung.basis().unwrap());
        prop_assert_eq!(after.w, before.w);
        let (sin, cos) = degrees.to_radians().sin_cos();
        let before_up = camera.up_angle().unwrap();
        let off = 5e-16 * before_up.conditioning + 1e-15;
        prop_assert!((after.v - (cos * before.v - sin * before.u)).length() <= off);
        prop_assert!((after.u - (cos * before.u + sin * before.v)).length() <= off);
        prop_assert!((swung.up().length() / camera.up().length() - 1.0).abs() <= 1e-15);
        let after_up = swung.up_angle().unwrap();
        prop_assert!((after_up.angle - before_up.angle).abs() <= 1e-15);
    }

    /// A tilt of up sets the requested angle between up and view, and does not change the basis.
    #[test]
    fn a_tilt_sets_the_angle_and_keeps_the_basis(
        camera in any_camera(), power in -6.0..0.0_f64, obtuse in any::<bool>(),
    ) {
        prop_assume!(camera.orientation.kind() != OrientationKind::Basis);
        let degrees = 90.0 * 10_f64.powf(power);
        let degrees = if obtuse { 180.0 - degrees } else { degrees };
        let tilted = camera.up_tilted(degrees).unwrap();
        prop_assert_eq!(tilted.orientation.kind(), camera.orientation.kind());
        let found = tilted.up_angle().unwrap();
        prop_assert!((found.angle - degrees.to_radians()).abs() <= 8e-16);
        prop_assert!((tilted.up().length() / camera.up().length() - 1.0).abs() <= 1e-15);
        let (before, after) = (camera.basis().unwrap(), tilted.basis().unwrap());
        prop_assert_eq!(after.w, before.w);
        let off = (after.u - before.u).length().max((after.v - before.v).length());
        prop_assert!(off <= 5e-16 * found.conditioning, "{off:e} at {:?}", found);
    }

    /// Scaling the viewport's width, height and distance by a factor leaves the picture unchanged, and
    /// divides t by the factor.
    #[test]
    fn a_scaled_picture_is_the_same(
        camera in any_camera(), distance in 0.01..100.0_f64, row in 0..400_u32, column in 0..400_u32,
    ) {
        let viewport = Viewport { width: 2.0, height: 1.5, distance: 0.7 };
        let camera = Camera { viewport, ..camera };
        let scaled = camera.scaled_picture(distance).unwrap();
        prop_assert_eq!(scaled.viewport.distance, distance);
        prop_assert_eq!(Camera { viewport, ..scaled }, camera);
        let (before, after) = (camera.resolve().unwrap(), scaled.resolve().unwrap());
        let pixel = Pixel { row, column };
        let (one, other) = (before.ray_of_pixel(pixel), after.ray_of_pixel(pixel));
        let factor = distance / 0.7;
        let off = (one.direction * factor - other.direction).length();
        prop_assert!(off <= 2e-15 * other.direction.length());
        let scene = Scene::new(vec![], vec![Plane { point: camera.eye + camera.view(), normal: camera.view() }]).unwrap();
        let t = |camera: &ResolvedCamera| scene.ranked_roots_of(&camera.exact_ray(pixel))[0].root.t;
        prop_assert!((t(&before) / t(&after) / factor - 1.0).abs() <= 1e-14);
    }

}

#[test]
fn the_canonical_picture_scales_exactly() {
    let scaled = Camera::CANONICAL.scaled_picture(0.3).unwrap().viewport;
    assert_eq!(scaled, Viewport { width: 0.3, height: 0.3, distance: 0.3 });
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(Camera::CANONICAL.scaled_picture(bad).is_err());
    }
    let viewport = Viewport { width: 1e300, height: 1.0, distance: 1e-10 };
    let error = Camera { viewport, ..Camera::CANONICAL }.scaled_picture(1.0).unwrap_err();
    assert_eq!(error.field, "width");
    let empty = Viewport { height: 0.0, ..Viewport::CANONICAL };
    let error = Camera { viewport: empty, ..Camera::CANONICAL }.scaled_picture(1.0).unwrap_err();
    assert_eq!(error.field, "height");
}

/// A swing of an extremely long or short up vector does not overflow, and agrees with the reference.
#[test]
fn swings_of_ups_of_any_length() {
    for size in [1e-300, 1.0, 1e300] {
        let camera = looking(vec3(0.0, 3.0, -4.0), size * vec3(1.0, 2.0, 0.5));
        let swung = camera.swung(37.0).unwrap();
        let up = swung.up();
        let ratio = up / size;
        assert!((ratio.length() - 5.25_f64.sqrt()).abs() < 1e-15, "{up:?}");
        let given = reference::Orientation::View { view: [0.0, 3.0, -4.0], up: up.to_array() };
        let [u, ..] = reference::basis([0.0; 3], &given).unwrap();
        let before = camera.basis().unwrap();
        let (sin, cos) = 37_f64.to_radians().sin_cos();
        let wanted = cos * before.u + sin * before.v;
        assert!(reference::angle_between(&u, wanted.to_array()) < 5e-16);
        assert!(ulps(ratio.dot(before.w), (camera.up() / size).dot(before.w)) < 16);
    }
}

#[test]
fn a_picture_is_scaled_as_the_measure_that_was_edited() {
    let before = Viewport { width: 2.0, height: 1.0, distance: 4.0 };
    let camera = Camera { viewport: before, ..Camera::CANONICAL };
    let tripled = Viewport { width: 6.0, height: 3.0, distance: 12.0 };
    for edited in [
        Viewport { width: 6.0, ..before },
        Viewport { height: 3.0, ..before },
        Viewport { distance: 12.0, ..before },
    ] {
        assert_eq!(camera.picture_scaled_as(&before, &edited).unwrap().viewport, tripled);
    }
    let none = Viewport { width: 0.0, ..before };
    assert!(camera.picture_scaled_as(&before, &none).is_err());
}
