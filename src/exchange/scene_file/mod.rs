//! Scene files: TOML, read with the position of every error, and saved without losing comments.
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
//! [observer]                        # of the world view; optional
//! target = [0.0, 0.0, -3.0]         # looked at
//! azimuth = 40.0                    # degrees, from +z towards +x
//! elevation = 20.0                  # degrees above the target
//! distance = 12.0                   # from the target
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
//! Every table except `camera` may be omitted, and so may each field of `viewport` and `image`; the
//! defaults are those of the canonical camera. A top-level `spheres = "file.csv"`, with a path relative
//! to the scene file, adds [many spheres](crate::csv::spheres). Unknown fields are errors.
//!
//! Without `[observer]`, the world view is fitted to the scene. Only the command *Keep this view in the
//! scene* adds or changes this table: looking around changes no file.
//!
//! The comment lines at the beginning of the file are the document's note, a text for the viewer about
//! the scene.
//!
//! A camera without a valid basis (eye = at, up parallel to view, vectors set by hand that are not
//! orthonormal) is not an error of the file. The file can be loaded, and the reason is given where the
//! basis is needed. Values that are never valid, such as a radius of 0, are errors here.

use std::path::{Path, PathBuf};

use pinhole_core::{BasisError, CameraError};

use crate::document::Document;
use crate::fields::{Section, TomlSource};
use crate::host::host;
use crate::{FileError, Location, limits};

pub(crate) use read::camera;
pub use read::{TABLES, observer, tables, toml, with_table};
pub use write::{observer_fields, to_text};

mod edit;
mod read;
mod write;

/// The version of the scene format that this program reads and writes.
pub const VERSION: i64 = 1;

/// Reads a scene file.
///
/// # Errors
/// Returns the first error in the scene file, or in the CSV file that it names.
pub fn load(path: &Path) -> Result<Document, FileError> {
    Ok(load_with_text(path)?.0)
}

/// Reads a scene file, and returns its text, too.
///
/// # Errors
/// Returns the errors of [`load`].
pub fn load_with_text(path: &Path) -> Result<(Document, String), FileError> {
    let text = String::from_utf8(limits::read(path, limits::TEXT)?).map_err(|error| {
        let location = Location::of_byte(error.as_bytes(), error.utf8_error().valid_up_to());
        FileError::at(path, location, "not UTF-8 text: a scene file is text in UTF-8")
    })?;
    Ok((parse(&text, path, path.parent().unwrap_or(Path::new("")))?, text))
}

/// Reads the text of a scene file. `path` is used in messages; the path of a CSV file is relative to
/// the folder `base`.
///
/// # Errors
/// Returns the errors of [`load`].
pub fn parse(text: &str, path: &Path, base: &Path) -> Result<Document, FileError> {
    read::document(text, path, Some(base), false)
}

/// Reads the text of unsaved changes like [`parse`], with the invalid numbers that the user may have been about
/// to correct.
///
/// # Errors
/// Returns the errors of [`load`].
pub fn parse_draft(text: &str, path: &Path, base: &Path) -> Result<Document, FileError> {
    read::document(text, path, Some(base), true)
}

/// Reads the text of a scene that must not name a CSV file.
///
/// # Errors
/// Returns the first error in the text.
pub(crate) fn parse_alone(text: &str, path: &Path) -> Result<Document, FileError> {
    let document = read::document(text, path, None, false)?;
    match &document.csv_spheres {
        Some(_) => Err(FileError::of_file(path, "names a file of spheres, which only files may")),
        None => Ok(document),
    }
}

/// The result of [`save`] or [`prepare`].
#[derive(Clone, Debug)]
pub struct Saved {
    /// The document that reading the file would give. It shares the CSV file's spheres with the
    /// original document, so that the CSV file need not be read again.
    pub document: Document,
    /// The file's text.
    pub text: String,
}

/// Writes a scene file, completely or not at all.
///
/// # Errors
/// Returns the errors of [`prepare`], or an error if the file cannot be written. An existing file is
/// then unchanged.
pub fn save(document: &Document, path: &Path, previous: Option<&str>) -> Result<Saved, FileError> {
    let saved = prepare(document, path, previous, false)?;
    host().write(path, saved.text.as_bytes())?;
    Ok(saved)
}

/// Returns the text to write for a scene file at this path, and the document that it contains.
///
/// Where values have not changed, the comments and layout of the `previous` text are kept. The path of
/// a CSV file is rewritten if necessary, so that it refers to the same file as before. A draft, of unsaved
/// changes, may contain invalid numbers.
///
/// # Errors
/// Returns an error if a value could not be read back from the text.
pub fn prepare(
    document: &Document,
    path: &Path,
    previous: Option<&str>,
    is_draft: bool,
) -> Result<Saved, FileError> {
    let mut document = document.clone();
    if let Some(csv) = &mut document.csv_spheres {
        csv.path = path_from(path.parent().unwrap_or(Path::new("")), &csv.path, &csv.file)
            .ok_or_else(|| {
                FileError::of_file(path, "cannot name the spheres' file: its path is not UTF-8")
            })?;
    }
    let text = to_text(&document, previous);
    let mut written = read::document(&text, path, None, is_draft)
        .map_err(|error| FileError::of_file(path, format!("not saved: {}", error.problem)))?;
    written.csv_spheres = document.csv_spheres;
    Ok(Saved { document: written, text })
}

/// Returns the path by which a file in `folder` refers to `file`: `written`, the path up to now, if it
/// still refers to that file, otherwise the relative path or, if there is none, the absolute path. A relative path
/// is written with slashes, so that every system can read it.
/// Returns `None` if the path is not UTF-8.
pub fn path_from(folder: &Path, written: &str, file: &Path) -> Option<String> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let file = host().resolved(file)?;
    if host().resolved(&folder.join(written)).as_ref() == Some(&file) {
        return Some(written.to_owned());
    }
    let relative = host().resolved(folder).and_then(|folder| relative_path(&folder, &file));
    match relative {
        Some(path) if cfg!(windows) => path.to_str().map(|path| path.replace('\\', "/")),
        path => path.unwrap_or(file).to_str().map(str::to_owned),
    }
}

/// Returns the relative path from a folder to a file, which are both absolute. Returns `None` if they
/// have no folder in common, for example on two different drives.
fn relative_path(folder: &Path, file: &Path) -> Option<PathBuf> {
    let shared = folder.components().zip(file.components()).take_while(|(a, b)| a == b).count();
    if shared == 0 {
        return None;
    }
    let up = folder.components().skip(shared).map(|_| std::path::Component::ParentDir);
    Some(up.chain(file.components().skip(shared)).collect())
}

/// Splits the text of a scene file into its note and the rest. The note ends before the first line that
/// is not a comment.
fn split_note(text: &str) -> (&str, &str) {
    let mut end = 0;
    for line in text.split_inclusive('\n').take_while(|line| line.starts_with('#')) {
        end += line.len();
    }
    text.split_at(end)
}

/// Returns the note in a block of comment lines: their text without `# `.
fn note_of_block(block: &str) -> String {
    let line = |line: &str| -> String {
        let line = line.strip_prefix('#').unwrap_or(line);
        line.strip_prefix(' ').unwrap_or(line).trim_end_matches('\r').to_owned()
    };
    let block = block.strip_suffix('\n').unwrap_or(block);
    block.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

/// Returns the comment block for a note, with a newline at its end. It is empty for an empty note.
///
/// ASCII control characters, which TOML does not allow in comments, are replaced by spaces.
fn note_to_block(note: &str) -> String {
    if note.is_empty() {
        return String::new();
    }
    let clean = |c: char| if c.is_ascii_control() && c != '\t' { ' ' } else { c };
    note.split('\n')
        .map(|line| {
            let line: String = line.chars().map(clean).collect();
            if line.is_empty() { "#\n".to_owned() } else { format!("# {line}\n") }
        })
        .collect()
}

/// Returns the error of a scene file's camera, with the position of the invalid field, such as
/// `room.toml:5:6: camera.at: eye and at are the same point (1, 2, 3): move one of them`.
///
/// The file is read again, because a document does not store positions. Returns `None` if the file does
/// not contain the field, because the file has changed or the value is the default.
pub fn camera_fault(path: &Path, error: &CameraError) -> Option<FileError> {
    let text = limits::read_text(path).ok()?;
    let source = TomlSource { text: &text, path, is_draft: false };
    let toml = toml(&source).ok()?;
    let field = field_at_fault(error)?;
    let (tables, key) = field.rsplit_once('.')?;
    let mut section = Section::root(&source, toml.as_table());
    for table in tables.split('.') {
        section = section.get(table)?.section().ok()?;
    }
    Some(section.get(key)?.fault(error))
}

/// Returns the name of the field that causes a camera's error, with its table, such as `camera.at`;
/// `None` if no single field does.
fn field_at_fault(error: &CameraError) -> Option<String> {
    Some(match error {
        CameraError::Basis(error) => match error {
            BasisError::NotFinite { field, .. } => format!("camera.{field}"),
            BasisError::NotUnit { vector, .. } => format!("camera.basis.{vector}"),
            BasisError::NotOrthogonal { .. } | BasisError::LeftHanded => "camera.basis".to_owned(),
            other => format!("camera.{}", other.vector()),
        },
        CameraError::Viewport(error) => format!("viewport.{}", error.field),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_ends_at_the_first_line_without_a_hash() {
        let text = "# one\n#\n#  three\n\n# not this\npinhole = 1\n";
        let (block, rest) = split_note(text);
        assert_eq!(note_of_block(block), "one\n\n three");
        assert_eq!(rest, "\n# not this\npinhole = 1\n");
        assert_eq!(split_note("\n# late\n"), ("", "\n# late\n"));
    }

    #[test]
    fn notes_survive() {
        for note in [
            "one line",
            "two\nlines",
            "an end\n",
            "\n",
            " indented",
            "#hash",
            "tab\there",
            "\u{85}",
            "\u{2028}\u{9f}",
        ] {
            assert_eq!(note_of_block(split_note(&note_to_block(note)).0), note);
        }
        assert_eq!(note_to_block(""), "");
        assert_eq!(note_to_block("a\r\nb"), "# a \n# b\n");
    }
}
