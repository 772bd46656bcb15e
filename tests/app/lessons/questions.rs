//! The steps that ask an exercise: their right answers, found by hand, and what R does with what was
//! typed.

use std::collections::BTreeSet;

use egui::Key;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::lessons::builtin;
use pinhole::model::session::ViewLayout;
use pinhole_figure::overlay_items::Item;

use super::{Window, at_step, go_to, key, press, shown_step};
use crate::app::practice::exercises::answers;
use crate::harness::{assert_says, says, texts_with};

/// The parts of a question, and what is typed for each.
type Answers = &'static [(&'static str, &'static [&'static str])];

/// Lesson, step, and the answers.
const QUESTIONS: &[(usize, usize, Answers)] = &[
    // (u, v) = (0.3, -0.2).
    (2, 5, &[("p", &["0", "0", "0"]), ("d", &["0.3", "-0.2", "-1"])]),
    // (u, v) = (0.4, -0.2), z = -4: -t = -4, and 4 (0.4, -0.2, -1).
    (2, 6, &[("t", &["4"]), ("point", &["1.6", "-0.8", "-4"])]),
    // Distance 2.5, (u, v) = (0.3, 0.1), z = -7.5: -2.5 t = -7.5.
    (3, 6, &[("d", &["0.3", "0.1", "-2.5"]), ("t", &["3"])]),
    // s = 1/√2, u = (-s, 0, -s), v = y, so w = u x v = (s, 0, -s); 0.2 u + 0.1 v - w; z = 0.8 s t = 4.
    (
        6,
        6,
        &[
            ("u", &["-1/sqrt(2)", "0", "-1/sqrt(2)"]),
            ("v", &["0", "1", "0"]),
            ("w", &["1/sqrt(2)", "0", "-1/sqrt(2)"]),
            ("d", &["-1.2/sqrt(2)", "0.1", "0.8/sqrt(2)"]),
            ("t", &["5*sqrt(2)"]),
        ],
    ),
    // View = (3, 0, 0), up = (-1, 3, 4): up x w = (0, -4, 3).
    (7, 6, &[("w", &["-1", "0", "0"]), ("u", &["0", "-0.8", "0.6"]), ("v", &["0", "0.6", "0.8"])]),
    // eye - at = (-1, 1, 2), y x (-1, 1, 2) = (2, 0, 1), (-1, 1, 2) x (2, 0, 1) = (1, 5, -2).
    (
        8,
        4,
        &[
            ("w", &["-1/sqrt(6)", "1/sqrt(6)", "2/sqrt(6)"]),
            ("u", &["2/sqrt(5)", "0", "1/sqrt(5)"]),
            ("v", &["1/sqrt(30)", "5/sqrt(30)", "-2/sqrt(30)"]),
        ],
    ),
    // x - 3y + 11 at (1 - 3t, 3 - 2t): 3 + 3t. Behind p.
    (11, 6, &[("t", &["-1"]), ("point", &["4", "5"])]),
    // From (0, -2, 1) along -z, 4 beside the centre at z = -10: half the chord is √(25 - 16) = 3, so in
    // at z = -7; the normal is (-4, 0, 3)/5.
    (12, 9, &[("t", &["4"]), ("point", &["0", "-2", "-7"]), ("normal", &["-0.8", "0", "0.6"])]),
];

const ALL_RIGHT: &str = "All correct.";

fn type_answers(window: &mut Window, (lesson, step): (usize, usize), parts: Answers) {
    for (part, texts) in parts {
        answers(window, part, texts);
    }
    if (lesson, step) == (11, 6) {
        window.get_by_role_and_label(Role::RadioButton, "no").click();
        window.run();
    }
    press(window, "Check");
}

#[test]
fn every_question_is_answered_by_hand_and_accepted() {
    let mut window = at_step(1, 1);
    for &(lesson, step, parts) in QUESTIONS {
        go_to(&mut window, lesson, step);
        assert!(!says(&window, ALL_RIGHT), "{lesson}.{step}");
        type_answers(&mut window, (lesson, step), parts);
        assert_says(&window, ALL_RIGHT);
    }
}

#[test]
fn every_step_with_a_question_is_among_them() {
    let asking: BTreeSet<(usize, usize)> = builtin::all()
        .iter()
        .enumerate()
        .flat_map(|(lesson, l)| l.steps.iter().enumerate().map(move |(k, s)| (lesson, k, s)))
        .filter(|(.., step)| step.layout() == Some(ViewLayout::Exercises))
        .map(|(lesson, k, _)| (lesson + 1, k + 1))
        .collect();
    assert_eq!(QUESTIONS.iter().map(|row| (row.0, row.1)).collect::<BTreeSet<_>>(), asking);
}

#[test]
fn what_was_typed_stays_from_step_to_step_until_r_takes_it_away() {
    let (_, _, parts) = QUESTIONS[0];
    let mut window = at_step(2, 5);
    let blank = window.state().session().exercises.clone();
    type_answers(&mut window, (2, 5), parts);
    assert_says(&window, ALL_RIGHT);
    let answered = window.state().session().exercises.clone();
    press(&mut window, "Previous");
    press(&mut window, "Next");
    assert_eq!(shown_step(&window), (2, 5));
    assert_eq!(window.state().session().exercises, answered);
    key(&mut window, Key::R);
    assert_eq!(window.state().session().exercises, blank);
    assert!(!says(&window, ALL_RIGHT));
    // Another question was chosen: R asks the step's once more.
    press(&mut window, "New numbers");
    assert_ne!(window.state().session().exercises, blank);
    press(&mut window, "Back to the step");
    assert_eq!(window.state().session().exercises, blank);
}

#[test]
fn closing_the_lesson_gives_back_the_exercise_from_before() {
    let mut window = at_step(2, 4);
    let before = window.state().session().exercises.clone();
    press(&mut window, "Next");
    assert_ne!(window.state().session().exercises, before);
    press(&mut window, "Close the lesson");
    assert_eq!(window.state().session().exercises, before);
}

#[test]
fn a_question_s_figure_draws_what_the_step_shows_and_end_shows_its_solution() {
    let mut window = at_step(12, 9);
    let items = |window: &Window| {
        let view = window.state().derived().world_view.clone().unwrap();
        view.marks.iter().map(|mark| mark.item).collect::<Vec<Item>>()
    };
    let shown = items(&window);
    assert!(shown.contains(&Item::Floor) && !shown.contains(&Item::Axes), "{shown:?}");
    go_to(&mut window, 6, 6);
    assert!(items(&window).contains(&Item::Axes));
    key(&mut window, Key::End);
    assert_says(&window, "Hide the solution");
    let roots = texts_with(&window, "5 √2");
    assert!(!roots.is_empty(), "its t");
}
