//! Pieces of a POV-Ray scene: words, brackets, and the numbers of a vector.

use std::path::Path;

use super::comments::without_comments;
use crate::error::one_line;
use crate::format::Input;
use crate::programs::pieces::{Piece, is_of_word};
use crate::{FileError, Location};

/// A text whose comments are blanked and whose angle brackets are square, so that places stay.
pub(super) struct Code<'a> {
    path: &'a Path,
    text: &'a str,
    plain: String,
    /// Places where each bracket opens and closes, in order.
    brackets: Vec<(usize, usize)>,
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
        FileError::at(self.path, Location::of_byte(self.text.as_bytes(), at), problem)
    }

    /// `field is value: right`, where the value stands.
    pub(super) fn fault(&self, field: &str, piece: Piece, right: &str) -> FileError {
        let given = self.text.get(piece.at..piece.at + piece.text.len()).unwrap_or(piece.text);
        let shown = one_line(given);
        let shown = if shown.is_empty() { "empty" } else { &shown };
        self.error(piece.at, format!("{field} is {shown}: {right}"))
    }

    pub(super) fn missing(&self, field: &str, right: &str) -> FileError {
        FileError::of_file(self.path, format!("{field} is missing: {right}"))
    }

    /// Returns the text between the bracket with which the piece begins and the one that closes it.
    pub(super) fn bracketed<'t>(&self, piece: Piece<'t>) -> Option<Piece<'t>> {
        let found = self.brackets.binary_search_by_key(&piece.at, |(open, _)| *open).ok()?;
        let end = self.brackets[found].1 - piece.at;
        (end < piece.text.len()).then(|| piece.until(end).from(1))
    }
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
