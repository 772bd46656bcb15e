//! The `pinhole` program. Parses the arguments, and opens the window or runs a headless command.

use std::process::ExitCode;

use clap::Parser;
use pinhole::cli::arguments::Arguments;
use pinhole::{cli, model, platform};

fn main() -> ExitCode {
    model::fault::watch();
    platform::signals::watch();
    let parsed = Arguments::try_parse();
    let is_no_command = match &parsed {
        Ok(parsed) => parsed.command.is_none(),
        Err(asked) => asked.use_stderr(),
    };
    let first = std::env::args_os().nth(1).filter(|_| is_no_command);
    if let Some(wrong) = first.and_then(|first| cli::mistyped(&first)) {
        wrong.exit();
    }
    let code = cli::exit_code(match parsed {
        Ok(Arguments { command: Some(command), .. }) => cli::run(&command),
        Ok(Arguments { command: None, window }) => platform::run(&window),
        // Not an error: the user asked for the help or the version.
        Err(asked) if !asked.use_stderr() => cli::print(&asked),
        Err(wrong) => wrong.exit(),
    });
    platform::signals::pass_on();
    code
}
