//! Runs a [method](crate::methods) chosen at run time, to trace whole pictures or as a kernel whose time
//! a caller measures.
//!
//! The loops are compiled for each SIMD level and vectorized by the compiler. Products and sums are
//! fused only where a formula says so, so every level gives the same bits.

use std::marker::PhantomData;
use std::sync::{Arc, OnceLock};

use fearless_simd::{Level, dispatch};
use glam::DVec3;
use rayon::prelude::*;

use crate::camera::ray::{ExactRay, Ray};
use crate::camera::resolved::ResolvedCamera;
use crate::exact::double_double::DoubleDouble;
use crate::exact::steps::Steps;
use crate::methods::formulas::{
    ClosestPoint, HalfB, Intersect, Kahan, Lagrange, Perpendicular, Recentred, Textbook,
};
use crate::methods::loops::{RoundedFrame, first_hit};
use crate::methods::number::{Real, RoundedRay, RoundedScene};
use crate::methods::{Formula, Method, Precision};
use crate::render::frame::{Depth, Frame, NO_OBJECT, Outputs, Raster};
use crate::render::{retrace, trace_as};
use crate::scene::Scene;

/// The first hit of a ray, as computed by one of the methods.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct MethodHit {
    /// The object's index in the scene.
    pub object: u32,
    /// Position on the ray, in units of the direction's length, converted to `f64`.
    pub t: f64,
    /// The outward normal as computed by the method: for a sphere `(p + t d - center) / radius`, with
    /// the ray's origin p and direction d. Because of rounding, its length may differ from 1.
    pub normal: DVec3,
}

/// The first hits of a raster's pixels, row by row, as returned by [`trace_by`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Traced {
    /// `t` of each pixel's first hit, converted to `f64`; infinite if there is none.
    pub t: Vec<f64>,
    /// Index of the object that each pixel hits first, or [`NO_OBJECT`].
    pub object: Vec<u32>,
}

/// Evaluates an expression for a method chosen at run time. In the expression, `$formula` stands for the
/// formula's type and `$real` for its number type. For the ladder, separate expressions are given, one
/// for each precision of `t`.
macro_rules! with_method {
    (
        $method:expr,
        ladder => $ladder:expr,
        ladder_f32 => $ladder_f32:expr,
        $formula:ident, $real:ident => $body:expr
    ) => {
        match $method {
            Method::Ladder => $ladder,
            Method::LadderF32 => $ladder_f32,
            Method::DoubleDouble => with_types!(HalfB, DoubleDouble, $formula, $real => $body),
            Method::Known(known, Precision::F32) => with_formula!(known, f32, $formula, $real => $body),
            Method::Known(known, Precision::F64) => with_formula!(known, f64, $formula, $real => $body),
        }
    };
}

macro_rules! with_formula {
    ($known:expr, $number:ty, $formula:ident, $real:ident => $body:expr) => {
        match $known {
            Formula::Textbook => with_types!(Textbook, $number, $formula, $real => $body),
            Formula::HalfB => with_types!(HalfB, $number, $formula, $real => $body),
            Formula::Kahan => with_types!(Kahan, $number, $formula, $real => $body),
            Formula::Perpendicular => with_types!(Perpendicular, $number, $formula, $real => $body),
            Formula::ClosestPoint => with_types!(ClosestPoint, $number, $formula, $real => $body),
            Formula::Recentred => with_types!(Recentred, $number, $formula, $real => $body),
            Formula::Lagrange => with_types!(Lagrange, $number, $formula, $real => $body),
        }
    };
}

macro_rules! with_types {
    ($known:ty, $number:ty, $formula:ident, $real:ident => $body:expr) => {{
        type $formula = $known;
        type $real = $number;
        $body
    }};
}

/// Traces the first hit of every pixel of the raster by a method, with rows in parallel. Each direction
/// `u*U + v*V - distance*W` is computed in the method's own precision, from the camera's basis rounded
/// to that precision, and is intersected with every object.
pub fn trace_by(method: Method, scene: &Scene, camera: &ResolvedCamera, raster: &Raster) -> Traced {
    with_method!(
        method,
        ladder => trace_by_ladder::<f64>(scene, camera, raster),
        ladder_f32 => trace_by_ladder::<f32>(scene, camera, raster),
        M, R => trace_by_known::<M, R>(&RoundedFrame::new(scene, camera, raster), raster)
    )
}

fn trace_by_ladder<T: Depth>(scene: &Scene, camera: &ResolvedCamera, raster: &Raster) -> Traced {
    let frame = trace_as::<T>(scene, camera, raster, Outputs::default());
    Traced { t: frame.t.into_iter().map(T::widened).collect(), object: frame.object }
}

fn trace_by_known<M: Intersect<R>, R: Real>(frame: &RoundedFrame<R>, raster: &Raster) -> Traced {
    let mut traced = Traced { t: vec![0.0; raster.len()], object: vec![NO_OBJECT; raster.len()] };
    let (level, width) = (Level::new(), raster.columns().len().max(1));
    let rows = traced.t.par_chunks_mut(width).zip(traced.object.par_chunks_mut(width));
    rows.enumerate().for_each_init(
        || frame.row(),
        |row, (index, (t, object))| {
            dispatch!(level, _simd => frame.trace_row::<M>(index, row));
            object.copy_from_slice(&row.object);
            for (t, found) in t.iter_mut().zip(&row.t) {
                *t = found.to_f64();
            }
        },
    );
    traced
}

/// A method applied, in one thread, to the view rays of a raster or to a list of rays, for a caller that
/// measures the time.
///
/// The ladder for a raster is an exception: it calls [`retrace`], which runs in the current thread pool.
pub trait MethodKernel: Send + Sync {
    /// Computes every ray's first hit again, without its normal. For a raster, this includes all
    /// preparation, starting from the scene and the camera. The results are kept in the kernel's own
    /// memory.
    fn run(&mut self);

    /// Returns the first hit of the ray with this index, as found by [`MethodKernel::run`], with its
    /// normal. The pixels of a raster are counted row by row. Returns `None` for a miss; for a list of
    /// rays also if [`MethodKernel::run`] has not been called yet.
    ///
    /// # Panics
    /// Panics if a raster has no pixel of this index.
    fn hit(&self, index: usize) -> Option<MethodHit>;

    /// Returns how many decisions each step of the ladder made in the last run, and how many values of
    /// `t` each step computed. Returns `None` for any method but the ladder.
    fn steps(&self) -> Option<[Steps; 2]> {
        None
    }
}

/// Creates the kernel of a method for the view rays of a raster's pixels.
pub fn frame_kernel(
    method: Method,
    scene: &Arc<Scene>,
    camera: &ResolvedCamera,
    raster: &Raster,
) -> Box<dyn MethodKernel> {
    let (scene, camera, raster) = (Arc::clone(scene), *camera, raster.clone());
    with_method!(
        method,
        ladder => Box::new(LadderFrame::<f64> { scene, camera, raster, frame: OnceLock::new() }),
        ladder_f32 => Box::new(LadderFrame::<f32> { scene, camera, raster, frame: OnceLock::new() }),
        M, R => Box::new(KnownFrame::<M, R> {
            rounded: RoundedFrame::new(&scene, &camera, &raster),
            scene,
            camera,
            raster,
            t: Vec::new(),
            object: Vec::new(),
            formula: PhantomData,
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

impl<T: Depth + 'static> MethodKernel for LadderFrame<T> {
    fn run(&mut self) {
        match self.frame.get_mut() {
            Some(frame) => retrace(frame, &self.scene, &self.camera),
            None => self.frame = OnceLock::from(self.traced()),
        }
    }

    fn hit(&self, index: usize) -> Option<MethodHit> {
        let width = self.raster.columns().len();
        let frame = self.frame.get_or_init(|| self.traced());
        let traced = frame.at(index / width, index % width);
        let object = traced.object?;
        // The frame was traced without normals, whose computation takes longer than everything else.
        let root = self.scene.first_hit_of(&self.camera.exact_ray(traced.pixel));
        let normal = root.filter(|root| root.object == object)?.normal;
        Some(MethodHit { object, t: traced.t.widened(), normal })
    }

    fn steps(&self) -> Option<[Steps; 2]> {
        self.frame.get().map(|frame| [frame.steps, frame.steps_of_t])
    }
}

struct KnownFrame<M, R> {
    rounded: RoundedFrame<R>,
    scene: Arc<Scene>,
    camera: ResolvedCamera,
    raster: Raster,
    t: Vec<R>,
    object: Vec<u32>,
    formula: PhantomData<M>,
}

impl<M: Intersect<R>, R: Real> MethodKernel for KnownFrame<M, R> {
    fn run(&mut self) {
        self.rounded = RoundedFrame::new(&self.scene, &self.camera, &self.raster);
        self.t.resize(self.raster.len(), R::ZERO);
        self.object.resize(self.raster.len(), NO_OBJECT);
        let width = self.raster.columns().len().max(1);
        let (level, mut row) = (Level::new(), self.rounded.row());
        let rows = self.t.chunks_mut(width).zip(self.object.chunks_mut(width));
        for (index, (t, object)) in rows.enumerate() {
            dispatch!(level, _simd => self.rounded.trace_row::<M>(index, &mut row));
            t.copy_from_slice(&row.t);
            object.copy_from_slice(&row.object);
        }
    }

    fn hit(&self, index: usize) -> Option<MethodHit> {
        let (scene, ray) = (&self.rounded.scene, self.rounded.ray(index));
        hit_of_rounded(scene, &ray, first_hit::<M, R>(scene, &ray))
    }
}

/// Converts a hit in rounded numbers to a [`MethodHit`] with its normal.
fn hit_of_rounded<R: Real>(
    scene: &RoundedScene<R>,
    ray: &RoundedRay<R>,
    hit: Option<(u32, R)>,
) -> Option<MethodHit> {
    hit.map(|(object, t)| MethodHit { object, t: t.to_f64(), normal: scene.normal(object, ray, t) })
}

/// Creates the kernel of a method for a list of rays, each with its own scene. Returns `None` for
/// [`Method::LadderF32`], which traces only frames. Scenes and rays are rounded to the method's
/// precision here, so that this is not timed.
pub fn ray_kernel(method: Method, cases: &[(Scene, Ray)]) -> Option<Box<dyn MethodKernel>> {
    let kernel: Box<dyn MethodKernel> = with_method!(
        method,
        ladder => Box::new(LadderRays {
            cases: cases.to_vec(),
            hits: Vec::new(),
            steps: Default::default(),
        }),
        ladder_f32 => return None,
        M, R => {
            let rounded = |(scene, ray): &(Scene, Ray)| {
                (RoundedScene::new(scene), RoundedRay::new(ray))
            };
            let cases: Vec<_> = cases.iter().map(rounded).collect();
            let hits = vec![None; cases.len()];
            Box::new(KnownRays::<M, R> { cases, hits, formula: PhantomData })
        }
    );
    Some(kernel)
}

struct LadderRays {
    cases: Vec<(Scene, Ray)>,
    hits: Vec<Option<(u32, f64)>>,
    steps: [Steps; 2],
}

impl MethodKernel for LadderRays {
    fn run(&mut self) {
        let LadderRays { cases, hits, steps } = self;
        hits.clear();
        *steps = Default::default();
        let [decisions, of_t] = steps;
        let first = |(scene, ray): &(Scene, Ray)| {
            scene.first_t_counting(&ExactRay::from_ray(ray).ok()?, decisions, of_t)
        };
        hits.extend(cases.iter().map(first));
    }

    fn hit(&self, index: usize) -> Option<MethodHit> {
        let (object, t) = (*self.hits.get(index)?)?;
        let (scene, ray) = self.cases.get(index)?;
        let root = scene.first_hit(ray).filter(|root| root.object == object)?;
        Some(MethodHit { object, t, normal: root.normal })
    }

    fn steps(&self) -> Option<[Steps; 2]> {
        (!self.hits.is_empty()).then_some(self.steps)
    }
}

type RoundedCase<R> = (RoundedScene<R>, RoundedRay<R>);

struct KnownRays<M, R> {
    cases: Vec<RoundedCase<R>>,
    hits: Vec<Option<(u32, R)>>,
    formula: PhantomData<M>,
}

#[inline(always)]
fn first_hits<M: Intersect<R>, R: Real>(cases: &[RoundedCase<R>], hits: &mut [Option<(u32, R)>]) {
    for (hit, (scene, ray)) in hits.iter_mut().zip(cases) {
        *hit = first_hit::<M, R>(scene, ray);
    }
}

impl<M: Intersect<R>, R: Real> MethodKernel for KnownRays<M, R> {
    fn run(&mut self) {
        let KnownRays { cases, hits, .. } = self;
        dispatch!(Level::new(), _simd => first_hits::<M, R>(cases, hits));
    }

    fn hit(&self, index: usize) -> Option<MethodHit> {
        let (scene, ray) = self.cases.get(index)?;
        hit_of_rounded(scene, ray, self.hits[index])
    }
}
