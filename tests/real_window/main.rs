//! The release binary in a real window: a virtual screen, a window manager, and a mouse.
//!
//! Ignored unless asked for, since it needs Xvfb, openbox and xdotool; `.ci/run` installs them and
//! sets `PINHOLE_BINARY`. Where to click is not written down here: the same window, laid out in
//! memory at the same size, says where each accessible label is.

#![allow(clippy::unwrap_used, reason = "a test that cannot drive its window has failed")]
#![allow(clippy::print_stdout, reason = "says what it ran on, and how fast")]

#[path = "support/whole_window.rs"]
mod whole_window;

use std::fs;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use egui::accesskit::Role;
use egui::{Pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::app::App;
use pinhole::files::OpenDocument;
use pinhole::formats::scene_argument::SceneSource;
use pinhole::formats::{builtin, scene_file};
use pinhole::store::{Remembered, RememberedRay, Store};
use pinhole_core::{ImageSize, Pixel, shortest};

/// Points the mouse moves in the long drag, one a frame.
const DRAG: i32 = 100;

/// A process that ends with the test.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A screen that nobody sees, with a window manager.
struct Screen {
    display: String,
    _server: Running,
    _manager: Running,
}

impl Screen {
    fn start() -> Screen {
        let mut server = Command::new("Xvfb")
            // Without a reset when its only client so far goes away, under the feet of the next.
            .args(["-displayfd", "1", "-screen", "0", "1400x1000x24", "-nolisten", "tcp"])
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

    fn xdotool(&self, arguments: &[&str]) -> Output {
        Command::new("xdotool").args(arguments).env("DISPLAY", &self.display).output().unwrap()
    }

    fn try_say(&self, arguments: &[&str]) -> Option<String> {
        let output = self.xdotool(arguments);
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
    }

    /// Moves the mouse to a place of a window.
    fn mouse(&self, window: &str, to: Pos2) {
        let (x, y) = (to.x.floor().to_string(), to.y.floor().to_string());
        assert!(self.xdotool(&["mousemove", "--window", window, &x, &y]).status.success());
    }

    fn press(&self, what: &str, button_or_key: &str) {
        assert!(self.xdotool(&[what, button_or_key]).status.success());
    }
}

fn wait_for<T>(what: &str, mut ready: impl FnMut() -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        if let Some(value) = ready() {
            return value;
        }
        assert!(start.elapsed() < Duration::from_secs(60), "waited in vain for {what}");
        sleep(Duration::from_millis(50));
    }
}

fn binary() -> PathBuf {
    std::env::var_os("PINHOLE_BINARY").map_or(env!("CARGO_BIN_EXE_pinhole").into(), PathBuf::from)
}

/// The window on `scene`, and where everything in it is.
struct Window<'a> {
    screen: &'a Screen,
    process: Running,
    id: String,
    layout: Harness<'static, App>,
}

impl<'a> Window<'a> {
    fn open(screen: &'a Screen, scene: &Path, state: &Path, setting: &Setting) -> Window<'a> {
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

    fn place(&self, role: Role, label: &str, share: egui::Vec2) -> Pos2 {
        let rect = self.layout.get_by_role_and_label(role, label).rect();
        rect.min + share * rect.size()
    }

    /// The pixel of the camera view at a place of the window.
    fn pixel_at(&self, at: Pos2, image: ImageSize) -> Pixel {
        let rect = self.layout.get_by_role_and_label(Role::Image, "Camera view").rect();
        let share = (at - rect.min) / rect.size();
        Pixel {
            row: (share.y * image.height() as f32) as u32,
            column: (share.x * image.width() as f32) as u32,
        }
    }

    fn drag_right(&self, from: Pos2, points: i32) {
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

    fn click(&self, at: Pos2) {
        self.screen.mouse(&self.id, at);
        sleep(Duration::from_millis(100));
        self.screen.press("click", "1");
        sleep(Duration::from_millis(300));
    }
}

/// The same window in memory: where each label is.
fn laid_out(scene: &Path, size: egui::Vec2) -> Harness<'static, App> {
    let source = SceneSource::File(scene.to_owned());
    let open = OpenDocument::new(source.load().unwrap(), source);
    let mut layout = Harness::builder()
        .with_size(size)
        .with_context_setup(|ctx| App::set_up(ctx, &Default::default()))
        .build_ui_state(whole_window::show, App::new(open, Remembered::default(), None));
    layout.run();
    layout
}

/// One way to start the program.
struct Setting {
    name: &'static str,
    arguments: &'static [&'static str],
    environment: &'static [(&'static str, &'static str)],
    /// What the program then says that drew it.
    drawn_by: &'static str,
}

/// Folders without any driver in them.
const NO_DRIVER: &[(&str, &str)] = &[
    ("VK_DRIVER_FILES", "/nonexistent"),
    ("VK_ICD_FILENAMES", "/nonexistent"),
    ("VK_LOADER_DRIVERS_DISABLE", "*"),
    ("LIBGL_DRIVERS_PATH", "/nonexistent"),
    ("GBM_BACKENDS_PATH", "/nonexistent"),
    ("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"),
];

fn drive(setting: &Setting) {
    println!("real window, {}: {}", setting.name, binary().display());
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("scene.toml");
    fs::write(&scene, builtin::find("canonical").unwrap().text).unwrap();
    let before = scene_file::load(&scene).unwrap();
    let screen = Screen::start();
    let mut window = Window::open(&screen, &scene, folder.path(), setting);

    window.drag_right(window.place(Role::SpinButton, "eye x", vec2(0.5, 0.5)), DRAG);
    // The mouse goes by whole dots, so the pixel is the one under such a dot.
    let at = window.place(Role::Image, "Camera view", vec2(0.25, 0.75)).floor();
    window.click(at);
    let pixel = window.pixel_at(at, before.camera.image);
    screen.press("key", "ctrl+s");
    let saved = wait_for("the saved file", || {
        let saved = scene_file::load(&scene).ok()?;
        (saved != before).then_some(saved)
    });
    sleep(Duration::from_millis(300));
    screen.press("key", "ctrl+q");
    let status = wait_for("the program to end", || window.process.0.try_wait().unwrap());
    assert!(status.success(), "{status}");

    // A hundredth of a unit a point, less the few points that tell a drag from a click.
    assert!((0.8..=1.0).contains(&saved.camera.eye.x), "eye.x is {}", saved.camera.eye.x);
    let mut moved = before;
    moved.camera.eye.x = saved.camera.eye.x;
    assert_eq!(saved, moved, "nothing else has changed");
    let remembered = Store::at(&folder.path().join("pinhole/state.json")).load();
    assert_eq!(remembered.selection, Some(RememberedRay::Pixel(pixel.row, pixel.column)));
    assert!(remembered.renderer.starts_with(setting.drawn_by), "{}", remembered.renderer);
    println!("drawn by {}", remembered.renderer);
    inspected(&scene, pixel, &saved);
    report_times(&folder.path().join("frames.csv"));
}

/// What the program says of the pixel that was clicked, in the scene that was saved.
fn inspected(scene: &Path, pixel: Pixel, saved: &pinhole::document::Document) {
    let place = format!("{},{}", pixel.row, pixel.column);
    let output = Command::new(binary())
        .arg("inspect")
        .arg(scene)
        .args(["--pixel", &place, "--json"])
        .output()
        .unwrap();
    let said: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let ray = saved.camera.posed().unwrap().ray_of_pixel(pixel);
    assert_eq!(said["ray"]["origin"][0].as_f64(), Some(saved.camera.eye.x));
    for k in 0..3 {
        assert_eq!(said["ray"]["direction"][k].as_f64(), Some(ray.direction[k]), "{said}");
    }
    println!("inspected: eye.x = {}, ray {}", shortest(saved.camera.eye.x), said["ray"]);
}

/// Median and 99th percentile of the drag's frames; printed, not judged.
fn report_times(path: &Path) {
    let text = fs::read_to_string(path).unwrap();
    let mut since_input: Vec<f64> =
        text.lines().skip(1).filter_map(|line| line.split(',').next()?.parse().ok()).collect();
    assert!(since_input.len() >= DRAG as usize / 2, "{} frames answer input", since_input.len());
    since_input.sort_by(f64::total_cmp);
    let quantile = |q: f64| since_input[((since_input.len() - 1) as f64 * q) as usize];
    println!(
        "input to presented frame: median {:.1} ms, p99 {:.1} ms, {} frames",
        quantile(0.5),
        quantile(0.99),
        since_input.len()
    );
}

#[test]
#[ignore = "needs Xvfb, openbox, xdotool and lavapipe: .ci/run installs them"]
fn the_window_is_driven_with_wgpu_on_a_software_adapter() {
    drive(&Setting {
        name: "wgpu on lavapipe",
        arguments: &["--renderer", "wgpu"],
        environment: &[("WGPU_BACKEND", "vulkan")],
        drawn_by: "wgpu (",
    });
}

#[test]
#[ignore = "needs Xvfb, openbox and xdotool: .ci/run installs them"]
fn the_window_is_driven_with_every_driver_hidden() {
    drive(&Setting {
        name: "every driver hidden",
        arguments: &[],
        environment: NO_DRIVER,
        drawn_by: "cpu (",
    });
}
