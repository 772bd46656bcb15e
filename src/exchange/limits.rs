//! Limits on the size of inputs. Larger inputs are rejected with a message that states the limit.

use std::hint::black_box;
use std::io::{self, Read};
use std::path::Path;

use crate::FileError;
use crate::host::host;

/// Maximum size in bytes of a text that people write, such as a scene or a lesson, and of the program's own
/// state. It is parsed as a whole, which takes up to 300 times as much memory.
pub const TEXT: u64 = 2 << 20;

/// Maximum size in bytes of another program's file, of codes, and of what goes into a page.
pub const FOREIGN: u64 = 64 << 20;

/// Maximum number of values in another program's file that is parsed as a whole.
pub const VALUES: usize = 1_000_000;

/// Maximum size in bytes of a table, or of a picture to be graded.
pub const TABLE: u64 = 1 << 30;

/// Maximum size of a pasted text in bytes.
pub const PASTE: usize = 128 << 10;

/// Maximum size of a row of a table in bytes.
pub const ROW: usize = 64 << 10;

/// Maximum number of rows in a table.
pub const ROWS: usize = 10_000_000;

/// Maximum nesting depth of brackets, which is far more than real files need.
pub const NESTING: usize = 64;

/// Checks that there is enough memory for `what`, which takes this many bytes.
///
/// # Errors
/// Returns [`too_little_memory`] if the system does not give so much memory.
pub fn memory(what: &str, bytes: u64) -> Result<(), String> {
    let size = usize::try_from(bytes).unwrap_or(usize::MAX);
    let mut memory = Vec::<u8>::new();
    let reserved = memory.try_reserve_exact(size);
    // The compiler removes an allocation that nobody uses.
    black_box(&memory);
    reserved.map_err(|_| too_little_memory(what, bytes))
}

/// Returns the reason why there is no room for `what`, which takes this many bytes: the error of a buffer's
/// `try_reserve`.
pub fn too_little_memory(what: &str, bytes: u64) -> String {
    format!("there is too little memory: {what} takes {} MB", bytes.div_ceil(1_000_000))
}

/// Returns the error about a file of which at most `most` bytes are read.
pub(crate) fn too_large(path: &Path, most: u64) -> FileError {
    let right = match most {
        TEXT => ". Many spheres belong in a table: spheres = \"file.csv\"",
        _ => "",
    };
    FileError::of_file(path, format!("it is too large: at most {} MiB are read{right}", most >> 20))
}

/// Opens a file of at most `most` bytes.
///
/// # Errors
/// Returns the errors of [`Host::open`](crate::host::Host::open), or an error if the file is larger.
pub fn open(path: &Path, most: u64) -> Result<Box<dyn Read>, FileError> {
    match host().stamp(path) {
        Some(stamp) if stamp.length > most => Err(too_large(path, most)),
        _ => host().open(path),
    }
}

/// Reads a file of at most `most` bytes.
///
/// # Errors
/// Returns the errors of [`open`] and [`read_from`].
pub fn read(path: &Path, most: u64) -> Result<Vec<u8>, FileError> {
    read_from(open(path, most)?, path, most)
}

/// Returns an error if these first bytes are those of a text in UTF-16.
pub(crate) fn not_utf_16(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    match bytes {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => {
            Err(FileError::of_file(path, "it is text in UTF-16: save it as UTF-8"))
        }
        _ => Ok(()),
    }
}

/// Reads a text file of at most [`TEXT`] bytes.
///
/// # Errors
/// Returns the errors of [`read_text_of`].
pub fn read_text(path: &Path) -> Result<String, FileError> {
    read_text_of(path, TEXT)
}

/// Reads a text file of at most `most` bytes.
///
/// # Errors
/// Returns the errors of [`read`], or an error if the text is not UTF-8.
pub fn read_text_of(path: &Path, most: u64) -> Result<String, FileError> {
    String::from_utf8(read(path, most)?).map_err(|error| {
        let error = io::Error::new(io::ErrorKind::InvalidData, error.utf8_error());
        FileError::unreadable(path, &error)
    })
}

/// Reads at most `most` bytes from a source. `path` is its name in messages.
///
/// # Errors
/// Returns an error if reading fails, if the source contains more bytes, or if it is text in UTF-16.
pub fn read_from(source: impl Read, path: &Path, most: u64) -> Result<Vec<u8>, FileError> {
    let mut bytes = Vec::new();
    let read = source.take(most + 1).read_to_end(&mut bytes);
    read.map_err(|error| FileError::unreadable(path, &error))?;
    if bytes.len() as u64 > most {
        return Err(too_large(path, most));
    }
    not_utf_16(path, &bytes)?;
    Ok(bytes)
}
