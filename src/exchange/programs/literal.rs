//! Reads cameras that are given by literal numbers, such as `gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0)`:
//! eye, at and up, a matrix, or OpenCV's K, R and t.
//!
//! Variables are not resolved, and no arithmetic is done except for quotients such as 4.0 / 3.0. A text
//! is either understood completely, so that each statement contributes to the camera, or rejected with
//! the line of the error.

use pinhole_core::arithmetic::length;
use pinhole_core::glam::DAffine3;
use pinhole_core::{
    Basis, Camera, DVec3, ImageSize, Intrinsics, Orientation, Viewport, fov_of_extent,
};

use super::derived::{
    affine, image_of, right_handed, rounded, settled, shortest_where, size_note, viewport_of_angle,
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
    let tokens = tokens(text);
    let solid: Vec<&str> = tokens.iter().map(|token| token.text).filter(|t| *t != "\n").collect();
    let behind = |is_name: &dyn Fn(&str) -> bool, signs: &[&str]| {
        let mut found = solid.windows(3).filter(|three| is_name(three[0]));
        found.find(|three| signs.contains(&three[1])).map(|three| three[2])
    };
    let of_numbers =
        |c: char| c.is_ascii_digit() || c.is_whitespace() || "()[],.;+-eE\u{feff}".contains(c);
    behind(&is_look_at, &["("]).is_some()
        || POINTS.iter().all(|point| behind(&|name| name == *point, &["=", ":"]).is_some())
        || behind(&|name| K_NAMES.contains(&name), &["=", ":"])
            .is_some_and(|value| value.starts_with(['[', '(', 'n']))
        || behind(&|name| MATRICES.contains(&last_segment(name)), &["="]).is_some()
        || text.chars().all(of_numbers) && text.contains(|c: char| c.is_ascii_digit())
}

/// Reads the camera of a text. The field of view and the image size are those of the camera `at_hand`
/// if the text does not specify them.
pub(super) fn read(input: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    let source = Source { input, statements: statements(input)? };
    if source.statements.is_empty() {
        return Err(source.missing("a number", RIGHT));
    }
    if source.statements.iter().any(|statement| is_of_intrinsics(statement.target)) {
        return by_intrinsics(&source, at_hand);
    }
    if let Some(k) = source.statements.iter().position(|s| is_look_at(s.called)) {
        let call = &source.statements[k];
        let points = source.numbers(call)?.try_into();
        let points = points.map_err(|_| source.refused(call, "it must have 9 numbers"))?;
        return match source.statements.get(usize::from(k == 0)) {
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
fn by_names(source: &Source, at_hand: &Camera) -> Result<Imported, FileError> {
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
fn by_numbers(source: &Source, at_hand: &Camera) -> Result<Imported, FileError> {
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
    let is_rotation = first.tokens.iter().take(2).all(|token| token.turn() > 0)
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
        rounded(degrees, 4)
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
fn by_intrinsics(source: &Source, at_hand: &Camera) -> Result<Imported, FileError> {
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
            rounded(right, 6),
            rounded(down, 6)
        ));
    }
    let [x, y, z, t] = pose(source, &mut notes)?;
    // eye = -R^T t: this removes the rounding errors of nine products and six sums.
    let eye = DVec3::ZERO - (t.x * x + t.y * y + t.z * z);
    let roundings = 4.0 * f64::EPSILON * length(t);
    let eye = DVec3::from_array(eye.to_array().map(|x| settled(x, roundings)));
    let frame = DAffine3::from_cols(x, -y, -z, eye);
    let (orientation, eye) = right_handed(&frame, &mut notes).map_err(|right| {
        FileError::of_file(source.input.path, format!("R is no rotation: {right}"))
    })?;
    let viewport = viewport_of(&k, image, at_hand.viewport.distance);
    Ok(Imported { camera: Camera { eye, orientation, viewport, image }, notes })
}

fn intrinsics(source: &Source) -> Result<Intrinsics, FileError> {
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
    source: &Source,
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
fn pose(source: &Source, notes: &mut Vec<String>) -> Result<[DVec3; 4], FileError> {
    let whole = source.given(&RT_NAMES, &[12, 16], "it must be [R|t], 3 × 4")?;
    let matrix = source.given(&R_NAMES, &[9], "it must be 3 × 3 numbers")?;
    let translation = source.given(&T_NAMES, &[3], "it must be three numbers")?;
    if let Some((field, numbers)) = whole {
        if let Some((other, _)) = matrix.or(translation) {
            return Err(source.given_too(other, field));
        }
        let right = "its last row must be 0 0 0 1";
        let affine = affine_of_rows(&numbers).ok_or_else(|| source.value_fault(field, right))?;
        let rows = affine.matrix3.transpose();
        return Ok([rows.x_axis, rows.y_axis, rows.z_axis, affine.translation]);
    }
    match (matrix, translation) {
        (Some((_, m)), Some((_, t))) => {
            let [x, y, z] = [0, 3, 6].map(|k| DVec3::from_slice(&m[k..]));
            Ok([x, y, z, DVec3::from_slice(&t)])
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
struct Source<'s> {
    input: &'s Input<'s>,
    statements: Vec<Statement<'s>>,
}

/// A statement: a call, an assignment, or numbers alone.
struct Statement<'s> {
    /// The whole statement, which is not empty.
    tokens: Vec<Token<'s>>,
    /// The name that is assigned to, such as `view` in `glm::mat4 view = ...`; empty if there is none.
    target: &'s str,
    /// The name of the called function; empty if nothing is called.
    called: &'s str,
    /// The arguments of the call; without a call, the values.
    arguments: Vec<Vec<Token<'s>>>,
}

impl Source<'_> {
    /// Returns a part of a statement on one line, and the index of its first byte, for an error.
    fn shown(&self, statement: &Statement, part: &[Token]) -> (String, usize) {
        let (Some(first), Some(last)) = (part.first(), part.last()) else {
            return (String::new(), statement.tokens[0].at);
        };
        let text = one_line(&self.input.text[first.at..last.at + last.text.len()]);
        (text.replace(QUOTES, ""), first.at)
    }

    /// Creates the error `statement: right`, located at the statement.
    fn refused(&self, statement: &Statement, right: &str) -> FileError {
        let (text, at) = self.shown(statement, &statement.tokens);
        self.input.error_at(at, format!("{}: {right}", text.trim_end_matches(':')))
    }

    /// Creates the error `field is value: right` about an argument, located at the value.
    fn fault(&self, field: &str, of: &Statement, value: &[Token], right: &str) -> FileError {
        let (value, at) = self.shown(of, value);
        self.input.error_at(at, format!("{field} is {value}: {right}"))
    }

    /// Creates the error of [`Self::fault`] for a statement that assigns one value to a name.
    fn value_fault(&self, statement: &Statement, right: &str) -> FileError {
        self.fault(statement.target, statement, &statement.arguments[0], right)
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
            let fault = || self.fault(field, statement, argument, OF_NUMBERS);
            all.extend(literal(argument).ok_or_else(fault)?);
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
    ) -> Result<Option<(&Statement<'_>, Vec<f64>)>, FileError> {
        let mut taken: Option<(&Statement, Vec<f64>)> = None;
        for statement in self.statements.iter().filter(|s| names.contains(&s.target)) {
            let value = &statement.arguments[0];
            // In C, the quotient of two integers is rounded towards 0.
            let is_quotient = value.iter().any(|token| token.text == "/");
            let numbers = literal(value).filter(|n| counts.contains(&n.len()) && !is_quotient);
            let numbers = numbers.ok_or_else(|| self.value_fault(statement, right))?;
            if let Some((first, _)) = taken {
                return Err(self.given_too(statement, first));
            }
            taken = Some((statement, numbers));
        }
        Ok(taken)
    }
}

/// A word, such as a name or a number, or a sign; and the index of its first byte in the text.
#[derive(Clone, Copy)]
struct Token<'s> {
    text: &'s str,
    at: usize,
}

impl Token<'_> {
    /// Returns 1 for a bracket that opens, -1 for one that closes, and 0 for any other token.
    fn turn(&self) -> i32 {
        match self.text {
            "(" | "[" | "{" => 1,
            ")" | "]" | "}" => -1,
            _ => 0,
        }
    }
}

const QUOTES: [char; 2] = ['"', '\''];

/// Splits a text into tokens, without its comments. The end of a line is a token, too; `//` is one behind a
/// number, which it may divide. The outer braces and the quotes of a JSON object or of Python's `dict` are
/// left out.
fn tokens(text: &str) -> Vec<Token<'_>> {
    const SIGNS: &str = "()[]{},;/=\"'#\n";
    let (mut tokens, mut at): (Vec<Token>, usize) = (Vec::new(), 0);
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        let is_directive = DIRECTIVES.iter().any(|directive| rest.starts_with(directive));
        let is_number =
            |last: &Token| last.text.ends_with(|c: char| c.is_ascii_digit() || c == '.');
        let is_colon = |k: usize| !rest[k..].starts_with("::") && !rest[..k].ends_with(':');
        let ends = |(k, c): &(usize, char)| {
            c.is_whitespace() || SIGNS.contains(*c) || *c == ':' && is_colon(*k)
        };
        let word = rest.char_indices().skip(1).find(ends).map_or(rest.len(), |(k, _)| k);
        let (length, is_token) = match c {
            '/' if rest.starts_with("//") && tokens.last().is_some_and(is_number) => (2, true),
            '/' if rest.starts_with("/*") => {
                (rest[2..].find("*/").map_or(rest.len(), |k| k + 4), false)
            }
            '/' if rest.starts_with("//") => (rest.find('\n').unwrap_or(rest.len()), false),
            '#' if !is_directive => (rest.find('\n').unwrap_or(rest.len()), false),
            '\n' => (1, true),
            c if c.is_whitespace() || c == '\u{feff}' => (c.len_utf8(), false),
            ':' if is_colon(0) => (1, true),
            c if c != '#' && SIGNS.contains(c) => (1, true),
            _ => (word, true),
        };
        if is_token {
            tokens.push(Token { text: &rest[..length], at });
        }
        at += length;
    }
    let solid: Vec<Token> = tokens.iter().filter(|token| token.text != "\n").copied().collect();
    if let [first, second, .., last] = solid[..]
        && (first.text, last.text) == ("{", "}")
        && second.text.starts_with(QUOTES)
    {
        tokens
            .retain(|one| ![first.at, last.at].contains(&one.at) && !one.text.starts_with(QUOTES));
    }
    tokens
}

/// Splits tokens at those outside of brackets for whose index `is_end` is true.
fn parts<'s>(tokens: &[Token<'s>], is_end: impl Fn(usize) -> bool) -> Vec<Vec<Token<'s>>> {
    let (mut depth, mut parts) = (0, vec![Vec::new()]);
    for (k, token) in tokens.iter().enumerate() {
        depth += token.turn();
        if depth == 0 && is_end(k) {
            parts.push(Vec::new());
        } else if let Some(part) = parts.last_mut() {
            part.push(*token);
        }
    }
    parts
}

/// Splits tokens at commas outside of brackets. A trailing comma is allowed.
fn list<'s>(tokens: &[Token<'s>]) -> Vec<Vec<Token<'s>>> {
    let mut parts = parts(tokens, |k| tokens[k].text == ",");
    parts.pop_if(|last| last.is_empty());
    parts
}

/// Splits a text into its statements.
fn statements<'s>(input: &Input<'s>) -> Result<Vec<Statement<'s>>, FileError> {
    let tokens = tokens(input.text);
    let fault = |at: usize, right: &str| {
        let rest = input.text[at..].split([';', '\n']).next().unwrap_or_default();
        input.error_at(at, format!("{}: {right}", one_line(rest).trim_end_matches(':')))
    };
    let mut open: Vec<Token> = Vec::new();
    for token in &tokens {
        let closes = |open: &mut Token| {
            matches!((open.text, token.text), ("(", ")") | ("[", "]") | ("{", "}"))
        };
        if token.turn() > 0 {
            open.push(*token);
        } else if token.turn() < 0 && open.pop_if(closes).is_none() {
            return Err(fault(token.at, "no bracket is open that it closes"));
        } else if token.text == "//" {
            let right = "a number must not stand before //, which may divide it, as in Python";
            return Err(fault(token.at, right));
        }
    }
    if let Some(first) = open.first() {
        return Err(fault(first.at, "this bracket is not closed"));
    }
    // A statement continues after a line that is incomplete, and after a comma that no assignment follows.
    let is_end = |k: usize| match tokens[k].text {
        ";" => true,
        "\n" => k == 0 || !["=", ",", ":"].contains(&tokens[k - 1].text),
        "," => {
            let mut next = tokens[k + 1..].iter().map(|token| token.text).filter(|t| *t != "\n");
            next.next().is_some_and(is_name) && matches!(next.next(), Some("=" | ":"))
        }
        _ => false,
    };
    let mut parts = parts(&tokens, is_end);
    parts.iter_mut().for_each(|part| part.retain(|token| token.text != "\n"));
    parts.retain(|part| part.first().is_some_and(|one| !["import", "from"].contains(&one.text)));
    let statement = |part: Vec<Token<'s>>| {
        let at = part[0].at;
        statement(part).ok_or_else(|| fault(at, RIGHT))
    };
    parts.into_iter().map(statement).collect()
}

/// Parses `name(...)`, `name = ...`, or numbers. Returns `None` for anything else.
fn statement(tokens: Vec<Token>) -> Option<Statement> {
    let head = tokens.iter().take_while(|token| token.turn() == 0);
    let (target, value) = match head.clone().position(|token| ["=", ":"].contains(&token.text)) {
        None => ("", &tokens[..]),
        Some(at) => {
            let (target, words) = tokens[..at].split_last()?;
            let are_declared = words.iter().all(|word| DECLARATIONS.contains(&word.text));
            (Some(target.text).filter(|name| is_name(name) && are_declared)?, &tokens[at + 1..])
        }
    };
    let mut depth = 0;
    let closes = |token: &Token| {
        depth += token.turn();
        token.turn() < 0 && depth == 0
    };
    let is_whole = value.iter().position(closes).is_some_and(|close| close + 1 == value.len());
    let (called, arguments) = match value {
        [name, open, inside @ .., _]
            if is_whole
                && open.text == "("
                && is_name(name.text)
                && !MAKERS.contains(&last_segment(name.text)) =>
        {
            (name.text, list(inside))
        }
        _ if !target.is_empty() => ("", vec![value.to_vec()]),
        [first, ..] if first.text.starts_with(is_of_name) && literal(value).is_none() => {
            return None;
        }
        _ => ("", list(value)),
    };
    Some(Statement { target, called, arguments, tokens })
}

/// Returns the numbers of a value, if it is literal: apart from numbers, it contains only brackets,
/// [`MAKERS`] before brackets, slashes in quotients of two numbers, and commas. Returns `None` for any other
/// value.
fn literal(value: &[Token]) -> Option<Vec<f64>> {
    let (mut numbers, mut commas, mut is_behind_value) = (Vec::new(), 0, false);
    let mut tokens = value.iter().peekable();
    while let Some(token) = tokens.next() {
        let is_maker = || MAKERS.contains(&last_segment(token.text));
        match token.text {
            // Two adjacent commas mean that a number is missing.
            "," if !is_behind_value => return None,
            "," => (commas, is_behind_value) = (commas + 1, false),
            _ if token.turn() != 0 => is_behind_value |= token.turn() < 0,
            _ if is_maker() && tokens.peek().is_some_and(|next| next.turn() > 0) => (),
            text => {
                let mut number_of = number(text)?;
                if tokens.next_if(|next| next.text == "/").is_some() {
                    number_of /= number(tokens.next()?.text)?;
                }
                numbers.push(Some(number_of).filter(|number| number.is_finite())?);
                is_behind_value = true;
            }
        }
    }
    // In GLM, a vector that is made from one number has it in all components.
    if let ([one], Some("vec3" | "dvec3")) =
        (&numbers[..], value.first().map(|first| last_segment(first.text)))
    {
        return Some(vec![*one; 3]);
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
