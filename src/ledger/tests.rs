use expect_test::{Expect, expect};
use pinhole_core::{DVec2, DVec3, Orientation, Pixel};

use super::*;
use crate::formats::scene_argument::SceneSource;

/// A built-in scene's ledger.
fn document(scene: &str) -> Document {
    SceneSource::of(scene.as_ref()).expect("a scene").load().expect("a document")
}

fn of(document: &Document, selection: Selection, digits: usize, from_one: bool) -> Ledger {
    let posed = document.camera.posed();
    let scene = document.scene();
    let inspection =
        posed.as_ref().ok().zip(scene.as_ref().ok()).map(|(posed, scene)| match selection {
            Selection::Pixel(pixel) => Inspection::of_pixel(posed, scene, pixel),
            Selection::Uv(uv) => Inspection::of_uv(posed, scene, uv),
        });
    let fault = match (&posed, &scene) {
        (Err(e), _) => Some(Fault::Camera(*e)),
        (_, Err(e)) => Some(Fault::Scene(*e)),
        _ => None,
    };
    ledger(&Sources {
        document,
        posed: posed.as_ref().ok(),
        scene: scene.as_ref().ok(),
        inspection: inspection.as_ref(),
        fault,
        selection,
        sections: LedgerSections::default(),
        digits,
        from_one,
    })
}

const WARM_UP: Selection = Selection::Uv(DVec2::new(0.2, -0.1));

fn check(document: &Document, selection: Selection, expected: Expect) {
    expected.assert_eq(&of(document, selection, 5, false).to_string());
}

#[test]
fn the_canonical_camera() {
    check(&document("canonical"), WARM_UP, expect![""]);
}

#[test]
fn a_pixel_of_the_look_at_camera() {
    check(&document("look-at"), Selection::Pixel(Pixel { row: 99, column: 199 }), expect![""]);
}

#[test]
fn the_lectures_forty_five_degrees() {
    check(&document("forty-five"), WARM_UP, expect![""]);
}

#[test]
fn rows_and_columns_counted_from_one() {
    let pixel = Selection::Pixel(Pixel { row: 99, column: 199 });
    let ledger = of(&document("canonical"), pixel, 5, true);
    let lines = ledger.sections[1].lines.iter().take(3).map(|line| format!("{line}\n"));
    expect![""].assert_eq(&lines.collect::<String>());
}

#[test]
fn a_camera_without_a_basis_is_derived_up_to_the_line_that_fails() {
    let mut document = document("canonical");
    for (at, up) in [
        (DVec3::ZERO, DVec3::Y),
        (DVec3::new(0.0, 0.0, -1.0), DVec3::ZERO),
        (DVec3::new(0.0, 0.0, -1.0), DVec3::new(0.0, 0.0, 2.0)),
    ] {
        document.camera.orientation = Orientation::At { at, up };
        let ledger = of(&document, WARM_UP, 5, false);
        let last = ledger.sections[0].lines.last().expect("lines");
        assert!(last.is_fault && !last.note.is_empty(), "{ledger}");
        assert!(ledger.sections[1].lines.iter().all(|line| line.is_fault));
    }
    expect![""].assert_eq(&of(&document, WARM_UP, 5, false).to_string());
}

#[test]
fn nothing_is_no_number() {
    for scene in crate::formats::builtin::all() {
        let document = document(scene.name);
        for selection in [WARM_UP, Selection::Pixel(Pixel { row: 0, column: 0 })] {
            let text = of(&document, selection, 17, false).to_string();
            assert!(!text.contains("NaN") && !text.contains("inf"), "{}: {text}", scene.name);
        }
    }
}

#[test]
fn digits_follow_the_setting() {
    let mut document = document("canonical");
    document.camera.orientation =
        Orientation::View { view: DVec3::new(0.3, -0.77, -1.9), up: DVec3::new(0.1, 1.0, 0.2) };
    let text = |digits| of(&document, WARM_UP, digits, false).to_string();
    assert!(text(3).contains("≈") && text(3).len() < text(9).len());
    expect![""]
        .assert_eq(&text(3).lines().take(9).map(|line| format!("{line}\n")).collect::<String>());
}
