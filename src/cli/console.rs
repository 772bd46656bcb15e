//! Standard input, output and error; checks of output file names; the errors of commands and their exit
//! status.

use std::fmt;
use std::io::{self, BufWriter, Read, Write};
use std::path::Path;
use std::process::ExitCode;

use clap::builder::Styles;
use pinhole_exchange::{FileError, legible, legible_name, limits};
use serde::Serialize;

/// Returns true for `-`, which stands for standard input or output.
pub(super) fn is_standard(path: &Path) -> bool {
    path == Path::new("-")
}

/// Opens a file of at most `most` bytes, or standard input if the path is `-`. Also returns the name to use in
/// messages.
pub(super) fn open(path: &Path, most: u64) -> Result<(&Path, Box<dyn Read>), FileError> {
    match is_standard(path) {
        true => Ok((Path::new("standard input"), Box::new(io::stdin()))),
        false => Ok((path, limits::open(path, most)?)),
    }
}

/// Reads what [`open`] opens.
pub(super) fn read(path: &Path, most: u64) -> Result<(&Path, Vec<u8>), FileError> {
    let (path, source) = open(path, most)?;
    Ok((path, limits::read_from(source, path, most)?))
}

/// Returns the rows of a table as lines, in columns that are as wide as their widest cells.
pub(super) fn columns<const N: usize>(table: &[[String; N]]) -> Vec<String> {
    let width = |k: usize| table.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..N).map(width).collect();
    let line = |row: &[String; N]| {
        let cells = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:width$}"));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    table.iter().map(line).collect()
}

/// Returns a value as one JSON object with a line break. Numbers read back to the same `f64`.
pub(super) fn to_json(value: &impl Serialize) -> Result<String, CommandError> {
    let text = serde_json::to_string_pretty(value);
    Ok(text.map_err(|error| CommandError::Input(error.to_string()))? + "\n")
}

/// Prints the help or the version.
///
/// # Errors
/// Returns an error if standard output cannot be written.
pub fn print(asked: &clap::Error) -> Result<(), CommandError> {
    delivered(asked.print().and_then(|()| io::stdout().flush()))
}

/// Writes to standard output. If the reader stops reading, the error is [`CommandError::ReaderGone`],
/// which is not a failure.
pub(super) fn to_stdout(
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), CommandError> {
    let mut out = BufWriter::new(io::stdout().lock());
    delivered(write(&mut out).and_then(|()| out.flush()))
}

fn delivered(written: io::Result<()>) -> Result<(), CommandError> {
    written.map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => CommandError::ReaderGone,
        _ => FileError::unwritable(Path::new("standard output"), &error).into(),
    })
}

/// Prints a note to standard error.
pub(super) fn warn(note: &str) {
    // If standard error is closed, the text is lost.
    let _ = writeln!(io::stderr(), "note: {}", legible(note));
}

/// Rejects the path of an output with an extension other than `ending`. The error message begins with `what`.
pub(super) fn named(output: &Path, ending: &str, what: &str) -> Result<(), CommandError> {
    match output.extension() {
        Some(other) if !other.eq_ignore_ascii_case(ending) => {
            let stem = output.with_extension(ending);
            refused(format!("{what}: not {} but {}", output.display(), stem.display()))
        }
        _ => Ok(()),
    }
}

/// The reason why a command failed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CommandError {
    /// The input is at fault: exit status 1.
    Input(String),
    /// The arguments are invalid or cannot be combined: exit status 2.
    Arguments(String),
    /// The answers were graded, and not all of them are right: exit status 1, without a message.
    Disagrees,
    /// The answers or the scene cannot be read: exit status 2.
    Unreadable(String),
    /// The reader of standard output has stopped reading. This is not a failure.
    ReaderGone,
}

/// Returns an error about the arguments.
pub(super) fn refused<T>(problem: impl Into<String>) -> Result<T, CommandError> {
    Err(CommandError::Arguments(problem.into()))
}

impl fmt::Display for CommandError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CommandError::Input(message)
            | CommandError::Arguments(message)
            | CommandError::Unreadable(message) => f.write_str(message),
            CommandError::Disagrees => f.write_str("not all answers agree"),
            CommandError::ReaderGone => f.write_str("nobody reads standard output"),
        }
    }
}

impl std::error::Error for CommandError {}

impl From<FileError> for CommandError {
    fn from(error: FileError) -> Self {
        CommandError::Input(error.to_string())
    }
}

/// Prints a command's error to standard error and returns the exit status.
pub fn exit_code(result: Result<(), CommandError>) -> ExitCode {
    let status = match &result {
        Ok(()) | Err(CommandError::ReaderGone) => return ExitCode::SUCCESS,
        Err(CommandError::Disagrees) => return ExitCode::from(1),
        Err(CommandError::Input(_)) => 1,
        Err(CommandError::Arguments(_) | CommandError::Unreadable(_)) => 2,
    };
    if let Err(error) = result {
        let styles = Styles::styled();
        let (style, error) = (styles.get_error(), error.to_string());
        // The message looks like those of clap. If standard error is closed too, only the exit status
        // reports the error.
        let _ = writeln!(anstream::stderr(), "{style}error:{style:#} {}", legible(&error));
    }
    ExitCode::from(status)
}

/// Returns the error for a scene whose camera or objects are invalid.
pub(super) fn scene_fault(scene: &Path, error: impl fmt::Display) -> CommandError {
    let name = if is_standard(scene) { Path::new("standard input") } else { scene };
    CommandError::Input(format!("{}: {error}", legible_name(name)))
}

/// Returns the error for a command that requires a feature that this build lacks.
pub(super) fn not_built(what: &str, feature: &str) -> CommandError {
    CommandError::Input(format!(
        "this build has no {what}: it was built without the feature {feature}"
    ))
}

/// Returns the error for a file whose contents could not be computed.
pub(super) fn unmade(path: &Path, error: &dyn fmt::Display) -> CommandError {
    FileError::of_file(path, format!("cannot be made: {error}")).into()
}
