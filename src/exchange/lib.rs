//! Reads and writes scenes on disk, in this program's format and in other programs' formats.
//!
//! - [`document`]: [`document::Document`], the contents of a scene file: a camera, objects with names and
//!   colours, and a note.
//! - [`scene_file`]: reads and writes a document as TOML.
//! - [`scenes`]: the scenes that come with the program, and the scene that a command-line argument
//!   names.
//! - [`csv`]: tables of spheres and of rays.
//! - [`answers`]: a student's basis, rays, hits or picture.
//! - [`images`]: PNG, GIF and OpenEXR.
//! - [`format`](mod@format): the scene to export, and the properties of other programs' formats.
//! - [`page`]: the page that runs the program in a browser, with a scene or lesson in it.
//! - [`programs`]: writes cameras and scenes for other programs by templates, and reads a camera from a
//!   glTF or from literal numbers.
//! - [`link`]: a scene or a lesson's step in a URL.
//! - [`seal`]: a text's version and check, by which a link that was cut off is noticed.
//! - [`code`]: the current camera as a short program in several languages.
//! - [`windows_names`]: the names that Windows refuses, and its ways to write a path.
//! - [`host`](mod@host): the operating system or browser that keeps the files.
//!
//! Every problem with a file is a [`FileError`], which states the location and the rule for valid
//! values. A file is written completely or not at all ([`atomic`]), and is read only up to a maximum
//! size ([`limits`]). This crate does not need a window.

pub mod answers;
pub mod atomic;
pub mod code;
pub mod csv;
pub mod document;
mod error;
mod export_scene;
pub mod fields;
pub mod format;
pub mod host;
pub mod images;
pub mod limits;
pub mod link;
pub mod page;
pub mod programs;
pub mod scene_file;
pub mod scenes;
pub mod seal;
mod template;
pub mod windows_names;

pub use document::Document;
pub use error::{FileError, Location, is_hidden, legible, legible_name};
pub use format::{Conventions, ExportScene, Exported, Format};
pub use scenes::{BuiltinScene, SceneSource};

/// Runs the example of the README as a test.
#[cfg(doctest)]
#[doc = include_str!("README.md")]
struct ExchangeReadme;
