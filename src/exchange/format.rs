//! The formats of other programs and languages: the name, the template and the conventions of each.

use std::path::Path;

use pinhole_core::{Camera, DVec3};

use crate::error::one_line;
pub use crate::export_scene::{ExportScene, Include};
pub use crate::template::Text;
use crate::template::{self, BEYOND, TemplateValue, n};
use crate::{FileError, Location, legible};

/// A format in which Pinhole writes the camera or the scene: that of another program, a notation for
/// cameras, or code in a programming language.
#[derive(Debug)]
pub struct Format {
    /// Name on the command line, after `--to`.
    pub name: &'static str,
    /// Name on the screen.
    pub label: &'static str,
    /// Short name, of one or two words.
    pub short: &'static str,
    /// The suggested file name.
    pub file: &'static str,
    /// The format's conventions; `None` for code, which uses the lecture's conventions.
    pub conventions: Option<Conventions>,
    /// The text of an exported file, with names in braces in place of values.
    pub(crate) template: &'static str,
    /// The kinds of objects that the format omits or replaces, for a note about them.
    pub(crate) left_out: LeftOut,
    /// Returns the template's values that only this format has, and adds notes to the list. Returns an
    /// error if the format cannot express the scene.
    pub(crate) extra: fn(&ExportScene, &mut Vec<String>) -> Result<ExtraValues, String>,
}

/// Values for a template that only one format has, each with its name in the template.
pub(crate) type ExtraValues = Vec<(&'static str, TemplateValue)>;

/// The objects that a format omits or replaces.
#[derive(Clone, Copy, Debug)]
pub(crate) enum LeftOut {
    /// None, or only objects that need no note.
    Nothing,
    /// Planes, each of which is replaced by a square.
    Squares,
    /// Planes are omitted, for this reason.
    Planes(&'static str),
    /// All objects are omitted, for this reason.
    Objects(&'static str),
}

/// An exported scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Exported {
    /// The file's text.
    pub text: Text,
    /// Notes about parts of the scene that the format cannot express, or expresses in a different way.
    pub notes: Vec<String>,
}

/// A text from another program, with its path for messages.
#[derive(Clone, Copy, Debug)]
pub struct Input<'a> {
    /// The path of the file, as the user gave it.
    pub path: &'a Path,
    /// The contents of the file.
    pub text: &'a str,
}

/// An imported camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// The camera.
    pub camera: Camera,
    /// Notes about parts of the text that could not be imported, and about values that it does not
    /// specify.
    pub notes: Vec<String>,
}

impl Format {
    /// A format that leaves nothing out and has no values of its own.
    pub(crate) const PLAIN: Format = Format {
        name: "",
        label: "",
        short: "",
        file: "",
        conventions: None,
        template: "",
        left_out: LeftOut::Nothing,
        extra: |_, _| Ok(Vec::new()),
    };

    /// Returns the file name extension of the format, without the dot.
    pub fn ending(&self) -> &'static str {
        self.file.rsplit('.').next().unwrap_or_default()
    }

    /// Writes the camera, and the objects if requested, in this format.
    ///
    /// # Errors
    /// Returns a message about the first quantity that the format cannot express, such as one that is
    /// not finite.
    pub fn write(&self, subject: &ExportScene) -> Result<Exported, String> {
        if self.conventions.as_ref().is_some_and(|theirs| theirs.shape.starts_with("square only")) {
            square_pixels(subject, self.label)?;
        }
        let mut notes = Vec::new();
        let extra = (self.extra)(subject, &mut notes)?;
        let marked = template::written(self.template, subject, &extra)?;
        if let Some(line) = marked.lines().find(|line| line.contains(BEYOND)) {
            let line = Text::from_marked(&line.replace(BEYOND, "infinite")).text;
            return Err(format!(
                "a number would not be finite, in {}: bring the eye and the objects nearer to each other",
                one_line(&line)
            ));
        }
        let planes = subject.planes();
        match self.left_out {
            LeftOut::Nothing => {}
            LeftOut::Squares => {
                notes.extend(planes.map(|(plane, title)| {
                    square_note(title, self.short, subject.square_of(plane).1)
                }))
            }
            LeftOut::Planes(why) => {
                notes.extend(planes.map(|(_, title)| format!("{title} is left out: {why}")));
            }
            LeftOut::Objects(_) if subject.objects.is_empty() => {}
            LeftOut::Objects(why) => notes.push(format!("objects are left out: {why}")),
        }
        notes.iter_mut().for_each(|note| *note = legible(note));
        Ok(Exported { text: Text::from_marked(&marked), notes })
    }
}

impl Input<'_> {
    /// Creates an error at this byte of the text.
    pub(crate) fn error_at(&self, at: usize, problem: impl Into<String>) -> FileError {
        FileError::at(self.path, Location::of_byte(self.text.as_bytes(), at), problem)
    }
}

/// The direction of an axis of a format's camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// The axis's letter with its sign: `u`, `−w`.
    pub name: &'static str,
    /// The axis's direction in words: `right`, `up`, `backwards`, or the opposite of one of them.
    pub meaning: &'static str,
    /// The axis's direction in the camera's coordinates (u, v, w).
    pub direction: DVec3,
}

/// How a format counts pixels, and where their centres are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PixelConvention {
    /// x points to the right and y down from the image's corner, with pixel centres at half-integers:
    /// Pinhole's convention.
    Corner,
    /// x points to the right and y down, with pixel centres at integers.
    AtCentre,
    /// y points up from the image's lower left corner, with pixel centres at half-integers.
    FromBottom,
    /// Rows and columns are counted from 1.
    FromOne,
    /// Columns and rows are counted from 0, and the column comes first.
    ColumnFirst,
    /// Coordinates range from -1 to 1 across the image, with y up.
    Device,
}

/// A format's conventions.
#[derive(Debug)]
pub struct Conventions {
    /// Directions of the x, y and z axes of the format's camera.
    pub axes: [Axis; 3],
    /// The quantities that specify the camera.
    pub given_by: &'static str,
    /// The convention for counting pixels.
    pub pixels: PixelConvention,
    /// The quantity that specifies the field of view.
    pub view: &'static str,
    /// The template for the numbers that specify a camera's field of view.
    pub(crate) field: &'static str,
    /// The format's counterpart of the viewport's distance.
    pub distance: &'static str,
    /// The pixel shapes that the format allows.
    pub shape: &'static str,
}

#[allow(missing_docs, reason = "u, v, w of the camera, and their opposites")]
impl Axis {
    pub const U: Axis = Axis { name: "u", meaning: "right", direction: DVec3::X };
    pub const V: Axis = Axis { name: "v", meaning: "up", direction: DVec3::Y };
    pub const W: Axis = Axis { name: "w", meaning: "backwards", direction: DVec3::Z };
    pub const MINUS_U: Axis = Axis { name: "−u", meaning: "left", direction: DVec3::NEG_X };
    pub const MINUS_V: Axis = Axis { name: "−v", meaning: "down", direction: DVec3::NEG_Y };
    pub const MINUS_W: Axis = Axis { name: "−w", meaning: "forwards", direction: DVec3::NEG_Z };

    /// Returns true if the axis is the opposite of u, v or w.
    pub fn is_flipped(self) -> bool {
        self.direction.element_sum() < 0.0
    }
}

impl Conventions {
    /// The axes of a camera in Pinhole.
    pub const OURS: [Axis; 3] = [Axis::U, Axis::V, Axis::W];

    /// Returns true if the axes of the format's camera are right-handed.
    pub fn is_right_handed(&self) -> bool {
        let [x, y, z] = self.axes.map(|axis| axis.direction);
        x.cross(y).dot(z) > 0.0
    }

    /// Returns the number or numbers that specify the camera's field of view in this format.
    pub fn field_of_view(&self, subject: &ExportScene) -> String {
        let value = |name: &str| template::scene_value(subject, name);
        template::filled(self.field, value)
            .unwrap_or_else(|_| "none that can be written".to_owned())
    }
}

/// Returns an error if the pixels are not square.
fn square_pixels(subject: &ExportScene, program: &str) -> Result<(), String> {
    let shape = subject.pixel_shape();
    if shape == 1.0 {
        return Ok(());
    }
    let (viewport, image) = (subject.resolve().viewport(), subject.resolve().image());
    let digits = n(format!("{shape:.6e}").parse().unwrap_or(shape));
    Err(format!(
        "pixels are {} times as wide as high, and {program} has square ones only: make the \
         viewport's width / height, {} / {}, the image's {} / {}",
        digits.replace(BEYOND, "infinitely many"),
        n(viewport.width),
        n(viewport.height),
        image.width(),
        image.height(),
    ))
}

/// Returns the note about a plane that is replaced by a square.
pub(crate) fn square_note(title: &str, program: &str, half: f64) -> String {
    format!(
        "{title} is infinite, and {program} has no infinite plane: written as a square that reaches {} \
         to each side, so that the horizon is a little lower",
        n(half)
    )
}
