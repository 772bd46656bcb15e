//! A scene too heavy for a frame under the hand: coarser while it moves, said so, and fine at rest.
//! Every scene is made too heavy here by leaving no time at all for it.

use std::sync::Arc;
use std::time::Duration;

use egui::accesskit::Role;
use egui::{ColorImage, Event, Key, Modifiers, PointerButton, Pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::ui::app::App;
use pinhole::view::adaptive_resolution::Subsampling;
use pinhole_core::{DVec3, Orientation};

use crate::harness::{says, window};

const TOLD: &str = "coarser while it moves: one in 8 rows and columns";

const COARSE: [Subsampling; 2] = [Subsampling::MOST, Subsampling::NONE];

/// A window on the lecture's scene in which nothing is traced fast enough.
fn heavy() -> Harness<'static, App> {
    let mut window = window("canonical");
    window.state_mut().follow_within(Duration::ZERO);
    // What was traced before is known to be heavy once something is traced again.
    look_at(&mut window, DVec3::new(0.1, 0.0, -1.0));
    window
}

fn look_at(window: &mut Harness<'_, App>, at: DVec3) {
    let middle = middle_of(window, "Camera view");
    press(window, middle, PointerButton::Secondary, true);
    window.event(Event::PointerMoved(middle + vec2((100.0 * at.x) as f32, 0.0)));
    window.run();
    press(window, middle, PointerButton::Secondary, false);
    window.run();
}

fn middle_of(window: &Harness<'_, App>, view: &str) -> Pos2 {
    window.get_by_role_and_label(Role::Image, view).rect().center()
}

fn press(window: &mut Harness<'_, App>, pos: Pos2, button: PointerButton, pressed: bool) {
    window.event(Event::PointerMoved(pos));
    window.event(Event::PointerButton { pos, button, pressed, modifiers: Modifiers::NONE });
    window.step();
}

fn coarseness(window: &Harness<'_, App>) -> [Subsampling; 2] {
    window.state().derived().subsampling
}

/// What the camera view shows.
fn image(window: &Harness<'_, App>) -> Option<Arc<ColorImage>> {
    window.state().derived().camera_view.clone().map(|view| view.image)
}

#[test]
fn under_the_hand_the_picture_is_coarse_and_at_rest_it_is_fine() {
    // The same is done in a window that has all the time it needs.
    let (mut window, mut patient) = (heavy(), heavy());
    patient.state_mut().follow_within(Duration::MAX);
    let from = middle_of(&window, "Camera view");
    let mut both = |what: &dyn Fn(&mut Harness<'_, App>)| {
        what(&mut window);
        what(&mut patient);
        assert_eq!(coarseness(&patient), [Subsampling::NONE; 2]);
        let told = says(&window, TOLD);
        assert_eq!(told, coarseness(&window) != [Subsampling::NONE; 2]);
        (coarseness(&window), image(&window) == image(&patient))
    };
    let moved_to = |x: f32| {
        move |window: &mut Harness<'_, App>| {
            window.event(Event::PointerMoved(from + vec2(x, 10.0)));
            window.step();
        }
    };
    both(&|window| press(window, from, PointerButton::Secondary, true));
    assert_eq!(both(&moved_to(30.0)), (COARSE, false));
    let rest = |window: &mut Harness<'_, App>| {
        window.run();
    };
    // The hand rests, the button still held.
    assert_eq!(both(&rest), ([Subsampling::NONE; 2], true));
    assert_eq!(both(&moved_to(60.0)), (COARSE, false));
    let let_go = |window: &mut Harness<'_, App>| {
        press(window, from + vec2(60.0, 10.0), PointerButton::Secondary, false);
        window.run();
    };
    assert_eq!(both(&let_go), ([Subsampling::NONE; 2], true));
}

#[test]
fn the_observer_in_the_hand_makes_the_world_view_coarse_alone() {
    let (mut window, mut patient) = (heavy(), heavy());
    patient.state_mut().follow_within(Duration::MAX);
    // Beside every object, of which the pointer would show handles.
    let from = window.get_by_role_and_label(Role::Image, "World view").rect().left_bottom();
    let from = from + vec2(12.0, -12.0);
    for window in [&mut window, &mut patient] {
        press(window, from, PointerButton::Primary, true);
        for x in [40.0, 60.0] {
            window.event(Event::PointerMoved(from + vec2(x, 0.0)));
            window.step();
        }
    }
    assert_eq!(coarseness(&window), [Subsampling::NONE, Subsampling::MOST]);
    assert!(says(&window, TOLD));
    for window in [&mut window, &mut patient] {
        press(window, from + vec2(60.0, 0.0), PointerButton::Primary, false);
        window.run();
    }
    assert_eq!(coarseness(&window), [Subsampling::NONE; 2]);
    let image =
        |w: &Harness<'_, App>| w.state().derived().world_view.clone().map(|view| view.image);
    assert!(image(&window) == image(&patient), "the world view stays coarse");
}

#[test]
fn an_animation_that_stands_still_is_fine() {
    let mut window = heavy();
    window.get_by_role_and_label(Role::Button, "Play").click();
    window.run();
    window.get_by_label("Orbit the camera around at").click();
    window.run();
    assert_eq!(coarseness(&window), [Subsampling::NONE; 2]);
    let before = window.state().document().camera;
    window.key_press(Key::Period);
    window.run();
    assert_ne!(window.state().document().camera, before);
    assert_eq!(coarseness(&window), [Subsampling::NONE; 2]);
}

#[test]
fn a_fine_picture_stays_while_the_hand_moves_something_else() {
    let mut window = heavy();
    let traced = window.state().pictures_traced();
    let from = middle_of(&window, "Camera view");
    press(&mut window, from, PointerButton::Primary, true);
    window.event(Event::PointerMoved(from + vec2(30.0, 10.0)));
    window.step();
    assert_eq!(coarseness(&window), [Subsampling::NONE; 2]);
    assert_eq!(window.state().pictures_traced(), traced);
}

/// Ctrl, Shift and = make +; where Shift is let go first, it is = that is let go.
#[test]
fn a_key_that_changes_its_name_while_it_is_held_leaves_nothing_coarse() {
    let mut window = heavy();
    let key = |key, pressed, modifiers| Event::Key {
        key,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers,
    };
    window.event(key(Key::Plus, true, Modifiers::COMMAND | Modifiers::SHIFT));
    window.step();
    window.event(key(Key::Equals, false, Modifiers::COMMAND));
    window.run();
    look_at(&mut window, DVec3::new(0.3, 0.0, -1.0));
    assert_eq!(coarseness(&window), [Subsampling::NONE; 2]);
}

#[test]
fn an_edit_that_is_no_drag_is_fine_at_once() {
    let mut window = heavy();
    crate::harness::type_into(&mut window, "eye z", "0.5");
    window.step();
    assert_eq!(coarseness(&window), [Subsampling::NONE; 2]);
    match window.state().document().camera.orientation {
        Orientation::At { .. } => assert_eq!(window.state().document().camera.eye.z, 0.5),
        _ => panic!("given by at"),
    }
}
