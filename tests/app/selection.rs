//! Which ray is looked at: by mouse, by keys, by typing; and what the readouts say of it.

use egui::accesskit::Role;
use egui_kittest::kittest::Queryable as _;
use pinhole_core::{DVec2, Pixel, Selection};
use pinhole_figure::concept::Concept;
use pinhole_figure::overlay::world_position_of;

use super::harness::{assert_says, click_at, type_into, window};

#[test]
fn the_warm_up_is_selected_at_first_and_read_off() {
    let window = window("canonical");
    for text in [
        "u = (1, 0, 0)",
        "v = (0, 1, 0)",
        "w = (0, 0, 1)",
        "sensitivity = 1",
        "(u, v) = (0.2, −0.1)",
        "pixel = the corner of four pixels",
        "p = (0, 0, 0)",
        "d = (0.2, −0.1, −1)",
        "first hit (smallest t > 0)",
        "point = (1.2, −0.6, −6)",
        "t = 6",
    ] {
        assert_says(&window, text);
    }
}

#[test]
fn a_click_in_the_camera_view_selects_the_pixel_under_it() {
    let mut window = window("canonical");
    let rect = window.get_by_role_and_label(Role::Image, "Camera view").rect();
    let at = rect.min + egui::vec2(0.25, 0.75) * rect.size() + egui::vec2(0.3, 0.3);
    click_at(&mut window, at);
    assert_eq!(
        window.state().session().shown.selection,
        Selection::Pixel(Pixel { row: 300, column: 100 })
    );
    assert_says(&window, "pixel = row 300, column 100");
}

#[test]
fn arrow_keys_move_the_selection_and_stop_at_the_edge() {
    let mut window = window("canonical");
    type_into(&mut window, "row", "0");
    type_into(&mut window, "column", "5");
    let focused = window.get_by_role_and_label(Role::Image, "Camera view");
    focused.focus();
    window.run();
    for key in
        [egui::Key::ArrowUp, egui::Key::ArrowLeft, egui::Key::ArrowLeft, egui::Key::ArrowDown]
    {
        window.key_press(key);
        window.run();
    }
    assert_eq!(
        window.state().session().shown.selection,
        Selection::Pixel(Pixel { row: 1, column: 3 })
    );
}

#[test]
fn the_first_arrow_key_goes_its_own_way_from_a_corner_of_pixels() {
    // (0.2, −0.1) is where rows 239 and 240 meet columns 279 and 280.
    for (key, row, column) in [
        (egui::Key::ArrowUp, 239, 280),
        (egui::Key::ArrowDown, 240, 280),
        (egui::Key::ArrowLeft, 240, 279),
        (egui::Key::ArrowRight, 240, 280),
    ] {
        let mut window = window("canonical");
        window.get_by_role_and_label(Role::Image, "Camera view").focus();
        window.run();
        window.key_press(key);
        window.run();
        let selection = window.state().session().shown.selection;
        assert_eq!(selection, Selection::Pixel(Pixel { row, column }), "{key:?}");
    }
}

#[test]
fn a_ray_is_selected_by_typing_row_and_column_or_uv() {
    let mut window = window("canonical");
    type_into(&mut window, "row", "99");
    type_into(&mut window, "column", "199");
    assert_says(&window, "(u, v) = (−0.00125, 0.25125)");
    type_into(&mut window, "uv u", "0");
    type_into(&mut window, "uv v", "0");
    assert_says(&window, "d = (0, 0, −1)");
    let hits = window.state().derived().inspection.clone().unwrap();
    let t: Vec<f64> = hits.roots.iter().map(|root| root.t).collect();
    assert_eq!(t, [4.0, 6.0, 6.0]);
    assert_eq!(hits.first, Some(0));
}

#[test]
fn a_click_on_the_viewport_in_the_world_view_selects_its_pixel() {
    let mut window = window("canonical");
    let rect = window.get_by_role_and_label(Role::Image, "World view").rect();
    let derived = window.state().derived();
    let (resolved, frame) = (derived.resolved.unwrap(), derived.world_frame.clone().unwrap());
    let wanted = Pixel { row: 300, column: 120 };
    let point = resolved.viewport_point(resolved.uv_of_pixel(wanted));
    let DVec2 { x, y } = world_position_of(frame.camera(), point).unwrap();
    let at = rect.min + egui::vec2(x as f32, y as f32);
    window.drag_at(at);
    window.run();
    window.drop_at(at);
    window.run();
    let Selection::Pixel(pixel) = window.state().session().shown.selection else {
        panic!("no pixel")
    };
    // Seen from the side, a dot covers several pixels.
    let point = resolved.viewport_point(resolved.uv_of_pixel(pixel));
    let DVec2 { x, y } = world_position_of(frame.camera(), point).unwrap();
    let off = (rect.min + egui::vec2(x as f32, y as f32)).distance(at);
    assert!(off <= 1.0, "{pixel:?} is not {wanted:?}: {off} dots away");
}

#[test]
fn rows_and_columns_are_counted_as_the_course_does_when_asked() {
    let mut window = window("canonical");
    type_into(&mut window, "row", "99");
    type_into(&mut window, "column", "199");
    window.get_by_label("View").click();
    window.run();
    window.get_by_label("Numbers").click();
    window.run();
    window.get_by_label("Count rows and columns from 1").click();
    window.run();
    assert_says(&window, "pixel = row 100, column 200 (from 1)");
    let row = window.get_by_role_and_label(Role::SpinButton, "row");
    assert_eq!(row.value().as_deref(), Some("100"));
    assert_eq!(
        window.state().session().shown.selection,
        Selection::Pixel(Pixel { row: 99, column: 199 }),
        "the same pixel"
    );
}

#[test]
fn the_mouse_moves_the_observer_and_never_the_camera() {
    let mut window = window("canonical");
    let before = window.state().document().clone();
    let observer = window.state().session().shown.observer;
    let rect = window.get_by_role_and_label(Role::Image, "World view").rect();
    let from = rect.min + egui::vec2(40.0, 40.0);
    window.drag_at(from);
    window.run();
    window.hover_at(from + egui::vec2(60.0, 25.0));
    window.run();
    window.drop_at(from + egui::vec2(60.0, 25.0));
    window.run();
    let orbited = window.state().session().shown.observer;
    assert_ne!(orbited, observer, "a drag orbits");
    window.hover_at(from);
    window.run();
    window.event(egui::Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: egui::vec2(0.0, 80.0),
        modifiers: egui::Modifiers::NONE,
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
    });
    window.run();
    assert_ne!(window.state().session().shown.observer, orbited, "the wheel zooms");
    assert_eq!(*window.state().document(), before);
    window.key_press(egui::Key::F);
    window.run();
    assert_eq!(window.state().session().shown.observer, observer, "F frames all again");
}

#[test]
fn pointing_at_a_number_shows_it_in_both_views_and_dims_nothing() {
    for unfolded in [true, false] {
        let mut window = window("canonical");
        if !unfolded {
            window.get_by_label("Fewer numbers").click();
            window.run();
        }
        for (text, concept) in [
            ("u = (1, 0, 0)", Concept::U),
            ("w = (0, 0, 1)", Concept::W),
            ("t = 6", Concept::Root { object: 2, number: 0 }),
        ] {
            let number = window.query_all_by_value(text).next().unwrap().rect();
            window.hover_at(number.center());
            window.run();
            if concept == (Concept::Root { object: 2, number: 0 }) && unfolded {
                // Each object's roots are listed there, and say their own names.
                continue;
            }
            let session = window.state().session();
            assert_eq!(
                session.live.hovered.map(|hovered| hovered.concept),
                Some(concept),
                "{text}"
            );
            assert!(!session.dims(), "{text}");
        }
        window.hover_at(egui::Pos2::ZERO);
        window.run();
        assert_eq!(window.state().session().live.hovered, None);
    }
}

#[test]
fn arrow_keys_are_not_held_up_by_a_pointer_that_rests() {
    let mut window = window("canonical");
    let view = window.get_by_role_and_label(Role::Image, "Camera view").rect();
    click_at(&mut window, view.center());
    let clicked = window.state().session().shown_selection();
    for _ in 0..3 {
        window.key_press(egui::Key::ArrowRight);
        window.run();
    }
    let session = window.state().session();
    assert_ne!(session.shown.selection, clicked);
    assert_eq!(session.shown_selection(), session.shown.selection, "what the keys select is shown");
    window.hover_at(view.center() + egui::vec2(20.0, 5.0));
    window.run();
    let session = window.state().session();
    assert_ne!(
        session.shown_selection(),
        session.shown.selection,
        "a pointer that moves is followed"
    );
}

#[test]
fn the_pixel_that_is_pointed_at_is_the_one_that_is_seen_there() {
    let mut window = window("canonical");
    for zoom in [1.0, 1.7] {
        window.ctx.set_zoom_factor(zoom);
        window.run();
        let per_point = window.ctx.pixels_per_point();
        let rect = window.get_by_role_and_label(Role::Image, "Camera view").rect();
        let dots = (rect.width() * per_point).round() as u32;
        let corner = (rect.min.to_vec2() * per_point).round();
        for k in [100, 101, 102, 103, 104, 105, 106, 107] {
            // A mouse goes by whole dots: the upper left corner of the one under its tip.
            let at = (corner + egui::Vec2::splat(k as f32)) / per_point;
            window.hover_at(at.to_pos2());
            window.run();
            let shown = (2 * k + 1) * 400 / (2 * dots);
            let pixel = Pixel { row: shown, column: shown };
            let selected = window.state().session().shown_selection();
            assert_eq!(selected, Selection::Pixel(pixel), "dot {k} of {dots}");
        }
    }
}
