//! Tests the marks that explain the camera: each is where the camera's numbers put it.

use pinhole_core::{Camera, DVec2, DVec3, Orientation, Scene};

use super::*;

/// Returns a stage that shows one item and its labels.
fn stage(camera: Camera, item: Item) -> Stage {
    let observer = Observer::new(DVec3::new(0.0, 0.0, -1.5), 0.8, 0.4, 9.0);
    let mut stage = Stage::seen_by(camera, Scene::default(), observer);
    stage.items = OverlayItems::NONE.with(item, true).with(Item::Labels, true);
    stage
}

fn texts(drawing: &Drawing) -> Vec<&str> {
    drawing.labels.iter().map(|label| label.text.as_str()).collect()
}

/// Returns true if a corner of a mark is at a point of the world.
fn reaches(stage: &Stage, drawing: &Drawing, at: DVec3) -> bool {
    let expected = stage.to_screen(at);
    drawing.marks.iter().flat_map(points).any(|point| wide(point).distance(expected) < 0.2)
}

#[test]
fn the_ring_goes_from_u_to_v_to_w_and_the_angles_are_squares() {
    let stage = stage(Camera::CANONICAL, Item::Ring);
    let drawing = small_drawing(&stage);
    let length = arrow_length(stage.frame.camera(), DVec3::ZERO, 0.25, false);
    let heads = || drawing.marks.iter().filter(|mark| matches!(mark.shape, Shape::Polygon { .. }));
    assert_eq!(heads().count(), 3);
    for (from, to) in [(DVec3::X, DVec3::Y), (DVec3::Y, DVec3::Z), (DVec3::Z, DVec3::X)] {
        // The tip of each head is 80 degrees from where its arc begins, and so 10 degrees before the end.
        let (sin, cos) = 80f64.to_radians().sin_cos();
        let tip = stage.to_screen(0.55 * length * (cos * from + sin * to));
        assert!(heads().any(|head| wide(points(head)[0]).distance(tip) < 0.2), "{from} {to}");
    }
    let square = Stage { items: OverlayItems::NONE.with(Item::RightAngles, true), ..stage };
    let drawing = small_drawing(&square);
    for corner in [DVec3::new(1.0, 1.0, 0.0), DVec3::new(0.0, 1.0, 1.0), DVec3::new(1.0, 0.0, 1.0)]
    {
        assert!(reaches(&square, &drawing, 0.17 * length * corner), "{corner}");
    }
}

#[test]
fn both_products_are_areas() {
    let orientation = Orientation::View { view: DVec3::NEG_Z, up: DVec3::new(0.0, 1.0, 1.0) };
    for (item, corner, expected) in [
        (Item::UpCrossW, DVec3::new(0.0, 1.0, 2.0), "|up × w| = 1 ≈ 1.414 · sin(45°)"),
        (Item::WCrossU, DVec3::new(1.0, 0.0, 1.0), "|w × u| = 1 = sin(90°)"),
    ] {
        let stage = stage(Camera { orientation, ..Camera::CANONICAL }, item);
        let drawing = small_drawing(&stage);
        let length = arrow_length(stage.frame.camera(), DVec3::ZERO, 0.25, false);
        assert!(reaches(&stage, &drawing, length * corner), "{corner}");
        assert_eq!(texts(&drawing), [expected]);
    }
    // A long or a short up is drawn with another length, but its area is its own.
    for (up, expected) in [
        (DVec3::new(0.0, 3.0, 4.0), "|up × w| = 3 ≈ 5 · sin(36.87°)"),
        (DVec3::new(0.0, 0.125, 0.0), "|up × w| = 0.125 = 0.125 · sin(90°)"),
    ] {
        let orientation = Orientation::View { view: DVec3::NEG_Z, up };
        let stage = stage(Camera { orientation, ..Camera::CANONICAL }, Item::UpCrossW);
        assert_eq!(texts(&small_drawing(&stage))[0], expected);
    }
}

#[test]
fn view_goes_from_the_eye_to_at_and_minus_view_back() {
    let at = DVec3::new(0.5, 0.2, -3.0);
    let camera = Camera { orientation: Orientation::At { at, up: DVec3::Y }, ..Camera::CANONICAL };
    let stage = stage(camera, Item::ViewVector);
    let drawing = small_drawing(&stage);
    assert_eq!(texts(&drawing), ["view = at − eye", "−view"]);
    let heads: Vec<DVec2> = drawing
        .marks
        .iter()
        .filter(|mark| matches!(mark.shape, Shape::Polygon { .. }))
        .map(|mark| wide(points(mark)[0]))
        .collect();
    let [view, back] = heads[..] else { panic!("{heads:?}") };
    assert!(view.distance(stage.to_screen(at)) < 0.1, "to at");
    let eye = stage.to_screen(DVec3::ZERO);
    assert!((1.0..6.0).contains(&back.distance(eye)), "beside the eye");
    let stage = Stage { items: stage.items.with(Item::ViewAndUp, true), ..stage };
    assert!(!texts(&small_drawing(&stage)).contains(&"view"), "no stub beside the whole vector");
}

#[test]
fn the_viewport_has_its_measures_and_the_point_its_legs() {
    let mut camera = Camera::CANONICAL;
    camera.viewport.width = 1.5;
    camera.viewport.distance = 2.0;
    let mut measured = stage(camera, Item::Measures);
    let texts_of = |drawing: &Drawing| {
        let mut texts: Vec<String> = texts(drawing).into_iter().map(str::to_owned).collect();
        texts.sort_unstable();
        texts
    };
    let drawn = small_drawing(&measured);
    assert_eq!(texts_of(&drawn), ["distance = 2", "height = 1", "width = 1.5"]);
    for at in [(-0.75, -0.64), (0.75, -0.64), (0.89, -0.5), (0.89, 0.5), (0.0, 0.0)] {
        assert!(reaches(&measured, &drawn, DVec3::new(at.0, at.1, -2.0)), "{at:?}");
    }
    measured.items = OverlayItems::NONE.with(Item::UvLegs, true).with(Item::Labels, true);
    let selection = Selection::Uv(DVec2::new(0.4, -0.3));
    let ray = Inspection::new(measured.resolve(), &measured.scene, selection);
    measured.inspection = Some(Arc::new(ray));
    let drawn = small_drawing(&measured);
    assert_eq!(texts_of(&drawn), ["u = 0.4", "v = −0.3"]);
    for at in [(0.0, 0.0), (0.4, 0.0), (0.4, -0.3)] {
        assert!(reaches(&measured, &drawn, DVec3::new(at.0, at.1, -2.0)), "{at:?}");
    }
}

#[test]
fn rows_and_columns_are_numbered_beside_their_pixels() {
    let mut camera = Camera::CANONICAL;
    camera.image = image(4, 3);
    let stage = stage(camera, Item::PixelNumbers);
    let numbered = |first_number: u32| {
        let view = WorldView { scale: 0.1, first_number, ..stage.view() };
        let drawing = view.drawing(stage.scene());
        check_labels(&drawing, DVec2::new(SIZE.0.into(), SIZE.1.into()));
        drawing
    };
    let drawing = numbered(0);
    assert_eq!(texts(&drawing), ["0", "1", "2", "3", "0", "1", "2", "W = 4", "H = 3"]);
    let at = |u: f64, v: f64| stage.to_screen(DVec3::new(u, v, -1.0));
    let columns = (0..4).map(|k| at(0.25 * f64::from(k) - 0.375, 0.5));
    let rows = (0..3).map(|k| at(-0.5, 1.0 / 3.0 - f64::from(k) / 3.0));
    for (label, edge) in drawing.labels.iter().zip(columns.chain(rows)) {
        let apart = wide(label.position).distance(edge);
        assert!((0.5..3.0).contains(&apart), "{}: {apart}", label.text);
    }
    assert_eq!(texts(&numbered(1)), ["1", "2", "3", "4", "1", "2", "3", "W = 4", "H = 3"]);
}

#[test]
fn a_small_camera_has_a_body_only_if_nothing_else_shows_where_it_looks() {
    let observer = Observer::new(DVec3::ZERO, 0.8, 0.4, 60.0);
    let stage = Stage::seen_by(Camera::CANONICAL, Scene::default(), observer);
    let triangles = |items: OverlayItems| {
        let drawing = stage.view_of(|figure| figure.items = items).drawing(stage.scene());
        let of_eye = drawing.marks.into_iter().filter(|mark| mark.item == Item::Eye);
        of_eye.filter(|mark| matches!(mark.shape, Shape::Polygon { .. })).count()
    };
    let alone = OverlayItems::NONE.with(Item::Eye, true).with(Item::Viewport, true);
    assert!(triangles(alone) > 0);
    for item in [Item::Basis, Item::ViewAndUp, Item::Frustum] {
        assert_eq!(triangles(alone.with(item, true)), 0, "{item:?}");
    }
}
