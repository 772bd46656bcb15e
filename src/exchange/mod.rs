//! Other programs' cameras: the camera and the scene in each one's own words, and back.
//!
//! Nothing here knows a window or a disk. A format is a file or a folder, and a row of [`FORMATS`]: how
//! it is written, how it is read, how a text of it is told from others, and its [`Terms`], which say how
//! its axes, pixels and field of view differ from those here.
//!
//! World coordinates are never turned: where another program's habit is z up or a left-handed world,
//! the camera is given so that the same coordinates make the same picture. What a format has no word
//! for is refused with a reason, or told in a note; nothing is put in its place silently.

mod affine;
mod back;
mod blender;
mod code;
mod colmap;
mod comments;
mod course;
mod gltf;
mod json;
mod left_out;
mod matrix;
mod mitsuba;
mod names;
mod opencv;
mod opengl;
mod pbrt;
mod povray;
mod python;
mod sheet;
mod subject;
mod terms;
mod three;
mod weekend;

use std::fmt;
use std::path::Path;

use pinhole_core::{Camera, DVec3, Plane, Sphere};

use crate::document::Item;
use crate::formats::FileError;

pub(crate) use back::MIRRORED;
pub use sheet::Sheet;
pub use subject::{Subject, With};
pub(crate) use terms::FIELD_OF_VIEW;
pub use terms::{Axis, Pixels, Row, Terms, rows};

/// A program, or a habit of writing cameras, that Pinhole exchanges them with.
#[derive(Debug)]
pub struct Format {
    /// What `--to` calls it.
    pub name: &'static str,
    /// What people call it.
    pub label: &'static str,
    /// The same in a word or two.
    pub short: &'static str,
    /// How its files end, without the dot.
    pub ending: &'static str,
    /// Its conventions.
    pub terms: Terms,
    write: fn(&Subject) -> Result<Written, Unsayable>,
    read: fn(&Text, &Camera) -> Result<Taken, FileError>,
    claims: fn(&str) -> bool,
}

/// Every format, in the order in which a text is held against them.
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

/// What was written: one text, or several where the format has several files.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Written {
    /// Each file's name and text; the first one's name is only a proposal where there is but one.
    pub files: Vec<(&'static str, Sheet)>,
    /// What the format cannot say, or says in another way.
    pub notes: Vec<String>,
}

/// Why a format cannot say it: with what would have to be otherwise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsayable(pub String);

impl fmt::Display for Unsayable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Unsayable {}

/// A text of another program, and what messages call it.
#[derive(Clone, Copy, Debug)]
pub struct Text<'a> {
    /// The file as the user gave it.
    pub path: &'a Path,
    /// What is in it.
    pub text: &'a str,
}

/// What was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Taken {
    /// The camera.
    pub camera: Camera,
    /// The spheres.
    pub spheres: Vec<Item<Sphere>>,
    /// The planes.
    pub planes: Vec<Item<Plane>>,
    /// What could not be taken over, and what the text does not say.
    pub notes: Vec<String>,
}

impl Format {
    /// The format of this name.
    pub fn named(name: &str) -> Option<&'static Format> {
        FORMATS.iter().find(|format| format.name == name)
    }

    /// The camera, and what else is asked for, in the format's words.
    ///
    /// What is written is read again: where the rays that come back differ by more than a billionth,
    /// be it that the format gives a field of view near 180 degrees, a note says by how much.
    ///
    /// # Errors
    /// What the format cannot say.
    pub fn write(&self, subject: &Subject) -> Result<Written, Unsayable> {
        let mut written = (self.write)(subject)?;
        let alone = match subject.with {
            With::CameraAlone => written.clone(),
            _ => (self.write)(&subject.camera_alone())?,
        };
        written.notes.extend(back::difference(self, &alone, subject.resolve()));
        Ok(written)
    }

    /// What the text says. What it leaves open, such as the image's size or the viewport's distance,
    /// is as in the camera `at_hand`.
    ///
    /// # Errors
    /// The first thing that is wrong with the text, at its place.
    pub fn read(&self, text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
        let mut taken = (self.read)(text, at_hand)?;
        // No negative zeros.
        taken.camera.eye += DVec3::ZERO;
        match taken.camera.resolve() {
            Ok(_) => Ok(taken),
            Err(error) => Err(FileError::of_file(text.path, format!("{}: {error}", self.label))),
        }
    }

    /// Whether the text is one of this format, as far as its first words tell.
    pub fn claims(&self, text: &str) -> bool {
        (self.claims)(text)
    }
}

impl Written {
    pub(crate) fn of(name: &'static str, sheet: Sheet, notes: Vec<String>) -> Written {
        Written { files: vec![(name, sheet)], notes }
    }

    /// All files in one text.
    pub fn joined(&self) -> Sheet {
        self.files.iter().fold(Sheet::default(), |mut joined, (_, sheet)| {
            joined.append(sheet);
            joined
        })
    }
}

/// The format of a text, by what is in it.
pub fn recognised(text: &str) -> Option<&'static Format> {
    FORMATS.iter().find(|format| format.claims(text))
}

/// The format of a file: by what is in it, else by how its name ends where nothing else ends so.
///
/// # Errors
/// Where it is none of them; with their names.
pub fn recognised_file(text: &Text) -> Result<&'static Format, FileError> {
    if let Some(format) = recognised(text.text) {
        return Ok(format);
    }
    let ending = text.path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    // Other endings are those of a language, and Python's may be anything.
    let is_blender = BLENDER_SIGNS.iter().any(|sign| text.text.contains(sign));
    let name = match ending {
        "gltf" => "gltf",
        "pov" => "povray",
        "pbrt" => "pbrt",
        "py" if is_blender => "blender",
        _ => "",
    };
    Format::named(name).ok_or_else(|| FileError::of_file(text.path, unknown()))
}

/// What only Blender's cameras and objects have.
const BLENDER_SIGNS: [&str; 4] =
    ["rotation_euler", "rotation_quaternion", "sensor_width", "clip_start"];

/// What is said of a text that is no camera.
pub fn unknown() -> String {
    let label = |format: &'static Format| match format.name {
        "three" => "three.js (JSON or code)",
        _ => format.label,
    };
    let labels: Vec<&str> = FORMATS.iter().map(label).collect();
    format!("no camera of a known form: it may be {}", labels.join(", "))
}
