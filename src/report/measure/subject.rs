//! The subject of a case: the rays that the reference and the methods trace.

use std::sync::Arc;
use std::time::Duration;

use web_time::Instant;

use pinhole_core::methods::{Method, MethodKernel, frame_kernel, ray_kernel};
use pinhole_core::{
    Basis, Camera, DVec3, Orientation, Plane, Raster, Ray, ResolvedCamera, Scene, Sphere, Viewport,
};
use pinhole_reference::{self as reference, Hit, Object, View};
use rayon::ThreadPool;

use super::condition::Problem;

/// A description of the reference.
pub(super) const REFERENCE: &str = "arbitrary precision (crate pinhole-reference, on dashu-float): \
     decisions proven by intervals of rising precision and exact algebra, t and normals to 440 bits; \
     from eye, at, up, viewport and image, or the ray, as given, nothing rounded on the way";

/// The rays of a case, numbered from 0, which are either single rays or the rays of pixels.
pub(super) enum CaseSubject {
    /// Single rays, each with its own scene.
    Rays(Vec<(Scene, Ray)>),
    /// The rays of the pixels of a picture.
    Frame(Box<MeasuredPicture>),
}

/// A scene seen by a camera.
pub(super) struct MeasuredPicture {
    pub(super) scene: Arc<Scene>,
    pub(super) camera: ResolvedCamera,
    of_reference: reference::Camera,
    objects: Vec<Object>,
    /// The camera and the objects as prepared by the reference for all rays. `None` for a scene with
    /// many objects, for which the reference gets only those objects that the pixel's ray may hit.
    view: Option<View>,
    /// The pixels that are compared with the reference.
    raster: Raster,
    /// The pixels that are traced for timing.
    timed: Raster,
}

/// A method that is prepared for a subject.
pub(super) struct Kernel {
    /// The method's loops whose hits are compared with the reference.
    pub(super) compared: Box<dyn MethodKernel>,
    /// The method's loops that are run to time it.
    pub(super) timed: Box<dyn MethodKernel>,
    /// Number of times that `timed` is run in one time measurement.
    repeats: u32,
}

/// Approximate duration of one time measurement of single rays, unless that would take more than 100
/// runs.
const MEASUREMENT: Duration = Duration::from_micros(300);

/// With this many objects or more, the reference gets, for each ray, only the objects that it may hit.
const MANY_OBJECTS: usize = 12;

impl CaseSubject {
    /// Returns the number of rays.
    pub(super) fn len(&self) -> usize {
        match self {
            CaseSubject::Rays(cases) => cases.len(),
            CaseSubject::Frame(picture) => picture.raster.len(),
        }
    }

    /// Returns the true first hit of the ray `index`, and the [`Problem`] from which its condition
    /// number is computed; `None` if the ray hits nothing.
    pub(super) fn truth(&self, index: usize) -> Option<(Hit, Problem)> {
        let (scene, ray, hit) = match self {
            CaseSubject::Rays(cases) => {
                let (scene, ray) = &cases[index];
                let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
                (scene, *ray, reference::first_hit(&objects_of(scene), origin, direction)?)
            }
            CaseSubject::Frame(picture) => {
                let ray = picture.camera.ray_of_pixel(picture.raster.pixel(index));
                (&*picture.scene, ray, picture.truth(index)?)
            }
        };
        let object = scene.object(u32::try_from(hit.object).ok()?)?;
        let problem = Problem::new(&ray, &object, &hit);
        Some((hit, problem))
    }

    /// Prepares a method to trace the rays. Returns `None` if they are single rays and the method can
    /// only trace frames.
    pub(super) fn kernel(&self, method: Method) -> Option<Kernel> {
        Some(match self {
            CaseSubject::Rays(cases) => {
                let (mut compared, timed) =
                    (ray_kernel(method, cases)?, ray_kernel(method, cases)?);
                let start = Instant::now();
                compared.run();
                let fitting = MEASUREMENT.div_duration_f64(start.elapsed()) as u32;
                let repeats = fitting.clamp(1, 100);
                Kernel { compared, timed, repeats }
            }
            CaseSubject::Frame(picture) => {
                let MeasuredPicture { scene, camera, raster, timed, .. } = &**picture;
                let [compared, timed] =
                    [raster, timed].map(|raster| frame_kernel(method, scene, camera, raster));
                Kernel { compared, timed, repeats: 1 }
            }
        })
    }

    /// Returns the number of pixels (or rays) that are traced for timing.
    pub(super) fn pixels_timed(&self) -> usize {
        match self {
            CaseSubject::Rays(cases) => cases.len(),
            CaseSubject::Frame(picture) => picture.timed.len(),
        }
    }

    /// Runs a method, and returns its time in nanoseconds per pixel (or ray).
    pub(super) fn time(&self, kernel: &mut Kernel, one_thread: Option<&ThreadPool>) -> f64 {
        let pixels = self.pixels_timed() * kernel.repeats as usize;
        let mut measure = || {
            let start = Instant::now();
            for _ in 0..kernel.repeats {
                kernel.timed.run();
            }
            start.elapsed()
        };
        let took = match one_thread {
            Some(pool) => pool.install(measure),
            None => measure(),
        };
        took.as_nanos() as f64 / pixels.max(1) as f64
    }
}

impl MeasuredPicture {
    /// Creates a scene seen by a camera, which is `camera` for the methods and `given` for the
    /// reference. The pixels of `raster` are compared with the reference, and those of `timed` are
    /// traced for timing.
    pub(super) fn new(
        scene: Arc<Scene>,
        given: &Camera,
        camera: &ResolvedCamera,
        raster: Raster,
        timed: Raster,
    ) -> MeasuredPicture {
        let (objects, of_reference, camera) =
            (objects_of(&scene), reference_camera(given), *camera);
        let has_few = objects.len() < MANY_OBJECTS;
        let view = has_few.then(|| of_reference.prepare(&objects).ok()).flatten();
        MeasuredPicture { scene, camera, of_reference, objects, view, raster, timed }
    }

    fn truth(&self, pixel: usize) -> Option<Hit> {
        let pixel = self.raster.pixel(pixel);
        if let Some(view) = &self.view {
            return view.first_hit_of_pixel(pixel.row, pixel.column);
        }
        let ray = self.camera.ray_of_pixel(pixel);
        let near: Vec<usize> = (0..self.objects.len())
            .filter(|index| !is_missed_for_sure(&self.objects[*index], &ray))
            .collect();
        let objects: Vec<Object> = near.iter().map(|index| self.objects[*index]).collect();
        let view = self.of_reference.prepare(&objects).ok()?;
        let mut hit = view.first_hit_of_pixel(pixel.row, pixel.column)?;
        hit.object = near[hit.object];
        Some(hit)
    }
}

/// Returns true if the object is a sphere that the ray's line misses by so much that rounding cannot be
/// the reason. Then the exact reference need not test it. Returns false for a plane.
///
/// The ray's direction has a relative error of about 1e-16. The margin of 1e-6 times the distance to
/// the centre plus the radius is far larger than this error and the rounding errors in this function.
/// If anything overflows or underflows, the result is false.
fn is_missed_for_sure(object: &Object, ray: &Ray) -> bool {
    let Object::Sphere { center, radius } = object else { return false };
    let to_center = DVec3::from_array(*center) - ray.origin;
    let across = to_center.cross(ray.direction).length() / ray.direction.length();
    let reach = radius + 1e-6 * (to_center.length() + radius);
    let is_plain = |x: f64| (1e-100..1e100).contains(&x);
    is_plain(ray.direction.length()) && is_plain(reach) && across > reach
}

/// Converts the scene's objects to those of the reference, spheres before planes.
fn objects_of(scene: &Scene) -> Vec<Object> {
    let sphere = |s: &Sphere| Object::Sphere { center: s.center.into(), radius: s.radius };
    let plane = |p: &Plane| Object::Plane { point: p.point.into(), normal: p.normal.into() };
    scene.spheres().iter().map(sphere).chain(scene.planes().iter().map(plane)).collect()
}

fn reference_camera(camera: &Camera) -> reference::Camera {
    let Viewport { width, height, distance } = camera.viewport;
    let orientation = match camera.orientation {
        Orientation::At { at, up } => reference::Orientation::At { at: at.into(), up: up.into() },
        Orientation::View { view, up } => {
            reference::Orientation::View { view: view.into(), up: up.into() }
        }
        Orientation::Basis(Basis { u, v, w }) => {
            reference::Orientation::Basis { u: u.into(), v: v.into(), w: w.into() }
        }
    };
    let (eye, columns, rows) = (camera.eye.into(), camera.image.width(), camera.image.height());
    reference::Camera { eye, orientation, width, height, distance, columns, rows }
}
