//! A camera without a basis: the last good picture stays, and the reason is said.

use std::sync::Arc;

use egui_kittest::kittest::Queryable as _;
use pinhole::model::session::ViewLayout;
use pinhole_figure::Fault;

use super::harness::{assert_says, choose_object, show, texts_with, type_into, window};

#[test]
fn the_last_good_picture_stays_and_the_reason_is_written() {
    let mut window = window("canonical");
    let before = window.state().derived().camera_view.clone().unwrap().image;
    type_into(&mut window, "at z", "0");
    let app = window.state();
    assert!(matches!(app.derived().fault, Some(Fault::Camera(_))));
    assert!(Arc::ptr_eq(&before, &app.derived().camera_view.clone().unwrap().image));
    let reason = "eye and at are the same point (0, 0, 0): move one of them";
    assert_eq!(texts_with(&window, reason), [reason], "across the picture");
    type_into(&mut window, "at z", "-1");
    assert!(window.state().derived().fault.is_none());
    assert_says(&window, "w = (0, 0, 1)");
}

#[test]
fn the_reason_is_said_once_on_every_page() {
    let mut window = window("canonical");
    window.get_by_label("Experiments").click();
    window.run();
    type_into(&mut window, "up y", "0");
    type_into(&mut window, "up z", "1");
    let reason = "up (0, 0, 1) is parallel to the view direction (0, 0, −5): turn one of them";
    for layout in [ViewLayout::Both, ViewLayout::World, ViewLayout::Camera, ViewLayout::Plot] {
        show(&mut window, layout);
        assert_eq!(texts_with(&window, reason), [reason], "{layout:?}");
    }
    // The derivation marks the line at which it fails.
    show(&mut window, ViewLayout::Derivation);
    let failing = format!("𝐮 = normalize(up × 𝐰); {reason}");
    let mut said = texts_with(&window, reason);
    said.sort();
    assert_eq!(said, [reason.to_owned(), failing]);
}

#[test]
fn every_fault_has_its_words_and_no_nan_is_shown() {
    for (field, text, reason) in [
        ("up y", "0", "up is (0, 0, 0): it must point somewhere"),
        ("width", "0", "viewport width is 0: it must be finite and greater than 0"),
        ("height", "-1", "viewport height is −1: it must be finite and greater than 0"),
        ("distance", "0", "viewport distance is 0: it must be finite and greater than 0"),
    ] {
        let mut window = window("canonical");
        window.get_by_label("Keep the pixels' shape").click();
        window.run();
        type_into(&mut window, field, text);
        assert_says(&window, reason);
        for wrong in ["NaN", "nan", "inf"] {
            let found = texts_with(&window, wrong);
            assert!(found.iter().all(|text| text.contains("infinite")), "{field}: {found:?}");
        }
    }
}

#[test]
fn up_along_the_view_is_a_fault_and_nearly_along_it_is_not() {
    let mut window = window("canonical");
    type_into(&mut window, "up y", "0");
    type_into(&mut window, "up z", "1");
    assert_says(
        &window,
        "up (0, 0, 1) is parallel to the view direction (0, 0, −5): turn one of them",
    );
    type_into(&mut window, "up y", "1e-9");
    assert!(window.state().derived().fault.is_none());
    assert_says(&window, "v = (0, 1, 0)");
    assert_says(&window, "sensitivity = 1e9");
}

#[test]
fn a_sphere_without_a_radius_is_a_fault_too() {
    let mut window = window("canonical");
    choose_object(&mut window, "sphere 0 “ball”");
    type_into(&mut window, "radius", "-1");
    assert!(matches!(window.state().derived().fault, Some(Fault::Scene(_))));
    assert_says(&window, "radius is −1: it must be finite and greater than 0");
}

#[test]
fn another_scene_has_no_last_picture_of_this_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("blind.toml");
    let text = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nat = [0, 0, 0]\nup = [0, 1, 0]\n";
    std::fs::write(&path, text).unwrap();
    let mut window = window("canonical");
    super::files::scene_files::drop_file(&mut window, &path);
    assert!(window.state().derived().fault.is_some());
    assert!(window.state().derived().camera_view.is_none());
}

#[test]
fn what_is_left_of_the_scene_keeps_its_colours_while_an_object_is_at_fault() {
    let mut window = window("canonical");
    let before = window.state().derived().world_view.clone().unwrap().image;
    choose_object(&mut window, "sphere 0 “ball”");
    type_into(&mut window, "radius", "-1");
    choose_object(&mut window, "sphere 1 “marble”");
    window.get_by_label("Delete").click();
    window.run();
    let after = window.state().derived().world_view.clone().unwrap().image;
    let orange = |image: &egui::ColorImage| {
        image.pixels.iter().filter(|p| p.r() > 200 && p.g() > 120 && p.b() < 40).count()
    };
    assert!(orange(&before) > 1000 && orange(&after).abs_diff(orange(&before)) < 2000);
}
