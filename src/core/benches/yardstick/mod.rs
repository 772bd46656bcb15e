//! The bench rig, which measures the speed of `pinhole-core`.
//!
//! - [`scenes`]: seeded scenes of 1 to 10^7 spheres, each with a camera that moves a little every frame;
//!   [`adversarial`]: scenes that are hard to draw fast;
//! - [`textbook`] and [`bvh`]: the rivals, as a good student would write them, without tricks;
//! - [`rig`]: programs in C++, built if there is a compiler: streaming stores of the same two buffers,
//!   which are the limit, and Embree;
//! - [`rounds`]: times frames in turn, so that anything that slows the machine down affects all
//!   contestants; [`machine`]: whether other processes used the machine meanwhile;
//! - [`contest`]: runs all contestants on one scene; [`check`]: checks a sample of a frame's pixels.
//!
//! Every contestant writes t as `f32` and the object as `u32` for every pixel. The time includes ray
//! generation and everything else that depends on the camera. Data that depend only on the scene, such
//! as a rival's bounding volumes, are made before, and not timed.

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
