//! Measures the most expensive scenes: spheres that `f32` cannot distinguish, nested and equal spheres,
//! spheres that touch the eye, and spheres of sizes from 1e-290 to 1e290. Each is compared with an
//! ordinary scene of as many spheres.
//!
//! `cargo bench -p pinhole-core --bench worst`; words after `--` run only the families of scenes whose
//! names contain one of them. The frame has 320 x 180 pixels unless the family says otherwise, and is
//! traced by all threads.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a benchmark prints and may fail")]

use std::time::{Duration, Instant};

use pinhole_core::*;

const IMAGE: [u32; 2] = [320, 180];
const ROUNDS: usize = 3;

/// A measurement that takes longer than this is not repeated.
const LONG: Duration = Duration::from_secs(2);

/// A generator of pseudorandom numbers from 0 to 1, the same in every run (SplitMix64: Steele, Lea,
/// Flood, *Fast splittable pseudorandom number generators*, 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Returns a point of the cube from -1 to 1.
    fn point(&mut self) -> DVec3 {
        DVec3::from_array([(); 3].map(|()| 2.0 * self.next() - 1.0))
    }
}

type Family<T = Sphere> = (&'static str, usize, fn(usize) -> Vec<T>);

/// Families of planes: name, number of planes, and the planes.
const PLANE_FAMILIES: [Family<Plane>; 2] = [
    // The same plane, except for the rounding of the normals.
    ("planes alike", 11, |count| {
        let normal = |k: usize| (k + 1) as f64 * DVec3::new(0.1, 0.2, 0.7);
        (0..count).map(|k| Plane { point: AHEAD, normal: normal(k) }).collect()
    }),
    ("planes tilted", 20, |count| {
        let normal = |k: usize| DVec3::new(1e-40 * k as f64, 0.2, 0.7);
        (0..count).map(|k| Plane { point: AHEAD, normal: normal(k) }).collect()
    }),
];

fn ball(center: impl Into<DVec3>, radius: f64) -> Sphere {
    Sphere { center: center.into(), radius }
}

const AHEAD: DVec3 = DVec3::new(0.0, 0.0, -5.0);

/// The families: name, number of spheres, and the spheres.
const FAMILIES: [Family; 15] = [
    ("within 1e-9", 10_000, |count| {
        let mut random = Random(1);
        (0..count).map(|_| ball(AHEAD + 1e-9 * random.point(), 1.0)).collect()
    }),
    ("nearly equal", 500, |count| {
        let mut random = Random(2);
        (0..count).map(|_| ball(AHEAD + 1e-15 * random.point(), 1.0)).collect()
    }),
    ("touch the eye", 200, |count| {
        (1..=count).map(|k| ball([0.0, -(k as f64), 0.0], k as f64)).collect()
    }),
    // These spheres would touch the eye if their centres were not rounded.
    ("nearly touch it", 200, |count| {
        let (down, step) = (DVec3::new(0.1, -0.7, 0.0).normalize(), 0.1);
        (1..=count).map(|k| ball(step * k as f64 * down, step * k as f64)).collect()
    }),
    ("nested by an ulp", 1000, |count| {
        (0..count).map(|k| ball(AHEAD, 1.0 + k as f64 * f64::EPSILON)).collect()
    }),
    ("equal", 1000, |count| vec![ball(AHEAD, 1.0); count]),
    ("all lengths", 400, |count| {
        let size = |k: usize| 10_f64.powf(-290.0 + 580.0 * k as f64 / count as f64);
        (0..count).map(|k| ball(size(k) * AHEAD, size(k))).collect()
    }),
    // The eye is inside, and the basis irrational.
    ("two 1e-308 apart", 2, |count| {
        (0..count).map(|k| ball(0.1 * AHEAD + 1e-308 * k as f64, 1.0)).collect()
    }),
    ("nine 1e-308 apart", 9, |count| {
        (0..count).map(|k| ball(0.1 * AHEAD + 1e-308 * k as f64, 1.0)).collect()
    }),
    // Seen along the plane in which they touch.
    ("touch, alike", 200, |count| {
        let radius = |k: usize| 1.0 + k as f64 * f64::EPSILON;
        (0..count).map(|k| ball([0.0, -radius(k), 0.0], radius(k))).collect()
    }),
    ("touch, near plane", 200, |count| {
        (1..=count).map(|k| ball([0.0, -(k as f64), 0.0], k as f64)).collect()
    }),
    ("touch, far apart", 2, |_| {
        [1e300, 1e308].map(|radius| ball([0.0, -radius, 0.0], radius)).to_vec()
    }),
    // They meet in one circle, which the middle row shows.
    ("one circle", 60, |count| {
        // Right-angled triangles with one leg in common: n^2 = (radius - height) (radius + height).
        let n = 720.0;
        let small = (1..).map(|k| 2.0 * f64::from(k)).filter(|d| (n * n / d) % 2.0 == 0.0);
        let one = |d: f64| ball([0.0, (n * n / d - d) / 2.0, -5.0 * n], (n * n / d + d) / 2.0);
        small.take(count).map(one).collect()
    }),
    ("nearly one", 100_000, |count| {
        let mut random = Random(1);
        (0..count).map(|_| ball(AHEAD + 1e-9 * random.point(), 1.0)).collect()
    }),
    ("one cone", 100_000, |count| {
        let mut random = Random(3);
        let depth = |random: &mut Random| 10_f64.powf(4.0 * random.next());
        let one = |random: &mut Random| {
            let depth = depth(random);
            ball(depth * (AHEAD + 1e-3 * random.point()), depth)
        };
        (0..count).map(|_| one(&mut random)).collect()
    }),
];

/// Returns `count` equal spheres at random places in front of the eye.
fn ordinary(count: usize) -> Vec<Sphere> {
    let mut random = Random(4);
    let radius = 2.0 / (count as f64).cbrt();
    (0..count).map(|_| ball(AHEAD + 3.0 * random.point() + 2.0 * DVec3::NEG_Z, radius)).collect()
}

/// Returns the image of a family and the height of its viewport at distance 1.
fn view_of(name: &str) -> ([u32; 2], f64) {
    match name {
        "two 1e-308 apart" => ([400, 400], 1.0),
        "nine 1e-308 apart" => ([100, 100], 1.0),
        "touch, alike" => ([100, 100], 1e-2),
        "touch, near plane" | "touch, far apart" => ([100, 100], 1e-18),
        "one circle" => ([321, 181], 1.0),
        _ => (IMAGE, 1.0),
    }
}

fn camera(name: &str) -> ResolvedCamera {
    let ([width, height], side) = view_of(name);
    let image = ImageSize::new(width, height).unwrap();
    let aspect = f64::from(width) / f64::from(height);
    let viewport = Viewport { width: aspect * side, height: side, distance: 1.0 };
    let mut camera = Camera { viewport, image, ..Camera::CANONICAL };
    if name.contains("1e-308") {
        camera.orientation = Orientation::At { at: DVec3::new(0.1, 0.2, -1.0), up: DVec3::Y };
    }
    camera.resolve().unwrap()
}

fn time<T: Depth>(scene: &Scene, camera: &ResolvedCamera) -> (f64, Steps) {
    let (raster, mut steps) = (Raster::full(camera.image()), Steps::default());
    let mut best = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        steps = trace_as::<T>(scene, camera, &raster, Outputs::default()).steps;
        best = best.min(start.elapsed().as_secs_f64());
        if start.elapsed() > LONG {
            break;
        }
    }
    (best, steps)
}

fn main() {
    let only: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    let threads = rayon::current_num_threads();
    println!("{IMAGE:?} pixels, {threads} threads; the least of up to {ROUNDS} rounds\n");
    println!(
        "family             spheres   f32 ms  ordinary  ratio   f64 ms  ns/(pixel sphere)  steps"
    );
    let is_wanted =
        |name: &str| only.is_empty() || only.iter().any(|only| name.contains(only.as_str()));
    for (name, count, spheres) in FAMILIES {
        if !is_wanted(name) {
            continue;
        }
        let camera = camera(name);
        let pixels = camera.image().pixel_count() as f64;
        let scene = |spheres| {
            let scene = Scene::new(spheres, vec![]).unwrap();
            scene.make_index();
            scene
        };
        let (hard, easy) = (scene(spheres(count)), scene(ordinary(count)));
        let (single, steps) = time::<f32>(&hard, &camera);
        let (plain, _) = time::<f32>(&easy, &camera);
        let (double, _) = time::<f64>(&hard, &camera);
        println!(
            "{name:17} {count:8} {:8.1} {:9.2} {:6.0} {:8.1} {:12.1}         {} {} {}",
            1e3 * single,
            1e3 * plain,
            single / plain,
            1e3 * double,
            1e9 * single * threads as f64 / (pixels * count as f64),
            steps.f64,
            steps.double_double,
            steps.exact,
        );
    }
    for (name, count, planes) in PLANE_FAMILIES {
        if !is_wanted(name) {
            continue;
        }
        let (scene, camera) = (Scene::new(vec![], planes(count)).unwrap(), camera(name));
        let ((single, steps), (double, _)) =
            (time::<f32>(&scene, &camera), time::<f64>(&scene, &camera));
        let [single, double] = [single, double].map(|seconds| 1e3 * seconds);
        let Steps { f64, double_double, exact, .. } = steps;
        println!(
            "{name:17} {count:8} {single:8.1} {:25.1}         {f64} {double_double} {exact}",
            double
        );
    }
    single_rays();
}

/// Measures how long it takes to find the first hits of 2000 rays among 100,000 spheres, one ray at a
/// time.
fn single_rays() {
    let scene = Scene::new(ordinary(100_000), vec![]).unwrap();
    scene.make_index();
    let mut random = Random(5);
    let rays: Vec<Ray> = (0..2000)
        .map(|_| Ray::new([0.0; 3], (AHEAD + random.point()).to_array()).unwrap())
        .collect();
    let start = Instant::now();
    let hits = rays.iter().filter(|ray| scene.first_hit(ray).is_some()).count();
    println!(
        "\n2000 rays, 100000 spheres, one by one: {:.0} ms, {hits} hits",
        1e3 * start.elapsed().as_secs_f64()
    );
}
