//! A session bus of the screen's own, on which the program meets a screen reader.

use std::io::{BufRead as _, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

use crate::screen::Running;

/// The bus; it starts the services of accessibility when somebody asks for them.
pub(crate) struct Bus {
    pub(crate) address: String,
    _process: Running,
}

impl Bus {
    /// Starts it with its files in `folder`, for the programs on a display.
    pub(crate) fn start(display: &str, folder: &Path) -> Bus {
        let mut process = Command::new("dbus-daemon")
            .args(["--session", "--nofork", "--print-address=1"])
            .env("DISPLAY", display)
            // Whoever runs this has a desktop and settings that it must not meet.
            .env("XDG_RUNTIME_DIR", folder)
            .env("XDG_CACHE_HOME", folder)
            .env("GSETTINGS_BACKEND", "memory")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("dbus-daemon is installed: .ci/run does it");
        let mut address = String::new();
        BufReader::new(process.stdout.take().unwrap()).read_line(&mut address).unwrap();
        Bus { address: address.trim().to_owned(), _process: Running(process) }
    }
}
