//! Tests that what is exported is read back, whatever the camera's measures: for every format that import reads.

use pinhole_core::{Camera, DVec3, ImageSize, Orientation, Viewport};
use pinhole_exchange::format::{ExportScene, Include};
use proptest::prelude::*;

use super::{Importer, format, read, scene_of};

/// A measure of any size, or an ordinary one.
fn measure() -> BoxedStrategy<f64> {
    let any = (-300.0..=300.0).prop_map(|exponent| 10_f64.powf(exponent));
    prop_oneof![any, Just(1e-300), Just(1e300), Just(1e-17), 0.1..10.0].boxed()
}

fn vector() -> impl Strategy<Value = DVec3> {
    let component = || (-1.0..1.0, measure()).prop_map(|(sign, size)| f64::signum(sign) * size);
    let ordinary = || (-2.0..2.0, -2.0..2.0, -2.0..2.0).prop_map(DVec3::from);
    prop_oneof![(component(), component(), component()).prop_map(DVec3::from), ordinary()]
}

fn camera() -> impl Strategy<Value = Camera> {
    let sides = (1_u32..=ImageSize::MAX, 1_u32..=ImageSize::MAX);
    (vector(), vector(), vector(), [measure(), measure(), measure()], sides).prop_map(
        |(eye, view, up, [width, height, distance], sides)| Camera {
            eye,
            orientation: Orientation::View { view, up },
            viewport: Viewport { width, height, distance },
            image: ImageSize::new(sides.0, sides.1).unwrap(),
        },
    )
}

/// The viewport's sides at distance 1.
fn slopes(camera: &Camera) -> [f64; 2] {
    let Viewport { width, height, distance } = camera.viewport;
    [width / distance, height / distance]
}

fn is_nearly(a: f64, b: f64, part: f64) -> bool {
    (a - b).abs() <= part * b.abs()
}

/// Returns true if both have their axes in the same directions, and their eyes in the same place.
fn is_same_pose(a: &Camera, b: &Camera) -> bool {
    let [own, other] = [a, b].map(|camera| *camera.resolve().unwrap().basis());
    let turned = (own.u - other.u).length().max((own.w - other.w).length());
    turned < 1e-9 && (a.eye - b.eye).abs().max_element() <= 1e-12 * b.eye.abs().max_element()
}

/// Returns the exported text, unless the format cannot hold the camera. The reason then has its numbers, and is true.
fn exported(name: &str, camera: &Camera) -> Option<String> {
    let document = scene_of(*camera);
    let subject = ExportScene::new(&document, Include::CameraAlone).unwrap();
    match format(name).write(&subject) {
        Ok(written) => Some(written.text.text),
        Err(reason) => {
            let is_told = reason.contains("it must be between 1e-300 and 1e");
            assert!(is_told || reason.contains("keeps the direction"), "{reason}");
            let are_ordinary = slopes(camera).iter().all(|slope| (1e-250..1e5).contains(slope));
            assert!(!are_ordinary || camera.eye.abs().max_element() > 1e3, "{reason}");
            None
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn every_export_is_read_back_or_refused_with_its_numbers(own in camera()) {
        prop_assume!(own.resolve().is_ok());
        if let Some(text) = exported("gltf", &own) {
            let back = read(Importer::Gltf, &text).unwrap_or_else(|error| panic!("{error}: {text}")).camera;
            prop_assert!(is_same_pose(&back, &own), "{back:?}");
            prop_assert_eq!((back.image, back.viewport.distance), (own.image, own.viewport.distance));
            let [a, b] = [&back, &own].map(slopes);
            prop_assert!(is_nearly(a[0], b[0], 1e-9) && is_nearly(a[1], b[1], 1e-9), "{a:?} {b:?}");
        }
        if let Some(text) = exported("opencv", &own) {
            let back = read(Importer::Literal, &text).unwrap_or_else(|error| panic!("{error}: {text}")).camera;
            prop_assert!(is_same_pose(&back, &own), "{back:?}");
            prop_assert_eq!(back.image, own.image);
            let [a, b] = [&back, &own].map(slopes);
            prop_assert!(is_nearly(a[0], b[0], 1e-9) && is_nearly(a[1], b[1], 1e-9), "{a:?} {b:?}");
        }
        if let Some(text) = exported("opengl", &own) {
            let call = &text[text.find("gluLookAt").unwrap()..];
            let back = read(Importer::Literal, call).unwrap_or_else(|error| panic!("{error}: {text}")).camera;
            prop_assert!(is_same_pose(&back, &own), "{back:?}");
        }
    }
}

#[test]
fn a_viewport_that_an_angle_does_not_tell_is_refused_with_its_numbers() {
    let viewport = Viewport { width: 1.0, height: 1.0, distance: 1e-17 };
    let document = scene_of(Camera { viewport, ..Camera::CANONICAL });
    let subject = ExportScene::new(&document, Include::Objects).unwrap();
    let told = format("gltf").write(&subject).unwrap_err();
    let expected = "the viewport's height / distance is 1 / 1e-17: it must be between 1e-300 and 1e6, or the numbers of \
                    this format do not tell it";
    assert_eq!(told, expected);
    let viewport = Viewport { width: 1e300, height: 1e-300, distance: 1.0 };
    let document = scene_of(Camera { viewport, ..Camera::CANONICAL });
    let subject = ExportScene::new(&document, Include::Objects).unwrap();
    let told = format("weekend").write(&subject).unwrap_err();
    assert!(told.starts_with("pixels are infinitely many times as wide as high"), "{told}");
}
