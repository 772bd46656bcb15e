//! Every pixel of crowds of spheres is right: the object that its ray hits first, and its `t`.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking and tells what it has looked at"
)]

mod common;
mod support;

use common::{Numbers, vec3};
use pinhole_core::*;
use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestRunner};
use support::crowds::{self, Crowd, ahead};
use support::every_pixel::{check, every_pixel_is_right};

/// What is wrong with a crowd's frame; tells what was looked at.
fn faults_of(crowd: &Crowd) -> Option<String> {
    let frame = crowd.trace();
    match check(&crowd.scene, &crowd.camera, &frame) {
        Ok(checked) if checked.objects >= crowd.objects => {
            println!("{}: {checked:?}", crowd.name);
            None
        }
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
    // One ball before another, both touched by the same pixels' rays exactly.
    let crowd = crowds::all().into_iter().find(|c| c.name == "ties with a plane").unwrap();
    let mut frame = crowd.trace();
    let tie = (0..frame.object.len()).find(|k| frame.t[*k] == 16.0 && frame.object[*k] < 320);
    let tie = tie.unwrap();
    // The plane is there too, at the same t, but is listed later.
    frame.object[tie] = 321;
    let found = check(&crowd.scene, &crowd.camera, &frame).unwrap_err();
    assert_eq!(found.keys().copied().collect::<Vec<_>>(), [tie]);
}

/// A camera and a crowd around it, by what they differ in.
#[derive(Clone, Debug)]
struct Seeds {
    spheres: u64,
    count: usize,
    image: [u32; 2],
    /// Powers of 10: the viewport's width, how much lower it is, the world's size, and how many
    /// worlds away from the world's origin the eye is.
    width: f64,
    aspect: f64,
    world: f64,
    away: f64,
    /// Powers of 10 that radii are spread over, in pixels.
    radii: [f64; 2],
    view: [f64; 3],
}

fn any_seeds() -> impl Strategy<Value = Seeds> {
    let counts = prop_oneof![1..=20_usize, 250..=260_usize, 300..=900_usize];
    let radii = (-1.5..1.5, 0.0..2.0).prop_map(|(low, more): (f64, f64)| [low, low + more]);
    let camera = (-1.0..3.0, -1.5..1.5, -3.0..3.0, prop_oneof![Just(-9.0), -2.0..6.0]);
    let view = prop_oneof![
        Just([0.0, 0.0, -1.0]),
        [-1.0..1.0, -1.0..1.0, 0.1..1.0].prop_map(|view: [f64; 3]| view)
    ];
    (any::<u64>(), counts, [1..60_u32, 1..60_u32], camera, radii, view).prop_map(
        |(spheres, count, image, (width, aspect, world, away), radii, view)| {
            Seeds { spheres, count, image, width, aspect, world, away, radii, view }
        },
    )
}

fn crowd_of(seeds: &Seeds) -> Crowd {
    let power = |x: f64| 10_f64.powf(x);
    let (world, width) = (power(seeds.world), power(seeds.width));
    let height = width * power(seeds.aspect);
    let mut numbers = Numbers(seeds.spheres);
    let away = world * power(seeds.away);
    let eye = away * numbers.point(1.0);
    let orientation = Orientation::View { view: seeds.view.into(), up: vec3(0.1, 1.0, 0.05) };
    let camera = Camera { eye, orientation, ..ahead([width, height], seeds.image) };
    let basis = camera.basis().unwrap();
    let [columns, rows] = seeds.image.map(f64::from);
    let pixel = (width / columns).min(height / rows);
    let one = |k: usize| {
        let depth = world * power(numbers.between(0.0, 1.0));
        let side = |numbers: &mut Numbers| depth * numbers.between(-0.55, 0.55);
        let (x, y) = (width * side(&mut numbers), height * side(&mut numbers));
        let radius = depth * pixel * power(numbers.between(seeds.radii[0], seeds.radii[1]));
        // A few behind and beside the eye.
        let z = if k % 16 == 15 { numbers.between(-1.0, 1.0) * depth } else { -depth };
        Sphere { center: eye + x * basis.u + y * basis.v + z * basis.w, radius }
    };
    let spheres = (0..seeds.count).map(one).collect();
    Crowd::new("random", spheres, camera)
}

#[test]
fn crowds_of_random_cameras_are_right() {
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap();
    for seed in [1, now.as_nanos() as u64] {
        println!("seed {seed}");
        let config = ProptestConfig {
            cases: 1000,
            failure_persistence: None,
            rng_seed: RngSeed::Fixed(seed),
            ..ProptestConfig::default()
        };
        let found = TestRunner::new(config).run(&any_seeds(), |seeds| {
            let crowd = crowd_of(&seeds);
            let faults = check(&crowd.scene, &crowd.camera, &crowd.trace());
            prop_assert!(faults.is_ok(), "{:?}", faults.unwrap_err());
            Ok(())
        });
        assert!(found.is_ok(), "{}", found.unwrap_err());
    }
}

/// The scenes of the benchmark at full size, 2 million pixels each.
///
/// ```text
/// cargo test --release -p pinhole-core --test crowds -- --ignored --nocapture
/// ```
#[test]
#[ignore = "takes minutes; see the command above"]
fn every_pixel_of_the_benchmarks_hard_scenes_is_right() {
    for listed in pinhole_yardstick::adversarial::all() {
        let start = std::time::Instant::now();
        let setting = listed.make();
        for number in [0, 3] {
            let posed = setting.camera(number);
            let raster = Raster::full(posed.image());
            let frame = trace_as::<f32>(&setting.scene, &posed, &raster, Outputs::default());
            let checked =
                every_pixel_is_right(&setting.name, &setting.scene, &as_given(&posed), &frame);
            let seconds = start.elapsed().as_secs_f64();
            println!("{} frame {number}: {seconds:.1} s, {checked:?}", setting.name);
        }
    }
}

/// The camera of a benchmark's scene, all of which look along -z with y up.
fn as_given(posed: &PosedCamera) -> Camera {
    let camera = Camera {
        eye: posed.eye(),
        orientation: Orientation::View { view: DVec3::NEG_Z, up: DVec3::Y },
        viewport: *posed.viewport(),
        image: posed.image(),
    };
    assert_eq!(camera.basis().as_ref(), Ok(posed.basis()));
    camera
}
