//! The program in a window of that screen, and the same window in memory.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread::sleep;
use std::time::Duration;

use egui::accesskit::Role;
use egui::{Pos2, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::files::OpenDocument;
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;
use pinhole_core::{ImageSize, Pixel};
use pinhole_exchange::scenes::SceneSource;

use crate::screen::{Running, Screen, wait_for};
use crate::whole_window;

/// One way to start the program.
pub(crate) struct Setting {
    pub(crate) name: &'static str,
    pub(crate) arguments: &'static [&'static str],
    pub(crate) environment: &'static [(&'static str, &'static str)],
    /// What the program then says that drew it.
    pub(crate) drawn_by: &'static str,
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

/// The window on `scene`, and where everything in it is.
pub(crate) struct Window<'a> {
    pub(crate) screen: &'a Screen,
    process: Running,
    id: String,
    /// It does what is said here; by [`Window::drag`] both do the same.
    pub(crate) layout: Harness<'static, App>,
}

impl<'a> Window<'a> {
    pub(crate) fn open(
        screen: &'a Screen,
        scene: &Path,
        state: &Path,
        setting: &Setting,
    ) -> Window<'a> {
        let mut command = Command::new(binary());
        command.arg(scene).args(setting.arguments).envs(setting.environment.iter().copied());
        let process = command
            .env("DISPLAY", &screen.display)
            .env_remove("WAYLAND_DISPLAY")
            .env("WINIT_X11_SCALE_FACTOR", "1")
            .env("XDG_STATE_HOME", state)
            .env("PINHOLE_FRAME_TIMES", state.join("frames.csv"))
            .spawn()
            .unwrap();
        let process = Running(process);
        // The title carries the scene's name from the first frame on.
        let id = wait_for("the window", || {
            screen.try_say(&["search", "--onlyvisible", "--name", "scene.toml - Pinhole"])
        });
        let id = id.lines().next().unwrap().to_owned();
        screen.press("windowactivate", &id);
        sleep(Duration::from_secs(2));
        let geometry = screen.try_say(&["getwindowgeometry", "--shell", &id]).unwrap();
        let value = |key: &str| {
            let line = geometry.lines().find_map(|line| line.strip_prefix(key)).unwrap();
            line.trim_start_matches('=').parse::<f32>().unwrap()
        };
        let layout = laid_out(scene, vec2(value("WIDTH"), value("HEIGHT")));
        Window { screen, process, id, layout }
    }

    pub(crate) fn position(&self, role: Role, label: &str, share: Vec2) -> Pos2 {
        let rect = self.layout.get_by_role_and_label(role, label).rect();
        rect.min + share * rect.size()
    }

    /// The pixel of the camera view at a position of the window.
    pub(crate) fn pixel_at(&self, at: Pos2, image: ImageSize) -> Pixel {
        let rect = self.layout.get_by_role_and_label(Role::Image, "Camera view").rect();
        let share = (at - rect.min) / rect.size();
        Pixel {
            row: (share.y * image.height() as f32) as u32,
            column: (share.x * image.width() as f32) as u32,
        }
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

    /// Drags by so much, with the mouse here and in memory; from whole dots, as the mouse goes.
    pub(crate) fn drag(&mut self, from: Pos2, by: Vec2) {
        const MOVES: u8 = 8;
        let (from, by) = (from.floor(), by.round());
        let on_the_way = |k: u8| (from + f32::from(k) / f32::from(MOVES) * by).floor();
        self.screen.mouse(&self.id, from);
        sleep(Duration::from_millis(300));
        self.screen.press("mousedown", "1");
        for k in 1..=MOVES {
            self.screen.mouse(&self.id, on_the_way(k));
            sleep(Duration::from_millis(100));
        }
        self.screen.press("mouseup", "1");
        sleep(Duration::from_millis(500));
        self.layout.hover_at(from);
        self.layout.run();
        self.layout.drag_at(from);
        self.layout.run();
        for k in 1..=MOVES {
            self.layout.hover_at(on_the_way(k));
            self.layout.run();
        }
        self.layout.drop_at(from + by);
        self.layout.run();
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

    /// Closes it by its key.
    pub(crate) fn quit(&mut self) {
        self.key("ctrl+q");
        let status = wait_for("the program to end", || self.process.0.try_wait().unwrap());
        assert!(status.success(), "{status}");
    }

    pub(crate) fn click(&self, at: Pos2) {
        self.screen.mouse(&self.id, at);
        sleep(Duration::from_millis(100));
        self.screen.press("click", "1");
        sleep(Duration::from_millis(300));
    }
}

/// The same window in memory: where each label is.
fn laid_out(scene: &Path, size: Vec2) -> Harness<'static, App> {
    let source = SceneSource::File(scene.to_owned());
    let open = OpenDocument::new(source.load().unwrap(), source);
    let mut layout = Harness::builder()
        .with_size(size)
        .with_max_steps(30)
        .with_context_setup(|ctx| App::set_up(ctx, &Default::default()))
        .build_ui_state(whole_window::show, App::new(open, Remembered::default(), None));
    layout.run();
    layout
}
