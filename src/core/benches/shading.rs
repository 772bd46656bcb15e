//! Measures shading, that is, computing the pixels' colours: median milliseconds per frame of 1920 x
//! 1080 pixels, on one thread.
//!
//! `cargo bench -p pinhole-core --bench shading`
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a benchmark prints and may fail")]

use std::hint::black_box;
use std::time::Instant;

use pinhole_core::*;

const ROUNDS: usize = 15;

fn camera() -> ResolvedCamera {
    let image = ImageSize::new(1920, 1080).unwrap();
    let orientation = Orientation::At { at: DVec3::new(0.1, 0.0, -5.0), up: DVec3::Y };
    let viewport = Viewport { width: 1.92, height: 1.08, distance: 1.0 };
    Camera { eye: DVec3::new(0.1, 0.05, 0.0), orientation, viewport, image }.resolve().unwrap()
}

/// Returns a grid of equal spheres in front of the eye that cover about 60 % of the picture.
fn grid(across: u32, down: u32, away: f64) -> Scene {
    let step = 1.92 * away / f64::from(across);
    let at = |k: u32, count: u32| (f64::from(k) - 0.5 * f64::from(count - 1)) * step;
    let spheres = (0..down).flat_map(|j| {
        (0..across).map(move |i| Sphere {
            center: DVec3::new(0.1 + at(i, across), at(j, down), -away),
            radius: 0.44 * step,
        })
    });
    Scene::new(spheres.collect(), vec![]).unwrap()
}

fn scenes() -> Vec<(&'static str, Scene)> {
    let ball = |center: [f64; 3], radius| Sphere { center: center.into(), radius };
    let floor = Plane { point: DVec3::new(0.0, -1.0, 0.0), normal: DVec3::new(0.0, 1.0, 0.0) };
    let three = vec![
        ball([-1.0, 0.0, -5.0], 1.0),
        ball([0.6, 0.2, -4.0], 0.7),
        ball([2.0, 0.5, -6.0], 1.2),
    ];
    vec![
        ("from inside one sphere", Scene::new(vec![ball([0.0; 3], 9.0)], vec![]).unwrap()),
        ("three on a plane", Scene::new(three, vec![floor]).unwrap()),
        ("1,000, far", grid(42, 24, 20.0)),
        ("58,000, far", grid(322, 180, 20.0)),
    ]
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn ms(mut work: impl FnMut()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        work();
        1e3 * start.elapsed().as_secs_f64()
    };
    median((0..ROUNDS).map(time).collect())
}

fn main() {
    let level = Level::new();
    println!("1920 x 1080, one thread, {ROUNDS} rounds, {level:?}; ms a frame\n");
    rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap().install(|| {
        for (name, scene) in scenes() {
            of_scene(level, name, &scene);
        }
    });
}

fn of_scene(level: Level, name: &str, scene: &Scene) {
    let camera = camera();
    let raster = Raster::full(camera.image());
    let frame = trace_as::<f32>(scene, &camera, &raster, Outputs::default());
    let hits = frame.object.iter().filter(|object| **object != NO_OBJECT).count();
    println!("{name}: {:.0} % hit", 100.0 * hits as f64 / raster.len() as f64);
    let traced = ms(|| {
        let outputs = Outputs::default();
        black_box(trace_at_level::<f32>(level, scene, &camera, &raster, outputs, |_| ()));
    });
    println!("  traced   {traced:6.2}");
    let colors: Vec<Rgb> =
        (0..scene.spheres().len() + scene.planes().len()).map(|i| [i as u8, 200, 90]).collect();
    for how in Shade::ALL {
        let paint = Paint {
            shade: how,
            color_of: |i: u32| colors[i as usize],
            to_pixel: |[r, g, b]: Rgb| [r, g, b, 255_u8],
        };
        let alone = ms(|| {
            black_box(shade_at_level(level, &frame, scene, &paint));
        });
        let mut pixels = vec![[0; 4]; raster.len()];
        let to_pixels = ms(|| {
            let (none, to) = (Outputs::NONE, &mut pixels[..]);
            let _: Frame<f32> = trace_painted(scene, &camera, &raster, none, &paint, to);
        });
        println!("  {:8} {alone:6.2}, traced and painted {to_pixels:6.2}", how.name());
    }
}
