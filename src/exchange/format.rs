//! The parts of every format: its name, its writer, its conventions where they differ from
//! Pinhole's, and its text, in which numbers with the opposite sign are marked.

use std::fmt;
use std::ops::Range;
use std::path::Path;

use pinhole_core::arithmetic::{length, unit};
use pinhole_core::{
    Camera, DVec3, Intrinsics, Orientation, OrientationKind, Plane, ResolvedCamera, Rgb, Scene,
    Sphere, Viewport,
};

use crate::document::Document;
use crate::error::{is_hidden, one_line};
use crate::{FileError, Location, legible};

/// A program, a notation for cameras, or a programming language that Pinhole writes.
#[derive(Debug)]
pub struct Format {
    /// Name on the command line, after `--to`.
    pub name: &'static str,
    /// Name on the screen.
    pub label: &'static str,
    /// Short name, of one or two words.
    pub short: &'static str,
    /// Proposed file name.
    pub file: &'static str,
    /// The format's conventions; `None` for code, which uses the lecture's conventions.
    pub conventions: Option<Conventions>,
    pub(crate) write: fn(&ExportScene, &mut Vec<String>) -> Result<String, Unsupported>,
}

/// An exported scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Exported {
    /// The file's text.
    pub text: Text,
    /// Notes about anything that the format cannot express, or expresses differently.
    pub notes: Vec<String>,
}

/// A text from another program, and its path for messages.
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
    /// Notes about anything that could not be imported, or that the text does not specify.
    pub notes: Vec<String>,
}

impl Format {
    /// Returns the file name extension of the format, without the dot.
    pub fn ending(&self) -> &'static str {
        self.file.rsplit('.').next().unwrap_or_default()
    }

    /// Writes the camera, and the objects if requested, in this format.
    ///
    /// # Errors
    /// Returns the first quantity that the format cannot express, such as one that is not finite.
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
    /// Creates an error at a byte of the text.
    pub(crate) fn error_at(&self, at: usize, problem: impl Into<String>) -> FileError {
        FileError::at(self.path, Location::of_byte(self.text.as_bytes(), at), problem)
    }
}

/// Direction of an axis of a format's camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// The axis's letter with its sign: `u`, `−w`.
    pub name: &'static str,
    /// The direction in words: `right`, `up`, `backwards`, and their opposites.
    pub meaning: &'static str,
    /// The axis's vector, in coordinates (u, v, w).
    pub direction: DVec3,
}

/// How a format counts pixels, and where their centres are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PixelConvention {
    /// x right, y down from the image's corner, centres at halves: Pinhole's convention.
    Corner,
    /// x right, y down, centres at whole numbers.
    AtCentre,
    /// y up from the lower left corner, centres at halves.
    FromBottom,
    /// Rows and columns from 1.
    FromOne,
    /// Row and column from 0, the column first.
    ColumnFirst,
    /// -1 to 1 across the image, y up.
    Device,
}

/// A format's conventions.
#[derive(Debug)]
pub struct Conventions {
    /// Directions of the x, y and z axes of the format's camera.
    pub axes: [Axis; 3],
    /// The numbers that specify the camera.
    pub given_by: &'static str,
    /// The format's convention for pixels.
    pub pixels: PixelConvention,
    /// The quantity that specifies the field of view.
    pub view: &'static str,
    /// Returns the numbers that describe the field of view of a camera.
    pub(crate) field: fn(&ExportScene) -> String,
    /// The format's counterpart of the viewport's distance.
    pub distance: &'static str,
    /// The pixel shapes that the format allows.
    pub shape: &'static str,
    /// The precision in which the other program computes.
    pub lengths: &'static str,
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

    /// Returns the number or numbers that describe the field of view of a camera.
    pub fn field_of_view(&self, subject: &ExportScene) -> String {
        (self.field)(subject).replace(BEYOND, "beyond f64")
    }
}

/// A text, and the parts whose sign is the opposite of Pinhole's.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// The text.
    pub text: String,
    /// Byte ranges of the parts with the opposite sign, in order.
    pub flipped: Vec<Range<usize>>,
}

/// Marks around a flipped part while the text is being written: characters of the private use area,
/// which never occur in a number.
const OPEN: char = '\u{e000}';
const CLOSE: char = '\u{e001}';

/// Placeholder for a number that is not finite, which no format allows.
const BEYOND: char = '\u{e002}';

/// Formats a number with the fewest digits that read back to the same number.
pub(crate) fn n(x: f64) -> String {
    if x.is_finite() { pinhole_core::shortest(x) } else { BEYOND.to_string() }
}

impl Text {
    /// Creates a text from a string in which numbers may be marked by [`flipped`].
    pub(crate) fn from_marked(marked: &str) -> Text {
        let mut made = Text::default();
        let mut from = 0;
        for c in marked.chars() {
            match c {
                OPEN => from = made.text.len(),
                CLOSE => made.flipped.push(from..made.text.len()),
                c => made.text.push(c),
            }
        }
        made
    }
}

/// Formats a number with the opposite sign, and marks it.
pub(crate) fn flipped(x: f64) -> String {
    format!("{OPEN}{}{CLOSE}", n(x))
}

/// Returns an external text, such as a name, without characters that would end a line, are hidden,
/// or serve as marks in this module.
pub(crate) fn sanitized(text: &str) -> String {
    text.chars().filter(|c| !is_hidden(*c) && ![OPEN, CLOSE, BEYOND].contains(c)).collect()
}

/// Returns a name that can be quoted in every format.
pub(crate) fn quotable(name: &str) -> String {
    sanitized(name).chars().map(|c| if "\"'\\<>&".contains(c) { '_' } else { c }).collect()
}

/// Formats a number with a point or an exponent, for formats in which `1` would be an integer and divided as
/// one.
pub(crate) fn real(x: f64) -> String {
    point(n(x))
}

/// Adds a point to the text of a number that has neither a point nor an exponent.
pub(crate) fn point(number: String) -> String {
    if number.contains(['.', 'e']) { number } else { number + ".0" }
}

/// Formats a vector as `1, 2, 3`.
pub(crate) fn commas(v: DVec3) -> String {
    commas_of(v, n)
}

/// Formats a vector's components with `number`, separated by commas.
pub(crate) fn commas_of(v: DVec3, number: impl Fn(f64) -> String) -> String {
    v.to_array().map(number).join(", ")
}

/// Formats a vector as `1 2 3`.
pub(crate) fn spaces(v: DVec3) -> String {
    v.to_array().map(n).join(" ")
}

/// Formats the three rows of a matrix that is given by its columns.
pub(crate) fn rows(columns: [DVec3; 4], between: &str) -> [String; 3] {
    [0, 1, 2].map(|k| columns.map(|column| n(column[k])).join(between))
}

/// Converts a colour to linear light (with the sRGB curve of IEC 61966-2-1), and formats it with
/// six digits.
pub(crate) fn light(color: Rgb, between: &str) -> String {
    let parts = color.map(|byte| {
        let s = f64::from(byte) / 255.0;
        let light = if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) };
        n((light * 1e6).round() / 1e6)
    });
    parts.join(between)
}

/// The reason why a format cannot express a scene, and what would have to change.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsupported(pub String);

impl fmt::Display for Unsupported {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Unsupported {}

/// The objects to export with the camera.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Include {
    /// No objects.
    CameraAlone,
    /// The objects that the format supports.
    #[default]
    Objects,
    /// The objects that the format supports, and meshes in place of other objects.
    Meshes,
}

/// A scene to export.
#[derive(Clone, Debug)]
pub struct ExportScene<'a> {
    /// The scene.
    pub document: &'a Document,
    /// The objects to export with the camera.
    pub include: Include,
    /// The spheres; empty unless objects are requested.
    pub(crate) spheres: Vec<ExportObject<Sphere>>,
    /// The planes; empty unless objects are requested.
    pub(crate) planes: Vec<ExportObject<Plane>>,
    resolved: ResolvedCamera,
}

/// A sphere or plane with its title and colour.
#[derive(Clone, Debug)]
pub(crate) struct ExportObject<S> {
    pub(crate) shape: S,
    pub(crate) color: Rgb,
    pub(crate) title: String,
}

/// Largest difference from 1 of an aspect ratio that counts as square: a few rounding errors.
const SQUARE: f64 = 1e-14;

impl<'a> ExportScene<'a> {
    /// Creates the scene from a document whose camera has a basis.
    ///
    /// # Errors
    /// Returns an error if the camera, or a requested object, is invalid.
    pub fn new(document: &'a Document, include: Include) -> Result<ExportScene<'a>, Unsupported> {
        let resolved = document.camera.resolve().map_err(|error| Unsupported(error.to_string()))?;
        let scene = match include {
            Include::CameraAlone => Scene::default(),
            _ => document.scene().map_err(|error| Unsupported(error.to_string()))?,
        };
        let spheres = export_objects(document, 0, scene.spheres());
        let planes = export_objects(document, scene.spheres().len(), scene.planes());
        Ok(ExportScene { document, include, spheres, planes, resolved })
    }

    /// Returns the camera with its basis.
    pub fn resolve(&self) -> &ResolvedCamera {
        &self.resolved
    }

    pub(crate) fn camera(&self) -> &Camera {
        &self.document.camera
    }

    pub(crate) fn viewport(&self) -> &Viewport {
        self.resolved.viewport()
    }

    /// Returns the image size, W and H.
    pub(crate) fn size(&self) -> [u32; 2] {
        [self.resolved.image().width(), self.resolved.image().height()]
    }

    pub(crate) fn intrinsics(&self) -> Intrinsics {
        Intrinsics::from_viewport(self.viewport(), self.resolved.image())
    }

    /// Returns the vertical field of view in degrees.
    pub(crate) fn vertical_degrees(&self) -> f64 {
        self.viewport().vertical_fov().to_degrees()
    }

    /// Returns the points eye and at, and the vector up.
    pub(crate) fn look_at(&self) -> Result<[DVec3; 3], Unsupported> {
        let camera = self.camera().given_by(OrientationKind::At);
        match camera.map(|camera| (camera.eye, camera.orientation)) {
            Ok((eye, Orientation::At { at, up })) => Ok([eye, at, up]),
            _ => Err(Unsupported(
                "eye is so far out that no point ahead of it keeps the direction: move the scene \
                 nearer to the origin"
                    .to_owned(),
            )),
        }
    }

    /// Returns a pixel's width divided by its height in the world; exactly 1 if the ratio differs
    /// from 1 only by rounding.
    pub(crate) fn pixel_shape(&self) -> f64 {
        let [width, height] = self.size().map(f64::from);
        let viewport = self.viewport();
        let shape = (viewport.width / width) / (viewport.height / height);
        if (shape - 1.0).abs() <= SQUARE { 1.0 } else { shape }
    }

    /// Returns an error if the pixels are not square.
    pub(crate) fn square_pixels(&self, program: &str) -> Result<(), Unsupported> {
        let shape = self.pixel_shape();
        if shape == 1.0 {
            return Ok(());
        }
        let [width, height] = self.size();
        let viewport = self.viewport();
        Err(Unsupported(format!(
            "pixels are {} times as wide as high, and {program} has square ones only: make the \
             viewport's width / height, {} / {}, the image's {width} / {height}",
            n((shape * 1e6).round() / 1e6),
            n(viewport.width),
            n(viewport.height),
        )))
    }

    /// Returns the note about objects that a format cannot contain; `None` if there are none.
    pub(crate) fn objects_left_out(&self, why: &str) -> Option<String> {
        let is_empty = self.spheres.is_empty() && self.planes.is_empty();
        (!is_empty).then(|| format!("objects are left out: {why}"))
    }

    /// Returns the near and far distances for programs that clip.
    pub(crate) fn clip(&self) -> (f64, f64) {
        let eye = self.resolved.eye();
        let spheres = &self.spheres;
        let reach = |s: &ExportObject<Sphere>| length(s.shape.center - eye) + s.shape.radius;
        let far = spheres.iter().map(reach).fold(1e4, f64::max);
        let gap = |s: &ExportObject<Sphere>| (length(s.shape.center - eye) - s.shape.radius).abs();
        let gaps = spheres.iter().map(gap).filter(|gap| *gap > 0.0);
        let near = gaps.map(|gap| 0.25 * gap).fold(0.01, f64::min).max(1e-6 * far.min(1e4));
        (near, if far > 1e4 { 2.0 * far } else { far })
    }

    /// Returns a square that replaces the plane in programs without infinite planes: its centre, half its side,
    /// and two unit vectors along its sides.
    pub(crate) fn square_of(&self, plane: &Plane) -> (DVec3, f64, [DVec3; 2]) {
        let normal = unit(plane.normal);
        let height = (self.resolved.eye() - plane.point).dot(normal);
        let middle = self.resolved.eye() - height * normal;
        let basis = normal.any_orthonormal_pair();
        let reach = length(self.resolved.eye() - plane.point).max(1.0);
        // A power of ten, at least a thousand times as far as anything visible.
        (middle, 10_f64.powf((1e3 * reach).log10().ceil()), [basis.0, basis.1])
    }
}

/// Returns the objects with their colours and titles; the first one has the index `first`.
fn export_objects<S: Copy>(
    document: &Document,
    first: usize,
    shapes: &[S],
) -> Vec<ExportObject<S>> {
    let object = |(k, shape): (usize, &S)| ExportObject {
        shape: *shape,
        color: document.color_of((first + k) as u32),
        title: document.title_of(first + k),
    };
    shapes.iter().enumerate().map(object).collect()
}

/// Returns the note about a square that replaces a plane.
pub(crate) fn square_note(title: &str, program: &str, half: f64) -> String {
    format!(
        "{title} is infinite, and {program} has no infinite plane: written as a square that reaches {} \
         to each side, so that the horizon is a little lower",
        n(half)
    )
}
