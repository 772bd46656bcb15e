//! Measures what exact decisions cost: compares `pinhole-core`, whose every hit or miss is exact, with
//! a SIMD loop over the plain textbook formula, for one sphere, one megapixel and one thread, in a
//! single run.
//!
//! `cargo bench -p pinhole-core --bench certainty`; the SIMD level is the processor's best, or AVX2 with
//! `-- avx2`.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a benchmark prints and may fail")]

mod textbook;

use std::hint::black_box;
use std::time::Instant;

use pinhole_core::*;
use textbook::{Form, Loop};

const SIDE: u32 = 1024;
const ROUNDS: usize = 41;

fn camera() -> ResolvedCamera {
    let image = ImageSize::new(SIDE, SIDE).unwrap();
    let orientation = Orientation::At { at: DVec3::new(0.1, 0.0, -5.0), up: DVec3::Y };
    let viewport = Viewport { width: 2.0, height: 2.0, distance: 1.0 };
    Camera { eye: DVec3::new(0.1, 0.05, 0.0), orientation, viewport, image }.resolve().unwrap()
}

/// Returns a sphere on the camera's axis that covers about `share` of the picture. For a share of 0,
/// the sphere lies outside the picture.
fn sphere(share: f64) -> Sphere {
    let ahead = DVec3::new(0.1, 0.0, -5.0);
    match share {
        0.0 => Sphere { center: DVec3::new(40.0, 0.0, -5.0), radius: 1.0 },
        // This sphere is large enough for every ray to hit it.
        1.0 => Sphere { center: ahead, radius: 4.5 },
        _ => {
            // The outline is a circle of radius rho in the viewport: sin(angle) = r / |q|.
            let rho = (4.0 * share / std::f64::consts::PI).sqrt();
            let distance = (ahead - DVec3::new(0.1, 0.05, 0.0)).length();
            Sphere { center: ahead, radius: distance * rho / (1.0 + rho * rho).sqrt() }
        }
    }
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn level() -> Level {
    let best = Level::new();
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    if std::env::args().any(|argument| argument == "avx2") {
        return best.as_avx2().map_or(best, Level::Avx2);
    }
    best
}

fn main() {
    let level = level();
    println!("{SIDE} x {SIDE}, one sphere, one thread, {ROUNDS} interleaved rounds, {level:?}");
    println!("medians in ns a pixel; ratios to the textbook's two roots in the same precision\n");
    rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap().install(|| {
        for share in [0.0, 0.2, 0.785, 1.0] {
            compare(level, share);
        }
    });
}

fn compare(level: Level, share: f64) {
    let (camera, sphere) = (camera(), sphere(share));
    let scene = Scene::new(vec![sphere], vec![]).unwrap();
    let raster = Raster::full(camera.image());
    let mut single = trace_as::<f32>(&scene, &camera, &raster, Outputs::default());
    let mut double = trace_as::<f64>(&scene, &camera, &raster, Outputs::default());
    let pixels = single.object.len();
    let mut by_f32 = Loop::<f32>::new(&camera, &sphere);
    let mut by_f64 = Loop::<f64>::new(&camera, &sphere);
    let mut times = vec![Vec::new(); 5];
    for _ in 0..ROUNDS {
        let mut run = |index: usize, work: &mut dyn FnMut()| {
            let start = Instant::now();
            work();
            times[index].push(start.elapsed().as_nanos() as f64 / pixels as f64);
        };
        run(0, &mut || by_f32.run(level, Form::TwoRoots));
        run(1, &mut || by_f32.run(level, Form::OneRoot));
        run(2, &mut || by_f64.run(level, Form::TwoRoots));
        run(3, &mut || retrace_at_level(level, black_box(&mut single), &scene, &camera));
        run(4, &mut || retrace_at_level(level, black_box(&mut double), &scene, &camera));
    }
    let hits = single.object.iter().filter(|object| **object != NO_OBJECT).count();
    let wrong = |object: &[u32]| object.iter().zip(&single.object).filter(|(a, b)| a != b).count();
    let [two, one, two_f64, ladder_f32, ladder_f64] =
        <[f64; 5]>::try_from(times.into_iter().map(median).collect::<Vec<_>>()).unwrap();
    println!("coverage {:5.1} %   {:?}", 100.0 * hits as f64 / pixels as f64, single.steps);
    println!(
        "  textbook f32 {two:.3}, {} wrong; one root {one:.3}; textbook f64 {two_f64:.3}, {} wrong",
        wrong(&by_f32.object),
        wrong(&by_f64.object)
    );
    println!(
        "  ladder to f32 {ladder_f32:.3}: {:.2} of two roots, {:.2} of one root",
        ladder_f32 / two,
        ladder_f32 / one
    );
    println!("  ladder to f64 {ladder_f64:.3}: {:.2} of two roots in f64\n", ladder_f64 / two_f64);
}
