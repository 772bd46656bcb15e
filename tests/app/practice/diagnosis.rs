//! What is said of typical wrong answers: each mistake once, and by its name.

use egui::accesskit::Role;
use egui::vec2;
use egui_kittest::kittest::Queryable as _;
use pinhole_lecture::exercises::Exercise;

use super::exercises::{answer, answers, choose, click, drawn, open, said};
use crate::harness::texts_with;

#[test]
fn one_mistake_is_told_once() {
    let mut window = open(Exercise::WarmUpPlane);
    let sign = "Wrong: The sign is wrong: in front of the ray's origin, 𝑡 is positive; behind it, \
                negative.";
    answer(&mut window, "t", "-6");
    click(&mut window, "Check");
    assert_eq!(said(&window, "t"), sign);
    answers(&mut window, "point", &["-1.2", "0.6", "6"]);
    click(&mut window, "Check");
    assert_eq!(said(&window, "t"), sign);
    assert_eq!(said(&window, "point"), "Wrong, for the same reason as 𝑡.");
    choose(&mut window, Exercise::Turned);
    for (part, texts) in [
        ("u", ["1", "0", "-1"]),
        ("v", ["0", "1", "0"]),
        ("w", ["1", "0", "1"]),
        ("d", ["-0.8", "-0.1", "-1.2"]),
    ] {
        answers(&mut window, part, &texts);
    }
    answer(&mut window, "t", "5");
    click(&mut window, "Check");
    assert!(said(&window, "u").starts_with("Wrong: 𝐮 and 𝐰 must be of length 1"));
    for part in ["w", "d", "t"] {
        assert_eq!(said(&window, part), "Wrong, for the same reason as 𝐮.", "{part}");
    }
}

#[test]
fn typical_mistakes_about_pixels_points_and_coefficients_are_named() {
    let mut window = open(Exercise::PixelUv);
    assert_ne!(texts_with(&window, "counted from 1, from the top left"), [""; 0]);
    assert_eq!(drawn(&window), "no answer is drawn");
    answers(&mut window, "uv", &["281.5/400 - 0.5", "0.5 - 241.5/400"]);
    click(&mut window, "Check");
    assert!(said(&window, "uv").starts_with("Wrong: This is the centre of another pixel"));
    answers(&mut window, "uv", &["280/400 - 0.5", "0.5 - 240/400"]);
    click(&mut window, "Check");
    assert!(said(&window, "uv").starts_with("Wrong: This is a corner of the pixel"));
    assert_eq!(drawn(&window), "drawn: your (u, v) (dashed)");
    click(&mut window, "Show the solution");
    assert_ne!(texts_with(&window, "0.20125"), [""; 0]);
    assert_eq!(drawn(&window), "drawn: (u, v), your (u, v) (dashed)");
    choose(&mut window, Exercise::PointAt);
    answers(&mut window, "point", &["1.2", "-0.6", "-6"]);
    click(&mut window, "Check");
    assert!(said(&window, "point").starts_with("Wrong: 𝐩 is left out"));
    assert_eq!(drawn(&window), "drawn: d, your point (dashed)");
    click(&mut window, "Show the solution");
    let line = "𝐩 + 6 𝐝 = (20, 4, 10) + 6 (0.2, −0.1, −1) = (21.2, 3.4, 4)";
    window.run();
    assert_ne!(texts_with(&window, line), [""; 0], "{:?}", texts_with(&window, "21.2"));
    assert_eq!(drawn(&window), "drawn: d, point, your point (dashed)");
    choose(&mut window, Exercise::Coefficients);
    for (part, text) in [("a", "1"), ("b", "-10"), ("c", "24"), ("D", "4")] {
        answer(&mut window, part, text);
    }
    click(&mut window, "Check");
    assert!(said(&window, "b").starts_with("Wrong: 𝑏 has a factor 2 too much"));
    assert_eq!(said(&window, "D"), "Wrong, for the same reason as 𝑏.");
    answer(&mut window, "b", "-5");
    click(&mut window, "Check");
    assert!(said(&window, "D").starts_with("Wrong: This is 4𝐷"), "{}", said(&window, "D"));
    click(&mut window, "Show the solution");
    assert_ne!(texts_with(&window, "𝐷 = "), [""; 0]);
}

/// On a lecturer's screen, an old projector's and a phone's.
#[test]
fn the_fields_of_an_exercise_are_whole_on_every_screen() {
    for size in [[1920.0, 1080.0], [1024.0, 768.0], [390.0, 844.0]] {
        let mut window = open(Exercise::Lines);
        for exercise in [Exercise::PixelUv, Exercise::PointAt, Exercise::Coefficients] {
            window.set_size(vec2(1276.0, 800.0));
            window.run();
            choose(&mut window, exercise);
            window.set_size(vec2(size[0], size[1]));
            window.run();
            let whole = window.ctx.content_rect();
            let fields = window.get_all_by_role(Role::TextInput).map(|field| field.rect());
            let check = window.get_by_role_and_label(Role::Button, "Check").rect();
            let rects: Vec<_> = fields.chain([check]).collect();
            for (k, rect) in rects.iter().enumerate() {
                assert!(whole.contains_rect(*rect), "{exercise:?} at {size:?}: {rect:?}");
                let overlaps = rects[..k].iter().any(|other| other.shrink(1.0).intersects(*rect));
                assert!(!overlaps, "{exercise:?} at {size:?}: {rect:?} in {rects:?}");
            }
            let parts = window.state().session().exercises.question().parts.clone();
            let count: usize = parts.iter().map(|part| part.count()).sum();
            assert!(rects.len() > count, "{exercise:?} at {size:?}");
        }
    }
}
