//! The program in a window of that screen.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus};
use std::thread::sleep;
use std::time::Duration;

use egui::{Pos2, Vec2, vec2};
use pinhole_exchange::scenes::BuiltinScene;

use crate::screen::{Running, Screen, signal, wait_for};

/// One way to start the program.
pub(crate) struct Setting<'a> {
    pub(crate) name: &'a str,
    pub(crate) arguments: &'a [&'a str],
    pub(crate) environment: &'a [(&'a str, &'a str)],
    /// What the program then says that drew it.
    pub(crate) drawn_by: &'a str,
}

/// Folders without any driver in them.
pub(crate) const NO_DRIVER: &[(&str, &str)] = &[
    ("VK_DRIVER_FILES", "/nonexistent"),
    ("VK_ICD_FILENAMES", "/nonexistent"),
    ("VK_LOADER_DRIVERS_DISABLE", "*"),
    ("LIBGL_DRIVERS_PATH", "/nonexistent"),
    ("GBM_BACKENDS_PATH", "/nonexistent"),
    ("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"),
];

pub(crate) fn binary() -> PathBuf {
    std::env::var_os("PINHOLE_BINARY").map_or(env!("CARGO_BIN_EXE_pinhole").into(), PathBuf::from)
}

/// Writes a built-in scene into a folder, as a file that may be changed.
pub(crate) fn built_in(folder: &Path, name: &str) -> PathBuf {
    let path = folder.join("scene.toml");
    fs::write(&path, BuiltinScene::find(name).unwrap().text).unwrap();
    path
}

/// The window.
pub(crate) struct Window<'a> {
    pub(crate) screen: &'a Screen,
    process: Running,
    id: String,
}

impl<'a> Window<'a> {
    /// Opens it with these arguments besides the setting's; it has the keyboard.
    pub(crate) fn open(
        screen: &'a Screen,
        arguments: &[&OsStr],
        state: &Path,
        setting: &Setting,
    ) -> Window<'a> {
        Window::open_by(Command::new(binary()), screen, arguments, state, setting)
    }

    /// Opens it by a command that may say where its messages go.
    pub(crate) fn open_by(
        mut command: Command,
        screen: &'a Screen,
        arguments: &[&OsStr],
        state: &Path,
        setting: &Setting,
    ) -> Window<'a> {
        command.args(arguments).args(setting.arguments).envs(setting.environment.iter().copied());
        let process = command
            .env("DISPLAY", &screen.display)
            .env("DBUS_SESSION_BUS_ADDRESS", &screen.bus.address)
            .env_remove("WAYLAND_DISPLAY")
            .env("WINIT_X11_SCALE_FACTOR", "1")
            .env("XDG_STATE_HOME", state)
            .env("PINHOLE_FRAME_TIMES", state.join("frames.csv"))
            .spawn()
            .unwrap();
        let process = Running(process);
        // The title carries the scene's name from the first frame on.
        let id = wait_for("the window", || {
            screen.try_say(&["search", "--onlyvisible", "--name", " - Pinhole"])
        });
        let id = id.lines().next().unwrap().to_owned();
        screen.press("windowactivate", &id);
        wait_for("the keyboard", || screen.try_say(&["getwindowfocus"]).filter(|has| *has == id));
        Window { screen, process, id }
    }

    /// Its width and height, in dots.
    pub(crate) fn size(&self) -> Vec2 {
        let geometry = self.screen.try_say(&["getwindowgeometry", "--shell", &self.id]).unwrap();
        let value = |key: &str| {
            let line = geometry.lines().find_map(|line| line.strip_prefix(key)).unwrap();
            line.trim_start_matches('=').parse::<f32>().unwrap()
        };
        vec2(value("WIDTH"), value("HEIGHT"))
    }

    pub(crate) fn drag_right(&self, from: Pos2, points: i32) {
        self.screen.mouse(&self.id, from);
        self.screen.press("mousedown", "1");
        for x in 1..=points {
            self.screen.mouse(&self.id, from + vec2(x as f32, 0.0));
            // Slow enough for a software adapter to answer each move with a frame of its own.
            sleep(Duration::from_millis(100));
        }
        self.screen.press("mouseup", "1");
        sleep(Duration::from_millis(300));
    }

    /// Drags by so much, from whole dots, as the mouse goes.
    pub(crate) fn drag(&self, from: Pos2, by: Vec2) {
        let [from, on_the_way @ ..] = way(from, by);
        self.screen.mouse(&self.id, from);
        sleep(Duration::from_millis(300));
        self.screen.press("mousedown", "1");
        for at in on_the_way {
            self.screen.mouse(&self.id, at);
            sleep(Duration::from_millis(100));
        }
        self.screen.press("mouseup", "1");
        sleep(Duration::from_millis(500));
    }

    /// Moves the mouse there.
    pub(crate) fn point_at(&self, at: Pos2) {
        self.screen.mouse(&self.id, at);
    }

    /// Presses a key, as xdotool calls it, here alone.
    pub(crate) fn key(&self, key: &str) {
        self.screen.press("key", key);
        sleep(Duration::from_millis(500));
    }

    /// Types a text, here alone.
    pub(crate) fn write(&self, text: &str) {
        assert!(self.screen.xdotool(&["type", "--delay", "30", text]).status.success());
        sleep(Duration::from_millis(500));
    }

    /// Its title.
    pub(crate) fn title(&self) -> Option<String> {
        self.screen.try_say(&["getwindowname", &self.id])
    }

    pub(crate) fn minimise(&self) {
        self.screen.press("windowminimize", &self.id);
    }

    /// Sends its process a signal, by the name that `kill` knows.
    pub(crate) fn signal(&self, name: &str) {
        signal(&self.process, name);
    }

    /// Has the X server end its connection.
    pub(crate) fn kill_client(&self) {
        self.screen.press("windowkill", &self.id);
    }

    /// Returns the memory that its process has in use, in MiB; `None` if it has ended.
    pub(crate) fn memory(&self) -> Option<usize> {
        let status = format!("/proc/{}/status", self.process.0.id());
        let status = fs::read_to_string(status).ok()?;
        let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
        Some(line.trim().trim_end_matches(" kB").parse::<usize>().unwrap() >> 10)
    }

    /// Waits until its process has ended, however.
    pub(crate) fn wait(&mut self) -> ExitStatus {
        wait_for("the program to end", || self.process.0.try_wait().unwrap())
    }

    /// Closes it by its key.
    pub(crate) fn quit(&mut self) {
        self.key("ctrl+q");
        let status = wait_for("the program to end", || self.process.0.try_wait().unwrap());
        assert!(status.success(), "{status}");
    }

    /// Turns the wheel by one step.
    pub(crate) fn scroll(&self, at: Pos2, up: bool) {
        self.screen.mouse(&self.id, at);
        self.screen.press("click", if up { "4" } else { "5" });
        sleep(Duration::from_millis(100));
    }

    pub(crate) fn click(&self, at: Pos2) {
        self.screen.mouse(&self.id, at);
        sleep(Duration::from_millis(100));
        self.screen.press("click", "1");
        sleep(Duration::from_millis(300));
    }
}

/// Where a drag begins, and where the mouse stops on its way.
pub(crate) fn way(from: Pos2, by: Vec2) -> [Pos2; 9] {
    let (from, by) = (from.floor(), by.round());
    std::array::from_fn(|k| (from + k as f32 / 8.0 * by).floor())
}
