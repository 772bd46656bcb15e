//! Tests of exported texts without the other programs: all numbers are finite, and a format rejects
//! what it cannot express.

use pinhole_core::{Camera, DVec3, ImageSize, Plane, Viewport};
use pinhole_exchange::document::Item;
use pinhole_exchange::format::{ExportScene, Include};
use pinhole_exchange::programs::FORMATS;

use super::{marker, scene_of, text_of};

/// Only finite numbers are exported: a camera whose eye is so far away that squares overflow is either
/// written with finite numbers, or rejected.
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
                    let text = written.text.text;
                    let words = text.split(|c: char| !c.is_alphanumeric());
                    let is_none = |word: &&str| ["inf", "NaN", "infinity"].contains(word);
                    assert_eq!(words.filter(is_none).count(), 0, "{} {far}: {text}", format.name);
                    assert!(!text.contains('\u{e002}'), "{}", format.name);
                }
                Err(refused) => {
                    let refused = refused.to_string();
                    let said = ["a number would not be finite, in ", "eye is so far out"];
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

/// The aspect ratio that is written makes the book's `int(image_width / aspect_ratio)` the image's
/// height, although the quotient of a rounded ratio might be just below it.
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
