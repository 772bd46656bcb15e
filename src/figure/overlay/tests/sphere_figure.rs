//! Tests the sphere figure: every mark of it is where the quadratic equation puts it.

use pinhole_core::{Camera, DVec2, DVec3, Scene};

use super::*;

/// Returns a stage that shows the figure alone, with the ray through a point of the canonical viewport.
fn stage(spheres: Vec<Sphere>, uv: (f64, f64)) -> Stage {
    let scene = Scene::new(spheres, vec![]).expect("a scene");
    let observer = from_the_right(DVec3::new(0.0, 0.0, -3.0), 12.0);
    let mut stage = Stage::seen_by(Camera::CANONICAL, scene, observer);
    stage.items = OverlayItems::NONE.with(Item::SphereFigure, true).with(Item::Labels, true);
    let selection = Selection::Uv(DVec2::from(uv));
    let ray = Inspection::new(stage.resolve(), &stage.scene, selection);
    stage.inspection = Some(Arc::new(ray));
    stage
}

fn texts(drawing: &Drawing) -> Vec<&str> {
    let mut texts: Vec<&str> = drawing.labels.iter().map(|label| label.text.as_str()).collect();
    texts.sort_unstable();
    texts
}

/// Returns true if a point of the world is marked by a disc.
fn has_disc(stage: &Stage, drawing: &Drawing, at: DVec3) -> bool {
    let expected = stage.to_screen(at);
    let mut shapes = drawing.marks.iter().map(|mark| &mark.shape);
    shapes.any(|shape| {
        matches!(shape, Shape::Disc { center, .. } if wide(*center).distance(expected) < 0.1)
    })
}

/// Returns true if a line of the drawing has these ends in the world.
fn has_line(stage: &Stage, drawing: &Drawing, ends: [DVec3; 2]) -> bool {
    let ends = ends.map(|end| stage.to_screen(end));
    drawing.marks.iter().any(|mark| {
        let points = points(mark);
        points.len() == 2 && (0..2).all(|k| wide(points[k]).distance(ends[k]) < 0.1)
    })
}

#[test]
fn a_hit_sphere_shows_roots_foot_radius_and_half_chord() {
    // d = (0, 0, -1) passes the centre at a distance of 0.6: D = 0.64.
    let stage = stage(vec![sphere(0.0, 0.6, -5.0, 1.0)], (0.0, 0.0));
    let drawing = small_drawing(&stage);
    let expected = [
        "centre",
        "d",
        "foot: t = −b/a = 5",
        "r = 1",
        "t < 0",
        "t = 4.2, first hit",
        "t = 5.8",
        "√D/a = 0.8",
    ];
    assert_eq!(texts(&drawing), expected);
    let at = |z: f64| DVec3::new(0.0, 0.0, z);
    let center = DVec3::new(0.0, 0.6, -5.0);
    for point in [center, at(-5.0), at(-4.2), at(-5.8)] {
        assert!(has_disc(&stage, &drawing, point), "{point}");
    }
    assert!(has_line(&stage, &drawing, [center, at(-4.2)]), "r to the first hit");
    assert!(has_line(&stage, &drawing, [at(-5.0), center]), "the perpendicular");
    // The sides of the right angle are a fifth of the perpendicular.
    let corner = DVec3::new(0.0, 0.12, -4.88);
    assert!(has_line(&stage, &drawing, [at(-4.88), corner]));
    assert!(has_line(&stage, &drawing, [corner, DVec3::new(0.0, 0.12, -5.0)]));
    let dashed: Vec<_> = drawing.marks.iter().filter(|mark| mark.hidden).map(points).collect();
    assert_eq!(dashed.len(), 1, "behind the first hit");
    assert!(wide(dashed[0][0]).distance(stage.to_screen(at(-4.2))) < 0.1);
    let dotted = drawing.marks.iter().find(|mark| mark.pattern.is_some()).map(points);
    let [from, to] = dotted.expect("the line behind the eye")[..] else { panic!() };
    assert!(wide(from).distance(stage.to_screen(DVec3::ZERO)) < 0.1);
    assert!(to[0] < from[0], "behind the eye: -z is to the right");
}

#[test]
fn a_missed_sphere_shows_its_distance_against_its_radius() {
    // The first sphere is behind the eye, so the second one is closer to the ray.
    let spheres = vec![sphere(0.0, 0.0, 1.0, 0.5), sphere(0.0, 1.25, -5.0, 1.0)];
    let stage = stage(spheres, (0.0, 0.0));
    let drawing = small_drawing(&stage);
    let of_figure = ["centre", "d", "distance = 1.25 > r", "foot: t = −b/a = 5", "r = 1"];
    let of_roots = ["t < 0", "t = −0.5", "t = −1.5"];
    assert_eq!(texts(&drawing), [&of_figure[..], &of_roots].concat());
    let (center, rim) = (DVec3::new(0.0, 1.25, -5.0), DVec3::new(0.0, 1.25, -4.0));
    assert!(has_line(&stage, &drawing, [center, rim]), "r keeps off the perpendicular");
    assert!(has_line(&stage, &drawing, [DVec3::new(0.0, 0.0, -5.0), center]));
    assert!(drawing.marks.iter().all(|mark| !mark.hidden), "nothing ends the ray");
}

#[test]
fn a_touched_sphere_has_one_root_and_a_sphere_around_the_eye_one_behind_it() {
    let touched = small_drawing(&stage(vec![sphere(0.0, 1.0, -5.0, 1.0)], (0.0, 0.0)));
    assert!(texts(&touched).contains(&"t = 5, first hit"), "{:?}", texts(&touched));
    assert!(!texts(&touched).iter().any(|text| text.contains("distance")));
    let around = small_drawing(&stage(vec![sphere(0.0, 0.0, -1.0, 2.0)], (0.0, 0.0)));
    for text in ["t = −1", "t = 3, first hit", "foot: t = −b/a = 1", "√D/a = 2"] {
        assert!(texts(&around).contains(&text), "{text}: {:?}", texts(&around));
    }
}

#[test]
fn roots_of_all_objects_are_marked_behind_the_eye_too() {
    let spheres = vec![sphere(0.0, 0.0, 1.0, 0.5), sphere(0.0, 0.0, -5.0, 1.0)];
    let mut stage = stage(spheres, (0.0, 0.0));
    stage.items = OverlayItems::NONE.with(Item::Roots, true).with(Item::Labels, true);
    let drawing = small_drawing(&stage);
    assert_eq!(texts(&drawing), ["6", "t < 0", "t = 4, first hit", "−0.5", "−1.5"]);
    for z in [1.5, 0.5, -4.0, -6.0] {
        assert!(has_disc(&stage, &drawing, DVec3::new(0.0, 0.0, z)), "{z}");
    }
}

#[test]
fn a_sphere_behind_a_wall_is_entered_but_not_hit_first() {
    let mut stage = stage(vec![sphere(0.0, 0.6, -5.0, 1.0)], (0.0, 0.0));
    let wall = pinhole_core::Plane { point: DVec3::new(0.0, 0.0, -3.0), normal: DVec3::Z };
    stage.scene = Scene::new(stage.scene.spheres().to_vec(), vec![wall]).expect("a scene");
    let ray = Inspection::new(stage.resolve(), &stage.scene, Selection::Uv(DVec2::ZERO));
    stage.inspection = Some(Arc::new(ray));
    let drawing = small_drawing(&stage);
    assert!(texts(&drawing).contains(&"t = 4.2"), "{:?}", texts(&drawing));
    assert!(!texts(&drawing).iter().any(|text| text.contains("first")));
}
