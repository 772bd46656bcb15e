//! Reading OpenCV's K and [R|t]: in JSON, in a YAML file of `cv::FileStorage`, or in statements whose
//! numbers are literal.

use pinhole_core::{Camera, DVec3, ImageSize, Intrinsics};

use super::fields::{Field, fields};
use super::{off_centre, pose_of, viewport_of};
use crate::format::affine::Affine;
use crate::format::image_size::{image_of, size_note};
use crate::format::text::n;
use crate::format::{Imported, Input};
use crate::{FileError, Location};

const K_NAMES: [&str; 7] = [
    "K",
    "camera_matrix",
    "cameraMatrix",
    "camera_intrinsics",
    "intrinsics",
    "intrinsic_matrix",
    "mtx",
];
const R_NAMES: [&str; 3] = ["R", "rotation", "rotation_matrix"];
const VECTOR_NAMES: [&str; 3] = ["rvec", "rotation_vector", "rvecs"];
const T_NAMES: [&str; 6] = ["t", "tvec", "translation", "translation_vector", "T", "tvecs"];
const RT_NAMES: [&str; 3] = ["Rt", "extrinsics", "extrinsic"];
const DISTORTION_NAMES: [&str; 6] =
    ["distortion", "dist", "distortion_coefficients", "dist_coeffs", "distCoeffs", "dist_coefs"];

/// Names of the image's size: width and height.
const SIZE_NAMES: [[&str; 2]; 3] =
    [["image_width", "image_height"], ["imageWidth", "imageHeight"], ["width", "height"]];

fn is_known(name: &str) -> bool {
    let lists: [&[&str]; 6] =
        [&K_NAMES, &R_NAMES, &VECTOR_NAMES, &T_NAMES, &RT_NAMES, &DISTORTION_NAMES];
    lists.iter().any(|list| list.contains(&name)) || SIZE_NAMES.as_flattened().contains(&name)
}

/// A text with K and a rotation, or with a K that is more than a number.
pub(super) fn detect(text: &str) -> bool {
    let any = |names: &[&str], fits: &dyn Fn(&str) -> bool| {
        names.iter().any(|name| given(text, name).any(fits))
    };
    let is_list = |value: &str| value.starts_with(['[', '(', '{', '!', 'n', '\n']);
    any(&K_NAMES, &is_list)
        || any(&K_NAMES, &|_| true) && (any(&R_NAMES, &|_| true) || any(&VECTOR_NAMES, &|_| true))
}

/// Finds the texts behind a name and its `=` or `:`.
fn given<'t>(text: &'t str, name: &str) -> impl Iterator<Item = &'t str> {
    let is_of_name = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.');
    let length = name.len();
    text.match_indices(name).map(|(at, _)| at).filter_map(move |at| {
        if text[..at].ends_with(is_of_name) {
            return None;
        }
        let rest = text[at + length..].trim_start_matches(['"', '\'']).trim_start_matches(' ');
        Some(rest.strip_prefix(['=', ':'])?.trim_start_matches(' '))
    })
}

/// The fields of a text, and how their faults are told.
struct Reader<'a, 't> {
    text: &'a Input<'t>,
    fields: Vec<Field>,
}

/// A value, and the field that gives it.
struct Value<'r> {
    field: &'r Field,
    numbers: &'r [f64],
}

impl Reader<'_, '_> {
    fn fault(&self, field: &Field, right: &str) -> FileError {
        self.text.error_at(field.at, format!("{} is {}: {right}", field.name, field.shown))
    }

    fn missing(&self, name: &str, right: &str) -> FileError {
        FileError::of_file(self.text.path, format!("{name} is missing: {right}"))
    }

    /// Returns the value that one of these names is given, of one of these counts of numbers.
    ///
    /// # Errors
    /// Returns an error if a name is given no numbers, none has one of the counts, or two are given.
    fn one_of(
        &self,
        names: &[&str],
        counts: &[usize],
        right: &str,
    ) -> Result<Option<Value<'_>>, FileError> {
        let (mut taken, mut other): (Option<Value>, Option<&Field>) = (None, None);
        for field in self.fields.iter().filter(|field| names.contains(&&field.name[..])) {
            let Some(numbers) = &field.numbers else { return Err(self.fault(field, right)) };
            if !counts.contains(&numbers.len()) {
                other = other.or(Some(field));
            } else if let Some(first) = &taken {
                return Err(self.given_too(field, first.field));
            } else {
                taken = Some(Value { field, numbers });
            }
        }
        match (taken, other) {
            (None, Some(field)) => Err(self.fault(field, right)),
            (taken, _) => Ok(taken),
        }
    }

    fn given_too(&self, field: &Field, first: &Field) -> FileError {
        self.fault(field, &format!("{} is given too: only one of them may be", first.name))
    }

    fn number(&self, name: &str) -> Result<Option<Value<'_>>, FileError> {
        self.one_of(&[name], &[1], "it must be one number")
    }
}

pub(super) fn read(text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    let reader = Reader { text, fields: fields(text, is_known)? };
    let mut notes = Vec::new();
    let intrinsics = intrinsics(&reader)?;
    let image = size(&reader, &intrinsics, at_hand, &mut notes)?;
    off_centre(&intrinsics, image, &mut notes);
    let (rows, t) = pose(&reader, &mut notes)?;
    for field in &reader.fields {
        let is_zero = |numbers: &Vec<f64>| numbers.iter().all(|k| *k == 0.0);
        if DISTORTION_NAMES.contains(&&field.name[..])
            && !field.numbers.as_ref().is_some_and(is_zero)
        {
            let name = &field.name;
            notes.push(format!("{name} is left out: a pinhole draws straight lines straight"));
            break;
        }
    }
    let (orientation, eye, _) = pose_of(rows, t)
        .right_handed(&mut notes)
        .map_err(|right| FileError::of_file(text.path, format!("R is no rotation: {right}")))?;
    let viewport = viewport_of(&intrinsics, image, at_hand.viewport.distance);
    Ok(Imported::camera(Camera { eye, orientation, viewport, image }, notes))
}

fn intrinsics(reader: &Reader) -> Result<Intrinsics, FileError> {
    let k = reader.one_of(&K_NAMES, &[9], "it must be 3 × 3 numbers")?;
    let k = k.ok_or_else(|| reader.missing("K", "it must be nine numbers"))?;
    let [fx, skew, cx, zero, fy, cy, p, q, r] = *k.numbers else {
        return Err(reader.missing("K", "it must be nine numbers"));
    };
    // A skew of roundings is none.
    let has_skew = skew.abs() > 4.0 * f64::EPSILON * fx;
    if [zero, p, q] != [0.0; 3] || r != 1.0 || has_skew || !(fx > 0.0 && fy > 0.0) {
        let right = "it must be fx 0 cx, 0 fy cy, 0 0 1 with fx and fy greater than 0";
        return Err(reader.fault(k.field, right));
    }
    Ok(Intrinsics { fx, fy, cx: cx + 0.5, cy: cy + 0.5 })
}

/// Images that are guessed from the principal point are no smaller.
const SMALLEST: f64 = 4.0;

fn size(
    reader: &Reader,
    k: &Intrinsics,
    at_hand: &Camera,
    notes: &mut Vec<String>,
) -> Result<ImageSize, FileError> {
    let unsaid = "the image's size is not given";
    for [width, height] in SIZE_NAMES {
        let (Some(width), Some(height)) = (reader.number(width)?, reader.number(height)?) else {
            continue;
        };
        return image_of(width.numbers[0], height.numbers[0])
            .map_err(|right| reader.fault(width.field, &right));
    }
    // cx = 320 is meant as half of 640 by those who do not count from centres.
    let doubled = [k.cx, k.cy].map(|c| 2.0 * (c - 0.5));
    let [around_x, around_y] = [k.cx, k.cy].map(|c| (2.0 * c).round());
    if around_x.min(around_y) < SMALLEST {
        return Err(reader.missing(
            "width",
            &format!(
                "K's principal point is ({}, {}), which no image has in its middle: width and height \
                 must be given",
                n(k.cx - 0.5),
                n(k.cy - 0.5)
            ),
        ));
    }
    if doubled.iter().all(|size| size % 2.0 == 0.0)
        && let Ok(image) = image_of(doubled[0], doubled[1])
    {
        notes.push(size_note(unsaid, image, ", twice cx and cy, taken"));
        return Ok(image);
    }
    if let Ok(image) = image_of(around_x, around_y) {
        notes.push(size_note(unsaid, image, ", whose middle is the principal point, taken"));
        return Ok(image);
    }
    notes.push(size_note(unsaid, at_hand.image, ", the one at hand, taken"));
    Ok(at_hand.image)
}

/// Maximum difference of one rotation's numbers in two forms, as they are printed: to eight digits.
const AGREE: f64 = 1e-6;

/// R's rows and t, given apart or as one 3 × 4 or 4 × 4 matrix; R as a matrix, by Rodrigues' vector, or by
/// both where they agree. A calibration gives neither: its camera's frame is the world's.
fn pose(reader: &Reader, notes: &mut Vec<String>) -> Result<([DVec3; 3], DVec3), FileError> {
    let whole = reader.one_of(&RT_NAMES, &[12, 16], "it must be [R|t], 3 × 4")?;
    let matrix = reader.one_of(&R_NAMES, &[9], "it must be 3 × 3 numbers")?;
    let vector = reader.one_of(&VECTOR_NAMES, &[3], "it must be three numbers")?;
    let translation = reader.one_of(&T_NAMES, &[3], "it must be three numbers")?;
    if let Some(whole) = whole {
        if let Some(other) = matrix.or(vector).or(translation) {
            return Err(reader.given_too(other.field, whole.field));
        }
        let affine = Affine::from_rows(whole.numbers)
            .ok_or_else(|| reader.fault(whole.field, "its last row must be 0 0 0 1"))?;
        return Ok((rows(&affine), affine.at));
    }
    if matrix.is_none() && vector.is_none() && translation.is_none() {
        let said = "R and t are not given: the eye is taken at the origin, looking along +z with y down, as \
                    OpenCV's camera does";
        notes.push(said.to_owned());
        return Ok((rows(&Affine::IDENTITY), DVec3::ZERO));
    }
    let by_matrix =
        matrix.map(|m| (m.field, [0, 3, 6].map(|k| DVec3::from_slice(&m.numbers[k..]))));
    let by_vector = vector.map(|vector| (vector.field, turned(&vector, notes)));
    if let (Some((matrix, rows)), Some((vector, others))) = (by_matrix, by_vector)
        && !rows.iter().zip(others).all(|(row, other)| row.abs_diff_eq(other, AGREE))
    {
        let line = Location::of_byte(reader.text.text.as_bytes(), matrix.at).line;
        let name = &matrix.name;
        let right =
            format!("{name} in line {line} is another rotation: only one of them may be given");
        return Err(reader.fault(vector, &right));
    }
    let (_, rotation) = by_matrix
        .or(by_vector)
        .ok_or_else(|| reader.missing("R", "the rotation must be nine numbers, or rvec three"))?;
    let translation =
        translation.ok_or_else(|| reader.missing("t", "the translation must be three numbers"))?;
    Ok((rotation, DVec3::from_slice(translation.numbers)))
}

fn rows(turn: &Affine) -> [DVec3; 3] {
    [0, 1, 2].map(|k| DVec3::new(turn.x[k], turn.y[k], turn.z[k]))
}

/// The rows of the rotation that a vector gives as OpenCV has it: about it, by its length in radians.
fn turned(value: &Value, notes: &mut Vec<String>) -> [DVec3; 3] {
    let vector = DVec3::from_slice(value.numbers);
    if vector.length() > std::f64::consts::TAU {
        let note =
            "turns by more than a full turn: its length is taken as radians, as OpenCV has it";
        notes.push(format!("{} {note}", value.field.name));
    }
    let turn = Affine::rotation(vector.length().to_degrees(), vector);
    rows(&turn.unwrap_or(Affine::IDENTITY))
}
