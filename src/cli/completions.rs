//! `pinhole completions`: what a shell reads to complete commands, options and scenes.

use super::console::to_stdout;
use super::error::CommandError;
use crate::cli::arguments::{CompletionsArguments, Shell};

pub(super) fn run(arguments: &CompletionsArguments) -> Result<(), CommandError> {
    let script = match arguments.shell {
        Shell::Bash => include_str!("../../assets/completions/pinhole.bash"),
        Shell::Zsh => include_str!("../../assets/completions/_pinhole"),
        Shell::Fish => include_str!("../../assets/completions/pinhole.fish"),
    };
    to_stdout(|out| out.write_all(script.as_bytes()))
}
