//! Scenes to be fast in, each with a camera that moves a little every frame. The same every time.

use std::fmt;

use glam::DVec3;
use pinhole_core::{
    Camera, CameraError, ImageSize, NO_OBJECT, Orientation, Raster, ResolvedCamera, Scene, Sphere,
    Viewport, trace_as,
};

use crate::adversarial;
use crate::random::Random;

/// A scene and who looks at it.
#[derive(Clone, Debug)]
pub struct Setting {
    /// Its name.
    pub name: String,
    /// The objects.
    pub scene: Scene,
    camera: Camera,
    resolved: ResolvedCamera,
}

/// Distance that the eye moves from frame to frame, in widths of the viewport.
const STRIDE: f64 = 1e-3;

impl Setting {
    /// A scene seen by a camera.
    ///
    /// # Errors
    /// Where the camera sees nothing.
    pub fn new(name: &str, scene: Scene, camera: Camera) -> Result<Setting, CameraError> {
        Ok(Setting { name: name.to_owned(), scene, camera, resolved: camera.resolve()? })
    }

    /// The image's size.
    pub fn image(&self) -> ImageSize {
        self.camera.image
    }

    /// Number of pixels of a frame.
    pub fn pixels(&self) -> usize {
        self.camera.image.width() as usize * self.camera.image.height() as usize
    }

    /// The camera of a frame: on a small circle around its place, at another point in every frame.
    pub fn camera(&self, frame: usize) -> ResolvedCamera {
        let basis = self.resolved.basis();
        let (sin, cos) = (0.7 * frame as f64).sin_cos();
        let stride = STRIDE * self.camera.viewport.width;
        let eye = self.camera.eye + stride * (cos * basis.u + sin * basis.v);
        Camera { eye, ..self.camera }.resolve().unwrap_or(self.resolved)
    }

    /// Returns the scene in an image of another size, through the same viewport.
    ///
    /// # Panics
    /// Where that is no [`ImageSize`].
    #[must_use]
    pub fn with_image(self, width: u32, height: u32) -> Setting {
        Setting::built_in(
            &self.name,
            self.scene,
            Camera { image: image(width, height), ..self.camera },
        )
    }

    /// Returns the setting under another name.
    #[must_use]
    pub fn named(self, name: &str) -> Setting {
        Setting { name: name.to_owned(), ..self }
    }

    /// One of our own, whose camera is sure to see.
    pub(crate) fn built_in(name: &str, scene: Scene, camera: Camera) -> Setting {
        match Setting::new(name, scene, camera) {
            Ok(setting) => setting,
            Err(error) => unreachable!("{name}: {error}"),
        }
    }
}

/// The image of all scenes that do not say otherwise.
pub const IMAGE: [u32; 2] = [1920, 1080];

/// The camera at the origin, along -z, 53 degrees from bottom to top.
pub(crate) fn camera() -> Camera {
    Camera {
        eye: DVec3::ZERO,
        orientation: Orientation::View { view: DVec3::NEG_Z, up: DVec3::Y },
        viewport: Viewport { width: 16.0 / 9.0, height: 1.0, distance: 1.0 },
        image: image(IMAGE[0], IMAGE[1]),
    }
}

fn image(width: u32, height: u32) -> ImageSize {
    match ImageSize::new(width, height) {
        Ok(image) => image,
        Err(error) => panic!("{error}"),
    }
}

pub(crate) fn scene(name: &str, spheres: Vec<Sphere>) -> Scene {
    match Scene::new(spheres, Vec::new()) {
        Ok(scene) => scene,
        Err(error) => unreachable!("{name}: {error}"),
    }
}

/// Distances of the nearest and the farthest centres.
const DEPTH: [f64; 2] = [4.0, 12.0];

/// Centres spread evenly over a box ahead, as wide and high as what is seen half way through it; the
/// first stands in its middle.
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

/// Spheres of one radius, spread evenly over a box ahead, which together cover this share of the
/// pixels; then `radius_factor` times as large.
///
/// The radius is searched for, by tracing one pixel of 64.
pub fn spheres_at(count: usize, coverage: f64, radius_factor: f64) -> Setting {
    let name = format!("N={}", Count(count));
    let centers = centers_ahead(count, &mut Random::new(1));
    let radius = radius_factor * scale_for(coverage, &centers, &|_| 1.0);
    let spheres = centers.into_iter().map(|center| Sphere { center, radius }).collect();
    Setting::built_in(&name, scene(&name, spheres), camera())
}

/// More spheres than this are not asked how much they cover: that depends on their number and radius
/// only by the sum of their areas, as long as they are small.
const MOST_ASKED: usize = 100_000;

/// Returns the factor of radii with which [`camera`] sees this share of its pixels covered.
pub(crate) fn scale_for(coverage: f64, centers: &[DVec3], radius_of: &dyn Fn(usize) -> f64) -> f64 {
    let asked = &centers[..centers.len().min(MOST_ASKED)];
    let camera = Setting::built_in("asked", Scene::default(), camera()).resolved;
    let covered = |scale: f64| {
        let sphere = |(index, center): (usize, &DVec3)| Sphere {
            center: *center,
            radius: scale * radius_of(index),
        };
        covered(&scene("asked", asked.iter().enumerate().map(sphere).collect()), &camera)
    };
    // Where spheres overlap at random, a share exp(-area) stays free, and area grows with scale^2.
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

/// The share of a camera's pixels that hit something, from every eighth row and column.
pub fn covered(scene: &Scene, camera: &ResolvedCamera) -> f64 {
    let image = camera.image();
    let raster = Raster::shown_on(image, image.width().div_ceil(8), image.height().div_ceil(8));
    let frame = trace_as::<f32>(scene, camera, &raster, Default::default());
    let hits = frame.object.iter().filter(|object| **object != NO_OBJECT).count();
    hits as f64 / frame.object.len() as f64
}

/// A number of spheres, short: `10`, `1000`, `1e4`.
#[derive(Clone, Copy, Debug)]
pub struct Count(pub usize);

impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let exponent = self.0.max(1).ilog10();
        let text = match self.0 {
            count if count >= 10_000 && count.is_multiple_of(10usize.pow(exponent)) => {
                format!("{}e{exponent}", count / 10usize.pow(exponent))
            }
            count => count.to_string(),
        };
        f.pad(&text)
    }
}

/// The reason why a scene is in the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Time against the number of spheres.
    Growth,
    /// Hard to be fast in.
    Adversarial,
    /// Other images.
    Sizes,
}

/// A scene of the list, before it is made.
pub struct Listed {
    /// Its name.
    pub name: String,
    /// The reason why it is in the list.
    pub group: Group,
    make: Box<dyn Fn() -> Setting + Send + Sync>,
}

impl Listed {
    pub(crate) fn new(
        name: &str,
        group: Group,
        make: impl Fn() -> Setting + Send + Sync + 'static,
    ) -> Listed {
        Listed { name: name.to_owned(), group, make: Box::new(make) }
    }

    /// Makes it.
    pub fn make(&self) -> Setting {
        (self.make)().named(&self.name)
    }
}

/// The share of pixels that is covered in the scenes of [`Group::Growth`].
pub const COVERAGE: f64 = 0.6;

/// 1, 3, 10, 100, ..., up to `most` spheres that cover 60 % of 1920 x 1080 pixels.
pub fn growth(most: usize) -> Vec<Listed> {
    let decades = std::iter::successors(Some(10), |count: &usize| count.checked_mul(10));
    let counts = [1, 3].into_iter().chain(decades).take_while(|count| *count <= most);
    counts
        .map(|count| {
            let name = format!("N={}", Count(count));
            Listed::new(&name, Group::Growth, move || spheres_at(count, COVERAGE, 1.0))
        })
        .collect()
}

/// All scenes: growth up to 10^7, the adversarial ones, other images.
pub fn all() -> Vec<Listed> {
    let mut all = growth(10_000_000);
    all.extend(adversarial::all());
    all
}
