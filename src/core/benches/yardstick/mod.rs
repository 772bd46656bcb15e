//! The tools with which the benchmark `speed` compares `pinhole-core` with other ray tracers.
//!
//! - [`scenes`]: seeded scenes of 1 to 10^7 spheres, each with a camera that moves a little every frame;
//!   [`adversarial`]: scenes that are hard to draw fast;
//! - [`textbook`] and [`bvh`]: the rivals, two ray tracers as a good student would write them, without
//!   tricks;
//! - [`rig`]: programs in C++, built if there is a compiler: one that only writes a frame's two buffers
//!   with streaming (non-temporal) stores, which gives a lower limit of the time, and one that uses
//!   Embree;
//! - [`rounds`]: times the contestants' frames in turn, so that anything that slows the machine down
//!   affects all of them; [`machine`]: how busy other processes kept the machine meanwhile;
//! - [`contest`]: runs all contestants on one scene; [`check`]: checks a sample of a frame's pixels.
//!
//! Every contestant writes t as `f32` and the object as `u32` for every pixel. The time includes ray
//! generation and everything else that depends on the camera. Data that depend only on the scene, such
//! as a bounding volume hierarchy, are computed beforehand, and not timed.

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
