//! The `pinhole` program: arguments, then the window or a headless command.

use std::process::ExitCode;

use clap::Parser;
use pinhole::cli::arguments::{Arguments, WindowArguments};
use pinhole::cli::{self, CommandError};

fn main() -> ExitCode {
    let Arguments { command, window } = Arguments::parse();
    cli::exit_code(match command {
        Some(command) => cli::run(&command),
        None => open_window(&window),
    })
}

fn open_window(arguments: &WindowArguments) -> Result<(), CommandError> {
    pinhole::platform::program::run(arguments)
        .map_err(|error| CommandError::Input(error.to_string()))
}
