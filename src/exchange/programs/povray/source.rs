//! Pieces of a POV-Ray scene: words, brackets, and the numbers of a vector.

use std::path::Path;

use pinhole_core::DVec3;

use super::comments::without_comments;
use crate::format::Input;
use crate::{FileError, Place};

/// A text whose comments are blanked and whose angle brackets are square, so that places stay.
pub(super) struct Code<'a> {
    path: &'a Path,
    text: &'a str,
    plain: String,
    /// Places where each bracket opens and closes, in order.
    brackets: Vec<(usize, usize)>,
}

/// A part of a text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece<'t> {
    pub(super) text: &'t str,
    pub(super) at: usize,
}

impl<'a> Code<'a> {
    pub(super) fn new(text: &Input<'a>) -> Code<'a> {
        let plain = without_comments(text.text).replace('<', "[").replace('>', "]");
        let brackets = matched(&plain);
        Code { path: text.path, text: text.text, plain, brackets }
    }

    /// The whole text.
    pub(super) fn whole(&self) -> Piece<'_> {
        Piece { text: &self.plain, at: 0 }
    }

    pub(super) fn error(&self, at: usize, problem: impl Into<String>) -> FileError {
        let place = Some(Place::of_byte(self.text.as_bytes(), at));
        FileError { place, ..FileError::of_file(self.path, problem) }
    }

    /// `field is value: right`, where the value stands.
    pub(super) fn fault(&self, field: &str, piece: Piece, right: &str) -> FileError {
        let given = self.text.get(piece.at..piece.at + piece.text.len()).unwrap_or(piece.text);
        let shown: String = given.split_whitespace().collect::<Vec<_>>().join(" ");
        let shown: String = match shown.chars().count() {
            0..=60 => shown,
            _ => shown.chars().take(60).chain("...".chars()).collect(),
        };
        let shown = if shown.is_empty() { "empty".to_owned() } else { shown };
        self.error(piece.at, format!("{field} is {shown}: {right}"))
    }

    pub(super) fn missing(&self, field: &str, right: &str) -> FileError {
        FileError::of_file(self.path, format!("{field} is missing: {right}"))
    }

    /// Returns the error of axes that are no rotation.
    pub(super) fn rotation(&self, field: &str, right: &str) -> FileError {
        FileError::of_file(self.path, format!("{field} is no rotation: {right}"))
    }

    /// Returns the text between the bracket with which the piece begins and the one that closes it.
    pub(super) fn bracketed<'t>(&self, piece: Piece<'t>) -> Option<Piece<'t>> {
        let found = self.brackets.binary_search_by_key(&piece.at, |(open, _)| *open).ok()?;
        let end = self.brackets[found].1 - piece.at;
        Some(Piece { text: piece.text.get(..=end)?.get(1..end)?, at: piece.at + 1 })
    }

    /// A vector of numbers, as <1, 2, 3>.
    ///
    /// # Errors
    /// The first of its parts that is none.
    pub(super) fn vector(&self, field: &str, piece: Piece) -> Result<DVec3, FileError> {
        let inside = self.bracketed(piece).unwrap_or(piece);
        let mut numbers = Vec::new();
        for part in split(inside) {
            let number = part.text.parse().ok().filter(|number: &f64| number.is_finite());
            numbers
                .push(number.ok_or_else(|| self.fault(field, part, "it must be a finite number"))?);
        }
        match numbers[..] {
            [x, y, z] => Ok(DVec3::new(x, y, z)),
            _ => Err(self.fault(field, piece, "it must be three numbers")),
        }
    }
}

impl<'t> Piece<'t> {
    pub(super) fn from(self, byte: usize) -> Piece<'t> {
        Piece { text: &self.text[byte..], at: self.at + byte }
    }
}

/// A value without the blanks around it.
pub(super) fn trimmed(piece: Piece) -> Piece {
    let piece = after_spaces(piece);
    Piece { text: piece.text.trim_end(), ..piece }
}

/// The parts between commas that stand in no bracket of their own.
pub(super) fn split(piece: Piece) -> Vec<Piece> {
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

/// Finds where each bracket opens and closes, in order, in one pass over the text.
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

/// Returns true for what a word is made of: letters, digits and `_`.
pub(super) fn is_of_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Finds a word where it is no part of a longer one.
pub(super) fn words(within: Piece, word: &str) -> Vec<usize> {
    let text = within.text;
    let alone = |at: &usize| {
        let before = text[..*at].chars().next_back();
        let after = text[at + word.len()..].chars().next();
        !before.is_some_and(is_of_word) && !after.is_some_and(is_of_word)
    };
    text.match_indices(word).map(|(at, _)| at).filter(alone).collect()
}

pub(super) fn after_spaces(piece: Piece) -> Piece {
    piece.from(piece.text.len() - piece.text.trim_start().len())
}
