//! The derivation: its lines, and pointing from it to the views and back.

use std::sync::Arc;

use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::lessons::LessonArgument;
use pinhole::model::session::{Settings, Setup, ViewLayout};
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;
use pinhole_figure::concept::{Concept, HoverSource, Hovered};
use pinhole_figure::overlay::Shape;

use super::harness::{assert_says, says, texts_with, type_into, unfolded, window_with};

fn derivation_window(scene: &str) -> Harness<'static, App> {
    let settings = Settings {
        setup: Setup { layout: ViewLayout::Derivation, ..Setup::default() },
        ..unfolded()
    };
    window_with(scene, Remembered { settings, ..Remembered::default() }, None)
}

fn pointed(window: &Harness<'_, App>) -> Option<Hovered> {
    window.state().session().live.hovered
}

/// Moves the mouse to where nothing can be pointed at.
fn point_at_nothing(window: &mut Harness<'_, App>) {
    window.remove_cursor();
    window.run();
    assert_eq!(pointed(window), None);
}

/// Moves the mouse to a mark in a view.
fn hover_mark(window: &mut Harness<'_, App>, view: &str, concept: Concept) {
    let derived = window.state().derived();
    let shown = if view == "World view" { &derived.world_view } else { &derived.camera_view };
    let marks = &shown.as_ref().unwrap().marks;
    let mark = marks.iter().rfind(|mark| mark.concept == Some(concept)).unwrap().clone();
    let [x, y] = match mark.shape {
        Shape::Line { points, .. } | Shape::Polygon { points } => {
            let [a, b] = [points[0], points[1]];
            [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
        }
        Shape::Disc { center, .. } => center,
    };
    let at = window.get_by_role_and_label(Role::Image, view).rect().min + egui::vec2(x, y);
    window.hover_at(at);
    window.run();
}

#[test]
fn every_line_can_be_read() {
    let window = derivation_window("canonical");
    for line in [
        "eye = (0, 0, 0)",
        "view = at − eye = (0, 0, −5) − (0, 0, 0) = (0, 0, −5)",
        "−view = (0, 0, 5)",
        "𝐰 = normalize(−view) = (0, 0, 5)/5 = (0, 0, 1)",
        "up × 𝐰 = (0, 1, 0) × (0, 0, 1) = (1, 0, 0)",
        "𝐯 = 𝐰 × 𝐮 = (0, 0, 1) × (1, 0, 0) = (0, 1, 0)",
        "(u, v) = (0.2, −0.1); the corner of four pixels, no pixel's centre",
        "𝐝 = u 𝐮 + v 𝐯 − distance 𝐰 = (0.2, 0, 0) + (0, −0.1, 0) + (0, 0, −1) = (0.2, −0.1, −1)",
    ] {
        assert_says(&window, line);
    }
}

#[test]
fn a_line_that_is_pointed_at_lights_its_thing_in_both_views() {
    let mut window = derivation_window("canonical");
    let before = window.state().document().clone();
    let pictures = |window: &Harness<'_, App>| {
        let derived = window.state().derived();
        [&derived.world_view, &derived.camera_view].map(|shown| shown.clone().unwrap())
    };
    let unlit = pictures(&window);
    let traced = window.state().pictures_traced();
    window.get_by_label("up × 𝐰 = (0, 1, 0) × (0, 0, 1) = (1, 0, 0)").hover();
    window.run();
    assert_eq!(
        pointed(&window),
        Some(Hovered { concept: Concept::UpCrossW, by: HoverSource::Derivation })
    );
    let lit = pictures(&window);
    for (lit, unlit) in lit.iter().zip(&unlit) {
        assert_ne!(lit.image, unlit.image);
        assert!(lit.marks.iter().any(|mark| mark.concept == Some(Concept::UpCrossW)));
    }
    let labels: Vec<&str> = lit[0].labels.iter().map(|label| label.text.as_str()).collect();
    assert!(labels.contains(&"|up × w| = 1 = sin(90°)"), "{labels:?}");
    point_at_nothing(&mut window);
    for (now, unlit) in pictures(&window).iter().zip(&unlit) {
        assert_eq!(now.image, unlit.image);
    }
    assert_eq!(window.state().pictures_traced(), traced, "pointing traces nothing");
    assert_eq!(*window.state().document(), before);
}

#[test]
fn a_line_that_has_the_focus_lights_its_thing() {
    let mut window = derivation_window("canonical");
    window.get_by_label("−view = (0, 0, 5)").focus();
    window.run();
    assert_eq!(pointed(&window).map(|pointed| pointed.concept), Some(Concept::Backwards));
}

#[test]
fn a_mark_that_is_pointed_at_lights_its_line_and_is_named() {
    let mut window = derivation_window("canonical");
    for (view, concept, line, words) in [
        (
            "World view",
            Concept::W,
            "𝐰 = normalize",
            "𝐰: backwards, the opposite of the view direction, of length 1",
        ),
        ("World view", Concept::V, "𝐯 = 𝐰 × 𝐮", "𝐯: up in the image, of length 1"),
        ("World view", Concept::Eye, "eye = ", "eye: where every view ray begins"),
    ] {
        hover_mark(&mut window, view, concept);
        assert_eq!(pointed(&window), Some(Hovered { concept, by: HoverSource::View }), "{view}");
        assert!(says(&window, words), "{:?}", texts_with(&window, words));
        let highlighted: Vec<String> = window
            .root()
            .children_recursive()
            .map(|node| node.accesskit_node())
            .filter(|node| node.description().as_deref() == Some("highlighted"))
            .filter_map(|node| node.value())
            .collect();
        assert!(highlighted.iter().any(|text| text.starts_with(line)), "{view}: {highlighted:?}");
        point_at_nothing(&mut window);
    }
}

#[test]
fn the_line_of_what_is_pointed_at_is_scrolled_into_view() {
    let mut window = derivation_window("canonical");
    window.set_size(egui::vec2(1280.0, 560.0));
    window.run();
    let seen = |window: &Harness<'_, App>| {
        let line = window.get_by(|node| {
            node.value().is_some_and(|text| text.starts_with("t = (𝐧 · (point − 𝐩))/"))
        });
        line.rect().max.y < 560.0
    };
    assert!(!seen(&window));
    let hit = Concept::Root { object: 2, number: 0 };
    hover_mark(&mut window, "World view", hit);
    assert_eq!(pointed(&window).map(|pointed| pointed.concept), Some(hit));
    assert!(seen(&window));
}

#[test]
fn only_the_point_of_the_first_hit_is_named_hit() {
    let mut window = derivation_window("canonical");
    type_into(&mut window, "distance", "2");
    let hits = texts_with(&window, "hit = 𝐩 + ");
    assert!(matches!(&hits[..], [hit] if hit.contains("t₁")), "{hits:?}");
    assert_says(&window, "𝐩 + t 𝐝 = (0, 0, 0) + 3 (0.2, −0.1, −2) = (0.6, −0.3, −6)");
}

#[test]
fn a_number_that_changes_changes_the_derivation_in_the_same_frame() {
    let mut window = derivation_window("canonical");
    window.get_by_role_and_label(Role::SpinButton, "distance").click();
    window.run();
    window.get_by_role_and_label(Role::SpinButton, "distance").type_text("2");
    window.run();
    window.key_press(egui::Key::Enter);
    window.step();
    assert_eq!(window.state().document().camera.viewport.distance, 2.0);
    assert_says(&window, "−distance 𝐰 = −2 (0, 0, 1) = (0, 0, −2)");
}

#[test]
fn the_derivation_goes_up_to_the_line_that_fails() {
    let mut window = derivation_window("canonical");
    type_into(&mut window, "at z", "0");
    let reason = "eye and at are the same point (0, 0, 0): move one of them";
    assert_says(&window, "view = at − eye = (0, 0, 0) − (0, 0, 0) = (0, 0, 0)");
    assert_says(&window, &format!("𝐰 = normalize(−view); {reason}"));
    assert!(texts_with(&window, "up × 𝐰").is_empty());
    type_into(&mut window, "at y", "1");
    assert_says(&window, "up × 𝐰 = (0, 1, 0) × (0, −1, 0) = (0, 0, 0)");
    let line = window.get_by_label("up × 𝐰 = (0, 1, 0) × (0, −1, 0) = (0, 0, 0)");
    line.hover();
    window.run();
    assert_eq!(pointed(&window).map(|pointed| pointed.concept), Some(Concept::UpCrossW));
}

#[test]
fn sections_are_left_out() {
    let mut window = derivation_window("canonical");
    window.get_by_label("Derivation: Basis").click();
    window.run();
    assert!(!says(&window, "−view = (0, 0, 5)"));
    window.get_by_label("Derivation: Basis").click();
    window.run();
    assert_says(&window, "−view = (0, 0, 5)");
    window.get_by_label("Derivation: Objects").click();
    window.run();
    assert!(texts_with(&window, "D = b²").is_empty());
    window.get_by_label("Copy the derivation").click();
    window.step();
    let copied =
        window.output().platform_output.commands.iter().find_map(|command| match command {
            egui::OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        });
    let copied = copied.unwrap();
    assert!(copied.starts_with("Basis\n  eye = (0, 0, 0)\n"), "{copied}");
    assert!(!copied.contains("D = b²"));
}

/// Returns the names of the derivation's fields, from top to bottom.
fn fields(window: &Harness<'_, App>) -> Vec<String> {
    let all = window.query_all_by_role(Role::SpinButton);
    let names = all.filter_map(|node| node.accesskit_node().label());
    names.filter_map(|name| Some(name.strip_prefix("derivation ")?.to_owned())).collect()
}

fn field_rect(window: &Harness<'_, App>, name: &str) -> egui::Rect {
    window.get_by_role_and_label(Role::SpinButton, &format!("derivation {name}")).rect()
}

/// Leaves out all but the objects, so that their numbers are in sight.
fn show_only_objects(window: &mut Harness<'_, App>) {
    for section in ["Derivation: Basis", "Derivation: Pixel to ray"] {
        window.get_by_label(section).click();
        window.run();
    }
}

fn undo(window: &mut Harness<'_, App>) {
    window.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Z);
    window.run();
}

#[test]
fn the_given_numbers_are_fields_and_no_others() {
    let mut window = derivation_window("canonical");
    let coordinates = |name: &str| ["x", "y", "z"].map(|axis| format!("{name} {axis}"));
    let mut expected: Vec<String> = ["eye", "at", "up"].into_iter().flat_map(coordinates).collect();
    expected.extend(["distance", "uv u", "uv v"].map(str::to_owned));
    for sphere in ["sphere 0 “ball”", "sphere 1 “marble”"] {
        expected.extend(coordinates(&format!("{sphere} centre")));
        expected.push(format!("{sphere} radius"));
    }
    expected.extend(coordinates("plane 2 “back wall” point"));
    expected.extend(coordinates("plane 2 “back wall” normal"));
    assert_eq!(fields(&window), expected);
    type_into(&mut window, "row", "3");
    let of_pixel: Vec<String> = fields(&window).into_iter().skip(9).take(7).collect();
    assert_eq!(of_pixel, ["width", "height", "W", "H", "distance", "row", "column"]);
}

#[test]
fn a_given_number_is_typed_where_it_stands_and_all_follows_in_the_same_frame() {
    let mut window = derivation_window("canonical");
    let world =
        |window: &Harness<'_, App>| window.state().derived().world_view.clone().unwrap().image;
    let before = world(&window);
    window.get_by_role_and_label(Role::SpinButton, "derivation eye x").click();
    window.run();
    window.get_by_role_and_label(Role::SpinButton, "derivation eye x").type_text("1/2");
    window.run();
    window.key_press(egui::Key::Enter);
    window.step();
    assert_eq!(window.state().document().camera.eye.x, 0.5);
    assert_says(&window, "eye = (0.5, 0, 0)");
    assert_says(&window, "view = at − eye = (0, 0, −5) − (0.5, 0, 0) = (−0.5, 0, −5)");
    assert_ne!(before, world(&window));
    let field = window.get_by_role_and_label(Role::SpinButton, "eye x");
    assert_eq!(field.value().as_deref(), Some("0.5"));
    undo(&mut window);
    assert_eq!(window.state().document().camera.eye.x, 0.0);
}

#[test]
fn a_drag_of_a_given_number_is_one_step() {
    let mut window = derivation_window("canonical");
    show_only_objects(&mut window);
    let before = window.state().document().clone();
    let from = field_rect(&window, "sphere 0 “ball” radius").center();
    window.hover_at(from);
    window.run();
    window.drag_at(from);
    window.run();
    let mut radii = vec![before.spheres[0].shape.radius];
    for k in 1..=4 {
        window.hover_at(from + egui::vec2(12.0 * k as f32, 0.0));
        // The frame in which the mouse moves shows it.
        window.step();
        let radius = window.state().document().spheres[0].shape.radius;
        assert!(radius > radii[k - 1], "{radius} after {radii:?}");
        assert!(says(&window, &format!("r = {radius}")), "{:?}", texts_with(&window, "r = "));
        radii.push(radius);
        assert_eq!(
            pointed(&window).map(|pointed| pointed.concept),
            Some(Concept::Object(0)),
            "the sphere is lit while its number is dragged"
        );
    }
    window.drop_at(from + egui::vec2(48.0, 0.0));
    window.run();
    undo(&mut window);
    assert_eq!(*window.state().document(), before);
}

#[test]
fn escape_gives_the_old_number_back() {
    let mut window = derivation_window("canonical");
    let before = window.state().document().clone();
    window.get_by_role_and_label(Role::SpinButton, "derivation up y").click();
    window.run();
    window.get_by_role_and_label(Role::SpinButton, "derivation up y").type_text("9");
    window.run();
    window.key_press(egui::Key::Escape);
    window.run();
    assert_eq!(*window.state().document(), before);
    assert_says(&window, "up = (0, 1, 0)");
}

#[test]
fn what_is_no_number_is_refused_with_a_reason() {
    let mut window = derivation_window("canonical");
    let before = window.state().document().clone();
    type_into(&mut window, "derivation distance", "zwei");
    assert_eq!(*window.state().document(), before);
    assert!(!texts_with(&window, "“zwei” is not a number").is_empty());
    type_into(&mut window, "row", "3");
    type_into(&mut window, "derivation row", "400");
    assert!(!texts_with(&window, "400 is not between 0 and 399").is_empty());
    assert_says(&window, "row i = 3, column j = 280; counted from 0");
}

#[test]
fn a_number_that_is_dragged_too_far_can_be_dragged_back() {
    let mut window = derivation_window("canonical");
    window.get_by_label("Derivation: Basis").click();
    window.run();
    for (name, left, line) in [
        ("distance", -140.0, "no ray; viewport distance is −0.4"),
        ("sphere 0 “ball” radius", -140.0, "no picture; radius is −"),
    ] {
        let from = field_rect(&window, name).center();
        let before = window.state().document().clone();
        window.hover_at(from);
        window.run();
        window.drag_at(from);
        window.run();
        window.hover_at(from + egui::vec2(left, 0.0));
        window.run();
        assert!(
            texts_with(&window, "; ").iter().any(|text| text.starts_with(line)),
            "{name}: {:?}",
            texts_with(&window, "; ")
        );
        window.hover_at(from + egui::vec2(20.0, 0.0));
        window.run();
        window.drop_at(from + egui::vec2(20.0, 0.0));
        window.run();
        assert!(window.state().derived().fault.is_none(), "{name}");
        undo(&mut window);
        assert_eq!(*window.state().document(), before, "{name}");
    }
}

#[test]
fn the_pixels_shape_is_kept_as_in_the_panel() {
    let mut window = derivation_window("canonical");
    type_into(&mut window, "row", "3");
    type_into(&mut window, "derivation width", "2");
    let viewport = window.state().document().camera.viewport;
    assert_eq!((viewport.width, viewport.height), (2.0, 2.0));
    type_into(&mut window, "derivation W", "200");
    let camera = window.state().document().camera;
    assert_eq!((camera.viewport.width, camera.viewport.height), (1.0, 2.0));
    assert_says(&window, "row i = 3, column j = 140; counted from 0");
}

#[test]
fn given_numbers_are_reached_by_the_keyboard() {
    let mut window = derivation_window("canonical");
    window.get_by_role_and_label(Role::SpinButton, "derivation at x").focus();
    window.run();
    window.get_by_role_and_label(Role::SpinButton, "derivation at x").type_text("3");
    window.run();
    window.key_press(egui::Key::Tab);
    window.run();
    assert_says(&window, "at = (3, 0, −5)");
    let y = window.get_by_role_and_label(Role::SpinButton, "derivation at y");
    assert!(y.is_focused());
}

#[test]
fn exact_forms_or_decimals() {
    let mut window = derivation_window("forty-five");
    assert_says(&window, "𝐮 = (1/√2, 0, −1/√2); set by hand");
    window.get_by_label("Decimals").click();
    window.run();
    assert!(!window.state().session().preferences.exact_forms);
    assert_says(&window, "𝐮 ≈ (0.70711, 0, −0.70711); set by hand");
    let shown = window.state().derived().derivation.clone().unwrap().to_string();
    let is_number = |after: &str| after.starts_with(|c: char| c.is_ascii_digit());
    assert!(!shown.split('√').skip(1).any(is_number), "{shown}");
    window.get_by_label("Exact").click();
    window.run();
    assert_says(&window, "𝐮 = (1/√2, 0, −1/√2); set by hand");
}

#[test]
fn three_decimals_while_presenting() {
    let mut window = derivation_window("look-at");
    assert!(!texts_with(&window, "0.9882").is_empty());
    window.key_press(egui::Key::F5);
    window.run();
    assert!(texts_with(&window, "0.9882").is_empty());
    assert!(!texts_with(&window, "≈ 0.988").is_empty());
    assert!(!texts_with(&window, "(21, 4, 15)/√682").is_empty(), "short forms stay");
}

#[test]
fn w_recaps_the_way_to_the_ray_in_six_lines_and_ends_the_recap() {
    let recap = |d: &str, is: char| {
        [
            "view = at − eye = (−21, −4, −15)".to_owned(),
            "𝐰 = normalize(−view) = (21, 4, 15)/√682".to_owned(),
            "𝐮 = normalize(up × 𝐰) = (5, 0, −7)/√74".to_owned(),
            "𝐯 = 𝐰 × 𝐮 ≈ (−0.12464, 0.9882, −0.089027)".to_owned(),
            format!("𝐝 = u 𝐮 + v 𝐯 − distance 𝐰 {is} {d}"),
            format!("𝐩 + t 𝐝 {is} (20, 4, 10) + t {d}; 𝐩 = eye; t = 1 is on the viewport"),
        ]
    };
    let press = |window: &mut Harness<'_, App>, key| {
        window.key_press(key);
        window.run();
    };
    let layout = |window: &Harness<'_, App>| window.state().session().shown.setup.layout;
    let mut window = window_with("look-at", Remembered::default(), None);
    let before = layout(&window);
    press(&mut window, egui::Key::W);
    let shown = recap("(−0.67542, −0.25199, −0.72822)", '≈');
    assert_eq!(lines(&window), shown);
    shown.iter().for_each(|line| assert_says(&window, line));
    window.get_by_role_and_label(Role::Image, "Camera view");
    press(&mut window, egui::Key::W);
    assert_eq!(layout(&window), before);
    press(&mut window, egui::Key::W);
    window.get_by_label("All lines").click();
    window.run();
    assert_eq!(layout(&window), ViewLayout::Derivation);
    assert!(lines(&window).len() > 20);
    // In a lesson, the card beside the figure has the six lines in place of the step's own.
    let id = LessonArgument::parse("8.2").unwrap().load().unwrap().0;
    window.state_mut().open_lesson(id, None);
    window.run();
    press(&mut window, egui::Key::End);
    let of_step = lines(&window);
    press(&mut window, egui::Key::W);
    let shown = recap("(−21, −4, −15)/√682", '=');
    assert_eq!(lines(&window), shown);
    shown.iter().for_each(|line| assert_says(&window, line));
    press(&mut window, egui::Key::W);
    assert_eq!(lines(&window), of_step);
}

/// Presents a lesson whose second step shows the derivation; `more` belongs to that step.
fn presented_derivation(folder: &std::path::Path, more: &str) -> Harness<'static, App> {
    let path = folder.join("mine.toml");
    let text = format!(
        "pinhole_lesson = 1\ntitle = \"Mine\"\n[[step]]\ntitle = \"One\"\ntext = \"Look.\"\n\
         scene = \"canonical\"\nlayout = \"both\"\n[[step]]\ntitle = \"Two\"\ntext = \"See.\"\n\
         layout = \"derivation\"\nformulas = [\"eye\", \"at\", \"view\", \"w\", \"u\"]\n{more}"
    );
    std::fs::write(&path, text).unwrap();
    let (id, file) = LessonArgument::parse(path.to_str().unwrap()).unwrap().load().unwrap();
    let mut window = derivation_window("canonical");
    window.state_mut().open_lesson(id, file);
    for key in [egui::Key::F5, egui::Key::PageDown] {
        window.key_press(key);
        window.run();
    }
    window
}

fn lines(window: &Harness<'_, App>) -> Vec<String> {
    let derivation = window.state().derived().derivation.clone().unwrap();
    let lines = derivation.sections.iter().flat_map(|section| &section.lines);
    let texts: Vec<String> = lines.map(ToString::to_string).collect();
    assert_eq!(texts.len(), derivation.line_count());
    texts
}

#[test]
fn page_down_reveals_line_by_line_before_an_audience() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = presented_derivation(folder.path(), "");
    let all = lines(&window);
    // *eye* and *at* are given, and come with what follows from them.
    for count in [0].into_iter().chain(3..=all.len()) {
        for line in &all {
            let is_shown = all[..count].contains(line);
            assert_eq!(says(&window, line), is_shown, "{line} with {count} lines revealed");
        }
        if count == 0 {
            assert!(!fields(&window).contains(&"at x".to_owned()));
        }
        window.key_press(egui::Key::PageDown);
        window.run();
    }
    // Page Up takes the lines back, in the same steps.
    for count in (3..all.len()).rev().chain([0]) {
        window.key_press(egui::Key::PageUp);
        window.run();
        let shown = all.iter().filter(|line| says(&window, line)).count();
        assert_eq!(shown, count);
    }
    window.key_press(egui::Key::F5);
    window.run();
    assert!(lines(&window).iter().all(|line| says(&window, line)), "nothing is kept back");
}

#[test]
fn a_step_reveals_the_lines_that_it_is_about_and_the_next_one_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let more =
        "highlight = \"w\"\n[[step]]\ntitle = \"Three\"\ntext = \"On.\"\nhighlight = \"u\"\n";
    let mut window = presented_derivation(folder.path(), more);
    let all = lines(&window);
    let shown = |window: &Harness<'_, App>| all.iter().filter(|line| says(window, line)).count();
    let mut counts = Vec::new();
    while window.state().lesson().unwrap().id().step == 1 {
        counts.push(shown(&window));
        window.key_press(egui::Key::PageDown);
        window.run();
    }
    let through_w = *counts.last().unwrap();
    assert_eq!(counts, [0].into_iter().chain(3..=through_w).collect::<Vec<_>>());
    assert!(through_w > 0 && through_w < all.len(), "{through_w} of {all:?}");
    assert_eq!(shown(&window), through_w, "the next step begins with what was shown");
    window.key_press(egui::Key::PageDown);
    window.run();
    assert_eq!(shown(&window), through_w + 1);
}

#[test]
fn an_idle_window_keeps_its_derivation() {
    let mut window = derivation_window("look-at");
    let before = window.state().derived().derivation.clone().unwrap();
    window.step();
    assert!(Arc::ptr_eq(&before, window.state().derived().derivation.as_ref().unwrap()));
}

#[test]
fn a_symbol_that_the_mouse_rests_on_says_what_it_is() {
    let mut window = derivation_window("canonical");
    let mut said = |line: &str, [x, y]: [f32; 2]| {
        let rect = window.get_by_label(line).rect();
        window.hover_at(rect.left_top() + egui::vec2(x, y));
        for _ in 0..4 {
            window.step();
        }
        texts_with(&window, ", ")
    };
    let has = |texts: &[String], words: &str| texts.iter().any(|text| text.starts_with(words));
    let (w, u) = ("𝐰: backwards, the opposite of the view", "𝐮: to the right in the image");
    let texts = said("𝐰 = normalize(−view) = (0, 0, 5)/5 = (0, 0, 1)", [63.0, 22.0]);
    assert!(has(&texts, w), "{texts:?}");
    let scalar = "𝑢: how far right of the viewport's middle";
    let line = "u 𝐮 = 0.2 (1, 0, 0) = (0.2, 0, 0)";
    let texts = said(line, [83.0, 13.0]);
    assert!(has(&texts, scalar) && !has(&texts, u) && !has(&texts, w), "{texts:?}");
    let texts = said(line, [96.0, 13.0]);
    assert!(has(&texts, u) && !has(&texts, scalar), "{texts:?}");
    // Numbers mean nothing but themselves.
    let texts = said(line, [150.0, 13.0]);
    assert!(!has(&texts, u) && !has(&texts, scalar), "{texts:?}");
}

#[test]
fn concepts_are_pointed_at_in_the_views_of_every_layout() {
    for layout in [ViewLayout::Both, ViewLayout::Plot, ViewLayout::Mistakes] {
        let settings = Settings { setup: Setup { layout, ..Setup::default() }, ..unfolded() };
        let remembered = Remembered { settings, ..Remembered::default() };
        let mut window = window_with("canonical", remembered, None);
        if window.query_by_role_and_label(Role::Image, "World view").is_some() {
            hover_mark(&mut window, "World view", Concept::W);
            let pointed_at = Hovered { concept: Concept::W, by: HoverSource::View };
            assert_eq!(pointed(&window), Some(pointed_at), "{layout:?}");
            point_at_nothing(&mut window);
        }
        let picture =
            |window: &Harness<'_, App>| window.state().derived().camera_view.clone().unwrap().image;
        // A plane has no outline of its own: its pixels are hatched.
        let wall = Concept::Object(2);
        let view = window.get_by_role_and_label(Role::Image, "Camera view").rect();
        window.hover_at(view.min + egui::vec2(0.15, 0.8) * view.size());
        window.run();
        assert_eq!(pointed(&window).map(|pointed| pointed.concept), Some(wall), "{layout:?}");
        // Pointing is quiet unless Alt is held.
        window.event(egui::Event::ModifiersChanged(egui::Modifiers::ALT));
        window.run();
        let lit = picture(&window);
        window.event(egui::Event::ModifiersChanged(egui::Modifiers::NONE));
        point_at_nothing(&mut window);
        assert_ne!(lit, picture(&window), "{layout:?}");
    }
}
