//! Tests of observers: which points they see, and how they move.

use std::f64::consts::FRAC_PI_2;

use pinhole_core::{Camera, DVec2, DVec3, Orientation, Plane, ResolvedCamera, Scene, Sphere};
use proptest::prelude::*;

use super::*;

fn resolve(observer: &Observer) -> ResolvedCamera {
    observer.camera(400, 300).resolve().expect("observers have a basis")
}

/// Returns the position of a point in the picture: x and y from -1 to 1.
fn seen_at(observer: &Observer, point: DVec3) -> DVec2 {
    let camera = resolve(observer);
    let projection = camera.project(point);
    assert!(projection.is_in_front(), "{point} is behind {observer:?}");
    projection.uv / (0.5 * DVec2::new(camera.viewport().width, camera.viewport().height))
}

fn is_in_sight(observer: &Observer, point: DVec3) -> bool {
    seen_at(observer, point).abs().max_element() < 1.0
}

fn looking(eye: DVec3, at: DVec3) -> Camera {
    Camera { eye, orientation: Orientation::At { at, up: DVec3::Y }, ..Camera::CANONICAL }
}

fn ball(x: f64, y: f64, z: f64, radius: f64) -> Sphere {
    Sphere { center: DVec3::new(x, y, z), radius }
}

/// Returns the points that belong in sight.
fn must_be_seen(camera: &Camera, spheres: &[Sphere]) -> Vec<DVec3> {
    let own = camera.resolve().expect("a camera");
    let half = 0.5 * DVec2::new(own.viewport().width, own.viewport().height);
    let corners = [DVec2::ONE, DVec2::NEG_ONE, DVec2::new(1.0, -1.0), DVec2::new(-1.0, 1.0)];
    let mut points: Vec<DVec3> = corners.map(|c| own.viewport_point(half * c)).to_vec();
    points.push(own.eye());
    for sphere in spheres {
        points.extend(
            DVec3::AXES.iter().flat_map(|axis| {
                [1.0, -1.0].map(|sign| sphere.center + sign * sphere.radius * *axis)
            }),
        );
    }
    points
}

#[test]
fn everything_is_in_sight() {
    let wall = Plane { point: DVec3::new(0.0, 0.0, -6.0), normal: DVec3::Z };
    let down = Orientation::View { view: DVec3::NEG_Y, up: DVec3::X };
    let cases = [
        (Camera::CANONICAL, vec![ball(0.0, 0.0, -5.0, 1.0)], vec![wall]),
        (Camera::CANONICAL, vec![], vec![]),
        (
            looking(DVec3::new(20.0, 4.0, 10.0), DVec3::new(-1.0, 0.0, -5.0)),
            vec![ball(0.0, 0.0, -5.0, 1.0), ball(-2.5, 0.0, -5.0, 1.5)],
            vec![],
        ),
        (Camera::CANONICAL, vec![ball(0.0, 0.0, -1e5, 1.0)], vec![]),
        (
            Camera { orientation: down, ..Camera::CANONICAL },
            vec![ball(0.0, -5.0, 0.0, 1.0)],
            vec![],
        ),
    ];
    for (camera, spheres, planes) in cases {
        let scene = Scene::new(spheres.clone(), planes).expect("a scene");
        let observer =
            Observer::frame_all(&arrows(&camera, &scene), ViewSize::of_aspect(4.0 / 3.0));
        for point in must_be_seen(&camera, &spheres) {
            assert!(is_in_sight(&observer, point), "{point} by {observer:?}");
        }
    }
}

#[test]
fn a_planet_is_not_framed() {
    let with = |spheres: Vec<Sphere>| {
        let scene = Scene::new(spheres, vec![]).expect("a scene");
        Observer::frame_all(&arrows(&Camera::CANONICAL, &scene), ViewSize::of_aspect(1.0))
    };
    let small = ball(0.0, 0.0, -5.0, 1.0);
    let [alone, on_a_planet] =
        [with(vec![small]), with(vec![ball(0.0, -5001.0, 0.0, 5000.0), small])];
    assert!(on_a_planet.distance() < 1.2 * alone.distance(), "{on_a_planet:?} for {alone:?}");
}

#[test]
fn the_camera_is_never_lost_from_afar() {
    for far in [5.0, 100.0, 1e4, 1e7] {
        let camera = looking(DVec3::ZERO, DVec3::new(0.0, 0.0, -far));
        let scene = Scene::new(vec![ball(0.0, 0.0, -far, 1.0)], vec![]).expect("a scene");
        let observer = Observer::frame_all(&arrows(&camera, &scene), ViewSize::of_aspect(1.25));
        let own = camera.resolve().expect("a camera");
        let top = seen_at(&observer, own.viewport_point(DVec2::new(0.0, 0.5)));
        let bottom = seen_at(&observer, own.viewport_point(DVec2::new(0.0, -0.5)));
        // In a picture 2 high.
        assert!(top.distance(bottom) > 0.2, "{far}: {}", top.distance(bottom));
        assert!(is_in_sight(&observer, DVec3::new(0.0, 0.0, -far)));
    }
}

#[test]
fn every_scale_is_framed_alike() {
    let framed = |scale: f64, shift: DVec3| {
        let mut camera = looking(shift, shift + DVec3::new(0.0, 0.0, -5.0 * scale));
        camera.viewport.width *= scale;
        camera.viewport.height *= scale;
        camera.viewport.distance *= scale;
        let center = shift + DVec3::new(0.0, 0.0, -5.0 * scale);
        let scene = Scene::new(vec![Sphere { center, radius: scale }], vec![]).expect("a scene");
        let observer = Observer::frame_all(&arrows(&camera, &scene), ViewSize::of_aspect(1.25));
        seen_at(&observer, camera.eye)
    };
    let ordinary = framed(1.0, DVec3::ZERO);
    for scale in [1e-6, 1e-3, 1e3, 1e9] {
        // The arrows are one unit long but stay within a range of lengths on the screen.
        assert!(framed(scale, DVec3::ZERO).distance(ordinary) < 0.3, "{scale}");
    }
    assert!(framed(1.0, DVec3::new(1e9, -1e9, 1e9)).distance(ordinary) < 0.3);
}

#[test]
fn azimuth_and_elevation() {
    let eye = |azimuth, elevation| {
        resolve(&Observer::new(DVec3::new(1.0, 2.0, 3.0), azimuth, elevation, 4.0)).eye()
    };
    assert!(eye(0.0, 0.0).distance(DVec3::new(1.0, 2.0, 7.0)) < 1e-12);
    assert!(eye(FRAC_PI_2, 0.0).distance(DVec3::new(5.0, 2.0, 3.0)) < 1e-12);
    // Straight up is out of range.
    let above = (eye(0.0, 10.0) - DVec3::new(1.0, 2.0, 3.0)).normalize();
    assert!(above.distance(DVec3::Y) < 0.02 && above.z > 0.0);
}

#[test]
fn from_above_a_figure_is_flat_and_what_is_at_the_target_keeps_its_size() {
    let size = |elevation: f64, height: f64| {
        let observer = Observer::new(DVec3::ZERO, 0.0, elevation.to_radians(), 5.0);
        let seen = |x: f64| seen_at(&observer, DVec3::new(x, height, 0.0));
        seen(1.0).distance(seen(-1.0))
    };
    assert!((size(90.0, 0.0) - size(60.0, 0.0)).abs() < 1e-3);
    // What is nearer to the observer is hardly larger.
    assert!(size(90.0, 1.0) / size(90.0, 0.0) < 1.03 && size(60.0, 1.0) / size(60.0, 0.0) > 1.15);
}

#[test]
fn panning_moves_what_is_at_the_target_with_the_hand() {
    let mut observer = Observer::new(DVec3::new(1.0, 2.0, 3.0), 0.7, 0.4, 9.0);
    let point = observer.target();
    assert!(seen_at(&observer, point).length() < 1e-12);
    observer.pan(0.25, 0.1);
    // The point moves by a quarter of the height to the right and a tenth down. The picture is 2 x 2 units.
    let expected = DVec2::new(0.25 * 2.0 * 300.0 / 400.0, -0.1 * 2.0);
    assert!(seen_at(&observer, point).distance(expected) < 1e-12);
}

#[test]
fn zooming_in_brings_the_target_nearer() {
    let mut observer = Observer::new(DVec3::ZERO, 0.0, 0.0, 8.0);
    observer.zoom(observer.target(), 2.0, FREE);
    assert_eq!(observer.distance(), 4.0);
    for nonsense in [0.0, -1.0, f64::NAN] {
        observer.zoom(observer.target(), nonsense, FREE);
        assert_eq!(observer.distance(), 4.0);
    }
}

/// No limits of a zoom.
const FREE: [f64; 2] = [1e-300, f64::MAX];

#[test]
fn a_point_stays_in_place_while_it_is_zoomed_to_within_the_limits() {
    let mut observer = Observer::new(DVec3::new(1.0, 2.0, 3.0), 0.7, 0.4, 9.0);
    let point = DVec3::new(2.0, 1.0, 4.5);
    let (place, eye) = (seen_at(&observer, point), resolve(&observer).eye());
    observer.zoom(point, 3.0, FREE);
    assert!(seen_at(&observer, point).distance(place) < 1e-12);
    let reach = |observer: &Observer| resolve(observer).eye().distance(point);
    assert!((reach(&observer) - eye.distance(point) / 3.0).abs() < 1e-12);
    observer.zoom(point, 1e9, [0.5, 40.0]);
    assert!((reach(&observer) - 0.5).abs() < 1e-12);
    observer.zoom(point, 1e-9, [0.5, 40.0]);
    assert!((observer.distance() - 40.0).abs() < 1e-9);
    assert!(seen_at(&observer, point).distance(place) < 1e-9);
}

#[test]
fn nonsense_is_brought_into_range() {
    resolve(&Observer::new(DVec3::new(1e300, 0.0, 0.0), 1e300, 9.0, -1.0));
    let mut observer = Observer::new(DVec3::new(0.0, f64::NAN, 0.0), 0.0, 0.0, f64::NAN);
    resolve(&observer);
    observer.orbit(f64::INFINITY, f64::NAN);
    resolve(&observer);
}

#[test]
fn a_scene_is_seen_without_planes_and_what_encloses_the_camera() {
    let wall = Plane { point: DVec3::new(0.0, 0.0, -6.0), normal: DVec3::Z };
    let around = ball(0.0, 0.0, 0.0, 3.0);
    let small = ball(0.0, 0.0, -5.0, 1.0);
    let scene = Scene::new(vec![around, small], vec![wall]).expect("a scene");
    let (eye, outside, inside) = (DVec3::ZERO, DVec3::new(9.0, 0.0, 0.0), DVec3::X);
    assert_eq!(enclosing(&scene, eye, outside), [0]);
    let seen = traced_scene(&scene, &[0]);
    assert_eq!(seen.planes(), []);
    assert_eq!(seen.spheres()[1], small);
    assert!(seen.spheres()[0].radius < 1e-100);
    assert!(enclosing(&scene, eye, inside).is_empty());
    assert_eq!(traced_scene(&scene, &[]).spheres(), scene.spheres());
    assert_eq!(scene.spheres()[0], around, "the scene itself stays as it is");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn observers_always_have_a_basis(
        target in prop::array::uniform3(prop::num::f64::ANY),
        angles in prop::array::uniform2(prop::num::f64::ANY),
        distance in prop::num::f64::ANY,
        moves in prop::array::uniform5(-1e3..1e3f64),
    ) {
        let mut observer = Observer::new(target.into(), angles[0], angles[1], distance);
        resolve(&observer);
        observer.orbit(moves[0], moves[1]);
        observer.pan(moves[2], moves[3]);
        observer.zoom(observer.target() + moves[4], moves[4], FREE);
        resolve(&observer);
    }
}

/// Returns a camera's eye and the corners of its viewport.
fn own_points(camera: &Camera) -> Vec<DVec3> {
    must_be_seen(camera, &[])
}

#[test]
fn a_camera_is_framed_from_the_side_that_it_was_seen_from() {
    let camera = looking(DVec3::new(20.0, 4.0, 10.0), DVec3::new(-1.0, 0.0, -5.0));
    let scene = Scene::default();
    for (azimuth, elevation) in [(0.3, 0.2), (-2.0, 0.9), (3.0, -0.4)] {
        let before = Observer::new(DVec3::new(5.0, 0.0, 0.0), azimuth, elevation, 400.0);
        let framed =
            before.framing_camera(&arrows(&camera, &scene), ViewSize::of_aspect(4.0 / 3.0));
        let [old, new] = [before, framed].map(|observer| resolve(&observer).basis().w);
        assert!(old.distance(new) < 1e-12);
        for point in own_points(&camera) {
            assert!(is_in_sight(&framed, point), "{point} by {framed:?}");
        }
        let seen = own_points(&camera).into_iter().map(|point| seen_at(&framed, point));
        let ys: Vec<f64> = seen.map(|point| point.y).collect();
        let [least, most] =
            [ys.iter().copied().fold(2.0, f64::min), ys.iter().copied().fold(-2.0, f64::max)];
        // In a picture 2 high.
        assert!(most - least > 0.3, "{framed:?}");
    }
}

#[test]
fn the_observer_steps_back_as_far_as_a_way_needs() {
    let camera = looking(DVec3::new(20.0, 4.0, 10.0), DVec3::new(-1.0, 0.0, -5.0));
    let turn = |k: u32| camera.orbited(std::f64::consts::TAU * f64::from(k) / 24.0, 0.0);
    let way: Vec<Camera> = (0..24).map(|k| turn(k).expect("an orbit")).collect();
    let scene = Scene::default();
    let before = Observer::frame_all(&arrows(&camera, &scene), ViewSize::of_aspect(4.0 / 3.0));
    let is_lost = |observer: &Observer| {
        let points = way.iter().flat_map(own_points);
        let behind = |point: &DVec3| !resolve(observer).project(*point).is_in_front();
        points.into_iter().any(|point| behind(&point) || !is_in_sight(observer, point))
    };
    let after = before.following(&camera, &way, 4.0 / 3.0);
    assert!(is_lost(&before) && !is_lost(&after), "{after:?}");
    assert_eq!(
        (after.target(), after.azimuth, after.elevation),
        (before.target(), before.azimuth, before.elevation)
    );
    assert_eq!(after.following(&camera, &way, 4.0 / 3.0), after, "no farther than it needs");
    assert_eq!(before.following(&camera, &[camera], 4.0 / 3.0), before, "nor nearer");
    // An observer that does not look at the camera stays where it is.
    let elsewhere = Observer::new(DVec3::new(-1.0, 0.0, -5.0), 0.5, 0.3, 5.0);
    assert_eq!(elsewhere.following(&camera, &way, 4.0 / 3.0), elsewhere);
}

/// Returns the basis arrows and up, each with a label.
fn arrows<'a>(camera: &'a Camera, scene: &'a Scene) -> Drawn<'a> {
    let basis = camera.resolve().map(|resolved| *resolved.basis());
    let vectors = basis.map_or(Vec::new(), |basis| vec![basis.u, basis.v, basis.w]);
    let up = UP_LENGTH * camera.up().normalize_or_zero();
    let place = |along| (Place { at: camera.eye, along, length: Length::Arrow }, true);
    let places = vectors.into_iter().chain([up]).map(place).collect();
    Drawn { camera, scene, has_frustum: true, places }
}

/// Returns the camera and the scene alone.
fn nothing<'a>(camera: &'a Camera, scene: &'a Scene) -> Drawn<'a> {
    Drawn { camera, scene, has_frustum: false, places: Vec::new() }
}

/// Length of the up arrow, as a multiple of the basis arrows' length.
const UP_LENGTH: f64 = 1.35;

/// Returns the tips of the basis arrows and of up, as the world view draws them.
fn tips(observer: &Observer, camera: &Camera, size: ViewSize) -> Vec<DVec3> {
    let resolved =
        observer.camera(size.width as u32, size.height as u32).resolve().expect("a basis");
    let depth = (resolved.eye() - camera.eye).dot(observer.back());
    let per_point = extent_of_fov(FOV, depth) / size.height;
    let (least, most) = size.arrow_points();
    let length = 1.0_f64.clamp(least * per_point, most * per_point);
    let own = camera.resolve().expect("a camera");
    let basis = own.basis();
    let up = UP_LENGTH * camera.up().normalize();
    [basis.u, basis.v, basis.w, up].map(|axis| camera.eye + length * axis).to_vec()
}

#[test]
fn no_tip_of_an_arrow_is_cut_off_in_a_view_of_any_shape() {
    let camera = looking(DVec3::ZERO, DVec3::new(0.0, 0.0, -5.0));
    let scene = Scene::new(vec![ball(0.0, 0.0, -5.0, 1.0)], vec![]).expect("a scene");
    let wide = ViewSize::new(900.0, 500.0);
    let framed = Observer::frame_all(&arrows(&camera, &scene), wide);
    let named = Observer::new(DVec3::new(-0.1, -0.2, -2.3), 0.84, 0.33, 9.0);
    for (width, height) in [(900.0, 500.0), (340.0, 560.0), (300.0, 300.0), (1200.0, 700.0)] {
        let size = ViewSize::new(width, height);
        let refitted = framed.refitted(&arrows(&camera, &scene), size);
        assert_eq!((refitted.azimuth, refitted.elevation), (framed.azimuth, framed.elevation));
        let kept = named.framing_the_same(&arrows(&camera, &scene), size);
        assert_eq!((kept.azimuth, kept.elevation), (named.azimuth, named.elevation));
        for observer in [refitted, kept] {
            let seen = observer.camera(width as u32, height as u32).resolve().expect("a basis");
            let half = 0.5 * DVec2::new(seen.viewport().width, seen.viewport().height);
            for tip in tips(&observer, &camera, size) {
                // A label's width from the border.
                let room = 1.0 - 30.0 / DVec2::new(width, height);
                let at = seen.project(tip).uv / half;
                assert!(at.abs().cmplt(room).all(), "{at} in {size:?} by {observer:?}");
            }
        }
    }
    // An observer that looks closely at something else stays.
    let close = Observer::new(DVec3::new(0.0, 0.0, -5.0), 0.5, 0.3, 2.0);
    assert_eq!(close.framing_the_same(&arrows(&camera, &scene), wide), close);
}

#[test]
fn a_sphere_around_the_camera_stays_in_sight_as_a_whole() {
    let camera = Camera::CANONICAL;
    let around = ball(0.0, 0.0, -1.0, 4.0);
    let scene = Scene::new(vec![around], vec![]).expect("a scene");
    let named = Observer::new(DVec3::new(0.0, 0.0, -1.0), 0.84, 0.45, 14.5);
    for (width, height) in [(500.0, 180.0), (300.0, 600.0), (900.0, 700.0)] {
        let size = ViewSize::new(width, height);
        let seen = named.framing_the_same(&nothing(&camera, &scene), size);
        let (right, up) = seen.right_and_up();
        let sides = [right, -right, up, -up].map(|side| around.center + around.radius * side);
        let view = seen.camera(width as u32, height as u32).resolve().expect("a basis");
        let half = 0.5 * DVec2::new(view.viewport().width, view.viewport().height);
        let seen_at = sides.map(|side| (view.project(side).uv / half).abs().max_element());
        let most = seen_at.into_iter().fold(0.0, f64::max);
        assert!((0.7..1.0).contains(&most), "{seen_at:?} in {size:?}");
    }
    // An observer inside the sphere keeps its distance.
    let inside = Observer::new(DVec3::new(0.0, 0.0, -1.0), 0.84, 0.45, 3.0);
    let size = ViewSize::of_aspect(1.25);
    assert!(inside.framing_the_same(&nothing(&camera, &scene), size).distance() < 5.0);
}

#[test]
fn arrows_take_no_more_than_their_share_of_a_low_view() {
    let at = |width, height| ViewSize::new(width, height).arrow_points();
    assert_eq!(at(900.0, 500.0), (62.0, 125.0));
    let (least, most) = at(900.0, 100.0);
    assert!((25.0..30.0).contains(&least) && most == 125.0, "{least}");
    assert_eq!(at(100.0, 900.0), at(900.0, 100.0));
    assert!(at(0.0, 0.0).0 > 0.0);
    let camera = looking(DVec3::ZERO, DVec3::new(0.0, 0.0, -5.0));
    let scene = Scene::new(vec![ball(0.0, 0.0, -5.0, 1.0)], vec![]).expect("a scene");
    let named = Observer::new(DVec3::new(-0.1, -0.2, -2.3), 0.84, 0.33, 9.0);
    for height in [60.0, 100.0, 150.0] {
        let size = ViewSize::new(300.0, height);
        let seen = named.framing_the_same(&arrows(&camera, &scene), size);
        let view = seen.camera(300, height as u32).resolve().expect("a basis");
        let half = 0.5 * DVec2::new(view.viewport().width, view.viewport().height);
        let [eye, ball] = [DVec3::ZERO, DVec3::new(0.0, 0.0, -5.0)].map(|p| view.project(p).uv);
        for tip in tips(&seen, &camera, size) {
            let at = view.project(tip).uv / half;
            assert!(at.abs().cmplt(DVec2::splat(0.95)).all(), "{at} in {size:?}");
        }
        let share = (ball - eye).length() / (2.0 * half.x);
        assert!(share > 0.15, "{share}: the arrows crowd the scene out of {size:?}");
    }
}
