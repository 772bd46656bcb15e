//! Standard output, standard error, and the names of files to write.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use super::error::CommandError;

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
