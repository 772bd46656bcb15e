//! The parts of every format: its conventions, its writer, and the reader of its texts.

pub(crate) mod affine;
mod conventions;
mod export_scene;
pub(crate) mod image_size;
pub(crate) mod json;
pub(crate) mod left_out;
pub(crate) mod pose;
pub(crate) mod text;
pub(crate) mod viewport;

use std::path::Path;

use pinhole_core::{Camera, DVec3, Pixel, Plane, Sphere};

use self::pose::mirrored;
use self::text::BEYOND;
use crate::document::Item;
use crate::error::one_line;
use crate::{FileError, Location, legible};

pub use conventions::{Axis, Conventions, PixelConvention};
pub(crate) use export_scene::square_note;
pub use export_scene::{ExportScene, Include, Unsupported};
pub use pose::MIRRORED;
pub use text::Text;

/// A program, or a habit of writing cameras, that Pinhole exchanges them with.
#[derive(Debug)]
pub struct Format {
    /// Name on the command line, after `--to`.
    pub name: &'static str,
    /// Name on the screen.
    pub label: &'static str,
    /// Name in a word or two.
    pub short: &'static str,
    /// Ending of its files, without the dot.
    pub ending: &'static str,
    /// Its conventions.
    pub conventions: Conventions,
    pub(crate) write: fn(&ExportScene) -> Result<Exported, Unsupported>,
    /// Reader of what is written, where there is one.
    pub(crate) importer: Option<&'static Importer>,
}

/// A reader of another program's files, or of numbers that are pasted.
#[derive(Debug)]
pub struct Importer {
    /// Name on the command line, after `--from`.
    pub name: &'static str,
    /// Name on the screen.
    pub label: &'static str,
    pub(crate) read: fn(&Input, &Camera) -> Result<Imported, FileError>,
    pub(crate) detect: fn(&str) -> bool,
}

/// An exported scene: one text, or several where the format has several files.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Exported {
    /// Each file's name and text; the first one's name is only a proposal where there is but one.
    pub files: Vec<(&'static str, Text)>,
    /// Notes on what the format cannot say, or says in another way.
    pub notes: Vec<String>,
}

/// A text of another program, and what messages call it.
#[derive(Clone, Copy, Debug)]
pub struct Input<'a> {
    /// The file as the user gave it.
    pub path: &'a Path,
    /// Its contents.
    pub text: &'a str,
}

/// An imported scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// The camera.
    pub camera: Camera,
    /// The spheres.
    pub spheres: Vec<Item<Sphere>>,
    /// The planes.
    pub planes: Vec<Item<Plane>>,
    /// Notes on what could not be taken over, and what the text does not say.
    pub notes: Vec<String>,
}

impl Format {
    /// The camera, and what else is asked for, in the format's words.
    ///
    /// The text is read again where there is an importer. A note says by how much the rays that come back
    /// differ, if by more than a billionth, as those of a field of view near 180 degrees may.
    ///
    /// # Errors
    /// Returns the first quantity that the format cannot express, as one that is not finite, or why the
    /// numbers make no camera any more when they are read again.
    pub fn write(&self, subject: &ExportScene) -> Result<Exported, Unsupported> {
        let mut written = (self.write)(subject)?;
        for (_, text) in &written.files {
            finite(&text.text)?;
        }
        let alone = match subject.include {
            Include::CameraAlone => written.clone(),
            _ => (self.write)(&subject.camera_alone())?,
        };
        written.notes.extend(difference(self, &alone, subject)?);
        written.notes.iter_mut().for_each(|note| *note = legible(note));
        Ok(written)
    }
}

impl Importer {
    /// Reads the text. What it leaves open, such as the image's size or the viewport's distance,
    /// is as in the camera `at_hand`.
    ///
    /// # Errors
    /// Returns the first error in the text, with its line and column.
    pub fn read(&self, text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
        let mut taken = (self.read)(text, at_hand)?;
        taken.notes.iter_mut().for_each(|note| *note = legible(note));
        // No negative zeros.
        taken.camera.eye += DVec3::ZERO;
        match taken.camera.resolve() {
            Ok(_) => Ok(taken),
            Err(error) => Err(FileError::of_file(text.path, format!("{}: {error}", self.label))),
        }
    }

    /// Returns true for a text of this format, as far as its words tell.
    pub fn detect(&self, text: &str) -> bool {
        (self.detect)(text)
    }
}

impl Imported {
    /// A camera without objects.
    pub(crate) fn camera(camera: Camera, notes: Vec<String>) -> Imported {
        Imported { camera, spheres: Vec::new(), planes: Vec::new(), notes }
    }

    /// The scene with its objects mirrored, where the camera's world was.
    pub(crate) fn mirrored_if(mut self, is_mirrored: bool) -> Imported {
        if is_mirrored {
            for sphere in &mut self.spheres {
                sphere.shape.center = mirrored(sphere.shape.center);
            }
            for Plane { point, normal } in self.planes.iter_mut().map(|plane| &mut plane.shape) {
                (*point, *normal) = (mirrored(*point), mirrored(*normal));
            }
        }
        self
    }
}

impl Exported {
    /// One file of a text whose parts may be marked.
    pub(crate) fn one_file(name: &'static str, text: &str, notes: Vec<String>) -> Exported {
        Exported { files: vec![(name, Text::from_marked(text))], notes }
    }

    /// All files in one text.
    pub fn joined(&self) -> Text {
        self.files.iter().fold(Text::default(), |mut joined, (_, text)| {
            joined.append(text);
            joined
        })
    }
}

impl Input<'_> {
    /// An error at a byte of the text.
    pub(crate) fn error_at(&self, at: usize, problem: impl Into<String>) -> FileError {
        FileError::at(self.path, Location::of_byte(self.text.as_bytes(), at), problem)
    }
}

/// Refuses a text with a number that is not finite, by the line that it stands in.
fn finite(text: &str) -> Result<(), Unsupported> {
    let Some(line) = text.lines().find(|line| line.contains(BEYOND)) else { return Ok(()) };
    let line = line.replace(BEYOND, "infinite");
    Err(Unsupported(format!(
        "a number would not be finite, in {}: bring the eye and the objects nearer to each other",
        one_line(&line)
    )))
}

/// Returns a note where what was written, read again, makes a camera with other rays, and by how much.
///
/// # Errors
/// Returns why it makes no camera any more.
fn difference(
    format: &Format,
    written: &Exported,
    subject: &ExportScene,
) -> Result<Option<String>, Unsupported> {
    const ENOUGH: f64 = 1e-9;
    let Some(importer) = format.importer else { return Ok(None) };
    let resolved = subject.resolve();
    let text = written.joined().text;
    let at_hand =
        Camera { viewport: *resolved.viewport(), image: resolved.image(), ..Camera::CANONICAL };
    let lost = |why: &str| {
        Unsupported(format!("{} would read no camera from its numbers: {why}", format.short))
    };
    let read = (importer.read)(&Input { path: Path::new(""), text: &text }, &at_hand);
    let back = read.map_err(|error| lost(&error.problem))?.camera.resolve();
    let back = back.map_err(|error| lost(&error.to_string()))?;
    let [height, width] = [resolved.image().height(), resolved.image().width()].map(|n| n - 1);
    let corners = [(0, 0), (0, width), (height, 0), (height, width)];
    let off = corners.map(|(row, column)| {
        let [a, b] = [resolved, &back].map(|camera| {
            let ray = camera.ray_of_pixel(Pixel { row, column });
            ray.direction / ray.direction.abs().max_element()
        });
        let turned = a.normalize().cross(b.normalize()).length();
        if a.dot(b) > 0.0 { turned } else { 2.0 }
    });
    let off = off.into_iter().fold(0.0, f64::max);
    Ok((off > ENOUGH).then(|| {
        format!("its numbers keep this camera's rays to {off:.0e} of a right angle's sine only")
    }))
}
