//! Tests of the known intersection methods: they agree on ordinary scenes, and fail where their
//! documentation says so.

use pinhole_core::methods::*;
use pinhole_core::*;

use crate::common::{Numbers, camera, first_hit_by, plane, roots_of, sphere, vec3};

fn lecture_scene() -> Scene {
    let spheres = vec![
        sphere([0.0, 0.0, -5.0], 1.0),
        sphere([1.5, 0.5, -7.0], 1.5),
        sphere([-1.0, -0.5, -4.0], 0.5),
        sphere([0.25, 0.25, 1.0], 30.0),
    ];
    Scene::new(spheres, vec![plane([0.0, -1.0, 0.0], [0.0, 2.0, 0.5])]).unwrap()
}

fn resolve(width: u32, height: u32) -> ResolvedCamera {
    camera(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, width, height).resolve().unwrap()
}

/// Maximum relative error of t due to rounding on an ordinary scene.
fn tolerance(precision: Precision) -> f64 {
    match precision {
        Precision::F32 => 1e-4,
        Precision::F64 => 1e-12,
    }
}

#[test]
fn names_are_unique_and_read_back() {
    let expected = "ladder-f32 ladder double-double textbook-f32 textbook-f64 half-b-f32 half-b-f64 kahan-f32 kahan-f64 \
        perpendicular-f32 perpendicular-f64 closest-point-f32 closest-point-f64 recentred-f32 \
        recentred-f64 lagrange-f32 lagrange-f64";
    let names: Vec<_> = Method::of_frames().map(Method::name).collect();
    assert_eq!(names.join(" "), expected);
    for method in Method::of_frames() {
        assert_eq!(Method::from_name(method.name()), Some(method));
        assert!(!method.source().is_empty() && method.about().ends_with('.'), "{method}");
    }
    assert_eq!(Method::from_name("newton"), None);
}

#[test]
fn on_an_ordinary_scene_all_methods_agree() {
    let scene = lecture_scene();
    let mut numbers = Numbers(1);
    let mut hits = 0;
    for _ in 0..2000 {
        let ray = Ray { origin: numbers.point(0.5), direction: numbers.point(1.0) };
        let right = scene.first_hit(&ray).unwrap();
        // Where the outline or another object is too near, rounding may decide.
        let is_clear = roots_of(&scene, &ray).iter().filter(|root| root.t > 0.0).all(|root| {
            root.normal.dot(ray.direction.normalize()).abs() > 0.05
                && (root.t == right.t || (root.t - right.t).abs() > 0.05 * right.t)
        });
        if !is_clear || right.t < 0.05 {
            continue;
        }
        hits += 1;
        for method in Method::all() {
            let hit = first_hit_by(method, &scene, &ray).unwrap();
            let tolerance = tolerance(method.precision());
            assert_eq!(hit.object, right.object, "{method} on {ray:?}");
            assert!((hit.t - right.t).abs() <= tolerance * right.t, "{method}: {hit:?} {right:?}");
            let turned = (hit.normal - right.normal).length();
            assert!(turned <= 20.0 * tolerance, "{method}: {hit:?} {right:?}");
        }
    }
    assert!(hits > 1000, "{hits}");
}

#[test]
fn a_picture_is_what_each_pixel_says() {
    let (scene, camera) = (std::sync::Arc::new(lecture_scene()), resolve(31, 17));
    let raster = Raster::shown_on(camera.image(), 29, 17);
    for method in Method::of_frames() {
        let picture = trace_by(method, &scene, &camera, &raster);
        let mut kernel = frame_kernel(method, &scene, &camera, &raster);
        kernel.run();
        let mut seen = std::collections::BTreeSet::new();
        for (index, object) in picture.object.iter().enumerate() {
            let (row, column) = (index / 29, index % 29);
            let hit = kernel.hit(index);
            let expected = hit.map_or((NO_OBJECT, f64::INFINITY), |hit| (hit.object, hit.t));
            assert_eq!((*object, picture.t[index]), expected, "{method} at {row}, {column}");
            seen.insert(*object);
            if method.precision() == Precision::F64 && matches!(method, Method::Known(..)) {
                let pixel = Pixel { row: raster.rows()[row], column: raster.columns()[column] };
                let of_ray = first_hit_by(method, &scene, &camera.ray_of_pixel(pixel));
                assert_eq!(hit, of_ray, "{method} at {row}, {column}");
            }
        }
        assert!(seen.len() >= 4, "{method} sees {seen:?}");
    }
}

#[test]
fn a_list_of_rays_is_what_each_ray_says() {
    let mut numbers = Numbers(2);
    let cases: Vec<(Scene, Ray)> = (0..200)
        .map(|_| {
            let ray = Ray { origin: numbers.point(20.0), direction: numbers.point(1.0) };
            (lecture_scene(), ray)
        })
        .collect();
    for method in Method::all() {
        let mut kernel = ray_kernel(method, &cases).unwrap();
        assert_eq!(kernel.hit(0), None);
        kernel.run();
        for (index, (scene, ray)) in cases.iter().enumerate() {
            assert_eq!(kernel.hit(index), first_hit_by(method, scene, ray), "{method}");
        }
    }
}

#[test]
fn among_equals_the_object_listed_first_wins() {
    let twice = vec![sphere([0.0, 0.0, -5.0], 1.0); 2];
    let touching = plane([0.0, 0.0, -4.0], [0.0, 0.0, 1.0]);
    let scene = Scene::new(twice, vec![touching; 2]).unwrap();
    let ray = Ray { origin: DVec3::ZERO, direction: DVec3::NEG_Z };
    for method in Method::all() {
        let hit = first_hit_by(method, &scene, &ray).unwrap();
        assert_eq!((hit.object, hit.t, hit.normal), (0, 4.0, DVec3::Z), "{method}");
    }
}

#[test]
fn a_tangent_is_a_hit_and_behind_is_none() {
    let scene = Scene::new(vec![sphere([0.0, 1.0, -5.0], 1.0)], vec![]).unwrap();
    for method in Method::all() {
        let first =
            |direction| first_hit_by(method, &scene, &Ray { origin: DVec3::ZERO, direction });
        assert_eq!(first(DVec3::NEG_Z).map(|hit| hit.t), Some(5.0), "{method}");
        assert_eq!(first(DVec3::Z), None, "{method}");
    }
}

/// Tests the median relative error of t, over a picture's pixels, for the lecture's floor, a huge
/// sphere.
#[test]
fn the_courses_floor_shows_what_the_textbook_loses_in_f32() {
    let scene = Scene::new(vec![sphere([0.0, -5001.0, 0.0], 5000.0)], vec![]).unwrap();
    let camera = resolve(64, 64);
    let raster = Raster::full(camera.image());
    let right = trace_by(Method::Ladder, &scene, &camera, &raster);
    let median_error = |name: &str| {
        let found = trace_by(Method::from_name(name).unwrap(), &scene, &camera, &raster);
        let mut errors: Vec<f64> = (0..raster.len())
            .filter(|i| right.object[*i] == 0 && found.object[*i] == 0)
            .map(|i| (found.t[i] - right.t[i]).abs() / right.t[i])
            .collect();
        assert!(errors.len() > 1500, "{}", errors.len());
        errors.sort_by(f64::total_cmp);
        errors[errors.len() / 2]
    };
    let textbook = median_error("textbook-f32");
    assert!((3e-5..1e-3).contains(&textbook), "{textbook:e}");
    for method in Method::all().filter(|m| m.precision() == Precision::F64) {
        let error = median_error(method.name());
        assert!(error < 1e-11, "{method}: {error:e}");
    }
}

#[test]
fn whatever_is_not_a_number_is_no_hit() {
    let huge = 1e200;
    let extreme = [
        sphere([huge, huge, -huge], huge),
        sphere([0.0, 0.0, -5.0], 1e-300),
        sphere([3e38, 0.0, 0.0], 1e38),
    ];
    let scene =
        Scene::new(extreme.to_vec(), vec![plane([0.0, -huge, 0.0], [0.0, 1e-200, 0.0])]).unwrap();
    let directions =
        [vec3(0.0, 0.0, -1.0), vec3(1e-200, 1e-200, -1e-200), vec3(huge, huge, -huge), DVec3::ZERO];
    // The ladder is excluded, because it decides such rays right even if their t is outside the range
    // of `f64`.
    for method in Method::all().filter(|method| *method != Method::Ladder) {
        for direction in directions.into_iter().chain([vec3(f64::NAN, 0.0, 1.0)]) {
            let ray = Ray { origin: vec3(0.0, 0.0, 1e-300), direction };
            if let Some(hit) = first_hit_by(method, &scene, &ray) {
                assert!(hit.t > 0.0 && hit.t.is_finite(), "{method}: {hit:?}");
            }
        }
    }
    for method in Method::all() {
        let empty = Scene::default();
        let picture =
            trace_by(method, &empty, &resolve(3, 2), &Raster::full(resolve(3, 2).image()));
        assert_eq!(picture.object, [NO_OBJECT; 6], "{method}");
    }
}
