//! A virtual screen with a window manager, driven by xdotool.

use std::fs;
use std::io::Read as _;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use egui::Pos2;
use tempfile::TempDir;

use crate::bus::Bus;

/// Width and height of the screen, in dots.
pub(crate) const SIZE: [u32; 2] = [1400, 1000];

/// A colour a dot, of rows from the top.
pub(crate) type Dots = Vec<Vec<[u8; 3]>>;

/// A process that ends with the test.
pub(crate) struct Running(pub(crate) Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Sends a process a signal, by the name that `kill` knows.
pub(crate) fn signal(to: &Running, name: &str) {
    let kill = Command::new("kill").args(["-s", name, &to.0.id().to_string()]).status();
    assert!(kill.unwrap().success());
}

/// A screen that nobody sees, with a window manager.
pub(crate) struct Screen {
    pub(crate) display: String,
    /// Where its programs meet.
    pub(crate) bus: Bus,
    _manager: Running,
    server: Running,
    folder: TempDir,
}

impl Screen {
    pub(crate) fn start() -> Screen {
        let folder = tempfile::tempdir().unwrap();
        let [width, height] = SIZE;
        let size = format!("{width}x{height}x24");
        let mut server = Command::new("Xvfb")
            // Without a reset when its only client so far goes away, under the feet of the next.
            .args(["-displayfd", "1", "-screen", "0", &size, "-nolisten", "tcp"])
            .arg("-noreset")
            // What is on the screen, as a file at all times.
            .arg("-fbdir")
            .arg(folder.path())
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
        let bus = Bus::start(&display, folder.path());
        let (server, _manager) = (Running(server), Running(manager));
        let screen = Screen { display, bus, _manager, server, folder };
        // Only a window manager knows of desktops.
        wait_for("the window manager", || screen.try_say(&["get_num_desktops"]));
        screen
    }

    /// What is on the screen now: red, green and blue of its dots, row by row.
    pub(crate) fn dots(&self) -> Dots {
        let file = fs::read(self.folder.path().join("Xvfb_screen0")).unwrap();
        // X11/XWDFile.h: numbers of four bytes, the colour map behind them, then the rows.
        let number =
            |k: usize| u32::from_be_bytes(file[4 * k..4 * k + 4].try_into().unwrap()) as usize;
        let (header, row_length, colors) = (number(0), number(12), number(19));
        assert_eq!([number(7), number(11)], [0, 32], "blue first, four bytes a dot");
        let rows = &file[header + 12 * colors..];
        let [width, height] = SIZE.map(|size| size as usize);
        let row = |y: usize| rows[y * row_length..][..4 * width].chunks_exact(4);
        (0..height).map(|y| row(y).map(|dot| [dot[2], dot[1], dot[0]]).collect()).collect()
    }

    /// Returns the picture of the screen as soon as it rests.
    pub(crate) fn settled(&self) -> Dots {
        wait_for("the picture to stay", || {
            let before = self.dots();
            sleep(Duration::from_secs(2));
            (before == self.dots()).then_some(before)
        })
    }

    pub(crate) fn xdotool(&self, arguments: &[&str]) -> Output {
        Command::new("xdotool").args(arguments).env("DISPLAY", &self.display).output().unwrap()
    }

    pub(crate) fn try_say(&self, arguments: &[&str]) -> Option<String> {
        let output = self.xdotool(arguments);
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
    }

    /// Ends the server as if it had crashed.
    pub(crate) fn kill_server(&self) {
        signal(&self.server, "KILL");
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

/// Says in which pixels two pictures of the screen differ.
pub(crate) fn difference(a: &Dots, b: &Dots) -> String {
    let rows: Vec<usize> = (0..a.len()).filter(|&y| a[y] != b[y]).collect();
    let columns: Vec<usize> =
        (0..a[0].len()).filter(|&x| rows.iter().any(|&y| a[y][x] != b[y][x])).collect();
    let ends = |all: &[usize]| (all.first().copied(), all.last().copied());
    format!("differs in rows {:?}, columns {:?}", ends(&rows), ends(&columns))
}

#[track_caller]
pub(crate) fn wait_for<T>(what: &str, ready: impl FnMut() -> Option<T>) -> T {
    wait_or_say(what, ready, String::new)
}

/// Waits; if in vain, says what there is instead.
#[track_caller]
pub(crate) fn wait_or_say<T>(
    what: &str,
    mut ready: impl FnMut() -> Option<T>,
    instead: impl FnOnce() -> String,
) -> T {
    let start = Instant::now();
    loop {
        if let Some(value) = ready() {
            return value;
        }
        if start.elapsed() > Duration::from_secs(60) {
            panic!("waited in vain for {what} {}", instead());
        }
        sleep(Duration::from_millis(50));
    }
}
