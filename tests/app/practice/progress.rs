//! The way through the exercises: narrow columns, the sentence at its field, hints, ticks and what comes next.

use egui::accesskit::Role;
use egui::{Key, Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::lessons::{StepId, Which};
use pinhole::model::session::{Settings, Setup, ViewLayout};
use pinhole::model::store::{Remembered, Store};
use pinhole::ui::app::App;
use pinhole_lecture::exercises::Exercise;

use super::exercises::{answer, answers, choose, click, open};
use crate::harness::{assert_says, command, show, texts_with, window, window_with};

fn button(window: &Harness<'_, App>, name: &str) -> Rect {
    window.get_by_role_and_label(Role::Button, name).rect()
}

#[test]
fn a_step_s_exercise_has_whole_buttons_and_the_step_s_text() {
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
        // The step's text stands over its own exercise, with whatever numbers.
        assert_ne!(texts_with(&window, "The basis first"), [""; 0]);
        command(&mut window, Exercise::Sphere.title());
        assert_eq!(texts_with(&window, "The basis first"), [""; 0]);
    }
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
        let told = |text: &str| -> Vec<Rect> {
            let labels = window.get_all_by_role(Role::Label);
            let says = |value: String| value.starts_with(text);
            let told = labels.filter(|node| node.accesskit_node().value().is_some_and(says));
            told.map(|node| node.rect()).collect()
        };
        let [cause] = told("Wrong: 𝐮 and")[..] else { panic!("{size}") };
        let between = field(&window, "u x").bottom()..field(&window, "v x").top() + 1.0;
        assert!(between.contains(&cause.top()) && between.contains(&cause.bottom()), "{size}");
        assert_eq!(told("as 𝐮").len(), 3, "{size}");
        assert_ne!(texts_with(&window, "Not answered yet: 𝐯"), [""; 0], "{size}");
        assert_eq!(still(&window), before, "{size}");
        // While it is corrected, nothing moves below the hand.
        let below = field(&window, "t");
        answer(&mut window, "u x", "1/sqrt(2)");
        assert_eq!(texts_with(&window, "Wrong: 𝐮 and"), [""; 0], "{size}");
        assert_eq!(field(&window, "t"), below, "{size}");
    }
}

/// Returns true if the exercise has a tick in the menu.
fn has_tick(window: &mut Harness<'_, App>, exercise: Exercise) -> bool {
    window.get_by_label("exercise").click();
    window.run();
    let entry = window.get_all_by_role_and_label(Role::Button, exercise.title()).last().unwrap();
    let is_done = entry.accesskit_node().description().as_deref() == Some("done");
    window.key_press(Key::Escape);
    window.run();
    is_done
}

fn exercise(window: &Harness<'_, App>) -> Exercise {
    window.state().session().exercises.question().exercise
}

#[test]
fn what_is_done_has_a_tick_and_next_leads_to_what_is_not() {
    let mut window = open(Exercise::WarmUpPlane);
    assert_says(&window, "0 of 11 done");
    answer(&mut window, "t", "-6");
    window.key_press(Key::Enter);
    window.run();
    assert!(window.get_by_role_and_label(Role::TextInput, "answer t").is_focused());
    assert!(!has_tick(&mut window, Exercise::WarmUpPlane));
    answers(&mut window, "point", &["1.2", "-0.6", "-6"]);
    answer(&mut window, "t", "6");
    window.key_press(Key::Enter);
    window.run();
    assert_says(&window, "1 of 11 done");
    // Enter goes on, into the first field.
    window.key_press(Key::Enter);
    window.run();
    assert_eq!(exercise(&window), Exercise::Distance);
    assert!(window.get_by_role_and_label(Role::TextInput, "answer d x").is_focused());
    assert!(has_tick(&mut window, Exercise::WarmUpPlane));
    // Behind the last exercise comes the first that is not done, and a seen solution makes none done.
    choose(&mut window, Exercise::Lines);
    click(&mut window, "Show the solution");
    answer(&mut window, "t", "1");
    answers(&mut window, "point", &["1", "1"]);
    window.get_by_role_and_label(Role::RadioButton, "yes").click();
    window.run();
    click(&mut window, "Hide the solution");
    click(&mut window, "Check");
    assert_says(&window, "All correct, after the solution.");
    assert_says(&window, "1 of 11 done");
    click(&mut window, "Next exercise");
    assert_eq!(exercise(&window), Exercise::PixelUv);
}

#[test]
fn what_is_done_is_kept_until_it_is_started_over() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("state.json");
    let store = || Store::at(&path);
    let start = || {
        let mut window = window_with("canonical", store().load(), Some(store()));
        show(&mut window, ViewLayout::Exercises);
        choose(&mut window, Exercise::PointAt);
        window
    };
    let mut window = start();
    answers(&mut window, "point", &["21.2", "3.4", "4"]);
    click(&mut window, "Check");
    // Another scene, undone, and an end without a farewell.
    crate::harness::open_scene(&mut window, "look-at");
    window.key_press_modifiers(egui::Modifiers::COMMAND, Key::Z);
    window.run();
    drop(window);
    let mut window = start();
    assert_says(&window, "1 of 11 done");
    let start_over = |window: &mut Harness<'_, App>, answer: &str| {
        window.get_by_label("exercise").click();
        window.run();
        click(window, "Start over…");
        click(window, answer);
    };
    start_over(&mut window, "Cancel");
    assert_says(&window, "1 of 11 done");
    start_over(&mut window, "Start over");
    assert_says(&window, "0 of 11 done");
    drop(window);
    assert_says(&start(), "0 of 11 done");
    // What cannot be read is ignored, and nothing else is lost.
    let settings =
        Settings { setup: Setup { digits: 7, ..Setup::default() }, ..Settings::default() };
    let state = Remembered { settings, ..Remembered::default() };
    for (foreign, count) in [
        (serde_json::json!(["sphere", 7, "of-tomorrow", null, "sphere"]), 1),
        (serde_json::json!({"sphere": true}), 0),
        (serde_json::json!("\u{0}"), 0),
    ] {
        let mut state = serde_json::to_value(&state).unwrap();
        state["progress"] = foreign;
        std::fs::write(&path, state.to_string()).unwrap();
        assert_eq!(store().load().settings, settings);
        assert_says(&start(), &format!("{count} of 11 done"));
    }
}

#[test]
fn a_hint_is_the_next_line_that_leads_to_what_is_not_right_yet() {
    for size in [vec2(1280.0, 800.0), vec2(1024.0, 768.0), vec2(390.0, 844.0)] {
        let mut window = open(Exercise::ViewUp);
        window.set_size(size);
        window.run();
        let check = button(&window, "Check");
        click(&mut window, "Hint");
        let line = |window: &Harness<'_, App>, of: &str| texts_with(window, of).pop();
        assert!(line(&window, "𝐰 = normalize").is_some_and(|line| !line.contains("(0, 1, 0)")));
        answers(&mut window, "w", &["0", "1", "0"]);
        click(&mut window, "Check");
        // It begins with what is asked next.
        click(&mut window, "Hint");
        assert_eq!(line(&window, "up × 𝐰").as_deref(), Some("up × 𝐰 = (2, 2, 0) × (0, 1, 0)"));
        assert_eq!(line(&window, "𝐰 = normalize"), None);
        for _ in 0..2 {
            click(&mut window, "Hint");
            assert!(!window.state().session().exercises.to_code().contains("/seen/"));
        }
        let fields = window.get_all_by_role(Role::TextInput).map(|field| field.rect());
        let others: Vec<Rect> = fields.chain([check, button(&window, "Hint")]).collect();
        let shown = window.get_all_by_role(Role::Label).filter(|node| {
            node.accesskit_node().value().is_some_and(|text| text.starts_with("𝐯 = 𝐰 × 𝐮"))
        });
        let shown: Vec<Rect> = shown.map(|node| node.rect()).collect();
        assert!(!shown.is_empty(), "{size}");
        let covers = |rect: &Rect| others.iter().any(|other| other.shrink(1.0).intersects(*rect));
        assert!(!shown.iter().any(covers), "{size}: {shown:?}, {others:?}");
        assert_eq!(button(&window, "Check"), check, "{size}");
        click(&mut window, "Hint");
        assert!(window.state().session().exercises.to_code().contains("/seen/"));
        window.get_by_role_and_label(Role::Button, "Hide the solution");
        choose(&mut window, Exercise::Lines);
        click(&mut window, "Hint");
        assert!(line(&window, "substituted").is_some() && line(&window, "added up").is_none());
        answer(&mut window, "t", "1");
        click(&mut window, "Check");
        click(&mut window, "Hint");
        assert!(line(&window, "parametric").is_some() && line(&window, "They meet").is_none());
    }
}

#[test]
fn hints_leave_the_results_to_the_student_and_end_in_the_solution() {
    for &exercise in Exercise::LISTED {
        let mut window = open(exercise);
        let hides =
            |window: &Harness<'_, App>| window.query_by_label("Hide the solution").is_some();
        let mut hints = 0;
        while !hides(&window) {
            assert!(!window.state().session().exercises.to_code().contains("/seen/"));
            assert_eq!(texts_with(&window, "zero where"), [""; 0], "it says t");
            click(&mut window, "Hint");
            hints += 1;
            assert!(hints < 12, "{exercise:?}");
        }
        assert!(hints > 1, "{exercise:?}");
        assert!(window.state().session().exercises.to_code().contains("/seen/"));
    }
}
