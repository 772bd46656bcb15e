//! From a scene of one's own into the lessons and back: nothing is lost, and nothing stays behind.

use std::path::Path;

use egui::Key;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::lessons::{StepId, Which};
use pinhole::model::session::{Settings, Setup, ViewLayout};
use pinhole::model::store::{Remembered, Store};
use pinhole_exchange::scene_file;

use super::{Window, answer, at_step, go_to, key, press, shown_step};
use crate::app::practice::exercises::answers;
use crate::harness::{assert_says, open_scene, type_into, unfolded, window, window_with};

#[test]
fn lessons_open_from_the_bar_and_close_without_a_trace() {
    let settings = Settings {
        setup: Setup { layout: ViewLayout::Camera, digits: 9, ..Setup::default() },
        ..unfolded()
    };
    let remembered = Remembered { settings, ..Remembered::default() };
    let mut window = window_with("planet", remembered, None);
    let before = window.state().session().settings();
    window.get_by_label("Lessons").click();
    window.run();
    window.get_by_label("Lesson 9: When it breaks").click();
    window.run();
    assert_eq!(shown_step(&window), (9, 1));
    assert_ne!(window.state().session().settings(), before);
    press(&mut window, "Close the lesson");
    assert!(window.state().lesson().is_none());
    assert_eq!(window.state().session().settings(), before);
    assert_says(&window, "Unnamed scene");
    type_into(&mut window, "eye x", "1");
    assert_says(&window, "Unnamed scene*");
}

#[test]
fn a_scene_that_a_step_has_left_as_it_was_has_its_name_again() {
    let mut window = at_step(1, 1);
    assert_says(&window, "Lesson 1, step 1");
    press(&mut window, "Close the lesson");
    assert_says(&window, "canonical");
    type_into(&mut window, "eye x", "1");
    assert_says(&window, "canonical*");
}

#[test]
fn what_was_typed_in_a_steps_question_is_there_when_the_lesson_is_opened_again() {
    let mut window = at_step(2, 5);
    answers(&mut window, "d", &["0.3", "-0.2", "-1"]);
    press(&mut window, "Close the lesson");
    go_to(&mut window, 2, 5);
    let typed = window.get_by_role_and_label(Role::TextInput, "answer d y").value();
    assert_eq!(typed.as_deref(), Some("-0.2"));
}

#[test]
fn a_scenes_changes_are_asked_about_and_a_steps_are_not() {
    let mut window = window("canonical");
    type_into(&mut window, "eye x", "7");
    let open = |window: &mut Window| {
        window.get_by_label("Lessons").click();
        window.run();
        window.get_by_label("Lesson 2: Warm-up").click();
        window.run();
    };
    open(&mut window);
    assert_says(&window, "Save the changes to canonical?");
    press(&mut window, "Cancel");
    assert_eq!(window.state().document().camera.eye.x, 7.0);
    assert!(window.state().lesson().is_none());
    open(&mut window);
    press(&mut window, "Discard");
    assert_eq!(shown_step(&window), (2, 1));
    // Saved, a step's scene is a file like any other.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    type_into(&mut window, "eye x", "3");
    window.key_press_modifiers(egui::Modifiers::COMMAND, Key::S);
    window.run();
    window.get_by_role_and_label(Role::TextInput, "path").focus();
    window.run();
    window.key_press_modifiers(egui::Modifiers::COMMAND, Key::A);
    window.get_by_role_and_label(Role::TextInput, "path").type_text(path.to_str().unwrap());
    window.run();
    key(&mut window, Key::Enter);
    assert_eq!(scene_file::load(&path).unwrap().camera.eye.x, 3.0);
    type_into(&mut window, "eye x", "4");
    answer(&mut window);
    press(&mut window, "Next");
    assert_says(&window, "Save the changes to mine.toml?");
    press(&mut window, "Save");
    assert_eq!(scene_file::load(&path).unwrap().camera.eye.x, 4.0);
    assert_eq!(shown_step(&window), (2, 2));
}

#[test]
fn the_next_run_goes_on_at_the_step_and_has_the_settings_from_before() {
    let folder = tempfile::tempdir().unwrap();
    let store = Store::at(&folder.path().join("state.json"));
    let mut window = window_with("planet", Remembered::default(), Some(store.clone()));
    window.state_mut().open_lesson(StepId { lesson: Which::Builtin(8), step: 1 }, None);
    window.run();
    type_into(&mut window, "eye x", "7");
    window.state_mut().on_exit();
    let remembered = store.load();
    assert_eq!(remembered.lesson_step(), Some(StepId { lesson: Which::Builtin(8), step: 1 }));
    assert_eq!(remembered.last.as_deref(), Some(Path::new("planet")));
    assert_eq!(remembered.settings, Settings::default());
    let written = std::fs::read_dir(store.unsaved()).unwrap();
    let mut endings = written.map(|file| file.unwrap().path().extension().map(|e| e.to_owned()));
    assert!(endings.all(|ending| ending == Some("lock".into())), "a step's changes are no loss");
}

#[test]
fn another_scene_ends_the_lesson() {
    let mut window = at_step(2, 1);
    open_scene(&mut window, "planet");
    assert!(window.state().lesson().is_none());
    let radii: Vec<f64> =
        window.state().document().spheres.iter().map(|item| item.shape.radius).collect();
    assert!(radii.contains(&5000.0), "{radii:?}");
}

/// What a step shows in the panel is as wide as the panel, not the other way round; not even in the
/// pass in which its scroll bar comes or goes.
#[test]
fn the_side_panel_keeps_its_width() {
    let mut window = at_step(3, 2);
    let left =
        |window: &Window| window.get_by_role_and_label(Role::Image, "World view").rect().left();
    let before = left(&window);
    for height in [700.0, 750.0, 800.0] {
        window.set_size(egui::vec2(1024.0, height));
        for way in [Key::PageDown, Key::PageUp, Key::PageDown, Key::PageUp] {
            key(&mut window, way);
            assert_eq!(left(&window), before, "{way:?}, {height}");
        }
    }
}
