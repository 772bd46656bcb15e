//! What is shown, saved as the last step of a lesson's file.

use std::fs;
use std::path::Path;

use egui::Key;
use pinhole::model::ViewLayout;
use pinhole::model::lessons::load;
use pinhole_exchange::BuiltinScene;
use pinhole_figure::{Concept, Item};

use super::{Window, at_step, key, press};
use crate::app::files::scene_files::drop_file;
use crate::harness::{assert_says, command, export_to, show, texts_with, type_into, window};

fn save(window: &mut Window, path: &Path) {
    command(window, "Save this view as a step");
    export_to(window, path);
    window.run();
}

/// Fails unless the last step of a lesson's file shows what the window shows.
#[track_caller]
fn assert_plays(path: &Path, from: &Window) {
    let mut window = window("planet");
    drop_file(&mut window, path);
    (1..load(path).unwrap().steps.len()).for_each(|_| key(&mut window, Key::PageDown));
    let [a, b] = [&window, from].map(|window| {
        let (document, session) = (window.state().document(), window.state().session());
        let (setup, lines) = (session.shown.setup, &session.shown.lines);
        (
            (document.camera, document.spheres.clone(), document.planes.clone()),
            (
                session.shown.observer.unwrap().stored(),
                session.shown.selection,
                session.shown.ray_point_t,
            ),
            (session.shown.formulas.clone(), session.shown.sections, session.shown.highlighted),
            setup,
            (setup.layout == ViewLayout::Lines)
                .then(|| (lines.line(), lines.ray, lines.t, lines.shown, lines.trail)),
            (setup.layout == ViewLayout::Mistakes).then_some(session.shown.mistakes_view.chosen),
        )
    });
    assert_eq!(a, b);
}

#[test]
fn views_become_the_steps_of_a_lesson_and_play_as_they_were() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("scenes")).unwrap();
    let (scene, path) = (folder.path().join("scenes/mine.toml"), folder.path().join("class.toml"));
    fs::write(&scene, BuiltinScene::find("look-at").unwrap().text).unwrap();
    let mut window = window(&scene);
    command(&mut window, "Views: Observer nearer");
    command(&mut window, &format!("Show: {}", Item::Ring.label()));
    save(&mut window, &path);
    assert_says(&window, "Saved step 1 to class.toml");
    let first = fs::read_to_string(&path).unwrap();
    let begin = "pinhole_lesson = 1\ntitle = \"class\"\n\n[[step]]\ntitle = \"Step 1\"\n";
    assert!(
        first.starts_with(begin) && first.contains("\nscene = \"scenes/mine.toml\"\n"),
        "{first}"
    );
    assert_plays(&path, &window);

    // Another editor leaves other line ends, and none at the end. A change that is not saved is in the step.
    let first = format!("{}\r\n# mine", first.trim_end().replace('\n', "\r\n"));
    fs::write(&path, &first).unwrap();
    type_into(&mut window, "eye x", "0.25");
    show(&mut window, ViewLayout::Derivation);
    command(&mut window, "Shading: t");
    save(&mut window, &path);
    let second = fs::read_to_string(&path).unwrap();
    let added = second.strip_prefix(&first).expect("the lesson as it was");
    assert!(added.starts_with("\r\n\r\n[[step]]\r\ntitle = \"Step 2\"\r\n"), "{added}");
    assert_eq!(added.matches('\n').count(), added.matches("\r\n").count());
    assert!(added.contains("[step.camera]") && !added.contains("step.sphere"), "{added}");
    assert_plays(&path, &window);

    // The next step of the open lesson is there at once, and goes on with the scene.
    drop_file(&mut window, &path);
    press(&mut window, "Discard");
    key(&mut window, Key::PageDown);
    command(&mut window, "Views: Look along x");
    save(&mut window, &path);
    let third = fs::read_to_string(&path).unwrap();
    assert!(!third[second.len()..].contains("scene"), "{third}");
    key(&mut window, Key::PageDown);
    assert_eq!(window.state().lesson().unwrap().id().step, 2);
    assert_plays(&path, &window);
}

#[test]
fn a_scene_without_a_file_is_saved_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("class.toml");
    for (lesson, step) in [(1, 2), (7, 3), (8, 2), (10, 2), (11, 1), (11, 2), (11, 3), (12, 3)] {
        let mut open = at_step(lesson, step);
        command(&mut open, "Views: Observer nearer");
        save(&mut open, &path);
        assert_plays(&path, &open);
    }
    let presented = load(&path).unwrap();
    let subject = |step: usize| presented.steps[step].shown.subject.clone();
    assert_eq!((subject(0), subject(1)), (vec![], vec![Concept::Up, Concept::W]));
    let mut empty = window("canonical");
    command(&mut empty, "File: New");
    save(&mut empty, &path);
    assert_plays(&path, &empty);
}

#[test]
fn what_is_no_lesson_stays_as_it_is_and_says_why() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("class.toml");
    let scene = BuiltinScene::find("roll").unwrap().text;
    let broken = "pinhole_lesson = 1\ntitle = \"Mine\"\n[[step]]\ntitle = 1\n";
    for (text, why) in [(broken, "class.toml:4:9: step 1.title is 1"), (scene, "pinhole_lesson")] {
        fs::write(&path, text).unwrap();
        let mut window = window("look-at");
        save(&mut window, &path);
        assert_says(&window, "This view was not saved");
        let told = texts_with(&window, "class.toml");
        assert!(told.iter().any(|told| told.contains(why)), "{why}: {told:?}");
        assert_eq!(fs::read_to_string(&path).unwrap(), text);
    }
    let mut class = window("look-at");
    show(&mut class, ViewLayout::Class);
    save(&mut class, &path);
    assert_says(&class, "This view was not saved");
    assert_eq!(fs::read_to_string(&path).unwrap(), scene);
    let mut itself = window(&path);
    save(&mut itself, &path);
    assert_says(&itself, "This view was not saved");
}
