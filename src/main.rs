//! The `pinhole` program: arguments, then the window or a headless command.

use std::process::ExitCode;

use clap::Parser;
use pinhole::cli::arguments::Arguments;
use pinhole::{cli, model, platform};

fn main() -> ExitCode {
    model::panics::watch();
    platform::signals::watch();
    let code = cli::exit_code(match Arguments::try_parse() {
        Ok(Arguments { command: Some(command), .. }) => cli::run(&command),
        Ok(Arguments { command: None, window }) => platform::program::run(&window),
        // What was asked for: the help, or the version.
        Err(asked) if !asked.use_stderr() => cli::print(&asked),
        Err(wrong) => wrong.exit(),
    });
    platform::signals::pass_on();
    code
}
