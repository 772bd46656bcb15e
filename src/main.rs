//! The `pinhole` program: arguments, then the window or a headless command.

use std::process::ExitCode;

use clap::Parser;
use pinhole::cli::arguments::Arguments;
use pinhole::{cli, model, platform};

fn main() -> ExitCode {
    model::panics::watch();
    platform::signals::watch();
    let Arguments { command, window } = Arguments::parse();
    cli::exit_code(match command {
        Some(command) => cli::run(&command),
        None => platform::program::run(&window),
    })
}
