//! A student's answers in the window: dropped, graded, shown, and put away.

use pinhole_core::Selection;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;
use pinhole_exchange::images::png;

use crate::app::files::scene_files::drop_file;
use crate::harness::{assert_says, click_at, export_to, says, show, texts_with, type_into, window};

const BACKWARDS: &str = "ux,uy,uz,vx,vy,vz,wx,wy,wz\n-1,0,0,0,1,0,0,0,-1\n";

/// t of the canonical scene's sphere in some of its 400 x 400 pixels: the far root.
fn far_roots(count_from: u32) -> String {
    roots(count_from, 1.0)
}

/// The same, with the right root.
fn near_roots() -> String {
    roots(0, -1.0)
}

fn roots(count_from: u32, sign: f64) -> String {
    let mut text = String::from("row,column,t\n");
    for i in 190..210 {
        for j in 180..220 {
            let u = (f64::from(j) + 0.5) / 400.0 - 0.5;
            let v = 0.5 - (f64::from(i) + 0.5) / 400.0;
            let a = u * u + v * v + 1.0;
            let t = (5.0 + sign * (25.0 - 24.0 * a).sqrt()) / a;
            writeln!(text, "{},{},{t}", i + count_from, j + count_from).unwrap();
        }
    }
    text
}

fn write(folder: &Path, name: &str, text: &str) -> PathBuf {
    let path = folder.join(name);
    fs::write(&path, text).unwrap();
    path
}

fn click(window: &mut Harness<'_, App>, label: &str) {
    window.get_by_role_and_label(Role::Button, label).click_accesskit();
    window.run();
}

fn map_says(window: &Harness<'_, App>) -> String {
    window.get_by_role_and_label(Role::Image, "Answers").accesskit_node().description().unwrap()
}

/// The open scene, without the objects that would be in the way.
fn alone() -> (tempfile::TempDir, Harness<'static, App>) {
    showing("center = [0, 0, -5]\nradius = 1\n")
}

fn showing(sphere: &str) -> (tempfile::TempDir, Harness<'static, App>) {
    let folder = tempfile::tempdir().unwrap();
    let camera =
        "pinhole = 1\n[camera]\neye = [0, 0, 0]\nat = [0, 0, -1]\nup = [0, 1, 0]\n[[sphere]]\n";
    let window = window(write(folder.path(), "s.toml", &format!("{camera}{sphere}")));
    (folder, window)
}

#[test]
fn dropped_hits_are_graded_and_the_worst_is_selected() {
    let (folder, mut window) = alone();
    drop_file(&mut window, &write(folder.path(), "mine.csv", &far_roots(0)));
    assert_eq!(window.state().session().shown.setup.layout, ViewLayout::Answers);
    assert_says(&window, "mine.csv");
    assert_says(&window, "0 of 800 hits agree, within 0.00001 of their distance");
    assert_says(&window, "Mistake: far-root");
    assert_says(
        &window,
        "Look at which root is taken: the smallest t above 0 is the hit, of one object and among all.",
    );
    assert!(map_says(&window).starts_with("0 of 800 hits agree"), "{}", map_says(&window));
    assert!(map_says(&window).contains("Look at which root"), "{}", map_says(&window));
    let worst = texts_with(&window, "right is t = ");
    assert!(worst[0].starts_with("Worst: row 199, column 199 is t = 5.99"), "{worst:?}");
    click(&mut window, "Select the worst pixel");
    let Selection::Pixel(pixel) = window.state().session().shown.selection else { panic!() };
    assert_eq!((pixel.row, pixel.column), (199, 199));
    // The map shows the image as the camera view does, and is clicked likewise.
    let rect = window.get_by_role_and_label(Role::Image, "Answers").rect();
    let image = &window.state().derived().second_view.as_ref().unwrap().image;
    assert_eq!(image.size, window.state().derived().camera_view.clone().unwrap().image.size);
    let wrong = egui::Color32::from_rgb(0xd5, 0x5e, 0x00);
    let share = image.pixels.iter().filter(|color| **color == wrong).count() as f32
        / image.pixels.len() as f32;
    assert!((0.5 * 0.005..=1.1 * 0.005).contains(&share), "{share}");
    click_at(&mut window, rect.min + egui::vec2(71.3, 211.3));
    let Selection::Pixel(pixel) = window.state().session().shown.selection else { panic!() };
    let [rows, columns] = [rect.height(), rect.width()].map(|dots| dots.round() as u32);
    let shown = (423 * 400 / (2 * rows), 143 * 400 / (2 * columns));
    assert_eq!((pixel.row, pixel.column), shown, "what the dots 211 and 71 show");
}

#[test]
fn what_cannot_be_judged_is_told_and_has_a_colour() {
    let (folder, mut window) = showing("center = [0, -1.90000000000001e14, 0]\nradius = 1.9e14\n");
    drop_file(&mut window, &write(folder.path(), "mine.csv", "row,column,t\n0,0,1\n"));
    assert_says(&window, "0 of 1 hits agree, 1 not judged, within 0.00001 of their distance");
    assert!(says(&window, "not judged") && !says(&window, "Select the worst pixel"));
    assert!(map_says(&window).contains("so that a wrong answer would pass"));
}

#[test]
fn the_grade_follows_the_camera() {
    let (folder, mut window) = alone();
    drop_file(&mut window, &write(folder.path(), "basis.csv", BACKWARDS));
    assert_says(&window, "1 of 3 vectors agrees, within 0.00001 in each coordinate");
    assert_says(&window, "Mistake: w-as-printed");
    assert_says(&window, "Answers about a basis have no map.");
    // Looking the other way, it is right.
    type_into(&mut window, "at z", "1");
    assert_says(&window, "3 of 3 vectors agree, within 0.00001 in each coordinate");
    assert_eq!(texts_with(&window, "Mistake:"), Vec::<String>::new());
    // Without a camera, nothing is.
    type_into(&mut window, "at z", "0");
    assert_eq!(texts_with(&window, "vectors agree"), Vec::<String>::new());
    assert_says(&window, "The scene is invalid, so the answers cannot be checked.");
    // While another layout is shown, nothing is graded.
    type_into(&mut window, "at z", "-1");
    show(&mut window, ViewLayout::Camera);
    assert!(window.state().derived().second_view.is_none());
    click(&mut window, "Practice");
    click(&mut window, "Answers");
    assert_says(&window, "Mistake: w-as-printed");
    click(&mut window, "Show me: 𝐰 without the minus");
    assert_eq!(window.state().session().shown.setup.layout, ViewLayout::Mistakes);
    let world = window.state().derived().world_view.as_ref().unwrap();
    let labels: Vec<&str> = world.labels.iter().map(|label| &*label.text).collect();
    assert!(["wrong camera", "u′", "w′"].iter().all(|ghost| labels.contains(ghost)), "{labels:?}");
    click(&mut window, "Answers");
    click(&mut window, "Close the answers");
    assert_eq!(window.state().session().shown.setup.layout, ViewLayout::Both);
    assert!(!says(&window, "Answers"));
}

#[test]
fn answers_that_count_from_one_are_read_again_as_such() {
    let (folder, mut window) = alone();
    drop_file(&mut window, &write(folder.path(), "mine.csv", &far_roots(1)));
    assert_says(&window, "Mistake: counted-from-one, far-root");
    window.get_by_role_and_label(Role::CheckBox, "The file counts from 1").click();
    window.run();
    assert_says(&window, "Mistake: far-root");
    assert!(texts_with(&window, "right is t = ")[0].starts_with("Worst: row 200, column 200 is"));
    click(&mut window, "Select the worst pixel");
    let Selection::Pixel(pixel) = window.state().session().shown.selection else { panic!() };
    assert_eq!((pixel.row, pixel.column), (199, 199));
    fs::write(folder.path().join("mine.csv"), "row,column,t\n1,1,\n").unwrap();
    click(&mut window, "Read again");
    assert_says(&window, "1 of 1 hits agrees, within 0.00001 of their distance");
}

#[test]
fn answers_from_zero_that_are_read_from_one_are_told_so() {
    let (folder, mut window) = alone();
    drop_file(&mut window, &write(folder.path(), "mine.csv", &near_roots()));
    assert_says(&window, "800 of 800 hits agree, within 0.00001 of their distance");
    window.get_by_role_and_label(Role::CheckBox, "The file counts from 1").click();
    window.run();
    let told = texts_with(&window, "They count from 0, and then all agree");
    assert!(!told.is_empty(), "{:?}", texts_with(&window, "count"));
    assert_eq!(texts_with(&window, "say --count-from 1"), Vec::<String>::new());
}

#[test]
fn answers_are_opened_from_the_menu_and_faults_are_told() {
    let (folder, mut window) = alone();
    let bad = write(folder.path(), "bad.csv", "row,column,t\n0,0,x\n");
    window.get_by_label("File").click();
    window.run();
    window.get_by_label_contains("Check answers…").click();
    window.run();
    export_to(&mut window, &bad);
    window.run();
    let message = format!(
        "{}:2:5: column t is \"x\": it must be a finite number; a miss leaves its cells empty, or has inf in them",
        bad.display()
    );
    assert_says(&window, &message);
    assert_eq!(map_says(&window), message);
    // What is none of spheres is meant as answers; a scene is a scene.
    drop_file(&mut window, &write(folder.path(), "typo.csv", "row,colum,t\n0,0,1\n"));
    assert!(!texts_with(&window, "is unknown: did you mean column?").is_empty());
    let scene = write(
        folder.path(),
        "far.toml",
        "pinhole = 1\n[camera]\neye = [0, 0, 9]\nat = [0, 0, 0]\nup = [0, 1, 0]\n",
    );
    drop_file(&mut window, &scene);
    assert_eq!(window.state().document().camera.eye.z, 9.0);
    drop_file(&mut window, &write(folder.path(), "balls.csv", "x,y,z,r\n0,0,0,1\n"));
    assert_says(&window, "This scene cannot be opened");
}

/// Nothing follows the head of this picture; its name is written backwards behind a mark that nobody sees.
#[test]
fn a_picture_is_refused_by_the_size_in_its_head_and_all_of_its_name_is_seen() {
    let (folder, mut window) = alone();
    let mut picture = Vec::new();
    png::encode(&mut picture, [16_384, 1], &[[0; 4]; 16_384], false).unwrap();
    let path = folder.path().join("mine\u{202e}gnp.csv");
    fs::write(&path, &picture[..33]).unwrap();
    drop_file(&mut window, &path);
    let told = "the picture has 16384 x 1 pixels: it must have 400 x 400, as the scene's image has";
    let message = format!("{}/mine\\u{{202e}}gnp.csv: {told}", folder.path().display());
    assert_eq!(map_says(&window), message);
    assert_says(&window, "mine\\u{202e}gnp.csv");
}

/// Before an audience the map's key is needed most: whole, and inside the window.
#[test]
fn the_maps_title_and_key_are_seen_while_presenting() {
    let (folder, mut window) = alone();
    drop_file(&mut window, &write(folder.path(), "mine.csv", &far_roots(0)));
    for size in [[1920.0, 1080.0], [1024.0, 768.0]] {
        window.set_size(size.into());
        for _ in 0..2 {
            window.key_press(egui::Key::F5);
            window.run();
            let whole = window.ctx.content_rect();
            for label in ["right", "wrong"] {
                let rect = window.get_by_role_and_label(Role::Label, label).rect();
                assert!(whole.contains_rect(rect), "{label}: {rect} in {whole}");
            }
        }
    }
}

#[test]
fn answers_by_the_million_are_for_the_command() {
    let (folder, mut window) = alone();
    let path = folder.path().join("many.csv");
    let file = fs::File::create(&path).unwrap();
    std::io::Write::write_all(&mut &file, b"row,column,t\n").unwrap();
    // Holes take no room on a disk.
    file.set_len(200_000_000).unwrap();
    drop_file(&mut window, &path);
    assert_says(&window, "Too many answers");
    assert_eq!(window.state().session().answers, None);
}
