//! The observer: zooming to what is under the pointer, framing by a double click, the gizmo of axes, and the view
//! that a scene keeps.

use std::fs;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, Pos2, TouchPhase, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::ui::app::App;
use pinhole_core::{DVec3, Frame, NO_OBJECT};
use pinhole_exchange::BuiltinScene;
use pinhole_exchange::link::{Link, Linked};

use crate::harness::{assert_says, command, window};

fn world<'a>(harness: &'a Harness<'_, App>) -> &'a Frame<f32> {
    harness.state().derived().world_frame.as_deref().expect("a world view")
}

/// The position on the screen of the middle of what the world view shows of an object, and its number of dots.
fn seen(harness: &Harness<'_, App>, object: u32) -> (Pos2, usize) {
    let frame = world(harness);
    let width = frame.camera().image().width() as usize;
    let dots = (0..frame.object.len()).filter(|k| frame.object[*k] == object);
    let dots: Vec<_> = dots.map(|k| vec2((k % width) as f32, (k / width) as f32)).collect();
    let middle = dots.iter().fold(egui::Vec2::ZERO, |sum, dot| sum + *dot) / dots.len() as f32;
    let view = harness.get_by_role_and_label(Role::Image, "World view").rect();
    (view.min + middle / harness.ctx.pixels_per_point(), dots.len())
}

fn object_at(harness: &Harness<'_, App>, at: Pos2) -> u32 {
    let view = harness.get_by_role_and_label(Role::Image, "World view").rect();
    let dot = (at - view.min) * harness.ctx.pixels_per_point();
    let frame = world(harness);
    frame.object[dot.y as usize * frame.camera().image().width() as usize + dot.x as usize]
}

fn turn_wheel(harness: &mut Harness<'_, App>, at: Pos2, notches: u32, lines: f32) {
    harness.hover_at(at);
    harness.run();
    for _ in 0..notches {
        harness.event(Event::MouseWheel {
            unit: MouseWheelUnit::Line,
            delta: vec2(0.0, lines),
            modifiers: Modifiers::NONE,
            phase: TouchPhase::Move,
            source: MouseWheelSource::Wheel,
        });
        harness.run_ok();
    }
}

#[test]
fn the_wheel_zooms_to_what_is_under_the_pointer_and_back() {
    for (scene, ball) in [("canonical", 0), ("look-at", 1), ("planet", 1)] {
        let mut harness = window(scene);
        let framed = harness.state().session().shown.observer;
        let (at, before) = seen(&harness, ball);
        assert_eq!(object_at(&harness, at), ball);
        turn_wheel(&mut harness, at, 12, 1.0);
        assert_eq!(object_at(&harness, at), ball, "{scene}: it is still under the pointer");
        assert!(seen(&harness, ball).1 > 4 * before, "{scene}: and larger");
        turn_wheel(&mut harness, at, 1, 60.0);
        assert_eq!(object_at(&harness, at), ball, "{scene}: there is a limit");
        turn_wheel(&mut harness, at, 1, -200.0);
        let sees = world(&harness).object.iter().any(|object| *object != NO_OBJECT);
        assert!(sees, "{scene}: and one on the way back");
        harness.key_press(Key::F);
        harness.run();
        assert_eq!(harness.state().session().shown.observer, framed);
    }
}

#[test]
fn where_nothing_is_the_wheel_keeps_the_scene_in_sight_and_an_empty_view_says_how_to_come_back() {
    let mut harness = window("look-at");
    let view = harness.get_by_role_and_label(Role::Image, "World view").rect();
    turn_wheel(&mut harness, view.min + vec2(60.0, 90.0), 6, 1.0);
    let lost =
        "Nothing is in sight: Frame all in the menu View, or a double click, shows everything";
    assert!(harness.query_by_label(lost).is_none());
    harness.get_by_role_and_label(Role::Image, "World view").focus();
    for _ in 0..60 {
        harness.key_press_modifiers(Modifiers::ALT, Key::ArrowRight);
    }
    harness.run();
    harness.get_by_label(lost);
    harness.key_press(Key::F);
    harness.run();
    assert!(harness.query_by_label(lost).is_none());
}

#[test]
fn the_wheel_goes_near_the_ground_that_a_planet_is_and_to_a_tiny_ball() {
    let mut harness = window("planet");
    let view = harness.get_by_role_and_label(Role::Image, "World view").rect();
    let at = view.center_bottom() - vec2(0.0, 60.0);
    assert_eq!(object_at(&harness, at), 0, "the planet");
    let distance =
        |harness: &Harness<'_, App>| harness.state().session().shown.observer.unwrap().distance();
    let before = distance(&harness);
    turn_wheel(&mut harness, at, 6, 1.0);
    assert!(distance(&harness) < 0.7 * before, "{} of {before}", distance(&harness));
    let mut harness = window("tiny-far");
    let before = distance(&harness);
    harness.get_by_role_and_label(Role::Image, "World view").focus();
    for _ in 0..8 {
        harness.key_press(Key::Plus);
    }
    harness.run();
    assert!(distance(&harness) < 0.5 * before);
}

#[test]
fn a_double_click_frames_what_is_there() {
    let mut harness = window("look-at");
    let framed = harness.state().session().shown.observer;
    let (at, _) = seen(&harness, 0);
    let double_click = |harness: &mut Harness<'_, App>, at: Pos2| {
        harness.hover_at(at);
        harness.run();
        for pressed in [true, false, true, false] {
            let (button, modifiers) = (egui::PointerButton::Primary, Modifiers::NONE);
            let event = Event::PointerButton { pos: at, button, pressed, modifiers };
            harness.input_mut().events.push(event);
        }
        harness.run();
    };
    double_click(&mut harness, at);
    let frame = world(&harness);
    let [width, height] = [frame.camera().image().width(), frame.camera().image().height()];
    let rows = (0..height).filter(|row| {
        let row = (row * width) as usize..((row + 1) * width) as usize;
        frame.object[row].contains(&0)
    });
    let rows = rows.count() as u32;
    assert!(rows > height / 2 && rows < height, "{rows} of {height} rows show the sphere");
    let view = harness.get_by_role_and_label(Role::Image, "World view").rect();
    let empty = view.left_bottom() + vec2(30.0, -60.0);
    assert_eq!(object_at(&harness, empty), NO_OBJECT);
    double_click(&mut harness, empty);
    assert_eq!(harness.state().session().shown.observer, framed, "beside it, everything is framed");
}

#[test]
fn the_gizmo_and_its_keys_look_along_the_axes() {
    let mut harness = window("canonical");
    let names =
        ["Look along x, from the side", "Look along y, from above", "Look along z, from the front"];
    for (name, (axis, key)) in
        names.into_iter().zip(DVec3::AXES.into_iter().zip([Key::X, Key::Y, Key::Z]))
    {
        let looks =
            |harness: &Harness<'_, App>| world(harness).camera().basis().w.dot(axis) > 0.999;
        harness.get_by_role_and_label(Role::Button, name).click();
        harness.run();
        assert!(looks(&harness), "{name}");
        harness.key_press(Key::F);
        harness.run();
        assert!(!looks(&harness));
        harness.key_press(key);
        harness.run();
        assert!(looks(&harness), "{name}, by its key");
        harness.key_press(key);
        harness.run();
        assert!(
            world(&harness).camera().basis().w.dot(axis) < -0.999,
            "again, from the other side"
        );
        harness.get_by_role_and_label(Role::Button, name).click();
        harness.run();
        assert!(looks(&harness), "{name}, once more");
    }
}

#[test]
fn a_scene_opens_with_the_view_that_was_kept_in_it_and_looking_around_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    let plain = BuiltinScene::find("look-at").unwrap().text;
    fs::write(&path, plain).unwrap();
    let mut harness = window(&path);
    let (at, _) = seen(&harness, 1);
    turn_wheel(&mut harness, at, 7, 1.0);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::S);
    harness.run();
    assert_says(&harness, "mine.toml");
    assert_eq!(fs::read_to_string(&path).unwrap(), plain, "looking around changes no file");
    command(&mut harness, "Views: Keep this view");
    assert_says(&harness, "mine.toml*");
    assert_says(&harness, "The scene opens with this view once it is saved");
    let kept = *world(&harness).camera();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::S);
    harness.run();
    let text = fs::read_to_string(&path).unwrap();
    let table: Vec<&str> = text.lines().filter(|line| !plain.contains(line)).collect();
    assert_eq!(table.len(), 5, "{table:?}");
    assert_eq!(table[0], "[observer]");
    let reopened = window(&path);
    let again = *world(&reopened).camera();
    let size = again.eye().distance(harness.state().document().camera.eye);
    assert!(again.eye().abs_diff_eq(kept.eye(), 1e-4 * size), "{} {}", again.eye(), kept.eye());
    assert!(again.basis().w.abs_diff_eq(kept.basis().w, 1e-4));
    let link = Link { shown: Linked::scene(reopened.state().document()), ray: None, page: None };
    let mut linked = window("canonical");
    linked.state_mut().follow_link(format!("#{}", link.to_fragment().unwrap()));
    linked.run();
    assert_eq!(*world(&linked).camera(), again, "a link keeps it");
    // Moving again changes nothing.
    turn_wheel(&mut harness, at, 1, -3.0);
    assert_says(&harness, "mine.toml");
    // Keeping it does, and can be undone.
    command(&mut harness, "Views: Keep this view");
    assert_says(&harness, "mine.toml*");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run();
    assert_says(&harness, "mine.toml");
}
