//! Open, save, drop, recent files, unsaved changes, and what the next run remembers.

use std::fs;

use egui::accesskit::Role;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::session::Split;
use pinhole::model::store::{Remembered, Store};
use pinhole_exchange::document::Document;
use pinhole_exchange::scene_file;

use crate::harness::{
    assert_says, command, open_scene, texts_with, type_into, unfolded, window, window_with,
};

fn ctrl(window: &mut egui_kittest::Harness<'_, pinhole::ui::app::App>, key: egui::Key) {
    window.key_press_modifiers(egui::Modifiers::COMMAND, key);
    window.run();
}

fn type_path(
    window: &mut egui_kittest::Harness<'_, pinhole::ui::app::App>,
    path: &std::path::Path,
) {
    window.get_by_role_and_label(Role::TextInput, "path").focus();
    window.run();
    window.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::A);
    window.get_by_role_and_label(Role::TextInput, "path").type_text(path.to_str().unwrap());
    window.run();
}

#[test]
fn a_scene_is_edited_and_saved_as_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    let mut window = window("canonical");
    type_into(&mut window, "eye x", "0.25");
    ctrl(&mut window, egui::Key::S);
    type_path(&mut window, &path);
    window.key_press(egui::Key::Enter);
    window.run();
    let saved = scene_file::load(&path).unwrap();
    assert_eq!(saved.camera.eye.x, 0.25);
    assert_eq!(saved, *window.state().document());
    assert_says(&window, "mine.toml");
    type_into(&mut window, "eye x", "0.5");
    assert_says(&window, "mine.toml*");
    ctrl(&mut window, egui::Key::S);
    assert_eq!(scene_file::load(&path).unwrap().camera.eye.x, 0.5);
}

#[test]
fn a_number_that_is_being_typed_is_saved_too() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    scene_file::save(&Document::default(), &path, None).unwrap();
    let mut window = window(&path);
    window.get_by_role_and_label(Role::SpinButton, "eye y").click();
    window.run();
    window.get_by_role_and_label(Role::SpinButton, "eye y").type_text("1/4");
    window.run();
    ctrl(&mut window, egui::Key::S);
    assert_eq!(scene_file::load(&path).unwrap().camera.eye.y, 0.25);
    assert_says(&window, "mine.toml");
}

#[test]
fn a_built_in_scene_opens_from_the_menu() {
    let mut window = window("canonical");
    open_scene(&mut window, "forty-five");
    assert_says(&window, "d ≈ (−0.56569, −0.1, −0.84853)");
}

#[test]
fn a_dropped_file_opens_and_a_bad_one_says_what_is_wrong() {
    let folder = tempfile::tempdir().unwrap();
    let good = folder.path().join("good.toml");
    scene_file::save(&Document::default(), &good, None).unwrap();
    let bad = folder.path().join("bad.toml");
    fs::write(&bad, "pinhole = 1\n[camera]\neye = [0.0, 0.0]\n").unwrap();
    let mut window = window("canonical");
    drop_file(&mut window, &bad);
    assert_says(&window, "This scene cannot be opened");
    assert!(window.state().document().object_count() > 0, "the open scene is still there");
    window.get_by_label("Close").click();
    window.run();
    drop_file(&mut window, &good);
    assert_eq!(*window.state().document(), Document::default());
}

pub(crate) fn drop_file(
    window: &mut egui_kittest::Harness<'_, pinhole::ui::app::App>,
    path: &std::path::Path,
) {
    window.input_mut().dropped_files = vec![std::sync::Arc::new(Dropped(path.to_owned()))];
    window.run();
}

#[derive(Debug)]
struct Dropped(std::path::PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &std::path::Path {
        &self.0
    }
    fn bytes(&self) -> Result<Vec<u8>, String> {
        fs::read(&self.0).map_err(|error| error.to_string())
    }
}

#[test]
fn unsaved_changes_are_asked_about_before_another_scene_opens() {
    let mut window = window("canonical");
    type_into(&mut window, "eye x", "7");
    for (answer, eye) in [("Cancel", 7.0), ("Discard", 0.0)] {
        open_scene(&mut window, "distance-two");
        assert_says(&window, "Save the changes to canonical?");
        window.get_by_label(answer).click();
        window.run();
        assert_eq!(window.state().document().camera.eye.x, eye, "{answer}");
    }
    assert_eq!(window.state().document().camera.viewport.distance, 2.0);
}

#[test]
fn what_waited_for_saving_goes_on_after_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("kept.toml");
    let mut window = window("canonical");
    type_into(&mut window, "eye x", "7");
    open_scene(&mut window, "distance-two");
    window.get_by_role_and_label(Role::Button, "Save").click();
    window.run();
    type_path(&mut window, &path);
    window.get_by_role_and_label(Role::Button, "Save").click();
    window.run();
    assert_eq!(scene_file::load(&path).unwrap().camera.eye.x, 7.0);
    assert_says(&window, "distance-two");
}

#[test]
fn closing_with_changes_asks_first() {
    let mut window = window("canonical");
    type_into(&mut window, "eye x", "7");
    ctrl(&mut window, egui::Key::Q);
    assert_says(&window, "Save the changes to canonical?");
    window.get_by_label("Cancel").click();
    window.run();
    assert_eq!(window.state().document().camera.eye.x, 7.0);
}

#[test]
fn settings_scene_and_ray_are_remembered() {
    let folder = tempfile::tempdir().unwrap();
    let store = Store::at(&folder.path().join("state.json"));
    assert_eq!(store.load(), Remembered::default());
    let remembered = Remembered { settings: unfolded(), ..Remembered::default() };
    let mut window = window_with("forty-five", remembered, Some(store.clone()));
    command(&mut window, "shading normals");
    type_into(&mut window, "row", "12");
    window.state_mut().on_exit();
    let remembered = store.load();
    assert_eq!(remembered.last.as_deref(), Some(std::path::Path::new("forty-five")));
    let again = window_with("forty-five", remembered, Some(store));
    assert_eq!(again.state().session().settings(), window.state().session().settings());
    assert_eq!(again.state().session().shown.selection, window.state().session().shown.selection);
}

#[cfg(unix)]
#[test]
fn a_file_name_that_is_no_text_costs_no_settings() {
    use std::os::unix::ffi::OsStrExt as _;

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(std::ffi::OsStr::from_bytes(b"\xff.toml"));
    scene_file::save(&Document::default(), &path, None).unwrap();
    let store = Store::at(&folder.path().join("state.json"));
    let recent = vec![path.clone(), folder.path().join("other.toml")];
    let remembered = Remembered { recent, settings: unfolded(), ..Remembered::default() };
    let mut window = window_with(&path, remembered, Some(store.clone()));
    command(&mut window, "shading normals");
    window.state_mut().on_exit();
    assert_eq!(store.load().settings, window.state().session().settings());
    assert_eq!(store.load().recent, [folder.path().join("other.toml")]);
}

#[test]
fn a_broken_store_is_no_reason_not_to_start() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("state.json");
    fs::write(&path, "{ not json").unwrap();
    assert_eq!(Store::at(&path).load(), Remembered::default());
}

#[test]
fn one_wrong_value_in_the_store_takes_no_other_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("state.json");
    let mut right = Remembered { last: Some("look-at".into()), ..Remembered::default() };
    right.settings.setup.digits = 9;
    right.settings.preferences.scheme = pinhole_figure::Scheme::Grey;
    right.settings.setup.items.set(pinhole_figure::overlay_items::Item::Labels, false);
    right.selection =
        Some(pinhole_core::Selection::Pixel(pinhole_core::Pixel { row: 3, column: 4 }));
    Store::at(&path).save(&Remembered::default(), &right).unwrap();
    let text = fs::read_to_string(&path).unwrap();
    let wrong = [
        ("\"digits\": 9", "\"digits\": \"nine\"", Remembered::default().settings.setup.digits),
        ("\"Grey\"", "\"Purple\"", 9),
        ("\"zoom\": 1.0", "\"zoom\": null", 9),
    ];
    for (value, by, digits) in wrong {
        assert!(text.contains(value), "{value} in {text}");
        fs::write(&path, text.replace(value, by)).unwrap();
        let read = Store::at(&path).load();
        let mut expected = right.clone();
        expected.settings.setup.digits = digits;
        if value == "\"Grey\"" {
            expected.settings.preferences.scheme = pinhole_figure::Scheme::Standard;
        }
        assert_eq!(read, expected, "{by}");
    }
}

#[test]
fn changes_that_were_discarded_are_gone() {
    let folder = tempfile::tempdir().unwrap();
    let store = Store::at(&folder.path().join("state.json"));
    let mut window = window_with("canonical", Remembered::default(), Some(store.clone()));
    type_into(&mut window, "eye x", "7");
    ctrl(&mut window, egui::Key::Q);
    window.get_by_label("Discard").click();
    window.run();
    window.state_mut().on_exit();
    assert_eq!(store.load().last.as_deref(), Some(std::path::Path::new("canonical")));
    drop(window);
    let window = window_with("canonical", Remembered::default(), Some(store));
    assert_eq!(texts_with(&window, "Restore"), Vec::<String>::new());
}

#[test]
fn a_small_or_much_enlarged_window_still_has_its_views_afterwards() {
    let mut window = window("canonical");
    for size in [[320.0, 240.0], [200.0, 100.0], [320.0, 200.0], [1280.0, 800.0]] {
        window.set_size(size.into());
        window.run();
    }
    let settings = window.state().session().settings();
    assert!(
        [Split::Views, Split::Readouts].into_iter().all(|s| settings
            .preferences
            .splits
            .get(s)
            .is_finite())
    );
    for view in ["World view", "Camera view"] {
        let rect = window.get_by_role_and_label(Role::Image, view).rect();
        assert!(rect.width() > 100.0 && rect.height() > 100.0, "{view}: {rect:?}");
    }
}

#[test]
fn settings_out_of_range_are_brought_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("state.json");
    fs::write(&path, r#"{"settings": {"digits": 70000, "splits": {"views": -3}}}"#).unwrap();
    let window = window_with("canonical", Store::at(&path).load(), None);
    let settings = window.state().session().settings();
    assert_eq!(settings.setup.digits, 17);
    assert!((0.0..=1.0).contains(&settings.preferences.splits.get(Split::Views)));
}

#[test]
fn a_camera_is_imported_from_a_file_and_the_notice_goes_by_itself() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("camera.txt");
    fs::write(&file, "gluLookAt(4, 3, 3, 0, 0, 0, 0, 1, 0);").unwrap();
    let mut window = window("canonical");
    let before = window.state().document().clone();
    command(&mut window, "Import a camera");
    type_path(&mut window, &file);
    window.key_press(egui::Key::Enter);
    window.run_steps(3);
    assert_eq!(window.state().document().camera.eye.to_array(), [4.0, 3.0, 3.0]);
    assert_says(&window, "Camera imported: literal numbers");
    window.run_steps(60);
    assert!(texts_with(&window, "Camera imported").is_empty(), "it goes by itself");
    ctrl(&mut window, egui::Key::Z);
    assert_eq!(*window.state().document(), before);
    fs::write(&file, "no camera").unwrap();
    command(&mut window, "Import a camera");
    type_path(&mut window, &file);
    window.key_press(egui::Key::Enter);
    window.run_steps(3);
    assert_eq!(*window.state().document(), before);
    assert_says(&window, "Not imported: this camera cannot be read");
}
