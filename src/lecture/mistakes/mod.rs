//! The classic mistakes: the wrong camera and picture that result from each, and the checks that find
//! it. A mistake is a change to the pipeline of a student's program, the sequence of its calculations.
//! The right pipeline is
//!
//! ```text
//! w = -view/|view|    u = up x w / |up x w|    v = w x u
//! pixel (row, column) -> (u, v) -> direction = u*U + v*V - distance*W -> roots -> hit
//! ```

mod checks;
mod pipeline;
mod table;
mod vote;
mod wrong_camera;
mod wrong_picture;

pub use checks::{Check, Checked, Value, Wanted};
pub(crate) use pipeline::{
    GivenCamera, Measure, Pipeline, PipelineCamera, Quadratic, Sign, SquareRoot, Way, WhichRoot,
};
pub use table::Mistake;
pub(crate) use vote::SplitMix64;

pub use vote::Vote;
pub use wrong_camera::WrongCamera;
pub use wrong_picture::{ComparedCamera, ComparedPicture, ComparedPixels, WrongPicture};
