//! What a screen reader hears of a page, whose widgets a browser does not tell it.

use egui::Event;
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;
use pinhole_lecture::exercises::Exercise;

use crate::app::practice::exercises::{answers, open};
use crate::harness::{command, show, type_into, window};

fn told(window: &Harness<'_, App>) -> String {
    window.state().spoken()
}

#[track_caller]
fn assert_told(window: &Harness<'_, App>, part: &str) {
    assert!(told(window).contains(part), "no “{part}” in: {}", told(window));
}

fn click(window: &mut Harness<'_, App>, label: &str) {
    window.get_by_role_and_label(Role::Button, label).click_accesskit();
    window.run();
}

#[test]
fn the_selected_ray_is_told_as_it_is_shown() {
    let mut window = window("canonical");
    assert_told(&window, ": hits plane 2 “back wall” at t = 6, point = (1.2, −0.6, −6)");
    type_into(&mut window, "row", "198");
    type_into(&mut window, "column", "199");
    assert_told(&window, "row 198, column 199: hits sphere 0");
    command(&mut window, "Count from 1");
    assert_told(&window, "row 199, column 200 (from 1): hits sphere 0");
    assert!(!told(&window).contains("row 198"), "counted in two ways: {}", told(&window));
    let longest = told(&window).split(|c: char| !c.is_ascii_digit()).map(str::len).max();
    assert!(longest < Some(8), "more digits than on the screen: {}", told(&window));
}

#[test]
fn an_exercise_is_told_without_its_solution() {
    let mut window = open(Exercise::Sphere);
    assert_told(&window, "A ray and a sphere\n");
    assert_told(&window, "\nt: \npoint: \n");
    for number in ["hits", "= 4", "u (right)"] {
        assert!(!told(&window).contains(number), "{}", told(&window));
    }
    answers(&mut window, "t", &["6"]);
    assert_told(&window, "\nt: 6\npoint: \n");
    click(&mut window, "Check");
    assert_told(&window, "t: 6. Wrong: That is the second root");
}

#[test]
fn a_vote_is_told_without_its_answer() {
    let mut window = window("look-at");
    show(&mut window, ViewLayout::Mistakes);
    click(&mut window, "Guess which");
    assert_told(&window, "Which mistake made the wrong picture?\nA: ");
    let right = window.state().session().shown.mistakes_view.shown().name();
    assert_eq!(told(&window).matches(right).count(), 1, "{}", told(&window));
    click(&mut window, "Reveal");
    assert_eq!(told(&window).matches(right).count(), 2, "{}", told(&window));
}

#[test]
fn dialogs_and_errors_are_told() {
    let mut window = window("canonical");
    window.event(Event::Paste("#v1/canonical/00000000".to_owned()));
    window.run();
    assert_told(&window, "This link cannot be opened\nlink:1:14: mistyped or cut off");
    click(&mut window, "Close");
    assert!(!told(&window).contains("link"), "{}", told(&window));
    window.event(Event::Paste("no camera".to_owned()));
    window.run();
    assert_told(&window, "no camera");
    type_into(&mut window, "at z", "0");
    assert_told(&window, "eye and at are the same point");
}
