//! The headless commands, one a file. None of them touches a display or a graphics driver.
//!
//! `error`, `load`, `console`, `standard`, `size` and `progress` are what they share.

pub mod arguments;
mod check;
mod completions;
mod console;
mod error;
mod export;
mod figure;
mod import;
mod inspect;
mod load;
mod mistyped;
mod progress;
mod render;
pub mod render_view;
#[cfg(feature = "report")]
mod report;
mod scenes;
mod size;
mod standard;
mod trace;

pub use self::console::print;
pub use self::error::{CommandError, exit_code};
pub use self::mistyped::mistyped;
use crate::cli::arguments::Command;

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
        Command::Completions(arguments) => completions::run(arguments),
    }
}
