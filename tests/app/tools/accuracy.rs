//! The accuracy view: the error map, who draws the picture, and measuring in slices.

use egui::accesskit::Role;
use egui::epaint::Shape;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::session::{Preferences, Settings, Setup, Split, Splits, ViewLayout};
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;
use pinhole::view::derive::MOST_QUESTIONS;
use pinhole_core::methods::Method;
use pinhole_core::{Pixel, Selection};
use pinhole_lecture::numbers::grouped;

use crate::harness::{assert_says, show, texts_with, type_into, unfolded, window, window_with};

fn named(name: &str) -> Method {
    Method::from_name(name).unwrap()
}

/// A window that comes back with these settings. It measures all the time, so a test goes on step by
/// step instead of waiting for rest.
fn with(scene: &str, settings: Settings) -> Harness<'static, App> {
    window_with(scene, Remembered { settings, ..Remembered::default() }, None)
}

/// A window on a scene that is written for it.
fn window_on(text: &str) -> Harness<'static, App> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).unwrap();
    window(&path)
}

/// A window on a sphere so small and far that single precision loses its outline.
fn far_window() -> Harness<'static, App> {
    window_on(
        "pinhole = 1\n[camera]\neye = [0, 0, 10000]\nat = [0, 0, 0]\nup = [0, 1, 0]\n\
         [viewport]\nwidth = 0.0004\nheight = 0.0004\n[image]\nwidth = 200\nheight = 200\n\
         [[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n",
    )
}

fn open(window: &mut Harness<'_, App>) {
    show(window, ViewLayout::Accuracy);
    window.run_steps(3);
}

fn choose(window: &mut Harness<'_, App>, combo: &str, method: &str) {
    window.get_by_role_and_label(Role::ComboBox, combo).click();
    window.run_steps(3);
    window.get_by_role_and_label(Role::Button, method).scroll_to_me();
    window.run_steps(3);
    window.get_by_role_and_label(Role::Button, method).click();
    window.run_steps(3);
}

fn map_says(window: &Harness<'_, App>) -> String {
    window.get_by_role_and_label(Role::Image, "Error map").accesskit_node().description().unwrap()
}

#[test]
fn a_closed_view_measures_nothing_and_takes_no_room() {
    let window = window("planet");
    let derived = window.state().derived();
    assert!(derived.second_view.is_none());
    assert!(window.query_by_label("Error map").is_none());
}

#[test]
fn the_map_follows_the_camera_at_once() {
    let mut window = window("grazing");
    open(&mut window);
    let before = window.state().derived().clone();
    let compared = before.compared.as_deref().unwrap();
    assert_eq!(compared.comparison.errors.len(), compared.frame.t.len());
    assert_eq!(compared.method.name(), "textbook-f32");
    window.get_by_role_and_label(Role::SpinButton, "eye x").click();
    window.run_steps(2);
    window.get_by_role_and_label(Role::SpinButton, "eye x").type_text("0.25");
    window.run_steps(2);
    window.key_press(egui::Key::Enter);
    window.run_steps(2);
    let after = window.state().derived().clone();
    assert_ne!(after.compared.as_deref().unwrap().comparison, compared.comparison);
    assert_ne!(
        after.second_view.as_ref().unwrap().image.pixels,
        before.second_view.as_ref().unwrap().image.pixels
    );
}

#[test]
fn the_map_is_of_the_chosen_method_and_says_how_many_pixels_are_wrong() {
    let mut window = window("planet");
    open(&mut window);
    assert!(map_says(&window).starts_with("textbook-f32: "), "{}", map_says(&window));
    choose(&mut window, "error map of", "ladder");
    let text = map_says(&window);
    assert!(text.starts_with("ladder: 0 of ") && text.ends_with("up to 0 ulps"), "{text}");
    choose(&mut window, "error map of", "lagrange-f64");
    assert_eq!(window.state().session().preferences.compared, named("lagrange-f64"));
    assert!(map_says(&window).starts_with("lagrange-f64: "));
    let map = window.state().derived().second_view.as_ref().unwrap().clone();
    assert_eq!(map.image.size, window.state().derived().camera_view.clone().unwrap().image.size);
}

#[test]
fn an_error_larger_than_t_is_told_in_words() {
    // Rounded to f32 the eye lies on the sphere: t is 1e-8, and textbook-f32 finds the far side at 2.
    let mut window = window_on(
        "pinhole = 1\n[camera]\neye = [0, 0, 1.00000001]\nat = [0, 0, 0]\nup = [0, 1, 0]\n\
         [viewport]\nwidth = 1\nheight = 1\n[image]\nwidth = 9\nheight = 9\n\
         [[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n",
    );
    open(&mut window);
    let text = map_says(&window);
    assert!(text.ends_with(" pixels wrong, at worst no digit of t right"), "{text}");
    let selected = texts_with(&window, "; textbook-f32 hits sphere 0 at t = ");
    assert!(selected.iter().any(|text| text.ends_with(": no digit of t right")), "{selected:?}");
}

#[test]
fn wrong_pixels_are_red_with_a_white_edge() {
    let mut window = far_window();
    open(&mut window);
    let derived = window.state().derived().clone();
    let wrong = derived.compared.as_deref().unwrap().comparison.wrong;
    let image = &derived.second_view.as_ref().unwrap().image;
    let red = image.pixels.iter().filter(|p| p.r() == 0xff && p.g() == 0x2d).count();
    let white = image.pixels.iter().filter(|p| **p == egui::Color32::WHITE).count();
    assert!(wrong > 0, "the scene is there to show that");
    assert!(red >= 25 && white >= 20, "{wrong} wrong, {red} red, {white} white");
    assert!(
        map_says(&window).contains(&format!(": {} of ", grouped(wrong as u64))),
        "{}",
        map_says(&window)
    );
}

#[test]
fn a_click_in_the_map_selects_the_pixel_and_says_what_both_make_of_it() {
    let mut window = window("canonical");
    open(&mut window);
    let rect = window.get_by_role_and_label(Role::Image, "Error map").rect();
    let at = rect.min + egui::vec2(0.25, 0.75) * rect.size() + egui::vec2(0.3, 0.3);
    window.hover_at(at);
    window.run_steps(2);
    window.drag_at(at);
    window.run_steps(2);
    window.drop_at(at);
    window.run_steps(2);
    let Selection::Pixel(Pixel { row, column }) = window.state().session().shown.selection else {
        panic!("no pixel is selected")
    };
    assert!(row.abs_diff(300) <= 1 && column.abs_diff(100) <= 1, "{row}, {column}");
    let text = texts_with(&window, &format!("row {row}, column {column}: ladder hits "));
    assert!(text.iter().any(|text| text.contains("; textbook-f32 hits ")), "{text:?}");
}

/// A window on so many spheres that no method may ask all of them at all pixels.
fn crowded_window() -> Harness<'static, App> {
    let folder = tempfile::tempdir().unwrap();
    let sphere = |i: i32| format!("{},{},-200,0.4\n", i % 200 - 100, i / 200 - 50);
    let rows: String = (0..20_000).map(sphere).collect();
    std::fs::write(folder.path().join("crowd.csv"), format!("x,y,z,r\n{rows}")).unwrap();
    let path = folder.path().join("crowd.toml");
    let text = "pinhole = 1\nspheres = \"crowd.csv\"\n\
                [camera]\neye = [0, 0, 0]\nat = [0, 0, -1]\nup = [0, 1, 0]\n";
    std::fs::write(&path, text).unwrap();
    with(path.to_str().unwrap(), unfolded())
}

#[test]
fn a_scene_too_large_for_the_other_methods_is_not_compared_and_says_why() {
    let mut window = crowded_window();
    assert_eq!(window.state().derived().too_many, None, "the ladder takes any number of objects");
    show(&mut window, ViewLayout::Accuracy);
    // Nothing is measured, so this comes to rest.
    window.run();
    let derived = window.state().derived().clone();
    assert!(derived.second_view.is_none() && derived.fault.is_none());
    let too_many = derived.too_many.unwrap();
    assert_eq!(too_many.objects, 20_000);
    assert!(too_many.objects * too_many.pixels > MOST_QUESTIONS);
    let why = too_many.to_string();
    assert!(why.starts_with("20,000 objects at "), "{why}");
    assert_says(&window, &format!("No error map: {why}"));
    assert_says(&window, &format!("Nothing is measured: {why}"));
}

/// The number of lines that join marks of the plot.
fn lines_between_marks(window: &Harness<'_, App>) -> usize {
    let is_line = |shape: &Shape| matches!(shape, Shape::Path(path) if !path.closed && path.stroke.width == 2.0);
    window.output().shapes.iter().filter(|clipped| is_line(&clipped.shape)).count()
}

#[test]
fn measuring_goes_in_slices_starts_anew_with_an_edit_and_ends() {
    let mut window = window("canonical");
    type_into(&mut window, "W", "40");
    type_into(&mut window, "H", "40");
    show(&mut window, ViewLayout::Accuracy);
    let done = |window: &Harness<'_, App>| !texts_with(window, "Measured on ").is_empty();
    let until_done = |window: &mut Harness<'_, App>| {
        let mut steps = 0;
        while !done(window) {
            window.step();
            steps += 1;
            assert!(steps < 20_000, "it never ends: {:?}", texts_with(window, "measured "));
        }
        steps
    };
    until_done(&mut window);
    assert!(texts_with(&window, "ladder").len() > 1);
    assert_says(&window, "error map of lagrange-f64");
    assert_eq!(lines_between_marks(&window), 0, "no method is between two others");
    // At rest, nothing is asked for.
    window.run();
    window.get_by_role_and_label(Role::SpinButton, "eye z").click();
    window.run_steps(2);
    window.get_by_role_and_label(Role::SpinButton, "eye z").type_text("1");
    window.run_steps(2);
    window.key_press(egui::Key::Enter);
    window.step();
    window.step();
    assert!(!done(&window), "the numbers are of another scene");
    let says = texts_with(&window, "easur");
    assert!(says.iter().any(|text| text.starts_with("measured ")), "how far it is: {says:?}");
    assert!(until_done(&mut window) > 2, "in slices");
}

#[test]
fn what_was_chosen_is_remembered() {
    let mut splits = Splits::default();
    splits.set(Split::Accuracy, 250.0);
    let settings = Settings {
        setup: Setup { layout: ViewLayout::Accuracy, ..Setup::default() },
        preferences: Preferences {
            compared: named("half-b-f32"),
            splits,
            ..unfolded().preferences
        },
    };
    let text = serde_json::to_string(&settings).unwrap();
    assert_eq!(serde_json::from_str::<Settings>(&text).unwrap(), settings);
}

#[test]
fn a_fault_leaves_the_last_map_and_stops_measuring() {
    let mut window = with("canonical", Settings::default());
    open(&mut window);
    window.get_by_role_and_label(Role::SpinButton, "up y").click();
    window.run_steps(2);
    window.get_by_role_and_label(Role::SpinButton, "up y").type_text("0");
    window.run_steps(2);
    window.key_press(egui::Key::Enter);
    // Nothing asks for another frame, so this comes to rest.
    window.run();
    assert!(window.state().derived().fault.is_some());
    assert!(window.state().derived().second_view.is_some());
}

#[test]
fn the_window_says_how_far_up_the_ladder_its_picture_went() {
    let mut window = window("canonical");
    let steps = window.state().derived().steps.unwrap();
    assert!(steps.total() > 0);
    let [f64, double_double, exact] = [steps.f64, steps.double_double, steps.exact].map(grouped);
    let said = if steps.beyond_f64() == 0 {
        format!("Hit or miss: {f64} decisions, all in f64")
    } else {
        format!(
            "Hit or miss: {f64} decisions in f64, {double_double} in double-double, {exact} exact"
        )
    };
    assert_says(&window, &said);
    open(&mut window);
    let steps = window.state().derived().steps.unwrap();
    let said = texts_with(&window, "Hit or miss: ");
    assert!(!said.is_empty());
    assert!(said.iter().all(|text| text.contains(&grouped(steps.f64))), "{said:?}");
}

#[test]
fn the_window_says_what_its_picture_left_out() {
    let mut window = window("canonical");
    type_into(&mut window, "W", "200");
    type_into(&mut window, "H", "100");
    let rows = |window: &Harness<'_, App>| {
        let counts = window.state().derived().counts.unwrap();
        assert_eq!(counts.rows, 100);
        counts.rows_untouched
    };
    let untouched = rows(&window);
    assert_says(&window, &format!("Left out: 0 of 2 spheres, {untouched} of 100 rows"));
    // The wall is asked about in every row, also where the camera looks away from it.
    type_into(&mut window, "at z", "1");
    assert_says(&window, "Left out: 2 of 2 spheres, 0 of 100 rows");
    // What lies next to the picture is left out, too. A fault has no counts.
    type_into(&mut window, "at z", "-1");
    type_into(&mut window, "eye y", "50");
    type_into(&mut window, "at y", "50");
    assert_says(&window, "Left out: 2 of 2 spheres, 0 of 100 rows");
    type_into(&mut window, "up y", "0");
    assert!(window.state().derived().fault.is_some());
    assert!(texts_with(&window, "Left out").is_empty());
    // It is there with the numbers folded, too.
    type_into(&mut window, "up y", "1");
    window.get_by_label("Fewer numbers").click();
    window.run();
    assert_says(&window, "Left out: 2 of 2 spheres, 0 of 100 rows");
}
