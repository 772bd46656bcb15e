//! Fills templates of texts for other programs and languages with the numbers of an exported scene.
//!
//! In a template, `{eye}` stands for the value with that name, and `{eye:STYLE}` for the value in a
//! style. In the style `real`, a number has a point or an exponent, so that no language reads it as an
//! integer; in `single`, it is rounded to `f32`; in `flipped`, it is marked as having the opposite
//! sign; in `spaces`, numbers are separated by blanks instead of commas. Any other text in braces stays
//! as it is.
//!
//! The line `@sphere` or `@plane` begins the text that is written for each sphere or plane. The line
//! `@objects` begins the text before the first object, which is omitted if there are no objects, and
//! `@end` the text after the last one.

use std::ops::Range;

use pinhole_core::arithmetic::unit;
use pinhole_core::{
    BACKGROUND, Basis, DVec3, Intrinsics, Object, Rgb, Sphere, Viewport, fov_of_extent,
};

use crate::error::is_hidden;
use crate::export_scene::{ExportObject, ExportScene};

/// An exported text, and the positions of those numbers in it whose sign is the opposite of Pinhole's.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// The text.
    pub text: String,
    /// Byte ranges of the numbers with the opposite sign, in order.
    pub flipped: Vec<Range<usize>>,
}

/// Characters that mark the start and the end of a number with the opposite sign while the text is
/// being written. They are in Unicode's private use area and never occur in a number.
const OPEN: char = '\u{e000}';
const CLOSE: char = '\u{e001}';

/// The placeholder for a number that is not finite. No format allows such numbers.
pub(crate) const BEYOND: char = '\u{e002}';

impl Text {
    /// Creates a text from a string in which marks enclose the numbers with the opposite sign.
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

/// Formats a number with the fewest digits that read back to the same number; [`BEYOND`] if it is not
/// finite.
pub(crate) fn n(x: f64) -> String {
    if x.is_finite() { pinhole_core::shortest(x) } else { BEYOND.to_string() }
}

/// Formats a vector as `1, 2, 3`.
pub(crate) fn commas(v: DVec3) -> String {
    v.to_array().map(n).join(", ")
}

/// Returns a text that comes from the user, such as a name, without characters that end a line, are
/// hidden, or serve as marks in this module.
fn sanitized(text: &str) -> String {
    text.chars().filter(|c| !is_hidden(*c) && ![OPEN, CLOSE, BEYOND].contains(c)).collect()
}

/// Returns a name in which characters that cannot be quoted in every format are replaced.
pub(crate) fn quotable(name: &str) -> String {
    sanitized(name).chars().map(|c| if "\"'\\<>&".contains(c) { '_' } else { c }).collect()
}

/// Returns a colour in linear light (with the sRGB curve of IEC 61966-2-1), rounded to six digits.
pub(crate) fn light(color: Rgb) -> DVec3 {
    DVec3::from_array(color.map(|byte| {
        let s = f64::from(byte) / 255.0;
        let light = if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) };
        (light * 1e6).round() / 1e6
    }))
}

/// A value that replaces a name in a template.
#[derive(Clone, Debug)]
pub(crate) enum TemplateValue {
    Numbers(Vec<f64>),
    Text(String),
}

impl From<f64> for TemplateValue {
    fn from(x: f64) -> TemplateValue {
        TemplateValue::Numbers(vec![x])
    }
}

impl From<DVec3> for TemplateValue {
    fn from(v: DVec3) -> TemplateValue {
        TemplateValue::Numbers(v.to_array().to_vec())
    }
}

impl From<String> for TemplateValue {
    fn from(text: String) -> TemplateValue {
        TemplateValue::Text(text)
    }
}

impl TemplateValue {
    fn written(self, style: &str) -> String {
        let numbers = match self {
            TemplateValue::Numbers(numbers) => numbers,
            TemplateValue::Text(text) => return text,
        };
        let with_point = |text: String| if text.contains(['.', 'e']) { text } else { text + ".0" };
        let number = |x: f64| match style {
            "real" => with_point(n(x)),
            // The sign of a negative zero is not needed.
            "single" => with_point(format!("{:?}", x as f32 + 0.0)),
            "flipped" => format!("{OPEN}{}{CLOSE}", n(x)),
            _ => n(x),
        };
        let between = if style == "spaces" { " " } else { ", " };
        numbers.into_iter().map(number).collect::<Vec<_>>().join(between)
    }
}

/// Returns the exported text: the template with the scene's values and the values `extra`, which only
/// this format has, filled in.
///
/// # Errors
/// Returns an error if a value does not exist for the scene.
pub(crate) fn written(
    template: &str,
    subject: &ExportScene,
    extra: &[(&str, TemplateValue)],
) -> Result<String, String> {
    let value = |name: &str| match extra.iter().find(|(known, _)| *known == name) {
        Some((_, value)) => Ok(Some(value.clone())),
        None => scene_value(subject, name),
    };
    let [sphere, plane] = ["\n@sphere\n", "\n@plane\n"].map(|line| section(template, line));
    let mut objects = String::new();
    for object in &subject.objects {
        let section = if matches!(object.shape, Object::Sphere(_)) { sphere } else { plane };
        objects += &filled(section, |name| Ok(object_value(subject, object, name)))?;
    }
    let mut text = filled(before_mark(template), value)?;
    if !objects.is_empty() {
        text += &filled(section(template, "\n@objects\n"), value)?;
        text += &objects;
    }
    Ok(text + section(template, "\n@end\n"))
}

/// Returns the section of a template that begins after `line`, up to the next line that begins with
/// `@`; empty if there is no such line.
pub(crate) fn section<'t>(template: &'t str, line: &str) -> &'t str {
    template.split_once(line).map_or("", |(_, section)| before_mark(section))
}

fn before_mark(text: &str) -> &str {
    text.find("\n@").map_or(text, |at| &text[..=at])
}

/// Returns the template with each name in braces replaced by its value; a name without a value stays as
/// it is.
pub(crate) fn filled(
    template: &str,
    value: impl Fn(&str) -> Result<Option<TemplateValue>, String>,
) -> Result<String, String> {
    let (mut text, mut rest) = (String::with_capacity(template.len()), template);
    while let Some((before, after)) = rest.split_once('{') {
        text += before;
        let (inside, behind) = after.split_once('}').unwrap_or((after, ""));
        let (name, style) = inside.split_once(':').unwrap_or((inside, ""));
        match value(name)? {
            Some(value) => (text, rest) = (text + &value.written(style), behind),
            None => (text, rest) = (text + "{", after),
        }
    }
    Ok(text + rest)
}

/// The largest quotient of a side of the viewport and its distance whose angle tells it to ten digits: towards
/// 180 degrees, the side changes more and more.
const WIDEST: f64 = 1e6;

/// The largest quotient of two of the viewport's measures in a template.
const LARGEST: f64 = 1e300;

/// Returns the value with this name in templates that a scene's camera determines; `None` if no such
/// value has this name.
pub(crate) fn scene_value(
    subject: &ExportScene,
    name: &str,
) -> Result<Option<TemplateValue>, String> {
    let (camera, resolved) = (&subject.document.camera, subject.resolve());
    let Basis { u, v, w } = *resolved.basis();
    let (eye, viewport, image) = (resolved.eye(), resolved.viewport(), resolved.image());
    let Viewport { width, height, distance } = *viewport;
    let [w_of, h_of, d_of] = [("width", width), ("height", height), ("distance", distance)];
    let angle = |side| quotient(side, d_of, WIDEST).map(|_| fov_of_extent(side.1, distance));
    let (across, upwards) = (|| angle(w_of), || angle(h_of));
    let focal = |side| quotient(d_of, side, LARGEST);
    let intrinsics =
        || focal(w_of).and(focal(h_of)).map(|_| Intrinsics::from_viewport(viewport, image));
    let from_eye = || resolved.basis().to_camera_from_world(eye);
    let row = |k: usize| TemplateValue::Numbers([u, v, w, eye].map(|column| column[k]).to_vec());
    Ok(Some(match name {
        "columns" => image.width().to_string().into(),
        "rows" => image.height().to_string().into(),
        "width" => width.into(),
        "height" => height.into(),
        "distance" => distance.into(),
        "aspect" => quotient(w_of, h_of, LARGEST)?.into(),
        "focal" => focal(w_of)?.into(),
        "eye" => eye.into(),
        "at" => subject.look_at()?[0].into(),
        "up" => subject.look_at()?[1].into(),
        "view" => camera.view().into(),
        "given_up" => camera.up().into(),
        "u" => u.into(),
        "v" => v.into(),
        "w" => w.into(),
        "minus_v" => (-v).into(),
        "minus_w" => (-w).into(),
        "right" => (width * u).into(),
        "upwards" => (height * v).into(),
        "forwards" => (-distance * w).into(),
        "row_x" => row(0),
        "row_y" => row(1),
        "row_z" => row(2),
        "near" => subject.clip().0.into(),
        "far" => subject.clip().1.into(),
        "vertical_radians" => upwards()?.into(),
        "vertical_degrees" => upwards()?.to_degrees().into(),
        "horizontal_radians" => across()?.into(),
        "horizontal_degrees" => across()?.to_degrees().into(),
        "shorter_degrees" => across()?.min(upwards()?).to_degrees().into(),
        "fx" => intrinsics()?.fx.into(),
        "fy" => intrinsics()?.fy.into(),
        "cx" => (intrinsics()?.cx - 0.5).into(),
        "cy" => (intrinsics()?.cy - 0.5).into(),
        "t_x" => (-from_eye().x).into(),
        "t_y" => from_eye().y.into(),
        "t_z" => from_eye().z.into(),
        "background" => light(BACKGROUND).into(),
        "-1" => (-1.0).into(),
        _ => return Ok(None),
    }))
}

/// Returns the quotient of two of the viewport's measures, each with its name.
///
/// # Errors
/// Returns the rule if it is not between 1e-300 and `most`.
fn quotient((first, a): (&str, f64), (second, b): (&str, f64), most: f64) -> Result<f64, String> {
    match a / b {
        held if (1e-300..=most).contains(&held) => Ok(held),
        _ => Err(format!(
            "the viewport's {first} / {second} is {} / {}: it must be between 1e-300 and {most:e}, or the numbers \
             of this format do not tell it",
            n(a),
            n(b)
        )),
    }
}

/// Returns an object's value with this name in templates; `None` if there is none. A plane's values
/// describe the square that represents it: rows of the matrix from the unit square to the world, and
/// corners.
fn object_value(subject: &ExportScene, object: &ExportObject, name: &str) -> Option<TemplateValue> {
    match name {
        "title" => return Some(sanitized(&object.title).into()),
        "name" => return Some(quotable(&object.title).into()),
        "light" => return Some(light(object.color).into()),
        _ => {}
    }
    let plane = match object.shape {
        Object::Sphere(Sphere { center, radius }) => {
            return Some(match name {
                "center" => center.into(),
                "x" => center.x.into(),
                "y" => center.y.into(),
                "z" => center.z.into(),
                "radius" => radius.into(),
                _ => return None,
            });
        }
        Object::Plane(plane) => plane,
    };
    let normal = unit(plane.normal);
    let (middle, half, [a, b]) = subject.square_of(&plane);
    let columns = [half * a, half * b, a.cross(b), middle];
    let row = |k: usize| TemplateValue::Numbers(columns.map(|column| column[k]).to_vec());
    let corner = |x: f64, y: f64| (middle + half * (x * a + y * b)).into();
    Some(match name {
        "normal" => normal.into(),
        "offset" => normal.dot(plane.point).into(),
        "row_x" => row(0),
        "row_y" => row(1),
        "row_z" => row(2),
        "corner_0" => corner(-1.0, -1.0),
        "corner_1" => corner(1.0, -1.0),
        "corner_2" => corner(-1.0, 1.0),
        "corner_3" => corner(1.0, 1.0),
        _ => return None,
    })
}
