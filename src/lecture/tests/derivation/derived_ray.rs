//! The view ray's derivation.

use pinhole_core::*;
use pinhole_lecture::RayDerivation;
use pinhole_reference::angle_between;
use proptest::prelude::*;

use super::{AT_45_DEGREES, vector};
use crate::common::{assert_ulps, assert_ulps3, frames, given, ulps, vec3};
use crate::config;

#[test]
fn the_warm_up_and_the_turned_camera() {
    let uv = DVec2::new(0.2, -0.1);
    let resolved = Camera::CANONICAL.resolve().unwrap();
    let derived = RayDerivation::new(&resolved, Selection::Uv(uv)).unwrap();
    assert_eq!((derived.pixel, derived.uv, derived.ray.origin), (None, uv, DVec3::ZERO));
    assert_eq!(derived.along_u, vec3(0.2, 0.0, 0.0));
    assert_eq!(derived.along_v, vec3(0.0, -0.1, 0.0));
    assert_eq!(derived.along_w, DVec3::NEG_Z);
    assert_eq!(derived.ray.direction, vec3(0.2, -0.1, -1.0));
    assert_ulps(derived.length, 1.05_f64.sqrt(), 1);
    assert_eq!(derived.ray, resolved.ray(uv));

    let s = 0.5_f64.sqrt();
    let derived = RayDerivation::new(&AT_45_DEGREES.resolve().unwrap(), Selection::Uv(uv)).unwrap();
    assert_ulps3(derived.along_u, vec3(0.2 * s, 0.0, -0.2 * s), 1);
    assert_ulps3(derived.along_w, vec3(-s, 0.0, -s), 1);
    assert_ulps3(derived.ray.direction, vec3(-0.8 * s, -0.1, -1.2 * s), 1);
}

#[test]
fn a_pixel_and_its_ray() {
    let resolved = Camera::CANONICAL.resolve().unwrap();
    let pixel = Pixel { row: 99, column: 199 };
    let derived = RayDerivation::new(&resolved, Selection::Pixel(pixel)).unwrap();
    assert_eq!(derived.pixel, Some(pixel));
    assert_eq!(derived.uv, DVec2::new(-1.0 / 800.0, 201.0 / 800.0));
    assert_eq!(derived.ray.direction, vec3(-1.0 / 800.0, 201.0 / 800.0, -1.0));
    assert_eq!(derived.ray, resolved.exact_ray(pixel).rounded());
    assert!(RayDerivation::new(&resolved, Selection::Uv(DVec2::new(f64::NAN, 0.0))).is_err());
}

proptest! {
    #![proptest_config(config(500))]

    /// The direction equals the sum of its three components up to rounding, since each component, and
    /// the direction itself, is rounded once.
    #[test]
    fn the_parts_make_the_direction(
        view in vector(-3.0..3.0), up in vector(-3.0..3.0),
        (width, height, distance) in (0.1..10.0_f64, 0.1..10.0_f64, 0.1..10.0_f64),
        row in 0..60_u32, column in 0..80_u32,
    ) {
        let camera = Camera {
            orientation: Orientation::View { view, up },
            viewport: Viewport { width, height, distance },
            image: ImageSize::new(80, 60).unwrap(),
            ..Camera::CANONICAL
        };
        let resolved = camera.resolve().unwrap();
        let derived = RayDerivation::new(&resolved, Selection::Pixel(Pixel { row, column })).unwrap();
        let RayDerivation { along_u, along_v, along_w, ray: Ray { direction, .. }, .. } = derived;
        let sum = along_u + along_v + along_w;
        let size = along_u.abs() + along_v.abs() + along_w.abs();
        let off = (sum - direction).abs();
        prop_assert!((0..3).all(|i| off[i] <= 4.0 * f64::EPSILON * size[i]), "{off:?}");
        let Basis { u, v, w } = *resolved.basis();
        for (part, factor, axis) in
            [(along_u, derived.uv.x, u), (along_v, derived.uv.y, v), (along_w, -distance, w)]
        {
            for i in 0..3 {
                prop_assert!(ulps(part[i], factor * axis[i]) <= 3, "{part:?} {axis:?}");
            }
        }
        prop_assert!(ulps(derived.length, direction.length()) <= 2);
    }
}

/// Compares with the reference's frames, including extreme measures.
#[test]
fn the_direction_is_that_of_the_reference() {
    let mut rays = 0;
    for family in &frames::FAMILIES {
        for &knob in family.knobs {
            for case in family.cases(knob, 5, 2) {
                let Ok(view) = case.camera.prepare(&[]) else { continue };
                let resolved = given::camera(&case.camera).resolve().unwrap();
                let pixel = Pixel { row: 1, column: 2 };
                let derived = RayDerivation::new(&resolved, Selection::Pixel(pixel)).unwrap();
                let truth = view.direction_of_pixel(1, 2);
                let off = angle_between(&truth, derived.ray.direction.to_array());
                assert!(off <= 1.7e-16, "{off:e} {}", family.name);
                assert!(derived.length > 0.0 && derived.length.is_finite());
                rays += 1;
            }
        }
    }
    assert!(rays > 30, "{rays}");
}

#[test]
fn extreme_measures_do_not_overflow() {
    for size in [1e-300, 1e300] {
        let viewport = Viewport { width: 2.0 * size, height: size, distance: 3.0 * size };
        let resolved = Camera { viewport, ..Camera::CANONICAL }.resolve().unwrap();
        let derived =
            RayDerivation::new(&resolved, Selection::Pixel(Pixel { row: 0, column: 0 })).unwrap();
        assert_ulps3(derived.along_u, vec3(-399.0 / 400.0 * size, 0.0, 0.0), 1);
        assert_ulps3(derived.along_v, vec3(0.0, 399.0 / 800.0 * size, 0.0), 1);
        assert_eq!(derived.along_w, vec3(0.0, 0.0, -3.0 * size));
        assert!(derived.length / size > 3.0 && derived.length / size < 4.0);
    }
}
