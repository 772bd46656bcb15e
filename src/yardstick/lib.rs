//! Bench rig: what the speed of `pinhole-core` is measured with.
//!
//! - [`scenes`]: seeded scenes of 1 to 10^7 spheres, each with a camera that moves a little every
//!   frame; [`adversarial`]: scenes that are hard to be fast in;
//! - [`textbook`] and [`bvh`]: the rivals, as a good student writes them, without tricks;
//! - [`rig`]: programs in C++, built where a compiler is: streaming stores of the same two buffers,
//!   which are the limit, and Embree;
//! - [`rounds`]: frames timed in turn, so that whatever slows the machine down slows all of them;
//!   [`machine`]: whether others used it meanwhile;
//! - [`contest`]: all of them over one scene; [`check`]: whether a frame is right, on a sample.
//!
//! Every contestant writes t as `f32` and the object as `u32` for every pixel, ray generation and
//! whatever depends on the camera included; what depends on the scene alone, such as the rival's
//! bounding volumes, is made before and not timed.
//!
//! ```
//! use std::time::Duration;
//! use pinhole_yardstick::contest::{self, Limits};
//! use pinhole_yardstick::scenes;
//!
//! let setting = scenes::spheres_at(10, 0.6, 1.0).with_image(96, 54);
//! let limits = Limits { share: Duration::from_millis(1), ..Limits::default() };
//! let outcome = contest::run(&setting, &limits, &mut []);
//! let (name, times) = outcome.rows[0];
//! assert!(name == contest::LADDER && times.min <= times.median);
//! ```

pub mod adversarial;
pub mod bvh;
pub mod check;
pub mod contest;
mod frames;
pub mod machine;
mod random;
pub mod rig;
pub mod rounds;
pub mod scenes;
pub mod textbook;

pub use frames::Buffers;
pub use scenes::Setting;
