//! Tests the panes that stand for planes, the floor, and the sides of the frustum.

use super::*;

/// Returns the marks of an item alone, and the picture without them.
fn alone(stage: &mut Stage, item: Item) -> (Drawing, Vec<Color32>) {
    stage.items = OverlayItems::NONE.with(item, true);
    let mut dots = stage.dots();
    let view = WorldView { without_marks: true, ..stage.view() };
    (stage.painted(&view, &mut dots), dots)
}

fn dot_at(stage: &Stage, dots: &[Color32], point: DVec3) -> Color32 {
    let at = stage.to_screen(point);
    dots[at.y as usize * SIZE.0 as usize + at.x as usize]
}

#[test]
fn a_plane_is_a_pane_around_what_the_camera_sees_of_it() {
    let wall = Plane { point: DVec3::new(0.0, 0.0, -6.0), normal: DVec3::Z };
    let scene = Scene::new(vec![], vec![wall]).expect("a scene");
    let observer = Observer::new(DVec3::new(0.0, 0.0, -6.0), 0.0, 0.0, 20.0);
    let mut stage = Stage::seen_by(Camera::CANONICAL, scene, observer);
    let (drawing, dots) = alone(&mut stage, Item::Planes);
    // The camera sees 6 x 6 units. A cell of the grid is 2 units, and half of one is the margin.
    let background = Style::Light.colors().background;
    let corner = |x: f64| DVec3::new(x, x, -6.0);
    for x in [-3.7, 2.7, 3.7] {
        assert_ne!(dot_at(&stage, &dots, corner(x)), background, "{x}");
    }
    for x in [-4.3, 4.3] {
        assert_eq!(dot_at(&stage, &dots, corner(x)), background, "{x}");
    }
    let ends: Vec<DVec2> = drawing.marks.iter().flat_map(points).map(wide).collect();
    assert_eq!(ends.len(), 8, "four sides");
    for x in [-4.0, 4.0] {
        let at = stage.to_screen(corner(x));
        assert!(ends.iter().any(|end| end.distance(at) < 0.01), "{x}: {ends:?}");
    }
}

#[test]
fn the_floor_lies_below_everything_and_lines_drop_to_it() {
    let balls = vec![sphere(0.0, 0.0, -5.0, 1.0), sphere(1.5, 2.0, -4.0, 0.5)];
    let mut stage = Stage::new(Camera::CANONICAL, balls, vec![]);
    let (drawing, dots) = alone(&mut stage, Item::Floor);
    assert!(drawing.marks.iter().all(|mark| mark.item == Item::Floor));
    let foot = stage.to_screen(DVec3::new(1.5, -1.0, -4.0));
    let reaches = |mark: &Mark| points(mark).iter().any(|at| wide(*at).distance(foot) < 1.0);
    assert!(drawing.marks.iter().any(reaches), "{:?}", drawing.marks);
    let (_, without) = alone(&mut stage, Item::Labels);
    let marked: Vec<usize> = (0..dots.len()).filter(|k| dots[*k] != without[*k]).collect();
    assert!(marked.len() > 300, "a grid");
    let edges = edge_blends(&stage.frame, &stage.scene);
    let is_edge = |k: usize| edges.iter().any(|edge| edge.pixel as usize == k);
    let hidden = |k: &&usize| stage.frame.object[**k] != NO_OBJECT && !is_edge(**k);
    assert_eq!(marked.iter().filter(hidden).count(), 0, "balls hide the floor");
}

#[test]
fn the_floor_is_the_highest_level_plane_below_the_eye() {
    let level = |y: f64| Plane::new([0.0, y, 0.0], [0.0, 1.0, 0.0]).expect("a plane");
    for (heights, floor) in [([2.0, -2.0, -3.0], -2.0), ([2.0, 3.0, 4.0], -0.6)] {
        let ball = vec![sphere(0.0, 2.0, -4.0, 0.5)];
        let stage = Stage::new(Camera::CANONICAL, ball, heights.map(level).to_vec());
        let stage = Stage { items: stage.items.with(Item::Planes, true), ..stage };
        let drawing = stage.drawing();
        let foot = stage.to_screen(DVec3::new(0.0, floor, -4.0));
        let reaches = |mark: &Mark| points(mark).iter().any(|at| wide(*at).distance(foot) < 1.0);
        let lines = drawing.marks.iter().filter(|mark| mark.item == Item::Floor);
        assert!(lines.clone().any(reaches), "{heights:?}: {:?}", lines.collect::<Vec<_>>());
    }
}

#[test]
fn many_objects_or_a_planet_have_no_floor() {
    let many = (0..65).map(|k| sphere(0.1 * f64::from(k) - 3.0, 0.0, -5.0, 0.05)).collect();
    let planet = vec![sphere(0.0, 0.0, -5.0, 1.0), sphere(0.0, -501.0, 0.0, 500.0)];
    for balls in [many, planet] {
        let mut stage = Stage::new(Camera::CANONICAL, balls, vec![]);
        let with = alone(&mut stage, Item::Floor);
        assert_eq!(with, alone(&mut stage, Item::Labels));
    }
}

#[test]
fn the_frustum_is_faintly_filled_where_it_faces_the_observer() {
    let drawing = canonical().drawing();
    let filled = drawing
        .marks
        .iter()
        .filter(|mark| mark.item == Item::Frustum && matches!(mark.shape, Shape::Polygon { .. }));
    let opacities: Vec<u8> = filled.map(|mark| mark.color.a()).collect();
    assert!(
        (2..8).contains(&opacities.len()) && opacities.iter().all(|a| *a < 30),
        "{opacities:?}"
    );
}

#[test]
fn the_ground_stays_while_the_observer_zooms() {
    let wall = Plane { point: DVec3::new(0.0, 0.0, -6.0), normal: DVec3::Z };
    let balls = vec![sphere(0.0, 0.0, -5.0, 1.0), sphere(1.5, 2.0, -4.0, 0.5)];
    let stage = Stage::new(Camera::CANONICAL, balls, vec![wall]);
    let seen_from = |factor: f64| {
        let mut observer = stage.observer;
        observer.zoom(observer.target(), factor, [1e-300, f64::MAX]);
        stage.view_of(|figure| figure.observer = observer).backdrop(stage.scene())
    };
    let near = seen_from(1.0);
    assert!(near.floor.is_some() && near.patches.len() == 1);
    for factor in [0.04, 0.3, 3.0, 8.0] {
        assert_eq!(seen_from(factor), near, "{factor}");
    }
}
