//! A window that ends without being asked: its unsaved changes are offered at the next start.

use std::path::Path;
use std::time::{Duration, Instant};

use egui::accesskit::Role;
use egui::{Context, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::files::OpenDocument;
use pinhole::model::session::Settings;
use pinhole::model::store::{Remembered, Store};
use pinhole::ui::app::App;
use pinhole_exchange::scenes::{BuiltinScene, SceneSource};

use crate::harness::{assert_says, says, texts_with, type_into, unfolded, window_with};
use crate::support::{self, whole_window};

const OFFER: &str = "Restore the unsaved changes to ";

const MINE: &str = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nat = [0, 0, -1]\nup = [0, 1, 0]\n";

fn opened(store: &Store, scene: impl AsRef<Path>) -> Harness<'static, App> {
    let remembered = Remembered { settings: unfolded(), ..Remembered::default() };
    window_with(scene, remembered, Some(store.clone()))
}

fn scenes_written(store: &Store) -> usize {
    let files = std::fs::read_dir(store.unsaved()).unwrap();
    files.filter(|file| file.as_ref().unwrap().path().extension() == Some("toml".as_ref())).count()
}

/// A window in which the eye was moved; the change is written aside within two seconds.
fn changed(store: &Store, scene: impl AsRef<Path>) -> Harness<'static, App> {
    let before = scenes_written(store);
    let mut window = opened(store, scene);
    press(&mut window, "Not now");
    type_into(&mut window, "eye x", "0.375");
    let start = window.ctx.input(|i| i.time);
    while window.ctx.input(|i| i.time) < start + 2.0 {
        window.step();
    }
    let start = Instant::now();
    while scenes_written(store) == before && start.elapsed() < Duration::from_secs(20) {
        std::thread::sleep(Duration::from_millis(5));
    }
    assert_eq!(scenes_written(store), before + 1);
    window
}

fn press(window: &mut Harness<'_, App>, button: &str) {
    if let Some(button) = window.query_by_role_and_label(Role::Button, button) {
        button.click();
    }
    window.run();
}

fn store() -> (tempfile::TempDir, Store) {
    let folder = tempfile::tempdir().unwrap();
    let store = Store::at(&folder.path().join("state.json"));
    std::fs::create_dir_all(store.unsaved()).unwrap();
    (folder, store)
}

#[test]
fn changes_of_a_window_that_was_killed_are_offered_and_restored() {
    let (_folder, store) = store();
    let killed = changed(&store, "look-at");
    let wanted = killed.state().document().clone();
    assert!(!says(&opened(&store, "canonical"), &format!("{OFFER}look-at?")), "it is still open");
    drop(killed);
    let mut window = opened(&store, "canonical");
    assert_says(&window, &format!("{OFFER}look-at?"));
    press(&mut window, "Restore");
    assert_eq!(*window.state().document(), wanted);
    assert_says(&window, "look-at*");
    assert!(texts_with(&window, OFFER).is_empty());
    window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.run();
    drop(window);
    assert!(texts_with(&opened(&store, "canonical"), OFFER).is_empty(), "offered once");
}

#[test]
fn two_windows_lose_nothing_to_each_other() {
    let (_folder, store) = store();
    let (first, second) = (changed(&store, "look-at"), changed(&store, "planet"));
    drop((first, second));
    let mut window = opened(&store, "canonical");
    for _ in 0..2 {
        assert!(!texts_with(&window, OFFER).is_empty());
        press(&mut window, "Discard");
    }
    assert!(texts_with(&window, OFFER).is_empty());
    assert_eq!(scenes_written(&store), 0);
}

#[test]
fn what_is_saved_or_given_up_is_not_offered() {
    let (folder, store) = store();
    let path = folder.path().join("mine.toml");
    std::fs::write(&path, MINE).unwrap();
    let mut saved = changed(&store, &path);
    saved.key_press_modifiers(Modifiers::COMMAND, Key::S);
    saved.run();
    assert_eq!(scenes_written(&store), 0);
    assert!(std::fs::read_to_string(&path).unwrap().contains("0.375"));
    drop(saved);
    let mut undone = changed(&store, "look-at");
    undone.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    undone.run();
    assert_eq!(scenes_written(&store), 0);
}

#[test]
fn a_window_whose_display_went_away_writes_its_last_change() {
    let (_folder, store) = store();
    let mut window = changed(&store, "look-at");
    type_into(&mut window, "eye y", "1.25");
    window.state_mut().on_exit();
    let wanted = window.state().document().clone();
    drop(window);
    let mut window = opened(&store, "canonical");
    press(&mut window, "Restore");
    assert_eq!(*window.state().document(), wanted);
}

#[test]
fn what_was_restored_survives_a_window_that_is_killed_at_once() {
    let (_folder, store) = store();
    drop(changed(&store, "look-at"));
    for _ in 0..3 {
        let mut window = opened(&store, "canonical");
        press(&mut window, "Restore");
        assert_eq!(window.state().document().camera.eye.x, 0.375);
    }
}

#[test]
fn what_is_opened_as_a_new_scene_leaves_the_file_alone() {
    let (folder, store) = store();
    let path = folder.path().join("mine.toml");
    std::fs::write(&path, MINE).unwrap();
    let killed = changed(&store, &path);
    let wanted = killed.state().document().clone();
    drop(killed);
    let mut window = opened(&store, "canonical");
    assert_says(&window, &path.display().to_string());
    press(&mut window, "Open as a new scene");
    assert_eq!(*window.state().document(), wanted);
    assert_says(&window, "mine.toml, unsaved*");
    window.key_press_modifiers(Modifiers::COMMAND, Key::S);
    window.run();
    assert_says(&window, "Save the scene as");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), MINE);
}

#[test]
fn each_window_s_changes_are_offered_whatever_else_there_is_to_tell() {
    let (_folder, store) = store();
    drop((changed(&store, "look-at"), changed(&store, "planet")));
    let mut window = opened(&store, "canonical");
    let first = texts_with(&window, OFFER);
    press(&mut window, "Not now");
    let second = texts_with(&window, OFFER);
    assert!(!first.is_empty() && !second.is_empty() && first != second, "{first:?} {second:?}");
    drop(window);
}

#[test]
fn changes_are_offered_after_what_is_told_at_the_start() {
    let (_folder, store) = store();
    drop(changed(&store, "look-at"));
    let source = SceneSource::Builtin(BuiltinScene::find("canonical").unwrap());
    let open = OpenDocument::open(source).unwrap();
    let mut app = App::new(open, Remembered::default(), Some(store.clone()));
    app.show_message("The last scene cannot be opened again", "It is gone.".to_owned());
    let set_up = |ctx: &Context| App::set_up(ctx, &Settings::default());
    let mut window = support::harness()
        .with_max_steps(30)
        .with_context_setup(set_up)
        .build_ui_state(whole_window::show, app);
    window.run();
    assert_says(&window, "It is gone.");
    press(&mut window, "Close");
    assert!(!texts_with(&window, OFFER).is_empty());
}

#[test]
fn a_window_that_is_hidden_writes_at_once_what_waits() {
    let (_folder, store) = store();
    let mut window = opened(&store, "look-at");
    // One frame after the edit, so that nothing is written yet.
    window.get_by_role_and_label(Role::SpinButton, "eye x").click();
    window.run();
    window.get_by_role_and_label(Role::SpinButton, "eye x").type_text("0.375");
    window.run();
    window.key_press(Key::Enter);
    window.step();
    assert_eq!((window.state().document().camera.eye.x, scenes_written(&store)), (0.375, 0));
    window.state_mut().rest();
    let start = Instant::now();
    while scenes_written(&store) == 0 && start.elapsed() < Duration::from_secs(20) {
        std::thread::sleep(Duration::from_millis(5));
    }
    assert_eq!(scenes_written(&store), 1);
}

#[test]
fn numbers_that_no_file_may_have_are_no_reason_to_lose_the_others() {
    let (folder, store) = store();
    let path = folder.path().join("mine.toml");
    let objects = "[[sphere]]\ncenter = [0, 0, -5]\nradius = 1\n\
                   [[plane]]\npoint = [0, 0, -6]\nnormal = [0, 0, 1]\n";
    std::fs::write(&path, format!("{MINE}{objects}")).unwrap();
    let mut window = opened(&store, &path);
    type_into(&mut window, "eye x", "0.375");
    type_into(&mut window, "distance", "-2");
    crate::harness::choose_object(&mut window, "sphere 0");
    type_into(&mut window, "radius", "0");
    crate::harness::choose_object(&mut window, "plane 1");
    type_into(&mut window, "normal z", "0");
    let wanted = window.state().document().clone();
    assert_eq!((wanted.camera.viewport.distance, wanted.spheres[0].shape.radius), (-2.0, 0.0));
    window.state_mut().on_exit();
    drop(window);
    let mut window = opened(&store, "canonical");
    press(&mut window, "Restore");
    assert_eq!(*window.state().document(), wanted);
}

#[test]
fn a_file_that_was_changed_since_is_not_written_over_without_a_question() {
    let (folder, store) = store();
    let path = folder.path().join("mine.toml");
    std::fs::write(&path, MINE).unwrap();
    drop(changed(&store, &path));
    let theirs = MINE.replace("eye = [0", "eye = [12.5");
    std::fs::write(&path, &theirs).unwrap();
    let mut window = opened(&store, "canonical");
    press(&mut window, "Restore");
    window.key_press_modifiers(Modifiers::COMMAND, Key::S);
    window.run();
    assert_says(&window, "Another program has changed mine.toml");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), theirs);
}
