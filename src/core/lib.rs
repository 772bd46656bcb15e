//! What a pinhole camera sees, in `f64`: camera bases, view rays, ray-object
//! intersection, and whole pictures.
//!
//! # Conventions
//!
//! ```text
//!            v (up in the image)
//!            |
//!            |        viewport, `distance` in front of the eye
//!            |      +-----------+
//!          eye ---- |  (u, v)   | ----> view ray: eye + t * direction
//!          /  \     +-----------+
//!         w    u (right in the image)
//!  (backwards)
//! ```
//!
//! - [`Basis`]: `w = -view / |view|`, `u = up x w / |up x w|`, `v = w x u`; right-handed.
//! - `uv` is a scalar position `(u, v)` in the viewport, in world units, with `(0, 0)` at its centre.
//!   It never shares a name with the vectors `u` and `v`.
//! - A [view ray](PosedCamera::ray) starts at the eye and has direction
//!   `u*U + v*V - distance*W`, *not* normalized: `t = 1` is the viewport itself. The distance along
//!   the ray is `t * |direction|` and is always named apart.
//! - A [`Pixel`] is `(row, column)`, both from 0, row 0 on top.
//! - A hit is the smallest `t > 0`; `t = 0` is none, a tangent is one. Among exact ties the object
//!   that is listed first wins. Objects are counted from 0: spheres, then planes.
//!
//! # A picture in ten lines
//!
//! ```
//! use pinhole_core::*;
//!
//! let scene = Scene::new(vec![Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 }], vec![])?;
//! let camera = Camera { image: ImageSize::new(8, 8)?, ..Camera::CANONICAL }.posed()?;
//! let frame = trace(&scene, &camera, &Raster::full(camera.image()), Outputs::default());
//! assert_eq!(frame.at(4, 4).object, Some(0));
//! assert_eq!(frame.at(0, 0).object, None);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! This crate knows no window, no file and no command line.

mod band;
mod basis;
mod big_conic;
mod big_ray;
mod bounds;
mod camera;
mod conic;
mod depth;
mod double_double;
mod error_free;
mod exact;
mod exact_ray;
mod fine_basis;
mod frame;
mod frame_rays;
mod image;
mod kernel;
mod lane;
mod lanes;
mod method_kernel;
mod method_real;
mod method_sphere;
mod method_trace;
pub mod methods;
mod normals;
mod number;
mod object_kernel;
mod plan;
mod plane;
mod plane_seen;
mod posed;
mod precise;
mod ray;
mod roots;
mod scale;
mod scene;
mod seen;
mod shade;
mod sphere;
mod sphere_seen;
mod steps;
mod surd;
mod terms;
mod trace;
mod viewport;

#[cfg(test)]
#[path = "tests/unit/arithmetic.rs"]
mod arithmetic_tests;

pub use fearless_simd::Level;

pub use basis::{Basis, BasisError, BasisVector, ORTHONORMAL_TOLERANCE, UpAngle};
pub use camera::{Camera, CameraError, Orientation, OrientationKind};
pub use depth::Depth;
pub use double_double::DoubleDouble;
pub use exact_ray::ExactRay;
pub use frame::{Frame, FramePixel, NO_OBJECT, Outputs, Raster};
pub use glam::{DVec2, DVec3};
pub use image::{ImageError, ImageSize, Pixel};
pub use number::shortest;
pub use plane::{Plane, PlaneTerms};
pub use posed::{PixelOfUv, PosedCamera, Projection};
pub use ray::{Ray, RayError};
pub use roots::Roots;
pub use scene::{Object, ObjectError, Root, Scene, SceneError};
pub use shade::{BACKGROUND, Rgb, Shade, shade, shade_pixel};
pub use sphere::{Sphere, SphereQuadratic};
pub use steps::{Step, Steps};
pub use trace::{retrace, trace, trace_as, trace_at_level, trace_reporting};
pub use viewport::{Viewport, ViewportError, extent_of_fov, fov_of_extent};
