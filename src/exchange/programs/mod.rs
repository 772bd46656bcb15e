//! Other programs' cameras: the camera and the scene in each one's own words, and a camera from a glTF or
//! from literal numbers.
//!
//! Nothing here knows a window or a disk. A format is a constant, and a row of [`FORMATS`]: how it is written, and
//! its [`Conventions`](crate::format::Conventions), by which its axes, pixels and field of view differ from
//! those here.
//!
//! World coordinates are never turned: where another program's habit is z up or a left-handed world,
//! the camera is given so that the same coordinates make the same picture. What a format has no word
//! for is refused with a reason, or told in a note; nothing is put in its place silently.

mod derived;
mod gltf;
mod gltf_read;
mod libraries;
mod literal;
mod renderers;
mod teaching;

use std::path::Path;

use pinhole_core::{Camera, DVec3};

pub use self::derived::MIRRORED;
use crate::code::LANGUAGES;
use crate::format::{Format, Imported, Input};
use crate::{FileError, legible};

/// Every format that a camera is written in.
pub static FORMATS: [Format; 10] = [
    gltf::FORMAT,
    libraries::THREE,
    renderers::MITSUBA,
    renderers::POVRAY,
    renderers::BLENDER,
    teaching::WEEKEND,
    libraries::OPENGL,
    teaching::COURSE,
    libraries::OPENCV,
    renderers::PBRT,
];

impl Format {
    /// All formats, then all languages.
    pub fn all() -> impl Iterator<Item = &'static Format> {
        FORMATS.iter().chain(&LANGUAGES)
    }

    /// The format or language of this name.
    pub fn named(name: &str) -> Option<&'static Format> {
        Format::all().find(|format| format.name == name)
    }
}

/// A form of text that a camera is read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Importer {
    /// glTF 2.0.
    Gltf,
    /// A look-at, a matrix, or K, R and t in numbers.
    Literal,
}

/// Message on a text that no camera is read from: what is read, and the way there from other programs.
pub const UNKNOWN: &str = "no camera that Pinhole reads: it reads glTF (.gltf, .glb), and numbers: eye, at and up, \
                           gluLookAt or glm::lookAt, a 3 × 4 or 4 × 4 matrix from camera to world, or K, R and t. \
                           Export the scene as glTF, or give its look-at alone";

impl Importer {
    /// The form of a text, by what is in it.
    pub fn of(text: &str) -> Option<Importer> {
        if gltf_read::detect(text) {
            return Some(Importer::Gltf);
        }
        literal::detect(text).then_some(Importer::Literal)
    }

    /// The form of a file: by what is in it, else by its ending.
    ///
    /// # Errors
    /// Returns an error, with the forms that there are, if it is none of them.
    pub fn of_file(text: &Input) -> Result<Importer, FileError> {
        let is_gltf =
            text.path.extension().is_some_and(|ending| ending == "gltf" || ending == "glb");
        let by_name = is_gltf.then_some(Importer::Gltf);
        let form = Importer::of(text.text).or(by_name);
        form.ok_or_else(|| FileError::of_file(text.path, UNKNOWN))
    }

    /// Its name on the screen.
    pub fn label(self) -> &'static str {
        match self {
            Importer::Gltf => "glTF 2.0",
            Importer::Literal => "literal numbers",
        }
    }

    /// Reads the text. What it leaves open, such as the image's size or the viewport's distance,
    /// is as in the camera `at_hand`.
    ///
    /// # Errors
    /// Returns the first error in the text, with its line and column.
    pub fn read(self, text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
        let mut taken = match self {
            Importer::Gltf => gltf_read::read(text, at_hand)?,
            Importer::Literal => literal::read(text, at_hand)?,
        };
        taken.notes.iter_mut().for_each(|note| *note = legible(note));
        // No negative zeros.
        taken.camera.eye += DVec3::ZERO;
        match taken.camera.resolve() {
            Ok(_) => Ok(taken),
            Err(error) => Err(FileError::of_file(text.path, format!("{}: {error}", self.label()))),
        }
    }
}

/// The text in a file's bytes: the JSON of a binary glTF, UTF-8, or else Latin-1, of which a note tells.
///
/// # Errors
/// Returns an error if a binary glTF is damaged, or the bytes are no text.
pub fn file_text(path: &Path, bytes: Vec<u8>) -> Result<(String, Option<String>), FileError> {
    if bytes.starts_with(gltf_read::MAGIC) {
        let json =
            gltf_read::json_of(&bytes).map_err(|problem| FileError::of_file(path, problem))?;
        return Ok((json.to_owned(), None));
    }
    let bytes = match String::from_utf8(bytes) {
        Ok(text) => return Ok((text, None)),
        Err(error) => error.into_bytes(),
    };
    // Latin-1 has a letter for every byte; a text has no control characters but blanks.
    if bytes.iter().any(|byte| byte.is_ascii_control() && !byte.is_ascii_whitespace()) {
        return Err(FileError::of_file(path, "not text: a camera is read from text in UTF-8"));
    }
    let note = "it is not UTF-8: read as Latin-1";
    Ok((bytes.into_iter().map(char::from).collect(), Some(note.to_owned())))
}
