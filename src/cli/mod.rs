//! The headless commands, one a file. None of them touches a display or a graphics driver.
//!
//! `error`, `load`, `console` and `progress` are what they share.

pub mod arguments;
mod check;
mod console;
mod error;
mod export;
mod figure;
mod import;
mod inspect;
mod load;
mod progress;
pub mod render;
#[cfg(feature = "report")]
mod report;
mod scenes;
mod trace;

pub use self::arguments::mistyped;
pub use self::console::print;
use self::console::to_stdout;
pub use self::error::{CommandError, exit_code};
use crate::cli::arguments::{Command, Shell};

/// Runs a command.
///
/// # Errors
/// Returns the reason if it could not be done.
pub fn run(command: &Command) -> Result<(), CommandError> {
    match command {
        Command::Scenes(arguments) => scenes::run(arguments),
        Command::Inspect(arguments) => inspect::run(arguments),
        Command::Render(arguments) => render::run(arguments),
        Command::Trace(arguments) => trace::run(arguments),
        Command::Check(arguments) => check::run(arguments),
        #[cfg(feature = "report")]
        Command::Report(arguments) => report::run(arguments),
        #[cfg(not(feature = "report"))]
        Command::Report(_) => Err(error::not_built("report", "report")),
        Command::Figure(arguments) => figure::run(arguments),
        Command::Export(arguments) => export::run(arguments),
        Command::Import(arguments) => import::run(arguments),
        Command::Completions(arguments) => complete(arguments.shell),
    }
}

/// `pinhole completions`: what a shell reads to complete commands, options and scenes.
fn complete(shell: Shell) -> Result<(), CommandError> {
    let script = match shell {
        Shell::Bash => include_str!("../../assets/completions/pinhole.bash"),
        Shell::Zsh => include_str!("../../assets/completions/_pinhole"),
        Shell::Fish => include_str!("../../assets/completions/pinhole.fish"),
    };
    to_stdout(|out| out.write_all(script.as_bytes()))
}
