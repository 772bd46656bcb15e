//! Dragging freely in a step, and R, which brings the step back.

use egui::accesskit::Role;
use egui::{Key, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

use pinhole::model::session::ViewLayout;

use super::{Window, at_step, key, press, shown_step};
use crate::harness::{assert_says, click_at, command, drag_from, says, show, type_into};

#[test]
fn one_key_brings_the_step_back_after_dragging() {
    let mut window = at_step(3, 2);
    let disabled = |window: &Window| {
        let back = window.get_by_role_and_label(Role::Button, "Back to the step");
        back.accesskit_node().is_disabled()
    };
    assert!(disabled(&window), "nothing was changed");
    let before = (window.state().document().clone(), window.state().session().clone());
    type_into(&mut window, "eye x", "0.25");
    assert!(!disabled(&window));
    key(&mut window, Key::R);
    assert_eq!(*window.state().document(), before.0);
    assert!(disabled(&window));
    type_into(&mut window, "uv u", "0.3");
    show(&mut window, ViewLayout::World);
    let rect = window.get_by_role_and_label(Role::Image, "World view").rect();
    let from = rect.min + egui::vec2(60.0, 60.0);
    window.drag_at(from);
    window.run();
    window.hover_at(from + egui::vec2(50.0, 20.0));
    window.run();
    window.drop_at(from + egui::vec2(50.0, 20.0));
    window.run();
    assert_ne!(*window.state().session(), before.1);
    press(&mut window, "Back to the step");
    assert_eq!(*window.state().session(), before.1);
    assert_eq!(shown_step(&window), (3, 2));
    type_into(&mut window, "eye x", "9");
    press(&mut window, "Next");
    assert_eq!(shown_step(&window), (3, 3));
    assert!(!says(&window, "Save the changes to Lesson 3, step 2?"), "a step is no file");
}

#[test]
fn r_puts_back_what_was_dragged_in_the_lines_lab() {
    let mut window = at_step(11, 2);
    let before = window.state().session().shown.lines.clone();
    let handle = window.get_by_label("move p").rect().center();
    drag_from(&mut window, handle, egui::vec2(60.0, 30.0));
    assert_ne!(window.state().session().shown.lines, before);
    key(&mut window, Key::R);
    assert_eq!(window.state().session().shown.lines, before);
}

const KEEP_PICTURE: &str = "Keep the picture: scale distance, width and height together";

#[test]
fn r_puts_back_what_a_step_sets_beside_the_scene() {
    type Change = fn(&mut Window);
    let changes: [(usize, usize, Change); 5] = [
        (12, 1, |window| {
            let graph = window.get_by_label("Plot of f(p + t d)").rect();
            click_at(window, graph.lerp_inside(vec2(0.5, 0.5)));
        }),
        (10, 1, |window| command(window, "Mistake: distance dropped")),
        (3, 3, |window| {
            window.get_by_role_and_label(Role::CheckBox, KEEP_PICTURE).click();
            window.run();
        }),
        (1, 1, |window| {
            window.get_by_label("Experiments").click();
            window.run();
        }),
        (11, 4, |window| {
            let plane = window.get_by_role_and_label(Role::Image, "Plane with both lines").rect();
            drag_from(window, plane.left_top() + vec2(30.0, 30.0), vec2(20.0, 10.0));
        }),
    ];
    for (lesson, step, change) in changes {
        let mut window = at_step(lesson, step);
        let before = window.state().session().clone();
        change(&mut window);
        assert_ne!(*window.state().session(), before, "{lesson}.{step}");
        key(&mut window, Key::R);
        assert_eq!(*window.state().session(), before, "{lesson}.{step}");
    }
}

#[test]
fn what_the_texts_of_the_steps_ask_for_does_what_they_say() {
    // 6.2: one number, and the reason is there.
    let mut window = at_step(6, 2);
    type_into(&mut window, "u x", "1");
    assert!(window.state().derived().fault.is_some());
    // 3.3: locked, the point stays; d is 4 times the warm-up's, so t = 6/4.
    let mut window = at_step(3, 3);
    type_into(&mut window, "distance", "4");
    assert_says(&window, "t = 1.5");
    // 7.5: up (0, 1, -1) is in one plane with w and the old up; (1, 1, -1) is not.
    let mut window = at_step(7, 5);
    type_into(&mut window, "up z", "-1");
    assert_says(&window, "u = (1, 0, 0)");
    type_into(&mut window, "up x", "1");
    assert!(!says(&window, "u = (1, 0, 0)"));
    assert_says(&window, "w = (0, 0.8, 0.6)");
}
