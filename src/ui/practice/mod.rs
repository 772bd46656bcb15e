//! The practice workspace: mistakes in cameras with votes on them, a student's answers, and a class's. Its
//! exercises are on the stage.

pub mod answers;
pub mod class;
pub mod gallery;
pub mod mistakes;
pub mod vote;

use egui::{DragValue, Ui};

use crate::model::practice::LARGEST_SEED;
use crate::ui::widgets::ResponseExt as _;

/// Shows the field for a seed. The seed takes effect once it is typed in full.
pub(crate) fn seed_field(ui: &mut Ui, seed: &mut u64, name: &str, hint: &str) {
    let field = DragValue::new(seed).speed(0.1).range(0..=LARGEST_SEED);
    ui.add(field.update_while_editing(false)).on_hover_text(hint).named(name);
}
