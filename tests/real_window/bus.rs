//! A session bus of the screen's own, on which the program meets a screen reader.

use std::fs;
use std::io::{BufRead as _, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

use crate::screen::Running;

/// A session bus that starts nothing but accessibility: whoever runs this may have a desktop, whose
/// file dialog nobody would answer.
const CONFIG: &str = r#"<busconfig>
  <type>session</type>
  <listen>unix:tmpdir=/tmp</listen>
  <auth>EXTERNAL</auth>
  <servicedir>services</servicedir>
  <policy context="default">
    <allow send_destination="*" eavesdrop="true"/>
    <allow eavesdrop="true"/>
    <allow own="*"/>
  </policy>
</busconfig>
"#;

/// The bus; it starts the services of accessibility when somebody asks for them.
pub(crate) struct Bus {
    pub(crate) address: String,
    _process: Running,
}

impl Bus {
    /// Starts it with its files in `folder`, for the programs on a display.
    pub(crate) fn start(display: &str, folder: &Path) -> Bus {
        let services = folder.join("services");
        fs::create_dir(&services).unwrap();
        let accessibility = "org.a11y.Bus.service";
        let installed = Path::new("/usr/share/dbus-1/services").join(accessibility);
        fs::copy(installed, services.join(accessibility))
            .expect("at-spi2-core is installed: .ci/run does it");
        let config = folder.join("bus.conf");
        fs::write(&config, CONFIG).unwrap();
        let mut process = Command::new("dbus-daemon")
            .args(["--nofork", "--print-address=1", "--config-file"])
            .arg(&config)
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
