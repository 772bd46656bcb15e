//! Finding calls, assignments and numbers in code and scene languages, without running them.

use std::path::Path;

use pinhole_core::DVec3;

use super::Text;
pub(crate) use super::comments::Comments;
use super::comments::without_comments;
use super::names::{Given, Known, filled};
use crate::formats::{FileError, Place};
use crate::model::expression;

/// A text whose comments are blanked, so that places stay.
pub(crate) struct Code<'a> {
    path: &'a Path,
    text: &'a str,
    plain: String,
    /// Where each bracket opens and closes, in order.
    pub(super) brackets: Vec<(usize, usize)>,
    pub(super) known: Known,
}

/// A part of a text.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece<'t> {
    pub(crate) text: &'t str,
    pub(crate) at: usize,
}

impl<'a> Code<'a> {
    pub(crate) fn new(text: &Text<'a>, comments: Comments) -> Code<'a> {
        let mut plain = without_comments(text.text, comments);
        if comments == Comments::SlashesAndAngles {
            plain = plain.replace('<', "[").replace('>', "]");
        }
        let brackets = matched(&plain);
        Code { path: text.path, text: text.text, plain, brackets, known: Known::default() }
    }

    /// The whole text.
    pub(crate) fn whole(&self) -> Piece<'_> {
        Piece { text: &self.plain, at: 0 }
    }

    pub(crate) fn error(&self, at: usize, problem: impl Into<String>) -> FileError {
        error_at(self.path, self.text, at, problem)
    }

    /// `field is value: right`, where the value stands.
    pub(crate) fn fault(&self, field: &str, piece: Piece, right: &str) -> FileError {
        let given = self.text.get(piece.at..piece.at + piece.text.len()).unwrap_or(piece.text);
        let shown: String = given.split_whitespace().collect::<Vec<_>>().join(" ");
        let shown: String = match shown.chars().count() {
            0..=60 => shown,
            _ => shown.chars().take(60).chain("...".chars()).collect(),
        };
        let shown = if shown.is_empty() { "empty".to_owned() } else { shown };
        self.error(piece.at, format!("{field} is {shown}: {right}"))
    }

    pub(crate) fn missing(&self, field: &str, right: &str) -> FileError {
        FileError::of_file(self.path, format!("{field} is missing: {right}"))
    }

    /// Of axes that are no rotation.
    pub(crate) fn rotation(&self, field: &str, right: &str) -> FileError {
        FileError::of_file(self.path, format!("{field} is no rotation: {right}"))
    }

    /// What stands in the brackets of every call of this name.
    pub(crate) fn calls(&self, name: &str) -> Vec<Piece<'_>> {
        self.calls_in(self.whole(), name)
    }

    pub(crate) fn calls_in<'t>(&self, within: Piece<'t>, name: &str) -> Vec<Piece<'t>> {
        let mut calls = Vec::new();
        let mut from = 0;
        for at in words(within, name) {
            let open = after_spaces(within.from(at + name.len()));
            // A call within the same one is an argument of it.
            if at >= from
                && let Some(inside) = self.bracketed(open)
            {
                from = inside.at + inside.text.len() - within.at;
                calls.push(inside);
            }
        }
        calls
    }

    /// What stands between the bracket with which the piece begins and the one that closes it.
    pub(crate) fn bracketed<'t>(&self, piece: Piece<'t>) -> Option<Piece<'t>> {
        let found = self.brackets.binary_search_by_key(&piece.at, |(open, _)| *open).ok()?;
        let end = self.brackets[found].1 - piece.at;
        Some(Piece { text: piece.text.get(..=end)?.get(1..end)?, at: piece.at + 1 })
    }

    /// The value that a name is given last: `name = value`, up to the end of the statement.
    pub(crate) fn value(&self, name: &str) -> Option<Piece<'_>> {
        let whole = self.whole();
        words(whole, name).into_iter().rev().find_map(|at| assigned(whole.from(at + name.len())))
    }

    /// Every number of a value, brackets and names such as `vec3` or `np.array` regardless.
    pub(crate) fn numbers(&self, field: &str, piece: Piece) -> Result<Vec<f64>, FileError> {
        let mut numbers = Vec::new();
        self.collect(field, trimmed(piece), DEEPEST, &mut numbers)?;
        Ok(numbers)
    }

    pub(super) fn collect(
        &self,
        field: &str,
        piece: Piece,
        depth: usize,
        into: &mut Vec<f64>,
    ) -> Result<(), FileError> {
        let Some(deeper) = depth.checked_sub(1) else {
            return Err(self.fault(field, piece, "its brackets are too many"));
        };
        if let Some(inside) = self.list_in(piece) {
            let before = into.len();
            for part in split(inside) {
                self.collect(field, part, deeper, into)?;
            }
            let count = filled(piece, inside, into.len() - before);
            let part = into.get(before).copied().unwrap_or_default();
            into.resize(before + count, part);
            return Ok(());
        }
        let parts = split(piece);
        if parts.len() > 1 {
            return parts.into_iter().try_for_each(|part| self.collect(field, part, deeper, into));
        }
        if let Some(number) = number(piece.text) {
            into.push(number);
        } else if let Some(numbers) = self.numbers_by_names(piece, deeper) {
            into.extend(numbers);
        } else if let Given::Changed = self.given(piece.text.trim()) {
            let right = "it is given more than once, or changed: here it must be numbers";
            return Err(self.fault(field, piece, right));
        } else {
            return Err(self.fault(field, piece, "it must be a finite number"));
        }
        Ok(())
    }

    /// What is in a list, be it `[1, 2]`, `(1, 2)`, `new Vec3(1, 2)` or `np.array([1, 2])`.
    fn list_in<'t>(&self, piece: Piece<'t>) -> Option<Piece<'t>> {
        let open = piece.text.find(['(', '[', '{'])?;
        let name = piece.text[..open].trim();
        let name = name.strip_prefix("new ").unwrap_or(name).trim_start();
        let is_path = name.chars().all(|c| c.is_alphanumeric() || ".:_".contains(c));
        let short = name.rsplit(['.', ':']).next().unwrap_or_default().to_ascii_lowercase();
        if !is_path || !(short.is_empty() || KINDS_OF_LIST.contains(&&short[..])) {
            return None;
        }
        let inside = self.bracketed(piece.from(open))?;
        let closed = inside.at + inside.text.len() + 1 == piece.at + piece.text.len();
        // Brackets round a sum, as in (1 + 2) / 3, are none of a list.
        let is_sum = name.is_empty() && !inside.text.contains([',', '[', '(']);
        (closed && (!is_sum || number(inside.text).is_some())).then_some(inside)
    }

    pub(crate) fn number(&self, field: &str, piece: Piece) -> Result<f64, FileError> {
        match self.numbers(field, piece)?[..] {
            [number] => Ok(number),
            _ => Err(self.fault(field, piece, "it must be one number")),
        }
    }

    pub(crate) fn vector(&self, field: &str, piece: Piece) -> Result<DVec3, FileError> {
        match self.numbers(field, piece)?[..] {
            [x, y, z] => Ok(DVec3::new(x, y, z)),
            _ => Err(self.fault(field, piece, "it must be three numbers")),
        }
    }
}

impl<'t> Piece<'t> {
    pub(crate) fn from(self, byte: usize) -> Piece<'t> {
        Piece { text: &self.text[byte..], at: self.at + byte }
    }
}

/// An error at a byte of a text.
pub(crate) fn error_at(
    path: &Path,
    text: &str,
    at: usize,
    problem: impl Into<String>,
) -> FileError {
    let place = Some(Place::of_byte(text.as_bytes(), at));
    FileError { place, ..FileError::of_file(path, problem) }
}

/// A value without the blanks around it.
pub(crate) fn trimmed(piece: Piece) -> Piece {
    let piece = after_spaces(piece);
    Piece { text: piece.text.trim_end(), ..piece }
}

/// The parts between commas that stand in no bracket of their own.
pub(crate) fn split(piece: Piece) -> Vec<Piece> {
    let mut parts = Vec::new();
    let (mut depth, mut from) = (0_i32, 0);
    for (at, c) in piece.text.char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(trimmed(Piece { text: &piece.text[from..at], at: piece.at + from }));
                from = at + 1;
            }
            _ => (),
        }
    }
    let last = trimmed(piece.from(from));
    if !last.text.is_empty() {
        parts.push(last);
    }
    parts
}

/// Where each bracket opens and closes, in order, in one pass over the text.
fn matched(text: &str) -> Vec<(usize, usize)> {
    let mut open: Vec<(u8, usize)> = Vec::new();
    let mut pairs = Vec::new();
    for (at, byte) in text.bytes().enumerate() {
        // A smaller one that is left open ends with the larger one around it: it may be a sign, as in
        // (a < b).
        let (own, smaller): (u8, &[u8]) = match byte {
            b'(' | b'[' | b'{' => {
                open.push((byte, at));
                continue;
            }
            b']' => (b'[', b""),
            b')' => (b'(', b"["),
            b'}' => (b'{', b"[("),
            _ => continue,
        };
        while open.pop_if(|(kind, _)| smaller.contains(kind)).is_some() {}
        pairs.extend(open.pop_if(|(kind, _)| *kind == own).map(|(_, from)| (from, at)));
    }
    pairs.sort_unstable();
    pairs
}

/// `= value` or `: value`, up to the end of the statement.
fn assigned(rest: Piece) -> Option<Piece> {
    let rest = after_spaces(rest);
    let value = rest.text.strip_prefix(['=', ':'])?;
    let value = after_spaces(Piece { text: value, at: rest.at + 1 });
    (!value.text.starts_with('=')).then(|| statement(value))
}

/// Whether a word goes on with it: letters, digits and `_`.
pub(crate) fn is_of_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Where a word stands that is no part of a longer one.
pub(crate) fn words(within: Piece, word: &str) -> Vec<usize> {
    let text = within.text;
    let alone = |at: &usize| {
        let before = text[..*at].chars().next_back();
        let after = text[at + word.len()..].chars().next();
        !before.is_some_and(is_of_word) && !after.is_some_and(is_of_word)
    };
    text.match_indices(word).map(|(at, _)| at).filter(alone).collect()
}

pub(crate) fn after_spaces(piece: Piece) -> Piece {
    piece.from(piece.text.len() - piece.text.trim_start().len())
}

/// Up to the semicolon or line's end at which the statement ends; brackets go over lines.
pub(super) fn statement(value: Piece) -> Piece {
    let mut depth = 0_i32;
    for (at, c) in value.text.char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => (),
        }
        if depth < 0 || (depth == 0 && matches!(c, ';' | '\n')) {
            return Piece { text: value.text[..at].trim_end(), ..value };
        }
    }
    trimmed(value)
}

/// A list in a list in a list: no camera has more of them.
const DEEPEST: usize = 16;

/// Words before a bracket that make a list of what is in it, in small letters; all others do something
/// with it.
const KINDS_OF_LIST: [&str; 38] = [
    "array",
    "asarray",
    "color",
    "double3",
    "dmat3",
    "dmat4",
    "dvec2",
    "dvec3",
    "dvec4",
    "euler",
    "float3",
    "float4",
    "list",
    "mat3",
    "mat4",
    "matrix",
    "matx33d",
    "matx33f",
    "new",
    "point",
    "point3",
    "point3d",
    "point3f",
    "quat",
    "quaternion",
    "svector",
    "sa",
    "tuple",
    "vec",
    "vec2",
    "vec3",
    "vec3d",
    "vec3f",
    "vec4",
    "vector",
    "vector3",
    "vector3d",
    "vector3f",
];

/// What turns a number into one with digits behind the point, whatever stands behind it.
const CASTS: [&str; 6] =
    ["(float)", "(double)", "(GLfloat)", "(GLdouble)", "static_cast<float>", "static_cast<double>"];

/// A number of code: `1`, `1.0f`, `16.0 / 9.0`, `double(400)`, `math.radians(45)`.
pub(crate) fn number(text: &str) -> Option<f64> {
    /// No number is longer, and so none is a bracket in a bracket without end.
    const LONGEST: usize = 400;
    if text.len() > LONGEST {
        return None;
    }
    let text = CASTS.iter().fold(text.to_owned(), |text, cast| text.replace(cast, ""));
    let text = text.trim();
    for name in ["radians", "deg2rad", "degToRad"] {
        if let Some((before, rest)) = text.split_once(name)
            && before.chars().all(|c| c.is_alphanumeric() || ".:_".contains(c))
            && let Some(inside) = rest.trim().strip_prefix('(').and_then(|r| r.strip_suffix(')'))
        {
            return number(inside).map(f64::to_radians);
        }
    }
    let mut clean = String::new();
    let mut letters = text.replace("double", "").replace("float", "").replace("Float64", "");
    for prefix in ["math.", "np.", "std::", "Math.", "glm::"] {
        letters = letters.replace(prefix, "");
    }
    let letters: Vec<char> = letters.chars().collect();
    for (k, c) in letters.iter().enumerate() {
        let after_digit = k > 0 && (letters[k - 1].is_ascii_digit() || letters[k - 1] == '.');
        let ends = letters.get(k + 1).is_none_or(|next| !next.is_alphanumeric());
        if !(matches!(c, 'f' | 'F') && after_digit && ends) {
            clean.push(*c);
        }
    }
    if clean.is_empty() {
        return None;
    }
    expression::evaluate(&clean).ok()
}
