//! A teacher's own lesson, from a file.

use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::lessons::{LessonArgument, Which};
use pinhole_core::DVec3;

use super::press;
use crate::app::files::scene_files::drop_file;
use crate::harness::{assert_says, command, window};

/// 1 / sqrt 2.
const S: f64 = std::f64::consts::FRAC_1_SQRT_2;

#[test]
fn a_teachers_own_lesson_opens_and_is_in_the_contents() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    let step = "[[step]]\ntitle = \"One\"\ntext = \"Look.\"\nscene = \"roll\"\n";
    std::fs::write(&path, format!("pinhole_lesson = 1\ntitle = \"My lesson\"\n{step}")).unwrap();
    let (id, file) = LessonArgument::parse(path.to_str().unwrap()).unwrap().load().unwrap();
    let mut window = window("canonical");
    window.state_mut().open_lesson(id, file);
    window.run();
    assert_says(&window, "My lesson · 1 of 1 · One");
    assert_says(&window, "Look.");
    let next = window.get_by_role_and_label(Role::Button, "Next");
    assert!(next.accesskit_node().is_disabled());
    window.get_by_label("Contents").click();
    window.run();
    window.get_by_label("2. Its basis").click();
    window.run();
    window.get_by_label("Contents").click();
    window.run();
    window.get_by_label("1. One").click();
    window.run();
    assert_says(&window, "Look.");
}

#[test]
fn a_lesson_file_opens_like_a_scene_and_a_bad_one_says_what_is_wrong() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path
    };
    let step = "[[step]]\ntitle = \"One\"\ntext = \"Look.\"\nscene = \"forty-five\"\n";
    let good = write("good.toml", &format!("pinhole_lesson = 1\ntitle = \"Mine\"\n{step}"));
    let bad = write("bad.toml", &format!("pinhole_lesson = 1\ntitle = \"Mine\"\n{step}show = 3\n"));
    let mut window = window("canonical");
    drop_file(&mut window, &bad);
    assert_says(&window, "This lesson cannot be opened");
    press(&mut window, "Close");
    assert!(window.state().lesson().is_none());
    drop_file(&mut window, &good);
    let lesson = window.state().lesson().unwrap();
    assert_eq!((lesson.short_title().as_str(), lesson.id().lesson), ("Mine", Which::File));
    assert!(
        window
            .state()
            .document()
            .camera
            .resolve()
            .unwrap()
            .basis()
            .u
            .abs_diff_eq(DVec3::new(S, 0.0, -S), 1e-15)
    );
}

/// The page would have other steps than the window.
#[test]
fn a_lesson_that_was_changed_meanwhile_is_not_saved_as_a_page() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    let step = "[[step]]\ntitle = \"One\"\ntext = \"Look.\"\nscene = \"roll\"\n";
    let text = format!("pinhole_lesson = 1\ntitle = \"Mine\"\n{step}");
    std::fs::write(&path, &text).unwrap();
    let mut window = window("canonical");
    drop_file(&mut window, &path);
    std::fs::write(&path, text.replace("roll", "grazing")).unwrap();
    command(&mut window, "Save as a page");
    window.get_by_role_and_label(Role::TextInput, "path").focus();
    window.run();
    window.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::A);
    let page = folder.path().join("mine.html");
    window.get_by_role_and_label(Role::TextInput, "path").type_text(page.to_str().unwrap());
    window.run();
    window.key_press(egui::Key::Enter);
    window.run();
    assert_says(&window, "The page was not saved");
    let reason = "has changed since the lesson was opened: open it again, then save the page";
    assert_says(&window, &format!("{}: {reason}", path.display()));
}
