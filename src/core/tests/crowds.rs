//! Tests that every pixel of pictures of many spheres is right: the object that its ray hits first, and
//! its `t`.

use pinhole_core::*;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

use crate::common::seed::config;
use crate::common::{Numbers, vec3};
use crate::support::crowds;
use crate::support::crowds::{Crowd, ahead};
use crate::support::every_pixel::{check, every_pixel_is_right};

/// Traces a crowd, and describes the pixels that are wrong; `None` if there are none.
fn faults_of(crowd: &Crowd) -> Option<String> {
    let frame = crowd.trace();
    match check(&crowd.scene, &crowd.camera, &frame) {
        Ok(checked) if checked.objects >= crowd.objects => None,
        Ok(checked) => Some(format!("{} shows too little: {checked:?}", crowd.name)),
        Err(faults) => {
            let shown: Vec<&str> = faults.values().take(5).map(String::as_str).collect();
            Some(format!("{}, {} pixels:\n{}", crowd.name, faults.len(), shown.join("\n")))
        }
    }
}

#[test]
fn crowds_are_right() {
    let failed: Vec<String> = crowds::all().iter().filter_map(faults_of).collect();
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}

/// Returns a camera at the origin that looks along -z, with square pixels of size `slope` in a viewport
/// at distance 1.
fn with_pixels(width: u32, height: u32, slope: f64) -> Camera {
    let viewport = Viewport {
        width: slope * f64::from(width),
        height: slope * f64::from(height),
        distance: 1.0,
    };
    Camera { viewport, image: ImageSize::new(width, height).unwrap(), ..Camera::CANONICAL }
}

fn assert_right(name: &str, spheres: Vec<Sphere>, camera: &Camera) {
    let scene = Scene::new(spheres, vec![]).unwrap();
    let resolved = camera.resolve().unwrap();
    let raster = Raster::full(resolved.image());
    let frame = trace_as::<f32>(&scene, &resolved, &raster, Outputs::default());
    every_pixel_is_right(name, &scene, camera, &frame);
}

/// Tests rows of a large sphere that start far from a pixel's centre c and end very close to it: there,
/// `S^2 = (c - start) (end - c)`, from which t is computed, must not lose digits by cancellation. Pixel
/// (118, 246) of the camera is such an end; another sphere is then placed in it, nearer by a few
/// `f32::EPSILON`.
#[test]
fn a_wide_row_that_ends_at_a_pixels_centre_is_right() {
    let camera = with_pixels(400, 300, 0.005291035911916648);
    let large = Sphere::new([-0.31982593425559647, 0.032220910606067854, -1.0], 0.5605967098854855)
        .unwrap();
    assert_right("ends at a centre", vec![large], &camera);

    let pixel = Pixel { row: 118, column: 246 };
    let resolved = camera.resolve().unwrap();
    let ray = resolved.ray_of_pixel(pixel);
    let t = large.roots(&ray).first_positive().unwrap();
    for nearer in [1.5, 2.5, 3.5] {
        let t = t * (1.0 - nearer * f64::from(f32::EPSILON));
        let center = ray.at(t) + 0.02 * ray.direction.normalize();
        let small = Sphere::new(center.to_array(), 0.02).unwrap();
        for spheres in [vec![small, large], vec![large, small]] {
            assert_right(&format!("nearer by {nearer}"), spheres, &camera);
        }
    }
}

/// Tests large spheres far to the side of the view, for which `b = q . d` (q from the eye to the
/// centre, d the direction) falls to a small fraction along a row.
#[test]
fn a_wide_row_along_which_b_falls_is_right() {
    let camera = with_pixels(3840, 2160, 0.0010788974128933709);
    for radius in [0.616430386754667, 0.6164303867543] {
        let sphere =
            Sphere::new([-0.47597771463472544, -0.02708509815350152, -1.0], radius).unwrap();
        assert_right("b falls", vec![sphere], &camera);
    }
}

/// Tests large spheres on both sides of the view, for which `b = q . d` varies along a row by several
/// times its smallest value.
#[test]
fn a_wide_row_along_which_b_varies_much_is_right() {
    let camera = with_pixels(640, 360, 1.0 / 360.0);
    for side in [-1.0, 1.0] {
        for (x, y, radius) in
            [(5.37, 0.18, 3.29), (8.0, -1.5, 4.5), (3.5, 2.0, 4.2), (11.0, 0.0, 5.5)]
        {
            let sphere = Sphere::new([side * x, y, -6.3], radius).unwrap();
            assert_right("b varies", vec![sphere], &camera);
        }
    }
}

/// Returns the largest error of a frame's t, in ulps of `f32`.
fn largest_error(scene: &Scene, camera: &Camera) -> f64 {
    let resolved = camera.resolve().unwrap();
    let raster = Raster::full(resolved.image());
    let drawn = trace_as::<f32>(scene, &resolved, &raster, Outputs::default());
    let exact = trace_as::<f64>(scene, &resolved, &raster, Outputs::default());
    let error = |(drawn, exact): (&f32, &f64)| {
        let ulp = f64::from(drawn.next_up()) - f64::from(*drawn);
        (f64::from(*drawn) - exact).abs() / ulp
    };
    let pairs = drawn.t.iter().zip(&exact.t);
    pairs.filter(|(drawn, _)| drawn.is_finite()).map(error).fold(0.0, f64::max)
}

/// Tests spheres whose size is near the limit up to which the faster code for small spheres draws them,
/// everywhere in the picture. The limit follows from the bound of the error of t. The errors must reach
/// more than half an ulp, which is due to the last rounding, but less than one.
#[test]
fn spheres_as_large_as_small_ones_can_be_are_within_an_ulp() {
    let mut largest: f64 = 0.0;
    for (seed, slope) in [(71, 1.0 / 1080.0), (72, 1.0 / 300.0), (73, 1.0 / 64.0)] {
        let camera = with_pixels(320, 200, slope);
        let mut numbers = Numbers(seed);
        let mut between = |low, high| numbers.between(low, high);
        let mut sphere = || {
            let z = between(3.0, 30.0);
            let (x, y) = (between(-150.0, 150.0) * slope * z, between(-90.0, 90.0) * slope * z);
            Sphere::new([x, y, -z], between(0.1, 1.2) * z / 22.0).unwrap()
        };
        let spheres: Vec<Sphere> = (0..300).map(|_| sphere()).collect();
        assert_right(&format!("slope {slope}"), spheres.clone(), &camera);
        let scene = Scene::new(spheres, vec![]).unwrap();
        largest = largest.max(largest_error(&scene, &camera));
    }
    println!("largest error of t: {largest:.3} ulp");
    assert!((0.55..1.0).contains(&largest), "{largest}");
}

/// Returns spheres behind the eye, so many that a spatial index is used.
fn behind() -> Vec<Sphere> {
    (0..300).map(|k| Sphere::new([f64::from(k), 0.0, 9.0], 0.25).unwrap()).collect()
}

/// Tests pixels that are up to a thousand times as high as they are wide, where a rounding error that
/// is small in rows is large in columns.
#[test]
fn outlines_in_pixels_far_from_square_are_right() {
    for (height, ratio) in [(16_383, 1024.0_f64), (16_383, 64.0), (1001, 1024.0)] {
        let slope = 1.0 / ratio.sqrt();
        let viewport = Viewport {
            width: 3.0 * slope,
            height: f64::from(height) * ratio * slope,
            distance: 1.0,
        };
        let image = ImageSize::new(3, height).unwrap();
        let camera = Camera { viewport, image, ..Camera::CANONICAL };
        // The first sphere is the one with which an error was found.
        let mut spheres = vec![([1.0736941544047746e-6, 0.03124999998390639, -1.0], 1.0 / 32.0)];
        for k in -4..=4 {
            let (x, below) = (1e-6 * f64::from(k), 1e-11 * f64::from(k));
            spheres.push(([x, (slope * slope - x * x).sqrt() - below, -1.0], slope));
            spheres.push(([x, 0.8 * slope - below, -1.0], 0.8 * slope));
        }
        for (center, radius) in spheres {
            let sphere = Sphere::new(center, radius).unwrap();
            assert_right("high pixels", vec![sphere], &camera);
            let many: Vec<Sphere> = behind().into_iter().chain([sphere]).collect();
            assert_right("high pixels, many spheres", many, &camera);
        }
    }
}

/// Tests a basis that is given by hand and is not quite orthonormal, nearly by as much as is allowed.
/// The outline's bounds must include this error.
#[test]
fn the_last_row_of_an_outline_is_not_lost() {
    let basis = Basis { u: DVec3::X, v: DVec3::Y, w: vec3(0.0, 2.3e-13, 1.0) };
    let viewport = Viewport { width: 3.0 * 0.99e-6, height: 2401e-11, distance: 1.0 };
    let image = ImageSize::new(3, 2401).unwrap();
    let orientation = Orientation::Basis(basis);
    let camera = Camera { orientation, viewport, image, ..Camera::CANONICAL };
    for short in 0..40 {
        let radius = (1100.0 - 0.002 * f64::from(short)) * 1e-11;
        let sphere = Sphere::new([0.0, 0.0, -1.0], radius).unwrap();
        let many: Vec<Sphere> = behind().into_iter().chain([sphere]).collect();
        assert_right("the last row", many, &camera);
    }
}

#[test]
fn the_checker_finds_what_is_wrong() {
    let few = |name| crowds::all().into_iter().find(|crowd| crowd.name == name).unwrap();
    for name in ["256 spheres", "each twice", "ties with a plane", "outlines through pixels, few"] {
        let crowd = few(name);
        let right = crowd.trace();
        let is_wrong = |change: &dyn Fn(&mut Frame<f32>) -> Option<usize>| {
            let mut frame = right.clone();
            let Some(pixel) = change(&mut frame) else { return };
            let found = check(&crowd.scene, &crowd.camera, &frame).unwrap_err();
            assert_eq!(found.keys().copied().collect::<Vec<_>>(), [pixel], "{name}: {found:?}");
        };
        let hit = right.object.iter().position(|object| *object != NO_OBJECT).unwrap();
        for by in [-3, 3] {
            is_wrong(&|frame| {
                frame.t[hit] = f32::from_bits(frame.t[hit].to_bits().wrapping_add_signed(by));
                Some(hit)
            });
        }
        is_wrong(&|frame| {
            (frame.t[hit], frame.object[hit]) = (f32::INFINITY, NO_OBJECT);
            Some(hit)
        });
        is_wrong(&|frame| {
            let none = frame.object.iter().position(|object| *object == NO_OBJECT)?;
            (frame.t[none], frame.object[none]) = (frame.t[hit], frame.object[hit]);
            Some(none)
        });
        is_wrong(&|frame| {
            // The neighbour's object, which is not first here.
            let differ = |k: &usize| {
                frame.object[*k] != frame.object[k + 1] && frame.object[k + 1] != NO_OBJECT
            };
            let edge = (0..frame.object.len() - 1).find(differ)?;
            frame.object[edge] = frame.object[edge + 1];
            Some(edge)
        });
    }
}

#[test]
fn the_checker_decides_ties_and_touches() {
    let crowd = crowds::all().into_iter().find(|c| c.name == "ties with a plane").unwrap();
    let mut frame = crowd.trace();
    let tie = (0..frame.object.len()).find(|k| frame.t[*k] == 16.0 && frame.object[*k] < 320);
    let tie = tie.unwrap();
    // The plane is there too, at the same t, but is listed later.
    frame.object[tie] = 321;
    let found = check(&crowd.scene, &crowd.camera, &frame).unwrap_err();
    assert_eq!(found.keys().copied().collect::<Vec<_>>(), [tie]);
}

/// The random parameters of a camera and of the spheres around it.
#[derive(Clone, Debug)]
struct Seeds {
    spheres: u64,
    count: usize,
    planes: usize,
    image: [u32; 2],
    powers: Powers,
    view: [f64; 3],
}

/// Powers of 10.
#[derive(Clone, Debug)]
struct Powers {
    /// The viewport's width over its distance, and its height over its width.
    width: f64,
    aspect: f64,
    /// The viewport's distance over the world's size.
    distance: f64,
    world: f64,
    /// Distance of the eye from the world's origin, relative to `world`.
    away: f64,
    /// The range of radii, in pixels.
    radii: [f64; 2],
}

fn any_seeds() -> impl Strategy<Value = Seeds> {
    let counts = prop_oneof![1..=20_usize, 250..=260_usize, 300..=900_usize];
    let images = prop_oneof![
        4 => [1..60_u32, 1..60_u32],
        1 => [1000..=16_384_u32, 1..=3_u32],
        1 => [1..=3_u32, 1000..=16_384_u32],
    ];
    let radii = (-1.5..1.5, 0.0..2.0).prop_map(|(low, more): (f64, f64)| [low, low + more]);
    let camera = (
        prop_oneof![3 => -1.0..3.0, 1 => 3.0..8.0],
        -1.5..1.5,
        prop_oneof![Just(0.0), -4.0..4.0],
        prop_oneof![3 => -3.0..3.0, 1 => -14.0..14.0],
        prop_oneof![Just(-9.0), -2.0..6.0],
    );
    let view = prop_oneof![
        Just([0.0, 0.0, -1.0]),
        [-1.0..1.0, -1.0..1.0, 0.1..1.0].prop_map(|view: [f64; 3]| view)
    ];
    let planes = prop_oneof![Just(0_usize), 1..4_usize];
    (any::<u64>(), counts, planes, images, camera, radii, view).prop_map(
        |(spheres, count, planes, image, (width, aspect, distance, world, away), radii, view)| {
            let powers = Powers { width, aspect, distance, world, away, radii };
            Seeds { spheres, count, planes, image, powers, view }
        },
    )
}

fn crowd_of(seeds: &Seeds) -> Crowd {
    let power = |x: f64| 10_f64.powf(x);
    let Powers { width, aspect, distance, world, away, radii } = seeds.powers;
    let (world, width) = (power(world), power(width));
    let height = width * power(aspect);
    let mut numbers = Numbers(seeds.spheres);
    let eye = world * power(away) * numbers.point(1.0);
    let distance = world * power(distance);
    let camera = Camera {
        eye,
        orientation: Orientation::View { view: seeds.view.into(), up: vec3(0.1, 1.0, 0.05) },
        viewport: Viewport { width: width * distance, height: height * distance, distance },
        ..ahead([1.0, 1.0], seeds.image)
    };
    let basis = camera.basis().unwrap();
    let [columns, rows] = seeds.image.map(f64::from);
    let pixel = (width / columns).min(height / rows);
    let one = |k: usize| {
        let depth = world * power(numbers.between(0.0, 1.0));
        let side = |numbers: &mut Numbers| depth * numbers.between(-0.55, 0.55);
        let (x, y) = (width * side(&mut numbers), height * side(&mut numbers));
        let pixels = power(numbers.between(radii[0], radii[1]));
        // In a wide-angle view, a pixel may be wider than its distance from the eye.
        let radius = depth * (pixel * pixels).min(numbers.between(0.1, 1.1));
        // A few behind and beside the eye.
        let z = if k % 16 == 15 { numbers.between(-1.0, 1.0) * depth } else { -depth };
        Sphere { center: eye + x * basis.u + y * basis.v + z * basis.w, radius }
    };
    let mut spheres: Vec<Sphere> = (0..seeds.count).map(one).collect();
    if seeds.spheres.is_multiple_of(4) {
        // Some of them twice, not side by side.
        spheres.extend_from_within(..seeds.count / 3);
    }
    let plane = |_| Plane {
        point: spheres[0].center + world * numbers.point(1.0),
        normal: numbers.point(1.0),
    };
    let planes = (0..seeds.planes).map(plane).collect();
    Crowd::new("random", spheres, camera).with_planes(planes).showing(0)
}

/// Checks this many random crowds.
fn check_random(cases: u32) {
    let found = TestRunner::new(config(cases)).run(&any_seeds(), |seeds| {
        let faults = faults_of(&crowd_of(&seeds));
        prop_assert!(faults.is_none(), "{}", faults.unwrap_or_default());
        Ok(())
    });
    assert!(found.is_ok(), "{}", found.unwrap_err());
}

#[test]
fn crowds_of_random_cameras_are_right() {
    check_random(200);
}

/// Checks many more random cameras and crowds than the test above.
///
/// ```text
/// PROPTEST_RNG_SEED=$RANDOM cargo test --release -p pinhole-core --test core many_random -- --ignored --nocapture
/// ```
#[test]
#[ignore = "takes minutes; see the command above"]
fn crowds_of_many_random_cameras_are_right() {
    check_random(10_000);
}

/// Checks every pixel of the benchmark's adversarial scenes at full size, 2 million pixels each.
///
/// ```text
/// cargo test --release -p pinhole-core --test core hard_scenes -- --ignored --nocapture
/// ```
#[test]
#[ignore = "takes minutes; see the command above"]
fn every_pixel_of_the_benchmarks_hard_scenes_is_right() {
    for listed in crate::yardstick::bench::adversarial::all() {
        let start = std::time::Instant::now();
        let setting = (listed.make)();
        for number in [0, 3] {
            let resolved = setting.camera(number);
            let raster = Raster::full(resolved.image());
            let frame = trace_as::<f32>(&setting.scene, &resolved, &raster, Outputs::default());
            let checked =
                every_pixel_is_right(listed.name, &setting.scene, &as_given(&resolved), &frame);
            let seconds = start.elapsed().as_secs_f64();
            println!("{} frame {number}: {seconds:.1} s, {checked:?}", listed.name);
        }
    }
}

/// Returns the camera from which `resolved` was made, which the benchmark does not provide. In all its
/// scenes, y is up.
fn as_given(resolved: &ResolvedCamera) -> Camera {
    let (up, ahead) = (DVec3::Y, DVec3::NEG_Z);
    let (viewport, image, eye) = (*resolved.viewport(), resolved.image(), resolved.eye());
    let cameras = [Orientation::View { view: ahead, up }, Orientation::At { at: ahead, up }]
        .map(|orientation| Camera { eye, orientation, viewport, image });
    cameras.into_iter().find(|camera| camera.resolve() == Ok(*resolved)).unwrap()
}

/// Returns spheres of which `f64` cannot tell which one a ray meets first, in the way of the given
/// number.
fn coincident(way: u32, numbers: &mut Numbers) -> Vec<Sphere> {
    let mut between = |low: f64, high: f64| numbers.between(low, high);
    let size = 10_f64.powf(between(-17.0, -6.0));
    let whole = |x: f64| x.floor();
    let one = |k: f64, between: &mut dyn FnMut(f64, f64) -> f64| {
        let off = size * DVec3::new(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0));
        let ahead = DVec3::new(0.0, 0.0, -3.0);
        match way {
            0 => (ahead + off, 2.0 + size * between(-1.0, 1.0)),
            1 => (ahead + 1e-308 * k * DVec3::X, 2.0),
            // They touch in one point, ahead or in the eye.
            2 => (ahead + k * DVec3::new(1.0, 2.0, -2.0), 3.0 * k),
            3 => (-k * DVec3::Y, k),
            4 => (-(1.0 + k * f64::EPSILON) * DVec3::Y, 1.0 + k * f64::EPSILON),
            5 => (ahead, 2.0 + k * f64::EPSILON),
            // The eye is inside.
            6 => (0.1 * ahead + off, 2.0 + size * between(-1.0, 1.0)),
            _ => (1e300_f64.powf(k / 9.0) * ahead, 2.0 * 1e300_f64.powf(k / 9.0)),
        }
    };
    (0..9)
        .map(|_| one(whole(between(1.0, 10.0)), &mut between))
        .map(|(center, radius)| Sphere { center, radius })
        .collect()
}

/// Every pixel of a frame shows what the exact order of a single ray's hits finds, which takes no
/// difference of two spheres.
#[test]
fn frames_of_coincident_spheres_show_what_single_rays_hit() {
    let mut numbers = Numbers(71);
    for case in 0..64 {
        let way = case % 8;
        let slope = if way == 4 { 1e-4 } else { 0.02 };
        let aside = if case < 32 { 0.0 } else { 0.1 * numbers.between(-1.0, 1.0) };
        let (at, up) = (DVec3::new(aside, 0.3 * aside, -1.0), DVec3::Y);
        let orientation = Orientation::At { at, up };
        let camera = Camera { orientation, ..with_pixels(33, 33, slope) };
        let scene = Scene::new(coincident(way, &mut numbers), vec![]).unwrap();
        let resolved = camera.resolve().unwrap();
        let raster = Raster::full(resolved.image());
        let frame = trace_as::<f32>(&scene, &resolved, &raster, Outputs::default());
        for row in 0..33 {
            for column in 0..33 {
                let ray = resolved.exact_ray(Pixel { row, column });
                let expected = scene.first_hit_of(&ray).map(|root| root.object);
                let found = frame.at(row as usize, column as usize).object;
                assert_eq!(found, expected, "{way}: {row}, {column} of {:?}", scene.spheres());
            }
        }
    }
}
