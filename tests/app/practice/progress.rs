//! The way through the exercises: narrow columns, the sentence at its field, hints, ticks and what comes next.

use egui::accesskit::Role;
use egui::{Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::lessons::{StepId, Which};
use pinhole::ui::app::App;
use pinhole_lecture::exercises::Exercise;

use super::exercises::click;
use crate::harness::{command, texts_with, window};

fn button(window: &Harness<'_, App>, name: &str) -> Rect {
    window.get_by_role_and_label(Role::Button, name).rect()
}

#[test]
fn the_buttons_of_a_step_s_exercise_are_whole_in_a_narrow_column() {
    let mut window = window("canonical");
    for size in [vec2(737.0, 553.0), vec2(1024.0, 768.0), vec2(390.0, 844.0)] {
        window.set_size(size);
        window.state_mut().open_lesson(StepId { lesson: Which::Builtin(5), step: 5 }, None);
        window.run();
        click(&mut window, "New numbers");
        let ends = ["Copy my answer", "Show the solution", "Check", "Contents"];
        let seed = window.get_by_label("exercise seed").rect();
        for rect in ends.map(|name| button(&window, name)).into_iter().chain([seed]) {
            let column = if size.x > size.y { 0.58 * size.x } else { 0.0 };
            assert!(rect.right() <= size.x - 10.0 && rect.left() > column, "{size}: {rect}");
        }
    }
}

#[test]
fn another_exercise_in_a_lesson_has_no_text_of_the_step() {
    let mut window = window("canonical");
    window.state_mut().open_lesson(StepId { lesson: Which::Builtin(5), step: 5 }, None);
    window.run();
    assert_ne!(texts_with(&window, "Another quarter turn"), [""; 0]);
    click(&mut window, "New numbers");
    assert_ne!(texts_with(&window, "Another quarter turn"), [""; 0]);
    command(&mut window, Exercise::Sphere.title());
    assert_eq!(texts_with(&window, "Another quarter turn"), [""; 0]);
    window.get_by_role_and_label(Role::ComboBox, "exercise");
}
