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

#[test]
fn a_step_whose_table_is_gone_says_so_and_the_one_before_stays() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    let table = "x,y,z,r\n0,0,-9,1\n0,1,-9,1\n";
    write("many.csv", table);
    let camera = "[camera]\neye = [0, 0, 0]\nat = [0, 0, -1]\nup = [0, 1, 0]\n";
    write("many.toml", &format!("pinhole = 1\nspheres = \"many.csv\"\n{camera}"));
    let step =
        |scene: &str| format!("[[step]]\ntitle = \"One\"\ntext = \"Look.\"\nscene = \"{scene}\"\n");
    let steps = [step("roll"), step("many.toml")].concat();
    write("mine.toml", &format!("pinhole_lesson = 1\ntitle = \"Mine\"\n{steps}"));
    let mut window = window("canonical");
    drop_file(&mut window, &folder.path().join("mine.toml"));
    std::fs::remove_file(folder.path().join("many.csv")).unwrap();
    let before = window.state().document().clone();
    press(&mut window, "Next");
    assert_says(&window, "This step cannot be shown");
    press(&mut window, "Close");
    assert_eq!(window.state().document(), &before);
    assert_eq!(window.state().lesson().unwrap().id().step, 0);
    write("many.csv", table);
    press(&mut window, "Next");
    let shown = window.state().document();
    assert_eq!(shown.csv_spheres.as_ref().unwrap().items.spheres.len(), 2);
    assert_eq!(window.state().lesson().unwrap().id().step, 1);
    assert_says(&window, "Mine · 2 of 2 · One");
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
