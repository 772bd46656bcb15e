//! The lab of lines: fields, handles, the slider that generates points, and what is said of two lines.

use egui::accesskit::Role;
use egui::{Key, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::features::lines::state::LinesLab;
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;
use pinhole_core::DVec2;

use super::plot::{answered, labels_in};
use crate::harness::{assert_reads, assert_says, drag_from, says, show, type_into, window};

fn open() -> Harness<'static, App> {
    let mut window = window("canonical");
    show(&mut window, ViewLayout::Lines);
    window
}

fn lab<'a>(window: &'a Harness<'_, App>) -> &'a LinesLab {
    &window.state().session().shown.lines
}

/// Drags a handle by so many points.
fn drag(window: &mut Harness<'_, App>, handle: &str, by: egui::Vec2) {
    let from = window.get_by_role_and_label(Role::Slider, handle).rect().center();
    drag_from(window, from, by);
}

/// Points of the screen in a unit of the plane.
fn scale(window: &Harness<'_, App>) -> f32 {
    let plane = window.get_by_label("Plane with both lines").rect();
    0.5 * plane.size().min_elem() / lab(window).window.half_extent as f32
}

#[test]
fn what_is_typed_is_put_in_with_its_numbers() {
    let mut window = open();
    for (field, text) in [("a", "2"), ("b", "-1"), ("c", "1")] {
        type_into(&mut window, field, text);
    }
    assert_reads(&window, "implicit: f(x, y) = 2 x − y + 1");
    assert_reads(&window, "substituted: f(p + t d)  = 2 t − t + 1");
    assert_reads(&window, "added up: = t + 1");
    assert_reads(&window, "zero where: t = −1");
    assert_reads(&window, "the same as  y = 2 x + 1");
    assert_says(&window, "They meet at t = −1, at (−1, −1). t < 0, behind p: the ray misses.");
    type_into(&mut window, "p x", "-2");
    assert_says(&window, "They meet at t = 3, at (1, 3). t > 0: the ray hits.");
}

#[test]
fn parallel_coincident_and_no_line_are_told_apart() {
    let mut window = open();
    type_into(&mut window, "b", "-1");
    assert_says(&window, "Parallel: f(p + t d) is −2 at every t, never 0. They never meet.");
    type_into(&mut window, "c", "0");
    assert_says(&window, "Coincident: f(p + t d) is 0 at every t. Both are the same line.");
    type_into(&mut window, "d x", "0");
    type_into(&mut window, "d y", "0");
    assert_says(&window, "d is (0, 0): every t gives the one point (0, 0)");
    type_into(&mut window, "a", "0");
    type_into(&mut window, "b", "0");
    assert_says(&window, "a and b are both 0: f is 0 at every point, and no line is left");
}

#[test]
fn every_example_says_what_it_is_called() {
    let mut window = open();
    for (name, said) in [
        ("Ray misses", "They meet at t = −1, at (−1, −1). t < 0, behind p: the ray misses."),
        ("Parallel", "Parallel: f(p + t d) is 2 at every t, never 0. They never meet."),
        ("Coincident", "Coincident: f(p + t d) is 0 at every t. Both are the same line."),
        ("Ray hits", "They meet at t = 1, at (1, 1). t > 0: the ray hits."),
    ] {
        window.get_by_role_and_label(Role::Button, name).click();
        window.run();
        assert_says(&window, said);
    }
}

#[test]
fn no_label_lies_on_an_axis() {
    for step in 1..6 {
        let mut window = answered((11, step), vec2(1024.0, 768.0));
        window.key_press(Key::F5);
        window.run();
        let plane = window.get_by_label("Plane with both lines").rect();
        let center = lab(&window).window.center;
        let from_center = scale(&window) * vec2(-center.x as f32, center.y as f32);
        let origin = plane.center() + from_center;
        for (text, rect) in labels_in(&window, "Plane with both lines") {
            let crosses = rect.x_range().contains(origin.x) || rect.y_range().contains(origin.y);
            assert!(!crosses, "11.{step}: {text}");
        }
    }
}

#[test]
fn handles_follow_the_pointer() {
    let mut window = open();
    let unit = scale(&window);
    drag(&mut window, "move p", egui::vec2(-2.0 * unit, -unit));
    assert!(lab(&window).ray.p.distance(DVec2::new(-2.0, 1.0)) < 0.02, "{:?}", lab(&window).ray);
    assert_eq!(lab(&window).ray.d, DVec2::ONE);
    drag(&mut window, "move the tip of d", egui::vec2(unit, unit));
    assert!(lab(&window).ray.d.distance(DVec2::new(2.0, 0.0)) < 0.03, "{:?}", lab(&window).ray);
    let before = lab(&window).line();
    drag(&mut window, "move the implicit line", egui::vec2(unit, 0.0));
    let after = lab(&window).line();
    assert_eq!((after.a, after.b), (before.a, before.b));
    assert!((after.c - before.c + 1.0).abs() < 0.03, "{after:?}");
    drag(&mut window, "turn the implicit line", egui::vec2(0.0, unit));
    let turned = lab(&window).line();
    assert!((turned.a, turned.b) != (after.a, after.b));
}

#[test]
fn t_generates_points_and_leaves_them_behind() {
    let mut window = open();
    type_into(&mut window, "t", "-1");
    type_into(&mut window, "t", "2");
    let trail = lab(&window).trail;
    assert_eq!((trail.first, trail.last), (-1.0, 2.0));
    assert_reads(&window, "at t = 2:  f = 2 > 0");
    window.get_by_role_and_label(Role::Button, "Clear").click();
    window.run();
    let trail = lab(&window).trail;
    assert_eq!((trail.first, trail.last), (2.0, 2.0));
    let unit = scale(&window);
    drag(&mut window, "slide t", egui::vec2(-unit, unit));
    assert!((lab(&window).t - 1.0).abs() < 0.02, "{}", lab(&window).t);
    assert!(says(&window, "slide t along"));
}

#[test]
fn arrow_keys_move_the_handle_that_has_the_focus() {
    let mut window = open();
    drag(&mut window, "move p", egui::vec2(0.0, 0.0));
    window.get_by_role_and_label(Role::Slider, "move p").focus();
    window.run();
    window.key_press(egui::Key::ArrowRight);
    window.run();
    window.key_press(egui::Key::ArrowUp);
    window.run();
    assert_eq!(lab(&window).ray.p, DVec2::new(0.1, 0.1));
}

#[test]
fn all_points_in_sight_are_drawn_however_far_t_has_gone() {
    let mut window = open();
    let seen = |window: &Harness<'_, App>| {
        let plane = window.get_by_label("Plane with both lines");
        plane.accesskit_node().description().unwrap_or_default()
    };
    assert_eq!(seen(&window), "a point at t = 0.5");
    type_into(&mut window, "t", "-900");
    let to_the_left = seen(&window);
    assert!(to_the_left.ends_with("to t = 0.5"), "{to_the_left}");
    type_into(&mut window, "t", "900");
    let both = seen(&window);
    let end = both.strip_prefix("points from t = −").and_then(|rest| rest.split_once(" to t = "));
    let (from, to) = end.expect("points on both sides of p");
    assert_eq!(from, to, "the window lies evenly about p");
}

#[test]
fn arrow_keys_slide_t_along_every_line() {
    let mut window = open();
    window.get_by_role_and_label(Role::Button, "Coincident").click();
    window.run();
    window.get_by_role_and_label(Role::Slider, "slide t").focus();
    window.run();
    for (key, t) in [
        (egui::Key::ArrowRight, 0.6),
        (egui::Key::ArrowUp, 0.7),
        (egui::Key::ArrowLeft, 0.6),
        (egui::Key::ArrowDown, 0.5),
    ] {
        window.key_press(key);
        window.run();
        assert_eq!(lab(&window).t, t, "{key:?}");
    }
}
