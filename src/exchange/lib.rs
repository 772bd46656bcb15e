//! Reads and writes scenes on disk, in this program's format and in other programs' formats.
//!
//! - [`document`]: [`document::Document`], which is what a scene file holds: a camera, named and coloured
//!   objects, and a note.
//! - [`scene_file`]: reads and writes a document as TOML.
//! - [`scenes`]: the scenes that come with the program, and the meaning of a scene on the command
//!   line.
//! - [`csv`]: tables of spheres and of rays.
//! - [`answers`]: a student's basis, rays, hits or picture.
//! - [`images`]: PNG, GIF and OpenEXR.
//! - [`format`](mod@format): the scene to export, and the parts of every other program's format.
//! - [`programs`]: other programs' cameras and scenes, written by templates; and a camera from a glTF or from
//!   numbers.
//! - [`code`]: the current camera as a short program in six languages.
//!
//! Every problem with a file is a [`FileError`], which states the location and the rule for valid
//! values. A file is written as a whole or not at all ([`atomic`]), and read up to a maximum size
//! ([`limits`]). This crate does not depend on a window.

pub mod answers;
pub mod atomic;
pub mod code;
pub mod csv;
pub mod document;
mod error;
mod export_scene;
pub mod fields;
pub mod format;
pub mod images;
pub mod limits;
pub mod programs;
pub mod scene_file;
pub mod scenes;
mod template;

pub use document::Document;
pub use error::{FileError, Location, is_hidden, legible};
pub use format::{Conventions, ExportScene, Exported, Format};
pub use scenes::{BuiltinScene, SceneSource};

/// The README's example is run with the others.
#[cfg(doctest)]
#[doc = include_str!("README.md")]
struct ExchangeReadme;
