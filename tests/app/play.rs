//! Animations by key and label: where the camera is at which phase, going through them, and what is left
//! when they end.

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::features::play::state::Kind;
use pinhole::ui::app::App;
use pinhole_core::{Camera, DVec3, Orientation, Pixel, Selection};

use crate::harness::{assert_says, open_scene, says, type_into, window};

fn press(harness: &mut Harness<'_, App>, key: Key) {
    press_with(harness, Modifiers::NONE, key);
}

/// Not until nothing changes any more, which never is while something plays.
fn press_with(harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    harness.key_press_modifiers(modifiers, key);
    harness.run_steps(2);
}

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_role_and_label(Role::Button, label).click_accesskit();
    harness.run_steps(2);
}

/// A window with an animation of this name open.
fn playing(scene: &str, label: &str) -> Harness<'static, App> {
    let mut harness = window(scene);
    open(&mut harness, label);
    harness
}

fn open(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_role_and_label(Role::Button, "Play").click();
    harness.run();
    harness.get_by_role_and_label(Role::Button, label).click();
    harness.run();
}

fn camera(harness: &Harness<'_, App>) -> Camera {
    harness.state().document().camera
}

fn up(harness: &Harness<'_, App>) -> DVec3 {
    camera(harness).up()
}

fn undo_name(harness: &mut Harness<'_, App>) -> String {
    harness.get_by_label("Edit").click();
    harness.run();
    let entry = harness.get_by_label_contains("Undo");
    let name = egui_kittest::kittest::NodeT::accesskit_node(&entry).label().unwrap();
    harness.key_press(Key::Escape);
    harness.run();
    name
}

#[test]
fn up_swings_by_steps_and_stop_gives_back() {
    let mut harness = playing("canonical", "Roll: up turns around view");
    let opened = camera(&harness);
    for _ in 0..6 {
        press(&mut harness, Key::Period);
    }
    assert_says(&harness, "90°");
    assert_eq!(up(&harness), DVec3::NEG_X);
    assert_eq!(harness.state().derived().resolved.unwrap().basis().v, DVec3::NEG_X);
    press(&mut harness, Key::Comma);
    assert_says(&harness, "75°");
    click(&mut harness, "Step forward");
    click(&mut harness, "Step forward");
    click(&mut harness, "Step back");
    assert_eq!(up(&harness), DVec3::NEG_X);
    click(&mut harness, "Stop and go back");
    assert_eq!(camera(&harness), opened);
    assert!(harness.state().player().is_none());
    assert_eq!(undo_name(&mut harness), "Undo Ctrl+Z", "nothing has changed");
}

#[test]
fn what_is_kept_is_one_step_of_the_history() {
    let mut harness = playing("canonical", "Roll: up turns around view");
    let opened = camera(&harness);
    for _ in 0..12 {
        press(&mut harness, Key::Period);
    }
    click(&mut harness, "Keep this");
    assert_eq!(up(&harness), DVec3::NEG_Y);
    assert_eq!(undo_name(&mut harness), "Undo roll Ctrl+Z");
    press_with(&mut harness, Modifiers::COMMAND, Key::Z);
    assert_eq!(camera(&harness), opened);
    press_with(&mut harness, Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(up(&harness), DVec3::NEG_Y);
}

#[test]
fn undo_ends_what_plays() {
    let mut harness = window("canonical");
    type_into(&mut harness, "width", "2");
    open(&mut harness, "Orbit the camera around at");
    press(&mut harness, Key::Space);
    harness.run_steps(8);
    assert!(harness.state().player().unwrap().phase > 0.0);
    press_with(&mut harness, Modifiers::COMMAND, Key::Z);
    assert_eq!(camera(&harness).eye, DVec3::ZERO);
    assert_eq!(camera(&harness).viewport.width, 2.0, "that was before");
    assert!(harness.state().player().is_none());
    press_with(&mut harness, Modifiers::COMMAND, Key::Z);
    assert_eq!(camera(&harness).viewport.width, 1.0);
}

#[test]
fn space_plays_and_pauses_and_a_turn_loops() {
    let mut harness = playing("canonical", "Orbit the camera around at");
    press(&mut harness, Key::Space);
    let mut phases = Vec::new();
    let at = DVec3::new(0.0, 0.0, -5.0);
    let given = camera(&harness).orientation;
    for _ in 0..60 {
        harness.step();
        phases.push(harness.state().player().unwrap().phase);
        let Camera { eye, orientation, .. } = camera(&harness);
        assert!((eye.distance(at) - 5.0).abs() < 1e-12, "{eye}");
        assert_eq!(orientation, given);
    }
    assert!(phases.windows(2).any(|pair| pair[1] < pair[0]), "it begins again");
    press(&mut harness, Key::Space);
    let at = harness.state().player().unwrap().phase;
    harness.run_steps(5);
    assert_eq!(harness.state().player().unwrap().phase, at, "it rests");
    harness.run();
}

#[test]
fn without_loop_it_ends_at_the_end() {
    let mut harness = playing("canonical", "Orbit the camera around at");
    for _ in 0..18 {
        press(&mut harness, Key::Period);
    }
    assert!(camera(&harness).eye.distance(DVec3::new(-5.0, 0.0, -5.0)) < 1e-14);
    harness.get_by_role_and_label(Role::CheckBox, "Loop").click();
    harness.run_steps(2);
    press(&mut harness, Key::Space);
    // Nothing changes any more once it has ended.
    harness.run_steps(60);
    harness.run();
    let player = harness.state().player().unwrap();
    assert_eq!((player.phase, player.running), (1.0, false));
    assert_eq!(camera(&harness).eye, DVec3::ZERO);
    assert_says(&harness, "360°");
}

#[test]
fn t_runs_from_the_eye_to_the_hit() {
    let mut harness = playing("canonical", "Walk along the ray");
    let hit = harness.state().derived().inspection.as_ref().unwrap().first_hit().unwrap().t;
    assert_eq!(harness.state().session().shown.ray_point_t, None, "not begun");
    for _ in 0..6 {
        press(&mut harness, Key::Period);
    }
    assert_eq!(harness.state().session().shown.ray_point_t, Some(0.25 * hit));
    for _ in 0..18 {
        press(&mut harness, Key::Period);
    }
    assert_eq!(harness.state().session().shown.ray_point_t, Some(hit));
    let document = harness.state().document().clone();
    click(&mut harness, "Stop and go back");
    assert_eq!(harness.state().session().shown.ray_point_t, None);
    assert_eq!(*harness.state().document(), document);
}

#[test]
fn pixels_are_scanned_and_the_rest_is_not_there_yet() {
    let mut harness = window("canonical");
    type_into(&mut harness, "W", "8");
    type_into(&mut harness, "H", "8");
    let whole = harness.state().derived().camera_view.clone().unwrap().image;
    let selection = harness.state().session().shown.selection;
    open(&mut harness, "Scan the pixels row by row");
    let opened = harness.state().session();
    assert_eq!((opened.shown.selection, opened.live.scanned_pixels), (selection, None), "whole");
    for _ in 0..27 {
        press(&mut harness, Key::Period);
    }
    assert_says(&harness, "27 of 64 pixels");
    let session = harness.state().session();
    assert_eq!(session.shown.selection, Selection::Pixel(Pixel { row: 3, column: 2 }));
    assert_eq!(session.live.scanned_pixels, Some(27));
    let image = harness.state().derived().camera_view.clone().unwrap().image;
    // The middle of a pixel has no mark and no edge.
    let differs = |row: usize, column: usize| {
        let [w, h] = image.size;
        let offset = (2 * row + 1) * h / 16 * w + (2 * column + 1) * w / 16 + 5;
        image.pixels[offset] != whole.pixels[offset]
    };
    assert!((0..3).all(|row| (0..8).all(|column| !differs(row, column))), "scanned");
    assert!((4..8).all(|row| (0..8).all(|column| differs(row, column))), "not yet");
    assert!(!differs(3, 1) && differs(3, 5));
    click(&mut harness, "Stop and go back");
    assert_eq!(harness.state().session().shown.selection, selection);
    assert_eq!(harness.state().derived().camera_view.clone().unwrap().image.pixels, whole.pixels);
}

#[test]
fn who_edits_the_camera_takes_it_over() {
    let mut harness = playing("canonical", "Roll: up turns around view");
    let opened = camera(&harness);
    for _ in 0..6 {
        press(&mut harness, Key::Period);
    }
    type_into(&mut harness, "eye y", "3");
    assert!(harness.state().player().is_none());
    assert_eq!(camera(&harness).eye, DVec3::new(0.0, 3.0, 0.0));
    assert_eq!(up(&harness), DVec3::NEG_X);
    assert_eq!(undo_name(&mut harness), "Undo move eye Ctrl+Z");
    press_with(&mut harness, Modifiers::COMMAND, Key::Z);
    assert_eq!(undo_name(&mut harness), "Undo roll Ctrl+Z");
    press_with(&mut harness, Modifiers::COMMAND, Key::Z);
    assert_eq!(camera(&harness), opened);
}

#[test]
fn the_slider_goes_anywhere_and_another_kind_begins_at_the_start() {
    let mut harness = playing("canonical", "Roll: up turns around view");
    let opened = camera(&harness);
    harness.get_by_role_and_label(Role::Slider, "position").focus();
    harness.run();
    harness.key_press(Key::ArrowRight);
    harness.run();
    assert!(harness.state().player().unwrap().phase > 0.0);
    assert_ne!(up(&harness), DVec3::Y);
    open(&mut harness, "Orbit the camera around at");
    assert_eq!(camera(&harness), opened);
    assert_says(&harness, "0°");
}

#[test]
fn another_scene_is_opened_from_the_start_without_asking() {
    let mut harness = playing("canonical", "Orbit the camera around at");
    press(&mut harness, Key::Period);
    open_scene(&mut harness, "look-at");
    assert!(!says(&harness, "Discard"), "nothing was changed by hand");
    assert!(harness.state().player().is_none());
    let Orientation::At { .. } = camera(&harness).orientation else { panic!("not look-at") };
    assert_ne!(camera(&harness), Camera::CANONICAL);
}

#[test]
fn an_open_animation_at_rest_does_no_work() {
    let mut harness = playing("canonical", "Orbit the camera around at");
    press(&mut harness, Key::Period);
    let traced = harness.state().pictures_traced();
    harness.run_steps(3);
    assert_eq!(harness.state().pictures_traced(), traced);
}

#[test]
fn a_camera_that_cannot_move_says_why() {
    let mut harness = window("canonical");
    type_into(&mut harness, "up z", "1");
    type_into(&mut harness, "up y", "0");
    open(&mut harness, "Roll: up turns around view");
    press(&mut harness, Key::Space);
    harness.run();
    assert!(!harness.state().player().unwrap().running);
    assert!(harness.state().player().unwrap().fault.is_some());
}

#[test]
fn an_animation_goes_on_while_presenting() {
    let mut harness = playing("canonical", "Roll: up turns around view");
    press(&mut harness, Key::F5);
    assert!(harness.state().session().presenting.is_some());
    for _ in 0..6 {
        press(&mut harness, Key::Period);
    }
    assert_eq!(up(&harness), DVec3::NEG_X);
    assert_says(&harness, "90°");
}

#[test]
fn nothing_in_the_strip_lies_over_anything_else() {
    let controls = [
        "what moves",
        "Resume",
        "Step back",
        "Step forward",
        "speed",
        "Loop",
        "Export…",
        "Keep this",
        "Stop and go back",
        "position",
    ];
    for kind in Kind::ALL {
        let mut harness = playing("canonical", kind.label());
        harness.set_size(egui::vec2(1024.0, 768.0));
        harness.run();
        for presents in [false, true] {
            if presents {
                press(&mut harness, Key::F5);
                harness.run_steps(6);
            }
            let thin = ["Resume", "Stop and go back", "position"];
            let controls = if presents { &thin[..] } else { &controls[..] };
            let rect = |name: &&str| harness.get_all_by_label(name).next_back().unwrap().rect();
            let rects: Vec<egui::Rect> = controls.iter().map(rect).collect();
            assert!(!presents || harness.query_by_label("Loop").is_none(), "a thin line");
            for (k, rect) in rects.iter().enumerate() {
                let under = (0..k).find(|other| rects[*other].shrink(1.0).intersects(*rect));
                let under = under.map(|other| controls[other]);
                assert_eq!(under, None, "{kind:?}: {} while presenting: {presents}", controls[k]);
            }
        }
    }
}

#[test]
fn an_orbiting_camera_stays_in_sight_and_stop_brings_the_observer_back() {
    let mut harness = window("look-at");
    let before = harness.state().session().shown.observer;
    open(&mut harness, "Orbit the camera around at");
    assert_ne!(harness.state().session().shown.observer, before, "it steps back");
    for k in 0..24 {
        let eye = harness.query_by_role_and_label(Role::Slider, "eye handle");
        assert!(eye.is_some(), "the eye is out of sight after {k} steps");
        press(&mut harness, Key::Period);
    }
    click(&mut harness, "Stop and go back");
    assert_eq!(harness.state().session().shown.observer, before);

    // Who moves the observer meanwhile has it stay there.
    open(&mut harness, "Orbit the camera around at");
    harness.get_by_role_and_label(Role::Image, "World view").focus();
    harness.run();
    press_with(&mut harness, Modifiers::COMMAND, Key::ArrowRight);
    let moved = harness.state().session().shown.observer;
    click(&mut harness, "Stop and go back");
    assert_eq!(harness.state().session().shown.observer, moved);

    // Who looks at a part of the camera goes on looking at it.
    let mut harness = window("canonical");
    harness.get_by_role_and_label(Role::Image, "World view").focus();
    harness.run();
    for _ in 0..20 {
        press(&mut harness, Key::Plus);
    }
    let near = harness.state().session().shown.observer;
    open(&mut harness, "Orbit the camera around at");
    assert_eq!(harness.state().session().shown.observer, near);
}

/// Who only watches has nothing to save, and is offered nothing at the next start.
#[test]
fn an_animation_that_is_watched_is_no_unsaved_change() {
    let mut harness = playing("canonical", "Orbit the camera around at");
    let before = camera(&harness);
    click(&mut harness, "Step forward");
    assert_ne!(camera(&harness), before);
    assert!(says(&harness, "canonical") && !says(&harness, "canonical*"));
    click(&mut harness, "Keep this");
    assert!(says(&harness, "canonical*"));
}
