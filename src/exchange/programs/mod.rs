//! Writes the camera and the scene in other programs' formats, and reads a camera from a glTF file or
//! from literal numbers.
//!
//! This module works on texts in memory. A format of another program is a constant in the list
//! [`FORMATS`]. It consists of a template and of [`Conventions`](crate::format::Conventions), which
//! describe how the format's axes, pixels and field of view differ from Pinhole's.
//!
//! World coordinates are never rotated: if another program conventionally has z up or a left-handed
//! world, the camera is written so that the same coordinates give the same picture. If a format cannot
//! express something, either the export fails with a reason or a note mentions it. Nothing is replaced
//! silently.

mod derived;
mod gltf;
mod gltf_read;
mod literal;
mod writers;

use std::ffi::OsStr;
use std::path::Path;

use pinhole_core::{Camera, DVec3};

pub use self::writers::FORMATS;
use crate::code::LANGUAGES;
use crate::format::{Format, Imported, Input};
use crate::{FileError, legible, limits, scene_file};

impl Format {
    /// Returns all formats of other programs, and then all languages.
    pub fn all() -> impl Iterator<Item = &'static Format> {
        FORMATS.iter().chain(LANGUAGES)
    }

    /// Returns the format or language with this name; `None` if there is none.
    pub fn named(name: &str) -> Option<&'static Format> {
        Format::all().find(|format| format.name == name)
    }
}

pinhole_core::texts! {
    /// A kind of text from which a camera can be read.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Importer[1];
    {
        /// Returns the label of the kind.
        label,
    }
    /// glTF 2.0.
    Gltf: "glTF 2.0";
    /// A scene of Pinhole, or its table `[camera]` alone.
    Scene: "a scene of Pinhole";
    /// Literal numbers: eye, at and up, a matrix, or OpenCV's K, R and t.
    Literal: "literal numbers";
}

/// The message for a text from which no camera can be read. It lists the supported kinds, and says how
/// to export from other programs.
pub const UNKNOWN: &str = "no camera that Pinhole reads: it reads glTF (.gltf, .glb), and numbers: eye, at and up, \
                           gluLookAt or glm::lookAt, a 3 × 4 or 4 × 4 matrix from camera to world, or K, R and t. \
                           Export the scene as glTF, or give its look-at alone";

impl Importer {
    /// Returns the kind of a text, judging by its content; `None` if no camera can be read from it.
    pub fn of(text: &str) -> Option<Importer> {
        if gltf_read::detect(text) {
            return Some(Importer::Gltf);
        }
        let is_scene = |line: &str| line.starts_with("[camera]") || line.starts_with("pinhole =");
        if text.lines().any(|line| is_scene(line.trim_start())) {
            return Some(Importer::Scene);
        }
        (text.len() <= limits::PASTE && literal::detect(text)).then_some(Importer::Literal)
    }

    /// Returns the kind of a file, judging by its content or, if that does not decide it, by its
    /// extension.
    ///
    /// # Errors
    /// Returns an error that lists the supported kinds if the file is of none of them, and an error for a
    /// scene of Pinhole, which needs no import.
    pub fn of_file(text: &Input) -> Result<Importer, FileError> {
        let by_name = is_gltf(text.path).then_some(Importer::Gltf);
        let problem = match Importer::of(text.text).or(by_name) {
            Some(Importer::Scene) => "this is a scene of Pinhole: open it as it is",
            Some(importer) => return Ok(importer),
            None if text.text.trim().is_empty() => "it is empty: export the camera again",
            None if text.text.len() > limits::PASTE => {
                "no glTF, and too large for numbers: at most 128 KiB are read. Give the camera alone"
            }
            None => UNKNOWN,
        };
        Err(FileError::of_file(text.path, problem))
    }

    /// Reads the camera in the text. Values that it does not specify, such as the image's size or the
    /// viewport's distance, are those of the camera `at_hand`.
    ///
    /// # Errors
    /// Returns the first error in the text, with its line and column.
    pub fn read(self, text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
        let mut taken = match self {
            Importer::Gltf => gltf_read::read(text, at_hand)?,
            Importer::Scene => scene_file::camera(text, at_hand)?,
            Importer::Literal => literal::read(text, at_hand)?,
        };
        taken.notes.iter_mut().for_each(|note| *note = legible(note));
        // Adding 0 makes negative zeros positive.
        taken.camera.eye += DVec3::ZERO;
        match taken.camera.resolve() {
            Ok(_) => Ok(taken),
            Err(error) => Err(FileError::of_file(text.path, format!("{}: {error}", self.label()))),
        }
    }
}

/// Returns true if a file is a glTF by its name.
pub fn is_gltf(path: &Path) -> bool {
    let is = |ending: &OsStr| ["gltf", "glb"].iter().any(|own| ending.eq_ignore_ascii_case(own));
    path.extension().is_some_and(is)
}

/// Returns the text in a file's bytes: the JSON of a binary glTF, otherwise the whole file, which must
/// be UTF-8.
///
/// # Errors
/// Returns an error if a binary glTF is damaged, or if the bytes are not text.
pub fn file_text(path: &Path, bytes: Vec<u8>) -> Result<String, FileError> {
    if bytes.starts_with(gltf_read::MAGIC) {
        let json = gltf_read::json_of(&bytes);
        return json.map(str::to_owned).map_err(|problem| FileError::of_file(path, problem));
    }
    let not_text = |_| FileError::of_file(path, "not text: a camera is read from text in UTF-8");
    String::from_utf8(bytes).map_err(not_text)
}
