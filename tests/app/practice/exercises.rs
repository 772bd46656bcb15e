//! The exercises: typed answers, what is said of them, seeds, and opening a question's camera.

use egui::accesskit::Role;
use egui::epaint::Shape;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::lessons::{StepId, Which};
use pinhole::model::session::{ThemeName, ViewLayout};
use pinhole::ui::app::App;
use pinhole_lecture::LARGEST_SEED;
use pinhole_lecture::exercises::{Exercise, Given, Question, question};

use crate::harness::{
    assert_reads, assert_says, command, drag_from, open_scene, show, texts_with, type_into, window,
};

pub(super) fn click(window: &mut Harness<'_, App>, label: &str) {
    window.get_by_role_and_label(Role::Button, label).click();
    window.run();
}

pub(crate) fn open(exercise: Exercise) -> Harness<'static, App> {
    let mut window = window("canonical");
    show(&mut window, ViewLayout::Exercises);
    choose(&mut window, exercise);
    window
}

/// Chooses an exercise in the menu.
pub(crate) fn choose(window: &mut Harness<'_, App>, exercise: Exercise) {
    window.get_by_label("exercise").click();
    window.run();
    window.get_all_by_role_and_label(Role::Button, exercise.title()).last().unwrap().click();
    window.run();
    assert_eq!(window.state().session().exercises.question().exercise, exercise);
}

/// Types over what is in an answer's field.
pub(super) fn answer(window: &mut Harness<'_, App>, field: &str, text: &str) {
    let label = format!("answer {field}");
    window.get_by_role_and_label(Role::TextInput, &label).click();
    window.run();
    window.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::A);
    window.get_by_role_and_label(Role::TextInput, &label).type_text(text);
    window.run();
}

/// Types on in the field that has the focus.
fn answer_on(window: &mut Harness<'_, App>, text: &str) {
    window.event(egui::Event::Text(text.to_owned()));
    window.run();
}

pub(crate) fn answers(window: &mut Harness<'_, App>, part: &str, texts: &[&str]) {
    if let [one] = texts {
        return answer(window, part, one);
    }
    let axes = if part == "uv" { ["u", "v", ""] } else { ["x", "y", "z"] };
    for (axis, text) in axes.into_iter().zip(texts) {
        answer(window, &format!("{part} {axis}"), text);
    }
}

/// What is said of a part after *Check*.
#[track_caller]
pub(super) fn said(window: &Harness<'_, App>, part: &str) -> String {
    let start = format!("{part}: ");
    let mut nodes = window.root().children_recursive();
    let value = nodes
        .find_map(|node| node.accesskit_node().value().filter(|value| value.starts_with(&start)));
    value.map(|value| value[start.len()..].to_owned()).unwrap()
}

#[test]
fn the_lectures_exercises_answered_rightly_are_accepted() {
    type Answers = Vec<(&'static str, Vec<&'static str>)>;
    let all: Vec<(Exercise, Answers)> = vec![
        (Exercise::WarmUpRay, vec![("p", vec!["0", "0", "0"]), ("d", vec!["0.2", "-0.1", "-1"])]),
        (Exercise::WarmUpPlane, vec![("t", vec!["6"]), ("point", vec!["1.2", "-0.6", "-6"])]),
        (Exercise::Distance, vec![("d", vec!["1/5", "-1/10", "-2"]), ("t", vec!["3"])]),
        (
            Exercise::Turned,
            vec![
                ("u", vec!["1/sqrt(2)", "0", "-1/sqrt(2)"]),
                ("v", vec!["0", "1", "0"]),
                ("w", vec!["√(2)/2", "0", "√(2)/2"]),
                ("d", vec!["-0.8/sqrt(2)", "-0.1", "-1.2/sqrt(2)"]),
                ("t", vec!["5*sqrt(2)"]),
            ],
        ),
        (
            Exercise::ViewUp,
            vec![
                ("w", vec!["0", "1", "0"]),
                ("u", vec!["0", "0", "1"]),
                ("v", vec!["1", "0", "0"]),
            ],
        ),
        (
            Exercise::EyeAtUp,
            vec![
                ("w", vec!["21/sqrt(682)", "4/sqrt(682)", "15/sqrt(682)"]),
                ("u", vec!["5/sqrt(74)", "0", "-7/sqrt(74)"]),
                ("v", vec!["-28/sqrt(50468)", "222/sqrt(50468)", "-20/sqrt(50468)"]),
            ],
        ),
        (
            Exercise::Sphere,
            vec![
                ("t", vec!["4"]),
                ("point", vec!["0", "0", "-4"]),
                ("normal", vec!["0", "0", "1"]),
            ],
        ),
        (Exercise::Lines, vec![("t", vec!["1"]), ("point", vec!["1", "1"])]),
        (Exercise::PixelUv, vec![("uv", vec!["280.5/400 - 0.5", "0.5 - 240.5/400"])]),
        (Exercise::PointAt, vec![("point", vec!["21.2", "3.4", "4"])]),
        (
            Exercise::Coefficients,
            vec![("a", vec!["1"]), ("b", vec!["-5"]), ("c", vec!["24"]), ("D", vec!["1"])],
        ),
    ];
    for (exercise, parts) in all {
        let mut window = open(exercise);
        for (part, texts) in &parts {
            answers(&mut window, part, texts);
        }
        if exercise == Exercise::Lines {
            window.get_by_role_and_label(Role::RadioButton, "yes").click();
            window.run();
        }
        click(&mut window, "Check");
        for (part, _) in &parts {
            assert_eq!(said(&window, part), "Right.", "{exercise:?}");
        }
        assert_says(&window, "All correct.");
    }
}

#[test]
fn a_scaled_a_backward_a_rounded_and_a_wrong_ray_are_told_apart() {
    let mut window = open(Exercise::WarmUpRay);
    for (texts, verdict) in [
        (["0.4", "-0.2", "-2"], "Right: yours is 2 times ours, the same ray."),
        (["-0.2", "0.1", "1"], "Wrong: it points the opposite way: it is minus ours."),
        (["-0.4", "0.2", "2"], "Wrong: it points the opposite way: it is −2 times ours."),
        (
            ["0.195", "-0.0976", "-0.976"],
            "Right to 3 digits: type at least 4, or give it exactly, as in 1/sqrt(2).",
        ),
        (["0.2", "-0.1", "1"], "Wrong: 𝑧 has the wrong sign: the camera looks along −𝑧."),
        (["-0.1", "0.2", "-1"], "Wrong: 𝑢 and 𝑣 are exchanged: 𝑢 goes to the right, 𝑣 goes up."),
        (
            ["0.2", "-0.3", "-1"],
            "Wrong: 𝑦 should be another number; it passes the viewport at (𝑢, 𝑣) = (0.2, −0.3), not (0.2, −0.1).",
        ),
    ] {
        answers(&mut window, "d", &texts);
        window.key_press(egui::Key::Enter);
        window.run();
        assert_eq!(said(&window, "d"), verdict, "{texts:?}");
        assert_eq!(said(&window, "p"), "Not answered yet.");
    }
}

#[test]
fn classic_mistakes_and_bad_input_are_named() {
    let mut window = open(Exercise::EyeAtUp);
    answers(&mut window, "w", &["-21/sqrt(682)", "-4/sqrt(682)", "-15/sqrt(682)"]);
    answers(&mut window, "u", &["5", "0", "-7"]);
    answers(&mut window, "v", &["0", "1", "zero"]);
    click(&mut window, "Check");
    let wrong_w = "Wrong: at − eye is the view: 𝐰 points the other way, from at to eye.";
    assert_eq!(said(&window, "w"), wrong_w);
    let length = "Wrong: the direction is right, but the length is √74: it must be 1.";
    assert_eq!(said(&window, "u"), length);
    assert!(said(&window, "v").starts_with("“zero” is not a number"), "{}", said(&window, "v"));
    answer(&mut window, "v z", "0");
    click(&mut window, "Check");
    let up_as_v = "Wrong: up is only a hint: 𝐯 = 𝐰 × 𝐮 is perpendicular to 𝐰.";
    assert!(said(&window, "v").starts_with(up_as_v), "{}", said(&window, "v"));
    assert_eq!(texts_with(&window, "All correct"), Vec::<String>::new());
}

#[test]
fn a_wrong_number_is_told_by_what_it_leaves_over() {
    let mut window = open(Exercise::WarmUpPlane);
    for (t, point, of_t, of_point) in [
        (
            "5.5",
            ["1.2", "0", "-6"],
            "Wrong: at this 𝑡, 𝑧 is −5.5, not the wall's −6.",
            "Wrong: 𝑦 should be another number; it is not on the ray, but 0.59714 away from it.",
        ),
        (
            "8",
            ["2.4", "-1.2", "-12"],
            "Wrong: at this 𝑡, 𝑧 is −8, not the wall's −6.",
            "Wrong: its 𝑧 is −12, not the wall's −6.",
        ),
    ] {
        answer(&mut window, "t", t);
        answers(&mut window, "point", &point);
        click(&mut window, "Check");
        assert_eq!((said(&window, "t"), said(&window, "point")), (of_t.into(), of_point.into()));
    }
    choose(&mut window, Exercise::Sphere);
    answer(&mut window, "t", "2.5");
    answers(&mut window, "point", &["3", "4", "-5"]);
    answers(&mut window, "normal", &["0", "0.6", "0.8"]);
    click(&mut window, "Check");
    let t = "Wrong: the point at this 𝑡 is not on the sphere: it is 2.5 from the centre, and the \
             radius is 1.";
    assert_eq!(said(&window, "t"), t);
    let point = "Wrong: it is not on the sphere: it is 5 from the centre, and the radius is 1; it is \
                 not on the ray, but 5 away from it.";
    assert_eq!(said(&window, "point"), point);
    let normal = "Wrong: 𝑦 should be another number; 𝑧 should be another number; it is 36.87° off the \
                  direction from the centre to the hit.";
    assert_eq!(said(&window, "normal"), normal);
}

#[test]
fn a_part_that_is_right_is_not_blamed_for_another() {
    let mut window = open(Exercise::ViewUp);
    let question = "A camera looks along view = (0, −2, 0), with up = (2, 2, 0).";
    // Vectors are not broken at the end of a line.
    assert_reads(
        &window,
        &question.replace(", −2, 0", ",\u{a0}−2,\u{a0}0").replace(", 2, 0", ",\u{a0}2,\u{a0}0"),
    );
    answers(&mut window, "w", &["0", "1", "0"]);
    answers(&mut window, "u", &["0", "0", "-1"]);
    answers(&mut window, "v", &["-1", "0", "0"]);
    click(&mut window, "Check");
    assert_eq!(said(&window, "w"), "Right.");
    let left = "Wrong: 𝐮 = 𝐰 × up points left: the factors are exchanged.";
    let follows = |part| format!("Wrong, for the same reason as {part}.");
    assert_eq!((said(&window, "u"), said(&window, "v")), (left.to_owned(), follows("𝐮")));
    // The same u, but with a w that it follows from.
    answers(&mut window, "w", &["0", "-1", "0"]);
    answers(&mut window, "v", &["1", "0", "0"]);
    click(&mut window, "Check");
    assert_eq!(said(&window, "v"), "Right.");
    assert_eq!(said(&window, "u"), follows("𝐰"));
    assert!(said(&window, "w").starts_with("Wrong: 𝐰 is made from view without the minus"));
    // up × w as it is, which is of length 2 here.
    answers(&mut window, "w", &["0", "1", "0"]);
    answers(&mut window, "u", &["0", "0", "2"]);
    answers(&mut window, "v", &["2", "0", "0"]);
    click(&mut window, "Check");
    let long = "Wrong: 𝐮 = up × 𝐰 is not normalized, and 𝐯 = 𝐰 × 𝐮 with it.";
    assert_eq!((said(&window, "u"), said(&window, "v")), (long.to_owned(), follows("𝐮")));
    // w = view, and what is made of it; with the right w, u is told in itself again.
    answers(&mut window, "w", &["0", "-2", "0"]);
    answers(&mut window, "u", &["0", "0", "-1"]);
    click(&mut window, "Check");
    assert!(said(&window, "w").starts_with("Wrong: 𝐰 is view itself"), "{}", said(&window, "w"));
    let both = (said(&window, "u"), said(&window, "v"));
    assert_eq!(both, (follows("𝐰"), follows("𝐰")));
    answers(&mut window, "w", &["0", "1", "0"]);
    answers(&mut window, "v", &["1", "0", "0"]);
    click(&mut window, "Check");
    let left = "Wrong: 𝐮 points left here: it must point right in the image. Or: Both cross";
    assert!(said(&window, "u").starts_with(left), "{}", said(&window, "u"));
}

#[test]
fn scalars_are_italic_and_a_question_is_read_without_marks() {
    let mut window = open(Exercise::WarmUpRay);
    // A column in which a sentence is one row.
    window.set_size(egui::vec2(1920.0, 1080.0));
    window.run();
    assert_reads(&window, "What is the viewing ray p + t d through (u, v) = (0.2,\u{a0}−0.1)?");
    // No line breaks inside a formula.
    let formulas = ["p + 𝑡 d", "(𝑢, 𝑣) = (0.2, −0.1)?"].map(|text| text.replace(' ', "\u{a0}"));
    let shown = &format!("What is the viewing ray {} through {}", formulas[0], formulas[1]);
    assert_eq!(texts_with(&window, shown), [shown.as_str()]);
    choose(&mut window, Exercise::Lines);
    let formulas = ["𝑥 + 𝑦 − 2 = 0", "(0, 0) + 𝑡 (1, 1)."].map(|text| text.replace(' ', "\u{a0}"));
    let shown = &format!("The line {} and the ray {}", formulas[0], formulas[1]);
    assert_eq!(texts_with(&window, shown), [shown.as_str()]);
    assert_says(&window, "𝑡 =");
    for &exercise in Exercise::LISTED {
        for paragraph in question(&Question::new(exercise, None).given) {
            assert_eq!(paragraph.matches('*').count() % 2, 0, "{paragraph}");
            let words =
                paragraph.replace(|c: char| !c.is_ascii_alphabetic() && !"*'".contains(c), " ");
            let bare = words.split(' ').filter(|word| word.len() == 1 && *word != "a");
            let bare: Vec<_> = bare.filter(|word| !["A", "*"].contains(word)).collect();
            assert_eq!(bare, Vec::<&str>::new(), "a letter without a mark in {paragraph}");
        }
    }
}

#[test]
fn a_pasted_vector_fills_all_fields() {
    let mut window = open(Exercise::WarmUpRay);
    // Letter by letter, the field is left alone until it is left.
    answer(&mut window, "d x", "(0.2, -0.1,");
    answer_on(&mut window, " -1)");
    answer(&mut window, "p x", "0, 0, 0");
    click(&mut window, "Check");
    assert_says(&window, "All correct.");
}

#[test]
fn another_one_like_it_has_a_seed_that_can_be_typed() {
    let mut window = open(Exercise::WarmUpRay);
    click(&mut window, "New numbers");
    assert_eq!(window.state().session().exercises.seed(), Some(1));
    type_into(&mut window, "exercise seed", "42");
    let exercises = &window.state().session().exercises;
    assert_eq!(exercises.seed(), Some(42));
    let Given::Uv(uv) = exercises.question().given else { panic!() };
    let text = format!("{:?}", (uv.x, uv.y)).replace('-', "−").replace(' ', "\u{a0}");
    assert!(!texts_with(&window, &text).is_empty(), "{text}: {:?}", texts_with(&window, "ray"));
    // A seed that not every number field can show is not taken.
    type_into(&mut window, "exercise seed", "9007199254740993");
    assert_eq!(window.state().session().exercises.seed(), Some(LARGEST_SEED));
    click(&mut window, "New numbers");
    assert_eq!(window.state().session().exercises.seed(), Some(0));
    click(&mut window, "Lecture version");
    assert_eq!(window.state().session().exercises.seed(), None);
}

/// What is drawn in the question's scene.
pub(super) fn drawn(window: &Harness<'_, App>) -> String {
    window.get_by_role_and_label(Role::Image, "World view").accesskit_node().description().unwrap()
}

#[test]
fn the_arrow_of_view_has_its_label() {
    for exercise in [Exercise::ViewUp, Exercise::EyeAtUp] {
        let window = open(exercise);
        let painted = window.output().shapes.iter().filter(|clipped| {
            let Shape::Vec(with_halo) = &clipped.shape else { return false };
            matches!(&with_halo[..], [.., Shape::Text(text)] if text.galley.job.text == "view")
        });
        assert_eq!(painted.count(), 1, "{exercise:?}");
    }
}

#[test]
fn the_solution_is_the_derivation_and_is_hidden_again() {
    let mut window = open(Exercise::EyeAtUp);
    let lines = |window: &Harness<'_, App>, of: &str| {
        let lines = texts_with(window, "=").into_iter();
        lines.filter(|line| line.starts_with(of)).collect::<Vec<String>>()
    };
    assert_eq!(lines(&window, "𝐮 = "), [""; 0]);
    click(&mut window, "Show the solution");
    let of_u = lines(&window, "𝐮 = ");
    assert!(of_u.iter().any(|line| line.contains("√74")), "{of_u:?}");
    assert_eq!(lines(&window, "𝐝 = "), [""; 0], "nothing is asked of a ray");
    assert_eq!(drawn(&window), "drawn: u, v, w");
    click(&mut window, "Hide the solution");
    assert_eq!(lines(&window, "𝐮 = "), [""; 0]);
    assert_eq!(drawn(&window), "no answer is drawn");
    choose(&mut window, Exercise::Sphere);
    click(&mut window, "Show the solution");
    assert_eq!(lines(&window, "𝐝 = "), [""; 0], "the ray is given");
    assert_ne!(lines(&window, "normal = "), [""; 0]);
    choose(&mut window, Exercise::Lines);
    click(&mut window, "Show the solution");
    assert!(!texts_with(&window, "They meet at").is_empty());
}

#[test]
fn what_is_typed_is_drawn_and_what_is_right_only_once_it_was_found_or_shown() {
    let mut window = open(Exercise::ViewUp);
    assert_eq!(drawn(&window), "no answer is drawn");
    answers(&mut window, "u", &["0", "0", "-1"]);
    assert_eq!(drawn(&window), "drawn: your u (dashed)");
    answers(&mut window, "w", &["0", "1", "0"]);
    click(&mut window, "Check");
    // What is right needs no mark of theirs, and a wrong answer leaves room for a second try.
    assert_eq!(drawn(&window), "drawn: your u (dashed), w");
    answers(&mut window, "u", &["1", "0", "0"]);
    assert_eq!(drawn(&window), "drawn: your u (dashed), w");
    click(&mut window, "Show the solution");
    assert_eq!(drawn(&window), "drawn: u, your u (dashed), v, w");
    choose(&mut window, Exercise::Distance);
    answers(&mut window, "d", &["0.2", "-0.1", "-1"]);
    answer(&mut window, "t", "6");
    click(&mut window, "Check");
    assert_eq!(drawn(&window), "drawn: your ray (dashed)");
    choose(&mut window, Exercise::Sphere);
    assert_eq!(drawn(&window), "drawn: d", "the ray is given, and where it hits is asked for");
    answer(&mut window, "t", "6");
    answers(&mut window, "point", &["0", "0", "-6"]);
    answers(&mut window, "normal", &["0", "0", "-1"]);
    let typed = "drawn: d, your t (dashed), your hit (dashed), your n (dashed)";
    assert_eq!(drawn(&window), typed);
    click(&mut window, "Check");
    assert_eq!(drawn(&window), typed);
}

#[test]
fn the_questions_scene_can_be_orbited_and_leaves_the_open_one_alone() {
    let mut window = open(Exercise::EyeAtUp);
    let before = window.state().session().shown.observer;
    let rect = window.get_by_role_and_label(Role::Image, "World view").rect();
    let picture = |window: &mut Harness<'_, App>| window.render().unwrap();
    let (first, document) = (picture(&mut window), window.state().document().clone());
    drag_from(&mut window, rect.center(), egui::vec2(90.0, 30.0));
    window.hover_at(egui::pos2(5.0, 5.0));
    window.run();
    assert_ne!(picture(&mut window), first);
    assert_eq!(window.state().session().shown.observer, before);
    assert_eq!(*window.state().document(), document);
}

#[test]
fn typed_answers_are_kept_whatever_is_opened_in_between() {
    let mut window = open(Exercise::EyeAtUp);
    let typed = |window: &Harness<'_, App>| {
        window.get_by_role_and_label(Role::TextInput, "answer u x").value().unwrap_or_default()
    };
    answer(&mut window, "u x", "5/sqrt(74)");
    choose(&mut window, Exercise::Sphere);
    answer(&mut window, "t", "4");
    choose(&mut window, Exercise::EyeAtUp);
    assert_eq!(typed(&window), "5/sqrt(74)");
    // Other numbers are another question.
    click(&mut window, "New numbers");
    assert_eq!(typed(&window), "");
    click(&mut window, "Lecture version");
    assert_eq!(typed(&window), "5/sqrt(74)");
    choose(&mut window, Exercise::Sphere);
    let t = |window: &Harness<'_, App>| {
        window.get_by_role_and_label(Role::TextInput, "answer t").value().unwrap_or_default()
    };
    assert_eq!(t(&window), "4");
    open_scene(&mut window, "look-at");
    show(&mut window, ViewLayout::Exercises);
    assert_eq!(t(&window), "4");
}

#[test]
fn a_question_s_wall_is_grey() {
    let window = open(Exercise::Turned);
    let view = window.state().derived().world_view.clone().unwrap();
    let is_colored = |pixel: &&egui::Color32| {
        let [r, g, b, _] = pixel.to_array();
        r.max(g).max(b) - r.min(g).min(b) > 48
    };
    let colored = view.image.pixels.iter().filter(is_colored).count();
    let share = colored as f64 / view.image.pixels.len() as f64;
    assert!(share < 0.1, "{share} of the view is coloured");
}

#[test]
fn a_verdict_moves_no_button() {
    let mut window = open(Exercise::EyeAtUp);
    let rect =
        |window: &Harness<'_, App>| window.get_by_role_and_label(Role::Button, "Check").rect();
    let before = rect(&window);
    answers(&mut window, "u", &["9", "-4", "1/3"]);
    click(&mut window, "Check");
    assert!(!said(&window, "u").is_empty());
    assert_eq!(rect(&window), before);
    click(&mut window, "Show the solution");
    assert_eq!(rect(&window), before);
}

#[test]
fn a_vectors_fields_stand_side_by_side() {
    let mut window = open(Exercise::EyeAtUp);
    for presenting in [false, true] {
        for width in [1024.0, 1276.0, 1920.0] {
            window.set_size(egui::vec2(width, 800.0));
            window.run();
            let tops = ["x", "y", "z"].map(|axis| {
                let name = format!("answer u {axis}");
                window.get_by_role_and_label(Role::TextInput, &name).rect().top()
            });
            assert!(tops.iter().all(|top| *top == tops[0]), "{width}, {presenting}: {tops:?}");
        }
        window.key_press(egui::Key::F5);
        window.run();
    }
}

#[test]
fn an_answer_field_has_a_frame_that_is_seen() {
    for theme in [ThemeName::Light, ThemeName::Dark] {
        let mut window = open(Exercise::WarmUpRay);
        command(&mut window, theme.label());
        let field = window.get_by_label("answer p x").rect();
        let frame = |shape: &Shape| match shape {
            Shape::Rect(shape) => {
                shape.rect.contains_rect(field.shrink(1.0))
                    && shape.rect.width() < field.width() + 10.0
                    && shape.stroke.width > 0.0
                    && shape.stroke.color.a() > 60
            }
            _ => false,
        };
        let shapes = &window.output().shapes;
        assert!(shapes.iter().any(|clipped| frame(&clipped.shape)), "{theme:?}");
    }
}

#[test]
fn practice_during_a_lesson_shows_its_own_exercise_alone() {
    let mut window = window("canonical");
    let id = StepId { lesson: Which::Builtin(6), step: 1 };
    window.state_mut().open_lesson(id, None);
    window.run();
    window.key_press(egui::Key::End);
    window.run();
    let of_step = |window: &Harness<'_, App>| !texts_with(window, "Backwards").is_empty();
    assert!(of_step(&window));
    show(&mut window, ViewLayout::Exercises);
    assert!(!of_step(&window), "{:?}", texts_with(&window, "Backwards"));
    window.get_by_role_and_label(Role::ComboBox, "exercise");
}
