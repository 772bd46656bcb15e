//! The desktop's file dialog, answered in place of the desktop: what the window makes of its answers.

use std::fs;
use std::path::Path;

use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::ui::app::App;
use pinhole::ui::widgets::path_field::FileAnswer;
use pinhole_exchange::document::Document;
use pinhole_exchange::scene_file;

use crate::harness::{assert_says, says, type_into, window};

/// A window on a desktop with a file dialog.
fn on_desktop(scene: impl AsRef<Path>) -> Harness<'static, App> {
    let mut window = window(scene);
    window.state_mut().use_desktop_dialog();
    window
}

fn press(window: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    window.key_press_modifiers(modifiers, key);
    window.run();
}

/// Answers the dialog that is open.
fn answer(window: &mut Harness<'_, App>, answer: FileAnswer) {
    assert!(window.state_mut().file_request().is_some());
    window.state_mut().answer_file(answer);
    window.run();
    assert!(window.state_mut().file_request().is_none());
}

#[test]
fn a_chosen_scene_opens_after_the_question_about_changes() {
    let folder = tempfile::tempdir().unwrap();
    let other = folder.path().join("other.toml");
    scene_file::save(&Document::default(), &other, None).unwrap();
    let mut window = on_desktop("look-at");
    type_into(&mut window, "eye x", "7");
    press(&mut window, Modifiers::COMMAND, Key::O);
    answer(&mut window, FileAnswer::Chosen(other));
    assert_says(&window, "Save the changes to look-at?");
    window.get_by_label("Discard").click();
    window.run();
    assert_eq!(*window.state().document(), Document::default());
}

#[test]
fn what_waits_for_saving_is_given_up_with_the_dialog() {
    let mut window = on_desktop("canonical");
    type_into(&mut window, "eye x", "7");
    press(&mut window, Modifiers::COMMAND, Key::Q);
    window.get_by_label("Save").click();
    window.run();
    let request = window.state_mut().file_request().cloned().unwrap();
    assert_eq!((&*request.name, request.question.writes), ("canonical.toml", Some("toml")));
    answer(&mut window, FileAnswer::Cancelled);
    assert!(!says(&window, "Cancel"), "no dialog");
    assert_says(&window, "canonical*");
    assert_eq!(window.state().document().camera.eye.x, 7.0);
}

#[test]
fn nothing_is_written_over_what_the_scene_is_read_from() {
    let folder = tempfile::tempdir().unwrap();
    let [scene, spheres] = ["scene.toml", "spheres.csv"].map(|name| folder.path().join(name));
    fs::write(&spheres, "x,y,z,r\n0,0,-5,1\n").unwrap();
    let text = "pinhole = 1\nspheres = \"spheres.csv\"\n[camera]\neye = [0.0, 0.0, 0.0]\n\
                at = [0.0, 0.0, -1.0]\nup = [0.0, 1.0, 0.0]\n";
    fs::write(&scene, text).unwrap();
    let mut window = on_desktop(&scene);
    press(&mut window, Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    answer(&mut window, FileAnswer::Chosen(spheres.clone()));
    assert_says(&window, "The scene was not saved");
    assert_eq!(fs::read_to_string(&spheres).unwrap(), "x,y,z,r\n0,0,-5,1\n");
}

#[test]
fn a_folder_and_a_dialog_that_does_not_work_leave_the_list() {
    let folder = tempfile::tempdir().unwrap();
    let listed = folder.path().join("listed.toml");
    scene_file::save(&Document::default(), &listed, None).unwrap();
    for given in [FileAnswer::Chosen(folder.path().to_owned()), FileAnswer::Unavailable] {
        let works = given != FileAnswer::Unavailable;
        let mut window = on_desktop(&listed);
        press(&mut window, Modifiers::COMMAND, Key::O);
        answer(&mut window, given);
        assert!(says(&window, "Up"), "the list");
        window.get_by_label("Cancel").click();
        window.run();
        press(&mut window, Modifiers::COMMAND, Key::O);
        assert_eq!(window.state_mut().file_request().is_some(), works);
    }
}
