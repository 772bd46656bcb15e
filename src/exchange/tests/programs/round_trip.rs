//! Out and back: the same camera, to the last digits.

use pinhole_core::{
    Basis, Camera, DVec3, ImageSize, Orientation, OrientationKind, Pixel, Plane, Viewport,
};
use pinhole_exchange::document::{Document, Item};
use pinhole_exchange::format::{ExportScene, Format, Importer, Include, Input};
use pinhole_exchange::programs::{FORMATS, importer_of};
use proptest::prelude::*;

use super::{marker, read, scene_of, text_of};

/// Formats that are read again: all but Blender's Python and the book's C++.
fn with_importers() -> impl Iterator<Item = (&'static Format, &'static Importer)> {
    FORMATS.iter().filter_map(|format| Some((format, Importer::named(format.name)?)))
}

#[test]
fn all_but_two_formats_are_read_again() {
    let names = |has: bool| {
        let is = move |format: &&Format| Importer::named(format.name).is_some() == has;
        FORMATS.iter().filter(is).map(|format| format.name).collect::<Vec<_>>()
    };
    assert_eq!(names(false), ["blender", "weekend"]);
    assert_eq!(names(true).len(), 9);
}

/// Directions as unit vectors, eye in units of its size: within 1e-12.
#[track_caller]
fn assert_same_rays(what: &str, before: &Camera, after: &Camera) {
    let (a, b) = (before.resolve().unwrap(), after.resolve().unwrap());
    assert_eq!(a.image(), b.image(), "{what}");
    let size = a.eye().length().max(1.0);
    assert!((a.eye() - b.eye()).length() <= 1e-12 * size, "{what}: {} {}", a.eye(), b.eye());
    let Basis { u, v, w } = *a.basis();
    for (x, y) in [(u, b.basis().u), (v, b.basis().v), (w, b.basis().w)] {
        assert!((x - y).length() <= 1e-12, "{what}: {x} {y}");
    }
    let (rows, columns) = (a.image().height(), a.image().width());
    for row in 0..rows {
        for column in 0..columns {
            let [x, y] =
                [&a, &b].map(|c| c.ray_of_pixel(Pixel { row, column }).direction.normalize());
            assert!((x - y).length() <= 1e-12, "{what}: pixel {row}, {column}: {x} {y}");
        }
    }
}

/// Cameras of every kind, the viewport's measures and the image's among them.
fn cameras() -> impl Strategy<Value = Camera> {
    let number = || -10.0..10.0_f64;
    let vector = move || (number(), number(), number()).prop_map(DVec3::from);
    let image = (1..20_u32, 1..20_u32).prop_map(|(w, h)| ImageSize::new(w, h).unwrap());
    let viewport = (0.01..20.0_f64, 0.01..20.0_f64, 0.05..20.0_f64, any::<bool>());
    let kind = prop_oneof![
        Just(OrientationKind::At),
        Just(OrientationKind::View),
        Just(OrientationKind::Basis)
    ];
    (vector(), vector(), vector(), image, viewport, kind).prop_filter_map(
        "no basis",
        |(eye, at, up, image, (width, height, distance, square), kind)| {
            let width = if square { height * image.aspect() } else { width };
            let orientation = Orientation::At { at, up };
            let viewport = Viewport { width, height, distance };
            let camera = Camera { eye, orientation, viewport, image };
            // Nearly parallel up magnifies roundings: another test's business.
            camera.up_angle().ok().filter(|angle| angle.conditioning < 50.0)?;
            camera.given_by(kind).ok()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..Default::default() })]

    #[test]
    fn every_format_gives_the_same_camera_back(camera in cameras()) {
        let document = scene_of(camera);
        let subject = ExportScene::new(&document, Include::Objects).unwrap();
        for format in &FORMATS {
            let Ok(written) = format.write(&subject) else {
                // Only pixels that are not square are refused.
                let viewport = camera.viewport;
                let square = (viewport.width / viewport.height / camera.image.aspect() - 1.0).abs();
                prop_assert!(square > 1e-15, "{} refused {camera:?}", format.name);
                continue;
            };
            prop_assert!(!written.notes.iter().any(|note| note.contains("rays to")), "{:?}", written.notes);
            if Importer::named(format.name).is_none() {
                continue;
            }
            let text = written.joined().text;
            prop_assert_eq!(importer_of(&text).map(|importer| importer.name), Some(format.name));
            let back = read(format.name, &text).unwrap().camera;
            assert_same_rays(format.name, &camera, &back);
        }
    }

    /// Eye, at and up are printed so that they read back to the bit.
    #[test]
    fn points_read_back_to_the_bit(camera in cameras()) {
        let camera = camera.given_by(OrientationKind::At).unwrap();
        let width = camera.viewport.height * camera.image.aspect();
        let camera = Camera { viewport: Viewport { width, ..camera.viewport }, ..camera };
        for name in ["mitsuba", "pbrt", "opengl"] {
            let back = read(name, &text_of(name, &scene_of(camera))).unwrap().camera;
            prop_assert_eq!(back.eye, camera.eye);
            prop_assert_eq!(back.orientation, camera.orientation, "{}", name);
        }
        let view = camera.given_by(OrientationKind::View).unwrap();
        let back = read("course", &text_of("course", &scene_of(view))).unwrap().camera;
        prop_assert_eq!((back.eye, back.orientation), (view.eye, view.orientation));
        let basis = camera.given_by(OrientationKind::Basis).unwrap();
        for name in ["gltf", "three"] {
            let back = read(name, &text_of(name, &scene_of(basis))).unwrap().camera;
            prop_assert_eq!((back.eye, back.orientation), (basis.eye, basis.orientation));
        }
    }
}

/// Where the distance is said, the whole viewport comes back.
#[test]
fn what_says_the_distance_keeps_t() {
    let viewport = Viewport { width: 3.2, height: 1.8, distance: 2.5 };
    let image = ImageSize::new(160, 90).unwrap();
    let document = scene_of(Camera { viewport, image, ..Camera::CANONICAL });
    for name in ["povray", "pbrt", "gltf", "three"] {
        assert_eq!(
            read(name, &text_of(name, &document)).unwrap().camera.viewport,
            viewport,
            "{name}"
        );
    }
    // The course's viewport is 1 wide.
    let course = read("course", &text_of("course", &document)).unwrap().camera.viewport;
    assert_eq!(course, Viewport { width: 1.0, height: 0.5625, distance: 0.78125 });
}

/// The camera at hand gives all that a text leaves open.
#[test]
fn what_is_left_open_is_as_at_hand() {
    let viewport = Viewport { width: 4.0, height: 3.0, distance: 2.0 };
    let image = ImageSize::new(400, 300).unwrap();
    let at_hand = Camera { viewport, image, ..Camera::CANONICAL };
    for (format, importer) in with_importers() {
        let document = scene_of(at_hand);
        let text = text_of(format.name, &document);
        let text = Input { path: "in".as_ref(), text: &text };
        let back = importer.read(&text, &at_hand).unwrap().camera;
        let scale = if format.name == "course" { 0.25 } else { 1.0 };
        assert_eq!(back.viewport.distance, scale * 2.0, "{}", format.name);
        assert!((back.viewport.width - scale * 4.0).abs() < 1e-14, "{}", format.name);
    }
    let text = "gluPerspective(60, 2, 0.1, 100); gluLookAt(0,0,0, 0,0,-1, 0,1,0);";
    let taken = Importer::named("opengl")
        .unwrap()
        .read(&Input { path: "in".as_ref(), text }, &at_hand)
        .unwrap();
    assert_eq!((taken.camera.image.width(), taken.camera.image.height()), (600, 300));
    assert_eq!(
        taken.notes,
        ["gluPerspective does not say how many pixels there are: 600 × 300 taken"]
    );
}

#[test]
fn spheres_and_planes_come_back() {
    let plane = Plane { point: DVec3::new(0.0, -3.0, 0.0), normal: DVec3::Y };
    let planes = vec![Item { name: None, color: Some([255, 128, 0]), shape: plane }];
    let document =
        Document { spheres: marker().into(), planes: planes.into(), ..Document::default() };
    for name in ["povray", "pbrt", "mitsuba", "three"] {
        let taken = read(name, &text_of(name, &document)).unwrap();
        assert_eq!(taken.spheres, *document.spheres, "{name}");
        let has_planes = ["povray", "mitsuba", "three"].contains(&name);
        assert_eq!(taken.planes.len(), usize::from(has_planes), "{name}");
        for plane in taken.planes {
            assert!(plane.shape.is_same(&document.planes[0].shape), "{name}: {plane:?}");
            assert_eq!(plane.color, Some([255, 128, 0]));
        }
    }
}

/// An extreme camera is written with a note on how much of it is kept.
#[test]
fn a_field_of_view_near_180_degrees_is_told() {
    let viewport = Viewport { width: 1e9, height: 1e9, distance: 1.0 };
    let document = scene_of(Camera { viewport, ..Camera::CANONICAL });
    let subject = ExportScene::new(&document, Include::CameraAlone).unwrap();
    let notes = super::format("povray").write(&subject).unwrap().notes;
    assert_eq!(notes, Vec::<String>::new());
    let viewport = Viewport { width: 1e-3, height: 1e17, distance: 1.0 };
    let image = ImageSize::new(2, 2).unwrap();
    let document = scene_of(Camera { viewport, image, ..Camera::CANONICAL });
    let subject = ExportScene::new(&document, Include::CameraAlone).unwrap();
    let refused = super::format("three").write(&subject).unwrap_err().to_string();
    assert_eq!(
        refused,
        "three.js would read no camera from its numbers: object.children[0].fov is 180: it must be \
         between 0 and 180 degrees"
    );
}

/// No number that is not finite leaves the program: an eye so far out that squares overflow is written with
/// finite ones, and read again, or refused by the line at fault.
#[test]
fn an_eye_beyond_all_is_written_in_finite_numbers_or_refused() {
    for far in [1e155, 1e200, 1e306, 1.7e308] {
        let mut document = scene_of(Camera { eye: DVec3::new(far, 0.0, 0.0), ..Camera::CANONICAL });
        document.spheres = marker().into();
        document.planes =
            vec![Item::plain(Plane { point: DVec3::ZERO, normal: DVec3::X * 1e-200 })].into();
        let subject = ExportScene::new(&document, Include::Meshes).unwrap();
        let mut count = 0;
        for format in &FORMATS {
            match format.write(&subject) {
                Ok(written) => {
                    count += 1;
                    let text = written.joined().text;
                    let words = text.split(|c: char| !c.is_alphanumeric());
                    let is_none = |word: &&str| ["inf", "NaN", "infinity"].contains(word);
                    assert_eq!(words.filter(is_none).count(), 0, "{} {far}: {text}", format.name);
                    assert!(!text.contains('\u{e002}'), "{}", format.name);
                }
                Err(refused) => {
                    let refused = refused.to_string();
                    let said = [
                        "a number would not be finite, in ",
                        "eye is so far out",
                        " would read no camera",
                    ];
                    assert!(said.iter().any(|said| refused.contains(said)), "{refused}");
                }
            }
        }
        assert!(count > 6 || far > 1e200, "{far}: {count}");
    }
}

#[test]
fn pixels_that_are_not_square_are_refused_where_they_cannot_be_said() {
    let viewport = Viewport { width: 2.0, ..Viewport::CANONICAL };
    let document = scene_of(Camera { viewport, ..Camera::CANONICAL });
    let subject = ExportScene::new(&document, Include::Objects).unwrap();
    for name in ["mitsuba", "weekend", "course"] {
        let refused = super::format(name).write(&subject).unwrap_err().to_string();
        assert!(refused.starts_with("pixels are 2 times as wide as high, and "), "{refused}");
        assert!(refused.contains("width / height, 2 / 1, the image's 400 / 400"), "{refused}");
    }
}

/// `int(image_width / aspect_ratio)` loses a row where the quotient is rounded up.
#[test]
fn weekend_keeps_every_row() {
    let value = |text: &str, name: &str| -> f64 {
        let given = text.split(&format!("cam.{name}")).nth(1).unwrap();
        let given = given.split(';').next().unwrap().trim_start_matches([' ', '=']);
        given
            .split('/')
            .map(|part| part.trim().parse::<f64>().unwrap())
            .reduce(|a, b| a / b)
            .unwrap()
    };
    for width in 1..60 {
        for height in 1..60 {
            let image = ImageSize::new(width, height).unwrap();
            let viewport = Viewport { width: image.aspect(), ..Viewport::CANONICAL };
            let text =
                text_of("weekend", &scene_of(Camera { viewport, image, ..Camera::CANONICAL }));
            let (columns, ratio) = (value(&text, "image_width"), value(&text, "aspect_ratio"));
            assert_eq!((columns as u32, (columns / ratio) as u32), (width, height), "{text}");
        }
    }
}
