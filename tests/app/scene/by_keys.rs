//! Everything by the keyboard: the camera steered in its view, the observer in the world view, objects,
//! the strip of an animation, handles in round steps.

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::ui::app::App;
use pinhole_core::steering::Keep;
use pinhole_figure::concept::Concept;
use pinhole_figure::overlay::{Mark, Shape};
use pinhole_figure::overlay_items::Item;

use super::{at_of, camera};
use crate::harness::{assert_says, says, window};

fn press(harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    harness.key_press_modifiers(modifiers, key);
    harness.run();
}

/// A key within one frame, and the frame after it: what is said for a moment is still there.
fn press_at_once(harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    for pressed in [true, false] {
        let event = Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
        harness.input_mut().events.push(event);
    }
    harness.run_steps(2);
}

fn focus(harness: &mut Harness<'_, App>, role: Role, label: &str) {
    harness.get_by_role_and_label(role, label).focus();
    harness.run();
}

/// Does the first command that is found by these letters.
fn command(harness: &mut Harness<'_, App>, text: &str) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::P);
    harness.run_steps(3);
    harness.get_by_role_and_label(Role::TextInput, "Command").type_text(text);
    harness.run_steps(3);
    harness.key_press(Key::Enter);
    harness.run_steps(3);
}

#[test]
fn keys_steer_the_camera_in_its_view_and_say_what_they_do() {
    let mut harness = window("look-at");
    let before = camera(&harness);
    let selected = harness.state().session().shown.selection;
    let basis = before.basis().unwrap();
    focus(&mut harness, Role::Image, "Camera view");
    let press = press_at_once;

    press(&mut harness, Modifiers::ALT, Key::ArrowRight);
    let looked = camera(&harness);
    assert_eq!((looked.eye, looked.up()), (before.eye, before.up()));
    assert!((at_of(&looked) - at_of(&before)).dot(basis.u) > 0.0, "to the right");
    press(&mut harness, Modifiers::ALT, Key::ArrowUp);
    assert!((at_of(&camera(&harness)) - at_of(&looked)).dot(basis.v) > 0.0, "and up");
    // Both are one step of the history.
    press(&mut harness, Modifiers::COMMAND, Key::Z);
    assert_eq!(camera(&harness), before);

    press(&mut harness, Modifiers::COMMAND, Key::ArrowRight);
    let orbited = camera(&harness);
    assert_eq!((at_of(&orbited), orbited.up()), (at_of(&before), before.up()));
    assert!((orbited.eye - before.eye).dot(basis.u) > 0.0, "the eye goes to the right");
    assert_says(&harness, "orbit around at");
    press(&mut harness, Modifiers::NONE, Key::Escape);
    assert_eq!(camera(&harness), before, "Escape takes back what keys have just done");
    press(&mut harness, Modifiers::COMMAND, Key::ArrowUp);
    assert!((camera(&harness).eye - before.eye).dot(basis.v) > 0.0, "and up");
    press(&mut harness, Modifiers::NONE, Key::Escape);

    press(&mut harness, Modifiers::NONE, Key::Plus);
    let zoomed = camera(&harness);
    assert_eq!((zoomed.eye, zoomed.orientation), (before.eye, before.orientation));
    assert!(zoomed.viewport.width < before.viewport.width);
    press(&mut harness, Modifiers::NONE, Key::Escape);
    press(&mut harness, Modifiers::NONE, Key::Minus);
    assert!(camera(&harness).viewport.width > before.viewport.width);
    press(&mut harness, Modifiers::NONE, Key::Escape);
    assert_eq!((camera(&harness), harness.state().session().shown.selection), (before, selected));
}

#[test]
fn the_same_keys_move_the_observer_in_the_world_view() {
    let mut harness = window("look-at");
    let before = harness.state().document().clone();
    focus(&mut harness, Role::Image, "World view");
    let keys = [
        (Modifiers::COMMAND, Key::ArrowRight, Key::ArrowLeft),
        (Modifiers::COMMAND, Key::ArrowUp, Key::ArrowDown),
        (Modifiers::ALT, Key::ArrowRight, Key::ArrowLeft),
        (Modifiers::ALT, Key::ArrowUp, Key::ArrowDown),
        (Modifiers::NONE, Key::Plus, Key::Minus),
    ];
    for (modifiers, there, back) in keys {
        let observer = harness.state().session().shown.observer.unwrap();
        press(&mut harness, modifiers, there);
        let moved = harness.state().session().shown.observer.unwrap();
        assert_ne!(moved, observer, "{there:?}");
        press(&mut harness, modifiers, back);
        let returned = harness.state().session().shown.observer.unwrap();
        let far = returned.target().distance(observer.target());
        assert!(far < 1e-9 && (returned.distance() - observer.distance()).abs() < 1e-9);
    }
    assert_eq!(harness.state().document(), &before);
}

#[test]
fn nothing_is_steered_while_a_field_or_the_other_view_has_the_focus() {
    let mut harness = window("look-at");
    let before = camera(&harness);
    focus(&mut harness, Role::Image, "World view");
    press(&mut harness, Modifiers::COMMAND, Key::ArrowRight);
    focus(&mut harness, Role::SpinButton, "eye x");
    for modifiers in [Modifiers::ALT, Modifiers::COMMAND] {
        press(&mut harness, modifiers, Key::ArrowRight);
    }
    assert_eq!(camera(&harness), before);
}

/// Whether the camera has a body, whose edges are named eye as its point is.
fn has_body(harness: &Harness<'_, App>) -> bool {
    let marks = harness.state().derived().world_view.clone().unwrap().marks;
    let is_edge = |mark: &&Mark| {
        mark.concept == Some(Concept::Eye) && matches!(mark.shape, Shape::Line { .. })
    };
    marks.iter().filter(is_edge).count() >= 8
}

#[test]
fn a_far_camera_has_a_body_and_a_near_one_has_handles_on_its_viewport() {
    let corner = "viewport, top right corner handle";
    let has_corner = |harness: &Harness<'_, App>| {
        harness.query_by_role_and_label(Role::Slider, corner).is_some()
    };
    let mut harness = window("look-at");
    assert!(!has_body(&harness), "its arrows and its frustum show the camera");
    for item in [Item::Basis, Item::ViewAndUp, Item::Frustum] {
        command(&mut harness, &format!("Overlay: {}", item.label()));
    }
    assert!(!has_corner(&harness) && has_body(&harness));
    press(&mut harness, Modifiers::SHIFT, Key::F);
    assert!(has_corner(&harness) && !has_body(&harness));
    press(&mut harness, Modifiers::NONE, Key::F);
    assert!(!has_corner(&harness) && has_body(&harness));
    assert!(!has_body(&window("canonical")));
    // However far away: the body keeps its size, and no note says that it is too small.
    focus(&mut harness, Role::Image, "World view");
    for _ in 0..12 {
        press(&mut harness, Modifiers::NONE, Key::Minus);
    }
    assert!(has_body(&harness));
    assert!(harness.query_by_role_and_label(Role::Button, "Frame the camera").is_none());
}

#[test]
fn objects_are_added_and_deleted() {
    let mut harness = window("canonical");
    let before = harness.state().document().clone();
    command(&mut harness, "+ sphere");
    let added = harness.state().document().spheres.len();
    assert_eq!(added, before.spheres.len() + 1);
    command(&mut harness, "delete the chosen");
    assert_eq!(harness.state().document(), &before);
    command(&mut harness, "+ plane");
    assert_eq!(harness.state().document().planes.len(), before.planes.len() + 1);
    press(&mut harness, Modifiers::COMMAND, Key::Z);
    assert_eq!(harness.state().document(), &before);
}

#[test]
fn what_is_kept_is_switched() {
    let mut harness = window("canonical");
    command(&mut harness, "eye travels");
    assert_eq!(harness.state().session().preferences.eye_keeps, Keep::View);
    command(&mut harness, "eye travels");
    assert_eq!(harness.state().session().preferences.eye_keeps, Keep::At);
}

#[test]
fn the_strip_of_an_animation_is_worked_by_commands() {
    let mut harness = window("canonical");
    let before = camera(&harness);
    command(&mut harness, "play: roll");
    let player = |harness: &Harness<'_, App>| harness.state().player().unwrap().clone();
    assert!(player(&harness).loops && player(&harness).speed == 1.0);
    press(&mut harness, Modifiers::NONE, Key::L);
    assert!(!player(&harness).loops);
    command(&mut harness, "export the animation");
    assert_says(&harness, "Export the animation");
    press(&mut harness, Modifiers::NONE, Key::Escape);
    press(&mut harness, Modifiers::NONE, Key::Period);
    let stepped = camera(&harness);
    assert_ne!(stepped, before);
    command(&mut harness, "play and compare: stop");
    assert!(harness.state().player().is_none());
    assert_eq!(camera(&harness), before);
    command(&mut harness, "play: roll");
    press(&mut harness, Modifiers::NONE, Key::Period);
    command(&mut harness, "play and compare: keep");
    assert_eq!(camera(&harness), stepped);
    // Without an animation there is nothing to export.
    command(&mut harness, "export the animation");
    assert!(!says(&harness, "Export the animation"));
}

#[test]
fn a_handle_goes_in_round_steps() {
    let mut harness = window("canonical");
    crate::harness::type_into(&mut harness, "eye y", "0.037");
    focus(&mut harness, Role::Slider, "eye handle");
    press(&mut harness, Modifiers::COMMAND, Key::ArrowUp);
    let y = camera(&harness).eye.y;
    let hundredths = y * 100.0;
    assert!(y > 0.037 && (hundredths - hundredths.round()).abs() < 1e-9, "{y} is no round one");
}

#[test]
fn escape_takes_back_what_keys_did_and_goes_on_presenting() {
    let mut harness = window("look-at");
    press(&mut harness, Modifiers::NONE, Key::F5);
    press(&mut harness, Modifiers::NONE, Key::Num3);
    let before = camera(&harness);
    // The only view needs no focus.
    press_at_once(&mut harness, Modifiers::COMMAND, Key::ArrowLeft);
    assert_ne!(camera(&harness), before);
    press_at_once(&mut harness, Modifiers::NONE, Key::Escape);
    assert_eq!(camera(&harness), before);
    assert!(harness.state().session().presenting.is_some());
}
