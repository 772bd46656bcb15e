//! Scenes in which the usual optimizations, such as bounding volumes, help little.

use glam::DVec3;
use pinhole_core::{Camera, Pixel, Sphere};

use super::random::Random;
use super::scenes::{COVERAGE, Listed, Setting, camera, centers_ahead, scale_for, spheres_at};

/// Returns all scenes of this module, and two scenes with other image sizes.
pub(crate) fn all() -> Vec<Listed> {
    let hard = |name, make: fn() -> Setting| Listed::new(name, "adversarial", make);
    vec![
        hard("overdraw-1e3", || spheres_at(1000, COVERAGE, 10.0)),
        hard("overdraw-1e5", || spheres_at(100_000, COVERAGE, 10.0)),
        hard("overdraw-1e6", || spheres_at(1_000_000, COVERAGE, 10.0)),
        hard("behind-one", behind_one),
        hard("sub-pixel", sub_pixel),
        hard("six-decades", six_decades),
        hard("dense-1e4", || dense(10_000)),
        hard("dense-1e5", || dense(100_000)),
        hard("dense-1e6", || dense(1_000_000)),
        hard("clustered-1e3", || clustered(1000)),
        hard("clustered-1e5", || clustered(100_000)),
        hard("in-cloud-1e3", || in_cloud(1000)),
        hard("in-cloud", || in_cloud(100_000)),
        hard("in-sphere", in_sphere),
        hard("one-pixel", one_pixel),
        hard("planet", planet),
        hard("eye-plane", eye_plane),
        hard("one-column", || spheres_at(10_000, COVERAGE, 1.0).with_image(1, 16_384)),
        hard("one-row", || spheres_at(10_000, COVERAGE, 1.0).with_image(16_384, 1)),
        Listed::new("square-400", "sizes", square),
        Listed::new("4k-N=1000", "sizes", || {
            spheres_at(1000, COVERAGE, 1.0).with_image(3840, 2160)
        }),
    ]
}

const SPREAD: f64 = 0.6;

fn setting(spheres: Vec<Sphere>) -> Setting {
    Setting::new(spheres, camera())
}

/// 10^5 spheres, all hidden by one more, which fills the view.
fn behind_one() -> Setting {
    let mut spheres = spheres_at(100_000, COVERAGE, 1.0).scene.spheres().to_vec();
    // sin(angle) = r / |q| = 0.75: 48.6 degrees, and the view's corners are at 45.6.
    spheres.push(Sphere { center: DVec3::new(0.0, 0.0, -2.0), radius: 1.5 });
    setting(spheres)
}

/// 10^6 spheres a fifth of a pixel wide, most of which lie between the rays of the pixel centres.
fn sub_pixel() -> Setting {
    let centers = centers_ahead(1_000_000, &mut Random::new(2));
    let sphere = |center: DVec3| Sphere { center, radius: 0.1 * pixel_at(-center.z) };
    setting(centers.into_iter().map(sphere).collect())
}

/// Returns the height in world units that one pixel covers at this depth.
fn pixel_at(depth: f64) -> f64 {
    let Camera { viewport, image, .. } = camera();
    depth * viewport.height / (viewport.distance * f64::from(image.height()))
}

/// 10^5 spheres whose radii are spread over six orders of magnitude, evenly on a logarithmic scale;
/// together they cover 60 % of the pixels.
fn six_decades() -> Setting {
    let mut random = Random::new(3);
    let centers = centers_ahead(100_000, &mut random);
    let radii: Vec<f64> = centers.iter().map(|_| 10f64.powf(random.within(-6.0, 0.0))).collect();
    let scale = scale_for(COVERAGE, &centers, &|index| radii[index]);
    let sphere = |(center, radius): (DVec3, f64)| Sphere { center, radius: scale * radius };
    setting(centers.into_iter().zip(radii).map(sphere).collect())
}

/// Spheres in the middle of the view, where they hide each other; 60 % of the pixels are covered.
fn dense(count: usize) -> Setting {
    let centers = centers_ahead(count, &mut Random::new(8)).into_iter();
    alike(centers.map(|center| center * DVec3::new(0.5, 0.5, 1.0)).collect())
}

/// Spheres in thirty clusters, each denser towards its middle; 60 % of the pixels are covered.
fn clustered(count: usize) -> Setting {
    let mut random = Random::new(9);
    let middles = centers_ahead(30, &mut random);
    let mut offset = || (0..4).map(|_| random.within(-SPREAD, SPREAD)).sum::<f64>();
    let near = |k: usize| middles[k % 30] + DVec3::new(offset(), offset(), offset());
    alike((0..count).map(near).collect())
}

/// Spheres on all sides of the eye; 60 % of the pixels are covered.
fn in_cloud(count: usize) -> Setting {
    let mut random = Random::new(4);
    let mut coordinate = || random.within(-8.0, 8.0);
    alike((0..count).map(|_| DVec3::new(coordinate(), coordinate(), coordinate())).collect())
}

/// Returns spheres of equal radius, chosen so that they cover 60 % of the pixels.
fn alike(centers: Vec<DVec3>) -> Setting {
    let radius = scale_for(COVERAGE, &centers, &|_| 1.0);
    setting(centers.into_iter().map(|center| Sphere { center, radius }).collect())
}

/// 10^4 spheres, and one that contains them and the eye.
fn in_sphere() -> Setting {
    let mut spheres = vec![Sphere { center: DVec3::new(0.0, 0.0, -3.0), radius: 40.0 }];
    spheres.extend(spheres_at(10_000, COVERAGE, 1.0).scene.spheres());
    setting(spheres)
}

/// 10^5 spheres of about a pixel's size, all of which are hit by the ray of the same pixel.
fn one_pixel() -> Setting {
    let resolved = setting(Vec::new()).camera(0);
    let direction = resolved.ray_of_pixel(Pixel { row: 611, column: 877 }).direction;
    let mut random = Random::new(5);
    let sphere = |_| {
        let depth = random.within(4.0, 12.0);
        let pixel = pixel_at(depth);
        let off = DVec3::new(random.within(-0.3, 0.3), random.within(-0.3, 0.3), 0.0);
        let center = resolved.eye() + depth * direction + pixel * off;
        Sphere { center, radius: random.within(0.6, 1.2) * pixel }
    };
    setting((0..100_000).map(sphere).collect())
}

/// A planet under the eye, and 10^4 pebbles on it.
fn planet() -> Setting {
    const RADIUS: f64 = 6.4e6;
    const EYE: f64 = 1.7;
    let mut random = Random::new(6);
    let mut spheres = vec![Sphere { center: DVec3::new(0.0, -RADIUS - EYE, 0.0), radius: RADIUS }];
    spheres.extend((0..10_000).map(|_| {
        let (x, z) = (random.within(-30.0, 30.0), random.within(-60.0, -2.0));
        let y = -EYE - (x * x + z * z) / (2.0 * RADIUS);
        Sphere { center: DVec3::new(x, y, z), radius: random.within(0.01, 0.2) }
    }));
    setting(spheres)
}

/// A thousand spheres to the sides of the eye, each of which crosses the plane through the eye and
/// reaches into the view.
fn eye_plane() -> Setting {
    let mut random = Random::new(7);
    let sphere = |_| {
        let (sin, cos) = random.within(0.0, std::f64::consts::TAU).sin_cos();
        let away = random.within(2.0, 40.0);
        let radius = away * random.within(0.7, 0.99);
        let z = radius * random.within(-0.5, 0.1);
        Sphere { center: DVec3::new(away * cos, away * sin, z), radius }
    };
    setting((0..1000).map(sphere).collect())
}

/// One sphere in the lecture's 400 x 400 pixels.
fn square() -> Setting {
    let ball = Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 };
    Setting::new(vec![ball], Camera::CANONICAL)
}
