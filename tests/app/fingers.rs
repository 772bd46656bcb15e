//! A phone's window, by touch alone: presenting is left, lessons go on, menus open and dialogs are whole.

use egui::accesskit::Role;
use egui::epaint::Shape;
use egui::{
    Event, Modifiers, PointerButton, Pos2, Rect, TouchDeviceId, TouchId, TouchPhase, pos2, vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::lessons::{StepId, Which};
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;

use crate::harness::{command, open_scene, show, texts_with, window};

const PHONE: egui::Vec2 = vec2(390.0, 844.0);
/// Height of the bar at the top, in which the scene's name is cut off.
const BAR: f32 = 30.0;

fn phone() -> Harness<'static, App> {
    let mut harness = window("canonical");
    harness.set_size(PHONE);
    harness.run();
    harness
}

/// Sends what a browser tells of one finger, in one frame.
fn finger(harness: &mut Harness<'_, App>, phase: TouchPhase, pos: Pos2) {
    let button = |pressed| Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    let mut events = match phase {
        TouchPhase::Start => vec![button(true)],
        TouchPhase::Move => vec![Event::PointerMoved(pos)],
        _ => vec![button(false), Event::PointerGone],
    };
    let (device_id, id) = (TouchDeviceId(0), TouchId(0));
    events.push(Event::Touch { device_id, id, phase, pos, force: None });
    harness.input_mut().events.extend(events);
    harness.step();
}

fn tap(harness: &mut Harness<'_, App>, at: Pos2) {
    finger(harness, TouchPhase::Start, at);
    finger(harness, TouchPhase::End, at);
    harness.run_ok();
}

fn tap_button(harness: &mut Harness<'_, App>, name: &str) {
    let button = harness.get_by_role_and_label(Role::Button, name).rect();
    assert!(button.height() >= 36.0, "{name} is too small for a finger: {button}");
    tap(harness, button.center());
}

fn swipe(harness: &mut Harness<'_, App>, from: Pos2, by: f32) {
    finger(harness, TouchPhase::Start, from);
    for k in 1..=4 {
        finger(harness, TouchPhase::Move, from + vec2(0.25 * k as f32 * by, 0.0));
    }
    finger(harness, TouchPhase::End, from + vec2(by, 0.0));
    harness.run_ok();
}

fn step(harness: &Harness<'_, App>) -> (usize, bool) {
    let state = harness.state();
    (state.lesson().unwrap().id().step, state.session().shown.is_asking)
}

#[test]
fn presenting_goes_on_and_ends_by_touch() {
    let mut harness = phone();
    harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(6), step: 0 }, None);
    harness.run();
    harness.key_press(egui::Key::F5);
    harness.run();
    assert!(harness.query_by_label("End presenting").is_none(), "a mouse's hand has keys");
    tap(&mut harness, pos2(200.0, 100.0));
    let begun = step(&harness);
    tap_button(&mut harness, "Next");
    assert_ne!(step(&harness), begun);
    tap_button(&mut harness, "Previous");
    tap_button(&mut harness, "End presenting");
    assert!(harness.state().session().presenting.is_none());
    assert!(harness.state().lesson().is_some());
}

#[test]
fn a_swipe_over_the_text_leads_through_a_lesson_and_a_short_one_does_not() {
    let mut harness = phone();
    harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(6), step: 4 }, None);
    harness.run();
    let text = pos2(250.0, 560.0);
    let begun = step(&harness);
    swipe(&mut harness, text, -30.0);
    assert_eq!(step(&harness), begun);
    swipe(&mut harness, text, -150.0);
    assert_ne!(step(&harness), begun);
    swipe(&mut harness, text - vec2(150.0, 0.0), 150.0);
    assert_eq!(step(&harness).0, begun.0);
}

#[test]
fn presenting_ends_when_the_window_no_longer_fills_the_screen() {
    let mut harness = phone();
    harness.state_mut().end_presenting();
    assert!(harness.state().session().presenting.is_none(), "it does not begin");
    harness.key_press(egui::Key::F5);
    harness.run();
    harness.state_mut().end_presenting();
    harness.run();
    assert!(harness.state().session().presenting.is_none());
}

#[test]
fn every_menu_opens_by_touch() {
    for (menu, entry) in [("File", "Share…"), ("View", "Frame the camera"), ("Tools", "Translator")]
    {
        let mut harness = phone();
        let at = harness.get_by_label("Menu").rect().center();
        tap(&mut harness, at);
        let button = |node: &egui_kittest::Node<'_>| node.accesskit_node().role() == Role::Button;
        let at = harness.query_all_by_label_contains(menu).find(button).unwrap().rect().center();
        tap(&mut harness, at);
        let shown = harness.query_all_by_label_contains(entry).next();
        let rect = shown.unwrap_or_else(|| panic!("{menu} does not open")).rect();
        assert!(rect.left() >= 0.0 && rect.right() <= PHONE.x, "{entry}: {rect}");
    }
}

#[test]
fn pages_are_stacked_on_a_phone_and_no_text_is_cut() {
    use ViewLayout::{Compare, Derivation, Lines, Mistakes, Plot};
    for layout in [Compare, Derivation, Lines, Mistakes, Plot] {
        let mut harness = phone();
        harness.key_press(egui::Key::G);
        show(&mut harness, layout);
        let is_below = |node: &egui_kittest::Node<'_>| node.rect().top() > BAR;
        for node in harness.query_all_by_role(Role::Label).filter(is_below) {
            let rect = node.rect();
            assert!(
                rect.right() <= PHONE.x,
                "{layout:?}: {:?} {rect}",
                node.accesskit_node().value()
            );
        }
        if layout != Lines {
            let world = harness.get_by_role_and_label(Role::Image, "World view").rect();
            assert!(world.width() > 180.0, "{layout:?}: {world}");
        }
    }
}

#[test]
fn dialogs_and_the_contents_are_whole_on_a_phone() {
    for title in ["Share", "Export a figure", "Save as", "About Pinhole"] {
        let mut harness = phone();
        command(&mut harness, title);
        let buttons = harness.query_all_by_role(Role::Button);
        let right = buttons.map(|button| button.rect().right()).fold(0.0, f32::max);
        assert!(right <= PHONE.x, "{title}: {right}");
        let fields = harness.query_all_by_role(Role::TextInput);
        let right = fields.map(|field| field.rect().right()).fold(0.0, f32::max);
        assert!(right <= PHONE.x, "{title}: {right}");
    }
    let mut harness = phone();
    harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(6), step: 2 }, None);
    harness.run();
    harness.get_by_label("Contents").click();
    harness.run();
    for entry in harness.query_all_by_label_contains("1. ") {
        assert!(entry.rect().right() <= PHONE.x, "{:?}", entry.rect());
    }
}

#[test]
fn a_lesson_is_closed_by_touch_and_the_page_from_before_comes_back() {
    for layout in [ViewLayout::Both, ViewLayout::Lines] {
        let mut harness = phone();
        show(&mut harness, layout);
        harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(6), step: 2 }, None);
        harness.run();
        tap(&mut harness, pos2(200.0, 100.0));
        tap_button(&mut harness, "Close the lesson");
        assert!(harness.state().lesson().is_none());
        let failed = harness.query_by_label("Pinhole ran into an internal error").is_some();
        assert!(!failed, "{layout:?}");
    }
}

#[test]
fn the_menu_closes_when_it_presents() {
    let mut harness = phone();
    for name in ["Menu", "View", "Present"] {
        let is_one = |node: &egui_kittest::Node<'_>| node.accesskit_node().role() == Role::Button;
        let all: Vec<_> = harness.query_all_by_label_contains(name).filter(is_one).collect();
        let at = all.last().unwrap_or_else(|| panic!("no {name}")).rect().center();
        drop(all);
        tap(&mut harness, at);
    }
    assert!(harness.state().session().presenting.is_some());
    assert!(!egui::Popup::is_any_open(&harness.ctx), "Escape would close the menu first");
}

#[test]
fn an_exercise_is_whole_and_within_reach() {
    for (lesson, k) in [(1, 4), (1, 5), (2, 5), (5, 5), (6, 5), (7, 3), (10, 5), (11, 8)] {
        let mut harness = phone();
        tap(&mut harness, pos2(200.0, 100.0));
        harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(lesson), step: k }, None);
        harness.run();
        let hint = harness.get_by_label_contains("You may type").rect();
        let buttons = ["New numbers", "Check", "Show the solution", "Copy my answer", "Next"];
        let of = |name: &&str| harness.get_by_role_and_label(Role::Button, name).rect();
        let buttons: Vec<Rect> = buttons.iter().map(of).collect();
        assert!(buttons.iter().all(|button| button.height() >= 36.0), "{buttons:?}");
        let fields = harness.get_all_by_role(Role::TextInput).map(|field| field.rect());
        let all: Vec<Rect> = fields.chain([hint]).chain(buttons).collect();
        for (index, rect) in all.iter().enumerate() {
            assert!(Rect::from_min_size(Pos2::ZERO, PHONE).contains_rect(*rect), "{rect}");
            let over = all[..index].iter().find(|other| other.shrink(0.5).intersects(*rect));
            assert_eq!(over, None, "{}.{}: on {rect}", lesson + 1, k + 1);
        }
        tap_button(&mut harness, "Show the solution");
        harness.get_by_role_and_label(Role::Button, "Hide the solution");
    }
}

#[test]
fn an_animation_can_be_closed_by_touch() {
    for kind in ["Roll: up turns around view", "Scan the pixels row by row"] {
        let mut harness = phone();
        tap(&mut harness, pos2(200.0, 100.0));
        command(&mut harness, kind);
        for name in ["Stop and go back", "Keep this", "position", "Step forward"] {
            let rect = harness.get_by_label(name).rect();
            assert!(rect.left() >= 0.0 && rect.right() <= PHONE.x, "{name}: {rect}");
        }
    }
}

/// A phone that a finger has touched, on a lesson's step.
fn touched_at(lesson: usize, step: usize) -> Harness<'static, App> {
    let mut harness = phone();
    tap(&mut harness, pos2(200.0, 100.0));
    let id = StepId { lesson: Which::Builtin(lesson), step };
    harness.state_mut().open_lesson(id, None);
    harness.run_ok();
    harness
}

fn type_answer(harness: &mut Harness<'_, App>, field: &str, text: &str) {
    let at = harness.get_by_role_and_label(Role::TextInput, field).rect().center();
    tap(harness, at);
    harness.event(Event::Text(text.to_owned()));
    harness.run_ok();
}

#[test]
fn all_answers_that_are_not_numbers_are_named() {
    let mut harness = touched_at(5, 5);
    for field in ["u x", "u y", "u z", "v x", "v y", "v z", "w x", "w y", "w z", "t"] {
        type_answer(&mut harness, &format!("answer {field}"), "abc");
    }
    tap_button(&mut harness, "Check");
    assert_eq!(texts_with(&harness, "𝐮, 𝐯, 𝐰, 𝑡 are not numbers").len(), 1);
}

#[test]
fn a_typed_text_stands_in_the_middle_of_its_field() {
    let mut harness = touched_at(5, 5);
    type_answer(&mut harness, "answer t", "12345");
    let field = harness.get_by_role_and_label(Role::TextInput, "answer t").rect();
    let shapes = harness.output().shapes.iter();
    let mut texts = shapes.filter_map(|clipped| match &clipped.shape {
        Shape::Text(text) if text.galley.text() == "12345" => Some(text.visual_bounding_rect()),
        _ => None,
    });
    let text = texts.next().unwrap();
    assert!((text.center().y - field.center().y).abs() < 2.0, "{text} in {field}");
}

#[test]
fn a_notice_covers_no_button() {
    let mut harness = touched_at(5, 5);
    type_answer(&mut harness, "answer t", "4");
    tap_button(&mut harness, "Copy my answer");
    let title = harness.get_by_label("The code of your answer is on the clipboard").rect();
    let close = harness.get_by_role_and_label(Role::Button, "Close").rect();
    let notice = title.union(close);
    let buttons = harness.query_all_by_role(Role::Button).map(|button| button.rect());
    let covered: Vec<Rect> =
        buttons.filter(|rect| *rect != close && rect.intersects(notice)).collect();
    assert_eq!(covered, [], "{notice}");
}

#[test]
fn instructions_name_what_the_hand_holds() {
    let mut harness = touched_at(6, 0);
    let has = |harness: &Harness<'_, App>, words: &str| !texts_with(harness, words).is_empty();
    assert!(has(&harness, "Tap Play to see") && !has(&harness, "Press Space"));
    // A mouse is moved.
    harness.hover_at(pos2(200.0, 120.0));
    harness.run_ok();
    assert!(has(&harness, "Press Space to see") && !has(&harness, "Tap Play"));
    let mut harness = phone();
    assert!(has(&harness, "Click a pixel"));
    tap(&mut harness, pos2(200.0, 100.0));
    assert!(has(&harness, "Tap a pixel") && !has(&harness, "Click"));
    command(&mut harness, "Guess which");
    assert!(!has(&harness, "Enter"), "a finger has no keys");
}

#[test]
fn vote_and_export_are_whole_and_nothing_in_them_overlaps() {
    let choices = [Role::RadioButton, Role::CheckBox];
    for (title, roles) in [("Guess which", &[Role::Button][..]), ("Export a figure", &choices)] {
        for presenting in [false, true] {
            let mut harness = phone();
            tap(&mut harness, pos2(200.0, 100.0));
            if presenting {
                harness.key_press(egui::Key::F5);
                harness.run();
                harness.set_size(PHONE);
            }
            command(&mut harness, title);
            let nodes = roles.iter().flat_map(|role| harness.query_all_by_role(*role));
            let all: Vec<Rect> = nodes.map(|node| node.rect()).collect();
            // Below the window is what can be scrolled to.
            let all: Vec<Rect> = all.into_iter().filter(|rect| rect.center().y < PHONE.y).collect();
            for (k, rect) in all.iter().enumerate() {
                let is_whole = Rect::from_min_size(Pos2::ZERO, PHONE).contains_rect(*rect);
                assert!(is_whole, "{title}: {rect}");
                let other = all[..k].iter().find(|other| other.shrink(1.0).intersects(*rect));
                assert_eq!(other, None, "{title}: {rect}");
            }
        }
    }
}

#[test]
fn the_codes_of_a_class_have_the_whole_width() {
    let mut harness = phone();
    show(&mut harness, ViewLayout::Class);
    let codes = harness.get_by_role_and_label(Role::MultilineTextInput, "codes").rect();
    assert!(codes.width() > 300.0, "{codes}");
}

#[test]
fn a_ghosts_numbers_have_as_many_digits_as_in_a_wide_window() {
    let mut harness = phone();
    open_scene(&mut harness, "look-at");
    harness.key_press(egui::Key::G);
    show(&mut harness, ViewLayout::Compare);
    let now = |harness: &Harness<'_, App>| texts_with(harness, "u: ghost");
    let on_phone = now(&harness);
    harness.set_size(vec2(1280.0, 800.0));
    harness.run();
    assert_eq!((on_phone.len(), on_phone), (1, now(&harness)));
}
