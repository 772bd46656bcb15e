//! Standard input, output and error, and the names of files to write.

use std::fs;
use std::io::{self, BufWriter, Read as _, Write};
use std::path::Path;

use pinhole_exchange::FileError;
use serde::Serialize;

use super::error::CommandError;

/// Reads a file, or standard input for `-`. Returns the name of the file in messages, too.
pub(super) fn read(path: &Path) -> Result<(&Path, Vec<u8>), FileError> {
    let (path, bytes) = if path == Path::new("-") {
        let mut bytes = Vec::new();
        let read = io::stdin().lock().read_to_end(&mut bytes);
        (Path::new("standard input"), read.map(|_| bytes))
    } else {
        (path, fs::read(path))
    };
    Ok((path, bytes.map_err(|error| FileError::unreadable(path, &error))?))
}

/// Returns a value as one JSON object and a line break. Numbers read back to the same `f64`.
pub(super) fn to_json(value: &impl Serialize) -> Result<String, CommandError> {
    let text = serde_json::to_string_pretty(value);
    Ok(text.map_err(|error| CommandError::Input(error.to_string()))? + "\n")
}

/// Writes to standard output, with care for a reader who has seen enough.
pub(super) fn to_stdout(
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), CommandError> {
    let mut out = BufWriter::new(io::stdout().lock());
    write(&mut out).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => CommandError::ReaderGone,
        _ => CommandError::Input(format!("standard output cannot be written: {error}")),
    })
}

/// Says on standard error what was done otherwise than one may think.
pub(super) fn warn(note: &str) {
    // Where standard error is closed, there is nobody to tell.
    let _ = writeln!(io::stderr(), "pinhole: note: {note}");
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
