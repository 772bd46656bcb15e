//! The [methods](crate::methods) chosen at run time: single rays, whole pictures, and loops for a
//! caller that measures their time.
//!
//! The loops are compiled for each SIMD level and vectorized by the compiler. No product is fused with
//! a sum but where a formula says so: every level gives the same bits.

use std::sync::{Arc, OnceLock};

use fearless_simd::{Level, dispatch};
use glam::DVec3;
use rayon::prelude::*;

use crate::camera::exact_ray::ExactRay;
use crate::camera::ray::Ray;
use crate::camera::resolved::ResolvedCamera;
use crate::exact::double_double::DoubleDouble;
use crate::exact::steps::Steps;
use crate::methods::formulas::{
    ByQ, ClosestPoint, Intersect, Kahan, Lagrange, Perpendicular, Plain, Recentred, Textbook,
};
use crate::methods::loops::{FrameBy, ViewRays, first_hit, first_hit_rounded};
use crate::methods::method::{Formula, Method, Precision};
use crate::methods::number::{Fused, Real, RoundedPlane, RoundedRay, RoundedScene, RoundedSphere};
use crate::render::frame::{Frame, NO_OBJECT, Outputs, Raster};
use crate::render::trace;
use crate::scene::Scene;
use crate::scene::object::{Object, Root};

/// The first hit of a ray, by some method.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct MethodHit {
    /// The object's index in the scene.
    pub object: u32,
    /// Place on the ray, in units of the direction's length, widened to `f64`.
    pub t: f64,
    /// The outward normal as the method gives it, `(p + t d - center) / radius` of a sphere, and of
    /// the length that rounding leaves it.
    pub normal: DVec3,
}

/// The first hits of a raster's pixels, row by row, see [`trace_by`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Traced {
    /// `t` of the first hit, widened to `f64`; infinite where there is none.
    pub t: Vec<f64>,
    /// Index of the object hit, or [`NO_OBJECT`].
    pub object: Vec<u32>,
}

/// Something done with a method at compile time, chosen at run time.
trait Visitor {
    type Out;
    fn ladder(self) -> Self::Out;
    fn known<M: Intersect>(self) -> Self::Out;
}

impl Method {
    fn accept<V: Visitor>(self, visitor: V) -> V::Out {
        use Precision::{F32, F64};
        match self {
            Method::Ladder => visitor.ladder(),
            Method::DoubleDouble => visitor.known::<ByQ<DoubleDouble, Plain>>(),
            Method::Known(formula, F32) => formula.accept::<f32, V>(visitor),
            Method::Known(formula, F64) => formula.accept::<f64, V>(visitor),
        }
    }
}

impl Formula {
    fn accept<R: Fused, V: Visitor>(self, visitor: V) -> V::Out {
        match self {
            Formula::Textbook => visitor.known::<Textbook<R>>(),
            Formula::HalfB => visitor.known::<ByQ<R, Plain>>(),
            Formula::Kahan => visitor.known::<ByQ<R, Kahan>>(),
            Formula::Perpendicular => visitor.known::<ByQ<R, Perpendicular>>(),
            Formula::ClosestPoint => visitor.known::<ClosestPoint<R>>(),
            Formula::Recentred => visitor.known::<Recentred<R>>(),
            Formula::Lagrange => visitor.known::<ByQ<R, Lagrange>>(),
        }
    }
}

/// The first hit of any ray. A ray that fails [`Ray::check`] hits nothing by the ladder, and whatever
/// rounding says by the others; what they make NaN or infinite is no hit.
pub fn first_hit_by(method: Method, scene: &Scene, ray: &Ray) -> Option<MethodHit> {
    struct FirstHit<'a>(&'a Scene, &'a Ray);
    impl Visitor for FirstHit<'_> {
        type Out = Option<MethodHit>;

        fn ladder(self) -> Self::Out {
            hit_of_root(self.0.first_hit(self.1))
        }

        fn known<M: Intersect>(self) -> Self::Out {
            let FirstHit(scene, ray) = self;
            hit_of_ray::<M>(scene, &RoundedRay::new(ray))
        }
    }
    method.accept(FirstHit(scene, ray))
}

fn hit_of_root(root: Option<Root>) -> Option<MethodHit> {
    root.map(|Root { object, t, normal, .. }| MethodHit { object, t, normal })
}

fn hit_of_ray<M: Intersect>(scene: &Scene, ray: &RoundedRay<M::Real>) -> Option<MethodHit> {
    let (object, t) = first_hit::<M>(scene, ray)?;
    let normal = match scene.object(object)? {
        Object::Sphere(sphere) => RoundedSphere::new(&sphere).normal(ray, t),
        Object::Plane(plane) => RoundedPlane::new(&plane).unit_normal(),
    };
    Some(MethodHit { object, t: t.to_f64(), normal: normal.to_f64() })
}

/// Traces the first hit of every pixel of the raster by a method, rows in parallel: each direction
/// `u*U + v*V - distance*W` in the method's own precision, from the camera's basis rounded to it,
/// against every object.
pub fn trace_by(method: Method, scene: &Scene, camera: &ResolvedCamera, raster: &Raster) -> Traced {
    struct Trace<'a>(&'a Scene, &'a ResolvedCamera, &'a Raster);
    impl Visitor for Trace<'_> {
        type Out = Traced;

        fn ladder(self) -> Traced {
            let frame = trace(self.0, self.1, self.2, Outputs::default());
            Traced { t: frame.t, object: frame.object }
        }

        fn known<M: Intersect>(self) -> Traced {
            let Trace(scene, camera, raster) = self;
            let plan = FrameBy::<M>::new(scene, camera, raster);
            let mut traced =
                Traced { t: vec![0.0; raster.len()], object: vec![NO_OBJECT; raster.len()] };
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
    }
    method.accept(Trace(scene, camera, raster))
}

/// A raster traced by one method in one thread, for a caller that takes the time, and single pixels
/// of it looked at closely.
///
/// The ladder is the exception to the one thread: it is [`trace`], in the thread pool at hand. No other
/// crate can implement this: [`frame_kernel`] makes what there is.
pub trait FrameKernel: Send + Sync + sealed::Sealed {
    /// Traces the whole raster again, from the scene as given to the last pixel's t and object, into
    /// memory of its own.
    fn trace(&mut self);

    /// The first hit of the raster's `row`th row and `column`th column, the same as in the trace.
    ///
    /// # Panics
    /// Outside the raster.
    fn hit(&self, row: usize, column: usize) -> Option<MethodHit>;

    /// Number of decisions that each step of the ladder made in the last trace; the ladder alone
    /// has steps.
    fn steps(&self) -> Option<Steps> {
        None
    }
}

/// A method's [`FrameKernel`].
pub fn frame_kernel(
    method: Method,
    scene: &Arc<Scene>,
    camera: &ResolvedCamera,
    raster: &Raster,
) -> Box<dyn FrameKernel> {
    struct Make<'a>(&'a Arc<Scene>, &'a ResolvedCamera, &'a Raster);
    impl Visitor for Make<'_> {
        type Out = Box<dyn FrameKernel>;

        fn ladder(self) -> Self::Out {
            Box::new(LadderFrame {
                scene: Arc::clone(self.0),
                camera: *self.1,
                raster: self.2.clone(),
                frame: OnceLock::new(),
            })
        }

        fn known<M: Intersect>(self) -> Self::Out {
            let Make(scene, camera, raster) = self;
            Box::new(KnownFrame::<M> {
                rays: ViewRays::new(camera, raster),
                scene: Arc::clone(scene),
                camera: *camera,
                raster: raster.clone(),
                t: Vec::new(),
                object: Vec::new(),
            })
        }
    }
    method.accept(Make(scene, camera, raster))
}

struct LadderFrame {
    scene: Arc<Scene>,
    camera: ResolvedCamera,
    raster: Raster,
    frame: OnceLock<Frame>,
}

impl LadderFrame {
    fn traced(&self) -> Frame {
        trace(&self.scene, &self.camera, &self.raster, Outputs::default())
    }
}

impl FrameKernel for LadderFrame {
    fn trace(&mut self) {
        self.frame = OnceLock::from(self.traced());
    }

    fn hit(&self, row: usize, column: usize) -> Option<MethodHit> {
        let traced = self.frame.get_or_init(|| self.traced()).at(row, column);
        let object = traced.object?;
        // The frame was traced without normals, which cost more than all the rest.
        let root = self.scene.first_hit_of(&self.camera.exact_ray(traced.pixel));
        let normal = root.filter(|root| root.object == object)?.normal;
        Some(MethodHit { object, t: traced.t, normal })
    }

    fn steps(&self) -> Option<Steps> {
        self.frame.get().map(|frame| frame.steps)
    }
}

struct KnownFrame<M: Intersect> {
    rays: ViewRays<M::Real>,
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
        hit_of_ray::<M>(&self.scene, &self.rays.ray(row, column))
    }
}

/// Rays, each with a scene of its own, intersected by one method in one thread, for a caller that
/// takes the time.
pub trait RayKernel: Send + Sync + sealed::Sealed {
    /// Finds every ray's first hit again, into memory of its own.
    fn intersect(&mut self);

    /// Returns what [`RayKernel::intersect`] found for a ray; nothing before that.
    fn hit(&self, index: usize) -> Option<MethodHit>;

    /// Number of decisions that each step of the ladder made the last time; the ladder alone has steps.
    fn steps(&self) -> Option<Steps> {
        None
    }
}

/// A method's [`RayKernel`]. Scenes and rays are rounded to the method's precision here, before
/// anything is timed.
pub fn ray_kernel(method: Method, cases: &[(Scene, Ray)]) -> Box<dyn RayKernel> {
    struct Make<'a>(&'a [(Scene, Ray)]);
    impl Visitor for Make<'_> {
        type Out = Box<dyn RayKernel>;

        fn ladder(self) -> Self::Out {
            Box::new(LadderRays {
                cases: self.0.to_vec(),
                hits: Vec::new(),
                steps: Steps::default(),
            })
        }

        fn known<M: Intersect>(self) -> Self::Out {
            let rounded = |(scene, ray): &(Scene, Ray)| {
                (RoundedScene::<M::Real>::new(scene), RoundedRay::new(ray))
            };
            let cases: Vec<_> = self.0.iter().map(rounded).collect();
            Box::new(KnownRays::<M> { hits: vec![None; cases.len()], cases })
        }
    }
    method.accept(Make(cases))
}

struct LadderRays {
    cases: Vec<(Scene, Ray)>,
    hits: Vec<Option<MethodHit>>,
    steps: Steps,
}

impl RayKernel for LadderRays {
    fn intersect(&mut self) {
        self.hits.clear();
        self.steps = Steps::default();
        for (scene, ray) in &self.cases {
            let ray = ExactRay::from_ray(ray).ok();
            let root = ray.and_then(|ray| scene.first_hit_counting(&ray, &mut self.steps));
            self.hits.push(hit_of_root(root));
        }
    }

    fn hit(&self, index: usize) -> Option<MethodHit> {
        *self.hits.get(index)?
    }

    fn steps(&self) -> Option<Steps> {
        (!self.hits.is_empty()).then_some(self.steps)
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
        *hit = first_hit_rounded::<M>(scene, ray);
    }
}

impl<M: Intersect> RayKernel for KnownRays<M> {
    fn intersect(&mut self) {
        let KnownRays { cases, hits } = self;
        dispatch!(Level::new(), _simd => first_hits::<M>(cases, hits));
    }

    fn hit(&self, index: usize) -> Option<MethodHit> {
        let (object, t) = (*self.hits.get(index)?)?;
        let (scene, ray) = &self.cases[index];
        let normal = match scene.spheres.get(object as usize) {
            Some(sphere) => sphere.normal(ray, t),
            None => scene.planes.get(object as usize - scene.spheres.len())?.unit_normal(),
        };
        Some(MethodHit { object, t: t.to_f64(), normal: normal.to_f64() })
    }
}

/// Kernels are made by [`frame_kernel`] and [`ray_kernel`] alone: their traits may get more methods.
mod sealed {
    use super::*;

    pub trait Sealed {}

    impl Sealed for LadderFrame {}
    impl<M: Intersect> Sealed for KnownFrame<M> {}
    impl Sealed for LadderRays {}
    impl<M: Intersect> Sealed for KnownRays<M> {}
}
