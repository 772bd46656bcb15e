//! The strip and its keys: the way through the lessons.

use egui::Key;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::Remembered;
use pinhole::model::lessons::builtin;
use pinhole_core::{Pixel, Selection};

use super::{Window, answer, at_step, key, press, shown_step};
use crate::harness::{assert_says, command, says, texts_with, type_into, window, window_with};

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
        assert_eq!(shown_step(&window), now, "{pressed:?}");
        answer(&mut window);
    }
    window.get_by_role_and_label(Role::Image, "Camera view").focus();
    window.run();
    key(&mut window, Key::ArrowRight);
    assert_eq!(shown_step(&window), (1, 4));
    let pixel = Pixel { row: 99, column: 300 };
    assert_eq!(window.state().session().shown.selection, Selection::Pixel(pixel));
    key(&mut window, Key::PageDown);
    assert_eq!(shown_step(&window), (2, 1), "a remote control works wherever the focus is");
    answer(&mut window);
    window.get_by_role_and_label(Role::SpinButton, "eye x").click();
    window.run();
    key(&mut window, Key::R);
    assert_eq!(shown_step(&window), (2, 1));
    key(&mut window, Key::ArrowRight);
    assert_eq!(shown_step(&window), (2, 1), "a field wants its arrows");
}

#[test]
fn contents_lead_everywhere() {
    let mut window = at_step(1, 1);
    let size = egui::vec2(1280.0, 720.0);
    window.set_size(size);
    window.run();
    window.get_by_label("Contents").click();
    window.run();
    let inside = egui::Rect::from_min_size(egui::Pos2::ZERO, size);
    for lesson in builtin::all() {
        for (index, step) in lesson.steps.iter().enumerate() {
            let entry = window.get_by_label(&format!("{}. {}", index + 1, step.title)).rect();
            assert!(inside.contains_rect(entry), "{}: {entry}", step.title);
        }
    }
    window.get_by_label("2. Its basis").click();
    window.run();
    assert_eq!(shown_step(&window), (8, 2));
    assert!(!says(&window, "2. Its basis"), "the contents are closed again");
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
fn the_hint_names_only_what_is_there_to_be_dragged() {
    let mut window = window_with("canonical", Remembered::default(), None);
    assert_says(&window, "Drag eye, at or up. Click a pixel.");
    command(&mut window, "Overlay: view and up");
    assert_says(&window, "Drag eye. Click a pixel.");
}

#[test]
fn the_whole_derivation_replaces_the_figure_and_the_other_way_round() {
    let mut window = at_step(7, 3);
    let figure =
        |window: &Window| window.query_by_role_and_label(Role::Image, "World view").is_some();
    assert!(figure(&window));
    press(&mut window, "Derivation");
    assert!(!figure(&window));
    assert!(!texts_with(&window, "Decimals").is_empty());
    press(&mut window, "Derivation");
    assert!(figure(&window));
}
