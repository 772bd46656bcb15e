//! Pictures of the window, drawn by the program's own painter: the same bytes on every machine.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test --test pinhole app::snapshots` writes them anew.

use pinhole::model::session::{Preferences, Settings, ThemeName, ViewLayout};
use pinhole::model::store::Remembered;

use super::harness::{show, type_into, unfolded, window, window_with};

#[test]
fn the_first_window() {
    let mut window = window_with("canonical", Remembered::default(), None);
    window.set_size(egui::vec2(1280.0, 800.0));
    window.run();
    window.snapshot("window_first");
}

#[test]
fn the_lectures_scene() {
    window("canonical").snapshot("window_canonical");
}

#[test]
fn a_dark_window_on_another_scene() {
    let settings = Settings {
        preferences: Preferences { theme: ThemeName::Dark, ..unfolded().preferences },
        ..unfolded()
    };
    let remembered = Remembered { settings, ..Remembered::default() };
    window_with("look-at", remembered, None).snapshot("window_dark");
}

#[test]
fn a_camera_without_a_basis() {
    let mut window = window("canonical");
    type_into(&mut window, "up y", "0");
    window.remove_cursor();
    window.run();
    window.snapshot("window_fault");
}

#[test]
fn one_view_alone_with_few_large_pixels() {
    let mut window = window("grazing");
    type_into(&mut window, "W", "24");
    type_into(&mut window, "H", "24");
    show(&mut window, ViewLayout::Camera);
    window.remove_cursor();
    window.run();
    window.snapshot("window_large_pixels");
}
