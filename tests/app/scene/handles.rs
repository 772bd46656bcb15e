//! The camera and the scene in the hand: every handle dragged by the mouse or moved by keys, with the
//! numbers that come of it; Escape, snapping, undo; the camera view taken in the hand.

use egui::accesskit::Role;
use egui::{
    Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, Vec2, vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::lessons::{StepId, Which};
use pinhole::model::session::{Preferences, Settings, Setup};
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;
use pinhole_core::{BasisError, Camera, CameraError, DVec3, Selection};
use pinhole_exchange::document::Document;
use pinhole_figure::Fault;
use pinhole_figure::overlay::world_position_of;
use pinhole_figure::overlay_items::Item;

use super::{at_of, camera};
use crate::harness::{
    assert_says, choose_object, command, says, texts_with, type_into, unfolded, window, window_with,
};

fn node_at(harness: &Harness<'_, App>, handle: &str) -> Pos2 {
    harness.get_by_role_and_label(Role::Slider, handle).rect().center()
}

fn document(harness: &Harness<'_, App>) -> Document {
    harness.state().document().clone()
}

/// Takes hold of a handle; where.
fn take(harness: &mut Harness<'_, App>, handle: &str) -> Pos2 {
    let at = node_at(harness, handle);
    press(harness, at);
    at
}

fn press(harness: &mut Harness<'_, App>, at: Pos2) {
    harness.hover_at(at);
    harness.run();
    harness.drag_at(at);
    harness.run();
}

fn pull(harness: &mut Harness<'_, App>, to: Pos2) {
    harness.hover_at(to);
    harness.run();
}

fn drop_it(harness: &mut Harness<'_, App>, at: Pos2) {
    harness.drop_at(at);
    harness.run();
}

/// Drags a handle by so much, and lets go.
fn drag(harness: &mut Harness<'_, App>, handle: &str, by: Vec2) {
    let from = take(harness, handle);
    pull(harness, from + 0.5 * by);
    pull(harness, from + by);
    drop_it(harness, from + by);
}

fn undo(harness: &mut Harness<'_, App>) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run();
}

fn with_modifiers(harness: &mut Harness<'_, App>, modifiers: Modifiers) {
    harness.event(Event::ModifiersChanged(modifiers));
    harness.run();
}

#[track_caller]
fn assert_near(a: Pos2, b: Pos2) {
    assert!(a.distance(b) <= 1.0, "{a:?} is not under the pointer at {b:?}");
}

/// Handles that go wherever they are dragged, in which scene, and what a drag of each is called.
const FREE: [(&str, &str, &str); 10] = [
    ("canonical", "eye handle", "move eye"),
    ("canonical", "at handle", "turn the camera"),
    ("canonical", "up handle", "turn the camera"),
    ("canonical", "sphere 0 “ball”: centre handle", "change spheres"),
    ("canonical", "sphere 0 “ball”: radius handle", "change spheres"),
    ("look-at", "eye handle", "move eye"),
    ("look-at", "at handle", "turn the camera"),
    ("look-at", "up handle", "turn the camera"),
    ("canonical", "viewport, top right corner handle", "change the viewport"),
    ("canonical", "plane 2 “back wall”: point handle", "change planes"),
];

/// Chooses a handle's object in the list, where it has one.
fn choose(harness: &mut Harness<'_, App>, handle: &str) {
    if let Some((object, _)) = handle.split_once(": ") {
        harness.get_by_role_and_label(Role::Button, object).click();
        harness.run();
    }
}

#[test]
fn every_free_handle_stays_under_the_pointer_and_is_undone_in_one_step() {
    for (scene, handle, name) in FREE {
        let settings = Settings {
            preferences: Preferences { keep_pixel_shape: false, ..unfolded().preferences },
            ..unfolded()
        };
        let remembered = Remembered { settings, ..Remembered::default() };
        let mut harness = window_with(scene, remembered, None);
        choose(&mut harness, handle);
        let before = document(&harness);
        let from = take(&mut harness, handle);
        for by in [vec2(3.0, -2.0), vec2(11.0, -7.0), vec2(24.0, -15.0), vec2(19.0, 9.0)] {
            pull(&mut harness, from + by);
            assert_near(node_at(&harness, handle), from + by);
        }
        let after = document(&harness);
        assert_ne!(after, before, "{handle}");
        drop_it(&mut harness, from + vec2(19.0, 9.0));
        assert_eq!(document(&harness), after, "{handle} stays where it was let go");
        harness.get_by_label("Edit").click();
        harness.run();
        assert_says(&harness, &format!("Undo {name} Ctrl+Z"));
        harness.key_press(Key::Escape);
        harness.run();
        undo(&mut harness);
        assert_eq!(document(&harness), before, "{handle}");
    }
}

#[test]
fn there_and_back_is_no_change_and_escape_gives_back() {
    for (scene, handle, _) in FREE {
        let mut harness = window(scene);
        choose(&mut harness, handle);
        let before = document(&harness);
        let from = take(&mut harness, handle);
        pull(&mut harness, from + vec2(17.0, 22.0));
        assert_ne!(document(&harness), before, "{handle}");
        pull(&mut harness, from);
        assert_eq!(document(&harness), before, "{handle}");

        pull(&mut harness, from + vec2(17.0, 22.0));
        harness.key_press(Key::Escape);
        harness.run();
        assert_eq!(document(&harness), before, "{handle}");
        // The button is still down: it drags nothing any more.
        let observer = harness.state().session().shown.observer;
        pull(&mut harness, from + vec2(40.0, 5.0));
        drop_it(&mut harness, from + vec2(40.0, 5.0));
        assert_eq!(document(&harness), before, "{handle}");
        assert_eq!(harness.state().session().shown.observer, observer);
        harness.get_by_label("Edit").click();
        harness.run();
        assert!(says(&harness, "Undo Ctrl+Z"), "{handle}: a drag that was given back is no step");
    }
}

/// The lecture's central failure case, which no hand would hit exactly.
#[test]
fn up_that_is_dragged_onto_the_line_of_view_is_parallel_to_it() {
    for scene in ["canonical", "look-at"] {
        let mut harness = window(scene);
        let to = node_at(&harness, "at handle") + vec2(3.0, 2.0) - node_at(&harness, "up handle");
        drag(&mut harness, "up handle", to);
        let camera = camera(&harness);
        let parallel = BasisError::UpParallelToView { up: camera.up(), view: camera.view() };
        let fault = harness.state().derived().fault;
        assert_eq!(fault, Some(Fault::Camera(CameraError::Basis(parallel))), "{scene}");
        // And it can be dragged away again.
        drag(&mut harness, "up handle", vec2(0.0, -60.0));
        assert_eq!(harness.state().derived().fault, None, "{scene}");
    }
}

#[test]
fn a_moved_eye_orbits_at_or_travels() {
    let mut harness = window("look-at");
    let before = camera(&harness);
    drag(&mut harness, "eye handle", vec2(20.0, 10.0));
    let orbited = camera(&harness);
    assert_eq!(at_of(&orbited), at_of(&before));
    assert_ne!(orbited.eye, before.eye);
    undo(&mut harness);

    harness.get_by_label("Eye orbits at").click();
    harness.run();
    drag(&mut harness, "eye handle", vec2(20.0, 10.0));
    let travelled = camera(&harness);
    assert_eq!(travelled.eye, orbited.eye);
    let apart = (travelled.view() - before.view()).length();
    assert!(apart < 1e-12, "{apart}");
    undo(&mut harness);

    // While it is dragged, Alt is for the other.
    let from = take(&mut harness, "eye handle");
    with_modifiers(&mut harness, Modifiers::ALT);
    pull(&mut harness, from + vec2(20.0, 10.0));
    assert_eq!(camera(&harness), orbited);
    with_modifiers(&mut harness, Modifiers::NONE);
    drop_it(&mut harness, from + vec2(20.0, 10.0));
}

#[test]
fn control_snaps_to_round_numbers() {
    let mut harness = window("look-at");
    let from = take(&mut harness, "eye handle");
    with_modifiers(&mut harness, Modifiers::COMMAND | Modifiers::CTRL);
    pull(&mut harness, from + vec2(31.0, 4.0));
    let eye = camera(&harness).eye;
    assert_eq!((eye * 5.0).fract(), DVec3::ZERO, "{eye} are no multiples of 0.2");
    with_modifiers(&mut harness, Modifiers::NONE);
    drop_it(&mut harness, from + vec2(31.0, 4.0));
}

#[test]
fn corners_keep_the_pixels_shape_and_distance_the_picture_on_wish() {
    let mut harness = window("canonical");
    drag(&mut harness, "viewport, top right corner handle", vec2(18.0, -11.0));
    let viewport = camera(&harness).viewport;
    assert!(viewport.width > 1.0);
    assert_eq!((viewport.width, viewport.distance), (viewport.height, 1.0));
    undo(&mut harness);

    let along = node_at(&harness, "at handle") - node_at(&harness, "eye handle");
    drag(&mut harness, "viewport's distance handle", 0.5 * along);
    let viewport = camera(&harness).viewport;
    assert!(viewport.distance > 1.2, "{viewport:?}");
    assert_eq!((viewport.width, viewport.height), (1.0, 1.0));
    undo(&mut harness);

    let settings =
        Settings { setup: Setup { keep_picture: true, ..Setup::default() }, ..unfolded() };
    let remembered = Remembered { settings, ..Remembered::default() };
    let mut harness = window_with("canonical", remembered, None);
    for handle in ["viewport's distance handle", "viewport, top left corner handle"] {
        let out = node_at(&harness, handle) - node_at(&harness, "eye handle");
        drag(&mut harness, handle, 0.5 * out);
        let viewport = camera(&harness).viewport;
        assert!(viewport.distance > 1.2, "{viewport:?}");
        assert!((viewport.width / viewport.distance - 1.0).abs() < 1e-12);
        assert!((viewport.height / viewport.distance - 1.0).abs() < 1e-12);
        undo(&mut harness);
    }
}

#[test]
fn the_selected_pixel_is_dragged_over_the_viewport_and_changes_no_document() {
    let mut harness = window("canonical");
    let before = document(&harness);
    let handle = "selected pixel handle";
    let from = take(&mut harness, handle);
    let selected = harness.state().session().shown.selection;
    pull(&mut harness, from + vec2(-12.0, -8.0));
    let moved = harness.state().session().shown.selection;
    assert!(matches!(moved, Selection::Pixel(_)) && moved != selected);
    assert_near(node_at(&harness, handle), from + vec2(-12.0, -8.0));
    harness.key_press(Key::Escape);
    harness.run();
    assert_eq!(harness.state().session().shown.selection, selected);
    drop_it(&mut harness, from);
    assert_eq!(document(&harness), before);
}

#[test]
fn an_eye_that_is_put_to_at_shows_the_fault_and_is_led_out_of_it() {
    let mut harness = window("canonical");
    type_into(&mut harness, "eye z", "-5");
    assert_eq!(camera(&harness).eye, DVec3::new(0.0, 0.0, -5.0));
    assert_says(&harness, "eye and at are the same point (0, 0, −5): move one of them");
    let from = take(&mut harness, "eye handle");
    pull(&mut harness, from + vec2(5.0, 5.0));
    assert!(camera(&harness).basis().is_ok());
    drop_it(&mut harness, from + vec2(5.0, 5.0));
}

#[test]
fn a_drag_past_the_pole_turns_v_without_a_jump() {
    let mut harness = window("look-at");
    let at = node_at(&harness, "at handle");
    let from = take(&mut harness, "eye handle");
    let mut v = camera(&harness).basis().unwrap().v;
    // Over what it looks at, from one side to the other, a little at a time.
    let to = at + 2.0 * (at - from).normalized() * 40.0 + vec2(0.0, -90.0);
    for step in 1..=120 {
        pull(&mut harness, from + (to - from) * (step as f32 / 120.0));
        let basis = camera(&harness).basis().unwrap();
        let turn = basis.v.dot(v).clamp(-1.0, 1.0).acos().to_degrees();
        assert!(turn < 35.0, "v jumps by {turn} degrees in step {step}");
        v = basis.v;
    }
    drop_it(&mut harness, to);
}

#[test]
fn a_handle_with_the_focus_is_moved_by_keys() {
    let mut harness = window("canonical");
    harness.get_by_role_and_label(Role::Slider, "eye handle").focus();
    harness.run();
    let selected = harness.state().session().shown.selection;
    harness.key_press(Key::ArrowUp);
    harness.step();
    let eye = camera(&harness).eye;
    assert!(eye.y > 0.0 && eye.x == 0.0 && eye.z == 0.0, "{eye:?}");
    assert_eq!(harness.state().session().shown.selection, selected);
    harness.key_press(Key::ArrowUp);
    harness.step();
    assert_eq!(camera(&harness).eye.y, 2.0 * eye.y);
    let handle = harness.get_by_role_and_label(Role::Slider, "eye handle");
    assert!(handle.accesskit_node().description().unwrap().starts_with("eye = (0, "));
    // More of the same soon after it is the same step.
    undo(&mut harness);
    assert_eq!(camera(&harness).eye, DVec3::ZERO);
}

#[test]
fn every_handle_is_moved_by_keys() {
    let names = [
        "at handle",
        "up handle",
        "viewport, bottom left corner handle",
        "viewport's distance handle",
        "sphere 0 “ball”: centre handle",
        "sphere 0 “ball”: radius handle",
    ];
    for name in names {
        let mut harness = window("canonical");
        choose_object(&mut harness, "sphere 0 “ball”");
        let before = document(&harness);
        harness.get_by_role_and_label(Role::Slider, name).focus();
        harness.run();
        harness.key_press(Key::ArrowRight);
        harness.run();
        assert_ne!(document(&harness), before, "{name}");
        undo(&mut harness);
        assert_eq!(document(&harness), before, "{name}");
    }
}

#[test]
fn handles_that_are_switched_off_are_not_there() {
    let mut settings = Settings::default();
    settings.setup.items.set(pinhole_figure::overlay_items::Item::Handles, false);
    let remembered = Remembered { settings, ..Remembered::default() };
    let at = node_at(&window("canonical"), "eye handle");
    let mut harness = window_with("canonical", remembered, None);
    assert!(harness.query_by_role_and_label(Role::Slider, "eye handle").is_none());
    let (before, observer) = (document(&harness), harness.state().session().shown.observer);
    crate::harness::drag_from(&mut harness, at, vec2(20.0, 20.0));
    assert_eq!(document(&harness), before);
    assert_ne!(harness.state().session().shown.observer, observer);
}

#[test]
fn pointing_at_handles_traces_no_picture() {
    let mut harness = window("canonical");
    let traced = harness.state().pictures_traced();
    for handle in ["eye handle", "up handle", "viewport, top left corner handle"] {
        let at = node_at(&harness, handle);
        harness.hover_at(at);
        harness.run();
        assert!(harness.state().session().live.handles.over.is_some(), "{handle}");
    }
    assert_eq!(harness.state().pictures_traced(), traced);
}

/// Drags in the camera view with a button, from its middle; the camera while it is held.
fn turn(
    harness: &mut Harness<'_, App>,
    button: PointerButton,
    modifiers: Modifiers,
    by: Vec2,
) -> Camera {
    let view = harness.get_by_role_and_label(Role::Image, "Camera view").rect();
    let press = |pos: Pos2, pressed| Event::PointerButton { pos, button, pressed, modifiers };
    let from = view.center();
    harness.hover_at(from);
    harness.run();
    harness.event(press(from, true));
    harness.run();
    harness.hover_at(from + 0.5 * by);
    harness.run();
    harness.hover_at(from + by);
    harness.run();
    let held = camera(harness);
    harness.event(press(from + by, false));
    harness.run();
    held
}

#[test]
fn the_camera_view_looks_round_and_orbits() {
    let mut harness = window("look-at");
    let before = camera(&harness);
    let selected = harness.state().session().shown.selection;
    let looked = turn(&mut harness, PointerButton::Secondary, Modifiers::NONE, vec2(40.0, 10.0));
    assert_eq!((looked.eye, looked.up()), (before.eye, before.up()));
    assert_ne!(at_of(&looked), at_of(&before));
    undo(&mut harness);
    assert_eq!(camera(&harness), before);

    for (button, modifiers) in
        [(PointerButton::Middle, Modifiers::NONE), (PointerButton::Secondary, Modifiers::SHIFT)]
    {
        with_modifiers(&mut harness, modifiers);
        let orbited = turn(&mut harness, button, modifiers, vec2(40.0, 10.0));
        with_modifiers(&mut harness, Modifiers::NONE);
        assert_eq!((at_of(&orbited), orbited.up()), (at_of(&before), before.up()));
        let (old, new) = (before.view().length(), orbited.view().length());
        assert!(orbited.eye != before.eye && (old - new).abs() < 1e-12 * old);
        undo(&mut harness);
        assert_eq!(camera(&harness), before);
    }
    assert_eq!(harness.state().session().shown.selection, selected);
}

#[test]
fn escape_gives_back_the_camera_of_the_camera_view() {
    let mut harness = window("look-at");
    let before = camera(&harness);
    let from = harness.get_by_role_and_label(Role::Image, "Camera view").rect().center();
    let button = PointerButton::Secondary;
    let press = |pos: Pos2, pressed| Event::PointerButton {
        pos,
        button,
        pressed,
        modifiers: Modifiers::NONE,
    };
    harness.hover_at(from);
    harness.run();
    harness.event(press(from, true));
    harness.run();
    harness.hover_at(from + vec2(60.0, 0.0));
    harness.run();
    assert_ne!(camera(&harness), before);
    assert_says(&harness, "look around");
    harness.key_press(Key::Escape);
    harness.run();
    assert_eq!(camera(&harness), before);
    harness.hover_at(from + vec2(90.0, 0.0));
    harness.run();
    harness.event(press(from + vec2(90.0, 0.0), false));
    harness.run();
    assert_eq!(camera(&harness), before);
}

fn wheel(harness: &mut Harness<'_, App>, lines: f32, modifiers: Modifiers) {
    let view = harness.get_by_role_and_label(Role::Image, "Camera view").rect();
    harness.hover_at(view.center());
    harness.run();
    with_modifiers(harness, modifiers);
    let phase = egui::TouchPhase::Move;
    let (unit, source) = (MouseWheelUnit::Line, MouseWheelSource::Wheel);
    let delta = vec2(0.0, lines);
    harness.event(Event::MouseWheel { unit, delta, phase, source, modifiers });
    harness.run_steps(20);
    with_modifiers(harness, Modifiers::NONE);
}

#[test]
fn the_wheel_looks_at_pixels_more_closely_and_changes_no_camera() {
    let mut harness = window("look-at");
    let before = camera(&harness);
    let loupe = |harness: &Harness<'_, App>| {
        let settings = &harness.state().session().settings();
        settings.setup.items.shows(Item::Loupe).then_some(settings.preferences.loupe_pixels)
    };
    assert_eq!(loupe(&harness), None);
    wheel(&mut harness, 1.0, Modifiers::NONE);
    let opened = loupe(&harness).unwrap();
    wheel(&mut harness, 2.0, Modifiers::NONE);
    let closer = loupe(&harness).unwrap();
    assert!(closer < opened, "{closer} of {opened} pixels");
    wheel(&mut harness, 50.0, Modifiers::NONE);
    assert_eq!(loupe(&harness), Some(3));
    wheel(&mut harness, -50.0, Modifiers::NONE);
    assert_eq!(loupe(&harness), None);
    assert_eq!(camera(&harness), before);
}

#[test]
fn ctrl_and_wheel_zoom_in_one_step() {
    let mut harness = window("look-at");
    let before = camera(&harness);
    wheel(&mut harness, 2.0, Modifiers::COMMAND | Modifiers::CTRL);
    let zoomed = camera(&harness);
    assert_eq!((zoomed.eye, zoomed.orientation), (before.eye, before.orientation));
    let (old, new) = (before.viewport, zoomed.viewport);
    assert!(new.width < old.width && new.distance == old.distance);
    assert!((new.width / new.height - old.width / old.height).abs() < 1e-12);
    undo(&mut harness);
    assert_eq!(camera(&harness), before);
}

#[test]
fn looking_up_stops_short_of_the_pole() {
    let mut harness = window("look-at");
    for _ in 0..8 {
        turn(&mut harness, PointerButton::Secondary, Modifiers::NONE, vec2(0.0, 200.0));
        let camera = camera(&harness);
        assert!(camera.basis().is_ok());
        assert!(camera.up_angle().unwrap().angle.to_degrees() > 0.9);
    }
    assert!(camera(&harness).up_angle().unwrap().angle.to_degrees() < 1.1);
}

/// Returns the first point of a grid over the world view at which this handle is shown.
fn pointed_at(harness: &mut Harness<'_, App>, handle: &str) -> Pos2 {
    let view = harness.get_by_role_and_label(Role::Image, "World view").rect();
    let places = (0..20).flat_map(|row| (0..20).map(move |column| (row, column)));
    let mut places = places.map(|(row, column)| {
        view.min + vec2(column as f32 + 0.5, row as f32 + 0.5) / 20.0 * view.size()
    });
    let found = places.find(|at| {
        harness.hover_at(*at);
        harness.step();
        harness.step();
        harness.query_by_role_and_label(Role::Slider, handle).is_some()
    });
    found.expect("the sphere is in the view")
}

const MARBLE: &str = "sphere 1 “marble”: radius handle";

#[test]
fn a_sphere_that_is_pointed_at_has_handles_and_is_chosen_by_them() {
    let mut harness = window("canonical");
    assert!(harness.query_by_role_and_label(Role::Slider, MARBLE).is_none());
    pointed_at(&mut harness, MARBLE);
    harness.run();
    let before = document(&harness).spheres[1].shape;
    drag(&mut harness, MARBLE, vec2(12.0, 0.0));
    let after = document(&harness).spheres[1].shape;
    assert!(after.radius > before.radius && after.center == before.center);
    assert!(harness.query_all_by_value("marble").next().is_some(), "its fields are shown");
}

#[test]
fn a_sphere_is_chosen_by_a_click_on_any_part_of_it() {
    let mut harness = window("look-at");
    let [center, radius] =
        ["centre", "radius"].map(|part| format!("sphere 1 “left”: {part} handle"));
    pointed_at(&mut harness, &radius);
    harness.run();
    let [from, to] = [center, radius].map(|handle| node_at(&harness, &handle));
    let at = from + (from - to).normalized().rot90() * 0.6 * from.distance(to);
    assert!(harness.query_all_by_value("left").next().is_none());
    press(&mut harness, at);
    drop_it(&mut harness, at);
    assert!(harness.query_all_by_value("left").next().is_some(), "its fields are shown");
}

#[test]
fn near_up_the_camera_takes_up_along_unless_up_is_kept() {
    let mut harness = window("canonical");
    type_into(&mut harness, "at y", "200");
    let is_said = |harness: &Harness<'_, App>| says(harness, "up turns with the camera");
    let pulled = |harness: &mut Harness<'_, App>| {
        let from = take(harness, "eye handle");
        pull(harness, from + vec2(30.0, 0.0));
        let (up, said) = (camera(harness).up(), is_said(harness));
        drop_it(harness, from + vec2(30.0, 0.0));
        (up, said)
    };
    let before = document(&harness);
    let (up, said) = pulled(&mut harness);
    assert!(said, "{:?}", texts_with(&harness, "up"));
    assert_ne!(up, before.camera.up());
    assert_eq!(camera(&harness).up(), up);
    undo(&mut harness);
    assert_eq!(document(&harness), before);

    command(&mut harness, "Keep up");
    assert!(harness.state().session().preferences.keep_up);
    let (up, said) = pulled(&mut harness);
    assert!(!said);
    assert_eq!(up, before.camera.up());
    assert_ne!(camera(&harness), before.camera, "the eye has moved");
}

/// Opens step 7.5, drags the tip of up by 60 pixels the way the point `way` from it goes on the screen, and returns the
/// camera before and after.
fn up_dragged(way: impl Fn(&Camera) -> DVec3) -> [Camera; 2] {
    let mut harness = window("canonical");
    let id = StepId { lesson: Which::Builtin(6), step: 4 };
    harness.state_mut().open_lesson(id, None);
    harness.run();
    let before = camera(&harness);
    let by = {
        let frame = harness.state().derived().world_frame.clone().unwrap();
        let at = |point| world_position_of(frame.camera(), point).unwrap();
        let tip = before.eye + before.up();
        let by = at(tip + 0.1 * way(&before)) - at(tip);
        60.0 * by.normalize()
    };
    drag(&mut harness, "up handle", vec2(by.x as f32, by.y as f32));
    [before, camera(&harness)]
}

#[test]
fn up_stays_in_the_plane_with_view_if_its_drag_begins_there() {
    let u = |camera: &Camera| camera.basis().unwrap().u;
    let toward_view = |camera: &Camera| camera.view().normalize();
    for way in [toward_view, |camera: &Camera| -camera.view().normalize(), Camera::up] {
        let [before, after] = up_dragged(way);
        assert_ne!(before.up(), after.up());
        assert_eq!(u(&before), u(&after), "{:?}", after.up());
    }
    let [before, after] = up_dragged(u);
    assert!(u(&before).distance(u(&after)) > 0.05, "{:?}", after.up());
}
