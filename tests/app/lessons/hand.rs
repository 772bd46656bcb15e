//! What a lecturer has at hand while presenting: ink, contents, the enlarged derivation and lines that come one by one.

use egui::accesskit::Role;
use egui::{Key, Modifiers, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::session::ViewLayout;

use super::{Window, begin, key, shown_step};
use crate::harness::{assert_says, drag_from, window};

/// Goes to the step of this number by the list of all steps.
fn go_to(window: &mut Window, number: &str) {
    key(window, Key::O);
    window.get_by_label("Command").type_text(number);
    window.run();
    key(window, Key::Enter);
}

#[test]
fn ink_stays_with_its_step() {
    let mut window = window("canonical");
    begin(&mut window, 5, 1);
    key(&mut window, Key::F5);
    key(&mut window, Key::P);
    let strokes =
        |window: &Window| window.state().session().live.pen.as_ref().map(|pen| pen.strokes.len());
    let center = window.get_by_label("World view").rect().center();
    drag_from(&mut window, center, vec2(60.0, 40.0));
    assert_eq!(strokes(&window), Some(1));
    begin(&mut window, 5, 2);
    assert_eq!(strokes(&window), Some(0));
    begin(&mut window, 5, 1);
    assert_eq!(strokes(&window), Some(1));
    go_to(&mut window, "5.2");
    assert_eq!((shown_step(&window), strokes(&window)), ((5, 2), Some(0)));
    window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.run();
    assert_eq!((shown_step(&window), strokes(&window)), ((5, 1), Some(1)), "undo, too");
    key(&mut window, Key::Escape);
    key(&mut window, Key::P);
    assert_eq!(strokes(&window), Some(0), "Escape has wiped it off");
}

#[test]
fn the_contents_open_at_the_step_and_find_another_one_while_presenting() {
    let mut window = window("canonical");
    begin(&mut window, 7, 3);
    key(&mut window, Key::F5);
    key(&mut window, Key::O);
    let chosen = |window: &Window| {
        let mut nodes = window.query_all_by_role(Role::Button);
        nodes.find_map(|node| {
            let is_on = node.accesskit_node().is_selected() == Some(true);
            node.accesskit_node().label().filter(|_| is_on)
        })
    };
    assert!(chosen(&window).is_some_and(|name| name.contains("Right: u")), "{:?}", chosen(&window));
    key(&mut window, Key::Escape);
    go_to(&mut window, "12.5");
    assert_eq!(shown_step(&window), (12, 5));
    assert!(window.state().session().presenting.is_some());
}

#[test]
fn a_step_without_a_derivation_says_so_and_stays() {
    let mut window = window("canonical");
    key(&mut window, Key::F5);
    for (lesson, step, why) in [
        (11, 1, "This step has no derivation."),
        (8, 3, "This step has no derivation."),
        (7, 2, "The derivation comes with the answer."),
    ] {
        begin(&mut window, lesson, step);
        let layout = window.state().session().shown.setup.layout;
        key(&mut window, Key::Num1);
        assert_says(&window, why);
        assert_eq!(window.state().session().shown.setup.layout, layout);
    }
    key(&mut window, Key::PageDown);
    key(&mut window, Key::Num1);
    assert_eq!(window.state().session().shown.setup.layout, ViewLayout::DerivationAlone);
}

#[test]
fn a_step_that_is_open_comes_line_by_line_when_it_is_presented() {
    let mut window = window("canonical");
    begin(&mut window, 7, 3);
    let lines = |window: &Window| window.state().session().shown.revealed_lines;
    assert_eq!(lines(&window), None);
    key(&mut window, Key::F5);
    assert_eq!(lines(&window), Some(0));
    key(&mut window, Key::PageDown);
    assert!(lines(&window) > Some(0));
    key(&mut window, Key::F5);
    assert_eq!(lines(&window), None);
}
