//! Scene files: TOML, read with every error at its position, and saved without losing the comments.
//!
//! ```toml
//! pinhole = 1                       # format version
//!
//! [camera]                          # exactly one of: at | view | basis
//! eye = [0.0, 0.0, 0.0]
//! at = [0.0, 0.0, -1.0]
//! up = [0.0, 1.0, 0.0]              # with at and view
//! # view = [0.0, 0.0, -1.0]
//! # basis = { u = [1.0, 0.0, 0.0], v = [0.0, 1.0, 0.0], w = [0.0, 0.0, 1.0] }
//!
//! [viewport]                        # world units
//! width = 1.0
//! height = 1.0
//! distance = 1.0
//!
//! [image]                           # pixels
//! width = 400
//! height = 400
//!
//! [[sphere]]
//! name = "ball"                     # optional
//! center = [0.0, 0.0, -5.0]
//! radius = 1.0
//! color = "#e69f00"                 # optional
//!
//! [[plane]]
//! name = "back wall"
//! point = [0.0, 0.0, -6.0]
//! normal = [0.0, 0.0, 1.0]
//! ```
//!
//! Every table but `camera` may be left out; so may each field of `viewport` and `image`. What is
//! left out is the canonical camera's. A top-level `spheres = "file.csv"`, relative to the scene
//! file, adds [many spheres](crate::csv::spheres). Unknown fields are errors.
//!
//! The comment lines at the very beginning of the file, up to the first line that is none, are the
//! document's note: what to look for.
//!
//! A camera whose numbers make no basis (eye = at, up parallel to view, vectors by hand that are
//! not orthonormal) is no error of the file: it loads, and whoever needs the basis says why there
//! is none. What can be no value at all, such as a radius of 0, is an error here.

mod edit;
mod fault;
mod note;
mod read;
mod write;

use std::path::{Path, PathBuf};

use crate::document::Document;
use crate::{FileError, Location, atomic, limits};

pub use fault::camera_fault;
pub use read::{TABLES, tables, toml};
pub use write::to_text;

/// The format version that this program reads and writes.
pub const VERSION: i64 = 1;

/// Reads a scene file.
///
/// # Errors
/// Returns the first error in it, or in the CSV file that it names.
pub fn load(path: &Path) -> Result<Document, FileError> {
    let bytes = limits::read(path, limits::TEXT)?;
    let text = std::str::from_utf8(&bytes).map_err(|error| {
        let location = Location::of_byte(&bytes, error.valid_up_to());
        FileError::at(path, location, "not UTF-8 text: a scene file is text in UTF-8")
    })?;
    parse(text, path, path.parent().unwrap_or(Path::new("")))
}

/// Reads a scene file's text. `path` is for the messages; `base` is the folder that a CSV file's
/// path is relative to.
///
/// # Errors
/// Returns the errors of [`load`].
pub fn parse(text: &str, path: &Path, base: &Path) -> Result<Document, FileError> {
    read::document(text, path, Some(base))
}

/// Reads a scene file's text by itself: a CSV file is named in the document, and not read.
///
/// # Errors
/// Returns the first error in the text.
pub fn parse_alone(text: &str, path: &Path) -> Result<Document, FileError> {
    read::document(text, path, None)
}

/// A document as [`save`] writes it.
#[derive(Clone, Debug)]
pub struct Saved {
    /// The document as a reader of the file finds it. It shares the CSV file's spheres with the one
    /// that was saved: that file is named, not written, and so not read again either.
    pub document: Document,
    /// The file's text.
    pub text: String,
}

/// Writes a scene file, as a whole or not at all: [`save_over`] the file that is there.
///
/// # Errors
/// Returns the errors of [`save_over`].
pub fn save(document: &Document, path: &Path) -> Result<Saved, FileError> {
    save_over(document, path, limits::read_text(path).ok().as_deref())
}

/// Writes a scene file, as a whole or not at all.
///
/// # Errors
/// Returns the errors of [`prepare`], or an error if the file cannot be written; the old file is then as
/// it was.
pub fn save_over(
    document: &Document,
    path: &Path,
    previous: Option<&str>,
) -> Result<Saved, FileError> {
    let saved = prepare(document, path, previous)?;
    atomic::write(path, |file| std::io::Write::write_all(file, saved.text.as_bytes()))?;
    Ok(saved)
}

/// Returns what is to be written to make a scene file of this path.
///
/// The comments and layout of the `previous` text stay where the values have not changed. The
/// reference to a CSV file is kept, and written so that it means the same file from there.
///
/// # Errors
/// Returns an error if a value could not be read back.
pub fn prepare(
    document: &Document,
    path: &Path,
    previous: Option<&str>,
) -> Result<Saved, FileError> {
    let mut document = document.clone();
    if let Some(csv) = &mut document.csv_spheres {
        csv.path = path_from(path.parent().unwrap_or(Path::new("")), &csv.path, &csv.file)
            .ok_or_else(|| {
                FileError::of_file(path, "cannot name the spheres' file: its path is not UTF-8")
            })?;
    }
    let text = to_text(&document, previous);
    let mut written = read::document(&text, path, None)
        .map_err(|error| FileError::of_file(path, format!("not saved: {}", error.problem)))?;
    written.csv_spheres = document.csv_spheres;
    Ok(Saved { document: written, text })
}

/// Returns the name of `file` in a scene file in `folder`: `written` if that means the same file from there,
/// else by the relative path, else by the whole path.
fn path_from(folder: &Path, written: &str, file: &Path) -> Option<String> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let file = resolved(file)?;
    if resolved(&folder.join(written)).as_ref() == Some(&file) {
        return Some(written.to_owned());
    }
    let relative = resolved(folder).and_then(|folder| relative_path(&folder, &file));
    relative.unwrap_or(file).to_str().map(str::to_owned)
}

/// The absolute path without links, also of a file that is gone while its folder is there.
fn resolved(path: &Path) -> Option<PathBuf> {
    let in_folder = || path.parent()?.canonicalize().ok().zip(path.file_name());
    path.canonicalize()
        .ok()
        .or_else(|| in_folder().map(|(folder, name)| folder.join(name)))
        .or_else(|| std::path::absolute(path).ok())
}

/// Returns the path from one absolute path to another, by way of the folder that they share. Without one, as on two
/// drives, there is none.
fn relative_path(folder: &Path, file: &Path) -> Option<PathBuf> {
    let shared = folder.components().zip(file.components()).take_while(|(a, b)| a == b).count();
    if shared == 0 {
        return None;
    }
    let up = folder.components().skip(shared).map(|_| std::path::Component::ParentDir);
    Some(up.chain(file.components().skip(shared)).collect())
}
