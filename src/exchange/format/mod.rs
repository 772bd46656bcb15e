//! The parts of every format: its conventions, its writer, and what is exported and imported.

mod conventions;
mod export_scene;
pub(crate) mod text;

use std::path::Path;

use pinhole_core::Camera;

use self::text::BEYOND;
use crate::error::one_line;
use crate::{FileError, Location, legible};

pub use conventions::{Axis, Conventions, PixelConvention};
pub(crate) use export_scene::square_note;
pub use export_scene::{ExportScene, Include, Unsupported};
pub use text::Text;

/// A program, a habit of writing cameras, or a language that Pinhole writes them for.
#[derive(Debug)]
pub struct Format {
    /// Name on the command line, after `--to`.
    pub name: &'static str,
    /// Name on the screen.
    pub label: &'static str,
    /// Name in a word or two.
    pub short: &'static str,
    /// Proposed name of its file.
    pub file: &'static str,
    /// Its conventions; `None` for code, which has the lecture's.
    pub conventions: Option<Conventions>,
    pub(crate) write: fn(&ExportScene, &mut Vec<String>) -> Result<String, Unsupported>,
}

/// An exported scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Exported {
    /// The file's text.
    pub text: Text,
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

/// An imported camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// The camera.
    pub camera: Camera,
    /// Notes on what could not be taken over, and what the text does not say.
    pub notes: Vec<String>,
}

impl Format {
    /// Returns the ending of its files, without the dot.
    pub fn ending(&self) -> &'static str {
        self.file.rsplit('.').next().unwrap_or_default()
    }

    /// The camera, and what else is asked for, in the format's words.
    ///
    /// # Errors
    /// Returns the first quantity that the format cannot express, as one that is not finite.
    pub fn write(&self, subject: &ExportScene) -> Result<Exported, Unsupported> {
        let mut notes = Vec::new();
        let marked = (self.write)(subject, &mut notes)?;
        if let Some(line) = marked.lines().find(|line| line.contains(BEYOND)) {
            let line = Text::from_marked(&line.replace(BEYOND, "infinite")).text;
            return Err(Unsupported(format!(
                "a number would not be finite, in {}: bring the eye and the objects nearer to each other",
                one_line(&line)
            )));
        }
        notes.iter_mut().for_each(|note| *note = legible(note));
        Ok(Exported { text: Text::from_marked(&marked), notes })
    }
}

impl Input<'_> {
    /// An error at a byte of the text.
    pub(crate) fn error_at(&self, at: usize, problem: impl Into<String>) -> FileError {
        FileError::at(self.path, Location::of_byte(self.text.as_bytes(), at), problem)
    }
}
