//! File errors, and suggestions for mistyped names.

use std::ffi::OsStr;
use std::fmt::Write as _;
use std::path::{Path, is_separator};
use std::{fmt, io};

use strsim::osa_distance;

/// The error of a file that cannot be read, is invalid, or cannot be written.
///
/// It is printed as `room.toml:12:10: sphere[3].radius is -1.0: it must be greater than 0`: file, line
/// and column, then the field, its value, and the rule for valid values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileError {
    /// The file, as the user gave it, in the form of [`legible_name`].
    pub file: String,
    /// Location in the file; `None` if the error is about the whole file.
    pub location: Option<Location>,
    /// The invalid field, its value, and the rule for valid values.
    pub problem: String,
}

/// A location in a text as line and column, both counted from 1. Columns count characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Location {
    /// The line, counted from 1.
    pub line: usize,
    /// The position of the character in the line, counted from 1.
    pub column: usize,
}

impl Location {
    /// The beginning of a text.
    pub(crate) const START: Location = Location { line: 1, column: 1 };

    /// Returns the location of a byte in the text.
    pub fn of_byte(text: &[u8], byte: usize) -> Location {
        let before = &text[..byte.min(text.len())];
        let line_start = before.iter().rposition(|b| *b == b'\n').map_or(0, |newline| newline + 1);
        let line = before[..line_start].iter().filter(|b| **b == b'\n').count() + 1;
        let line_text = String::from_utf8_lossy(&before[line_start..]);
        // Readers do not count a byte order mark as a character.
        let column = line_text.trim_start_matches('\u{feff}').chars().count() + 1;
        Location { line, column }
    }
}

impl FileError {
    /// Creates an error about the whole file. Characters of `problem` that cannot be seen are escaped, and it is
    /// shortened (see [`legible()`]).
    pub fn of_file(path: &Path, problem: impl Into<String>) -> FileError {
        let problem = legible(&problem.into());
        FileError { file: legible_name(path), location: None, problem }
    }

    /// Creates an error about a location in the file.
    pub(crate) fn at(path: &Path, location: Location, problem: impl Into<String>) -> FileError {
        FileError { location: Some(location), ..FileError::of_file(path, problem) }
    }

    /// Creates an error about a file that cannot be read, with the system's reason.
    pub fn unreadable(path: &Path, error: &io::Error) -> FileError {
        FileError::of_file(path, format!("cannot be read: {}", reason(error)))
    }

    /// Creates an error about a file that cannot be written, with the system's reason. Returns the inner error
    /// if it is about a file, which was written at the same time.
    pub fn unwritable(path: &Path, error: &io::Error) -> FileError {
        let inner = error.get_ref().and_then(|inner| inner.downcast_ref::<FileError>());
        let of_path = || FileError::of_file(path, format!("cannot be written: {}", reason(error)));
        inner.cloned().unwrap_or_else(of_path)
    }
}

/// Returns the system's message for an error without the error number, which does not help users.
fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    match error.kind() {
        io::ErrorKind::FileTooLarge => {
            "the file may not become larger, by ulimit -f or on this disk".to_owned()
        }
        // Windows denies the access, or reports a shared or locked file.
        _ if cfg!(windows) && matches!(error.raw_os_error(), Some(5 | 32 | 33)) => {
            "access is denied, or another program has it open".to_owned()
        }
        // A reason of the program's own.
        io::ErrorKind::Other => text,
        _ => text.split(" (os error").next().unwrap_or_default().to_lowercase(),
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let FileError { file, location, problem } = self;
        let file = legible(file);
        match location {
            Some(Location { line, column }) => write!(f, "{file}:{line}:{column}: {problem}"),
            None => write!(f, "{file}: {problem}"),
        }
    }
}

impl std::error::Error for FileError {}

/// Returns the text on one line, shortened to fit into a message.
pub(crate) fn one_line(text: &str) -> String {
    const LONGEST: usize = 60;
    let words = text.split_whitespace().take(LONGEST);
    let mut chars = words.flat_map(|word| word.chars().chain([' ']));
    let line: String = chars.by_ref().take(LONGEST).collect();
    match chars.next() {
        Some(next) if next != ' ' || chars.next().is_some() => format!("{line}..."),
        _ => line.trim_end().to_owned(),
    }
}

/// Returns true for a character that a terminal or a window would interpret rather than show. These are
/// control characters; marks that change the writing direction (Unicode Standard Annex 9), which can
/// make one text look like another; and noncharacters, which XML does not allow.
pub fn is_hidden(c: char) -> bool {
    let is_of_direction = matches!(
        c,
        '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}'
    );
    let ends_a_line = matches!(c, '\u{2028}' | '\u{2029}');
    let is_none = matches!(c, '\u{fffe}' | '\u{ffff}');
    c.is_control() || is_of_direction || ends_a_line || is_none
}

/// Returns true for a character without a mark of its own, such as a byte order mark: those that Unicode lists
/// as `Default_Ignorable_Code_Point`, and the blank of Braille.
fn is_empty(c: char) -> bool {
    matches!(
        c,
        '\u{ad}' | '\u{34f}' | '\u{115f}' | '\u{1160}' | '\u{17b4}' | '\u{17b5}' | '\u{180b}'..='\u{180f}'
            | '\u{200b}'..='\u{200d}' | '\u{2060}'..='\u{206f}' | '\u{2800}' | '\u{3164}' | '\u{fe00}'..='\u{fe0f}'
            | '\u{feff}' | '\u{ffa0}' | '\u{fff0}'..='\u{fff8}' | '\u{1bca0}'..='\u{1bca3}'
            | '\u{1d173}'..='\u{1d17a}' | '\u{e0000}'..='\u{e0fff}'
    )
}

/// Returns the message with characters escaped that cannot be seen, as in `\u{202e}`. If it has more than 1000
/// characters, its middle is omitted, because the beginning names the field and the end gives the
/// remedy.
pub fn legible(message: &str) -> String {
    const LONGEST: usize = 1000;
    const GAP: &str = " ... ";
    let mut shown = String::with_capacity(message.len());
    for c in message.chars() {
        if is_hidden(c) || is_empty(c) { shown.extend(c.escape_default()) } else { shown.push(c) }
    }
    let count = shown.chars().count();
    if count <= LONGEST {
        return shown;
    }
    let end = (LONGEST - GAP.len()) / 2;
    let begin = shown.chars().take(end).collect::<String>();
    begin + GAP + &shown.chars().skip(count - end).collect::<String>()
}

/// Returns true if the character at this place has no mark of its own, but belongs to the spelling of a word or of an
/// emoji, as in Persian and Hindi names: a joiner, a non-joiner, or the choice of a coloured sign.
fn is_of_word(text: &str, at: usize, c: char) -> bool {
    let is_joined = |c: char| {
        matches!(c, '\u{600}'..='\u{dff}' | '\u{1780}'..='\u{17b3}' | '\u{2600}'..='\u{27bf}')
            || ('\u{1f000}'..='\u{1faff}').contains(&c)
    };
    let before = text[..at].chars().next_back();
    let after = text[at + c.len_utf8()..].chars().next();
    match c {
        '\u{200c}' | '\u{200d}' => {
            before.is_some_and(|c| is_joined(c) || c == '\u{fe0f}') && after.is_some_and(is_joined)
        }
        '\u{fe0f}' => before.is_some_and(is_joined),
        _ => false,
    }
}

/// Returns the name or path of a file so that all of it is seen: other characters than letters, signs and plain
/// spaces between them are escaped, as in `\u{202e}`, and bytes that are not UTF-8, as in `\xff`. Two unlike names
/// stay unlike, since a backslash in a name becomes two.
pub fn legible_name(name: impl AsRef<OsStr>) -> String {
    let mut shown = String::new();
    for chunk in name.as_ref().as_encoded_bytes().utf8_chunks() {
        let (text, mut from) = (chunk.valid(), 0);
        let kept = text.char_indices().filter(|(at, c)| is_of_word(text, *at, *c));
        for (at, c) in kept.map(|(at, c)| (at, Some(c))).chain([(text.len(), None)]) {
            // Quotation marks are seen as they are.
            let escaped = text[from..at].escape_debug().to_string();
            for c in escaped.replace(r"\'", "'").replace(r#"\""#, "\"").chars() {
                if is_empty(c) { shown.extend(c.escape_default()) } else { shown.push(c) }
            }
            shown.extend(c);
            from = at + c.map_or(0, char::len_utf8);
        }
        for byte in chunk.invalid() {
            let _ = write!(shown, r"\x{byte:02x}");
        }
    }
    // Nobody sees a space where nothing stands beside it.
    let inside = shown.trim_matches(' ');
    let spaces = |part: &str| r"\u{20}".repeat(part.len());
    if let Some((before, after)) = shown.split_once(inside) {
        shown = spaces(before) + inside + &spaces(after);
    }
    // Where a backslash separates folders, no name has one.
    if is_separator('\\') { shown.replace(r"\\", r"\") } else { shown }
}

/// Returns serde's message about JSON in our words, without its place.
pub(crate) fn of_json(error: &serde_json::Error) -> String {
    let mut said = error.to_string().replace('`', "");
    for (of_serde, ours) in [
        ("f64 values", "numbers"),
        ("floating point ", "number "),
        ("a sequence", "a list"),
        ("invalid length", "a list of length"),
        ("invalid type: sequence", "a list"),
        ("invalid type: map", "an object"),
    ] {
        said = said.replace(of_serde, ours);
    }
    let said = said.rsplit_once(" at line ").map_or(&*said, |(said, _)| said);
    if let Some(inside) = said.strip_prefix("EOF while parsing ") {
        return format!("the text ends inside {inside}: is all of the file there?");
    }
    if let Some(field) = said.strip_prefix("missing field ") {
        return format!("{field} is missing");
    }
    let Some((found, right)) = said.rsplit_once(", expected ") else {
        return said.replace("expected value", "a value must stand here");
    };
    let found = found.trim_start_matches("invalid type: ").trim_start_matches("invalid value: ");
    let right = match right {
        "f64" => "a number",
        "usize" | "u32" => "a whole number from 0",
        "a string" => "text in quotes",
        right if right.starts_with("struct") => "an object",
        right => right,
    };
    format!("{} is there: it must be {right}", one_line(found))
}

/// Returns the `known` names of which `word` may be a misspelling, the nearest first.
pub(crate) fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    // All names are shorter.
    const LONGEST: usize = 100;
    if word.len() > LONGEST {
        return Vec::new();
    }
    let word = word.to_lowercase();
    let mut near: Vec<(usize, &str)> =
        known.into_iter().map(|name| (osa_distance(&word, name), name)).collect();
    // Up to a third of the letters may be wrong.
    let most = |name: &str| word.chars().count().max(name.chars().count()) / 3;
    near.retain(|(distance, name)| *distance <= most(name));
    near.sort_by_key(|(distance, _)| *distance);
    near.into_iter().map(|(_, name)| name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn far_names_are_not_suggested() {
        let known = ["eye", "at", "up", "view", "basis"];
        assert_eq!(nearest("eyes", known), ["eye"]);
        assert_eq!(nearest("veiw", known), ["view"]);
        assert_eq!(nearest("UP", known), ["up"]);
        assert!(nearest("position", known).is_empty());
    }
}
