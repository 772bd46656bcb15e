//! The camera panel's part for teaching.

use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole_core::DVec3;

use super::harness::{assert_says, says, type_into, window};

type Window = egui_kittest::Harness<'static, pinhole::ui::app::App>;

/// A window with the part unfolded.
fn teaching(scene: &str) -> Window {
    let mut window = window(scene);
    window.get_by_label("Experiments").click();
    window.run();
    window
}

fn near(a: DVec3, b: DVec3) -> bool {
    (a - b).length() < 1e-12
}

#[test]
fn the_locked_picture_stays_while_distance_width_or_height_change() {
    let mut window = teaching("canonical");
    window.get_by_label("Keep the picture: scale distance, width and height together").click();
    window.run();
    let before = window.state().derived().camera_view.clone().unwrap().image;
    let fov = window.get_by_role_and_label(Role::SpinButton, "vertical field of view");
    assert!(fov.accesskit_node().is_disabled());
    for (field, text, [width, height, distance]) in [
        ("distance", "2", [2.0, 2.0, 2.0]),
        ("width", "3", [3.0, 3.0, 3.0]),
        ("height", "1/2", [0.5, 0.5, 0.5]),
    ] {
        type_into(&mut window, field, text);
        let viewport = window.state().document().camera.viewport;
        assert_eq!([viewport.width, viewport.height, viewport.distance], [width, height, distance]);
    }
    type_into(&mut window, "distance", "2");
    // The selected ray stays the same line.
    assert_says(&window, "d = (0.4, −0.2, −2)");
    assert_says(&window, "t = 3");
    assert_says(&window, "point = (1.2, −0.6, −6)");
    type_into(&mut window, "distance", "1");
    type_into(&mut window, "uv u", "0.2");
    type_into(&mut window, "uv v", "-0.1");
    assert_eq!(before, window.state().derived().camera_view.clone().unwrap().image);
}

#[test]
fn the_locked_picture_comes_back_after_a_measure_that_is_none() {
    let mut window = teaching("canonical");
    window.get_by_label("Keep the picture: scale distance, width and height together").click();
    window.run();
    let before = window.state().derived().camera_view.clone().unwrap().image;
    let viewport = |window: &Window| window.state().document().camera.viewport;
    type_into(&mut window, "width", "0");
    assert_eq!(viewport(&window).width, 0.0);
    assert_says(&window, "viewport width is 0: it must be finite and greater than 0");
    type_into(&mut window, "eye x", "0.5");
    type_into(&mut window, "width", "3");
    let now = viewport(&window);
    assert_eq!([now.width, now.height, now.distance], [3.0, 3.0, 3.0]);
    type_into(&mut window, "height", "-2");
    type_into(&mut window, "distance", "1");
    let now = viewport(&window);
    assert_eq!([now.width, now.height, now.distance], [1.0, 1.0, 1.0]);
    type_into(&mut window, "eye x", "0");
    type_into(&mut window, "uv u", "0.2");
    type_into(&mut window, "uv v", "-0.1");
    assert_eq!(before, window.state().derived().camera_view.clone().unwrap().image);
}

#[test]
fn up_is_tilted_towards_the_view_and_the_sensitivity_says_what_that_does() {
    let mut window = teaching("canonical");
    let basis = *window.state().derived().resolved.unwrap().basis();
    for (degrees, number) in [
        ("90", "1° of roll per 1° of up"),
        ("10", "5.76° of roll per 1° of up"),
        ("0.5", "115° of roll per 1° of up"),
        ("179.5", "115° of roll per 1° of up"),
    ] {
        type_into(&mut window, "up from view", degrees);
        assert_says(&window, number);
        let now = *window.state().derived().resolved.unwrap().basis();
        assert!(near(now.u, basis.u) && near(now.v, basis.v) && near(now.w, basis.w), "{degrees}");
    }
    type_into(&mut window, "up z", "1");
    type_into(&mut window, "up y", "0");
    let tilt = window.get_by_role_and_label(Role::SpinButton, "up from view");
    assert!(tilt.accesskit_node().is_disabled());
}

#[test]
fn a_basis_by_hand_has_no_up_to_turn() {
    let mut window = teaching("forty-five");
    assert!(!window.state().document().camera.orientation.has_up());
    for field in ["roll", "up from view"] {
        assert!(window.query_by_role_and_label(Role::SpinButton, field).is_none());
    }
    assert!(says(&window, "Keep the picture: scale distance, width and height together"));
    window.get_by_label("Experiments").click();
    window.run();
    assert!(!says(&window, "Keep the picture: scale distance, width and height together"));
}
