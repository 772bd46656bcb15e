//! Standard input, output and error, and the names of files to write.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use pinhole_exchange::{FileError, legible, limits};
use serde::Serialize;

use super::error::CommandError;

/// Returns true for `-`, which stands for standard input or output.
pub(super) fn is_standard(path: &Path) -> bool {
    path == Path::new("-")
}

/// Reads a file of at most so many bytes, or standard input for `-`. Returns the name of the file in
/// messages, too.
pub(super) fn read(path: &Path, most: u64) -> Result<(&Path, Vec<u8>), FileError> {
    if is_standard(path) {
        let path = Path::new("standard input");
        return Ok((path, limits::read_from(io::stdin().lock(), path, most)?));
    }
    Ok((path, limits::read(path, most)?))
}

/// Returns a value as one JSON object and a line break. Numbers read back to the same `f64`.
pub(super) fn to_json(value: &impl Serialize) -> Result<String, CommandError> {
    let text = serde_json::to_string_pretty(value);
    Ok(text.map_err(|error| CommandError::Input(error.to_string()))? + "\n")
}

/// Prints the help or the version.
///
/// # Errors
/// Returns an error if it cannot be written.
pub fn print(asked: &clap::Error) -> Result<(), CommandError> {
    told(asked.print().and_then(|()| io::stdout().flush()))
}

/// Writes to standard output, with care for a reader who has seen enough.
pub(super) fn to_stdout(
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), CommandError> {
    let mut out = BufWriter::new(io::stdout().lock());
    told(write(&mut out).and_then(|()| out.flush()))
}

fn told(written: io::Result<()>) -> Result<(), CommandError> {
    written.map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => CommandError::ReaderGone,
        _ => FileError::unwritable(Path::new("standard output"), &error).into(),
    })
}

/// Says on standard error what was done otherwise than one may think.
pub(super) fn warn(note: &str) {
    // Where standard error is closed, there is nobody to tell.
    let _ = writeln!(io::stderr(), "note: {}", legible(note));
}

/// Refuses the name of another format: what it promises is not what would be in the file.
pub(super) fn named(output: &Path, ending: &str, what: &str) -> Result<(), CommandError> {
    match output.extension() {
        Some(other) if !other.eq_ignore_ascii_case(ending) => {
            let stem = output.with_extension(ending);
            let problem = format!("{what}: not {} but {}", output.display(), stem.display());
            Err(CommandError::Arguments(problem))
        }
        _ => Ok(()),
    }
}
