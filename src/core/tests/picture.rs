//! Tests that a picture is bit for bit the same as the first hits of the pixels' rays, traced one by
//! one.

use expect_test::expect;
use pinhole_core::*;
use proptest::prelude::*;

use crate::common::seed::config;
use crate::common::{Numbers, camera, plane, sphere, vec3};

/// Traces a picture, and asserts that each pixel equals the first hit of its ray, traced by itself.
#[track_caller]
fn assert_as_pixel_by_pixel(scene: &Scene, camera: &ResolvedCamera, raster: &Raster) {
    let frame = trace(scene, camera, raster, Outputs { normal: true, ..Outputs::default() });
    for row in 0..raster.rows().len() {
        for column in 0..raster.columns().len() {
            let traced = frame.at(row, column);
            let ray = camera.exact_ray(traced.pixel);
            let asked = scene.first_hit_of(&ray);
            let (object, t, normal) = asked.map_or((None, f64::INFINITY, DVec3::ZERO), |hit| {
                (Some(hit.object), hit.t, hit.normal)
            });
            let traced_normal = frame.normal[row * raster.columns().len() + column];
            assert!(
                (traced.object, traced.t.to_bits(), traced_normal) == (object, t.to_bits(), normal),
                "{traced:?} with normal {traced_normal:?}, alone {asked:?}, ray {ray:?}"
            );
        }
    }
}

#[track_caller]
fn assert_full(scene: &Scene, camera: &ResolvedCamera) {
    assert_as_pixel_by_pixel(scene, camera, &Raster::full(camera.image()));
}

fn spheres_only(spheres: Vec<Sphere>) -> Scene {
    Scene::new(spheres, vec![]).unwrap()
}

fn direction() -> impl Strategy<Value = DVec3> {
    [-1.0..1.0, -1.0..1.0, -1.0..1.0_f64]
        .prop_map(DVec3::from_array)
        .prop_filter("points somewhere", |d| d.length() > 1e-3)
}

/// Generates sizes whose log10 is evenly distributed between two bounds.
fn magnitude(from: f64, to: f64) -> impl Strategy<Value = f64> {
    (from..to).prop_map(|e| 10_f64.powf(e))
}

fn viewport() -> impl Strategy<Value = Viewport> {
    let extent = || prop_oneof![magnitude(-1.0, 1.0), magnitude(-12.0, 12.0)];
    [extent(), extent(), extent()].prop_map(|[width, height, distance]| Viewport {
        width,
        height,
        distance,
    })
}

/// Odd, even, and long thin images.
fn image() -> impl Strategy<Value = ImageSize> {
    prop_oneof![
        4 => (1..40_u32, 1..40_u32),
        1 => Just((1, 16_384)),
        1 => Just((16_384, 1)),
    ]
    .prop_map(|(width, height)| ImageSize::new(width, height).unwrap())
}

/// Generates orientations, half of them given by u, v, w that are not quite orthonormal, up to nearly
/// the tolerance.
fn orientation() -> impl Strategy<Value = Orientation> {
    (direction(), direction(), -9e-10..9e-10, any::<bool>()).prop_filter_map(
        "has a basis",
        |(view, up, defect, by_hand)| {
            let Basis { u, v, w } = Basis::from_view_up(view, up).ok()?;
            let off = Basis { u: u + defect * w, v: v * (1.0 + defect), w };
            Some(if by_hand { Orientation::Basis(off) } else { Orientation::View { view, up } })
        },
    )
}

fn resolve() -> impl Strategy<Value = ResolvedCamera> {
    let eye =
        ([-1.0..1.0, -1.0..1.0, -1.0..1.0_f64], prop_oneof![Just(1.0), magnitude(-3.0, 12.0)])
            .prop_map(|(p, reach)| reach * DVec3::from_array(p));
    (eye, orientation(), viewport(), image()).prop_map(|(eye, orientation, viewport, image)| {
        Camera { eye, orientation, viewport, image }.resolve().unwrap()
    })
}

/// Generates spheres at critical positions relative to the camera: visible, behind the eye, across the
/// plane through the eye, around the eye, with the eye on or just beside their surface, huge and tiny.
fn sphere_near(camera: ResolvedCamera) -> impl Strategy<Value = Sphere> {
    let image = camera.image();
    let ray = (0..image.height(), 0..image.width(), -0.5..0.5, -0.5..0.5).prop_map(
        move |(row, column, du, dv)| {
            let Viewport { width, height, .. } = camera.viewport();
            let pixel = camera.uv_of_pixel(Pixel { row, column });
            let across = DVec2::new(
                du * width / f64::from(image.width()),
                dv * height / f64::from(image.height()),
            );
            camera.ray(pixel + across).direction.normalize()
        },
    );
    let anywhere = prop_oneof![3 => ray, 1 => direction().prop_map(DVec3::normalize)];
    let near_one = prop_oneof![
        Just(1.0),
        Just(1.0 + f64::EPSILON),
        Just(1.0 - f64::EPSILON),
        (-14.0..-1.0, any::<bool>())
            .prop_map(|(e, more)| 1.0 + if more { 1.0 } else { -1.0 } * 10_f64.powf(e)),
    ];
    let share = prop_oneof![magnitude(-2.0, 0.5), magnitude(-14.0, 8.0), near_one];
    let distance = prop_oneof![4 => magnitude(-1.0, 2.0), 1 => magnitude(-20.0, 20.0)];
    (anywhere, distance, share).prop_map(move |(toward, distance, share)| Sphere {
        center: camera.eye() + distance * toward,
        radius: share * distance,
    })
}

fn scene_and_camera() -> impl Strategy<Value = (Scene, ResolvedCamera)> {
    resolve().prop_flat_map(|camera| {
        let spheres = prop::collection::vec(sphere_near(camera), 1..6);
        let planes = prop::collection::vec((direction(), direction(), magnitude(-2.0, 3.0)), 0..2);
        (spheres, planes).prop_map(move |(spheres, planes)| {
            let planes = planes
                .into_iter()
                .map(|(to, normal, distance)| Plane { point: camera.eye() + distance * to, normal })
                .collect();
            (Scene::new(spheres, planes).unwrap(), camera)
        })
    })
}

proptest! {
    #![proptest_config(config(150))]

    #[test]
    fn random_scenes((scene, camera) in scene_and_camera()) {
        assert_full(&scene, &camera);
    }

    #[test]
    fn a_raster_is_a_part_of_the_whole(
        (scene, camera) in scene_and_camera(), columns in 1..50_u32, rows in 1..50_u32,
    ) {
        assert_as_pixel_by_pixel(&scene, &camera, &Raster::shown_on(camera.image(), columns, rows));
    }
}

/// Tests planes through one point whose normals differ only by rounding errors, or by less than
/// double-double can represent.
#[test]
fn planes_that_nearly_coincide() {
    let scaled = |k: usize| (k + 1) as f64 * vec3(0.1, 0.2, 0.7);
    let tilted = |k: usize| vec3(1e-40 * k as f64, 0.2, 0.7);
    let crossing = |k: usize| vec3(1e-16 * (k as f64 - 2.0), 0.2, 1e-17 * k as f64);
    let normals: [&dyn Fn(usize) -> DVec3; 3] = [&scaled, &tilted, &crossing];
    for (eye, up) in [(DVec3::ZERO, DVec3::Y), (vec3(0.3, 1.7, 2.9), vec3(0.2, 1.0, 0.1))] {
        let camera = camera(eye, vec3(0.1, -0.3, -1.0), up, 41, 31).resolve().unwrap();
        for normal in normals {
            let at = |k: usize| Plane { point: vec3(0.5, -0.25, -5.0), normal: normal(k) };
            let scene = Scene::new(vec![], (0..6).map(at).collect()).unwrap();
            assert_full(&scene, &camera);
            let frame =
                trace_as::<f32>(&scene, &camera, &Raster::full(camera.image()), Outputs::default());
            let Steps { f64, double_double, exact, .. } = frame.steps;
            assert!(20 * (double_double + exact) < f64, "{:?}", frame.steps);
        }
    }
}

#[test]
fn planets_with_the_eye_just_above() {
    for radius in [5000.0, 1e6, 1e8] {
        for above in [1.0, 1e-3, 1e-7, 0.0, -1.0] {
            let planet = sphere([0.0, -radius - above, 0.0], radius);
            for view in [DVec3::NEG_Z, vec3(0.0, -1.0, -0.1), vec3(0.0, 0.1, -1.0)] {
                let camera =
                    camera(DVec3::ZERO, view, vec3(0.3, 1.0, 0.1), 61, 47).resolve().unwrap();
                assert_full(&spheres_only(vec![planet, sphere([0.0, 0.5, -5.0], 1.0)]), &camera);
            }
        }
    }
}

#[test]
fn tiny_and_far_spheres_behind_single_pixels() {
    let camera = camera(vec3(3.0, 1e3, -2.0), vec3(1.0, 2.0, -3.0), DVec3::Y, 25, 25);
    let camera = camera.resolve().unwrap();
    for far in [1e2, 1e6, 1e12] {
        for share in [1e-2, 1e-6, 1e-12] {
            let spheres = [(0, 0), (3, 4), (12, 12), (24, 1), (24, 24)].map(|(row, column)| {
                let ray = camera.ray_of_pixel(Pixel { row, column });
                Sphere { center: ray.at(far), radius: far * share }
            });
            let scene = spheres_only(spheres.to_vec());
            assert_full(&scene, &camera);
            let frame = trace(&scene, &camera, &Raster::full(camera.image()), Outputs::default());
            // Each sphere is visible in the pixel behind which it was placed.
            assert_eq!(frame.at(12, 12).object, Some(2));
            assert_eq!(frame.at(24, 1).object, Some(3));
        }
    }
}

/// Generates lists of spheres that `f32` cannot distinguish: next to one another, nested, or equal;
/// with the eye inside, on or beside their surface.
fn alike() -> impl Strategy<Value = Vec<Sphere>> {
    let bases = vec![
        sphere([0.2, -0.1, -5.0], 1.0),
        sphere([0.0, 0.0, -1.0], 2.0),
        // The first of these passes through the eye, the second only up to a rounding error.
        sphere([0.0, -3.0, 0.0], 3.0),
        sphere([0.3, -0.7, -0.1], 0.59_f64.sqrt()),
        sphere([1e4, 3e3, -9e4], 8e4),
    ];
    let moved = || (-1.0..1.0_f64, prop_oneof![Just(0.0), magnitude(-18.0, -6.0)]);
    let one = (prop::sample::select(bases), [moved(), moved(), moved()], moved()).prop_map(
        |(Sphere { center, radius }, by, wider)| {
            let offset = DVec3::from_array(by.map(|(sign, size)| sign * size * radius));
            Sphere { center: center + offset, radius: radius * (1.0 + wider.0 * wider.1) }
        },
    );
    prop::collection::vec(one, 2..40)
}

proptest! {
    #![proptest_config(config(150))]

    #[test]
    fn spheres_that_nearly_agree_are_told_apart(spheres in alike(), view in direction()) {
        let camera = camera(DVec3::ZERO, DVec3::NEG_Z + 0.3 * view, DVec3::Y, 17, 13);
        assert_full(&spheres_only(spheres), &camera.resolve().unwrap());
    }
}

#[test]
fn of_two_spheres_at_a_subnormal_t_the_nearer_is_seen() {
    let viewport = Viewport { width: 1e45, height: 1e45, distance: 1e45 };
    let camera = Camera { viewport, ..camera(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 5, 5) };
    let camera = camera.resolve().unwrap();
    let balls = [sphere([0.0, 0.0, -2.6], 1.0), sphere([0.0, 0.0, -2.5], 1.0)];
    assert_full(&spheres_only(balls.to_vec()), &camera);
    let frame = trace(
        &spheres_only(balls.to_vec()),
        &camera,
        &Raster::full(camera.image()),
        Outputs::default(),
    );
    assert_eq!(frame.at(2, 2).object, Some(1));
}

#[test]
fn lengths_near_the_ends_of_the_range() {
    for scale in [1e-300, 1e-150, 1e-70, 1e-55, 1e55, 1e70, 1e150, 1e300] {
        let ball = Sphere { center: scale * vec3(0.1, 0.0, -5.0), radius: scale };
        let around = Sphere { center: scale * vec3(0.0, 0.2, -6.0), radius: 8.0 * scale };
        let wall =
            Plane { point: scale * vec3(0.0, 0.0, -5.5), normal: scale * vec3(0.1, 0.0, 1.0) };
        let scene = Scene::new(vec![around, ball], vec![wall]).unwrap();
        for unit in [1e-300, 1e-100, 1e-60, 1.0, 1e60, 1e100, 1e300] {
            let viewport = Viewport { width: unit, height: unit, distance: unit };
            let camera = Camera { viewport, ..camera(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 19, 19) };
            let camera = camera.resolve().unwrap();
            assert_full(&scene, &camera);
            let frame = trace(&scene, &camera, &Raster::full(camera.image()), Outputs::default());
            // Where t is representable, the picture is the same in all units.
            if (scale / unit) > 1e-300 && (scale / unit) < 1e300 {
                assert_eq!(frame.at(9, 9).object, Some(1), "scale {scale:e}, unit {unit:e}");
                assert_eq!(frame.at(0, 0).object, Some(2), "scale {scale:e}, unit {unit:e}");
            }
        }
    }
}

#[test]
fn more_spheres_than_one_thread_takes_at_a_time() {
    let mut numbers = Numbers(2);
    let spheres = (0..30_000)
        .map(|_| Sphere { center: vec3(0.0, 0.0, -20.0) + numbers.point(10.0), radius: 0.05 })
        .collect();
    let scene = spheres_only(spheres);
    let camera = camera(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 33, 70).resolve().unwrap();
    assert_full(&scene, &camera);
}

#[test]
fn the_same_bits_on_any_number_of_threads() {
    let mut numbers = Numbers(1);
    let spheres = (0..20_000)
        .map(|_| Sphere { center: vec3(0.0, 0.0, -20.0) + numbers.point(10.0), radius: 0.1 })
        .collect();
    let scene = Scene::new(spheres, vec![plane([0.0, -3.0, 0.0], [0.0, 1.0, 0.2])]).unwrap();
    let camera = camera(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 200, 150).resolve().unwrap();
    let raster = Raster::full(camera.image());
    let with_threads = |threads| {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| {
            let frame =
                trace(&scene, &camera, &raster, Outputs { normal: true, ..Outputs::default() });
            let colors = shade(&frame, &scene, Shade::Lambert, |_| [200, 100, 50], |rgb| rgb);
            (frame, colors)
        })
    };
    let alone = with_threads(1);
    assert_eq!(alone, with_threads(2));
    assert_eq!(alone, with_threads(7));
}

/// Of objects at exactly the same t, the one listed first is visible.
#[test]
fn ties_go_to_the_object_listed_first() {
    let ball = sphere([0.0, 0.0, -5.0], 1.0);
    let wall = plane([0.0, 0.0, -6.0], [0.0, 0.0, 1.0]);
    let same_wall = plane([7.0, -2.0, -6.0], [0.0, 0.0, -3.0]);
    let scene = Scene::new(vec![ball, ball], vec![wall, same_wall]).unwrap();
    let camera = camera(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 31, 31).resolve().unwrap();
    let frame = trace(&scene, &camera, &Raster::full(camera.image()), Outputs::default());
    let mut seen = frame.object.clone();
    seen.sort_unstable();
    seen.dedup();
    assert_eq!(seen, [0, 2]);
    // These spheres touch one another, from inside and from outside, at t = 4 on the axis.
    let touching = vec![sphere([0.0, 0.0, -4.5], 0.5), ball, sphere([0.0, 0.0, -2.0], 2.0)];
    let ray = Ray { origin: vec3(0.0, 0.0, 0.0), direction: DVec3::NEG_Z };
    for first in 0..3 {
        let mut spheres = touching.clone();
        spheres.rotate_left(first);
        let hit = spheres_only(spheres).first_hit(&ray).unwrap();
        assert_eq!((hit.object, hit.t), (0, 4.0));
    }
}

#[test]
fn a_raster_shows_each_pixel_at_most_once() {
    let image = ImageSize::new(7, 3).unwrap();
    let shown = |columns, rows| {
        let raster = Raster::shown_on(image, columns, rows);
        (raster.columns().to_vec(), raster.rows().to_vec())
    };
    assert_eq!(shown(100, 100), ((0..7).collect(), (0..3).collect()));
    assert_eq!(shown(7, 2), ((0..7).collect(), vec![0, 2]));
    assert_eq!(shown(2, 1), (vec![1, 5], vec![1]));
    assert_eq!(shown(0, 0), (vec![3], vec![1]));
    assert_eq!(Raster::full(image).len(), 21);
}

/// The picture as text: a letter for each object.
fn as_text(frame: &Frame) -> String {
    let row = |row: &[u32]| -> String {
        row.iter().map(|object| "ABCDEF".chars().nth(*object as usize).unwrap_or('.')).collect()
    };
    let rows = frame.object.chunks(frame.raster().columns().len()).map(row);
    rows.fold(String::new(), |text, row| text + &row + "\n")
}

#[test]
fn two_balls_on_a_floor() {
    let scene = Scene::new(
        vec![sphere([-0.6, 0.0, -4.0], 1.0), sphere([1.0, -0.4, -3.0], 0.6)],
        vec![plane([0.0, -1.0, 0.0], [0.0, 1.0, 0.0])],
    )
    .unwrap();
    let viewport = Viewport { width: 2.0, height: 1.0, distance: 1.0 };
    let camera = Camera { viewport, ..camera(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 40, 20) };
    let camera = camera.resolve().unwrap();
    let frame = trace(&scene, &camera, &Raster::full(camera.image()), Outputs::default());
    expect![[r#"
        ........................................
        ........................................
        ........................................
        ........................................
        ........................................
        ..............AAAAA.....................
        .............AAAAAAAA...................
        ............AAAAAAAAA...................
        ............AAAAAAAAAA..................
        ............AAAAAAAAAA..BBBBB...........
        CCCCCCCCCCCCAAAAAAAAAACBBBBBBBCCCCCCCCCC
        CCCCCCCCCCCCAAAAAAAAAACBBBBBBBBCCCCCCCCC
        CCCCCCCCCCCCAAAAAAAAACCBBBBBBBBCCCCCCCCC
        CCCCCCCCCCCCCAAAAAAAACCBBBBBBBBCCCCCCCCC
        CCCCCCCCCCCCCCAAAAACCCCBBBBBBBBCCCCCCCCC
        CCCCCCCCCCCCCCCCCCCCCCCCBBBBBBCCCCCCCCCC
        CCCCCCCCCCCCCCCCCCCCCCCCCBBBBCCCCCCCCCCC
        CCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCC
        CCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCC
        CCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCCC
    "#]]
    .assert_eq(&as_text(&frame));
}

/// Tests spheres that cover thousands of pixels, which are drawn by separate code whose coefficients
/// come from exact numbers.
#[test]
fn spheres_that_fill_the_picture() {
    let spheres = [
        sphere([0.1, 0.2, -5.0], 2.4),
        sphere([0.0, -5001.0, 0.0], 5000.0),
        sphere([0.3, 0.1, 0.2], 9.0),
        sphere([0.0, 0.0, -1e9], 4e8),
        sphere([0.0, 0.0, -1.0], 1.0),
        sphere([-1.0, 0.5, -1.2], 1.1),
    ];
    let by_hand = Basis { u: DVec3::X, v: vec3(5e-10, 1.0, 0.0), w: DVec3::Z };
    for (index, ball) in spheres.into_iter().enumerate() {
        let scene = spheres_only(vec![ball, sphere([0.0, 0.0, -20.0], 18.0)]);
        for (view, up) in [(DVec3::NEG_Z, DVec3::Y), (vec3(0.1, -0.2, -1.0), vec3(0.3, 1.0, 0.1))] {
            let resolved = camera(DVec3::ZERO, view, up, 110, 80).resolve().unwrap();
            assert_full(&scene, &resolved);
        }
        let orientation = Orientation::Basis(by_hand);
        let image = ImageSize::new(90, 70).unwrap();
        let zoomed = Viewport { width: 1e-7, height: 1e-7, distance: 1.0 };
        for viewport in [Viewport::CANONICAL, zoomed] {
            let eye = vec3(1e-3 * index as f64, 0.0, 0.0);
            let resolved = Camera { eye, orientation, viewport, image }.resolve().unwrap();
            assert_full(&scene, &resolved);
        }
    }
}

/// The hit objects are the same whether t is stored in `f32` or `f64`, and equal those of each pixel's
/// ray, even if t is outside the range of `f32`, lengths are subnormal, or the viewport is of extreme
/// size.
#[test]
fn measures_at_the_ends_of_the_range() {
    let image = |width, height| ImageSize::new(width, height).unwrap();
    let tiny = Viewport { width: 1e-20, height: 1e-20, distance: 1e-20 };
    let far = Scene::new(
        vec![sphere([0.0, 0.0, -1e20], 3e19)],
        vec![plane([0.0, 0.0, -2e20], [0.0, 0.0, 1.0])],
    );
    let around = spheres_only(vec![sphere([5e-324; 3], 1e-323)]);
    let beside = spheres_only(vec![sphere([1e-6, 2e-6, 3e-6], 1e-7)]);
    let (view, up) = (vec3(1.0, 2.0, 3.0), DVec3::Y);
    let ball = spheres_only(vec![sphere([0.1, 0.3, -2.0], 0.8)]);
    let viewport = |width, height, distance| Viewport { width, height, distance };
    let cases = [
        (far.unwrap(), DVec3::NEG_Z, tiny, image(20, 20)),
        (around, vec3(-0.52, -0.52, -0.677), Viewport::CANONICAL, image(4, 4)),
        (beside.clone(), view, viewport(1.0, 1.0, 1e-310), image(3, 3)),
        (beside.clone(), view, viewport(1e300, 1e300, 1e-15), image(3, 3)),
        (beside, view, viewport(1e-310, 1e-310, 1e-310), image(5, 5)),
        (ball.clone(), vec3(0.1, 0.2, -1.0), viewport(1e36, 1.0, 1.0), image(1, 8192)),
        (ball.clone(), vec3(0.1, 0.2, -1.0), viewport(1e45, 1.0, 1.0), image(1, 8192)),
        (ball, vec3(0.1, 0.2, -1.0), viewport(1.0, 1e45, 1.0), image(8192, 1)),
    ];
    for (scene, view, viewport, image) in cases {
        let orientation = Orientation::View { view, up };
        let camera = Camera { eye: DVec3::ZERO, orientation, viewport, image }.resolve().unwrap();
        assert_full(&scene, &camera);
        let raster = Raster::full(image);
        let double = trace(&scene, &camera, &raster, Outputs::default());
        let single = trace_as::<f32>(&scene, &camera, &raster, Outputs::default());
        assert_eq!(double.object, single.object);
        assert!(double.object.iter().any(|object| *object != NO_OBJECT));
    }
}
