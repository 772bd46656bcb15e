//! Tests highlighting: a concept is drawn again over everything else, which is dimmed.

use pinhole_core::Orientation;

use super::*;
use crate::concept::{Concept, Concepts};

/// Concepts that both views show on the canonical stage, except its wall: see below.
const CONCEPTS: [Concept; 21] = [
    Concept::Eye,
    Concept::At,
    Concept::View,
    Concept::Up,
    Concept::Backwards,
    Concept::U,
    Concept::V,
    Concept::W,
    Concept::UpCrossW,
    Concept::WCrossU,
    Concept::Viewport,
    Concept::Distance,
    Concept::Pixel,
    Concept::AlongU,
    Concept::AlongV,
    Concept::AlongW,
    Concept::Direction,
    Concept::Ray,
    Concept::Object(0),
    Concept::Root { object: 0, number: 1 },
    Concept::Normal,
];

fn highlighted(stage: &Stage, concept: Concept) -> Option<Highlighted> {
    Some(Highlighted {
        concept,
        camera: stage.camera,
        digits: 5,
        dims: true,
        is_of_step: false,
        spoken: Concepts::default(),
        growth: 1.0,
    })
}

fn world_drawing(stage: &Stage, concept: Concept) -> Drawing {
    let view = stage.view_of(|figure| figure.highlighted = highlighted(stage, concept));
    WorldView { scale: 0.3, ..view }.drawing(stage.scene())
}

fn camera_drawing(stage: &Stage, concept: Option<Concept>) -> Drawing {
    CameraView {
        resolved: *stage.resolve(),
        picture: Same(stage.picture.clone().expect("a picture")),
        inspection: stage.inspection.clone().map(Same),
        size: [240, 240],
        items: stage.items,
        first_number: 0,
        scale: 0.5,
        style: Style::Dark,
        highlighted: concept.and_then(|concept| highlighted(stage, concept)),
        loupe: None,
        without_marks: false,
    }
    .drawing(Some(&stage.scene))
}

#[test]
fn every_thing_is_lit_in_the_views_that_can_show_it() {
    let stage = canonical();
    for concept in CONCEPTS {
        let world = world_drawing(&stage, concept);
        assert!(world.marks.iter().any(|mark| mark.concept == Some(concept)), "{concept:?}");
        check_labels(&world, DVec2::new(SIZE.0.into(), SIZE.1.into()));
        let camera = camera_drawing(&stage, Some(concept));
        assert!(camera.marks.iter().any(|mark| mark.concept == Some(concept)), "{concept:?}");
        check_labels(&camera, DVec2::splat(240.0));
    }
    let nowhere = camera_drawing(&stage, Some(Concept::Object(99)));
    assert_eq!(nowhere, camera_drawing(&stage, None));
}

#[test]
fn a_plane_is_hatched_where_it_is_seen() {
    let stage = canonical();
    let resolved = stage.resolve();
    let wall = stage.scene.spheres().len() as u32;
    let drawing = camera_drawing(&stage, Some(Concept::Object(wall)));
    let plain = camera_drawing(&stage, None);
    let count = drawing.marks.len() - plain.marks.len();
    assert_eq!(drawing.marks[count..], plain.marks, "what lies on the plane stays as it is");
    // The casing of all strokes lies below them.
    let strokes = &drawing.marks[count / 2..count];
    let mut seen = 0;
    for stroke in strokes {
        let [from, to] = [points(stroke)[0], points(stroke)[1]];
        let at = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
        let uv = camera_uv_at(resolved, [240, 240], at);
        let hit = stage.scene.first_hit_of(&resolved.exact_ray_at(uv).expect("a ray"));
        // Strokes that only touch the border may end next to it.
        if (to[0] - from[0]).abs() > 8.0 {
            assert_eq!(hit.map(|hit| hit.object), Some(wall), "{at:?}");
            seen += 1;
        }
    }
    assert!(seen > 10, "{seen}");
}

#[test]
fn what_is_lit_needs_no_item_and_the_rest_is_dimmed() {
    let mut stage = canonical();
    let plain = stage.drawing();
    let ink = |drawing: &Drawing| {
        drawing.marks.iter().find(|mark| mark.item == Item::Frustum).map(|mark| mark.color)
    };
    let dimmed = ink(&world_drawing(&stage, Concept::W)).expect("a frustum");
    assert!(dimmed.a() < ink(&plain).expect("a frustum").a());
    stage.items = OverlayItems::NONE;
    assert!(stage.drawing().marks.is_empty());
    let highlighted = world_drawing(&stage, Concept::W);
    assert!(
        highlighted.marks.iter().all(|mark| mark.concept == Some(Concept::W))
            && !highlighted.marks.is_empty()
    );
}

#[test]
fn a_cross_product_shows_its_factors_its_parallelogram_and_its_area() {
    let up = DVec3::new(0.0, 1.0, 1.0);
    let at = DVec3::new(0.0, 0.0, -1.0);
    let camera = Camera { orientation: Orientation::At { at, up }, ..Camera::CANONICAL };
    let observer = Observer::new(DVec3::ZERO, 0.9, 0.5, 6.0);
    let stage = Stage::seen_by(camera, Scene::default(), observer);
    let drawing = world_drawing(&stage, Concept::UpCrossW);
    let texts: Vec<&str> = drawing.labels.iter().map(|label| label.text.as_str()).collect();
    for text in ["up", "w", "up × w", "|up × w| = 1 ≈ 1.414 · sin(45°)"] {
        assert!(texts.contains(&text), "{text}: {texts:?}");
    }
    let fill = drawing.marks.iter().find(|mark| {
        mark.concept == Some(Concept::UpCrossW)
            && matches!(&mark.shape, Shape::Polygon { points } if points.len() == 4)
    });
    let fill = fill.expect("a parallelogram");
    assert!(fill.color.a() < 128, "one sees through it");
    let [eye, a, far, b]: [DVec2; 4] = points(fill)
        .into_iter()
        .map(|[x, y]| DVec2::new(x.into(), y.into()))
        .collect::<Vec<_>>()
        .try_into()
        .expect("four corners");
    assert!(eye.distance(stage.to_screen(DVec3::ZERO)) < 0.01);
    // Up and w point in the right directions, and the far corner is at the sum of both.
    let toward = |from: DVec2, to: DVec2| (to - from).normalize();
    let seen = |point: DVec3| toward(eye, stage.to_screen(point));
    assert!(toward(eye, a).distance(seen(0.1 * up)) < 0.05);
    assert!(toward(eye, b).distance(seen(0.1 * DVec3::Z)) < 0.05);
    let together = 0.1 * (up + DVec3::Z);
    assert!(toward(eye, far).distance(seen(together)) < 0.05);
}

#[test]
fn products_are_named_with_the_letters_of_their_factors() {
    let up = DVec3::new(0.0, 1.0, 1.0);
    let at = DVec3::new(0.0, 0.0, -1.0);
    let camera = Camera { orientation: Orientation::At { at, up }, ..Camera::CANONICAL };
    let stage = Stage::seen_by(camera, Scene::default(), Observer::new(DVec3::ZERO, 0.9, 0.5, 6.0));
    for (concept, product) in [(Concept::UpCrossW, "up × w"), (Concept::WCrossU, "w × u = v")] {
        let drawing = camera_drawing(&stage, Some(concept));
        for text in [product, "w"] {
            let label = drawing.labels.iter().find(|label| label.text == text);
            let label = label.unwrap_or_else(|| panic!("{text}: {:?}", drawing.labels));
            assert!(label.bold, "{text}");
        }
    }
}

/// Only the part of the parallelogram inside the picture is filled.
#[test]
fn a_parallelogram_that_leaves_the_picture_is_cut_off() {
    let orientation = Orientation::At { at: DVec3::NEG_Z, up: DVec3::new(0.0, 1.0, 1.0) };
    let camera = Camera { orientation, ..Camera::CANONICAL };
    let filled = |target: DVec3| {
        let stage = Stage::seen_by(camera, Scene::default(), Observer::new(target, 0.9, 0.3, 6.0));
        let drawing = world_drawing(&stage, Concept::UpCrossW);
        let mut polygons = drawing.marks.into_iter().filter_map(|mark| match mark.shape {
            Shape::Polygon { points } if mark.color.a() < 128 => Some(points),
            _ => None,
        });
        polygons.next_back()
    };
    let height = |points: &[[f32; 2]]| {
        let ys = points.iter().map(|[_, y]| *y);
        ys.clone().fold(f32::MIN, f32::max) - ys.fold(f32::MAX, f32::min)
    };
    let whole = filled(DVec3::ZERO).expect("all of it");
    let cut = filled(DVec3::new(0.0, -1.7, 0.0)).expect("a part of it");
    assert_eq!(whole.len(), 4);
    assert!(height(&cut) > 5.0 && height(&cut) < 0.9 * height(&whole), "{whole:?} {cut:?}");
    assert_eq!(filled(DVec3::new(0.0, -9.0, 0.0)), None);
}

#[test]
fn the_parts_of_a_direction_lead_from_the_eye_to_the_viewport() {
    let observer = Observer::new(DVec3::ZERO, 0.9, 0.5, 3.0);
    let mut stage = Stage::seen_by(Camera::CANONICAL, Scene::default(), observer);
    let uv = DVec2::new(0.45, 0.4);
    let inspection = Inspection::new(stage.resolve(), &stage.scene, Selection::Uv(uv));
    stage.inspection = Some(Arc::new(inspection));
    let drawing = world_drawing(&stage, Concept::AlongU);
    for concept in [Concept::AlongU, Concept::AlongV, Concept::AlongW] {
        assert!(drawing.marks.iter().any(|mark| mark.concept == Some(concept)), "{concept:?}");
    }
    let widths = |concept: Concept| {
        drawing.marks.iter().filter(move |mark| mark.concept == Some(concept)).filter_map(|mark| {
            match &mark.shape {
                Shape::Line { width, .. } => Some(*width),
                _ => None,
            }
        })
    };
    let widest = |concept| widths(concept).fold(0.0, f32::max);
    assert!(widest(Concept::AlongU) > widest(Concept::AlongW));
}

#[test]
fn without_a_basis_the_flat_parallelogram_is_still_drawn() {
    let camera = Camera {
        orientation: Orientation::At { at: DVec3::new(0.0, 3.0, 0.0), up: DVec3::Y },
        ..Camera::CANONICAL
    };
    let stage = Stage::new(camera, vec![sphere(0.0, 0.0, -5.0, 1.0)], vec![]);
    let drawing = world_drawing(&stage, Concept::UpCrossW);
    let texts: Vec<&str> = drawing.labels.iter().map(|label| label.text.as_str()).collect();
    for text in ["|up × w| = 0 = sin(180°)", "up", "w"] {
        assert!(texts.contains(&text), "{text}: {texts:?}");
    }
    assert!(
        world_drawing(&stage, Concept::U).marks.iter().all(|mark| mark.concept != Some(Concept::U))
    );
}

#[test]
fn a_normal_on_a_wall_is_lit_in_both_views_whatever_is_shown() {
    let wall = Plane { point: DVec3::new(0.0, 0.0, -6.0), normal: DVec3::Z };
    let observer = Observer::new(DVec3::new(0.0, 0.0, -3.0), 0.9, 0.5, 12.0);
    let scene = Scene::new(Vec::new(), vec![wall]).expect("a scene");
    let mut stage = Stage::seen_by(Camera::CANONICAL, scene, observer);
    for items in [OverlayItems::default(), OverlayItems::NONE] {
        stage.items = items;
        for drawing in
            [world_drawing(&stage, Concept::Normal), camera_drawing(&stage, Some(Concept::Normal))]
        {
            let mut lit = drawing.marks.iter().filter(|mark| mark.concept == Some(Concept::Normal));
            assert!(lit.next().is_some());
        }
    }
}

#[test]
fn numbers_of_rows_and_columns_are_dimmed_like_other_labels() {
    let mut stage = canonical();
    stage.camera.image = image(4, 4);
    stage.resolved = stage.camera.resolve().ok();
    stage.items = stage.items.with(Item::PixelNumbers, true);
    let color = |drawing: &Drawing| {
        let number = drawing.labels.iter().find(|label| label.item == Item::PixelNumbers);
        number.expect("a number").color
    };
    let plain = WorldView { scale: 0.1, ..stage.view() }.drawing(stage.scene());
    let dimmed = stage.view_of(|figure| figure.highlighted = highlighted(&stage, Concept::W));
    let dimmed = WorldView { scale: 0.1, ..dimmed };
    assert_ne!(color(&plain), color(&dimmed.drawing(stage.scene())));
}

#[test]
fn the_product_of_a_long_up_stays_in_the_camera_view() {
    let orientation = Orientation::View { view: DVec3::NEG_Z, up: DVec3::new(0.0, 2.0, 0.0) };
    let camera = Camera { orientation, ..Camera::CANONICAL };
    let observer = Observer::new(DVec3::ZERO, 0.9, 0.5, 6.0);
    let stage = Stage::seen_by(camera, Scene::default(), observer);
    let drawing = camera_drawing(&stage, Some(Concept::UpCrossW));
    let lit = drawing.marks.iter().filter(|mark| mark.concept == Some(Concept::UpCrossW));
    for [x, y] in lit.flat_map(points) {
        assert!((0.0..240.0).contains(&x) && (0.0..240.0).contains(&y), "{x} {y}");
    }
}

#[test]
fn the_nearest_mark_is_pointed_at() {
    let line = |y: f32| Shape::Line { points: vec![[0.0, y], [100.0, y]], width: 2.0 };
    let mark = |concept: Concept, shape: Shape| Mark {
        item: Item::Ray,
        concept: Some(concept),
        shape,
        color: Color32::BLACK,
        halo: None,
        hidden: false,
        pattern: None,
    };
    let triangle = Shape::Polygon { points: vec![[60.0, 40.0], [90.0, 40.0], [60.0, 80.0]] };
    let marks = [
        mark(Concept::U, line(10.0)),
        mark(Concept::V, line(30.0)),
        mark(Concept::Eye, Shape::Disc { center: [0.0, 10.0], radius: 6.0 }),
        mark(Concept::W, triangle),
    ];
    let at = |x: f32, y: f32| concept_at(&marks, [x, y], 8.0);
    assert_eq!(at(50.0, 12.0), Some(Concept::U));
    assert_eq!(at(50.0, 24.0), Some(Concept::V));
    assert_eq!(at(50.0, 20.0), None, "too far from both");
    assert_eq!(at(2.0, 11.0), Some(Concept::Eye), "drawn over the line");
    assert_eq!(at(65.0, 55.0), Some(Concept::W), "inside");
    assert_eq!(at(88.0, 75.0), None);
    assert_eq!(at(106.0, 10.0), Some(Concept::U), "beyond its end");
}
