//! Pieces of a text, each with its position.

/// A part of a text, and the byte at which it begins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece<'t> {
    pub(super) text: &'t str,
    pub(super) at: usize,
}

impl<'t> Piece<'t> {
    /// The rest of it from this byte on.
    pub(super) fn from(self, byte: usize) -> Piece<'t> {
        Piece { text: &self.text[byte..], at: self.at + byte }
    }

    /// The part of it before this byte.
    pub(super) fn until(self, byte: usize) -> Piece<'t> {
        Piece { text: &self.text[..byte], ..self }
    }

    pub(super) fn after_spaces(self) -> Piece<'t> {
        self.from(self.text.len() - self.text.trim_start().len())
    }

    /// It without the blanks around it.
    pub(super) fn trimmed(self) -> Piece<'t> {
        let piece = self.after_spaces();
        piece.until(piece.text.trim_end().len())
    }

    /// The parts between commas that stand in no bracket of their own; a comma may stand behind the last.
    pub(super) fn split(self) -> Vec<Piece<'t>> {
        let (mut depth, mut from, mut parts) = (0_i32, 0, Vec::new());
        for (at, c) in self.text.char_indices().chain([(self.text.len(), ',')]) {
            match c {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => depth -= 1,
                ',' if depth == 0 => {
                    parts.push(self.until(at).from(from).trimmed());
                    from = at + 1;
                }
                _ => (),
            }
        }
        parts.pop_if(|last| last.text.is_empty());
        parts
    }

    /// The word with which it begins; empty where it begins with none.
    pub(super) fn word(self) -> Piece<'t> {
        self.until(self.text.find(|c| !is_of_word(c)).unwrap_or(self.text.len()))
    }
}

/// Returns true for what a word is made of: letters, digits and `_`.
pub(super) fn is_of_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}
