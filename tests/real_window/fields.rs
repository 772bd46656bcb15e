//! A number dragged, a pixel clicked, saved, and quit.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::thread::sleep;
use std::time::Duration;

use egui::accesskit::Role;
use egui::vec2;
use pinhole::model::store::Store;
use pinhole_core::{Pixel, Selection, shortest};
use pinhole_exchange::scene_file;

use crate::memory::InMemory;
use crate::screen::{Screen, wait_for};
use crate::window::{Setting, Window, binary, built_in};

/// Points the mouse moves in the long drag, one a frame.
const DRAG: i32 = 100;

pub(crate) fn drive(setting: &Setting) {
    println!("real window, {}: {}", setting.name, binary().display());
    let folder = tempfile::tempdir().unwrap();
    let scene = built_in(folder.path(), "canonical");
    let before = scene_file::load(&scene).unwrap();
    let screen = Screen::start();
    let mut window = Window::open(&screen, &[scene.as_os_str()], folder.path(), setting);
    sleep(Duration::from_secs(2));
    let memory = InMemory::like(&window, &scene);

    window.drag_right(memory.position(Role::SpinButton, "eye x", vec2(0.5, 0.5)), DRAG);
    // The mouse goes by whole dots, so the pixel is the one under such a dot.
    let at = memory.position(Role::Image, "Camera view", vec2(0.25, 0.75)).floor();
    window.click(at);
    let pixel = memory.pixel_at(at, before.camera.image);
    screen.press("key", "ctrl+s");
    let saved = wait_for("the saved file", || {
        let saved = scene_file::load(&scene).ok()?;
        (saved != before).then_some(saved)
    });
    sleep(Duration::from_millis(300));
    window.quit();

    // A hundredth of a unit a point, less the few points that tell a drag from a click.
    assert!((0.8..=1.0).contains(&saved.camera.eye.x), "eye.x is {}", saved.camera.eye.x);
    let mut moved = before;
    moved.camera.eye.x = saved.camera.eye.x;
    assert_eq!(saved, moved, "nothing else has changed");
    let remembered = Store::at(&folder.path().join("pinhole/state.json")).load();
    assert_eq!(remembered.selection, Some(Selection::Pixel(pixel)));
    assert!(remembered.renderer.starts_with(setting.drawn_by), "{}", remembered.renderer);
    println!("drawn by {}", remembered.renderer);
    inspected(&scene, pixel, &saved);
    report_times(&folder.path().join("frames.csv"));
}

/// What the program says of the pixel that was clicked, in the scene that was saved.
fn inspected(scene: &Path, pixel: Pixel, saved: &pinhole_exchange::document::Document) {
    let position = format!("{},{}", pixel.row, pixel.column);
    let output = Command::new(binary())
        .arg("inspect")
        .arg(scene)
        .args(["--pixel", &position, "--json"])
        .output()
        .unwrap();
    let said: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let ray = saved.camera.resolve().unwrap().ray_of_pixel(pixel);
    assert_eq!(said["ray"]["origin"][0].as_f64(), Some(saved.camera.eye.x));
    for k in 0..3 {
        // `inspect` goes through the rounded (u, v).
        let off = said["ray"]["direction"][k].as_f64().unwrap() - ray.direction[k];
        assert!(off.abs() < 1e-15, "{off:e} in {said}");
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
