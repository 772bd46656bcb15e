//! The ghost by key and label: freezing, numbers, differences.

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;
use pinhole_core::{Camera, NO_OBJECT, Outputs, Raster, trace};

use crate::harness::{assert_reads, assert_says, open_scene, show, texts_with, type_into, window};

fn press(harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    harness.key_press_modifiers(modifiers, key);
    harness.run();
}

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_role_and_label(Role::Button, label).click_accesskit();
    harness.run();
}

/// A window with the ghost of the scene's camera, side by side with what is there now.
fn comparing(scene: &str) -> Harness<'static, App> {
    let mut harness = window(scene);
    press(&mut harness, Modifiers::NONE, Key::G);
    show(&mut harness, ViewLayout::Compare);
    harness
}

fn ghost_says(harness: &Harness<'_, App>) -> String {
    harness.get_by_role_and_label(Role::Image, "Ghost").accesskit_node().description().unwrap()
}

/// The names that the world view writes.
fn names(harness: &Harness<'_, App>) -> Vec<String> {
    let view = harness.state().derived().world_view.as_ref().unwrap();
    view.labels.iter().map(|label| label.text.clone()).collect()
}

#[test]
fn a_ghost_is_frozen_and_dropped_by_key() {
    let mut harness = window("canonical");
    let document = harness.state().document().clone();
    press(&mut harness, Modifiers::NONE, Key::G);
    assert_eq!(harness.state().session().shown.ghost.unwrap().camera, document.camera);
    type_into(&mut harness, "eye x", "1");
    assert_eq!(harness.state().session().shown.ghost.unwrap().camera, document.camera);
    let names_with = names(&harness);
    for name in ["eye′", "u′", "v′", "w′", "eye", "u", "v", "w"] {
        assert!(names_with.iter().any(|label| label == name), "no {name} in {names_with:?}");
    }
    press(&mut harness, Modifiers::SHIFT, Key::G);
    assert!(harness.state().session().shown.ghost.is_none());
    assert!(names(&harness).iter().all(|label| !label.contains('′')));
}

#[test]
fn the_names_stand_in_the_rows_of_their_numbers() {
    let harness = comparing("canonical");
    let heights = |text: &str| -> Vec<f32> {
        let all = harness.query_all_by_role(Role::Label);
        let reads = |node: &egui_kittest::Node<'_>| {
            node.accesskit_node().value().is_some_and(|value| value.starts_with(text))
        };
        all.filter(reads).map(|node| node.rect().center().y).collect()
    };
    let vectors = heights("(0, 1, 0)");
    for name in ["v: ghost", "up: ghost"] {
        let here = heights(name)[0];
        assert!(vectors.iter().any(|there| (there - here).abs() < 2.0), "{here}: {vectors:?}");
    }
}

#[test]
fn the_ghost_is_dashed() {
    let mut harness = window("canonical");
    let before = harness.state().derived().world_view.clone().unwrap();
    press(&mut harness, Modifiers::NONE, Key::G);
    let after = harness.state().derived().world_view.clone().unwrap();
    assert_ne!(before.image.pixels, after.image.pixels);
}

#[test]
fn the_difference_is_told_in_numbers() {
    let mut harness = comparing("canonical");
    assert_says(&harness, "turned by 0°, rolled by 0°");
    type_into(&mut harness, "eye x", "3");
    type_into(&mut harness, "eye z", "4");
    assert_reads(&harness, "eye: ghost (0, 0, 0), now (3, 0, 4), difference 5");
    assert_reads(&harness, "at: ghost (0, 0, −5), now (0, 0, −5), difference 0");
    // atan(3 / 9)
    assert_reads(&harness, "v: ghost (0, 1, 0), now (0, 1, 0), difference 0°");
    assert_says(&harness, "turned by 18.43°, rolled by 0°");
    type_into(&mut harness, "up y", "0");
    type_into(&mut harness, "up x", "1");
    assert_reads(&harness, "up: ghost (0, 1, 0), now (1, 0, 0), difference 90°");
    assert_eq!(texts_with(&harness, "rolled by −90°").len(), 2);
    type_into(&mut harness, "distance", "2.5");
    assert_reads(&harness, "distance: ghost 1, now 2.5, difference +1.5");
}

#[test]
fn the_selected_ray_hits_in_both() {
    let mut harness = comparing("canonical");
    let t = harness.state().derived().inspection.as_ref().unwrap().first_hit().unwrap().t;
    assert_eq!(t, 6.0);
    type_into(&mut harness, "distance", "2");
    assert_reads(&harness, "t: ghost 6, now 2.056, difference −3.944");
    assert_reads(&harness, "hit: ghost plane 2, now sphere 0, difference another");
}

#[test]
fn pixels_that_differ_are_counted() {
    let mut harness = comparing("canonical");
    assert!(ghost_says(&harness).starts_with("0 % of "), "{}", ghost_says(&harness));
    type_into(&mut harness, "W", "20");
    type_into(&mut harness, "H", "20");
    type_into(&mut harness, "eye x", "1");
    type_into(&mut harness, "at x", "1");
    let ghost = Camera { image: harness.state().document().camera.image, ..Camera::CANONICAL };
    let scene = harness.state().document().scene().unwrap();
    let objects = |camera: &Camera| {
        let camera = camera.resolve().unwrap();
        let raster = Raster::full(camera.image());
        trace(&scene, &camera, &raster, Outputs { object: true, ..Outputs::NONE }).object
    };
    let (here, there) = (objects(&harness.state().document().camera), objects(&ghost));
    let differing = here.iter().zip(&there).filter(|(a, b)| a != b).count();
    assert!(differing > 0 && here.iter().all(|object| *object != NO_OBJECT));
    let percent = 100.0 * differing as f64 / 400.0;
    assert!((10.0..99.0).contains(&percent), "{percent}");
    let said = format!("{percent:.0} % of the picture shows another object");
    assert_eq!(ghost_says(&harness), said);
    assert_says(&harness, &said);
    let picture = harness.state().derived().second_view.as_ref().unwrap().image.clone();
    click(&mut harness, "Differences");
    let map = harness.state().derived().second_view.as_ref().unwrap().image.clone();
    assert_eq!(picture.size, map.size);
    assert_ne!(picture.pixels, map.pixels);
}

#[test]
fn without_a_ghost_the_layout_says_how_to_get_one() {
    let mut harness = window("canonical");
    show(&mut harness, ViewLayout::Compare);
    assert_says(&harness, "Freeze the camera as a ghost, then change it and compare.");
    click(&mut harness, "Freeze the camera as a ghost");
    assert!(harness.state().derived().against_ghost.is_some());
    let traced = harness.state().pictures_traced();
    harness.run_steps(3);
    assert_eq!(harness.state().pictures_traced(), traced, "nothing changes");
}

#[test]
fn a_removed_ghost_leaves_no_empty_half() {
    let mut harness = comparing("canonical");
    press(&mut harness, Modifiers::SHIFT, Key::G);
    assert_eq!(harness.state().session().shown.setup.layout, ViewLayout::Both);
    assert!(harness.query_by_role_and_label(Role::Image, "Ghost").is_none());
}

#[test]
fn another_scene_has_no_ghost() {
    let mut harness = comparing("canonical");
    open_scene(&mut harness, "look-at");
    assert!(harness.state().session().shown.ghost.is_none());
}
