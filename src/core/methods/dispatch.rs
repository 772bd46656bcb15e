//! The [methods](crate::methods) chosen at run time: single rays, whole pictures, and loops for a
//! caller that measures their time.
//!
//! The loops are compiled for each SIMD level and vectorized by the compiler. Products and sums are
//! fused only where a formula says so: every level gives the same bits.

use std::sync::{Arc, OnceLock};

use fearless_simd::{Level, dispatch};
use glam::DVec3;
use rayon::prelude::*;

use crate::camera::ray::ExactRay;
use crate::camera::ray::Ray;
use crate::camera::resolved::ResolvedCamera;
use crate::exact::double_double::DoubleDouble;
use crate::exact::steps::Steps;
use crate::methods::formulas::{
    ByQ, ClosestPoint, Intersect, Kahan, Lagrange, Perpendicular, Plain, Recentred, Textbook,
};
use crate::methods::loops::{FrameBy, ViewRays, first_hit};
use crate::methods::number::{Real, RoundedRay, RoundedScene};
use crate::methods::{Formula, Method, Precision};
use crate::render::frame::Depth;
use crate::render::frame::{Frame, NO_OBJECT, Outputs, Raster};
use crate::render::{retrace, trace_as};
use crate::scene::Scene;

/// The first hit of a ray, by one of the methods.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct MethodHit {
    /// The object's index in the scene.
    pub object: u32,
    /// Position on the ray, in units of the direction's length, widened to `f64`.
    pub t: f64,
    /// The outward normal as the method gives it: `(p + t d - center) / radius` for a sphere, with
    /// whatever length rounding leaves.
    pub normal: DVec3,
}

/// The first hits of a raster's pixels, row by row, from [`trace_by`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Traced {
    /// `t` of each pixel's first hit, widened to `f64`; infinite if there is none.
    pub t: Vec<f64>,
    /// Index of the object that each pixel hits first, or [`NO_OBJECT`].
    pub object: Vec<u32>,
}

/// Evaluates an expression with the type of a method chosen at run time, for which `$known` stands. The
/// ladder has its own expressions, one for each precision of `t`.
macro_rules! with_method {
    (
        $method:expr,
        ladder => $ladder:expr,
        ladder_f32 => $ladder_f32:expr,
        $known:ident => $body:expr
    ) => {
        match $method {
            Method::Ladder => $ladder,
            Method::LadderF32 => $ladder_f32,
            Method::DoubleDouble => with_type!(ByQ<DoubleDouble, Plain>, $known => $body),
            Method::Known(formula, Precision::F32) => with_formula!(formula, f32, $known => $body),
            Method::Known(formula, Precision::F64) => with_formula!(formula, f64, $known => $body),
        }
    };
}

macro_rules! with_formula {
    ($formula:expr, $real:ty, $known:ident => $body:expr) => {
        match $formula {
            Formula::Textbook => with_type!(Textbook<$real>, $known => $body),
            Formula::HalfB => with_type!(ByQ<$real, Plain>, $known => $body),
            Formula::Kahan => with_type!(ByQ<$real, Kahan>, $known => $body),
            Formula::Perpendicular => with_type!(ByQ<$real, Perpendicular>, $known => $body),
            Formula::ClosestPoint => with_type!(ClosestPoint<$real>, $known => $body),
            Formula::Recentred => with_type!(Recentred<$real>, $known => $body),
            Formula::Lagrange => with_type!(ByQ<$real, Lagrange>, $known => $body),
        }
    };
}

macro_rules! with_type {
    ($type:ty, $known:ident => $body:expr) => {{
        type $known = $type;
        $body
    }};
}

/// Returns a hit in rounded numbers, with its normal.
fn hit_of_rounded<R: Real>(
    scene: &RoundedScene<R>,
    ray: &RoundedRay<R>,
    (object, t): (u32, R),
) -> Option<MethodHit> {
    let normal = match scene.spheres.get(object as usize) {
        Some(sphere) => sphere.normal(ray, t),
        None => scene.planes.get(object as usize - scene.spheres.len())?.unit_normal(),
    };
    Some(MethodHit { object, t: t.to_f64(), normal: normal.to_f64() })
}

/// Traces the first hit of every pixel of the raster by a method, rows in parallel. Each direction
/// `u*U + v*V - distance*W` is computed in the method's own precision, from the camera's basis rounded
/// to that precision, and is intersected with every object.
pub fn trace_by(method: Method, scene: &Scene, camera: &ResolvedCamera, raster: &Raster) -> Traced {
    with_method!(
        method,
        ladder => trace_by_ladder::<f64>(scene, camera, raster),
        ladder_f32 => trace_by_ladder::<f32>(scene, camera, raster),
        M => trace_by_known::<M>(scene, camera, raster)
    )
}

fn trace_by_ladder<T: Depth>(scene: &Scene, camera: &ResolvedCamera, raster: &Raster) -> Traced {
    let frame = trace_as::<T>(scene, camera, raster, Outputs::default());
    Traced { t: frame.t.into_iter().map(T::widened).collect(), object: frame.object }
}

fn trace_by_known<M: Intersect>(scene: &Scene, camera: &ResolvedCamera, raster: &Raster) -> Traced {
    let plan = FrameBy::<M>::new(scene, camera, raster);
    let mut traced = Traced { t: vec![0.0; raster.len()], object: vec![NO_OBJECT; raster.len()] };
    let (level, width) = (Level::new(), raster.columns().len().max(1));
    let rows = traced.t.par_chunks_mut(width).zip(traced.object.par_chunks_mut(width));
    rows.enumerate().for_each_init(
        || plan.row(),
        |row, (index, (t, object))| {
            dispatch!(level, _simd => plan.trace_row(index, row));
            object.copy_from_slice(&row.object);
            for (t, found) in t.iter_mut().zip(&row.t) {
                *t = found.to_f64();
            }
        },
    );
    traced
}

/// A raster traced by one method in one thread, for a caller that measures the time. Single pixels can
/// be read for closer inspection.
///
/// The ladder is an exception: it is [`retrace`], which runs in the current thread pool.
pub trait FrameKernel: Send + Sync {
    /// Traces the whole raster again, from the scene as given to the last pixel's t and object. The
    /// kernel owns the memory of the result.
    fn trace(&mut self);

    /// Returns the first hit at the raster's `row`th row and `column`th column, the same as in the
    /// trace; `None` for a miss.
    ///
    /// # Panics
    /// Panics if the row or column is outside the raster.
    fn hit(&self, row: usize, column: usize) -> Option<MethodHit>;

    /// Returns the number of decisions that each step of the ladder made in the last trace, and of `t`
    /// that each step computed; `None` for any method but the ladder.
    fn steps(&self) -> Option<[Steps; 2]> {
        None
    }
}

/// Makes a method's [`FrameKernel`].
pub fn frame_kernel(
    method: Method,
    scene: &Arc<Scene>,
    camera: &ResolvedCamera,
    raster: &Raster,
) -> Box<dyn FrameKernel> {
    let (scene, camera, raster) = (Arc::clone(scene), *camera, raster.clone());
    with_method!(
        method,
        ladder => Box::new(LadderFrame::<f64> { scene, camera, raster, frame: OnceLock::new() }),
        ladder_f32 => Box::new(LadderFrame::<f32> { scene, camera, raster, frame: OnceLock::new() }),
        M => Box::new(KnownFrame::<M> {
            rays: ViewRays::new(&camera, &raster),
            rounded: RoundedScene::new(&scene),
            scene,
            camera,
            raster,
            t: Vec::new(),
            object: Vec::new(),
        })
    )
}

struct LadderFrame<T> {
    scene: Arc<Scene>,
    camera: ResolvedCamera,
    raster: Raster,
    frame: OnceLock<Frame<T>>,
}

impl<T: Depth> LadderFrame<T> {
    fn traced(&self) -> Frame<T> {
        trace_as(&self.scene, &self.camera, &self.raster, Outputs::default())
    }
}

impl<T: Depth + 'static> FrameKernel for LadderFrame<T> {
    fn trace(&mut self) {
        match self.frame.get_mut() {
            Some(frame) => retrace(frame, &self.scene, &self.camera),
            None => self.frame = OnceLock::from(self.traced()),
        }
    }

    fn hit(&self, row: usize, column: usize) -> Option<MethodHit> {
        let traced = self.frame.get_or_init(|| self.traced()).at(row, column);
        let object = traced.object?;
        // The frame was traced without normals, which cost more than all the rest.
        let root = self.scene.first_hit_of(&self.camera.exact_ray(traced.pixel));
        let normal = root.filter(|root| root.object == object)?.normal;
        Some(MethodHit { object, t: traced.t.widened(), normal })
    }

    fn steps(&self) -> Option<[Steps; 2]> {
        self.frame.get().map(|frame| [frame.steps, frame.steps_of_t])
    }
}

struct KnownFrame<M: Intersect> {
    rays: ViewRays<M::Real>,
    rounded: RoundedScene<M::Real>,
    scene: Arc<Scene>,
    camera: ResolvedCamera,
    raster: Raster,
    t: Vec<M::Real>,
    object: Vec<u32>,
}

impl<M: Intersect> FrameKernel for KnownFrame<M> {
    fn trace(&mut self) {
        let plan = FrameBy::<M>::new(&self.scene, &self.camera, &self.raster);
        self.t.resize(self.raster.len(), M::Real::ZERO);
        self.object.resize(self.raster.len(), NO_OBJECT);
        let width = self.raster.columns().len().max(1);
        let (level, mut row) = (Level::new(), plan.row());
        let rows = self.t.chunks_mut(width).zip(self.object.chunks_mut(width));
        for (index, (t, object)) in rows.enumerate() {
            dispatch!(level, _simd => plan.trace_row(index, &mut row));
            t.copy_from_slice(&row.t);
            object.copy_from_slice(&row.object);
        }
    }

    fn hit(&self, row: usize, column: usize) -> Option<MethodHit> {
        let ray = self.rays.ray(row, column);
        hit_of_rounded(&self.rounded, &ray, first_hit::<M>(&self.rounded, &ray)?)
    }
}

/// Rays, each with its own scene, intersected by one method in one thread, for a caller that measures
/// the time.
pub trait RayKernel: Send + Sync {
    /// Finds every ray's first hit again. The kernel owns the memory of the result.
    fn intersect(&mut self);

    /// Returns the hit that [`RayKernel::intersect`] found for a ray; `None` for a miss or before the
    /// first call.
    fn hit(&self, index: usize) -> Option<MethodHit>;

    /// Returns the number of decisions that each step of the ladder made in the last call, and of `t`
    /// that each step computed; `None` for any method but the ladder.
    fn steps(&self) -> Option<[Steps; 2]> {
        None
    }
}

/// Makes a method's [`RayKernel`]; `None` for [`Method::LadderF32`], which traces only frames. Scenes
/// and rays are rounded to the method's precision here, before anything is timed.
pub fn ray_kernel(method: Method, cases: &[(Scene, Ray)]) -> Option<Box<dyn RayKernel>> {
    let kernel: Box<dyn RayKernel> = with_method!(
        method,
        ladder => Box::new(LadderRays {
            cases: cases.to_vec(),
            hits: Vec::new(),
            steps: Steps::default(),
            steps_of_t: Steps::default(),
        }),
        ladder_f32 => return None,
        M => {
            let rounded = |(scene, ray): &(Scene, Ray)| {
                (RoundedScene::new(scene), RoundedRay::new(ray))
            };
            let cases: Vec<_> = cases.iter().map(rounded).collect();
            Box::new(KnownRays::<M> { hits: vec![None; cases.len()], cases })
        }
    );
    Some(kernel)
}

struct LadderRays {
    cases: Vec<(Scene, Ray)>,
    hits: Vec<Option<(u32, f64)>>,
    steps: Steps,
    steps_of_t: Steps,
}

impl RayKernel for LadderRays {
    fn intersect(&mut self) {
        self.hits.clear();
        let LadderRays { cases, hits, steps, steps_of_t } = self;
        (*steps, *steps_of_t) = Default::default();
        let first = |(scene, ray): &(Scene, Ray)| {
            scene.first_t_counting(&ExactRay::from_ray(ray).ok()?, steps, steps_of_t)
        };
        hits.extend(cases.iter().map(first));
    }

    fn hit(&self, index: usize) -> Option<MethodHit> {
        let (object, t) = (*self.hits.get(index)?)?;
        let (scene, ray) = self.cases.get(index)?;
        // Found without its normal, as the other methods' hits are.
        let root = scene.first_hit(ray).filter(|root| root.object == object)?;
        Some(MethodHit { object, t, normal: root.normal })
    }

    fn steps(&self) -> Option<[Steps; 2]> {
        (!self.hits.is_empty()).then_some([self.steps, self.steps_of_t])
    }
}

type RoundedCase<R> = (RoundedScene<R>, RoundedRay<R>);

struct KnownRays<M: Intersect> {
    cases: Vec<RoundedCase<M::Real>>,
    hits: Vec<Option<(u32, M::Real)>>,
}

#[inline(always)]
fn first_hits<M: Intersect>(cases: &[RoundedCase<M::Real>], hits: &mut [Option<(u32, M::Real)>]) {
    for (hit, (scene, ray)) in hits.iter_mut().zip(cases) {
        *hit = first_hit::<M>(scene, ray);
    }
}

impl<M: Intersect> RayKernel for KnownRays<M> {
    fn intersect(&mut self) {
        let KnownRays { cases, hits } = self;
        dispatch!(Level::new(), _simd => first_hits::<M>(cases, hits));
    }

    fn hit(&self, index: usize) -> Option<MethodHit> {
        let (scene, ray) = self.cases.get(index)?;
        hit_of_rounded(scene, ray, self.hits[index]?)
    }
}
