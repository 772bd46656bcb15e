//! The buttons that lead through the lessons, and the table of contents.

use std::sync::Arc;

use egui::containers::menu::{MenuButton, MenuConfig};
use egui::{Button, RichText, ScrollArea, Ui, vec2};

use super::column::OpenStep;
use crate::model::lessons::{Lesson, OpenLesson, StepId, Which, builtin, title_of};
use crate::ui::action::{Action, Leave, LessonAction};
use crate::ui::commands_table::{keys_text, shortcut};
use crate::ui::widgets::ResponseExt as _;

/// Size of the buttons' text, in points.
const BUTTON: f32 = 15.0;
const NEXT: &str = "Next →";
const SHOW_ANSWER: &str = "Show the answer";

/// Shows the buttons from right to left.
pub(super) fn buttons(ui: &mut Ui, step: &OpenStep<'_>, is_asking: bool) {
    let OpenStep { open, file, is_changed } = *step;
    let button = |ui: &mut Ui, text: &str, name: &str, hint: &str, can: bool, action: Action| {
        let button = Button::new(RichText::new(text).size(BUTTON));
        let response = ui.add_enabled(can, button).on_hover_text(hint).on_disabled_hover_text(hint);
        response.named(name).asks(action);
    };
    button(ui, "×", "Close the lesson", "Close the lesson", true, LessonAction::Close.into());
    let back = format!("Reset ({})", shortcut(Leave::BackToStep));
    let hint = "Resets everything to the step";
    button(ui, &back, "Back to the step", hint, is_changed, Leave::BackToStep.into());
    let hint = |text: &str, action: LessonAction| format!("{text}: {}", keys_text(action));
    let can = is_asking || open.next().is_some();
    let (text, name, about) = match is_asking {
        true => (SHOW_ANSWER, SHOW_ANSWER, "The answer to the question"),
        false => (NEXT, "Next", "The next step"),
    };
    button(ui, text, name, &hint(about, LessonAction::Next), can, LessonAction::Next.into());
    let can = open.previous().is_some();
    let hint = hint("The previous step", LessonAction::Previous);
    button(ui, "←", "Previous", &hint, can, LessonAction::Previous.into());
    // Laid out like every menu, independent of the buttons' direction.
    let menu = MenuButton::from_button(Button::new(RichText::new("Contents").size(BUTTON)));
    menu.config(MenuConfig::new()).ui(ui, |ui| contents(ui, open, file));
}

/// Number of columns of the table of contents. With this number, all lessons fit into a window that is
/// 720 points high.
const COLUMNS: usize = 3;
/// Width of a column, in points.
const COLUMN: f32 = 330.0;

/// Shows all lessons with their steps; a lesson from a teacher's file is above the built-in ones.
fn contents(ui: &mut Ui, open: &OpenLesson, file: Option<&Lesson>) {
    let width = COLUMNS as f32 * COLUMN;
    // The default limit of a menu is too small for all lessons.
    ui.set_max_size((ui.ctx().content_rect().size() - vec2(40.0, 120.0)).max(vec2(200.0, 120.0)));
    ScrollArea::both().show(ui, |ui| {
        ui.set_width(width);
        if let Some(lesson) = file {
            entries(ui, Which::File, lesson, open);
            ui.separator();
        }
        let rows = |lessons: &[Arc<Lesson>]| -> usize {
            lessons.iter().map(|lesson| lesson.steps.len() + 1).sum()
        };
        let all = builtin::all();
        ui.columns(COLUMNS, |columns| {
            for (index, lesson) in all.iter().enumerate() {
                // All columns form one long column that is cut into equal parts. A lesson belongs to the
                // part that contains its middle.
                let middle = rows(&all[..index]) + lesson.steps.len() / 2;
                let column = (COLUMNS * middle / rows(all).max(1)).min(COLUMNS - 1);
                entries(&mut columns[column], Which::Builtin(index), lesson, open);
            }
        });
    });
}

/// Shows a lesson and its steps.
fn entries(ui: &mut Ui, which: Which, lesson: &Lesson, open: &OpenLesson) {
    ui.spacing_mut().item_spacing.y = 1.0;
    ui.add_space(4.0);
    ui.label(RichText::new(title_of(which, lesson)).size(BUTTON).strong());
    for (index, step) in lesson.steps.iter().enumerate() {
        let id = StepId { lesson: which, step: index };
        let text = RichText::new(format!("{}. {}", index + 1, step.title)).size(BUTTON);
        ui.selectable_label(id == open.id(), text).asks(Leave::GoTo(id));
    }
}
