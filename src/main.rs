//! The `pinhole` program.

// A double click on Windows opens no terminal.
#![cfg_attr(windows, windows_subsystem = "windows")]

use std::process::ExitCode;

fn main() -> ExitCode {
    pinhole::platform::main()
}
