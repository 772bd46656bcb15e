//! The way of an edit: from a field to the document, the picture and every readout, in one frame.

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;
use pinhole_core::{Camera, DVec3, Orientation, OrientationKind, Pixel, Sphere};

use super::harness::{assert_says, choose_object, says, show, type_into, window};

#[test]
fn an_edit_reaches_document_picture_and_readouts_in_the_same_frame() {
    let mut window = window("canonical");
    let before = window.state().derived().camera_view.clone().unwrap().image;
    let traced = window.state().pictures_traced();
    window.get_by_role_and_label(Role::SpinButton, "eye x").set_value_accesskit(0.5);
    window.step();
    let app = window.state();
    assert_eq!(app.document().camera.eye, DVec3::new(0.5, 0.0, 0.0));
    let inspection = app.derived().inspection.clone().unwrap();
    assert_eq!(inspection.ray.origin.x, 0.5);
    let after = app.derived().camera_view.clone().unwrap().image;
    assert_ne!(before, after, "the picture is the old one");
    assert_eq!(app.pictures_traced(), traced + 1, "one edit, one picture");
    assert_says(&window, "p = (0.5, 0, 0)");
    let eye = window.get_by_role_and_label(Role::SpinButton, "eye x");
    assert_eq!(eye.value().as_deref(), Some("0.5"));
}

#[test]
fn an_idle_window_traces_nothing() {
    let mut window = window("canonical");
    let traced = window.state().pictures_traced();
    window.hover_at(egui::pos2(700.0, 300.0));
    window.run_steps(5);
    window.hover_at(egui::pos2(200.0, 300.0));
    window.run_steps(5);
    assert_eq!(window.state().pictures_traced(), traced);
}

#[test]
fn every_camera_field_is_there_and_edits_what_it_says() {
    let mut window = window("canonical");
    for (field, read) in [
        ("eye x", (|c: &Camera| c.eye.x) as fn(&Camera) -> f64),
        ("eye y", |c| c.eye.y),
        ("eye z", |c| c.eye.z),
        ("at x", |c| at(c).x),
        ("at y", |c| at(c).y),
        ("at z", |c| at(c).z),
        ("up x", |c| c.up().x),
        ("up y", |c| c.up().y),
        ("up z", |c| c.up().z),
        ("distance", |c| c.viewport.distance),
        ("width", |c| c.viewport.width),
        ("height", |c| c.viewport.height),
    ] {
        type_into(&mut window, field, "3.25");
        assert_eq!(read(&window.state().document().camera), 3.25, "{field}");
    }
    for (field, read) in
        [("W", (|c: &Camera| c.image.width()) as fn(&Camera) -> u32), ("H", |c| c.image.height())]
    {
        type_into(&mut window, field, "321");
        assert_eq!(read(&window.state().document().camera), 321, "{field}");
    }
}

fn at(camera: &Camera) -> DVec3 {
    match camera.orientation {
        Orientation::At { at, .. } => at,
        other => panic!("given by {other:?}"),
    }
}

#[test]
fn fields_take_arithmetic_and_refuse_what_is_no_number() {
    let mut window = window("canonical");
    for (text, value) in
        [("sqrt(2)/2", 2f64.sqrt() / 2.0), ("1/3", 1.0 / 3.0), ("-2*pi", -std::f64::consts::TAU)]
    {
        type_into(&mut window, "eye x", text);
        assert_eq!(window.state().document().camera.eye.x, value, "{text}");
    }
    let before = window.state().document().clone();
    type_into(&mut window, "eye x", "1/0");
    assert_eq!(*window.state().document(), before, "nothing is taken over");
    assert_says(&window, "“1/0” is not a finite number");
}

#[test]
fn switching_how_the_camera_is_given_changes_no_ray() {
    let mut window = window("look-at");
    let direction = |app: &pinhole::ui::app::App| {
        app.document()
            .camera
            .resolve()
            .unwrap()
            .ray_of_pixel(Pixel { row: 10, column: 20 })
            .direction
    };
    let before = direction(window.state());
    for (button, kind) in [
        ("eye, view, up", OrientationKind::View),
        ("u, v, w", OrientationKind::Basis),
        ("eye, at, up", OrientationKind::At),
        ("u, v, w", OrientationKind::Basis),
        ("eye, view, up", OrientationKind::View),
    ] {
        window.get_by_role_and_label(Role::Button, button).click();
        window.run();
        assert_eq!(window.state().document().camera.orientation.kind(), kind);
        let now = direction(window.state());
        assert!((now - before).length() < 1e-14, "{button}: {before} became {now}");
    }
    for field in ["view x", "up z"] {
        window.get_by_role_and_label(Role::SpinButton, field);
    }
}

#[test]
fn a_basis_is_set_by_hand() {
    let mut window = window("canonical");
    window.get_by_role_and_label(Role::Button, "u, v, w").click();
    window.run();
    for (field, text) in
        [("u x", "sqrt(2)/2"), ("u z", "-sqrt(2)/2"), ("w x", "sqrt(2)/2"), ("w z", "sqrt(2)/2")]
    {
        type_into(&mut window, field, text);
    }
    assert_says(&window, "d ≈ (−0.56569, −0.1, −0.84853)");
}

#[test]
fn the_pixels_shape_holds_until_let_go() {
    let mut window = window("canonical");
    type_into(&mut window, "W", "800 x 400");
    assert_eq!(window.state().document().camera.viewport.height, 0.5);
    type_into(&mut window, "height", "2");
    assert_eq!(window.state().document().camera.viewport.width, 4.0);
    window.get_by_label("Keep the pixels' shape").click();
    window.run();
    type_into(&mut window, "width", "2");
    assert_eq!(window.state().document().camera.viewport.height, 2.0);
    assert!(says(&window, "Pixels are 0.5 times as wide as high: spheres look stretched"));
    window.get_by_label("Keep the pixels' shape").click();
    window.run();
    type_into(&mut window, "width", "4");
    assert_eq!(window.state().document().camera.viewport.height, 4.0, "half as wide as before");
    window.get_by_label("Make pixels square").click();
    window.run();
    assert_eq!(window.state().document().camera.viewport.height, 2.0);
}

/// No field of view grows with the image, what was typed back is as before, and no image is a sliver.
#[test]
fn another_image_makes_no_field_of_view_larger() {
    let mut window = window("canonical");
    let seen = |window: &Harness<'_, App>| {
        let camera = window.state().document().camera;
        let viewport = [camera.viewport.width, camera.viewport.height];
        ([camera.image.width(), camera.image.height()], viewport)
    };
    for (field, text, expected) in [
        ("W", "8", ([8, 8], [1.0, 1.0])),
        ("H", "400", ([400, 400], [1.0, 1.0])),
        ("W", "400 x 100", ([400, 100], [1.0, 0.25])),
        ("H", "50", ([200, 50], [1.0, 0.25])),
        ("H", "100×100", ([100, 100], [1.0, 1.0])),
    ] {
        type_into(&mut window, field, text);
        assert_eq!(seen(&window), expected, "{field} = {text}");
    }
}

#[test]
fn an_image_that_is_none_is_refused() {
    let mut window = window("canonical");
    for (text, reason) in [
        ("0", "0 is not between 1 and 16384"),
        ("99999", "99999 is not between 1 and 16384"),
        ("2.5", "2.5 is not a whole number"),
    ] {
        type_into(&mut window, "W", text);
        assert_says(&window, reason);
        assert_eq!(window.state().document().camera.image.width(), 400);
    }
    type_into(&mut window, "W", "2*300");
    assert_eq!(window.state().document().camera.image.width(), 600);
}

#[test]
fn pixels_that_are_not_square_are_told_from_the_start() {
    assert!(says(
        &window("non-square"),
        "Pixels are 1.5 times as wide as high: spheres look stretched"
    ));
}

#[test]
fn the_field_of_view_is_shown_and_edited() {
    let mut window = window("canonical");
    let field = window.get_by_role_and_label(Role::SpinButton, "vertical field of view");
    assert_eq!(field.value().as_deref(), Some("53.13°"));
    type_into(&mut window, "vertical field of view", "90");
    let viewport = window.state().document().camera.viewport;
    assert!((viewport.height - 2.0).abs() < 1e-15 && viewport.distance == 1.0, "{viewport:?}");
    type_into(&mut window, "vertical field of view", "180");
    assert_eq!(window.state().document().camera.viewport, viewport, "nothing is taken over");
    assert_says(&window, "180 is not between 1e−6 and 179.999");
}

#[test]
fn one_button_brings_the_canonical_camera_back() {
    let mut window = window("look-at");
    window.get_by_label("Canonical camera").click();
    window.run();
    assert_eq!(window.state().document().camera, Camera::CANONICAL);
}

#[test]
fn objects_are_added_edited_and_removed() {
    let mut window = window("canonical");
    let objects = window.state().document().object_count();
    window.get_by_label("+ Sphere").click();
    window.run();
    let spheres = window.state().document().spheres.len();
    type_into(&mut window, "centre x", "2");
    type_into(&mut window, "radius", "1/4");
    let name = window.get_by_role_and_label(Role::TextInput, "name");
    name.focus();
    name.type_text("pea");
    window.run();
    let pea = &window.state().document().spheres[spheres - 1];
    assert_eq!((pea.shape.center.x, pea.shape.radius), (2.0, 0.25));
    assert_eq!(pea.name.as_deref(), Some("pea"));
    window.get_by_label("+ Plane").click();
    window.run();
    type_into(&mut window, "normal x", "1");
    type_into(&mut window, "point y", "-3");
    let plane = window.state().document().planes.last().unwrap().shape;
    assert_eq!((plane.normal.x, plane.point.y), (1.0, -3.0));
    window.get_by_label("Delete").click();
    window.run();
    assert_eq!(window.state().document().object_count(), objects + 1);
}

#[test]
fn the_chosen_object_is_duplicated_and_deleted_by_keys_and_comes_back() {
    let mut window = window("canonical");
    let before = window.state().document().clone();
    for title in ["sphere 0 “ball”", "plane 2 “back wall”"] {
        choose_object(&mut window, title);
        window.key_press_modifiers(Modifiers::COMMAND, Key::D);
        window.run();
        assert_eq!(window.state().document().object_count(), before.object_count() + 1);
        window.key_press(Key::Delete);
        window.run();
        assert_eq!(*window.state().document(), before, "the copy is deleted, not the original");
        choose_object(&mut window, title);
        window.key_press(Key::Delete);
        window.run();
        assert_eq!(window.state().document().object_count(), before.object_count() - 1);
        window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        window.run();
        assert_eq!(*window.state().document(), before);
    }
    choose_object(&mut window, "sphere 0 “ball”");
    window.key_press_modifiers(Modifiers::COMMAND, Key::D);
    window.run();
    let spheres = &window.state().document().spheres;
    let [ball, copy] = [spheres[0].shape, spheres.last().unwrap().shape];
    assert_eq!(
        (copy.radius, copy.center),
        (ball.radius, ball.center + DVec3::X * 2.0 * ball.radius)
    );
}

#[test]
fn a_key_for_the_chosen_object_says_that_none_is_chosen() {
    let mut window = window("canonical");
    for (modifiers, key) in [(Modifiers::NONE, Key::Delete), (Modifiers::COMMAND, Key::D)] {
        window.key_press_modifiers(modifiers, key);
        window.step();
        window.step();
        assert_says(&window, "No object is chosen");
        window.run_ok();
    }
}

#[test]
fn delete_leaves_the_scene_alone_while_another_page_is_shown() {
    let mut window = window("canonical");
    choose_object(&mut window, "sphere 0 “ball”");
    let before = window.state().document().clone();
    for layout in [ViewLayout::Exercises, ViewLayout::Lines] {
        show(&mut window, layout);
        window.key_press(Key::Delete);
        window.run_ok();
        window.key_press_modifiers(Modifiers::COMMAND, Key::D);
        window.run_ok();
        assert_eq!(*window.state().document(), before, "{layout:?}");
    }
}

#[test]
fn a_new_scene_is_empty_and_has_the_canonical_camera() {
    let mut window = window("look-at");
    window.key_press_modifiers(Modifiers::COMMAND, Key::N);
    window.run();
    let document = window.state().document();
    assert_eq!((document.camera, document.object_count()), (Camera::CANONICAL, 0));
    assert_says(&window, "Nothing to see yet: add a sphere or a plane.");
}

#[test]
fn new_spheres_are_seen_and_touch_no_other() {
    let mut window = window("canonical");
    for _ in 0..9 {
        window.get_by_label("+ Sphere").click();
        window.run();
    }
    let document = window.state().document();
    let spheres: Vec<Sphere> = document.spheres.iter().map(|item| item.shape).collect();
    for (k, a) in spheres.iter().enumerate() {
        for b in &spheres[..k] {
            assert!(a.center.distance(b.center) > a.radius + b.radius, "{a:?}, {b:?}");
        }
    }
    let camera = document.camera.resolve().unwrap();
    for sphere in &spheres {
        let direction = sphere.center - camera.eye();
        let [x, y] = [direction.x / -direction.z, direction.y / -direction.z];
        assert!(direction.z < 0.0 && x.abs() < 0.5 && y.abs() < 0.5, "{sphere:?}");
    }
}

/// Rounding to whole pixels on the way does not bend the image's shape.
#[test]
fn an_image_that_is_dragged_small_and_large_again_has_its_shape() {
    let mut window = window("canonical");
    type_into(&mut window, "W", "400 x 300");
    let field = window.get_by_role_and_label(Role::SpinButton, "W").rect().center();
    let image = |window: &mut Harness<'_, App>, by: f32| {
        window.hover_at(field + egui::vec2(by, 0.0));
        window.run();
        let image = window.state().document().camera.image;
        [image.width(), image.height()]
    };
    image(&mut window, 0.0);
    window.drag_at(field);
    window.run();
    let smallest = image(&mut window, -500.0);
    assert_eq!(smallest, [1, 1]);
    let [width, height] = image(&mut window, -4.0);
    assert!(
        (390..400).contains(&width) && (height * 4).abs_diff(width * 3) <= 2,
        "{width} x {height}"
    );
}

/// Fields show rounded numbers. To walk through them is no edit, and what is typed replaces the whole number.
#[test]
fn tab_goes_through_fields_without_an_edit() {
    let mut window = window("canonical");
    type_into(&mut window, "distance", "1.3");
    let before = window.state().document().clone();
    let walk = |window: &mut Harness<'_, App>| {
        window.get_by_role_and_label(Role::SpinButton, "distance").click();
        window.run();
        for _ in 0..2 {
            window.key_press(Key::Tab);
            window.run();
        }
    };
    walk(&mut window);
    window.key_press(Key::Tab);
    window.run();
    assert_eq!(*window.state().document(), before);
    walk(&mut window);
    let fov = window.get_by_role_and_label(Role::SpinButton, "vertical field of view");
    assert!(fov.is_focused());
    window.event(egui::Event::Text("60".to_owned()));
    window.run();
    window.key_press(Key::Enter);
    window.run();
    let fov = window.state().document().camera.viewport.vertical_fov().to_degrees();
    assert!((fov - 60.0).abs() < 1e-9, "{fov}");
}

#[test]
fn a_new_sphere_has_finite_numbers_however_large_the_viewport() {
    let mut window = window("canonical");
    type_into(&mut window, "distance", "1e308");
    window.get_by_label("+ Sphere").click();
    window.run();
    let spheres = &window.state().document().spheres;
    assert_eq!(spheres.last().unwrap().shape.check(), Ok(()), "{spheres:?}");
}

#[test]
fn no_edit_of_the_viewport_makes_an_infinite_one() {
    let mut window = window("canonical");
    window.get_by_label("Keep the pixels' shape").click();
    window.run();
    for (field, number) in [("H", "800"), ("height", "1e300"), ("width", "1.7e308")] {
        type_into(&mut window, field, number);
    }
    window.get_by_label("Make pixels square").click();
    window.run();
    type_into(&mut window, "distance", "1e308");
    type_into(&mut window, "vertical field of view", "170");
    let viewport = window.state().document().camera.viewport;
    assert_eq!(viewport.check(), Ok(()), "{viewport:?}");
}

#[test]
fn long_numbers_push_nothing_aside() {
    let mut harness = window("canonical");
    let view = |harness: &Harness<'_, App>| {
        harness.get_by_role_and_label(Role::Image, "World view").rect()
    };
    let before = view(&harness);
    for (field, number) in [
        ("up x", "-0.0832932466688"),
        ("up y", "-1234567.25"),
        ("up z", "-1.23456789e-100"),
        ("eye x", "-1234567.25"),
        ("eye y", "-0.0832932466688"),
    ] {
        type_into(&mut harness, field, number);
        assert_eq!(view(&harness), before, "{field} = {number}");
    }
}
