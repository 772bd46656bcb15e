//! While the palette or the sheet of keys lies over the window, mouse and keys are theirs.

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, Pos2, TouchPhase, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::ui::app::App;

use crate::harness::{drag_from, window};

/// How the palette and the sheet of keys are opened.
const SHEETS: [(Modifiers, Key); 2] =
    [(Modifiers::COMMAND, Key::P), (Modifiers::SHIFT, Key::Questionmark)];

fn press(harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    harness.key_press_modifiers(modifiers, key);
    harness.run();
}

fn wheel_at(harness: &mut Harness<'_, App>, at: Pos2) {
    harness.hover_at(at);
    harness.run();
    let (unit, source) = (MouseWheelUnit::Line, MouseWheelSource::Wheel);
    let (delta, phase) = (vec2(0.0, 2.0), TouchPhase::Move);
    let modifiers = Modifiers::COMMAND | Modifiers::CTRL;
    harness.event(Event::ModifiersChanged(modifiers));
    harness.event(Event::MouseWheel { unit, delta, phase, source, modifiers });
    harness.run_steps(12);
    harness.event(Event::ModifiersChanged(Modifiers::NONE));
}

#[test]
fn neither_mouse_nor_keys_move_the_camera_below_a_sheet() {
    for (modifiers, key) in SHEETS {
        let mut harness = window("canonical");
        let handle = harness.get_by_role_and_label(Role::Slider, "eye handle").rect().center();
        let view = harness.get_by_role_and_label(Role::Image, "Camera view").rect();
        harness.get_by_role_and_label(Role::Slider, "eye handle").focus();
        harness.run();
        press(&mut harness, modifiers, key);
        let before = harness.state().document().clone();
        for key in [Key::ArrowRight, Key::ArrowUp] {
            press(&mut harness, Modifiers::NONE, key);
        }
        harness.hover_at(handle);
        harness.run();
        assert_eq!(harness.state().session().live.handles.over, None, "no handle is pointed at");
        wheel_at(&mut harness, view.center());
        assert_eq!(harness.state().document(), &before);
        // A drag outside the sheet closes it, and does nothing else.
        drag_from(&mut harness, handle, vec2(30.0, -20.0));
        assert_eq!(harness.state().document(), &before);
    }
}

#[test]
fn escape_closes_the_sheet_and_leaves_the_zoom_from_just_before() {
    for (modifiers, key) in SHEETS {
        let mut harness = window("canonical");
        let view = harness.get_by_role_and_label(Role::Image, "Camera view").rect();
        let before = harness.state().document().camera;
        wheel_at(&mut harness, view.center());
        let zoomed = harness.state().document().camera;
        assert_ne!(zoomed, before);
        press(&mut harness, modifiers, key);
        press(&mut harness, Modifiers::NONE, Key::Escape);
        assert_eq!(harness.state().document().camera, zoomed);
        // The sheet is closed: keys go where they went.
        press(&mut harness, Modifiers::NONE, Key::F5);
        assert!(harness.state().session().presenting.is_some());
    }
}
