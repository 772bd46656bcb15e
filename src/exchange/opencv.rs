//! OpenCV's K and [R|t], as JSON. Read as well: the same names given values in Python, or in a YAML
//! file of `cv::FileStorage`.
//!
//! ```text
//! s (x, y, 1) = K (R q + t)        x = j, y = i at the centre of pixel (row i, column j)
//! R = (u, -v, -w) as rows          t = -R eye
//! ```

use pinhole_core::{Camera, DVec3, Intrinsics, Viewport};

use super::back::{MIRRORED, Mirrored, Stance, image_of, settled, shortest_where};
use super::code::{Code, Comments, Piece};
use super::sheet::{Sheet, flipped, flipped_all, n};
use super::terms::{Axis, Pixels, Terms};
use super::{Format, Subject, Taken, Text, Unsayable, Written};
use crate::formats::FileError;

pub(super) const FORMAT: Format = Format {
    name: "opencv",
    label: "OpenCV K [R|t]",
    short: "OpenCV",
    ending: "json",
    terms: Terms {
        axes: [Axis::U, Axis::MinusV, Axis::MinusW],
        given_by: "R from world to camera, t = −R eye",
        pixels: Pixels::AtCentre,
        view: "fx, fy: distance / pixel's width and height, in pixels",
        field: |subject| {
            let Intrinsics { fx, fy, .. } = subject.intrinsics();
            format!("{}, {}", n(fx), n(fy))
        },
        distance: "none: K knows pixels only",
        shape: "any: fx and fy differ",
        lengths: "f64",
    },
    write,
    read,
    claims: |text| {
        let code = blanked(text);
        let given = |names: &[&str]| names.iter().any(|name| value(&code, name).is_some());
        let is_k = |(name, piece)| numbers(&code, name, piece).is_ok_and(|k| k.len() == 9);
        given(&K_NAMES)
            && (given(&R_NAMES)
                || given(&["Rt", "extrinsics"])
                || find(&code, &K_NAMES).is_some_and(is_k))
    },
};

const K_NAMES: [&str; 5] =
    ["K", "camera_matrix", "cameraMatrix", "camera_intrinsics", "intrinsics"];
const R_NAMES: [&str; 3] = ["R", "rotation", "rvec"];
const T_NAMES: [&str; 4] = ["t", "tvec", "translation", "T"];

fn write(subject: &Subject) -> Result<Written, Unsayable> {
    let [width, height] = subject.size();
    let Intrinsics { fx, fy, cx, cy } = subject.intrinsics();
    let basis = *subject.posed().basis();
    let t = translation(subject);
    let text = format!(
        "{{\n  \"image_width\": {width},\n  \"image_height\": {height},\n  \
         \"K\": [[{}, 0, {}],\n        [0, {}, {}],\n        [0, 0, 1]],\n  \
         \"R\": [[{}],\n        [{}],\n        [{}]],\n  \
         \"t\": [{}, {}, {}],\n  \"distortion\": [0, 0, 0, 0, 0]\n}}\n",
        n(fx),
        n(cx - 0.5),
        n(fy),
        n(cy - 0.5),
        basis.u.to_array().map(n).join(", "),
        flipped_all(-basis.v, ", "),
        flipped_all(-basis.w, ", "),
        n(t.x),
        flipped(n(t.y)),
        flipped(n(t.z)),
    );
    let objects = subject.spheres().len() + subject.planes().len();
    let left = "objects are left out: K and [R|t] are a camera only";
    let notes = (objects > 0).then(|| left.to_owned()).into_iter().collect();
    Ok(Written::of("camera.json", Sheet::of(&text), notes))
}

/// t = -R eye.
pub(super) fn translation(subject: &Subject) -> DVec3 {
    let eye = subject.posed().basis().to_camera_from_world(subject.posed().eye());
    DVec3::new(-eye.x, eye.y, eye.z)
}

fn blanked(text: &str) -> Code<'_> {
    let path = std::path::Path::new("");
    // YAML's tags, such as !!opencv-matrix, stand between a name and its numbers.
    Code::new(&Text { path, text }, Comments::Hash)
}

/// The list that a name is given: `K = [...]`, `"K": [...]`, `K: !!opencv-matrix ... data: [...]`.
fn value<'t>(code: &'t Code, name: &str) -> Option<Piece<'t>> {
    let whole = code.whole();
    super::code::words(whole, name).into_iter().rev().find_map(|at| {
        let rest = whole.from(at + name.len());
        let rest = match rest.text.strip_prefix('"') {
            Some(_) => rest.from(1),
            None => rest,
        };
        let rest = super::code::after_spaces(rest);
        rest.text.starts_with(['=', ':']).then_some(())?;
        let made = super::code::after_spaces(rest.from(1));
        if let Some((_, length)) = made_by_numpy(made.text) {
            return Some(Piece { text: &made.text[..length], ..made });
        }
        let (open, _) = rest.text.char_indices().take(100).find(|(_, c)| *c == '[')?;
        let before = &rest.text[1..open];
        let is_plain = before.chars().all(|c| c.is_alphanumeric() || " \n\t._(!-:".contains(c));
        let short = before.len() < 80 && (before.contains("data") || !before.contains('\n'));
        (is_plain && short).then(|| code.bracketed(rest.from(open))).flatten()
    })
}

/// `np.eye(3)`, `np.zeros(3)`, `np.zeros((3, 1))`: the numbers, and how long the call is.
fn made_by_numpy(text: &str) -> Option<(Vec<f64>, usize)> {
    let (name, rest) = text.split_at(text.char_indices().take(20).find(|(_, c)| *c == '(')?.0);
    let name = name.trim_start_matches("numpy.").trim_start_matches("np.");
    let end = rest.char_indices().take(60).find(|(at, c)| {
        let depth = |c: char| rest[..=*at].matches(c).count();
        *c == ')' && depth('(') == depth(')')
    });
    let end = end?.0;
    let sizes = rest[1..end].split(',').map(|size| size.trim().trim_matches(['(', ')']).trim());
    let sizes: Vec<usize> = sizes.map_while(|size| size.parse().ok()).collect();
    let numbers = match (name, &sizes[..]) {
        ("eye" | "identity", [3] | [3, 3]) => vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
        ("zeros", [n]) | ("zeros", [n, 1] | [1, n]) if (1..=20).contains(n) => vec![0.0; *n],
        _ => return None,
    };
    Some((numbers, text.len() - rest.len() + end + 1))
}

fn numbers(code: &Code, name: &str, piece: Piece) -> Result<Vec<f64>, FileError> {
    match made_by_numpy(piece.text) {
        Some((numbers, _)) => Ok(numbers),
        None => code.numbers(name, piece),
    }
}

/// The list that one of the names is given, and which.
fn find<'t>(code: &'t Code, names: &[&'static str]) -> Option<(&'static str, Piece<'t>)> {
    names.iter().find_map(|name| value(code, name).map(|piece| (*name, piece)))
}

fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let code = Code::new(text, Comments::Hash);
    let mut notes = Vec::new();
    let missing = |name: &str, right: &str| code.missing(name, right);
    let (k_name, k) =
        find(&code, &K_NAMES).ok_or_else(|| missing("K", "it must be nine numbers"))?;
    let [fx, skew, cx, zero, fy, cy, p, q, r] = numbers(&code, k_name, k)?[..] else {
        return Err(code.fault(k_name, k, "it must be 3 × 3 numbers"));
    };
    if [zero, p, q] != [0.0; 3] || r != 1.0 || skew != 0.0 || fx <= 0.0 || fy <= 0.0 {
        let right = "it must be fx 0 cx, 0 fy cy, 0 0 1 with fx and fy greater than 0";
        return Err(code.fault(k_name, k, right));
    }
    let intrinsics = Intrinsics { fx, fy, cx: cx + 0.5, cy: cy + 0.5 };
    let image = size(&code, &intrinsics, at_hand, &mut notes)?;
    off_centre(&intrinsics, image, &mut notes);
    let (rotation, t) = pose(&code)?;
    if let Some((name, piece)) =
        find(&code, &["distortion", "dist", "distortion_coefficients", "dist_coeffs"])
        && numbers(&code, name, piece)?.iter().any(|k| *k != 0.0)
    {
        notes.push(format!("{name} is left out: a pinhole draws straight lines straight"));
    }
    let stance = stance(rotation, t);
    let (orientation, eye) =
        turned(stance, &mut notes).map_err(|right| code.rotation("R", &right))?;
    let viewport = viewport_of(&intrinsics, image, at_hand.viewport.distance);
    Ok(Taken::camera(Camera { eye, orientation, viewport, image }, notes))
}

/// The viewport with as few digits as give these focal lengths.
pub(super) fn viewport_of(
    k: &Intrinsics,
    image: pinhole_core::ImageSize,
    distance: f64,
) -> Viewport {
    let near = k.viewport(image, distance);
    let of = |viewport: Viewport| Intrinsics::of(&viewport, image);
    let width = shortest_where(near.width, |width| of(Viewport { width, ..near }).fx == k.fx);
    let height = shortest_where(near.height, |height| of(Viewport { height, ..near }).fy == k.fy);
    Viewport { width, height, distance }
}

/// What is said of a principal point that is not in the middle.
pub(super) fn off_centre(k: &Intrinsics, image: pinhole_core::ImageSize, notes: &mut Vec<String>) {
    let [right, down] = k.off_centre(image);
    if right.abs().max(down.abs()) > 1e-9 * f64::from(image.width().max(image.height())) {
        notes.push(format!(
            "the principal point is {} pixels right of the image's middle and {} below it: taken as \
             the middle, which every camera here has there",
            n((right * 1e6).round() / 1e6),
            n((down * 1e6).round() / 1e6)
        ));
    }
}

/// From R's rows and t, in OpenCV's axes.
pub(super) fn stance([x, y, z]: [DVec3; 3], t: DVec3) -> Stance {
    // eye = -R^T t
    let eye = DVec3::ZERO - (t.x * x + t.y * y + t.z * z);
    // Nine products and six sums; the digits that they add are not the camera's.
    let roundings = 4.0 * f64::EPSILON * t.length();
    let eye = DVec3::from_array(eye.to_array().map(|x| settled(x, roundings)));
    Stance { eye, right: x, up: -y, backwards: -z }
}

/// The orientation and the eye; a mirrored world is turned over.
pub(super) fn turned(
    stance: Stance,
    notes: &mut Vec<String>,
) -> Result<(pinhole_core::Orientation, DVec3), String> {
    let Stance { right, up, backwards, .. } = stance;
    let mirrored = pinhole_core::Basis::is_left_handed(right, up, backwards);
    let stance = if mirrored { stance.mirrored() } else { stance };
    let orientation = stance.orientation(notes)?;
    if mirrored {
        notes.push(MIRRORED.to_owned());
    }
    Ok((orientation, stance.eye))
}

fn size(
    code: &Code,
    k: &Intrinsics,
    at_hand: &Camera,
    notes: &mut Vec<String>,
) -> Result<pinhole_core::ImageSize, FileError> {
    let named = |names: &[&str]| -> Result<Option<(f64, Piece<'_>)>, FileError> {
        let found = names.iter().find_map(|name| {
            let quoted = format!("\"{name}\"");
            let piece = code.value(name).or_else(|| after_quoted(code, &quoted))?;
            Some((name, piece))
        });
        found.map(|(name, piece)| Ok((code.number(name, piece)?, piece))).transpose()
    };
    let width = named(&["image_width", "width", "w"])?;
    let height = named(&["image_height", "height", "h"])?;
    if let (Some((w, piece)), Some((h, _))) = (width, height) {
        return image_of(w, h).map_err(|right| code.fault("image_width", piece, &right));
    }
    // cx = 320 is meant as half of 640 by those who do not count from centres.
    let [doubled_x, doubled_y] = [k.cx, k.cy].map(|c| 2.0 * (c - 0.5));
    if doubled_x % 2.0 == 0.0
        && doubled_y % 2.0 == 0.0
        && let Ok(image) = image_of(doubled_x, doubled_y)
    {
        let (w, h) = (image.width(), image.height());
        notes.push(format!("the image's size is not given: {w} × {h}, twice cx and cy, taken"));
        return Ok(image);
    }
    if let Ok(image) = image_of((2.0 * k.cx).round(), (2.0 * k.cy).round()) {
        let (w, h) = (image.width(), image.height());
        notes.push(format!(
            "the image's size is not given: {w} × {h}, whose middle is the principal point, taken"
        ));
        return Ok(image);
    }
    let image = at_hand.image;
    let (w, h) = (image.width(), image.height());
    notes.push(format!("the image's size is not given: {w} × {h}, the one at hand, taken"));
    Ok(image)
}

/// The number after `"name":`, up to the next comma.
fn after_quoted<'t>(code: &'t Code, quoted: &str) -> Option<Piece<'t>> {
    let whole = code.whole();
    let at = whole.text.find(quoted)? + quoted.len();
    let rest = super::code::after_spaces(whole.from(at));
    rest.text.strip_prefix(':')?;
    let rest = super::code::after_spaces(rest.from(1));
    let end = rest.text.find([',', '}', '\n']).unwrap_or(rest.text.len());
    Some(super::code::trimmed(Piece { text: &rest.text[..end], ..rest }))
}

/// R's rows and t, given apart or as one 3 × 4 or 4 × 4 matrix; R as a matrix or by Rodrigues'
/// vector.
fn pose(code: &Code) -> Result<([DVec3; 3], DVec3), FileError> {
    if let Some((name, piece)) = find(code, &["Rt", "extrinsics", "extrinsic"]) {
        let m = code.numbers(name, piece)?;
        let affine = super::affine::Affine::of_rows(&m);
        let affine = affine.ok_or_else(|| code.fault(name, piece, "it must be [R|t], 3 × 4"))?;
        let rows: [DVec3; 3] =
            std::array::from_fn(|k| DVec3::new(affine.x[k], affine.y[k], affine.z[k]));
        return Ok((rows, affine.at));
    }
    let (name, piece) = find(code, &R_NAMES)
        .ok_or_else(|| code.missing("R", "the rotation must be nine numbers"))?;
    let m = numbers(code, name, piece)?;
    let rows = match m[..] {
        [a, b, c, d, e, f, g, h, i] => {
            [DVec3::new(a, b, c), DVec3::new(d, e, f), DVec3::new(g, h, i)]
        }
        [x, y, z] => rodrigues(DVec3::new(x, y, z)),
        _ => return Err(code.fault(name, piece, "it must be 3 × 3 numbers")),
    };
    let (name, piece) = find(code, &T_NAMES)
        .ok_or_else(|| code.missing("t", "the translation must be three numbers"))?;
    match numbers(code, name, piece)?[..] {
        [x, y, z] => Ok((rows, DVec3::new(x, y, z))),
        _ => Err(code.fault(name, piece, "it must be three numbers")),
    }
}

/// Rows of the rotation about a vector by its length in radians.
fn rodrigues(vector: DVec3) -> [DVec3; 3] {
    let turn = super::affine::Affine::rotation(vector.length().to_degrees(), vector);
    let turn = turn.unwrap_or(super::affine::Affine::IDENTITY);
    std::array::from_fn(|k| DVec3::new(turn.x[k], turn.y[k], turn.z[k]))
}
