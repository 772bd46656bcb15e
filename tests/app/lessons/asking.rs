//! A step that asks the class: nothing is printed before it has thought.

use egui::Key;
use egui::accesskit::Role;
use egui::epaint::Shape;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::lessons::{LessonArgument, StepId, Which};
use pinhole::model::session::ViewLayout;
use pinhole_figure::derivation::sections::DerivationSection;
use pinhole_figure::overlay_items::Item;

use super::{Window, at_step, go_to, key, press};
use crate::harness::{assert_says, says, show, texts_with, type_into, window};

/// A window on a lesson of two steps, of which the first one asks.
pub(super) fn asking(folder: &std::path::Path) -> Window {
    let path = folder.join("mine.toml");
    let text = "pinhole_lesson = 1\ntitle = \"Mine\"\n[[step]]\ntitle = \"One\"\ntext = \"Look.\"\n\
                scene = \"canonical\"\nlayout = \"both\"\nshow = [\"eye\", \"basis\"]\n\
                ask = \"Where does **w** point?\"\nanswer = \"Backwards: (0, 0, 1).\"\n\
                hide = [\"basis\"]\n[[step]]\ntitle = \"Two\"\ntext = \"Go on.\"\n";
    std::fs::write(&path, text).unwrap();
    let (id, file) = LessonArgument::parse(path.to_str().unwrap()).unwrap().load().unwrap();
    let mut window = window("canonical");
    window.state_mut().open_lesson(id, file);
    window.run();
    window
}

fn shows_basis(window: &Window) -> bool {
    window.state().session().shown.setup.items.shows(Item::Basis)
}

#[test]
fn numbers_and_what_gives_the_answer_away_come_with_the_answer() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = asking(folder.path());
    for presenting in [false, true] {
        if presenting {
            key(&mut window, Key::F5);
        }
        assert_says(&window, "Where does w point?");
        assert!(!says(&window, "Backwards: (0, 0, 1)."));
        assert!(!shows_basis(&window));
        assert_eq!(texts_with(&window, "(0, 0, 1)"), Vec::<String>::new());
        let ray = window.query_by_role_and_label(Role::SpinButton, "uv u");
        assert!(ray.is_none(), "nor in the panel");
        // Pointing is no way round it.
        let view = window.get_by_role_and_label(Role::Image, "Camera view").rect();
        window.hover_at(view.center());
        window.run();
        assert_eq!(texts_with(&window, "𝑡 = "), Vec::<String>::new());
    }
    key(&mut window, Key::PageDown);
    assert_says(&window, "Backwards: (0, 0, 1).");
    assert_says(&window, "Where does w point?");
    assert!(shows_basis(&window) && !window.state().session().shown.is_asking);
    key(&mut window, Key::F5);
    assert!(window.query_by_role_and_label(Role::SpinButton, "uv u").is_some());
}

#[test]
fn no_point_of_the_ray_stands_at_the_answer_before_it_is_asked() {
    for step in [3, 4] {
        let mut window = window("canonical");
        let id = StepId { lesson: Which::Builtin(10), step: step - 1 };
        window.state_mut().open_lesson(id, None);
        window.run();
        let points = |window: &Window| {
            let is_point =
                |shape: &Shape| matches!(shape, Shape::Circle(point) if point.radius == 5.5);
            window.output().shapes.iter().filter(|clipped| is_point(&clipped.shape)).count()
        };
        assert_eq!(points(&window), 0, "11.{step}");
        key(&mut window, Key::PageDown);
        assert!(points(&window) > 0, "11.{step}");
    }
}

#[test]
fn a_layout_opened_by_hand_hides_the_answer() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = asking(folder.path());
    for layout in [
        ViewLayout::Both,
        ViewLayout::Mistakes,
        ViewLayout::Exercises,
        ViewLayout::Derivation,
        ViewLayout::Plot,
    ] {
        show(&mut window, layout);
        assert_says(&window, "Where does w point?");
        assert_eq!(texts_with(&window, "(0, 0, 1)"), Vec::<String>::new(), "{layout:?}");
        assert_eq!(texts_with(&window, "𝑡 = "), Vec::<String>::new(), "{layout:?}");
    }
    show(&mut window, ViewLayout::Derivation);
    key(&mut window, Key::PageDown);
    assert_ne!(texts_with(&window, "(0, 0, 1)"), Vec::<String>::new());
}

#[test]
fn the_answer_is_no_change_of_the_step_and_stays() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = asking(folder.path());
    press(&mut window, "Show the answer");
    let answered = window.state().session().clone();
    type_into(&mut window, "eye x", "0.25");
    key(&mut window, Key::R);
    assert_eq!(window.state().session().settings(), answered.settings());
    assert!(!window.state().session().shown.is_asking, "R asks nothing again");
    key(&mut window, Key::PageDown);
    assert_says(&window, "Go on.");
    key(&mut window, Key::PageUp);
    assert_says(&window, "Backwards: (0, 0, 1).");
    assert!(shows_basis(&window), "who goes back has heard the answer");
    press(&mut window, "Close the lesson");
    assert!(!window.state().session().shown.is_asking);
}

#[test]
fn end_shows_all_that_a_step_keeps_back() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = asking(folder.path());
    key(&mut window, Key::End);
    assert_says(&window, "Backwards: (0, 0, 1).");
    assert_says(&window, "Look.");
    assert!(shows_basis(&window));
}

#[test]
fn what_a_step_before_has_derived_is_not_derived_line_by_line_again() {
    let mut window = at_step(6, 2);
    let sections = |window: &Window| -> Vec<DerivationSection> {
        let derivation = window.state().derived().derivation.clone().unwrap();
        derivation.sections.iter().map(|section| section.section).collect()
    };
    assert_eq!(sections(&window), [DerivationSection::Basis]);
    go_to(&mut window, 6, 3);
    assert_eq!(sections(&window), [DerivationSection::PixelToRay], "the basis is the same one");
}

#[test]
fn what_end_has_shown_stays_shown_in_the_next_step() {
    let mut window = at_step(6, 3);
    key(&mut window, Key::F5);
    key(&mut window, Key::End);
    assert_eq!(window.state().session().shown.revealed_lines, None);
    key(&mut window, Key::PageDown);
    assert_says(&window, "Lesson 6 · 4 of 6 · Where is the distance?");
    assert_eq!(window.state().session().shown.revealed_lines, None, "the same derivation, whole");
}

#[test]
fn a_line_of_text_ends_in_no_short_formula() {
    let mut window = at_step(12, 3);
    key(&mut window, Key::F5);
    for width in [560.0, 600.0, 640.0, 680.0] {
        window.set_size(egui::vec2(width, 512.0));
        window.run();
        let rows = |shape: &Shape| match shape {
            Shape::Text(text) => text.galley.rows.iter().map(|row| row.text()).collect(),
            _ => Vec::new(),
        };
        let rows: Vec<String> =
            window.output().shapes.iter().flat_map(|clipped| rows(&clipped.shape)).collect();
        let whole = "(0,\u{a0}0,\u{a0}0)\u{a0}+\u{a0}𝑡\u{a0}(0,\u{a0}0,\u{a0}−1)";
        assert!(rows.iter().any(|row| row.contains(whole)), "{width}: {rows:?}");
    }
}

/// The labels of the world view.
fn labels(window: &Window) -> Vec<String> {
    let shown = window.state().derived().world_view.clone().unwrap();
    shown.labels.iter().map(|label| label.text.clone()).collect()
}

#[test]
fn which_camera_is_wrong_is_not_told_before_the_answer() {
    let mut window = window("canonical");
    let id = StepId { lesson: Which::Builtin(9), step: 0 };
    window.state_mut().open_lesson(id, None);
    window.run();
    assert_says(&window, "Camera 1");
    assert_says(&window, "Camera 2");
    let is_picture =
        |window: &Window, name: &str| window.query_by_role_and_label(Role::Image, name).is_some();
    assert!(is_picture(&window, "Camera 2") && !is_picture(&window, "Wrong camera"));
    let of_wrong = ["u′", "w′", "ray′", "wrong camera"].map(str::to_owned);
    assert!(!labels(&window).iter().any(|label| of_wrong.contains(label)));
    key(&mut window, Key::PageDown);
    assert_says(&window, "Camera 1: right");
    assert_says(&window, "Camera 2: wrong");
    let labels = labels(&window);
    assert!(of_wrong.iter().all(|label| labels.contains(label)), "{labels:?}");
}

#[test]
fn no_vector_of_the_basis_is_drawn_before_the_step_that_finds_it() {
    for (step, known) in [(2, vec!["w"]), (3, vec!["u", "w"]), (4, vec!["u", "v", "w"])] {
        let labels = labels(&at_step(7, step));
        let mut drawn: Vec<&str> = labels.iter().map(String::as_str).collect();
        drawn.retain(|label| ["u", "v", "w"].contains(label));
        drawn.sort();
        assert_eq!(drawn, known, "7.{step}: {labels:?}");
    }
}
