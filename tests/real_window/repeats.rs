//! A held key: one that does nothing costs no frame, and one that steps goes on stepping.

use std::fs;
use std::thread::sleep;
use std::time::Duration;

use egui::pos2;

use crate::screen::Screen;
use crate::window::{NO_DRIVER, Setting, Window, built_in};

/// Opens the window, presses a key, holds it for a while if asked to, and returns the number of frames
/// that it painted.
fn frames(screen: &Screen, key: &str, is_held: bool) -> usize {
    let folder = tempfile::tempdir().unwrap();
    let scene = built_in(folder.path(), "canonical");
    let setting = Setting { name: "", arguments: &[], environment: NO_DRIVER, drawn_by: "" };
    let mut window = Window::open(screen, &[scene.as_os_str()], folder.path(), &setting);
    window.point_at(pos2(2.0, 2.0));
    sleep(Duration::from_secs(1));
    screen.press(if is_held { "keydown" } else { "key" }, key);
    sleep(Duration::from_secs(2));
    screen.press("keyup", key);
    // What the arrow key has stepped is not to be asked about.
    window.key("ctrl+z");
    window.quit();
    let log = fs::read_to_string(folder.path().join("frames.csv")).unwrap();
    log.lines().count()
}

pub(crate) fn cost_no_frame() {
    let screen = Screen::start();
    let pressed = frames(&screen, "h", false);
    let [held, stepping] = ["h", "period"].map(|key| frames(&screen, key, true));
    println!(
        "frames: h pressed {pressed}, held for two seconds {held}; a step's key held {stepping}"
    );
    // The key is repeated some 25 times a second, after a moment.
    assert!(stepping > pressed + 20, "{stepping} frames of steps, {pressed} of nothing");
    assert!(held < pressed + 10, "{held} frames for a key that does nothing, {pressed} without");
}
