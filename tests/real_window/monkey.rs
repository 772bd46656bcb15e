//! A monkey at the real window: it clicks, drags, scrolls and types anywhere. The program meets no fault,
//! and its memory does not grow.
//!
//! It plays ten seconds with the seed of `PROPTEST_RNG_SEED`, and as long as `PINHOLE_MONKEY_SECONDS` says by hand.

use std::ffi::OsStr;
use std::fs::{self, File};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use egui::{Pos2, pos2, vec2};

use crate::mutants::{self, Random};
use crate::screen::Screen;
use crate::window::{NO_DRIVER, Setting, Window, binary, built_in};

const SETTING: Setting = Setting {
    name: "every driver hidden, a monkey",
    arguments: &[],
    environment: NO_DRIVER,
    drawn_by: "cpu (",
};

/// Keys that do not close the window.
const KEYS: [&str; 24] = [
    "Tab",
    "shift+Tab",
    "Escape",
    "space",
    "Return",
    "Up",
    "Down",
    "Left",
    "Right",
    "Prior",
    "Next",
    "Home",
    "End",
    "Delete",
    "BackSpace",
    "1",
    "0",
    "minus",
    "period",
    "f",
    "n",
    "r",
    "ctrl+z",
    "ctrl+shift+z",
];

/// Memory that a picture of another size, or a page that was not open before, may take, in MiB.
const GROWTH: usize = 64;

fn opened<'a>(screen: &'a Screen, scene: &Path, state: &Path, errors: &Path) -> Window<'a> {
    let mut command = Command::new(binary());
    command.stderr(File::options().create(true).append(true).open(errors).unwrap());
    Window::open_by(command, screen, &[OsStr::new(scene)], state, &SETTING)
}

/// Does one thing at random.
fn act(window: &Window, random: &mut Random) {
    let size = window.size();
    let mut anywhere = || -> Pos2 {
        let mut share = || random.below(1000) as f32 / 1000.0;
        pos2(share() * (size.x - 1.0), share() * (size.y - 1.0))
    };
    let (at, to) = (anywhere(), anywhere());
    match random.below(8) {
        0..=2 => window.click(at),
        3 | 4 => window.drag(at, 0.3 * (to - at)),
        5 => window.scroll(at, random.below(2) == 0),
        _ => window.key(KEYS[random.below(KEYS.len())]),
    }
}

/// Plays; a window that the monkey has closed opens again.
pub(crate) fn plays_a_while() {
    let (seed, time) = mutants::play("PINHOLE_MONKEY_SECONDS", Duration::from_secs(10));
    println!("real window, {}, seed {seed}", SETTING.name);
    let screen = Screen::start();
    let folder = tempfile::tempdir().unwrap();
    let (scene, errors) = (built_in(folder.path(), "canonical"), folder.path().join("errors"));
    let state = folder.path().join("state");
    let mut random = Random::new(seed);
    let mut window = opened(&screen, &scene, &state, &errors);
    window.drag(pos2(0.75 * window.size().x, 0.5 * window.size().y), vec2(40.0, 20.0));
    let (start, before, mut most, mut done) = (Instant::now(), window.memory().unwrap(), 0, 0);
    while start.elapsed() < time {
        act(&window, &mut random);
        done += 1;
        if window.title().is_none() {
            let status = window.wait();
            assert!(status.success(), "{status}, seed {seed}, after {done} things");
            window = opened(&screen, &scene, &state, &errors);
        }
        most = most.max(window.memory().unwrap_or_default());
    }
    let now = window.memory().unwrap_or_default();
    println!("{done} things done; memory {before} MiB, at most {most}, at the end {now}");
    assert!(now < before + GROWTH, "memory grew from {before} to {now} MiB, seed {seed}");
    window.signal("TERM");
    window.wait();
    let said = fs::read_to_string(&errors).unwrap();
    assert!(!said.contains("panicked"), "seed {seed}: {said}");
}
