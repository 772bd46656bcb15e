//! The lessons: walked step by step, their numbers, and dragging freely in between.

use std::path::Path;

use egui::Key;
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::app::App;
use pinhole::formats::scene_file;
use pinhole::lessons::{LessonArgument, Place, Which, builtin};
use pinhole::session::{Selection, Settings, ViewLayout};
use pinhole::store::{Remembered, Store};
use pinhole_core::{DVec3, Pixel};

use super::harness::{assert_says, drag_from, says, texts_with, type_into, window, window_with};
use super::scene_files::drop_file;

type Window = Harness<'static, App>;

fn press(window: &mut Window, button: &str) {
    window.get_by_role_and_label(Role::Button, button).click();
    window.run();
}

/// A window on a lesson's step, both counted from 1.
fn at_step(lesson: usize, step: usize) -> Window {
    let mut window = window("canonical");
    window
        .state_mut()
        .open_lesson(Place { lesson: Which::Builtin(lesson - 1), step: step - 1 }, None);
    window.run();
    window
}

fn key(window: &mut Window, key: Key) {
    window.key_press(key);
    window.run();
}

/// The open lesson and step, counted from 1.
fn place(window: &Window) -> (usize, usize) {
    match window.state().lesson().unwrap().place() {
        Place { lesson: Which::Builtin(index), step } => (index + 1, step + 1),
        place => panic!("{place:?}"),
    }
}

/// 1 / sqrt 2.
const S: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// What must be so at a step.
enum Says {
    /// Every t of the selected ray, ascending.
    Ts(&'static [f64]),
    /// The ray's origin and direction.
    Ray([f64; 3], [f64; 3]),
    /// The first hit.
    Hit(f64, [f64; 3]),
    /// The ray hits nothing but this object.
    Only(u32),
    /// (u, v).
    Uv(f64, f64),
    /// u, v and w.
    Basis([[f64; 3]; 3]),
    /// The reason for there being no camera.
    Fault(&'static str),
    /// Degrees of roll for one of up.
    Conditioning(f64),
}

use Says::{Basis, Conditioning, Fault, Hit, Only, Ray, Ts, Uv};

const O: [f64; 3] = [0.0, 0.0, 0.0];
const CANONICAL: Says = Basis([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
const TURNED: Says = Basis([[S, 0.0, -S], [0.0, 1.0, 0.0], [S, 0.0, S]]);
const DOWN: Says = Basis([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
const R2: f64 = std::f64::consts::SQRT_2;

/// Lesson, step, and a number of DESIGN's, or one that follows from them in the head.
fn numbers() -> Vec<(usize, usize, Says)> {
    let (r74, r682) = (74f64.sqrt(), 682f64.sqrt());
    let u = DVec3::new(5.0, 0.0, -7.0) / r74;
    let w = DVec3::new(21.0, 4.0, 15.0) / r682;
    let look_at = Basis([u.to_array(), w.cross(u).to_array(), w.to_array()]);
    vec![
        (1, 1, CANONICAL),
        (1, 3, Uv(-1.0 / 800.0, 201.0 / 800.0)),
        (1, 4, Ray(O, [-1.0 / 800.0, 201.0 / 800.0, -1.0])),
        (2, 1, Ray(O, [0.2, -0.1, -1.0])),
        (2, 2, Uv(0.2, -0.1)),
        (2, 3, Uv(0.2, -0.1)),
        (2, 4, Hit(6.0, [1.2, -0.6, -6.0])),
        (2, 4, Only(2)),
        (3, 1, Uv(-1.0 / 400.0, 201.0 / 400.0)),
        (3, 2, Ray(O, [0.2, -0.1, -2.0])),
        (3, 2, Hit(3.0, [0.6, -0.3, -6.0])),
        (3, 3, Hit(3.0, [1.2, -0.6, -6.0])),
        (4, 1, Ray([0.5, 0.4, 1.0], [0.2, -0.1, -1.0])),
        (5, 1, CANONICAL),
        (5, 1, Ray(O, [0.2, -0.1, -1.0])),
        (5, 2, TURNED),
        (5, 2, Ray(O, [-0.8 * S, -0.1, -1.2 * S])),
        (5, 3, DOWN),
        (5, 3, Ray(O, [-0.1, -1.0, 0.2])),
        (6, 1, TURNED),
        (6, 2, Ray(O, [-0.8 * S, -0.1, -1.2 * S])),
        (6, 2, Hit(5.0 * R2, [-4.0, -R2 / 2.0, -6.0])),
        (7, 2, DOWN),
        (7, 3, DOWN),
        (7, 4, DOWN),
        (8, 2, look_at),
        (9, 2, Conditioning(160.003)),
        (
            9,
            3,
            Fault("up (0, 1, 0) is parallel to the view direction (0, -8, 0): turn one of them"),
        ),
        (9, 4, Fault("eye and at are the same point (0, 0, 0): move one of them")),
        (9, 5, Fault("up is (0, 0, 0): it must point somewhere")),
        (12, 1, Ts(&[6.0])),
        (12, 2, Ts(&[4.0, 6.0, 6.0])),
        (12, 3, Only(1)),
        (12, 4, Ts(&[5.0, 5.0, 8.0])),
        (12, 5, Ts(&[-3.0, -2.5, -1.5, 5.0])),
        (13, 1, Ts(&[4.0, 6.0, 8.0, 12.0, 14.0])),
        (13, 1, Hit(4.0, [0.0, 0.0, -4.0])),
        (13, 2, Ts(&[-6.0, -4.0, 4.0, 6.0, 8.0, 12.0, 14.0])),
        (13, 2, Hit(4.0, [0.0, 0.0, -4.0])),
    ]
}

#[track_caller]
fn near(found: f64, wanted: f64, what: &str) {
    assert!(
        (found - wanted).abs() < 1e-12 * wanted.abs().max(1.0),
        "{what}: {found}, not {wanted}"
    );
}

#[track_caller]
fn all_near(found: DVec3, wanted: [f64; 3], what: &str) {
    found.to_array().into_iter().zip(wanted).for_each(|(found, wanted)| near(found, wanted, what));
}

fn check(app: &App, says: &Says, what: &str) {
    let derived = app.derived();
    if let Fault(reason) = says {
        assert_eq!(derived.fault.unwrap().to_string(), *reason, "{what}");
        return;
    }
    assert!(derived.fault.is_none(), "{what}: {:?}", derived.fault);
    let inspection = derived.inspection.clone().unwrap();
    match says {
        Ts(ts) => {
            let found: Vec<f64> = inspection.roots.iter().map(|root| root.t).collect();
            assert_eq!(found.len(), ts.len(), "{what}: {found:?}");
            found.iter().zip(*ts).for_each(|(found, wanted)| near(*found, *wanted, what));
        }
        Ray(origin, direction) => {
            all_near(inspection.ray.origin, *origin, what);
            all_near(inspection.ray.direction, *direction, what);
        }
        Hit(t, point) => {
            let hit = inspection.first_hit().unwrap();
            near(hit.t, *t, what);
            all_near(hit.point, *point, what);
        }
        Only(object) => {
            assert!(inspection.roots.iter().all(|root| root.object == *object), "{what}");
        }
        Uv(u, v) => {
            near(inspection.uv.x, *u, what);
            near(inspection.uv.y, *v, what);
        }
        Basis([u, v, w]) => {
            let basis = *derived.posed.unwrap().basis();
            all_near(basis.u, *u, what);
            all_near(basis.v, *v, what);
            all_near(basis.w, *w, what);
        }
        Conditioning(degrees) => {
            let found = derived.up_angle.unwrap().conditioning;
            assert!((found - degrees).abs() < 1e-3, "{what}: {found}");
        }
        Fault(_) => {}
    }
}

#[test]
fn every_step_is_reached_by_next_and_its_numbers_are_right() {
    let numbers = numbers();
    let mut window = at_step(1, 1);
    let mut seen = 0;
    for (index, lesson) in builtin::all().iter().enumerate() {
        for (k, step) in lesson.steps.iter().enumerate() {
            let now = (index + 1, k + 1);
            assert_eq!(place(&window), now);
            assert_says(&window, &format!("Lesson {}: {}", now.0, lesson.title));
            assert_says(&window, &step.title);
            assert_says(&window, &step.text.replace('*', ""));
            assert_says(&window, &format!("{} of {}", now.1, lesson.steps.len()));
            let app = window.state();
            assert_eq!(*app.document(), step.document, "{now:?}");
            assert_eq!(app.session().selection, step.selection, "{now:?}");
            assert_eq!(app.session().settings.layout, step.looks.layout.unwrap(), "{now:?}");
            assert_eq!(app.session().settings.items, step.looks.items.unwrap(), "{now:?}");
            for (.., says) in numbers.iter().filter(|n| (n.0, n.1) == now) {
                check(app, says, &format!("lesson {} step {}", now.0, now.1));
                seen += 1;
            }
            for wrong in ["NaN", "nan"] {
                assert!(texts_with(&window, wrong).is_empty(), "{now:?}");
            }
            let next = window.get_by_role_and_label(Role::Button, "Next");
            let last = index + 1 == builtin::all().len() && k + 1 == lesson.steps.len();
            assert_eq!(next.accesskit_node().is_disabled(), last, "{now:?}");
            if !last {
                press(&mut window, "Next");
            }
        }
    }
    assert_eq!(seen, numbers.len(), "a number is of no step");
    press(&mut window, "Previous");
    assert_eq!(place(&window), (13, 2));
}

#[test]
fn numbers_are_read_off_where_the_readouts_are() {
    for (lesson, step, texts) in [
        (1, 3, &["pixel = row 100, column 200", "(u, v) = (−0.00125, 0.25125)"][..]),
        (2, 1, &["p = (0, 0, 0)", "d = (0.2, −0.1, −1)", "pixel = the corner of four pixels"]),
        (2, 4, &["t = 6", "point = (1.2, −0.6, −6)"]),
        (3, 2, &["d = (0.2, −0.1, −2)", "t = 3", "point = (0.6, −0.3, −6)"]),
        (3, 3, &["t = 3", "point = (1.2, −0.6, −6)"]),
        (4, 1, &["p = (0.5, 0.4, 1)", "d = (0.2, −0.1, −1)"]),
        (6, 2, &["t = 7.0711", "point = (−4, −0.70711, −6)"]),
    ] {
        let mut window = at_step(lesson, step);
        if window.state().session().settings.layout == ViewLayout::Ledger {
            press(&mut window, "Both views");
        }
        for text in texts {
            assert_says(&window, text);
        }
    }
}

#[test]
fn a_step_is_the_same_however_it_is_reached() {
    for (lesson, step) in [(3, 3), (7, 4), (12, 5)] {
        let direct = at_step(lesson, step);
        let mut walked = at_step(lesson, 1);
        for _ in 1..step {
            press(&mut walked, "Next");
        }
        assert_eq!(direct.state().document(), walked.state().document());
        assert_eq!(direct.state().session().selection, walked.state().session().selection);
        assert_eq!(direct.state().session().settings, walked.state().session().settings);
    }
}

#[test]
fn one_key_brings_the_step_back_after_dragging() {
    let mut window = at_step(3, 2);
    let disabled = |window: &Window| {
        let back = window.get_by_role_and_label(Role::Button, "Back to the step");
        back.accesskit_node().is_disabled()
    };
    assert!(disabled(&window), "nothing was changed");
    let before = (window.state().document().clone(), window.state().session().clone());
    type_into(&mut window, "eye x", "0.25");
    assert!(!disabled(&window));
    key(&mut window, Key::R);
    assert_eq!(*window.state().document(), before.0);
    assert!(disabled(&window));
    type_into(&mut window, "uv u", "0.3");
    window.get_by_role_and_label(Role::Button, "World").click();
    window.run();
    let rect = window.get_by_role_and_label(Role::Image, "World view").rect();
    let from = rect.min + egui::vec2(60.0, 60.0);
    window.drag_at(from);
    window.run();
    window.hover_at(from + egui::vec2(50.0, 20.0));
    window.run();
    window.drop_at(from + egui::vec2(50.0, 20.0));
    window.run();
    assert_ne!(*window.state().session(), before.1);
    press(&mut window, "Back to the step");
    assert_eq!(*window.state().session(), before.1);
    assert_eq!(place(&window), (3, 2));
    type_into(&mut window, "eye x", "9");
    press(&mut window, "Next");
    assert_eq!(place(&window), (3, 3));
    assert!(!says(&window, "Save the changes to Lesson 3, step 2?"), "a step is no file");
}

#[test]
fn keys_go_through_the_lessons_unless_a_view_wants_them() {
    let mut window = at_step(2, 1);
    for (pressed, now) in [
        (Key::ArrowRight, (2, 2)),
        (Key::PageDown, (2, 3)),
        (Key::ArrowLeft, (2, 2)),
        (Key::PageUp, (2, 1)),
        (Key::PageUp, (1, 4)),
    ] {
        key(&mut window, pressed);
        assert_eq!(place(&window), now, "{pressed:?}");
    }
    window.get_by_role_and_label(Role::Image, "Camera view").focus();
    window.run();
    key(&mut window, Key::ArrowRight);
    assert_eq!(place(&window), (1, 4));
    let pixel = Pixel { row: 99, column: 200 };
    assert_eq!(window.state().session().selection, Selection::Pixel(pixel));
    key(&mut window, Key::PageDown);
    assert_eq!(place(&window), (2, 1), "a remote control works wherever the focus is");
    window.get_by_role_and_label(Role::SpinButton, "eye x").click();
    window.run();
    key(&mut window, Key::R);
    assert_eq!(place(&window), (2, 1));
    key(&mut window, Key::ArrowRight);
    assert_eq!(place(&window), (2, 1), "a field wants its arrows");
}

#[test]
fn contents_lead_everywhere() {
    let mut window = at_step(1, 1);
    window.get_by_label("Contents").click();
    window.run();
    for lesson in builtin::all() {
        for (index, step) in lesson.steps.iter().enumerate() {
            window.get_by_label(&format!("{}. {}", index + 1, step.title));
        }
    }
    window.get_by_label("2. Its basis").click();
    window.run();
    assert_eq!(place(&window), (8, 2));
    assert!(!says(&window, "2. Its basis"), "the contents are closed again");
}

#[test]
fn lessons_open_from_the_bar_and_close_without_a_trace() {
    let settings = Settings { layout: ViewLayout::Camera, digits: 9, ..Settings::default() };
    let remembered = Remembered { settings, ..Remembered::default() };
    let mut window = window_with("planet", remembered, None);
    let before = window.state().session().settings.clone();
    window.get_by_label("Lessons").click();
    window.run();
    window.get_by_label("Lesson 9: When it breaks").click();
    window.run();
    assert_eq!(place(&window), (9, 1));
    assert_ne!(window.state().session().settings, before);
    press(&mut window, "Close the lesson");
    assert!(window.state().lesson().is_none());
    assert_eq!(window.state().session().settings, before);
    assert_says(&window, "Lesson 9, step 1");
    type_into(&mut window, "eye x", "1");
    assert_says(&window, "Lesson 9, step 1 (changed)");
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
    assert_eq!(place(&window), (2, 1));
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
    press(&mut window, "Next");
    assert_says(&window, "Save the changes to mine.toml?");
    press(&mut window, "Save");
    assert_eq!(scene_file::load(&path).unwrap().camera.eye.x, 4.0);
    assert_eq!(place(&window), (2, 2));
}

#[test]
fn the_next_run_goes_on_at_the_step_and_has_the_settings_from_before() {
    let folder = tempfile::tempdir().unwrap();
    let store = Store::at(&folder.path().join("state.json"));
    let mut window = window_with("planet", Remembered::default(), Some(store.clone()));
    window.state_mut().open_lesson(Place { lesson: Which::Builtin(8), step: 1 }, None);
    window.run();
    type_into(&mut window, "eye x", "7");
    window.state_mut().on_exit();
    let remembered = store.load();
    assert_eq!(remembered.lesson_place(), Some(Place { lesson: Which::Builtin(8), step: 1 }));
    assert_eq!(remembered.last.as_deref(), Some(Path::new("planet")));
    assert_eq!(remembered.settings, Settings::default());
    assert!(!store.unsaved().exists(), "a step's changes are nobody's loss");
}

#[test]
fn a_teachers_own_lesson_opens_and_is_in_the_contents() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    let step = "[[step]]\ntitle = \"One\"\ntext = \"Look.\"\nscene = \"roll\"\n";
    std::fs::write(&path, format!("pinhole_lesson = 1\ntitle = \"My lesson\"\n{step}")).unwrap();
    let (place, file) = LessonArgument::of(path.to_str().unwrap()).unwrap().load().unwrap();
    let mut window = window("canonical");
    window.state_mut().open_lesson(place, file);
    window.run();
    assert_says(&window, "My lesson");
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
    assert_eq!((lesson.title().as_str(), lesson.place().lesson), ("Mine", Which::File));
    assert!(
        window
            .state()
            .document()
            .camera
            .posed()
            .unwrap()
            .basis()
            .u
            .abs_diff_eq(DVec3::new(S, 0.0, -S), 1e-15)
    );
}

#[test]
fn r_asks_nothing_where_no_lesson_is_open() {
    let mut window = window("canonical");
    type_into(&mut window, "eye x", "7");
    key(&mut window, Key::R);
    assert!(!says(&window, "Save the changes to canonical?"));
    assert_eq!(window.state().document().camera.eye.x, 7.0);
}

#[test]
fn another_scene_ends_the_lesson() {
    let mut window = at_step(2, 1);
    window.get_by_label("Scenes").click();
    window.run();
    window.get_by_label("planet").click();
    window.run();
    assert!(window.state().lesson().is_none());
    let radii: Vec<f64> =
        window.state().document().spheres.iter().map(|item| item.shape.radius).collect();
    assert!(radii.contains(&5000.0), "{radii:?}");
}

#[test]
fn r_puts_back_what_was_dragged_in_the_lines_lab() {
    let mut window = at_step(11, 1);
    let before = window.state().session().lines.clone();
    let handle = window.get_by_label("move p").rect().center();
    drag_from(&mut window, handle, egui::vec2(60.0, 30.0));
    assert_ne!(window.state().session().lines, before);
    key(&mut window, Key::R);
    assert_eq!(window.state().session().lines, before);
}
