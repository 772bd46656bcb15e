//! Pictures of a pinhole camera: camera bases, view rays, ray-object intersection, and whole pictures.
//! Every decision, such as hit or miss, is exact. The crate contains nothing about windows, files,
//! command lines or teaching.
//!
//! # A picture in ten lines
//!
//! ```
//! use pinhole_core::*;
//!
//! let ball = Sphere::new([0.0, 0.0, -5.0], 1.5)?;
//! let floor = Plane::new([0.0, -1.0, 0.0], [0.0, 1.0, 0.0])?;
//! let scene = Scene::new(vec![ball], vec![floor])?;
//! let camera = Camera { image: ImageSize::new(20, 10)?, ..Camera::CANONICAL }.resolve()?;
//! let frame = trace(&scene, &camera, &Raster::full(camera.image()), Outputs::default());
//! assert_eq!(frame.at(4, 10).object, Some(0));
//! assert_eq!(frame.at(9, 0).object, Some(1));
//! assert_eq!(frame.at(0, 0).object, None);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is where
//!
//! | for | there is |
//! | --- | --- |
//! | cameras | [`Camera`], [`Orientation`] (by at, by view, or u, v, w themselves), [`Viewport`], [`ImageSize`]; [`Camera::resolve`] checks them and returns a [`ResolvedCamera`], which converts between pixels, (u, v) and rays, and [projects](ResolvedCamera::project) points; [`Intrinsics`] describe the viewport and the image as in computer vision |
//! | bases | [`Basis`], [`UpAngle`] (how well up determines the basis), [`CameraDifference`]; [`BasisError`]: the reason why a camera has no basis |
//! | rays and objects | [`Ray`], [`Sphere`], [`Plane`], their [`Roots`]; [`SphereQuadratic`] and [`PlaneTerms`] hold the intermediate numbers |
//! | scenes | [`Scene`], [`Object`], [`Root`], [`RankedRoot`]: all roots of any ray, and its first hit |
//! | pictures | [`trace`], [`trace_as`] and [`retrace`] into a [`Frame`]; [`Raster`] selects the pixels, and [`Outputs`] the values to keep |
//! | colours | [`trace_painted`] and [`retrace_painted`], [`shade`](fn@shade), [`Shade`], [`Paint`], [`Rgb`] |
//! | certainty | [`ExactRay`], [`Step`], [`Steps`]; [`Certificate`]: the step that a ray's hit needed, and its margin; [`Counts`]: the work that a frame left out |
//! | a curve to plot | [`AlongRay`]: an object's implicit function along a ray |
//! | other methods | [`methods`]: the known formulas, for comparison |
//! | interaction | [`steering`]: moving and turning a camera by drags, wheel and keys |
//! | vectors | [`DVec2`], [`DVec3`] of [glam](https://docs.rs/glam), which is re-exported as a whole |
//!
//! Runnable examples are in the crate's `examples/`: a picture in the terminal (`terminal`), and rays
//! to CSV (`rays_to_csv`).
//!
//! # Conventions
//!
//! The world is right-handed, and so is the camera's basis. The canonical camera is at the world's
//! origin with u, v, w along x, y, z, so it looks along -z.
//!
//! ```text
//!   from the right side                                  from behind the eye
//!
//!       v (up in the image)                                 v (up in the image)
//!       ^                                                   ^
//!       |                |  viewport,                       |
//!       |                |  width x height                  |
//! w <--eye---------------|-------> -w, the view            eye---> u (right in the image)
//! (backwards)            |
//!       |<-- distance -->|                                 w comes out of the page
//!
//! view ray through (u, v):   eye + t * direction,   direction = u*U + v*V - distance*W
//! ```
//!
//! Where the scalars (u, v) occur as well, the basis vectors are written as capitals: U, V, W. The image
//! fills the viewport, with rows counted from the top:
//!
//! ```text
//!             column 0   1  ... W-1
//!                  +---+---+---+---+   v =  height / 2
//!            row 0 | * |   |   |   |   * centre of pixel (0, 0):
//!                  +---+---+---+---+     u = width  * ((column + 0.5) / W - 0.5)
//!                1 |   |   |   |   |     v = height * (0.5 - (row + 0.5) / H)
//!                  +---+---o---+---+   o (u, v) = (0, 0), the viewport's centre
//!              ... |   |   |   |   |
//!                  +---+---+---+---+
//!              H-1 |   |   |   |   |
//!                  +---+---+---+---+   v = -height / 2
//!    u = -width / 2                 u = width / 2
//! ```
//!
//! - [`Basis`]: `w = -view / |view|`, `u = up x w / |up x w|`, `v = w x u`; right-handed.
//! - `uv` is a position in the viewport: two scalars `(u, v)` in world units, with `(0, 0)` at the
//!   viewport's centre. The vectors `u` and `v` are never called `uv`.
//! - A [view ray](ResolvedCamera::ray) starts at the eye and has direction `u*U + v*V - distance*W`,
//!   which is *not* normalized: the viewport is at `t = 1`. The distance along the ray,
//!   `t * |direction|`, is never called t.
//! - A [`Pixel`] is `(row, column)`, both counted from 0, with row 0 at the top.
//! - A ray's hit is its root with the smallest `t > 0`. A root at `t = 0` is not a hit; a tangent is. If
//!   objects are hit at exactly equal `t`, the one listed first counts. Objects are counted from 0:
//!   spheres, then planes.
//!
//! # The ladder
//!
//! Every decision (hit or miss, which of two objects is first, on which side of an object the eye is,
//! whether there is a basis) equals that of exact real arithmetic for the given `f64` inputs. It climbs
//! a ladder of three steps. It is first made in `f64`, as the sign of a value with an error bound. If
//! the value is within the bound, the decision is in doubt, and is made in double-double, again with a
//! bound. If the value is within that bound, too, the decision is made in exact integers of arbitrary
//! length. Each bound is derived in the code where it is computed. [`Steps`] counts how many decisions
//! each step made.
//!
//! - *Any ray*: a [`Ray`]'s origin and direction are taken as exact, to the bit: [`Scene::first_hit`].
//! - *A pixel's ray*: eye, at (or view), up, viewport and image are taken as exact, to the bit, and no
//!   intermediate result is rounded, neither the basis nor (u, v) nor the direction:
//!   [`ResolvedCamera::exact_ray`] and [`Scene::first_hit_of`] for one pixel, [`trace`] for all pixels.
//!
//! `t` is the exact value, rounded to the nearest `f64` (in frames of `f32`, within an ulp of `f32`),
//! and a normal is within 3e-16 rad of the exact one. NaN, infinities, zero directions and radii that
//! are not positive are rejected with typed errors by [`Ray::check`], [`Scene::new`] and
//! [`Camera::resolve`].
//!
//! # With plain coordinates
//!
//! Each function below answers one question about plain coordinates. Rays and objects can be made from
//! any type that converts into a [`DVec3`]: `[f64; 3]`, `(f64, f64, f64)`; bases and cameras take only
//! [`DVec3`], so use `.into()`. To use `f32`, convert each number by `f64::from`, or a vector by glam's
//! `as_dvec3`, without loss.
//!
//! ```
//! use pinhole_core::*;
//!
//! // One object: a sphere, and a plane by any point and normal.
//! let ray = Ray::new([0.0, 0.0, 0.0], [0.0, 0.0, -1.0])?;
//! let ball = Sphere::new([0.0, 0.0, -5.0], 1.0)?;
//! let wall = Plane::new([0.0, 0.0, -6.0], [0.0, 0.0, 1.0])?;
//! assert_eq!(ball.roots(&ray), Roots::Two(4.0, 6.0));
//! assert_eq!(wall.roots(&ray), Roots::One(6.0));
//!
//! // The first of several: t, point, normal, and which one.
//! let scene = Scene::new(vec![ball], vec![wall])?;
//! let hit = scene.first_hit(&ray).unwrap();
//! assert_eq!((hit.object, hit.t, hit.normal), (0, 4.0, DVec3::Z));
//! let mut steps = Steps::default();
//! scene.first_hit_counting(&ExactRay::from_ray(&ray)?, &mut steps);
//! assert_eq!(steps.beyond_f64(), 0);
//!
//! // A basis. Errors give the reason: here eye and at would be the same point.
//! let (eye, at, up) = ([20.0, 4.0, 10.0], [-1.0, 0.0, -5.0], [0.0, 1.0, 0.0]);
//! let basis = Basis::from_eye_at_up(eye.into(), at.into(), up.into())?;
//! assert!((basis.u.x - 5.0 / 74.0_f64.sqrt()).abs() < 1e-15);
//! assert!(Basis::from_eye_at_up(eye.into(), eye.into(), up.into()).is_err());
//!
//! // A camera's pixel, from eye, at, up, viewport and image.
//! let camera = Camera {
//!     eye: [0.0, 0.0, 0.0].into(),
//!     orientation: Orientation::At { at: [0.0, 0.0, -1.0].into(), up: up.into() },
//!     viewport: Viewport { width: 1.0, height: 1.0, distance: 1.0 },
//!     image: ImageSize::new(5, 5)?,
//! };
//! let resolved = camera.resolve()?;
//! let pixel = Pixel { row: 2, column: 2 };
//! assert_eq!(resolved.ray_of_pixel(pixel), ray);
//! assert_eq!(scene.first_hit_of(&resolved.exact_ray(pixel)), Some(hit));
//! let through_uv = resolved.exact_ray_at(DVec2::new(0.2, -0.1))?;
//! assert_eq!(scene.first_hit_of(&through_uv).map(|hit| hit.t), Some(6.0));
//!
//! // A whole frame: t and object of every pixel, row by row.
//! let raster = Raster::full(resolved.image());
//! let frame = trace_as::<f32>(&scene, &resolved, &raster, Outputs::default());
//! assert_eq!((frame.t[12], frame.object[12]), (4.0, 0));
//!
//! // f32 values are widened, and then meant exactly.
//! let direction = [0.1_f32, 0.0, -1.0];
//! let ray = Ray::new([0.0; 3], direction.map(f64::from))?;
//! assert_ne!(scene.first_hit(&ray), scene.first_hit(&Ray::new([0.0; 3], [0.1, 0.0, -1.0])?));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # How it is built
//!
//! Each folder imports only from the folders above it in this table. The order inside `render` is given
//! in its `mod.rs`, which explains how a frame is made.
//!
//! | folder | contents |
//! | --- | --- |
//! | `exact` | numbers: error-free sums, double-double, numbers of any length, surds; a quadratic with a bound of its error |
//! | `camera` | the basis, the viewport, the image, and view rays with all their digits |
//! | `scene` | spheres and planes, which of them a ray meets and in which order (the ladder); the index over many spheres |
//! | `render` | pictures: `frame`, `outline`, `rows`, `bvh`, `polynomial`, `plan`, `row_band`, `shade` |
//! | `methods` | the known formulas, for comparison |
//! | `steering` | moving and turning the camera by drags, wheel and keys |
//!
//! A sphere is converted to pixels in these steps:
//!
//! 1. Every function that makes a picture calls `render::fill`.
//! 2. `Plan::new` calls `Classifier::classify`. `Outlines::find` finds the sphere's outline, a conic in
//!    rows and columns, with error bounds, or drops the sphere; `Span::new` computes the values that its
//!    rows share. If there are many spheres, `VisibleSpheres::new` examines boxes around nearby spheres
//!    (groups and blocks) instead.
//! 3. For each band of rows, `RowBand::draw_rows` calls `Span::draw`, which finds where each row begins
//!    and ends (`SpanRows::find`) and `t` in between (`SpanLanes::narrow` or `wide`), and keeps the
//!    nearest hits.
//! 4. `RowBand::resolve_doubt` decides the pixels in doubt, those that are too close to call.
//!    `SphereFromOrigin::meets` decides whether the pixel's ray intersects the sphere, by
//!    `Quadratic::new` in `f64` and in double-double, then by `BigRay`, which is exact. `PairOrder`
//!    decides which of two objects is first or, where it cannot, `Hit::compare`.
//! 5. `Painter::rows` converts runs of pixels that show one object to colours.

mod camera;
mod exact;
pub mod methods;
mod render;
mod scene;
pub mod steering;
mod texts;

/// Runs the README's example as a doc test.
#[cfg(doctest)]
#[doc = include_str!("README.md")]
struct Readme;

/// Exact arithmetic with which Pinhole's other crates compute the derivations that they show; not for
/// general use.
#[doc(hidden)]
pub mod arithmetic {
    pub use crate::camera::basis::{is_orthogonal, is_unit};
    pub use crate::camera::fine_basis::over_root_rounded;
    pub use crate::exact::dyadic::{
        Dyadic, Exact3, cross, dot, exact3, minus, root_of_quotient, rounded_quotient,
    };
    pub use crate::exact::scale::{length, unit};
}

pub use fearless_simd::Level;

pub use camera::basis::{Basis, BasisError, ORTHONORMAL_TOLERANCE, UpAngle};
pub use camera::difference::CameraDifference;
pub use camera::ray::{ExactRay, Ray, RayError};
pub use camera::resolved::{PixelOfUv, PixelRays, Projection, ResolvedCamera};
pub use camera::selection::Selection;
pub use camera::viewport::{
    ImageError, ImageSize, Intrinsics, Pixel, Viewport, ViewportError, extent_of_fov, fov_of_extent,
};
pub use camera::{Camera, CameraError, Orientation, OrientationKind};
pub use exact::double_double::DoubleDouble;
pub use exact::scale::{shortest, triple};
pub use exact::steps::{Step, Steps};
pub use glam::{self, DVec2, DVec3};
pub use render::edges::{EdgeBlend, Ellipse, edge_blends};
pub use render::frame::{Counts, Depth, Frame, FramePixel, NO_OBJECT, Outputs, Raster};
pub use render::shade::paint::{BACKGROUND, Paint, Rgb, Shade};
pub use render::shade::shade_rows::HitShader;
pub use render::shade::{lambert, nearest_t, shade, shade_at_level, shade_part};
pub use render::{
    retrace, retrace_at_level, retrace_painted, trace, trace_as, trace_at_level, trace_painted,
};
pub use scene::Scene;
pub use scene::along_ray::{AlongRay, ParabolaVertex};
pub use scene::certificate::{Certificate, Hardest, Question};
pub use scene::error::{ObjectError, SceneError};
pub use scene::object::{LineRoots, Object, RankedRoot, Root, Roots};
pub use scene::plane::{Plane, PlaneTerms};
pub use scene::sphere::{Sphere, SphereQuadratic};

#[cfg(test)]
#[path = "tests/common/levels.rs"]
mod test_levels;

#[cfg(test)]
#[path = "tests/common/seed.rs"]
mod test_seed;
