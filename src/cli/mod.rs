//! The headless commands, one a file. None of them touches a display or a graphics driver.
//!
//! They share `load`, `console` (with the errors) and `progress`.

pub mod arguments;
mod check;
mod console;
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
use self::console::to_stdout;
pub use self::console::{CommandError, exit_code, print};
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
        Command::Report(_) => Err(console::not_built("report", "report")),
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
