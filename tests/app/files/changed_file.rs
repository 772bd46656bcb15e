//! A scene's file that another program changes while it is open.

use std::fs;
use std::path::PathBuf;

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;
use pinhole_exchange::scene_file;

use crate::harness::{assert_says, says, texts_with, type_into, unfolded, window_with};

const MINE: &str = "# Mine.\n\npinhole = 1\n\n[camera]\neye = [0.0, 0.0, 0.0]\n\
                    at = [0.0, 0.0, -1.0]\nup = [0.0, 1.0, 0.0]\n";
const QUESTION: &str = "Another program has changed mine.toml";

/// A window on a file in a folder.
fn opened() -> (tempfile::TempDir, PathBuf, Harness<'static, App>) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    fs::write(&path, MINE).unwrap();
    let remembered = Remembered { settings: unfolded(), ..Remembered::default() };
    let window = window_with(&path, remembered, None);
    (folder, path, window)
}

/// Two seconds in which the window looks at the file, as it does each second.
fn look(window: &mut Harness<'_, App>) -> bool {
    let news = [(); 2].map(|()| window.state_mut().look_at_file());
    window.run();
    news[1]
}

fn press(window: &mut Harness<'_, App>, button: &str) {
    window.get_by_role_and_label(Role::Button, button).click();
    window.run();
}

fn save(window: &mut Harness<'_, App>) {
    window.key_press_modifiers(Modifiers::COMMAND, Key::S);
    window.run();
}

fn theirs(path: &PathBuf) {
    fs::write(path, MINE.replace("eye = [0.0", "eye = [12.5").replace("Mine", "Theirs")).unwrap();
}

fn eye_x(window: &Harness<'_, App>) -> f64 {
    window.state().document().camera.eye.x
}

#[test]
fn it_is_read_again_in_one_step_where_nothing_is_unsaved() {
    let (_folder, path, mut window) = opened();
    assert!(!look(&mut window), "nobody has changed it");
    theirs(&path);
    assert!(look(&mut window));
    assert_eq!(eye_x(&window), 12.5);
    assert_says(&window, "mine.toml");
    assert_says(&window, "mine.toml was changed by another program and has been read again");
    assert!(!look(&mut window), "told once");
    window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.run();
    assert_eq!(eye_x(&window), 0.0);
    assert_says(&window, "mine.toml*");
}

#[test]
fn its_table_of_spheres_is_read_again_too_and_saving_leaves_it_alone() {
    let folder = tempfile::tempdir().unwrap();
    let [path, table] = ["mine.toml", "balls.csv"].map(|name| folder.path().join(name));
    let one = "x,y,z,r\n0,0,-5,1\n";
    fs::write(&table, one).unwrap();
    fs::write(&path, MINE.replace("\n[camera]", "spheres = \"balls.csv\"\n\n[camera]")).unwrap();
    let remembered = Remembered { settings: unfolded(), ..Remembered::default() };
    let mut window = window_with(&path, remembered, None);
    let count = |window: &Harness<'_, App>| window.state().document().object_count();
    assert!(!look(&mut window), "nobody has changed it");
    let two = format!("{one}2,0,-5,1\n");
    fs::write(&table, &two).unwrap();
    assert!(look(&mut window));
    assert_eq!(count(&window), 2);
    assert_says(&window, "balls.csv was changed by another program and has been read again");

    type_into(&mut window, "eye x", "3");
    fs::write(&table, one).unwrap();
    save(&mut window);
    assert_eq!(scene_file::load(&path).unwrap().camera.eye.x, 3.0);
    assert_eq!(fs::read_to_string(&table).unwrap(), one);
    assert!(look(&mut window), "a save hides no change of the table");
    assert_eq!(count(&window), 1);
    type_into(&mut window, "eye x", "4");
    fs::write(&table, two).unwrap();
    look(&mut window);
    assert_says(&window, "Another program has changed balls.csv");
    press(&mut window, "Keep mine");
    assert!(!look(&mut window), "answered");
    assert_eq!(eye_x(&window), 4.0);
}

#[test]
fn a_file_that_was_only_touched_is_no_news() {
    let (_folder, path, mut window) = opened();
    fs::write(&path, MINE).unwrap();
    look(&mut window);
    assert_eq!(texts_with(&window, "changed"), Vec::<String>::new());
    type_into(&mut window, "eye x", "3");
    save(&mut window);
    assert_eq!(scene_file::load(&path).unwrap().camera.eye.x, 3.0);
    assert!(!look(&mut window), "our own save is not another program's");
}

#[test]
fn a_file_that_cannot_be_read_any_more_leaves_what_is_open() {
    let (_folder, path, mut window) = opened();
    fs::write(&path, "pinhole = ").unwrap();
    look(&mut window);
    assert_eq!(eye_x(&window), 0.0);
    let title = "The changed scene cannot be read";
    assert_says(&window, title);
    press(&mut window, "Close");
    assert!(!look(&mut window), "told once");
    let mend = |eye: &str| fs::write(&path, MINE.replace("eye = [0.0", eye)).unwrap();
    mend("eye = [2.5");
    look(&mut window);
    assert_eq!(eye_x(&window), 2.5);
    fs::write(&path, "pinhole = ").unwrap();
    look(&mut window);
    assert_says(&window, title);
    mend("eye = [3.5");
    look(&mut window);
    assert_eq!(eye_x(&window), 3.5);
    assert!(!says(&window, title), "the message goes with its cause");
}

#[test]
fn a_file_that_is_removed_is_told_and_may_be_saved_again() {
    let (_folder, path, mut window) = opened();
    let told = "mine.toml was removed by another program";
    fs::remove_file(&path).unwrap();
    assert!(look(&mut window));
    assert_says(&window, told);
    assert!(!look(&mut window), "told once");
    save(&mut window);
    assert_eq!(fs::read_to_string(&path).unwrap(), MINE);
    fs::remove_file(&path).unwrap();
    look(&mut window);
    theirs(&path);
    assert!(look(&mut window), "it is there again");
    assert_eq!(eye_x(&window), 12.5);
}

#[test]
fn saving_asks_before_it_replaces_what_another_program_wrote() {
    let (_folder, path, mut window) = opened();
    type_into(&mut window, "eye x", "3");
    theirs(&path);
    save(&mut window);
    assert_says(&window, QUESTION);
    assert_eq!(scene_file::load(&path).unwrap().camera.eye.x, 12.5, "not before it is answered");
    press(&mut window, "Cancel");
    assert!(!says(&window, QUESTION));
    save(&mut window);
    press(&mut window, "Keep mine");
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.contains("eye = [3.0"), "{text}");
    assert_says(&window, "mine.toml");
}

#[test]
fn theirs_are_taken_and_mine_come_back_by_undo() {
    let (_folder, path, mut window) = opened();
    type_into(&mut window, "eye x", "3");
    theirs(&path);
    assert!(look(&mut window), "told while they are unsaved, too");
    assert_says(&window, QUESTION);
    press(&mut window, "Take theirs");
    assert_eq!(eye_x(&window), 12.5);
    assert_says(&window, "mine.toml");
    window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.run();
    assert_eq!(eye_x(&window), 3.0);
    assert_says(&window, "mine.toml*");
}

#[test]
fn mine_are_kept_and_the_next_save_does_not_ask_again() {
    let (_folder, path, mut window) = opened();
    type_into(&mut window, "eye x", "3");
    theirs(&path);
    look(&mut window);
    press(&mut window, "Keep mine");
    assert_eq!(scene_file::load(&path).unwrap().camera.eye.x, 12.5, "nothing is saved yet");
    save(&mut window);
    assert!(!says(&window, QUESTION));
    assert_eq!(scene_file::load(&path).unwrap().camera.eye.x, 3.0);
}

#[test]
fn mine_are_saved_elsewhere() {
    let (folder, path, mut window) = opened();
    type_into(&mut window, "eye x", "3");
    theirs(&path);
    save(&mut window);
    press(&mut window, "Save as…");
    crate::harness::export_to(&mut window, &folder.path().join("other.toml"));
    window.run();
    assert_eq!(scene_file::load(&path).unwrap().camera.eye.x, 12.5);
    assert_eq!(scene_file::load(&folder.path().join("other.toml")).unwrap().camera.eye.x, 3.0);
}

#[test]
fn nothing_is_exported_over_the_scene_or_saved_over_its_spheres() {
    let (folder, path, mut window) = opened();
    drop(window);
    let csv = folder.path().join("balls.toml");
    fs::write(&csv, "x,y,z,r\n0,0,-5,1\n").unwrap();
    let text = MINE.replace("pinhole = 1\n", "pinhole = 1\nspheres = \"balls.toml\"\n");
    let figure = folder.path().join("mine.svg");
    fs::write(&path, &text).unwrap();
    fs::write(&figure, &text).unwrap();
    window = window_with(&figure, Remembered::default(), None);
    window.key_press_modifiers(Modifiers::COMMAND, Key::E);
    window.run();
    crate::harness::export_to(&mut window, &figure);
    window.run();
    press(&mut window, "Export");
    let why = format!("The scene is read from {}: choose another name.", figure.display());
    assert_says(&window, &why);
    assert_eq!(fs::read_to_string(&figure).unwrap(), text);
    press(&mut window, "Close");
    window.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    window.run();
    crate::harness::export_to(&mut window, &csv);
    window.run();
    press(&mut window, "Save");
    assert_says(
        &window,
        &format!("The scene is read from {}: choose another name.", csv.display()),
    );
    assert_eq!(fs::read_to_string(&csv).unwrap(), "x,y,z,r\n0,0,-5,1\n");
}
