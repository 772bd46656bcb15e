//! The `pinhole` program.

use std::process::ExitCode;

fn main() -> ExitCode {
    pinhole::platform::main()
}
