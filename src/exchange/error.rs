//! Errors of files.

use std::fmt;
use std::io;
use std::path::Path;

/// A file that cannot be read or written, and why.
///
/// Printed as `room.toml:12:10: sphere[3].radius is -1.0: it must be greater than 0`: file, line,
/// column, then field, value, and what would be right.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileError {
    /// The file, as the user gave it.
    pub file: String,
    /// Place in the file; `None` for the file as a whole.
    pub location: Option<Location>,
    /// The field at fault, its value, and what would be right.
    pub problem: String,
}

/// A location in a text: line and column, both counted from 1; a column is a character.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Location {
    /// The line.
    pub line: usize,
    /// The character in the line.
    pub column: usize,
}

impl Location {
    /// The beginning of a text.
    pub(crate) const START: Location = Location { line: 1, column: 1 };

    /// The position of a byte of the text.
    pub fn of_byte(text: &[u8], byte: usize) -> Location {
        let before = &text[..byte.min(text.len())];
        let line_start = before.iter().rposition(|b| *b == b'\n').map_or(0, |newline| newline + 1);
        let line = before[..line_start].iter().filter(|b| **b == b'\n').count() + 1;
        let line_text = String::from_utf8_lossy(&before[line_start..]);
        // A byte order mark is no character of the first line to its reader.
        let column = line_text.trim_start_matches('\u{feff}').chars().count() + 1;
        Location { line, column }
    }
}

impl FileError {
    /// About the file as a whole.
    pub fn of_file(path: &Path, problem: impl Into<String>) -> FileError {
        FileError { file: path.display().to_string(), location: None, problem: problem.into() }
    }

    /// About a position in the file.
    pub(crate) fn at(path: &Path, location: Location, problem: impl Into<String>) -> FileError {
        FileError { location: Some(location), ..FileError::of_file(path, problem) }
    }

    /// A file that the system does not let us read.
    pub fn unreadable(path: &Path, error: &io::Error) -> FileError {
        FileError::of_file(path, format!("cannot be read: {}", reason(error)))
    }

    /// A file that the system does not let us write.
    pub fn unwritable(path: &Path, error: &io::Error) -> FileError {
        FileError::of_file(path, format!("cannot be written: {}", reason(error)))
    }
}

/// The system's words, without the error number, which helps nobody.
fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    text.split(" (os error").next().unwrap_or_default().to_lowercase()
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let FileError { file, location, problem } = self;
        match location {
            Some(Location { line, column }) => write!(f, "{file}:{line}:{column}: {problem}"),
            None => write!(f, "{file}: {problem}"),
        }
    }
}

impl std::error::Error for FileError {}

/// A text on one line, and no longer than a message may be.
pub(crate) fn one_line(text: &str) -> String {
    const LONGEST: usize = 60;
    let line = text.split_whitespace().take(LONGEST).collect::<Vec<_>>().join(" ");
    match line.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}...", &line[..end]),
        None => line,
    }
}
