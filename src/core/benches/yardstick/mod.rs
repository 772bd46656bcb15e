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

pub(crate) mod adversarial;
pub(crate) mod bvh;
pub(crate) mod check;
pub(crate) mod contest;
pub(crate) mod frames;
pub(crate) mod machine;
mod random;
pub(crate) mod rig;
pub(crate) mod rounds;
pub(crate) mod scenes;
pub(crate) mod textbook;

pub(crate) use scenes::Setting;
