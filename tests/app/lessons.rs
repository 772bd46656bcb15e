//! The lessons: every step with its numbers, the way through them, and dragging freely in between.

mod asking;
mod back;
mod directed;
mod files;
mod hand;
mod leaving;
mod letters;
mod numbers;
mod questions;
mod ray_pictures;
mod saving;
mod stage;
mod strip;
mod votes;
mod walk;

use egui::Key;
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::lessons::{StepId, Which};
use pinhole::ui::app::App;

use super::harness::window;

type Window = Harness<'static, App>;

fn press(window: &mut Window, button: &str) {
    window.get_by_role_and_label(Role::Button, button).click();
    window.run();
}

fn go_to(window: &mut Window, lesson: usize, step: usize) {
    begin(window, lesson, step);
    answer(window);
}

/// Opens a step, both counted from 1, as it begins.
fn begin(window: &mut Window, lesson: usize, step: usize) {
    let id = StepId { lesson: Which::Builtin(lesson - 1), step: step - 1 };
    window.state_mut().open_lesson(id, None);
    window.run();
}

/// Shows the answer to the step's question, if it has one.
fn answer(window: &mut Window) {
    if window.state().session().shown.is_asking {
        press(window, "Show the answer");
    }
}

/// A window on a lesson's step, both counted from 1, with its question answered.
fn at_step(lesson: usize, step: usize) -> Window {
    let mut window = window("canonical");
    go_to(&mut window, lesson, step);
    window
}

fn key(window: &mut Window, key: Key) {
    window.key_press(key);
    window.run();
}

/// The open lesson and step, counted from 1.
fn shown_step(window: &Window) -> (usize, usize) {
    match window.state().lesson().unwrap().id() {
        StepId { lesson: Which::Builtin(index), step } => (index + 1, step + 1),
        other => panic!("{other:?}"),
    }
}
