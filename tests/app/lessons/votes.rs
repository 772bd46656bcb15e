//! The vote on a step's question: its answers below it, by keys and by mouse, in two rounds.

use egui::accesskit::Role;
use egui::{Key, Rect, Vec2, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::features::vote::OpenVote;
use pinhole::model::lessons::builtin;

use super::{Window, begin, key, press};
use crate::harness::{assert_says, says, window};

fn open_vote(window: &Window) -> Option<OpenVote> {
    window.state().session().live.vote.clone()
}

/// The steps with a question, each with its lesson and its own number, counted from 1.
fn asked() -> impl Iterator<Item = (usize, usize)> {
    builtin::all().iter().zip(1..).flat_map(|(lesson, number)| {
        let steps = lesson.steps.iter().zip(1..);
        steps.filter(|(step, _)| step.question.is_some()).map(move |(_, step)| (number, step))
    })
}

#[test]
fn every_question_has_answers_to_vote_on_and_the_right_one_has_no_place_of_its_own() {
    let mut places = [0; 4];
    for (lesson, step) in asked() {
        let question = builtin::all()[lesson - 1].steps[step - 1].question.as_ref().unwrap();
        assert!(question.choices.len() >= 2, "{lesson}.{step}");
        places[OpenVote::on_choices(&question.choices).right] += 1;
    }
    let all: usize = places.iter().sum();
    assert!(places.iter().all(|count| 2 * count < all && *count > 0), "{places:?}");
}

#[test]
fn a_class_votes_twice_sees_what_is_right_and_then_why() {
    let mut window = window("canonical");
    begin(&mut window, 7, 2);
    key(&mut window, Key::F5);
    assert_eq!(open_vote(&window), None);
    key(&mut window, Key::V);
    let open = open_vote(&window).expect("a vote");
    assert_eq!(open.options.len(), 4);
    key(&mut window, Key::B);
    assert_eq!(open_vote(&window).unwrap().answer, Some(1), "B blanks no screen meanwhile");
    key(&mut window, Key::V);
    assert_eq!(open_vote(&window).unwrap().round, 1);
    press(&mut window, &open.named(open.right));
    assert_eq!(open_vote(&window).unwrap().answer, Some(open.right));
    let why = "points backwards, so it is the opposite of view";
    let told = |window: &Window| window.query_by_label_contains(why).is_some();
    assert!(!told(&window));
    key(&mut window, Key::PageDown);
    assert!(open_vote(&window).unwrap().is_revealed && !told(&window));
    key(&mut window, Key::PageDown);
    assert!(told(&window) && open_vote(&window).is_none());
    key(&mut window, Key::V);
    assert_eq!(open_vote(&window), None, "the question is answered");
}

#[test]
fn another_step_ends_a_vote_and_a_button_does() {
    let mut window = window("canonical");
    begin(&mut window, 10, 2);
    press(&mut window, "Vote");
    assert!(window.query_by_role_and_label(Role::Button, "Vote").is_none());
    press(&mut window, "End the vote");
    assert_eq!(open_vote(&window), None);
    press(&mut window, "Vote");
    key(&mut window, Key::PageUp);
    assert_eq!(open_vote(&window), None);
    begin(&mut window, 10, 2);
    key(&mut window, Key::F5);
    key(&mut window, Key::V);
    key(&mut window, Key::Escape);
    assert_eq!(open_vote(&window), None);
    assert!(window.state().session().presenting.is_some(), "Escape has ended the vote, no more");
    key(&mut window, Key::F5);
    key(&mut window, Key::V);
    press(&mut window, "Close the lesson");
    assert_eq!(open_vote(&window), None, "a vote ends with its lesson");
    begin(&mut window, 7, 1);
    assert!(window.query_by_role_and_label(Role::Button, "Vote").is_none(), "it asks nothing");
}

#[test]
fn a_wrong_count_of_hands_says_what_is_wrong() {
    let mut window = window("canonical");
    begin(&mut window, 4, 2);
    key(&mut window, Key::V);
    key(&mut window, Key::H);
    window.event(egui::Event::Text("12 40 9".to_owned()));
    window.run();
    key(&mut window, Key::Tab);
    assert_says(&window, "Give 2 numbers, such as 12 40: here are 3.");
    assert!(open_vote(&window).is_some_and(|open| open.counted().next().is_none()));
}

#[test]
fn a_question_without_answers_to_vote_on_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = super::asking::asking(folder.path());
    assert!(window.query_by_role_and_label(Role::Button, "Vote").is_none());
    key(&mut window, Key::V);
    assert_eq!(open_vote(&window), None);
    assert_says(&window, "This question has no answers to vote on");
    assert!(says(&window, "Where does w point?"));
}

/// The rectangles of a vote's options, below the question.
fn options(window: &Window) -> Vec<Rect> {
    let open = open_vote(window).unwrap();
    let rect = |index| window.get_by_role_and_label(Role::Button, &open.named(index)).rect();
    (0..open.options.len()).map(rect).collect()
}

/// `size` is in points, at the zoom with which a window of so many pixels is presented.
fn options_are_seen(size: Vec2) {
    let mut window = window("canonical");
    key(&mut window, Key::F5);
    window.set_size(size);
    window.run();
    let whole = Rect::from_min_size(egui::Pos2::ZERO, size);
    let mut lowest = f32::INFINITY;
    for (lesson, step) in asked() {
        begin(&mut window, lesson, step);
        key(&mut window, Key::V);
        let question = builtin::all()[lesson - 1].steps[step - 1].question.as_ref().unwrap();
        let start = question.ask.split('*').next().unwrap().to_owned();
        let text = window.query_all_by_role(Role::Label).find_map(|node| {
            let value = node.accesskit_node().value().or(node.accesskit_node().label());
            value.filter(|value| value.starts_with(&start)).map(|_| node.rect())
        });
        let text = text.unwrap_or_else(|| panic!("{lesson}.{step}: no {start:?}"));
        let buttons = ["Second round", "Reveal", "End the vote"];
        let of = |name: &str| window.get_by_role_and_label(Role::Button, name).rect();
        let rects: Vec<Rect> = options(&window).into_iter().chain(buttons.map(of)).collect();
        for (k, rect) in rects.iter().enumerate() {
            assert!(!rect.shrink(1.0).intersects(text), "{lesson}.{step}: {rect} on {text}");
            let apart = rects[..k].iter().all(|other| !other.shrink(1.0).intersects(*rect));
            assert!(apart, "{lesson}.{step}: {rects:?}");
            assert!(whole.contains_rect(*rect), "{lesson}.{step}: {rect} in {whole}");
        }
        let heights = options(&window).into_iter().map(|rect| rect.height());
        lowest = heights.fold(lowest, f32::min);
    }
    assert!(lowest >= 24.0, "{lowest} at {size}");
}

#[test]
fn the_options_have_room_below_the_question_at_1920_x_1080() {
    options_are_seen(vec2(819.0, 461.0));
}

#[test]
fn the_options_have_room_below_the_question_at_1024_x_768() {
    options_are_seen(vec2(737.0, 553.0));
}

#[test]
fn the_options_have_room_below_the_question_at_390_x_844() {
    options_are_seen(vec2(390.0, 844.0));
}
