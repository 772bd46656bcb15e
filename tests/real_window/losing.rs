//! A graphics driver that fails while its window is open: the window goes on, drawn on the CPU.

use std::fs;
use std::path::Path;
use std::process::Command;

use egui::pos2;
use pinhole::model::store::Store;
use pinhole_exchange::scene_file;
use tempfile::TempDir;

use crate::hearing::{Heard, says};
use crate::screen::{Dots, Screen, difference, wait_for, wait_or_say};
use crate::window::{Setting, built_in};

/// A layer over the driver that has it fail on demand.
struct FailingDriver(TempDir);

impl FailingDriver {
    fn build() -> FailingDriver {
        let folder = tempfile::tempdir().unwrap();
        let source =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/real_window/failing_driver.c");
        let library = folder.path().join("failing_driver.so");
        let compiler = Command::new("cc")
            .args(["-shared", "-fPIC", "-o"])
            .args([&library, &source])
            .status()
            .expect("a C compiler is installed: .ci/run does it");
        assert!(compiler.success(), "{compiler}: Vulkan's headers are installed by .ci/run");
        let manifest = serde_json::json!({
            "file_format_version": "1.1.0",
            "layer": {
                "name": LAYER,
                "type": "GLOBAL",
                "library_path": library,
                "api_version": "1.3.0",
                "implementation_version": "1",
                "description": "A driver that fails on demand",
                "functions": {
                    "vkGetInstanceProcAddr": "function_of_instance",
                    "vkGetDeviceProcAddr": "function_of_device",
                },
            },
        });
        fs::write(folder.path().join("layer.json"), manifest.to_string()).unwrap();
        FailingDriver(folder)
    }
}

const LAYER: &str = "VK_LAYER_TEST_failing_driver";

/// Points at which the mouse is over nothing.
const NOWHERE: [egui::Pos2; 2] = [pos2(200.0, 700.0), pos2(210.0, 700.0)];

/// Opens the window with its list of objects, and points at nothing.
fn open<'a>(setting: &Setting, screen: &'a Screen, scene: &Path, state: &Path) -> Heard<'a> {
    let heard = Heard::open_as(setting, screen, &[scene.as_os_str()], state);
    heard.press("Objects");
    heard.window.point_at(NOWHERE[0]);
    heard
}

/// The screen after one edit and after another, if the CPU has drawn it all the time.
fn as_by_cpu() -> [Dots; 2] {
    let folder = tempfile::tempdir().unwrap();
    let scene = built_in(folder.path(), "look-at");
    let screen = Screen::start();
    let setting = Setting {
        name: "drawn on the CPU, to compare",
        arguments: &["--renderer", "cpu"],
        environment: &[],
        drawn_by: "cpu (",
    };
    let mut heard = open(&setting, &screen, &scene, folder.path());
    let pictures = [(); 2].map(|()| {
        heard.press("+ Sphere");
        screen.settled()
    });
    assert!(pictures[0] != pictures[1]);
    heard.window.key("ctrl+s");
    heard.window.quit();
    pictures
}

pub(crate) fn device_and_surface() {
    let expected = as_by_cpu();
    for what in ["LOST_DEVICE", "LOST_SURFACE"] {
        lose(what, &expected);
    }
}

fn lose(what: &str, expected: &[Dots; 2]) {
    let driver = FailingDriver::build();
    // The driver fails as soon as this file is there.
    let demand = driver.0.path().join("fail");
    let folder = tempfile::tempdir().unwrap();
    let scene = built_in(folder.path(), "look-at");
    let before = scene_file::load(&scene).unwrap();
    let screen = Screen::start();
    let setting = Setting {
        name: what,
        arguments: &["--renderer", "wgpu"],
        environment: &[
            ("WGPU_BACKEND", "vulkan"),
            ("VK_LAYER_PATH", driver.0.path().to_str().unwrap()),
            ("VK_INSTANCE_LAYERS", LAYER),
            (what, demand.to_str().unwrap()),
        ],
        drawn_by: "cpu (the graphics driver failed: ",
    };
    let mut heard = open(&setting, &screen, &scene, folder.path());
    heard.press("+ Sphere");
    screen.settled();

    fs::write(&demand, "").unwrap();
    for at in [NOWHERE[1], NOWHERE[0]] {
        heard.window.point_at(at);
    }
    heard.wait("the notice", |nodes| {
        let told = nodes.iter().any(|node| node.name.starts_with("The graphics driver failed: "));
        (told && says(nodes, "The window is drawn on the CPU now")).then_some(())
    });
    let is_as_expected = |k: usize| (screen.dots() == expected[k]).then_some(());
    let differing = |k: usize| difference(&screen.dots(), &expected[k]);
    wait_or_say("the picture that the CPU draws", || is_as_expected(0), || differing(0));
    heard.press("+ Sphere");
    wait_or_say("the picture of a change", || is_as_expected(1), || differing(1));

    let spheres_saved = |count: usize| {
        heard.window.key("ctrl+s");
        wait_for("the saved file", || {
            let saved = scene_file::load(&scene).ok()?;
            (saved.spheres.len() == before.spheres.len() + count).then_some(saved)
        })
    };
    spheres_saved(2);
    heard.window.key("ctrl+z");
    spheres_saved(1);
    heard.window.key("ctrl+z");
    assert_eq!(spheres_saved(0), before, "the history is that of the whole run");
    heard.window.quit();
    let remembered = Store::at(&folder.path().join("pinhole/state.json")).load();
    assert!(remembered.renderer.starts_with(setting.drawn_by), "{}", remembered.renderer);
}
