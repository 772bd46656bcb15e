//! The release binary in a real window: a virtual screen, a window manager, and a mouse.
//!
//! Ignored unless asked for, since it needs Xvfb, openbox and xdotool; `.ci/run` installs them and
//! sets `PINHOLE_BINARY`. Where to click is not written down here: the same window, laid out in
//! memory at the same size, says where each accessible label is.

#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, reason = "a test that cannot drive its window has failed")]
#![allow(clippy::print_stdout, reason = "says what it ran on, and how fast")]

mod bus;
mod dying;
mod fields;
mod hands;
mod hearing;
mod losing;
mod memory;
mod monkey;
#[path = "../../src/exchange/tests/common/mutants.rs"]
#[allow(dead_code, reason = "the monkey needs its random numbers alone")]
mod mutants;
mod observing;
mod pen;
mod pointing;
mod portal;
mod reader;
mod repeats;
mod reveal;
mod screen;
mod typing;
mod vote;
mod wayland;
#[path = "../support/whole_window.rs"]
mod whole_window;
mod window;

use window::{NO_DRIVER, Setting};

#[test]
#[ignore = "needs Xvfb, openbox, xdotool and lavapipe: .ci/run installs them"]
fn the_window_is_driven_with_wgpu_on_a_software_adapter() {
    fields::drive(&Setting {
        name: "wgpu on lavapipe",
        arguments: &["--renderer", "wgpu"],
        environment: &[("WGPU_BACKEND", "vulkan")],
        drawn_by: "wgpu (",
    });
}

#[test]
#[ignore = "needs Xvfb, openbox and xdotool: .ci/run installs them"]
fn the_window_is_driven_with_every_driver_hidden() {
    fields::drive(&Setting {
        name: "every driver hidden",
        arguments: &[],
        environment: NO_DRIVER,
        drawn_by: "cpu (",
    });
}

#[test]
#[ignore = "needs Xvfb, openbox and xdotool: .ci/run installs them"]
fn the_camera_is_taken_in_the_hand_presented_and_exported() {
    hands::drive(&Setting {
        name: "every driver hidden, by hand",
        arguments: &[],
        environment: NO_DRIVER,
        drawn_by: "cpu (",
    });
}

#[test]
#[ignore = "needs Xvfb, openbox, xdotool, dbus and at-spi2-core: .ci/run installs them"]
fn a_pixel_is_pointed_at_and_pinned() {
    pointing::hover_and_pin();
}

#[test]
#[ignore = "needs Xvfb, openbox, xdotool, dbus and at-spi2-core: .ci/run installs them"]
fn a_view_is_zoomed_turned_and_saved_as_a_step_that_plays() {
    observing::zoom_turn_save_and_play();
}

#[test]
#[ignore = "needs Xvfb, openbox, xdotool, dbus and at-spi2-core: .ci/run installs them"]
fn an_answer_and_a_derivation_are_revealed_key_by_key() {
    reveal::key_by_key();
}

#[test]
#[ignore = "needs Xvfb, openbox, xdotool, dbus and at-spi2-core: .ci/run installs them"]
fn a_given_number_is_typed_into_the_derivation() {
    typing::a_given_number();
}

#[test]
#[ignore = "needs Xvfb, openbox, xdotool, dbus and at-spi2-core: .ci/run installs them"]
fn the_pen_draws_and_escape_wipes_it_off() {
    pen::stroke();
}

#[test]
#[ignore = "needs Xvfb, openbox, xdotool, dbus and at-spi2-core: .ci/run installs them"]
fn a_vote_is_given_and_told_by_a_key() {
    vote::guess_which();
}

#[test]
#[ignore = "needs Xvfb, openbox and xdotool: .ci/run installs them"]
fn unsaved_changes_are_offered_however_the_window_ended() {
    dying::in_every_way();
}

#[test]
#[ignore = "needs weston, dbus and at-spi2-core: .ci/run installs them"]
fn unsaved_changes_are_offered_when_the_wayland_compositor_is_gone() {
    dying::with_its_compositor();
}

#[test]
#[ignore = "needs Xvfb, openbox, xdotool, weston, dbus and at-spi2-core: .ci/run installs them"]
fn the_picture_is_shown_on_wayland() {
    wayland::picture();
}

#[test]
#[ignore = "needs Xvfb, openbox, xdotool, dbus, at-spi2-core, lavapipe, gcc and Vulkan's headers: .ci/run installs them"]
fn the_window_goes_on_when_its_graphics_driver_fails() {
    losing::device_and_surface();
}

#[test]
#[ignore = "needs Xvfb, openbox and xdotool: .ci/run installs them"]
fn a_monkey_at_the_window_finds_no_fault() {
    monkey::plays_a_while();
}

#[test]
#[ignore = "needs Xvfb, openbox and xdotool: .ci/run installs them"]
fn a_held_key_that_does_nothing_costs_no_frame() {
    repeats::cost_no_frame();
}

#[test]
#[ignore = "needs Xvfb, openbox, xdotool, dbus and at-spi2-core: .ci/run installs them"]
fn the_desktops_file_dialog_opens_saves_and_exports() {
    portal::opens_saves_and_exports();
}

#[test]
#[ignore = "needs Xvfb, openbox, xdotool, dbus and at-spi2-core: .ci/run installs them"]
fn the_desktops_file_dialog_is_open_once_and_may_be_closed() {
    portal::is_open_once_and_may_be_closed();
}

#[test]
#[ignore = "needs Xvfb, openbox, xdotool, dbus and at-spi2-core: .ci/run installs them"]
fn without_the_desktops_file_dialog_the_window_asks_by_its_own() {
    portal::is_missing_or_does_not_work();
}
