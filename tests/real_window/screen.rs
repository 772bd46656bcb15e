//! A virtual screen with a window manager, driven by xdotool.

use std::io::Read as _;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use egui::Pos2;

/// Width and height of the screen, in dots.
pub(crate) const SIZE: [u32; 2] = [1400, 1000];

/// A process that ends with the test.
pub(crate) struct Running(pub(crate) Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A screen that nobody sees, with a window manager.
pub(crate) struct Screen {
    pub(crate) display: String,
    _server: Running,
    _manager: Running,
}

impl Screen {
    pub(crate) fn start() -> Screen {
        let [width, height] = SIZE;
        let size = format!("{width}x{height}x24");
        let mut server = Command::new("Xvfb")
            // Without a reset when its only client so far goes away, under the feet of the next.
            .args(["-displayfd", "1", "-screen", "0", &size, "-nolisten", "tcp"])
            .arg("-noreset")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Xvfb is installed: .ci/run does it");
        let mut number = String::new();
        let mut byte = [0];
        let mut output = server.stdout.take().unwrap();
        while output.read(&mut byte).unwrap() == 1 && byte[0] != b'\n' {
            number.push(char::from(byte[0]));
        }
        let display = format!(":{number}");
        let manager = Command::new("openbox")
            .env("DISPLAY", &display)
            .stderr(Stdio::null())
            .spawn()
            .expect("openbox is installed: .ci/run does it");
        let screen = Screen { display, _server: Running(server), _manager: Running(manager) };
        // Only a window manager knows of desktops.
        wait_for("the window manager", || screen.try_say(&["get_num_desktops"]));
        screen
    }

    pub(crate) fn xdotool(&self, arguments: &[&str]) -> Output {
        Command::new("xdotool").args(arguments).env("DISPLAY", &self.display).output().unwrap()
    }

    pub(crate) fn try_say(&self, arguments: &[&str]) -> Option<String> {
        let output = self.xdotool(arguments);
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
    }

    /// Moves the mouse to a position of a window.
    pub(crate) fn mouse(&self, window: &str, to: Pos2) {
        let (x, y) = (to.x.floor().to_string(), to.y.floor().to_string());
        assert!(self.xdotool(&["mousemove", "--window", window, &x, &y]).status.success());
    }

    pub(crate) fn press(&self, what: &str, button_or_key: &str) {
        assert!(self.xdotool(&[what, button_or_key]).status.success());
    }
}

pub(crate) fn wait_for<T>(what: &str, mut ready: impl FnMut() -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        if let Some(value) = ready() {
            return value;
        }
        assert!(start.elapsed() < Duration::from_secs(60), "waited in vain for {what}");
        sleep(Duration::from_millis(50));
    }
}
