//! Undo and redo: every change of the document is a step with a name, a drag is one step.

use egui::{Key, Modifiers, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::ui::app::App;
use pinhole_core::DVec3;

use crate::harness::{assert_says, choose_object, drag_from, type_into, window};

fn press(harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    harness.key_press_modifiers(modifiers, key);
    harness.run();
}

fn undo(harness: &mut Harness<'_, App>) {
    press(harness, Modifiers::COMMAND, Key::Z);
}

fn redo(harness: &mut Harness<'_, App>) {
    press(harness, Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
}

/// What the Edit menu says of undo and redo.
#[track_caller]
fn assert_menu(harness: &mut Harness<'_, App>, undo: &str, redo: &str) {
    harness.get_by_label("Edit").click();
    harness.run();
    for (text, keys) in [(undo, "Ctrl+Z"), (redo, "Ctrl+Shift+Z")] {
        assert_says(harness, &format!("{text} {keys}"));
    }
    press(harness, Modifiers::NONE, Key::Escape);
}

#[test]
fn steps_that_change_no_object_share_all_of_them() {
    let mut harness = window("look-at");
    let before = harness.state().document().clone();
    for (field, number) in [("eye x", "3"), ("up z", "0.5"), ("distance", "2")] {
        type_into(&mut harness, field, number);
    }
    let shared = |harness: &Harness<'_, App>| {
        let now = harness.state().document();
        now.spheres.is_same(&before.spheres) && now.planes.is_same(&before.planes)
    };
    assert!(shared(&harness), "edited");
    for key in [Key::Z, Key::Z, Key::Y] {
        harness.key_press_modifiers(Modifiers::COMMAND, key);
        harness.run();
        assert!(shared(&harness), "undone and redone");
    }
    // What is edited is a list of its own from then on.
    choose_object(&mut harness, "sphere 0 “target”");
    type_into(&mut harness, "radius", "2.5");
    let edited = harness.state().document().clone();
    assert!(!edited.spheres.is_same(&before.spheres) && edited.planes.is_same(&before.planes));
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run();
    assert!(shared(&harness), "the list from before, not one like it");
}

#[test]
fn each_change_is_undone_by_its_name() {
    let mut harness = window("canonical");
    let opened = harness.state().document().clone();
    assert_menu(&mut harness, "Undo", "Redo");
    type_into(&mut harness, "eye x", "3");
    type_into(&mut harness, "width", "2");
    harness.get_by_label("+ Sphere").click();
    harness.run();
    let added = harness.state().document().clone();
    assert_eq!(added.spheres.len(), opened.spheres.len() + 1);
    assert_menu(&mut harness, "Undo change spheres", "Redo");

    undo(&mut harness);
    assert_menu(&mut harness, "Undo change the viewport", "Redo change spheres");
    assert_eq!(harness.state().document().camera.viewport.width, 2.0);
    undo(&mut harness);
    assert_eq!(harness.state().document().camera.eye, DVec3::new(3.0, 0.0, 0.0));
    undo(&mut harness);
    assert_eq!(*harness.state().document(), opened);
    assert_menu(&mut harness, "Undo", "Redo move eye");
    undo(&mut harness);
    assert_eq!(*harness.state().document(), opened, "there is nothing left to undo");

    for _ in 0..3 {
        redo(&mut harness);
    }
    assert_eq!(*harness.state().document(), added);
    press(&mut harness, Modifiers::COMMAND, Key::Z);
    press(&mut harness, Modifiers::COMMAND, Key::Y);
    assert_eq!(*harness.state().document(), added);
}

#[test]
fn a_drag_is_one_step() {
    let mut harness = window("canonical");
    let field = harness.get_by_role_and_label(egui::accesskit::Role::SpinButton, "eye x");
    let from = field.rect().center();
    let opened = harness.state().document().clone();
    drag_from(&mut harness, from, vec2(60.0, 0.0));
    assert!(harness.state().document().camera.eye.x > 0.0);
    assert_menu(&mut harness, "Undo move eye", "Redo");
    undo(&mut harness);
    assert_eq!(*harness.state().document(), opened);
    assert_menu(&mut harness, "Undo", "Redo move eye");
}

#[test]
fn changes_by_the_menu_are_undone_from_it() {
    let mut harness = window("canonical");
    type_into(&mut harness, "eye y", "1");
    harness.get_by_label("Edit").click();
    harness.run();
    harness.get_by_label("Undo move eye Ctrl+Z").click();
    harness.run();
    assert_eq!(harness.state().document().camera.eye, DVec3::ZERO);
    harness.get_by_label("Edit").click();
    harness.run();
    harness.get_by_label("Redo move eye Ctrl+Shift+Z").click();
    harness.run();
    assert_eq!(harness.state().document().camera.eye, DVec3::Y);
}

#[test]
fn history_survives_the_steps_of_a_lesson() {
    let mut harness = window("canonical");
    type_into(&mut harness, "eye x", "3");
    harness.get_by_label("Lessons").click();
    harness.run();
    harness.get_by_label("Lesson 4: The eye moves").click();
    harness.run();
    harness.get_by_label("Discard").click();
    harness.run();
    let step_1 = harness.state().document().clone();
    type_into(&mut harness, "eye y", "2");
    // The answer to the step's question, then the next step.
    press(&mut harness, Modifiers::NONE, Key::PageDown);
    press(&mut harness, Modifiers::NONE, Key::PageDown);
    assert_eq!(harness.state().lesson().unwrap().id().step, 1);

    undo(&mut harness);
    assert_eq!(harness.state().lesson().unwrap().id().step, 0);
    assert_eq!(harness.state().document().camera.eye.y, 2.0);
    undo(&mut harness);
    assert_eq!(*harness.state().document(), step_1);
    undo(&mut harness);
    assert!(harness.state().lesson().is_none());
    assert_eq!(harness.state().document().camera.eye.x, 3.0);
    undo(&mut harness);
    assert_eq!(harness.state().document().camera.eye, DVec3::ZERO);
    for _ in 0..4 {
        redo(&mut harness);
    }
    assert_eq!(harness.state().lesson().unwrap().id().step, 1);
    assert_menu(&mut harness, "Undo show Lesson 4, step 2", "Redo");
}
