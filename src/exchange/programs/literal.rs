//! Reads cameras that are given by literal numbers, such as `gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0)`:
//! eye, at and up, a matrix, or OpenCV's K, R and t.
//!
//! Variables are not resolved, and no arithmetic is done except for quotients such as 4.0 / 3.0. A text
//! is either understood completely, so that each statement contributes to the camera, or rejected with
//! the line of the error.

use pinhole_core::glam::DAffine3;
use pinhole_core::{
    Basis, Camera, DVec3, ImageSize, Intrinsics, Orientation, Viewport, fov_of_extent, shortest,
};

use super::derived::{
    affine, image_of, right_handed, settled, shortest_where, size_note, viewport_of_angle,
};
use crate::FileError;
use crate::error::one_line;
use crate::format::{Imported, Input};
use crate::template::n;

/// Variable names of a camera-to-world matrix, for a camera that looks along its own -z with y up.
const MATRICES: [&str; 6] =
    ["matrix_world", "matrixWorld", "camera_to_world", "cameraToWorld", "c2w", "cam2world"];

/// The names of eye, at and up.
const POINTS: [&str; 3] = ["eye", "at", "up"];

/// Variable names of OpenCV's intrinsic matrix K; below, those of its pose R and t, of its lens, and of
/// the image's width and height.
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
const T_NAMES: [&str; 5] = ["t", "tvec", "translation", "translation_vector", "T"];
const RT_NAMES: [&str; 3] = ["Rt", "extrinsics", "extrinsic"];
const DISTORTION_NAMES: [&str; 3] = ["distortion", "dist", "dist_coeffs"];
const SIZE_NAMES: [[&str; 2]; 3] =
    [["image_width", "image_height"], ["imageWidth", "imageHeight"], ["width", "height"]];

/// Functions that only make a list or a vector of their arguments, so that a call of them is literal.
const MAKERS: [&str; 10] = [
    "vec3", "dvec3", "Vec3", "Vector3", "point3", "array", "asarray", "Matrix", "Vector", "SVector",
];

/// Words that may precede the name of a variable in an assignment.
const DECLARATIONS: [&str; 10] =
    ["const", "let", "var", "auto", "static", "export", "mat4", "glm::mat4", "vec3", "glm::vec3"];

/// Preprocessor directives that may exclude lines, so that a text with them cannot be understood
/// without running the preprocessor.
const DIRECTIVES: [&str; 4] = ["#if", "#el", "#end", "#define"];

const RIGHT: &str = "it must be nine numbers (eye, at, up), ten (and the vertical angle in degrees), a \
                     3 × 4 or 4 × 4 matrix from camera to world, one gluLookAt or glm::lookAt, or K, R \
                     and t, and nothing else: a program is not run";

const COUNTS: &str = "it must be 9 (eye, at, up), 10 (and the vertical angle in degrees), or 12 or 16 (a \
                      matrix from camera to world)";

const OF_NUMBERS: &str = "it must be given by numbers, without names or calculations";

/// Returns true if a text looks like a camera that is given by literal numbers.
pub(super) fn detect(text: &str) -> bool {
    let gives = |names: &[&str], signs: &[char], begins: &dyn Fn(&str) -> bool| {
        let is_of_name = |c: char| c.is_alphanumeric() || c == '_' || c == '.' && signs != ['='];
        names.iter().flat_map(|name| text.match_indices(name)).any(|(at, name)| {
            let rest = text[at + name.len()..].trim_start_matches([' ', '"', '\'']);
            let value = rest.strip_prefix(signs).map(|value| value.trim_start_matches(' '));
            !text[..at].ends_with(is_of_name) && value.is_some_and(begins)
        })
    };
    let is_list = |value: &str| value.starts_with(['[', '(', 'n', '\n']);
    let of_numbers =
        |c: char| c.is_ascii_digit() || c.is_whitespace() || "()[],.;+-eE\u{feff}".contains(c);
    let is_point = |value: &str| {
        is_list(value) || value.starts_with(|c: char| of_numbers(c) || c == 'g' || c == 'v')
    };
    gives(&["gluLookAt", "lookAt"], &['('], &|_| true)
        || POINTS.iter().all(|name| gives(&[name], &['=', ':'], &is_point))
        || gives(&K_NAMES, &['=', ':'], &is_list)
        || gives(&MATRICES, &['='], &|_| true)
        || text.chars().all(of_numbers) && text.contains(|c: char| c.is_ascii_digit())
}

/// Reads the camera of a text. The field of view and the image size are those of the camera `at_hand`
/// if the text does not specify them.
pub(super) fn read(input: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    let plain = unquoted(without_comments(input)?);
    let source = Statements { input, statements: statements(input, &plain)? };
    if source.statements.is_empty() {
        return Err(source.missing("a number", RIGHT));
    }
    if source.statements.iter().any(|statement| is_of_intrinsics(statement.target)) {
        return by_intrinsics(&source, at_hand);
    }
    if let Some(call) = source.statements.iter().find(|s| is_look_at(s.called)) {
        let numbers = source.numbers(call)?;
        let points = numbers.try_into();
        let points = points.map_err(|_| source.refused(call, "it must have 9 numbers"))?;
        let mut others = source.statements.iter().filter(|other| other.piece.at != call.piece.at);
        return match others.next() {
            Some(other) => Err(source.refused(other, ONE_LOOK_AT)),
            None => Ok(look_at(points, None, at_hand)),
        };
    }
    if source.statements.iter().any(|statement| POINTS.contains(&statement.target)) {
        return by_names(&source, at_hand);
    }
    by_numbers(&source, at_hand)
}

const ONE_LOOK_AT: &str = "only one gluLookAt or glm::lookAt is read, and nothing else: leave this out (the \
                      field of view may be given as a tenth number, behind eye, at and up)";

fn is_look_at(called: &str) -> bool {
    ["gluLookAt", "lookAt", "glm::lookAt"].contains(&called)
}

fn is_of_intrinsics(name: &str) -> bool {
    let lists: [&[&str]; 6] =
        [&K_NAMES, &R_NAMES, &T_NAMES, &RT_NAMES, &DISTORTION_NAMES, SIZE_NAMES.as_flattened()];
    lists.iter().any(|list| list.contains(&name))
}

/// Reads eye, at and up, each of them with its name.
fn by_names(source: &Statements, at_hand: &Camera) -> Result<Imported, FileError> {
    let mut points = [None; 3];
    for statement in &source.statements {
        let place = POINTS.iter().position(|name| *name == statement.target);
        let place = place.filter(|_| statement.called.is_empty());
        let right = "only eye, at and up may be given, each by three numbers";
        let place = place.ok_or_else(|| source.refused(statement, right))?;
        let point = <[f64; 3]>::try_from(source.numbers(statement)?);
        let point = point.map_err(|_| source.refused(statement, "it must have three numbers"))?;
        if points[place].replace(point).is_some() {
            let right = format!("{} is given twice", POINTS[place]);
            return Err(source.refused(statement, &right));
        }
    }
    let missing = |name| source.missing(name, "it must be three numbers");
    let point = |k: usize| points[k].ok_or_else(|| missing(POINTS[k]));
    let [eye, at, up] = [point(0)?, point(1)?, point(2)?];
    let points = std::array::from_fn(|k| [eye, at, up][k / 3][k % 3]);
    Ok(look_at(points, None, at_hand))
}

/// Reads numbers without names: eye, at and up, or a camera-to-world matrix.
fn by_numbers(source: &Statements, at_hand: &Camera) -> Result<Imported, FileError> {
    let (first, mut numbers) = (&source.statements[0], Vec::new());
    let is_alone = source.statements.len() == 1;
    for statement in &source.statements {
        let is_matrix = MATRICES.contains(&last_segment(statement.target));
        let is_read = statement.target.is_empty() || is_matrix && is_alone;
        if !(statement.called.is_empty() && is_read) {
            return Err(source.refused(statement, RIGHT));
        }
        numbers.extend(source.numbers(statement)?);
    }
    let refused = |right: &str| source.refused(first, right);
    let is_named = !first.target.is_empty();
    // A rotation alone, such as [[1, 0, 0], ...], is not a camera.
    let mut signs = first.piece.text.chars().filter(|c| !c.is_whitespace());
    let is_rotation = [signs.next(), signs.next()].iter().flatten().all(|c| "([{".contains(*c))
        && is_alone
        && first.arguments.len() == 1;
    let look_at = |points, degrees| {
        let Imported { camera, mut notes } = look_at(points, degrees, at_hand);
        notes.insert(0, "taken as eye, at and up, in this order".to_owned());
        Ok(Imported { camera, notes })
    };
    match (numbers.len(), <[f64; 9]>::try_from(numbers.get(..9).unwrap_or_default())) {
        (9, Ok(points)) if !is_named && !is_rotation => look_at(points, None),
        (10, Ok(points)) if !is_named => match numbers[9] {
            degrees if degrees > 0.0 && degrees < 180.0 => look_at(points, Some(degrees)),
            _ => Err(refused(
                "the tenth number is the vertical angle: it must be between 0 and 180 degrees",
            )),
        },
        (count, _) if !is_named && ![9, 10, 12, 16].contains(&count) => {
            let problem = format!("the count of numbers is {count}: {COUNTS}");
            Err(FileError::of_file(source.input.path, problem))
        }
        _ => {
            let by_rows = affine_of_rows(&numbers).map(|affine| (affine, "columns"));
            let found = by_rows.or_else(|| affine(&numbers).map(|affine| (affine, "rows")));
            let (affine, vectors) = found.ok_or_else(|| refused(RIGHT))?;
            by_matrix(&affine, vectors, at_hand).map_err(|right| refused(&right))
        }
    }
}

fn look_at(points: [f64; 9], degrees: Option<f64>, at_hand: &Camera) -> Imported {
    let [eye, at, up] = [0, 3, 6].map(|k| DVec3::from_slice(&points[k..]));
    let Viewport { width, height, distance } = at_hand.viewport;
    let given = degrees.map(|degrees| viewport_of_angle(degrees, width / height, distance));
    let notes = if given.is_none() { vec![unsaid(at_hand)] } else { Vec::new() };
    let viewport = given.unwrap_or(at_hand.viewport);
    let orientation = Orientation::At { at, up };
    Imported { camera: Camera { eye, orientation, viewport, image: at_hand.image }, notes }
}

/// Imports a camera-to-world matrix. `vectors` (`rows` or `columns`) says, for the note, which of them
/// are right, up, backwards and eye.
fn by_matrix(affine: &DAffine3, vectors: &str, at_hand: &Camera) -> Result<Imported, String> {
    let taken = format!(
        "taken as the matrix from camera to world: its {vectors} are right, up, backwards and eye"
    );
    let mut notes = vec![taken, unsaid(at_hand)];
    if Basis::error_of(affine.x_axis, affine.y_axis, affine.z_axis) > 1e-9 {
        notes.push("its scale is left out".to_owned());
    }
    let (orientation, eye) =
        right_handed(affine, &mut notes).map_err(|right| format!("it is no rotation: {right}"))?;
    Ok(Imported { camera: Camera { eye, orientation, ..*at_hand }, notes })
}

/// Returns the note about a field of view that is not specified.
fn unsaid(at_hand: &Camera) -> String {
    let viewport = &at_hand.viewport;
    let degrees = fov_of_extent(viewport.height, viewport.distance).to_degrees();
    format!(
        "the field of view is not given: {} degrees from bottom to top kept",
        n((degrees * 1e4).round() / 1e4)
    )
}

/// Returns the affine map of a 3 x 4 or 4 x 4 matrix in row-major order. Returns `None` if there are
/// neither 12 nor 16 numbers, or if the last row of 4 x 4 is not 0 0 0 1.
fn affine_of_rows(m: &[f64]) -> Option<DAffine3> {
    let whole: [f64; 16] = match m.len() {
        12 => [m, &[0.0, 0.0, 0.0, 1.0]].concat().try_into().ok()?,
        _ => m.try_into().ok()?,
    };
    affine(&std::array::from_fn::<f64, 16, _>(|k| whole[4 * (k % 4) + k / 4]))
}

/// Imports a camera from OpenCV's intrinsic matrix K, rotation R and translation t, which map a point q
/// of the world to the pixel coordinates (x, y):
///
/// ```text
/// s (x, y, 1) = K (R q + t)        x = j, y = i at the centre of pixel (row i, column j)
/// R = (u, -v, -w) as rows          t = -R eye
/// ```
fn by_intrinsics(source: &Statements, at_hand: &Camera) -> Result<Imported, FileError> {
    for statement in &source.statements {
        let is_value = statement.called.is_empty() && statement.arguments.len() == 1;
        if !(is_value && is_of_intrinsics(statement.target)) {
            let right =
                "only K, R and t, and the image's width and height may be given, each by numbers";
            return Err(source.refused(statement, right));
        }
    }
    let straight = "it must be 0: a pinhole camera has no lens that distorts";
    if let Some((field, numbers)) = source.given(&DISTORTION_NAMES, &[4, 5, 8, 12, 14], straight)?
        && numbers.iter().any(|number| *number != 0.0)
    {
        return Err(source.value_fault(field, straight));
    }
    let mut notes = Vec::new();
    let k = intrinsics(source)?;
    let image = size(source, &k, at_hand, &mut notes)?;
    let [right, down] = k.off_centre(image);
    if right.abs().max(down.abs()) > 1e-9 * f64::from(image.width().max(image.height())) {
        notes.push(format!(
            "the principal point is {} pixels right of the image's middle and {} below it: taken as \
             the middle, which every camera here has there",
            shortest((right * 1e6).round() / 1e6),
            shortest((down * 1e6).round() / 1e6)
        ));
    }
    let [x, y, z, t] = pose(source, &mut notes)?;
    // eye = -R^T t: this removes the rounding errors of nine products and six sums.
    let eye = DVec3::ZERO - (t.x * x + t.y * y + t.z * z);
    let roundings = 4.0 * f64::EPSILON * t.length();
    let eye = DVec3::from_array(eye.to_array().map(|x| settled(x, roundings)));
    let frame = DAffine3::from_cols(x, -y, -z, eye);
    let (orientation, eye) = right_handed(&frame, &mut notes).map_err(|right| {
        FileError::of_file(source.input.path, format!("R is no rotation: {right}"))
    })?;
    let viewport = viewport_of(&k, image, at_hand.viewport.distance);
    Ok(Imported { camera: Camera { eye, orientation, viewport, image }, notes })
}

fn intrinsics(source: &Statements) -> Result<Intrinsics, FileError> {
    let (field, k) = source
        .given(&K_NAMES, &[9], "it must be 3 × 3 numbers")?
        .ok_or_else(|| source.missing("K", "it must be nine numbers"))?;
    // A skew within rounding errors counts as none.
    let has_skew = k[1].abs() > 4.0 * f64::EPSILON * k[0];
    let is_diagonal = [k[3], k[6], k[7], k[8]] == [0.0, 0.0, 0.0, 1.0] && !has_skew;
    if !(is_diagonal && k[0] > 0.0 && k[4] > 0.0) {
        let right = "it must be fx 0 cx, 0 fy cy, 0 0 1 with fx and fy greater than 0";
        return Err(source.value_fault(field, right));
    }
    Ok(Intrinsics { fx: k[0], fy: k[4], cx: k[2] + 0.5, cy: k[5] + 0.5 })
}

/// Returns the viewport that has these focal lengths, with width and height rounded to as few digits as
/// possible.
fn viewport_of(k: &Intrinsics, image: ImageSize, distance: f64) -> Viewport {
    let near = k.viewport(image, distance);
    let of = |viewport: Viewport| Intrinsics::from_viewport(&viewport, image);
    let width = shortest_where(near.width, |width| of(Viewport { width, ..near }).fx == k.fx);
    let height = shortest_where(near.height, |height| of(Viewport { height, ..near }).fy == k.fy);
    Viewport { width, height, distance }
}

/// Minimum width and height of an image size that is guessed from the principal point.
const SMALLEST: f64 = 4.0;

fn size(
    source: &Statements,
    k: &Intrinsics,
    at_hand: &Camera,
    notes: &mut Vec<String>,
) -> Result<ImageSize, FileError> {
    for [width, height] in SIZE_NAMES {
        let number = |name| source.given(&[name], &[1], "it must be one number");
        let (Some((field, width)), Some((_, height))) = (number(width)?, number(height)?) else {
            continue;
        };
        return image_of(width[0], height[0]).map_err(|right| source.value_fault(field, &right));
    }
    // If pixels are counted from their corners, cx = 320 is exactly half of 640.
    let doubled = [k.cx, k.cy].map(|c| 2.0 * (c - 0.5));
    let [around_x, around_y] = [k.cx, k.cy].map(|c| (2.0 * c).round());
    if around_x.min(around_y) < SMALLEST {
        let right = format!(
            "K's principal point is ({}, {}), which no image has in its middle: width and height must be \
             given",
            n(k.cx - 0.5),
            n(k.cy - 0.5)
        );
        return Err(source.missing("width", &right));
    }
    let is_even = doubled.iter().all(|size| size % 2.0 == 0.0);
    let by_double = is_even.then(|| image_of(doubled[0], doubled[1]).ok()).flatten();
    let (image, taken) = match (by_double, image_of(around_x, around_y)) {
        (Some(image), _) => (image, ", twice cx and cy, taken"),
        (None, Ok(image)) => (image, ", whose middle is the principal point, taken"),
        (None, Err(_)) => (at_hand.image, ", the one at hand, taken"),
    };
    notes.push(size_note("the image's size is not given", image, taken));
    Ok(image)
}

/// Returns the three rows of OpenCV's R, followed by t, which are given separately or as one 3 × 4 or 4
/// × 4 matrix. If neither is given, returns the identity: the camera's coordinates are the world's.
fn pose(source: &Statements, notes: &mut Vec<String>) -> Result<[DVec3; 4], FileError> {
    let whole = source.given(&RT_NAMES, &[12, 16], "it must be [R|t], 3 × 4")?;
    let matrix = source.given(&R_NAMES, &[9], "it must be 3 × 3 numbers")?;
    let translation = source.given(&T_NAMES, &[3], "it must be three numbers")?;
    if let Some((field, numbers)) = whole {
        if let Some((other, _)) = matrix.or(translation) {
            return Err(source.given_too(other, field));
        }
        let right = "its last row must be 0 0 0 1";
        let affine = affine_of_rows(numbers).ok_or_else(|| source.value_fault(field, right))?;
        let rows = affine.matrix3.transpose();
        return Ok([rows.x_axis, rows.y_axis, rows.z_axis, affine.translation]);
    }
    match (matrix, translation) {
        (Some((_, m)), Some((_, t))) => {
            let [x, y, z] = [0, 3, 6].map(|k| DVec3::from_slice(&m[k..]));
            Ok([x, y, z, DVec3::from_slice(t)])
        }
        (Some(_), None) => Err(source.missing("t", "the translation must be three numbers")),
        (None, Some(_)) => Err(source.missing("R", "the rotation must be nine numbers")),
        (None, None) => {
            let said = "R and t are not given: the eye is taken at the origin, looking along +z with y down, \
                        as OpenCV's camera does";
            notes.push(said.to_owned());
            Ok([DVec3::X, DVec3::Y, DVec3::Z, DVec3::ZERO])
        }
    }
}

/// The statements of a text, and its path for errors.
struct Statements<'s> {
    input: &'s Input<'s>,
    statements: Vec<Statement<'s>>,
}

/// A statement: a call, an assignment, or numbers alone.
struct Statement<'s> {
    piece: Piece<'s>,
    /// The name that is assigned to, such as `view` in `glm::mat4 view = ...`; empty if there is none.
    target: &'s str,
    /// The name of the called function; empty if nothing is called.
    called: &'s str,
    /// The arguments of the call; without a call, the values.
    arguments: Vec<Argument<'s>>,
}

/// An argument of a call, or a value.
struct Argument<'s> {
    piece: Piece<'s>,
    /// The numbers in the argument as a flat list, whatever its brackets; `None` if it contains
    /// anything but literal numbers.
    numbers: Option<Vec<f64>>,
}

impl Statements<'_> {
    /// Creates the error `statement: right`, located at the statement.
    fn refused(&self, statement: &Statement, right: &str) -> FileError {
        refused(self.input, statement.piece, right)
    }

    /// Creates the error `field is value: right`, located at the value.
    fn fault(&self, field: &str, argument: &Argument, right: &str) -> FileError {
        let value = one_line(argument.piece.text);
        self.input.error_at(argument.piece.at, format!("{field} is {value}: {right}"))
    }

    /// Creates the error of [`Self::fault`] for a statement that assigns one value to a name.
    fn value_fault(&self, statement: &Statement, right: &str) -> FileError {
        self.fault(statement.target, &statement.arguments[0], right)
    }

    fn missing(&self, field: &str, right: &str) -> FileError {
        FileError::of_file(self.input.path, format!("{field} is missing: {right}"))
    }

    fn given_too(&self, statement: &Statement, first: &Statement) -> FileError {
        let right = format!("{} is given too: only one of them may be", first.target);
        self.value_fault(statement, &right)
    }

    /// Returns the numbers of all arguments as one list.
    fn numbers(&self, statement: &Statement) -> Result<Vec<f64>, FileError> {
        let field = if statement.called.is_empty() { "this" } else { statement.called };
        let mut all = Vec::new();
        for argument in &statement.arguments {
            let numbers = argument.numbers.as_ref();
            all.extend(numbers.ok_or_else(|| self.fault(field, argument, OF_NUMBERS))?);
        }
        Ok(all)
    }

    /// Returns the statement that assigns to one of `names`, and its numbers; `None` if there is none.
    /// Returns an error if there are several, or if it has a count of numbers that is not in `counts`.
    fn given(
        &self,
        names: &[&str],
        counts: &[usize],
        right: &str,
    ) -> Result<Option<(&Statement<'_>, &[f64])>, FileError> {
        let mut taken: Option<(&Statement, &[f64])> = None;
        for statement in self.statements.iter().filter(|s| names.contains(&s.target)) {
            let value = &statement.arguments[0];
            let numbers = value.numbers.as_deref().filter(|numbers| {
                // In C, the quotient of two integers is rounded towards 0.
                counts.contains(&numbers.len()) && !value.piece.text.contains('/')
            });
            let numbers = numbers.ok_or_else(|| self.value_fault(statement, right))?;
            if let Some((first, _)) = taken {
                return Err(self.given_too(statement, first));
            }
            taken = Some((statement, numbers));
        }
        Ok(taken)
    }
}

/// Creates the error `statement: right` about a statement, which is quoted on one line and without a
/// colon at its end.
fn refused(input: &Input, piece: Piece, right: &str) -> FileError {
    let statement = one_line(piece.text);
    input.error_at(piece.at, format!("{}: {right}", statement.trim_end_matches(':')))
}

/// A part of the imported text, and the index of its first byte in the text.
#[derive(Clone, Copy)]
struct Piece<'s> {
    text: &'s str,
    at: usize,
}

impl<'s> Piece<'s> {
    /// Returns the part from byte `from` to byte `end`, without surrounding whitespace.
    fn part(self, from: usize, end: usize) -> Piece<'s> {
        let text = self.text[from..end].trim_start();
        Piece { text: text.trim_end(), at: self.at + end - text.len() }
    }

    /// Splits the text at commas outside of brackets. A trailing comma is allowed.
    fn split(self) -> Vec<Piece<'s>> {
        let (mut depth, mut from, mut parts) = (0_i32, 0, Vec::new());
        for (at, c) in self.text.char_indices().chain([(self.text.len(), ',')]) {
            match c {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => depth -= 1,
                ',' if depth == 0 => {
                    parts.push(self.part(from, at));
                    from = at + 1;
                }
                _ => (),
            }
        }
        parts.pop_if(|last| last.text.is_empty());
        parts
    }
}

/// Returns the text with each byte of a comment replaced by a space, so that positions do not change.
fn without_comments(input: &Input) -> Result<String, FileError> {
    let text = input.text;
    let mut plain = String::with_capacity(text.len());
    while let Some(c) = text[plain.len()..].chars().next() {
        let rest = &text[plain.len()..];
        let is_directive = DIRECTIVES.iter().any(|directive| rest.starts_with(directive));
        let blank = if rest.starts_with("//") || c == '#' && !is_directive {
            rest.find('\n').unwrap_or(rest.len())
        } else if let Some(inside) = rest.strip_prefix("/*") {
            inside.find("*/").map_or(rest.len(), |end| end + 4)
        } else if c == '\u{feff}' {
            c.len_utf8()
        } else {
            plain.push(c);
            continue;
        };
        let before = plain.trim_end_matches([' ', '\t']);
        if rest.starts_with("//") && before.ends_with(|c: char| c.is_ascii_digit() || c == '.') {
            let right = "a number must not stand before //, which may divide it, as in Python";
            return Err(fault_at(input, text, plain.len(), right));
        }
        plain.extend(std::iter::repeat_n(' ', blank));
    }
    Ok(plain)
}

/// Returns the text of a JSON object or of Python's `dict` as assignments: its outer braces and its quotes
/// become spaces, so that positions do not change. Returns any other text unchanged.
fn unquoted(plain: String) -> String {
    let inside = plain.trim().strip_prefix('{').and_then(|rest| rest.strip_suffix('}'));
    if !inside.is_some_and(|inside| inside.trim_start().starts_with(['"', '\''])) {
        return plain;
    }
    let braces = [plain.find('{'), plain.rfind('}')];
    let is_blank = |at, c| braces.contains(&Some(at)) || c == '"' || c == '\'';
    plain.char_indices().map(|(at, c)| if is_blank(at, c) { ' ' } else { c }).collect()
}

/// Returns true if a text begins with `name =` or `name :`.
fn assigns(text: &str) -> bool {
    let text = text.trim_start();
    let rest = text.trim_start_matches(|c: char| is_of_name(c) || c.is_numeric()).trim_start();
    text.starts_with(is_of_name) && rest.starts_with(['=', ':']) && !rest.starts_with("::")
}

/// Creates an error that is located at byte `at` of the text, and quotes the rest of the statement from
/// there, followed by `right`.
fn fault_at(input: &Input, text: &str, at: usize, right: &str) -> FileError {
    let rest = text[at..].split([';', '\n']).next().unwrap_or_default();
    refused(input, Piece { text: rest, at }, right)
}

/// Splits a text into its statements. `plain` is the text without comments.
fn statements<'s>(input: &Input, plain: &'s str) -> Result<Vec<Statement<'s>>, FileError> {
    let (mut open, mut pieces): (Vec<(usize, char)>, Vec<Piece>) = Default::default();
    let (mut from, mut last, whole) = (0, ' ', Piece { text: plain, at: 0 });
    for (at, c) in plain.char_indices() {
        match c {
            '(' => open.push((at, ')')),
            '[' => open.push((at, ']')),
            '{' => open.push((at, '}')),
            ')' | ']' | '}' if open.pop_if(|(_, close)| *close == c).is_none() => {
                return Err(fault_at(input, plain, at, "no bracket is open that it closes"));
            }
            // A statement continues inside brackets, after a line that is incomplete, and after a comma
            // that no assignment follows.
            ';' | '\n' | ','
                if open.is_empty()
                    && (c != '\n' || !"=,:".contains(last))
                    && (c != ',' || assigns(&plain[at + 1..])) =>
            {
                pieces.push(whole.part(from, at));
                from = at + 1;
            }
            _ => (),
        }
        if !c.is_whitespace() {
            last = c;
        }
    }
    if let Some((at, _)) = open.first() {
        return Err(fault_at(input, plain, *at, "this bracket is not closed"));
    }
    pieces.push(whole.part(from, plain.len()));
    let is_import = |word: &str| ["import", "from"].contains(&word);
    pieces
        .into_iter()
        .filter(|piece| piece.text.split_whitespace().next().is_some_and(|word| !is_import(word)))
        .map(|piece| statement(piece).ok_or_else(|| fault_at(input, plain, piece.at, RIGHT)))
        .collect()
}

/// Parses `name(...)`, `name = ...`, or numbers. Returns `None` for anything else.
fn statement(piece: Piece) -> Option<Statement> {
    let (mut target, mut value) = ("", piece);
    // Find the first = or : outside of brackets that is not part of `::`.
    let head = piece.text.split(['(', '[', '{']).next()?.replace("::", "..");
    if let Some(at) = head.find(['=', ':']) {
        let mut words: Vec<&str> = piece.text[..at].split_whitespace().collect();
        target = words.pop().filter(|name| is_name(name))?;
        if !words.iter().all(|word| DECLARATIONS.contains(word)) {
            return None;
        }
        value = piece.part(at + 1, piece.text.len());
    }
    let (called, arguments) = match call_of(value) {
        Some((name, inside)) if !MAKERS.contains(&last_segment(name)) => (name, inside.split()),
        _ if !target.is_empty() => ("", vec![value]),
        _ if value.text.starts_with(is_of_name) && literal(value.text).is_none() => return None,
        _ => ("", value.split()),
    };
    let arguments = arguments.into_iter().map(argument).collect();
    Some(Statement { piece, target, called, arguments })
}

/// Returns the name of a called function and its arguments, if the whole piece is one call; otherwise
/// `None`.
fn call_of(piece: Piece<'_>) -> Option<(&str, Piece<'_>)> {
    let open = piece.text.find('(')?;
    let name = piece.text[..open].trim_end();
    let mut depth = 0_usize;
    let close = piece.text.char_indices().find(|(_, c)| {
        depth += usize::from("([{".contains(*c));
        depth -= usize::from(")]}".contains(*c)).min(depth);
        ")]}".contains(*c) && depth == 0
    });
    let is_call = is_name(name) && close.is_some_and(|(at, _)| at + 1 == piece.text.len());
    is_call.then(|| (name, piece.part(open + 1, piece.text.len() - 1)))
}

fn argument(piece: Piece) -> Argument {
    let mut numbers = literal(piece.text);
    // In GLM, a vector that is made from one number has it in all components.
    let maker = call_of(piece).map(|(name, _)| last_segment(name));
    if let (Some([one]), Some("vec3" | "dvec3")) = (numbers.as_deref(), maker) {
        numbers = Some(vec![*one; 3]);
    }
    Argument { piece, numbers }
}

/// Returns the numbers in a text, if it is literal: apart from numbers, it contains only brackets,
/// [`MAKERS`] before brackets, slashes in quotients of two numbers, commas and spaces. Returns `None`
/// for any other text.
fn literal(text: &str) -> Option<Vec<f64>> {
    let mut spaced = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '(' | '[' | '{' => spaced.push_str(" ( "),
            ')' | ']' | '}' => spaced.push_str(" ) "),
            ',' | '/' => spaced.extend([' ', c, ' ']),
            c => spaced.push(c),
        }
    }
    let (mut numbers, mut commas, mut is_behind_value) = (Vec::new(), 0, false);
    let mut cells = spaced.split_whitespace().peekable();
    while let Some(cell) = cells.next() {
        match cell {
            "(" => (),
            ")" => is_behind_value = true,
            // Two adjacent commas mean that a number is missing.
            "," if !is_behind_value => return None,
            "," => (commas, is_behind_value) = (commas + 1, false),
            name if cells.peek() == Some(&"(") && MAKERS.contains(&last_segment(name)) => (),
            cell => {
                let mut value = number(cell)?;
                if cells.next_if_eq(&"/").is_some() {
                    value /= number(cells.next()?)?;
                }
                numbers.push(Some(value).filter(|value| value.is_finite())?);
                is_behind_value = true;
            }
        }
    }
    // Either all numbers are separated by commas, with an optional trailing one, or all by blanks.
    let count = numbers.len();
    (count > 0 && (commas == 0 || commas == count || commas + 1 == count)).then_some(numbers)
}

/// Parses a number in the notation of C, Python and similar languages: `-1`, `.5`, `2.`, `1e-3`,
/// `4.0f`.
fn number(cell: &str) -> Option<f64> {
    let is_float = cell.ends_with(['f', 'F']) && cell.contains(['.', 'e', 'E']);
    let digits = if is_float { &cell[..cell.len() - 1] } else { cell };
    digits.parse().ok().filter(|number: &f64| number.is_finite())
}

fn is_of_name(c: char) -> bool {
    c.is_alphabetic() || c == '_' || c == '$'
}

fn is_name(name: &str) -> bool {
    let is_inside = |c: char| is_of_name(c) || c.is_numeric() || c == '.' || c == ':';
    name.starts_with(is_of_name) && name.chars().all(is_inside)
}

/// Returns the last part of a qualified name, such as `vec3` of `glm::vec3`.
fn last_segment(name: &str) -> &str {
    name.rsplit(['.', ':']).next().unwrap_or_default()
}
