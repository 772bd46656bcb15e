//! The way through the exercises: narrow columns, the sentence at its field, hints, ticks and what comes next.

use egui::accesskit::Role;
use egui::{Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::lessons::{StepId, Which};
use pinhole::ui::app::App;
use pinhole_lecture::exercises::Exercise;

use super::exercises::{answer, answers, click, open};
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

#[test]
fn a_wrong_answer_is_told_once_and_at_its_field() {
    for size in [vec2(1280.0, 800.0), vec2(1024.0, 768.0), vec2(390.0, 844.0)] {
        let mut window = open(Exercise::Turned);
        window.set_size(size);
        window.run();
        let field = |window: &Harness<'_, App>, name: &str| {
            window.get_by_role_and_label(Role::TextInput, &format!("answer {name}")).rect()
        };
        let still = |window: &Harness<'_, App>| {
            let view = window.get_by_role_and_label(Role::Image, "World view").rect();
            [view, button(window, "Check"), button(window, "Copy my answer")]
        };
        let before = still(&window);
        for (part, texts) in
            [("u", ["1", "0", "-1"]), ("w", ["1", "0", "1"]), ("d", ["-0.8", "-0.1", "-1.2"])]
        {
            answers(&mut window, part, &texts);
        }
        answer(&mut window, "t", "5");
        click(&mut window, "Check");
        let told = window.get_all_by_role(Role::Label).filter(|node| {
            node.accesskit_node().value().is_some_and(|text| text.starts_with("Wrong: 𝐮 and"))
        });
        let told: Vec<Rect> = told.map(|node| node.rect()).collect();
        let [told] = told[..] else { panic!("{size}: {told:?}") };
        let between = field(&window, "u x").bottom()..field(&window, "v x").top() + 1.0;
        assert!(between.contains(&told.top()) && between.contains(&told.bottom()), "{size}");
        let of_others = window.get_all_by_role(Role::Label);
        let of_others =
            of_others.filter(|node| node.accesskit_node().value().as_deref() == Some("as 𝐮"));
        assert_eq!(of_others.count(), 3, "{size}");
        assert_ne!(texts_with(&window, "Not answered yet: 𝐯"), [""; 0], "{size}");
        assert_eq!(still(&window), before, "{size}");
        // While it is corrected, nothing moves below the hand.
        let below = field(&window, "t");
        answer(&mut window, "u x", "1/sqrt(2)");
        assert_eq!(texts_with(&window, "Wrong: 𝐮 and"), [""; 0], "{size}");
        assert_eq!(field(&window, "t"), below, "{size}");
    }
}
