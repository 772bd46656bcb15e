//! The translator and the clipboard, by label: numbers that match, a paste that is one step, a bad one
//! that changes nothing.

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, OutputCommand};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;
use pinhole_core::{Camera, DVec3, Orientation};
use pinhole_exchange::code::LANGUAGES;
use pinhole_exchange::document::Document;
use pinhole_exchange::format::Format;
use pinhole_exchange::format::{ExportScene, Include};
use pinhole_exchange::programs::FORMATS;

use crate::harness::{assert_says, export_to, says, show, texts_with, type_into, window};

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_role_and_label(Role::Button, label).click_accesskit();
    harness.run();
}

fn translating(scene: &str, format: &str) -> Harness<'static, App> {
    let mut harness = window(scene);
    show(&mut harness, ViewLayout::Translator);
    click(&mut harness, format);
    harness
}

fn text_of(name: &str, document: &Document) -> String {
    let subject = ExportScene::new(document, Include::CameraAlone).unwrap();
    Format::named(name).unwrap().write(&subject).unwrap().text.text
}

fn shown(harness: &Harness<'_, App>) -> String {
    let parts = harness.query_all_by_label("translation");
    parts.map(|part| part.value().unwrap()).collect::<Vec<_>>().join("\n")
}

fn paste(harness: &mut Harness<'_, App>, text: &str) {
    harness.event(Event::Paste(text.to_owned()));
    harness.run();
}

fn camera(harness: &Harness<'_, App>) -> Camera {
    harness.state().document().camera
}

#[test]
fn every_format_shows_the_camera_live() {
    let mut harness = translating("look-at", "POV-Ray");
    for format in &FORMATS {
        click(&mut harness, format.short);
        let text = text_of(format.name, harness.state().document());
        assert!(!shown(&harness).is_empty());
        for line in shown(&harness).lines() {
            assert!(text.contains(line), "{}: {line}", format.label);
        }
    }
    let document = harness.state().document().clone();
    assert_eq!(shown(&harness), text_of("pbrt", &document).trim_end());
    type_into(&mut harness, "eye x", "5");
    let document = harness.state().document().clone();
    assert_eq!(document.camera.eye.x, 5.0);
    assert_eq!(shown(&harness), text_of("pbrt", &document).trim_end());
    assert!(shown(&harness).contains("LookAt 5 4 10"), "{}", shown(&harness));
}

#[test]
fn the_table_tells_what_is_turned() {
    let mut harness = translating("canonical", "OpenCV");
    assert_says(&harness, "down −𝐯 = (0, −1, 0)");
    assert_says(&harness, "forwards −𝐰 = (0, 0, −1)");
    assert_says(&harness, "along +z");
    click(&mut harness, "Mitsuba");
    assert_says(&harness, "left −𝐮 = (−1, 0, 0)");
    click(&mut harness, "POV-Ray");
    assert_says(&harness, "left-handed");
    click(&mut harness, "glTF");
    assert!(!says(&harness, "left-handed"));
}

#[test]
fn what_a_format_cannot_say_is_told() {
    let harness = translating("non-square", "Mitsuba");
    let said = texts_with(&harness, "Mitsuba 3 has square ones only");
    assert_eq!(said.len(), 1, "{said:?}");
    assert_eq!(shown(&harness), "");
}

#[test]
fn copying_gives_every_digit() {
    let mut harness = translating("look-at", "Blender");
    harness.get_by_role_and_label(Role::Button, "Copy").click_accesskit();
    harness.step();
    let commands = &harness.output().platform_output.commands;
    let copied = commands.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    assert_eq!(copied, Some(text_of("blender", harness.state().document())));
}

#[test]
fn saving_writes_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("camera.pov");
    let mut harness = translating("look-at", "POV-Ray");
    click(&mut harness, "Save as a file…");
    export_to(&mut harness, &path);
    harness.run();
    let text = std::fs::read_to_string(path).unwrap();
    assert_eq!(text, text_of("povray", harness.state().document()));
}

#[test]
fn a_paste_of_every_form_sets_the_camera_in_one_step() {
    let other = window("look-at").state().document().clone();
    let gltf = text_of("gltf", &other);
    let numbers = "gluLookAt(20, 4, 10, -1, 0, -5, 0, 1, 0);";
    for (text, label) in [(&*gltf, "glTF 2.0"), (numbers, "literal numbers")] {
        let mut harness = window("canonical");
        let before = harness.state().document().clone();
        paste(&mut harness, text);
        assert_says(&harness, &format!("Camera pasted: {label}"));
        let (here, there) = (camera(&harness).resolve().unwrap(), other.camera.resolve().unwrap());
        assert!((here.eye() - there.eye()).length() < 1e-12, "{label}");
        assert!((here.basis().u - there.basis().u).length() < 1e-12, "{label}");
        assert_eq!(harness.state().document().spheres, before.spheres);
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        harness.run();
        assert_eq!(harness.state().document(), &before, "{label}");
        assert!(!says(&harness, &format!("Camera pasted: {label}")));
    }
}

#[test]
fn a_paste_says_what_it_could_not_take_over() {
    let mut harness = window("canonical");
    let left_handed = "1 0 0 0\n0 1 0 1\n0 0 -1 -9";
    paste(&mut harness, left_handed);
    assert_says(
        &harness,
        "Its world is left-handed, Pinhole's is right-handed: the camera's every z is negated here, but \
         the objects are not: negate their z, too, for the same picture.",
    );
    let mut harness = window("canonical");
    paste(&mut harness, "gluLookAt(0, 0, 9, 0, 0, 0, 0, 1, 0);");
    assert_says(
        &harness,
        "The field of view is not given: 53.1301 degrees from bottom to top kept.",
    );
    let at = Orientation::At { at: DVec3::ZERO, up: DVec3::Y };
    assert_eq!(camera(&harness).orientation, at);
    click(&mut harness, "Close");
    assert!(!says(&harness, "Camera pasted: literal numbers"));
}

#[test]
fn the_notice_of_a_paste_goes_by_itself_and_an_error_stays() {
    let mut harness = window("canonical");
    paste(&mut harness, "20 4 10 -1 0 -5 0 1 0");
    assert_says(&harness, "Camera pasted: literal numbers");
    harness.run_steps(100);
    assert!(!says(&harness, "Camera pasted: literal numbers"));
    paste(&mut harness, "to whom it may concern");
    harness.run_steps(100);
    assert_says(&harness, "This text is not a camera: nothing was changed");
}

#[test]
fn a_bad_paste_changes_nothing() {
    let mut harness = window("canonical");
    let before = harness.state().document().clone();
    paste(&mut harness, "to whom it may concern");
    assert_says(&harness, "This text is not a camera: nothing was changed");
    paste(&mut harness, "camera { location <0, 1, -9> look_at 0 }");
    assert_says(
        &harness,
        "No camera that Pinhole reads: it reads glTF (.gltf, .glb), and numbers: eye, at and up, gluLookAt or \
         glm::lookAt, a 3 × 4 or 4 × 4 matrix from camera to world, or K, R and t. Export the scene as glTF, \
         or give its look-at alone.",
    );
    assert_eq!(harness.state().document(), &before);
    paste(&mut harness, "gluLookAt(0, 0);");
    assert_says(&harness, "Not pasted: this camera cannot be read");
    assert_says(&harness, "Pasted:1:1: gluLookAt(0, 0): it must have 9 numbers.");
    assert_eq!(harness.state().document(), &before);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run();
    assert_eq!(harness.state().document(), &before);
}

#[test]
fn what_is_pasted_into_a_field_is_typed_there() {
    let mut harness = window("canonical");
    harness.get_by_role_and_label(Role::SpinButton, "eye x").click();
    harness.run();
    paste(&mut harness, "gluLookAt(0, 0, 9, 0, 0, 0, 0, 1, 0);");
    assert!(!says(&harness, "Camera pasted: literal numbers"));
    assert_eq!(camera(&harness).eye.z, 0.0);
}

#[test]
fn a_scene_of_our_own_is_a_camera_too() {
    let mut harness = window("canonical");
    let scene = "pinhole = 1\n[camera]\neye = [1, 2, 3]\nview = [0, 0, -1]\nup = [0, 1, 0]\n\
                 [[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n";
    paste(&mut harness, scene);
    assert_says(&harness, "Camera pasted: a scene of Pinhole");
    assert_says(&harness, "Its objects are left out: a paste sets only the camera.");
    assert_eq!(camera(&harness).eye, DVec3::new(1.0, 2.0, 3.0));
    // The table alone keeps the viewport.
    type_into(&mut harness, "distance", "2");
    paste(&mut harness, "[camera]\neye = [4, 2, 3]\nat = [0, 0, -1]\nup = [0, 1, 0]\n");
    assert_eq!((camera(&harness).eye.x, camera(&harness).viewport.distance), (4.0, 2.0));
    paste(&mut harness, "pinhole = 1\n[camera]\neye = 3\n");
    assert_says(&harness, "Not pasted: this camera cannot be read");
    assert_eq!(camera(&harness).eye, DVec3::new(4.0, 2.0, 3.0));
}

#[test]
fn objects_go_along_where_they_are_asked_for() {
    let mut harness = translating("canonical", "POV-Ray");
    assert!(!shown(&harness).contains("sphere {"));
    harness.get_by_role_and_label(Role::CheckBox, "objects, too").click_accesskit();
    harness.run();
    assert!(shown(&harness).contains("sphere { <0, 0, -5>, 1"), "{}", shown(&harness));
}

#[test]
fn code_in_each_language_has_the_cameras_numbers_live() {
    let mut harness = translating("look-at", "Julia");
    for language in LANGUAGES {
        click(&mut harness, language.label);
        let text = text_of(language.name, harness.state().document());
        assert_eq!(shown(&harness), text.trim_end());
    }
    type_into(&mut harness, "eye x", "7.5");
    assert!(shown(&harness).contains("7.5"), "{}", shown(&harness));
}
