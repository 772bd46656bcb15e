//! The `pinhole` program: arguments, then the window or a headless command.

use std::process::ExitCode;

use clap::Parser;
use pinhole::arguments::{Arguments, WindowArguments};
use pinhole::commands::{self, CommandError};

fn main() -> ExitCode {
    let Arguments { command, window } = Arguments::parse();
    commands::exit_code(match command {
        Some(command) => commands::run(&command),
        None => open_window(&window),
    })
}

fn open_window(arguments: &WindowArguments) -> Result<(), CommandError> {
    pinhole::window::run(arguments).map_err(|error| CommandError::Input(error.to_string()))
}
