//! World views read as lists of marks and labels.

use pinhole_core::{Camera, DVec2, DVec3, Orientation, Plane, Scene};

use super::*;

/// Returns the lines of an item from left to right, each as `-` (or `.` if hidden) and its two ends.
fn runs(drawing: &Drawing, item: Item) -> Vec<(char, i64, i64)> {
    let lines = drawing.marks.iter().filter(|mark| {
        mark.item == item && matches!(&mark.shape, Shape::Line { points, .. } if points.len() == 2)
    });
    let mut runs: Vec<_> = lines
        .map(|mark| {
            let ends = points(mark);
            let whole = |x: f32| x.round() as i64;
            (if mark.hidden { '.' } else { '-' }, whole(ends[0][0]), whole(ends[1][0]))
        })
        .collect();
    runs.sort_by_key(|(_, from, _)| *from);
    runs
}

#[test]
fn a_ray_behind_a_sphere_is_dashed_there() {
    // The sphere of radius 0.5 is half way to the ray, so it covers 2 of the ray's 10 units.
    let scene = Scene::new(vec![sphere(5.0, 0.0, -5.0, 0.5)], vec![]).expect("a scene");
    let observer = from_the_right(DVec3::new(0.0, 0.0, -5.0), 10.0);
    let mut stage = Stage::seen_by(Camera::CANONICAL, scene, observer);
    stage.items = OverlayItems::NONE.with(Item::Ray, true);
    let ray = Inspection::new(stage.resolve(), &stage.scene, Selection::Uv(DVec2::ZERO));
    assert_eq!(ray.first, None);
    stage.inspection = Some(Arc::new(ray));
    let drawing = stage.drawing();
    // The observer's tangents to the sphere, whose centre is 5 away, meet the ray at
    // 10 * 0.5 / sqrt(25 - 0.25) from the middle.
    let half = 10.0 * 0.5 / (24.75f64).sqrt();
    let to_screen = |z: f64| stage.to_screen(DVec3::new(0.0, 0.0, z)).x.round() as i64;
    let [eye, from, to] = [0.0, half - 5.0, -half - 5.0].map(to_screen);
    // The selected pixel's frame is one screen pixel wide.
    let long = |(_, from, to): &(char, i64, i64)| to - from > 5;
    let found: Vec<_> = runs(&drawing, Item::Ray).into_iter().filter(long).collect();
    let kinds: String = found.iter().map(|run| run.0).collect();
    assert_eq!(kinds, "-.-");
    assert_eq!(found[0].1, eye);
    for (end, expected) in [(found[0].2, from), (found[1].1, from), (found[1].2, to)] {
        assert!((end - expected).abs() <= 2, "{found:?} {from} {to}");
    }
}

#[test]
fn a_ray_is_solid_up_to_its_hit_and_dashed_behind_it() {
    let scene = Scene::new(vec![sphere(-2.0, 0.0, -3.0, 1.0), sphere(0.0, 0.0, -7.0, 1.0)], vec![])
        .expect("a scene");
    let observer = from_the_right(DVec3::new(0.0, 0.0, -4.0), 14.0);
    let mut stage = Stage::seen_by(Camera::CANONICAL, scene, observer);
    stage.items = OverlayItems::NONE.with(Item::Ray, true);
    stage.inspection =
        Some(Arc::new(Inspection::new(stage.resolve(), &stage.scene, Selection::Uv(DVec2::ZERO))));
    let to_screen = |z: f64| stage.to_screen(DVec3::new(0.0, 0.0, z)).x.round() as i64;
    let ray: Vec<_> = runs(&stage.drawing(), Item::Ray)
        .into_iter()
        .filter(|(_, from, to)| to - from > 20)
        .collect();
    // The dashed part leaves the ball at z = -8 and ends half a radius beyond.
    let [eye, hit, end] = [0.0, -6.0, -8.5].map(to_screen);
    assert_eq!(ray, [('-', eye, hit), ('.', hit, end)]);
}

#[test]
fn the_picture_hides_what_is_behind_it_and_not_what_is_drawn_on_it() {
    let stage = canonical();
    let drawing = stage.drawing();
    let hidden = |item: Item| drawing.marks.iter().any(|m| m.item == item && m.hidden);
    assert!(hidden(Item::Ray));
    assert!(!hidden(Item::Viewport));
    assert!(!hidden(Item::Marks));
    assert!(!hidden(Item::Basis));
}

#[test]
fn a_wall_between_observer_and_camera_does_not_hide_the_camera() {
    let camera = Camera::CANONICAL;
    let behind = Plane { point: DVec3::new(0.0, 0.0, 2.0), normal: DVec3::Z };
    let scene = Scene::new(vec![], vec![behind]).expect("a scene");
    let observer = Observer::new(DVec3::ZERO, 0.3, 0.3, 8.0);
    let stage = Stage::seen_by(camera, scene, observer);
    let drawing = stage.drawing();
    let basis: Vec<_> = drawing.marks.iter().filter(|m| m.item == Item::Basis).collect();
    assert!(!basis.is_empty() && basis.iter().all(|mark| !mark.hidden));
    let mut eye = drawing.marks.iter().filter(|m| m.item == Item::Eye);
    assert!(eye.any(|mark| matches!(mark.shape, Shape::Disc { .. })), "no ring");
}

#[test]
fn lines_behind_a_wall_are_dashed() {
    let wall = Plane { point: DVec3::new(0.0, 0.0, -4.0), normal: DVec3::Z };
    let scene = Scene::new(vec![], vec![wall]).expect("a scene");
    let at = DVec3::new(0.0, 0.0, -5.0);
    let camera = Camera { orientation: Orientation::At { at, up: DVec3::Y }, ..Camera::CANONICAL };
    let stage = Stage::seen_by(camera, scene, Observer::new(DVec3::ZERO, 0.6, 0.3, 14.0));
    let drawing = stage.drawing();
    let at = drawing.marks.iter().find(|m| m.item == Item::At).map(|m| &m.shape);
    assert!(matches!(at, Some(Shape::Line { .. })), "a ring, not {at:?}");
}

#[test]
fn each_item_can_be_drawn_alone_and_left_out() {
    let mut stage = canonical();
    stage.items = OverlayItems::ALL;
    let eye = HandleMark { at: DVec3::ZERO, knob: Knob::Round, state: KnobState::Plain };
    let handles = vec![eye];
    let of_marks = |stage: &Stage| {
        let view = WorldView { handles: handles.clone(), ..stage.view() };
        let Drawing { marks, labels, .. } = view.drawing(stage.scene());
        let items: Vec<Item> =
            marks.iter().map(|m| m.item).chain(labels.iter().map(|l| l.item)).collect();
        items
    };
    let all = of_marks(&stage);
    // These items have no marks of their own in the world view.
    let filled = [Item::Picture, Item::PixelGrid, Item::UvAxes, Item::Labels, Item::Loupe];
    for item in Item::ALL {
        // All items together leave no room for numbers in so small a picture, and draw u and w as a basis.
        if ![Item::PixelNumbers, Item::U, Item::W].contains(&item) {
            assert_eq!(all.contains(&item), !filled.contains(&item), "{item:?}");
        }
        stage.items = OverlayItems::NONE.with(item, true).with(Item::Labels, true);
        let alone = of_marks(&stage);
        assert!(alone.iter().all(|other| *other == item), "{item:?}: {alone:?}");
        assert_eq!(alone.is_empty(), filled.contains(&item), "{item:?}");
        stage.items = OverlayItems::ALL.with(item, false);
        assert!(!of_marks(&stage).contains(&item), "{item:?}");
    }
}

#[test]
fn handles_keep_their_size_and_stand_out_by_form() {
    let stage = canonical();
    let mark = |at: DVec3, state: KnobState| {
        let handles = vec![HandleMark { at, knob: Knob::Round, state }];
        let drawing = WorldView { handles, ..stage.view() }.drawing(stage.scene());
        let own = drawing.marks.into_iter().filter(|mark| mark.item == Item::Handles);
        own.map(|mark| mark.shape).collect::<Vec<_>>()
    };
    let radii = |shapes: &[Shape]| -> Vec<f32> {
        let radius = |shape: &Shape| match shape {
            Shape::Disc { radius, .. } => Some(*radius),
            _ => None,
        };
        shapes.iter().filter_map(radius).collect()
    };
    let near = mark(DVec3::ZERO, KnobState::Plain);
    let far = mark(DVec3::new(0.0, 0.0, -5.0), KnobState::Plain);
    assert_eq!(radii(&near), radii(&far));
    let (over, held) = (mark(DVec3::ZERO, KnobState::Over), mark(DVec3::ZERO, KnobState::Held));
    assert!(radii(&over)[0] > radii(&near)[0]);
    // A held handle is full, with a ring around it.
    assert_eq!((radii(&near).len(), radii(&over).len(), radii(&held).len()), (2, 2, 1));
    assert_eq!(held.len(), 2);
}

#[test]
fn labels_name_everything_in_the_canonical_scene() {
    // The picture is small, and so are all lengths that are measured in points.
    let stage = canonical();
    let drawing = WorldView { scale: 0.3, ..stage.view() }.drawing(stage.scene());
    let mut texts: Vec<&str> = drawing.labels.iter().map(|label| label.text.as_str()).collect();
    texts.sort_unstable();
    let expected = ["at", "eye", "hit", "n", "u", "up", "v", "view", "w", "x", "y", "z"];
    assert!(expected.iter().all(|text| texts.contains(text)), "{texts:?}");
    check_labels(&drawing, DVec2::new(SIZE.0.into(), SIZE.1.into()));
}

#[test]
fn a_camera_without_a_basis_is_drawn_as_far_as_it_is_known() {
    let camera = Camera {
        orientation: Orientation::At { at: DVec3::new(0.0, 3.0, 0.0), up: DVec3::Y },
        ..Camera::CANONICAL
    };
    let stage = Stage::new(camera, vec![sphere(0.0, 0.0, -5.0, 1.0)], vec![]);
    assert_eq!(stage.resolved, None);
    let drawing = stage.drawing();
    let has = |item: Item| drawing.marks.iter().any(|mark| mark.item == item);
    assert!(has(Item::Eye) && has(Item::At) && has(Item::ViewAndUp));
    assert!(!has(Item::Basis) && !has(Item::Frustum) && !has(Item::Viewport));
}
