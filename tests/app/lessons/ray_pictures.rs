//! The pictures of the lessons on lines, on the ray and a sphere, and on many rays: what is drawn and named
//! before and after the answer.

use egui::Key;
use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::lessons::{StepId, Which, builtin};
use pinhole_core::{DVec3, SphereQuadratic};
use pinhole_lecture::ObjectDerivation;

use super::{Window, at_step, key};
use crate::app::painted_texts::texts;
use crate::harness::{texts_with, window};

/// A window on a lesson's step, both counted from 1, with its question open.
fn asked(lesson: usize, step: usize) -> Window {
    let mut window = window("canonical");
    let id = StepId { lesson: Which::Builtin(lesson - 1), step: step - 1 };
    window.state_mut().open_lesson(id, None);
    window.run();
    window
}

/// The labels in the world view.
fn labels(window: &Window) -> Vec<String> {
    let view = window.state().derived().world_view.clone().unwrap();
    view.labels.iter().map(|label| label.text.clone()).collect()
}

#[test]
fn the_ray_that_misses_the_ball_is_seen_beside_it() {
    let window = at_step(12, 6);
    let derived = window.state().derived();
    let observer = derived.world_frame.clone().unwrap().camera().eye();
    let ray = derived.inspection.clone().unwrap().ray;
    let center = DVec3::new(0.0, 0.0, -5.0);
    for k in 0..=70 {
        let sight = (ray.at(0.1 * f64::from(k)) - observer).normalize();
        let distance = sight.cross(center - observer).length();
        assert!(distance > 1.02, "t = 0.{k}: {distance}");
    }
    let labels = labels(&window);
    for text in ["r = 1", "distance ≈ 1.091 > r", "foot: t = −b/a ≈ 4.762"] {
        assert!(labels.iter().any(|label| label == text), "{text}: {labels:?}");
    }
}

#[test]
fn the_given_ray_is_there_before_the_answer_and_no_t_of_it() {
    for (lesson, step) in [(12, 1), (12, 3), (12, 6), (12, 7), (12, 8), (13, 1), (13, 2)] {
        let mut window = asked(lesson, step);
        let before = labels(&window);
        assert!(before.iter().any(|text| text == "d"), "{lesson}.{step}: {before:?}");
        assert!(!before.iter().any(|text| text.contains('=')), "{lesson}.{step}: {before:?}");
        key(&mut window, Key::PageDown);
        assert!(labels(&window).iter().any(|text| text.contains('=')), "{lesson}.{step}");
    }
}

#[test]
fn the_discriminant_is_not_named_before_it_is_introduced() {
    let named = |step| labels(&at_step(12, step)).iter().any(|text| text.contains("D/a"));
    assert_eq!([2, 3, 4, 5].map(named), [false, false, true, true]);
}

#[test]
fn the_wrong_hit_behind_the_eye_is_marked_and_each_root_says_whose_it_is() {
    let window = at_step(13, 2);
    assert!(labels(&window).contains(&"−6".to_owned()), "{:?}", labels(&window));
    for text in ["; near ball", "; rear ball"] {
        assert!(!texts_with(&window, text).is_empty(), "{text}");
    }
}

#[test]
fn each_line_is_shown_alone_before_one_is_put_into_the_other() {
    let points = |window: &Window| {
        let plane = window.get_by_role_and_label(Role::Image, "Plane with both lines");
        plane.accesskit_node().description()
    };
    let implicit = asked(11, 1);
    assert!(!texts_with(&implicit, "f(x, y) = a x + b y + c = 2 x + y − 2").is_empty());
    assert_eq!(points(&implicit), None);
    let parametric = asked(11, 2);
    assert!(!texts_with(&parametric, "x = px + t dx = −1 + t").is_empty());
    assert_eq!(points(&parametric).as_deref(), Some("points from t = −1 to t = 3"));
    for window in [implicit, parametric] {
        for text in ["substituted", "They meet"] {
            assert!(texts_with(&window, text).is_empty(), "{text}");
        }
    }
}

#[test]
fn the_graphs_title_is_the_equation_whose_left_side_is_drawn() {
    for (step, title) in [(1, "𝐧 · (𝐩 + 𝑡 𝐝 − point)"), (5, "|𝐩 + 𝑡 𝐝 − centre|² − 𝑟²")]
    {
        let window = at_step(12, step);
        let is_there = texts(&window).iter().any(|run| run.text == title);
        assert!(is_there, "12.{step}");
    }
}

#[test]
fn both_axes_of_the_plane_have_their_names_in_every_step() {
    for step in 1..=6 {
        let window = at_step(11, step);
        for name in ["𝑥", "𝑦"] {
            assert!(texts(&window).iter().any(|run| run.text == name), "11.{step}: {name}");
        }
    }
}

/// The value at t of the function on the card.
fn value_on_card(derivation: &ObjectDerivation, [p, d]: [DVec3; 2], t: f64) -> f64 {
    match derivation {
        ObjectDerivation::Sphere(ball) => {
            let SphereQuadratic { a, b, c, .. } = ball.quadratic;
            a * t * t + 2.0 * b * t + c
        }
        ObjectDerivation::Plane(wall) => wall.plane.normal.dot(p + t * d - wall.plane.point),
    }
}

#[test]
fn a_single_curve_is_the_function_on_the_card_at_20_values_of_t() {
    let mut count = 0;
    for step in 1..=builtin::all()[11].steps.len() {
        let window = at_step(12, step);
        let derived = window.state().derived();
        let Some(plot) = &derived.plot else { continue };
        let (Some(unit), [curve]) = (plot.unit(), &plot.curves[..]) else { continue };
        let ray = derived.inspection.as_deref().unwrap().ray;
        let samples = curve.samples.iter().step_by(curve.samples.len() / 20).take(20);
        for (t, height) in samples {
            let wanted = value_on_card(&curve.derivation, [ray.origin, ray.direction], *t);
            let drawn = height * unit;
            let near = (drawn - wanted).abs() <= 1e-9 * wanted.abs().max(1.0);
            assert!(near, "12.{step}: {drawn} is not {wanted} at {t}");
            count += 1;
        }
    }
    assert!(count >= 100, "{count}");
}

#[test]
fn one_line_is_put_into_the_other_line_by_line_and_where_they_meet_comes_last() {
    let mut window = window("canonical");
    key(&mut window, Key::F5);
    let id = StepId { lesson: Which::Builtin(10), step: 2 };
    window.state_mut().open_lesson(id, None);
    window.run();
    let lines = ["substituted", "added up", "zero where"];
    let shown = |window: &Window| {
        let card = lines.map(|line| !texts_with(window, line).is_empty());
        let meets = texts(window).iter().any(|run| run.text.starts_with("ray hits"));
        (card.into_iter().filter(|is_there| *is_there).count(), meets)
    };
    assert_eq!(shown(&window), (0, false));
    for wanted in [(1, false), (2, false), (3, true)] {
        key(&mut window, Key::PageDown);
        assert_eq!(shown(&window), wanted);
    }
    key(&mut window, Key::PageDown);
    assert_eq!(window.state().lesson().unwrap().id().step, 3);
}
