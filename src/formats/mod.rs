//! Files: scenes, molecules, the spheres, rays and answers of CSV files, and how outputs reach the disk.
//!
//! Nothing here knows a window. Whatever is wrong with a file is a [`FileError`], which says where
//! and what would be right.

pub mod answers;
pub(crate) mod assets;
pub mod atomic;
pub mod builtin;
pub mod color;
pub mod csv_spheres;
mod csv_table;
mod error;
#[cfg(feature = "exr")]
pub mod exr;
pub(crate) mod fields;
pub mod molecule;
pub mod png;
pub mod rays;
pub mod scene_argument;
pub mod scene_file;
mod suggest;

pub use error::{FileError, Place};
