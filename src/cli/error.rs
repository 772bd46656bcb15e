//! The errors of commands, and the exit status that tells them.

use super::console::is_standard;
use std::fmt;
use std::io::Write as _;
use std::path::Path;
use std::process::ExitCode;

use clap::builder::Styles;
use pinhole_exchange::{FileError, legible};

/// The reason why a command did not do what it was asked to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CommandError {
    /// The input is at fault: exit status 1.
    Input(String),
    /// The arguments do not go together: exit status 2.
    Arguments(String),
    /// The answers were graded, and not all of them agree: exit status 1, and no message.
    Disagrees,
    /// There is nothing to grade, or nothing to grade it by: exit status 2.
    Unreadable(String),
    /// Nobody reads standard output any more. Nothing is wrong.
    ReaderGone,
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

/// The exit status of a command; its error goes to standard error.
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
        // As clap writes its own. Where standard error is closed too, the status has to do.
        let _ = writeln!(anstream::stderr(), "{style}error:{style:#} {}", legible(&error));
    }
    ExitCode::from(status)
}

/// Turns what is wrong with a scene's camera or objects into what is wrong with the scene.
pub(super) fn scene_fault(scene: &Path, error: impl fmt::Display) -> CommandError {
    let name = if is_standard(scene) { Path::new("standard input") } else { scene };
    CommandError::Input(format!("{}: {error}", name.display()))
}

/// The error of a command that this build lacks, as it was built without a feature.
pub(super) fn not_built(what: &str, feature: &str) -> CommandError {
    CommandError::Input(format!(
        "this build has no {what}: it was built without the feature {feature}"
    ))
}

/// A file whose bytes could not be made.
pub(super) fn unmade(path: &Path, error: &dyn fmt::Display) -> CommandError {
    FileError::of_file(path, format!("cannot be made: {error}")).into()
}
