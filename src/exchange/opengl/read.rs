//! What a program gives `gluLookAt` and `gluPerspective`, or GLM's and glMatrix's `lookAt` and
//! `perspective`.

use pinhole_core::{Camera, DVec3, ImageSize, Orientation};

use super::moved::{alone, unmoved};
use crate::exchange::back::{image_of, image_of_aspect, upright};
use crate::exchange::code::{Code, Comments, Piece, split, trimmed};
use crate::exchange::names::Given;
use crate::exchange::sheet::n;
use crate::exchange::{Taken, Text};
use crate::formats::FileError;

/// The languages, as far as they reckon differently.
#[derive(Clone, Copy, PartialEq)]
enum Language {
    /// And C++: 4 / 3 is 1.
    C,
    JavaScript,
    Python,
}

pub(super) fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let language = language(text.text);
    let code = match language {
        Language::Python => Code::new(text, Comments::Hash),
        _ => Code::new(text, Comments::Slashes),
    };
    let mut notes = Vec::new();
    let look = chosen(&code, ["gluLookAt", "lookAt"], &LOOKS, &mut notes)?;
    let look = look.ok_or_else(|| {
        code.missing("gluLookAt", "the camera's eye, center and up must be given by it")
    })?;
    let lens = chosen(&code, ["gluPerspective", "perspective"], &LENSES, &mut notes)?;
    let lens = lens.ok_or_else(|| {
        code.missing("gluPerspective", "fovy, aspect, zNear and zFar must be given by it")
    })?;
    unmoved(&code, &look)?;
    unmoved(&code, &lens)?;
    alone(&code, &look)?;
    let [eye, at, up] = points(&code, &look)?;
    let (fovy, ratio) = field_of_view(&code, &lens, language)?;
    let size = size(&code, ratio.ok(), &mut notes)?;
    let aspect = ratio.unwrap_or_else(|said| {
        let image = size.unwrap_or(at_hand.image);
        let (w, h) = (image.width(), image.height());
        notes.push(format!("aspect is {said}, which is no number: {w} / {h} taken"));
        image.aspect()
    });
    let image =
        size.unwrap_or_else(|| image_of_aspect(at_hand.image, aspect, lens.name, &mut notes));
    let camera = Camera {
        eye,
        orientation: Orientation::At { at, up },
        viewport: upright(fovy, aspect, at_hand.viewport.distance),
        image,
    };
    Ok(Taken::camera(camera, notes))
}

/// By its signs: only Python has neither semicolons nor braces, and only JavaScript has `let`.
fn language(text: &str) -> Language {
    let mut lines = text.lines().map(str::trim);
    let is_python_s = |line: &str| {
        let imports = line.starts_with("import ") || line.starts_with("from ");
        (imports && !line.contains(['\'', '"', ';', '{', '*']))
            || line.starts_with("from OpenGL")
            || (line.starts_with("def ") && line.ends_with(':'))
    };
    const OTHERS: [&str; 9] =
        ["//", "/*", "#include", "#define", "#if", "const ", "let ", "var ", "{"];
    let is_python = lines.clone().any(is_python_s)
        || !(lines.any(|line| line.ends_with(';')) || OTHERS.iter().any(|w| text.contains(w)));
    if is_python {
        return Language::Python;
    }
    let is_javascript = ["mat4.", "let ", "=>", "function ", "var ", "Math."];
    match is_javascript.iter().any(|word| text.contains(word)) {
        true => Language::JavaScript,
        false => Language::C,
    }
}

/// A call that may be the camera's.
#[derive(Clone, Copy)]
pub(super) struct Call<'t> {
    pub(super) name: &'static str,
    pub(super) arguments: Piece<'t>,
    /// What the matrix is called.
    pub(super) matrix: &'t str,
}

/// What the camera's own matrices are called by most, and those of others.
const LOOKS: [&str; 3] = ["view", "cam", "eye"];
const LENSES: [&str; 4] = ["proj", "persp", "view", "cam"];
const OTHERS: [&str; 7] = ["light", "shadow", "sun", "depth", "mirror", "reflect", "cube"];

/// Of these the ones that are never the camera's, even where there is no other.
const LIGHTS: [&str; 4] = ["light", "shadow", "sun", "depth"];

/// No more different calls of a name are told apart: they are too many long before.
const MOST_CALLS: usize = 100;

/// The one call of these names; of several the one whose matrix is called as the camera's are.
fn chosen<'t>(
    code: &'t Code,
    names: [&'static str; 2],
    own: &[&str],
    notes: &mut Vec<String>,
) -> Result<Option<Call<'t>>, FileError> {
    let whole = code.whole();
    let mut calls: Vec<Call> = Vec::new();
    for name in names {
        for arguments in code.calls(name) {
            let after = &whole.text[arguments.at + arguments.text.len()..];
            let is_defined =
                after.strip_prefix(')').is_some_and(|a| a.trim_start().starts_with('{'));
            let same = calls.iter().any(|call| call.arguments.text == arguments.text);
            if !is_defined && !same && calls.len() < MOST_CALLS {
                calls.push(call(code, name, arguments));
            }
        }
    }
    let [first, .., last] = calls[..] else {
        let only = calls.first().copied();
        let matrix = only.map_or(String::new(), |call| call.matrix.to_ascii_lowercase());
        return match only.filter(|_| LIGHTS.iter().any(|word| matrix.contains(word))) {
            Some(call) => {
                let right = format!(
                    "this is of a light, not of the camera: the camera's {} must be given by numbers",
                    call.name
                );
                Err(code.fault(call.matrix, call.arguments, &right))
            }
            None => Ok(only),
        };
    };
    let is_one = |call: &&Call| {
        let matrix = call.matrix.to_ascii_lowercase();
        let has = |words: &[&str]| words.iter().any(|word| matrix.contains(word));
        has(own) && !has(&OTHERS)
    };
    let count = calls.len();
    let named: Vec<&Call> = calls.iter().filter(is_one).collect();
    if let [one] = named[..] {
        notes.push(format!("{count} calls of {}: that of {} is taken", first.name, one.matrix));
        return Ok(Some(*one));
    }
    let right = format!("one of {count} different calls: leave in that of the camera");
    Err(code.fault(last.name, last.arguments, &right))
}

/// With the name that it is given to; glMatrix has it as the first argument.
fn call<'t>(code: &'t Code, name: &'static str, arguments: Piece<'t>) -> Call<'t> {
    let is_name = |text: &str| {
        text.starts_with(|c: char| c.is_alphabetic() || c == '_')
            && text.chars().all(|c| c.is_alphanumeric() || "_.$".contains(c))
    };
    let parts = split(arguments);
    let more = if name.ends_with("erspective") { 5 } else { 4 };
    if name.starts_with(char::is_lowercase)
        && let [first, second, ..] = parts[..]
        && parts.len() == more
        && is_name(first.text)
    {
        let arguments = arguments.from(second.at - arguments.at);
        return Call { name, arguments, matrix: first.text };
    }
    let before = &code.whole().text[..arguments.at];
    let start = before.rfind([';', '{', '}', '\n']).map_or(0, |at| at + 1);
    let matrix = before[start..].split_once('=').map_or("", |(left, _)| left.trim());
    let from = matrix.rfind(|c: char| !(c.is_alphanumeric() || "_.$".contains(c)));
    Call { name, arguments, matrix: &matrix[from.map_or(0, |at| at + 1)..] }
}

/// Eye, center and up.
fn points(code: &Code, look: &Call) -> Result<[DVec3; 3], FileError> {
    let parts = split(look.arguments);
    if let [eye, center, up] = parts[..]
        && parts.iter().any(|part| sum(*part).is_some())
    {
        return Ok([point(code, eye)?, point(code, center)?, point(code, up)?]);
    }
    let numbers = code.numbers(look.name, look.arguments)?;
    let [ex, ey, ez, cx, cy, cz, ux, uy, uz] = numbers[..] else {
        return Err(code.fault(look.name, look.arguments, "it must have 9 numbers"));
    };
    Ok([DVec3::new(ex, ey, ez), DVec3::new(cx, cy, cz), DVec3::new(ux, uy, uz)])
}

/// A point, or one and a way from it, as in `position + front`.
fn point(code: &Code, piece: Piece) -> Result<DVec3, FileError> {
    let Some((a, sign, b)) = sum(piece) else { return code.vector("lookAt", piece) };
    Ok(code.vector("lookAt", a)? + sign * code.vector("lookAt", b)?)
}

/// Both sides of a sum, or of a difference, of two things with names or brackets.
fn sum(piece: Piece) -> Option<(Piece, f64, Piece)> {
    let mut depth = 0_i32;
    let (at, c) = piece.text.char_indices().skip(1).find(|(_, c)| {
        match c {
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' => depth -= 1,
            _ => (),
        }
        depth == 0 && matches!(c, '+' | '-')
    })?;
    let a = trimmed(Piece { text: &piece.text[..at], ..piece });
    let sign = if c == '+' { 1.0 } else { -1.0 };
    Some((a, sign, trimmed(piece.from(at + 1))))
}

/// fovy in degrees, and aspect, or its text where it is no number.
fn field_of_view<'t>(
    code: &Code,
    lens: &Call<'t>,
    language: Language,
) -> Result<(f64, Result<f64, &'t str>), FileError> {
    let parts = split(lens.arguments);
    let [fovy, aspect, ..] = parts[..] else {
        let right = "it must be fovy, aspect, zNear, zFar";
        return Err(code.fault("gluPerspective", lens.arguments, right));
    };
    let given = code.number("fovy", fovy)?;
    // GLM counts in radians, which are mostly written as radians(45).
    let in_degrees = lens.name == "gluPerspective";
    let degrees = if in_degrees { given } else { given.to_degrees() };
    if !in_degrees && (std::f64::consts::PI..180.0).contains(&given) {
        let right = format!(
            "GLM counts in radians, and {} radians are {} degrees: write glm::radians({})",
            n(given),
            n(degrees.round()),
            fovy.text
        );
        return Err(code.fault("fovy", fovy, &right));
    }
    if !(degrees > 0.0 && degrees < 180.0) {
        return Err(code.fault("fovy", fovy, "it must be between 0 and 180 degrees"));
    }
    if language == Language::C && is_of_whole_numbers(code, aspect.text) {
        let right =
            "C divides whole numbers without a fraction: write it with a point, as 4.0 / 3.0";
        return Err(code.fault("aspect", aspect, right));
    }
    match code.number("aspect", aspect) {
        Ok(ratio) if ratio > 0.0 => Ok((degrees, Ok(ratio))),
        Ok(_) => Err(code.fault("aspect", aspect, "it must be greater than 0")),
        Err(_) => Ok((degrees, Err(aspect.text))),
    }
}

/// Of `800 / 600`, and of names of such numbers.
fn is_of_whole_numbers(code: &Code, aspect: &str) -> bool {
    let is_whole = |text: &str| {
        let text = text.trim();
        let digits = |text: &str| !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
        digits(text) || matches!(code.given(text), Given::Once(value) if digits(value.text.trim()))
    };
    aspect.split_once('/').is_some_and(|(a, b)| is_whole(a) && is_whole(b))
}

/// Of `glViewport`, where it is of numbers; of several the one that has the ratio of the lens.
fn size(
    code: &Code,
    ratio: Option<f64>,
    notes: &mut Vec<String>,
) -> Result<Option<ImageSize>, FileError> {
    let mut sizes: Vec<ImageSize> = Vec::new();
    let mut count = 0;
    for call in code.calls("glViewport") {
        let parts = split(call);
        let [_, _, width, height] = parts[..] else {
            return Err(code.fault("glViewport", call, "it must have four numbers"));
        };
        count += 1;
        let numbers = code.number("width", width).ok().zip(code.number("height", height).ok());
        let Some((width, height)) = numbers else { continue };
        let size = image_of(width, height)
            .map_err(|right| code.fault("glViewport's size", call, &right))?;
        if sizes.len() < MOST_CALLS && !sizes.contains(&size) {
            sizes.push(size);
        }
    }
    if sizes.len() > 1 {
        let ratio = ratio.unwrap_or(f64::NAN);
        sizes.retain(|size| (size.aspect() / ratio - 1.0).abs() < 1e-6);
        if sizes.len() != 1 {
            notes.push(format!("{count} calls of glViewport: none of them is taken"));
            sizes.clear();
        }
    }
    Ok(sizes.first().copied())
}
