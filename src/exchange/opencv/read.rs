//! OpenCV's K and [R|t] as they are given in JSON, in Python, in C++, as NumPy prints them, or in a
//! YAML file of `cv::FileStorage`. Whatever has one of the names is understood to its end, or refused.

use std::path::Path;

use pinhole_core::{Camera, DVec3, ImageSize, Intrinsics};

use super::off_centre;
use super::stance;
use super::viewport_of;
use crate::exchange::affine::Affine;
use crate::exchange::back::{image_of, size_taken};
use crate::exchange::code::{Code, Comments};
use crate::exchange::matrix::Matrix;
use crate::exchange::matrix::names::{Found, Names};
use crate::exchange::sheet::n;
use crate::exchange::{Taken, Text};
use crate::formats::FileError;

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

/// Signs of C++, whose comments are others.
fn comments(text: &str) -> Comments {
    let is_cpp = ["cv::", "#include", "Mat_<", "Matx33"].iter().any(|sign| text.contains(sign));
    if is_cpp { Comments::Slashes } else { Comments::Hash }
}

pub(super) fn claims(text: &str) -> bool {
    if !K_NAMES.iter().any(|name| text.contains(name)) {
        return false;
    }
    let kind = comments(text);
    let code = Code::new(&Text { path: Path::new(""), text }, kind);
    let names = Names::new(&code, kind);
    let is_made = |found: &Found| match &found.value {
        Ok(value) => !value.is_scalar(),
        Err(_) => found.piece.text.contains(['(', '[']),
    };
    let given =
        |list: &[&str]| list.iter().any(|name| names.find(name).is_some_and(|f| is_made(&f)));
    let is_k = |name: &&str| {
        let value = names.find(name).and_then(|found| found.value.ok());
        value.is_some_and(|value| value.numbers.len() == 9)
    };
    given(&K_NAMES)
        && (given(&R_NAMES)
            || given(&VECTOR_NAMES)
            || given(&RT_NAMES[..2])
            || K_NAMES.iter().any(is_k))
}

/// The names of a text, and how its faults are told.
struct Reader<'c, 't> {
    code: &'c Code<'t>,
    names: Names<'c>,
}

/// A value, and where it is given by which name.
struct Value<'t> {
    name: &'static str,
    found: Found<'t>,
    numbers: Vec<f64>,
}

impl<'c> Reader<'c, '_> {
    fn fault(&self, name: &str, found: &Found, right: &str) -> FileError {
        self.code.fault(name, found.piece, right)
    }

    /// What one of these names is given, of one of these counts of numbers.
    ///
    /// # Errors
    /// Where one is not understood, where none has so many numbers, and where two differ.
    fn one_of(
        &self,
        names: &[&'static str],
        counts: &[usize],
        right: &str,
    ) -> Result<Option<Value<'c>>, FileError> {
        let (mut taken, mut other): (Option<Value>, _) = (None, None);
        for name in names {
            let Some(found) = self.names.find(name) else { continue };
            let value = match &found.value {
                Ok(value) => value,
                Err(why) => return Err(self.fault(name, &found, &format!("{right}, and {why}"))),
            };
            let numbers = value.numbers.clone();
            if !counts.contains(&numbers.len()) {
                other = other.or(Some((name, found)));
                continue;
            }
            match &taken {
                Some(first) if !alike(&first.numbers, &numbers) => {
                    let right = format!("{} is another: only one of them may be given", first.name);
                    return Err(self.fault(name, &found, &right));
                }
                Some(_) => (),
                None => taken = Some(Value { name, found, numbers }),
            }
        }
        match (taken, other) {
            (None, Some((name, found))) => Err(self.fault(name, &found, right)),
            (taken, _) => Ok(taken),
        }
    }

    /// A number that may be missing, or not be understood.
    fn number(&self, names: &[&str]) -> Option<f64> {
        names.iter().find_map(|name| self.names.find(name)?.value.ok()?.number())
    }
}

/// Up to a rounding to a few digits.
fn alike(a: &[f64], b: &[f64]) -> bool {
    let size = a.iter().chain(b).fold(0.0_f64, |size, x| size.max(x.abs()));
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-6 * size)
}

pub(super) fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let kind = comments(text.text);
    let code = Code::new(text, kind);
    let reader = Reader { code: &code, names: Names::new(&code, kind) };
    let mut notes = Vec::new();
    let intrinsics = intrinsics(&reader)?;
    let image = size(&reader, &intrinsics, at_hand, &mut notes)?;
    off_centre(&intrinsics, image, &mut notes);
    let (rows, t) = pose(&reader, &mut notes)?;
    for name in DISTORTION_NAMES {
        let Some(found) = reader.names.find(name) else { continue };
        let is_none = ["None", "cv::noArray()", "null"].contains(&found.piece.text);
        let is_zero = found.value.is_ok_and(|value| value.numbers.iter().all(|k| *k == 0.0));
        if !(is_none || is_zero) {
            notes.push(format!("{name} is left out: a pinhole draws straight lines straight"));
            break;
        }
    }
    let (orientation, eye, _) =
        stance(rows, t).right_handed(&mut notes).map_err(|right| code.rotation("R", &right))?;
    let viewport = viewport_of(&intrinsics, image, at_hand.viewport.distance);
    Ok(Taken::camera(Camera { eye, orientation, viewport, image }, notes))
}

fn intrinsics(reader: &Reader) -> Result<Intrinsics, FileError> {
    let missing = || reader.code.missing("K", "it must be nine numbers");
    let k = reader.one_of(&K_NAMES, &[9], "it must be 3 × 3 numbers")?.ok_or_else(missing)?;
    let [fx, skew, cx, zero, fy, cy, p, q, r] = k.numbers[..] else { return Err(missing()) };
    // A skew of roundings is none.
    let has_skew = skew.abs() > 4.0 * f64::EPSILON * fx;
    if [zero, p, q] != [0.0; 3] || r != 1.0 || has_skew || !(fx > 0.0 && fy > 0.0) {
        let right = "it must be fx 0 cx, 0 fy cy, 0 0 1 with fx and fy greater than 0";
        let [shown] = [k.numbers.iter().map(|x| n(*x)).collect::<Vec<_>>().join(", ")];
        let right = match k.found.piece.text.contains(|c: char| c.is_alphabetic()) {
            true => format!("it comes to {shown}: {right}"),
            false => right.to_owned(),
        };
        return Err(reader.fault(k.name, &k.found, &right));
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
    for (width_name, height_name, is_sure) in [
        ("image_width", "image_height", true),
        ("imageWidth", "imageHeight", true),
        ("width", "height", true),
        ("w", "h", false),
    ] {
        let given = reader.number(&[width_name]).zip(reader.number(&[height_name]));
        let Some((width, height)) = given else { continue };
        match (image_of(width, height), is_sure) {
            (Ok(image), _) => return Ok(image),
            (Err(right), true) => {
                let Some(found) = reader.names.find(width_name) else { continue };
                return Err(reader.fault(width_name, &found, &right));
            }
            // w and h may be anything.
            (Err(_), false) => (),
        }
    }
    // cx = 320 is meant as half of 640 by those who do not count from centres.
    let doubled = [k.cx, k.cy].map(|c| 2.0 * (c - 0.5));
    let [around_x, around_y] = [k.cx, k.cy].map(|c| (2.0 * c).round());
    if around_x.min(around_y) < SMALLEST {
        return Err(reader.code.missing(
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
        notes.push(size_taken(unsaid, image, ", twice cx and cy, taken"));
        return Ok(image);
    }
    if let Ok(image) = image_of(around_x, around_y) {
        notes.push(size_taken(unsaid, image, ", whose middle is the principal point, taken"));
        return Ok(image);
    }
    notes.push(size_taken(unsaid, at_hand.image, ", the one at hand, taken"));
    Ok(at_hand.image)
}

/// R's rows and t, given apart or as one 3 × 4 or 4 × 4 matrix; R as a matrix or by Rodrigues' vector.
fn pose(reader: &Reader, notes: &mut Vec<String>) -> Result<([DVec3; 3], DVec3), FileError> {
    let whole = reader.one_of(&RT_NAMES, &[12, 16], "it must be [R|t], 3 × 4");
    let right = "it must be 3 × 3 numbers";
    let matrix = reader.one_of(&R_NAMES, &[9], right)?;
    let vector = reader.one_of(&VECTOR_NAMES, &[3], "it must be three numbers")?;
    let translation = reader.one_of(&T_NAMES, &[3], "it must be three numbers")?;
    let is_apart = (matrix.is_some() || vector.is_some()) && translation.is_some();
    if !is_apart && let Some(whole) = whole? {
        let affine = Affine::of_rows(&whole.numbers).ok_or_else(|| {
            reader.fault(whole.name, &whole.found, "its last row must be 0 0 0 1")
        })?;
        return Ok((
            [0, 1, 2].map(|k| DVec3::new(affine.x[k], affine.y[k], affine.z[k])),
            affine.at,
        ));
    }
    let turned = |vector: &Value| -> Option<Vec<f64>> {
        Some(Matrix::vector(vector.numbers.clone()).rodrigues()?.numbers)
    };
    let by_vector = vector.as_ref().and_then(turned);
    if let (Some(matrix), Some(vector), Some(by_vector)) = (&matrix, &vector, &by_vector)
        && !alike(&matrix.numbers, by_vector)
    {
        let right = format!("{} is another rotation: only one of them may be given", matrix.name);
        return Err(reader.fault(vector.name, &vector.found, &right));
    }
    if let (None, Some(vector)) = (&matrix, &vector)
        && let [x, y, z] = vector.numbers[..]
        && DVec3::new(x, y, z).length() > std::f64::consts::TAU
    {
        let note =
            "turns by more than a full turn: its length is taken as radians, as OpenCV has it";
        notes.push(format!("{} {note}", vector.name));
    }
    let rotation = matrix.map(|matrix| matrix.numbers).or(by_vector).ok_or_else(|| {
        reader.code.missing("R", "the rotation must be nine numbers, or rvec three")
    })?;
    let translation = translation
        .ok_or_else(|| reader.code.missing("t", "the translation must be three numbers"))?;
    match (&rotation[..], &translation.numbers[..]) {
        (&[a, b, c, d, e, f, g, h, i], &[x, y, z]) => {
            let rows = [DVec3::new(a, b, c), DVec3::new(d, e, f), DVec3::new(g, h, i)];
            Ok((rows, DVec3::new(x, y, z)))
        }
        _ => Err(reader.code.missing("R", right)),
    }
}
