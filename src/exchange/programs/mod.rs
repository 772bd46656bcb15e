//! Other programs' cameras: the camera and the scene in each one's own words, and back.
//!
//! Nothing here knows a window or a disk. A format is a file or a folder, and a row of [`FORMATS`]: how
//! it is written, how it is read, how a text of it is told from others, and its
//! [`Conventions`](crate::format::Conventions), by which its axes, pixels and field of view differ from
//! those here.
//!
//! World coordinates are never turned: where another program's habit is z up or a left-handed world,
//! the camera is given so that the same coordinates make the same picture. What a format has no word
//! for is refused with a reason, or told in a note; nothing is put in its place silently.

mod blender;
mod colmap;
mod course;
mod file_text;
mod gltf;
mod literal;
mod mitsuba;
mod opencv;
mod opengl;
mod pbrt;
mod pieces;
mod povray;
mod three;
mod weekend;

pub use self::file_text::file_text;
use crate::FileError;
use crate::format::{Format, Importer, Input};

/// Every format that a camera is written in.
pub static FORMATS: [Format; 11] = [
    gltf::FORMAT,
    three::FORMAT,
    mitsuba::FORMAT,
    povray::FORMAT,
    blender::FORMAT,
    weekend::FORMAT,
    opengl::FORMAT,
    course::FORMAT,
    colmap::FORMAT,
    opencv::FORMAT,
    pbrt::FORMAT,
];

/// Every importer, in the order in which a text is held against them.
pub static IMPORTERS: [Importer; 10] = [
    gltf::IMPORTER,
    three::IMPORTER,
    mitsuba::IMPORTER,
    povray::IMPORTER,
    opengl::IMPORTER,
    course::IMPORTER,
    colmap::IMPORTER,
    opencv::IMPORTER,
    pbrt::IMPORTER,
    literal::numbers::IMPORTER,
];

impl Format {
    /// The format of this name.
    pub fn named(name: &str) -> Option<&'static Format> {
        FORMATS.iter().find(|format| format.name == name)
    }
}

impl Importer {
    /// The importer of this name.
    pub fn named(name: &str) -> Option<&'static Importer> {
        IMPORTERS.iter().find(|importer| importer.name == name)
    }
}

/// The importer of a text, by what is in it.
pub fn importer_of(text: &str) -> Option<&'static Importer> {
    IMPORTERS.iter().find(|importer| importer.detect(text))
}

/// The importer of a file: by what is in it, else by how its name ends where nothing else ends so.
///
/// # Errors
/// Returns an error, with the names of the formats, if it is none of them.
pub fn importer_of_file(text: &Input) -> Result<&'static Importer, FileError> {
    if let Some(importer) = importer_of(text.text) {
        return Ok(importer);
    }
    let ending = text.path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    // Other endings are those of a language.
    let name = match ending {
        "gltf" | "glb" => "gltf",
        "pov" => "povray",
        "pbrt" => "pbrt",
        _ => "",
    };
    Importer::named(name).ok_or_else(|| FileError::of_file(text.path, unknown_form()))
}

/// Returns the message on a text that is no camera.
pub fn unknown_form() -> String {
    let labels: Vec<&str> = IMPORTERS.iter().map(|importer| importer.label).collect();
    format!("no camera of a known form: it may be {}", labels.join(", "))
}
