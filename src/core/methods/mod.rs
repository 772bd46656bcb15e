//! The known ways to intersect rays with spheres, side by side: named, sourced, each in `f32` and
//! `f64`. They serve comparison and teaching; pictures are made by [`Method::Ladder`] unless somebody
//! asks for another one to see what it does wrong.
//!
//! [`Formula`] has each formula with its source and where it fails; [`Method`] is the choice among
//! them and the ladder at run time. The loops over pixels and rays are compiled for each of them.
//!
//! ```
//! use pinhole_core::methods::{Method, ray_kernel};
//! use pinhole_core::*;
//!
//! // The course's floor, seen from just above: the textbook's near root loses its digits.
//! let floor = Sphere::new([0.0, -5001.0, 0.0], 5000.0)?;
//! let scene = Scene::new(vec![floor], vec![])?;
//! let ray = Ray::new([0.0; 3], [0.25, -0.25, -1.0])?;
//! let t = |name| {
//!     let mut kernel = ray_kernel(Method::from_name(name)?, &[(scene.clone(), ray)])?;
//!     kernel.intersect();
//!     kernel.hit(0).map(|hit| hit.t)
//! };
//! let (right, textbook) = (t("ladder").unwrap(), t("textbook-f32").unwrap());
//! assert!((textbook - right).abs() > 1e-5 * right);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod dispatch;
mod formulas;
mod loops;
mod method;
mod number;

pub use dispatch::{FrameKernel, MethodHit, RayKernel, Traced, frame_kernel, ray_kernel, trace_by};
pub use method::{Formula, Method, Precision};
