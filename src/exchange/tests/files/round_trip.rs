//! Tests that any document, written and read again, is the same to the last bit.

use std::path::Path;
use std::sync::Arc;

use pinhole_core::{Basis, Camera, DVec3, ImageSize, Orientation, Plane, Rgb, Sphere, Viewport};
use pinhole_exchange::document::{CsvSpheres, Document, Item, StoredObserver};
use pinhole_exchange::scene_file::{self, to_text};
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;

pub(super) fn number() -> BoxedStrategy<f64> {
    let special = prop::sample::select(vec![
        0.0,
        -0.0,
        1.0,
        0.1,
        -5.0,
        1e300,
        1e16,
        1e15,
        1e-7,
        5e-324,
        f64::MIN_POSITIVE,
        f64::MAX,
        f64::MIN,
        1.0 / 3.0,
    ]);
    prop_oneof![
        special,
        any::<i16>().prop_map(f64::from),
        prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL
    ]
    .boxed()
}

fn positive() -> impl Strategy<Value = f64> {
    number().prop_map(|x| if x == 0.0 { 1.0 } else { x.abs() })
}

fn vector() -> impl Strategy<Value = DVec3> {
    [number(), number(), number()].prop_map(DVec3::from_array)
}

fn text() -> impl Strategy<Value = String> {
    let hard = prop::sample::select(vec![
        "",
        "\"",
        "'''",
        "\"\"\"",
        "\\",
        "\\u0041",
        "a\nb",
        "a\r\nb",
        "\r",
        "\t",
        "\u{0}\u{7}\u{1b}",
        "\u{7f}\u{85}",
        "# no comment",
        "[sphere]",
        "\u{feff}",
        "ü€😀",
        " blanks ",
        "=",
    ]);
    prop_oneof![hard.prop_map(str::to_owned), any::<String>()]
}

/// Returns random notes: lines that a comment can contain, without ASCII control characters except tabs.
fn note() -> impl Strategy<Value = String> {
    vec("[^\\x00-\\x1f\\x7f]{0,12}|\u{85}|#|\t| x", 0..4).prop_map(|lines| lines.join("\n"))
}

fn orientation() -> impl Strategy<Value = Orientation> {
    let [a, b, c] = [vector(), vector(), vector()];
    (0..3, a, b, c).prop_map(|(kind, a, b, c)| match kind {
        0 => Orientation::At { at: a, up: b },
        1 => Orientation::View { view: a, up: b },
        _ => Orientation::Basis(Basis { u: a, v: b, w: c }),
    })
}

fn camera() -> impl Strategy<Value = Camera> {
    let viewport = [positive().boxed(), positive().boxed(), positive().boxed()];
    let image = (1..=ImageSize::MAX, 1..=ImageSize::MAX);
    (vector(), orientation(), viewport, image).prop_map(|(eye, orientation, viewport, image)| {
        let [width, height, distance] = viewport;
        let viewport = Viewport { width, height, distance };
        Camera { eye, orientation, viewport, image: ImageSize::new(image.0, image.1).unwrap() }
    })
}

fn items<S: std::fmt::Debug + Clone>(
    shape: impl Strategy<Value = S>,
) -> impl Strategy<Value = Vec<Item<S>>> {
    let item = (option::of(text()), option::of(any::<Rgb>()), shape);
    vec(item.prop_map(|(name, color, shape)| Item { name, color, shape }), 0..5)
}

fn observer() -> impl Strategy<Value = StoredObserver> {
    let target = [-1e12..=1e12, -1.0..=1.0, -9.0..=0.0f64].prop_map(DVec3::from_array);
    let observer = (target, -1e3..=1e3, -90.0..=90.0, 1e-9..=1e12);
    observer.prop_map(|(target, azimuth, elevation, distance)| StoredObserver {
        target,
        azimuth,
        elevation,
        distance,
    })
}

pub(super) fn document() -> impl Strategy<Value = Document> {
    let sphere = (vector(), positive()).prop_map(|(center, radius)| Sphere { center, radius });
    let normal = vector().prop_map(|n| if n == DVec3::ZERO { DVec3::Z } else { n });
    let plane = (vector(), normal).prop_map(|(point, normal)| Plane { point, normal });
    let camera = (camera(), option::of(observer()));
    (note(), camera, items(sphere), items(plane), option::of(text())).prop_map(
        |(note, (camera, observer), spheres, planes, csv)| Document {
            note,
            camera,
            observer,
            spheres: spheres.into(),
            csv_spheres: csv.map(|path| CsvSpheres {
                file: path.clone().into(),
                path,
                stamp: None,
                count: 0,
                items: Arc::default(),
            }),
            planes: planes.into(),
        },
    )
}

/// Returns a document's debug text, which, unlike `==`, distinguishes 0 from -0.
pub(super) fn bits(document: &Document) -> String {
    format!("{document:?}")
}

/// Reads the document from a text without its line `spheres = ...`, since that CSV file does not exist.
fn read(text: &str) -> Document {
    let without_csv: String =
        text.split_inclusive('\n').filter(|line| !line.starts_with("spheres = ")).collect();
    scene_file::parse(&without_csv, Path::new("scene.toml"), Path::new("")).unwrap()
}

proptest! {
    #[test]
    fn text_is_the_document(document in document()) {
        let text = to_text(&document, None);
        let expected = Document { csv_spheres: None, ..document };
        prop_assert_eq!(bits(&read(&text)), bits(&expected), "{}", text);
    }

    #[test]
    fn text_over_any_previous_text_is_the_document(old in document(), new in document()) {
        let previous = to_text(&old, None);
        let text = to_text(&new, Some(&previous));
        let expected = Document { csv_spheres: None, ..new };
        prop_assert_eq!(bits(&read(&text)), bits(&expected), "{}", text);
    }

    #[test]
    fn nothing_changes_where_nothing_has_changed(document in document()) {
        let text = to_text(&document, None);
        prop_assert_eq!(to_text(&document, Some(&text)), text);
    }
}

proptest! {
    #[test]
    fn a_damaged_file_is_read_or_refused_at_a_place_in_it(
        document in document(),
        from in any::<prop::sample::Index>(),
        length in 0..9usize,
        damage in "([\\[\\]{}=\",.#\n0-9a-z]|\\PC){0,4}",
    ) {
        let mut text: Vec<char> =
            to_text(&Document { csv_spheres: None, ..document }, None).chars().collect();
        let from = from.index(text.len());
        text.splice(from..(from + length).min(text.len()), damage.chars());
        let text: String = text.into_iter().collect();
        if let Err(error) = scene_file::parse(&text, Path::new("scene.toml"), Path::new("")) {
            let location = error.location.unwrap();
            let line = text.split('\n').nth(location.line - 1).unwrap();
            prop_assert!(location.column <= line.chars().count() + 1, "{}\n{}", error, text);
        }
    }
}

#[test]
fn numbers_are_short_and_read_back() {
    let mut document = Document::default();
    document.camera.eye = DVec3::new(0.1, 1e300, -5.0);
    document.camera.viewport.width = 1.0 / 3.0;
    let text = to_text(&document, None);
    assert!(text.contains("eye = [0.1, 1e300, -5.0]\n"), "{text}");
    assert!(text.contains("width = 0.3333333333333333\n"), "{text}");
}
