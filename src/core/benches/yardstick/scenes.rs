//! Scenes for measuring speed, the same in every run, each with a camera that moves a little every
//! frame.

use glam::DVec3;
use pinhole_core::{
    Camera, ImageSize, Orientation, Raster, ResolvedCamera, Scene, Sphere, Viewport, trace_as,
};

use super::random::Random;
use super::{adversarial, check};

/// A scene and its camera.
#[derive(Clone, Debug)]
pub(crate) struct Setting {
    /// The objects.
    pub(crate) scene: Scene,
    camera: Camera,
    resolved: ResolvedCamera,
}

/// Radius of the circle on which the eye moves from frame to frame, in widths of the viewport.
const STRIDE: f64 = 1e-3;

impl Setting {
    /// Creates a setting of spheres and a camera.
    ///
    /// # Panics
    /// Panics if a sphere or the camera is invalid.
    pub(crate) fn new(spheres: Vec<Sphere>, camera: Camera) -> Setting {
        let scene = Scene::new(spheres, Vec::new()).expect("valid spheres");
        Setting { scene, camera, resolved: camera.resolve().expect("a camera that sees") }
    }

    /// The image's size.
    pub(crate) fn image(&self) -> ImageSize {
        self.camera.image
    }

    /// Number of pixels of a frame.
    pub(crate) fn pixels(&self) -> usize {
        self.camera.image.width() as usize * self.camera.image.height() as usize
    }

    /// Returns the camera of the frame with this number. Its eye is moved from the original one to a
    /// point on a small circle, a different one in every frame.
    pub(crate) fn camera(&self, frame: usize) -> ResolvedCamera {
        let basis = self.resolved.basis();
        let (sin, cos) = (0.7 * frame as f64).sin_cos();
        let stride = STRIDE * self.camera.viewport.width;
        let eye = self.camera.eye + stride * (cos * basis.u + sin * basis.v);
        Camera { eye, ..self.camera }.resolve().unwrap_or(self.resolved)
    }

    /// Returns the same scene and viewport with an image of this size in pixels.
    ///
    /// # Panics
    /// Panics if the size is not a valid [`ImageSize`].
    #[must_use]
    pub(crate) fn with_image(self, width: u32, height: u32) -> Setting {
        let camera = Camera { image: image(width, height), ..self.camera };
        let resolved = camera.resolve().expect("a camera that sees");
        Setting { camera, resolved, ..self }
    }
}

/// Returns the default camera: at the origin, looking along -z, with a vertical field of view of 53
/// degrees.
pub(crate) fn camera() -> Camera {
    Camera {
        eye: DVec3::ZERO,
        orientation: Orientation::View { view: DVec3::NEG_Z, up: DVec3::Y },
        viewport: Viewport { width: 16.0 / 9.0, height: 1.0, distance: 1.0 },
        image: image(1920, 1080),
    }
}

fn image(width: u32, height: u32) -> ImageSize {
    ImageSize::new(width, height).expect("a size of an image")
}

/// Depths of the nearest and the farthest centres.
const DEPTH: [f64; 2] = [4.0, 12.0];

/// Returns random centres of spheres, distributed uniformly over a box in front of the camera. The box
/// is as wide and high as the view is halfway between its near and far side. The first centre lies in
/// the middle of the box.
pub(crate) fn centers_ahead(count: usize, random: &mut Random) -> Vec<DVec3> {
    let [near, far] = DEPTH;
    let middle = 0.5 * (near + far);
    let Viewport { width, height, .. } = camera().viewport;
    let (x, y) = (0.5 * width * middle, 0.5 * height * middle);
    let mut center =
        || DVec3::new(random.within(-x, x), random.within(-y, y), -random.within(near, far));
    let mut centers: Vec<DVec3> = (0..count).map(|_| center()).collect();
    if let Some(first) = centers.first_mut() {
        *first = DVec3::new(0.0, 0.0, -middle);
    }
    centers
}

/// Returns spheres of equal radius at random places in a box in front of the camera. The radius is
/// `radius_factor` times the one with which they cover the share `coverage` of the pixels.
///
/// The radius is found by iteration, tracing one pixel in 64.
pub(crate) fn spheres_at(count: usize, coverage: f64, radius_factor: f64) -> Setting {
    let centers = centers_ahead(count, &mut Random::new(1));
    let radius = radius_factor * scale_for(coverage, &centers, &|_| 1.0);
    let spheres = centers.into_iter().map(|center| Sphere { center, radius }).collect();
    Setting::new(spheres, camera())
}

/// Maximum number of spheres whose coverage of the picture is traced. For more spheres it is
/// extrapolated, because the coverage by small spheres depends only on the sum of their areas.
const MOST_ASKED: usize = 100_000;

/// Returns the factor by which all radii must be multiplied for the spheres to cover the share
/// `coverage` of the pixels, as seen by [`camera`]. `radius_of` returns the unscaled radius of the
/// sphere with this index.
pub(crate) fn scale_for(coverage: f64, centers: &[DVec3], radius_of: &dyn Fn(usize) -> f64) -> f64 {
    let asked = &centers[..centers.len().min(MOST_ASKED)];
    let camera = camera();
    let covered = |scale: f64| {
        let sphere = |(index, center): (usize, &DVec3)| Sphere {
            center: *center,
            radius: scale * radius_of(index),
        };
        covered(&Setting::new(asked.iter().enumerate().map(sphere).collect(), camera))
    };
    // If spheres overlap at random, a share exp(-area) of the pixels stays free, and area grows with
    // scale^2.
    let (mut low, mut high) = (0.0, f64::INFINITY);
    let mut scale = (1.0 / asked.len().max(1) as f64).sqrt();
    for _ in 0..40 {
        let found = covered(scale);
        if (found - coverage).abs() < 2e-3 {
            break;
        }
        if found < coverage {
            low = scale
        } else {
            high = scale
        }
        let next = scale * ((1.0 - coverage).ln() / (1.0 - found).ln()).sqrt();
        scale = match (low < next && next < high, high.is_finite()) {
            (true, _) => next,
            (false, true) => 0.5 * (low + high),
            (false, false) => 2.0 * low,
        };
    }
    scale * (asked.len() as f64 / centers.len().max(1) as f64).sqrt()
}

/// Returns the share of pixels that hit something, computed from every eighth row and column.
pub(crate) fn covered(setting: &Setting) -> f64 {
    let image = setting.image();
    let raster = Raster::shown_on(image, image.width().div_ceil(8), image.height().div_ceil(8));
    let frame = trace_as::<f32>(&setting.scene, &setting.resolved, &raster, Default::default());
    check::coverage(&frame.object)
}

/// A scene in the list of the benchmark's scenes. It is built only when it is measured.
pub(crate) struct Listed {
    /// Its name.
    pub(crate) name: &'static str,
    /// What the scene measures: `growth` (of the time with the number of spheres), `adversarial` (a
    /// scene that is hard to draw fast), or `sizes` (of the image).
    pub(crate) group: &'static str,
    /// Makes it.
    pub(crate) make: Box<dyn Fn() -> Setting + Send + Sync>,
}

impl Listed {
    pub(crate) fn new(
        name: &'static str,
        group: &'static str,
        make: impl Fn() -> Setting + Send + Sync + 'static,
    ) -> Listed {
        Listed { name, group, make: Box::new(make) }
    }
}

/// The share of pixels that is covered in the scenes of the group `growth`.
pub(crate) const COVERAGE: f64 = 0.6;

/// Names of the scenes whose speeds are published: growing numbers of spheres, high overdraw, spheres
/// crowded in the middle of the view or in clusters, and the eye inside a cloud of spheres.
pub(crate) const STATED: [&str; 18] = [
    "N=1",
    "N=3",
    "N=10",
    "N=100",
    "N=1000",
    "N=1e4",
    "N=1e5",
    "N=1e6",
    "dense-1e4",
    "dense-1e5",
    "dense-1e6",
    "overdraw-1e3",
    "overdraw-1e5",
    "overdraw-1e6",
    "clustered-1e3",
    "clustered-1e5",
    "in-cloud-1e3",
    "in-cloud",
];

/// Returns all scenes of the benchmark: those with 1 to 10^7 spheres, the adversarial ones, and those
/// with other image sizes.
pub(crate) fn all() -> Vec<Listed> {
    let names = ["N=1", "N=3", "N=10", "N=100", "N=1000", "N=1e4", "N=1e5", "N=1e6", "N=1e7"];
    let counts = [1, 3, 10, 100, 1000, 10_000, 100_000, 1_000_000, 10_000_000];
    let growth = names
        .into_iter()
        .zip(counts)
        .map(|(name, count)| Listed::new(name, "growth", move || spheres_at(count, COVERAGE, 1.0)));
    growth.chain(adversarial::all()).collect()
}
