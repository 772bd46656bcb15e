//! A Wayland compositor, and the picture of a window that the CPU draws there.

use std::path::Path;
use std::process::{Command, Stdio};

use tempfile::TempDir;

use crate::bus::Bus;
use crate::reader::{IMAGE, Reader};
use crate::screen::{Running, SIZE, Screen, difference, wait_for, wait_or_say};
use crate::window::{NO_DRIVER, binary, built_in};

/// The compositor's name in its folder.
const SOCKET: &str = "wl-test";

/// A compositor that ends with the test.
pub(crate) struct Compositor {
    pub(crate) process: Running,
    folder: TempDir,
}

impl Compositor {
    /// Starts one whose screen nobody can look at.
    pub(crate) fn headless() -> Compositor {
        Compositor::start(Command::new("weston").arg("--backend=headless-backend.so"))
    }

    /// Starts one that fills an X screen, and fills it with each window in turn.
    fn on(screen: &Screen) -> Compositor {
        Compositor::start(
            Command::new("weston")
                .args(["--backend=x11-backend.so", "--use-pixman", "--fullscreen", "--no-input"])
                .args(["--no-config", "--shell=kiosk-shell.so"])
                .env("DISPLAY", &screen.display),
        )
    }

    fn start(weston: &mut Command) -> Compositor {
        let folder = tempfile::tempdir().unwrap();
        let [width, height] = SIZE;
        let process = weston
            .args([format!("--socket={SOCKET}"), "--idle-time=0".to_owned()])
            .args([format!("--width={width}"), format!("--height={height}")])
            .env("XDG_RUNTIME_DIR", folder.path())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .map(Running)
            .expect("weston is installed: .ci/run does it");
        let compositor = Compositor { process, folder };
        let socket = compositor.folder.path().join(SOCKET);
        wait_for("the compositor", || socket.exists().then_some(()));
        compositor
    }

    /// The program with a scene, to be drawn on the CPU and heard on the bus.
    pub(crate) fn program(&self, bus: &Bus, scene: &Path, state: &Path) -> Command {
        let mut program = Command::new(binary());
        program
            .arg(scene)
            .envs(NO_DRIVER.iter().copied())
            .env("XDG_RUNTIME_DIR", self.folder.path())
            .env("WAYLAND_DISPLAY", SOCKET)
            .env_remove("DISPLAY")
            .env("DBUS_SESSION_BUS_ADDRESS", &bus.address)
            .env("XDG_STATE_HOME", state);
        program
    }
}

/// The picture is there, follows what is folded and unfolded, and nothing of an earlier frame stays.
///
/// It is what an X screen shows that is looked at: weston's own screenshots take the byte of each dot
/// that has no meaning for the dot's opacity, and are black where that byte is zero.
pub(crate) fn picture() {
    println!("real window, on Wayland, every driver hidden");
    let folder = tempfile::tempdir().unwrap();
    let screen = Screen::start();
    let compositor = Compositor::on(&screen);
    let reader = Reader::start(&screen.bus);
    let scene = built_in(folder.path(), "look-at");
    let program = compositor.program(&screen.bus, &scene, folder.path()).spawn();
    let _program = Running(program.unwrap());
    let view = wait_for("the camera view", || {
        let nodes = reader.nodes()?;
        reader.rect(nodes.iter().find(|node| node.role == IMAGE && node.name == "Camera view")?)
    });
    let [x, y] = [view.center().x, view.center().y].map(|at| at as usize);
    wait_or_say(
        "the orange sphere",
        || matches!(screen.dots()[y][x], [r, g, b] if r > g && g / 4 > b).then_some(()),
        || format!("{:?} at {x}, {y} of {view:?}", screen.dots()[y][x]),
    );
    // Both buffers take part: what is unfolded moves there in several frames, each of which changes a
    // part of the window alone.
    let [unfolded, folded, again, back] = [(); 4].map(|()| {
        wait_for("a heading, pressed", || {
            let nodes = reader.nodes()?;
            reader.press(nodes.iter().find(|node| node.name == "Selected ray")?)
        });
        screen.settled()
    });
    assert!(folded != unfolded);
    assert!(again == unfolded, "{}", difference(&again, &unfolded));
    assert!(back == folded, "{}", difference(&back, &folded));
}
