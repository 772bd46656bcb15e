//! The strip of the open lesson: the step's text, and the navigation through the lessons.

use std::sync::Arc;

use egui::containers::menu::{MenuButton, MenuConfig};
use egui::{Align, Button, FontId, Label, Layout, RichText, ScrollArea, Ui, vec2};

use crate::model::lessons::{Lesson, OpenLesson, StepId, Which, builtin, title_of};
use crate::ui::action::{Action, Leave, LessonAction};
use crate::ui::commands_table::{keys_text, shortcut};
use crate::ui::widgets::{ResponseExt as _, marked_text, text_width};

/// Size of the text, in points; it is legible from the back row of a classroom.
const TEXT: f32 = 18.0;
/// Size of the buttons' text, in points.
const BUTTON: f32 = 15.0;
const NEXT: &str = "Next →";
const SHOW_ANSWER: &str = "Show the answer";
/// Number of lines of text that are always reserved, so that the views stay in place from step to step.
const LINES: f32 = 2.0;

/// Shows the strip. `file` is the lesson that was opened from a file. `asks` is true while the step's
/// question is open. `changed` is true if anything differs from the step.
pub(crate) fn ui(ui: &mut Ui, open: &OpenLesson, file: Option<&Lesson>, asks: bool, changed: bool) {
    ui.add_space(2.0);
    ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            buttons(ui, open, file, asks, changed);
            // The reserved width keeps the titles the same before and after the answer.
            let [next, answer] = [NEXT, SHOW_ANSWER].map(|text| width(ui, text, BUTTON));
            let reserved = if asks { 0.0 } else { answer - next };
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| titles(ui, open, reserved));
        });
    });
    text(ui, open, asks);
}

/// Shows the strip while presenting: the text without buttons.
pub(crate) fn slim(ui: &mut Ui, open: &OpenLesson, is_asking: bool) {
    ui.add_space(2.0);
    ui.horizontal(|ui| titles(ui, open, 0.0));
    text(ui, open, is_asking);
}

/// Shows the step's text, and its question or the answer.
fn text(ui: &mut Ui, open: &OpenLesson, is_asking: bool) {
    let step = open.step();
    let size = vec2(ui.available_width(), LINES * marked_text::row_height(ui, TEXT));
    ui.allocate_ui_with_layout(size, Layout::top_down(Align::Min), |ui| {
        ui.set_min_size(size);
        marked_text::label(ui, &step.text, TEXT);
        if let Some(question) = &step.question {
            let text = if is_asking { &question.ask } else { &question.answer };
            // The views stay in place when the answer replaces the question.
            let texts = [&question.ask, &question.answer];
            let height = texts.map(|text| marked_text::height(ui, text, TEXT));
            ui.scope(|ui| {
                ui.set_min_height(height[0].max(height[1]));
                marked_text::label(ui, text, TEXT);
            });
        }
    });
    ui.add_space(2.0);
}

/// Shows the titles of the lesson and the step, and leaves `reserved` points free. If the lesson's title does
/// not fit next to the longest title of its steps, only its number is shown.
fn titles(ui: &mut Ui, open: &OpenLesson, reserved: f32) {
    let gap = 10.0;
    ui.spacing_mut().item_spacing.x = gap;
    let steps = &open.lesson().steps;
    let number = format!("{} of {}", open.id().step + 1, steps.len());
    let longest = steps.iter().map(|step| width(ui, &step.title, TEXT)).fold(0.0, f32::max);
    let title = open.title();
    let row = width(ui, &title, TEXT) + width(ui, &number, TEXT) + longest + 2.0 * gap + reserved;
    let title = if row <= ui.available_width() { title } else { open.short_title() };
    ui.label(RichText::new(title).size(TEXT).strong());
    ui.label(RichText::new(number).size(TEXT).weak());
    let title = RichText::new(&open.step().title).size(TEXT).strong();
    ui.add(Label::new(title).truncate());
}

/// Returns the width of a text of this size.
fn width(ui: &Ui, text: &str, size: f32) -> f32 {
    text_width(ui, text, FontId::proportional(size))
}

/// Shows the buttons from right to left.
fn buttons(ui: &mut Ui, open: &OpenLesson, file: Option<&Lesson>, is_asking: bool, changed: bool) {
    let button = |ui: &mut Ui, text: &str, name: &str, hint: &str, can: bool, action: Action| {
        let button = Button::new(RichText::new(text).size(BUTTON));
        let response = ui.add_enabled(can, button).on_hover_text(hint).on_disabled_hover_text(hint);
        response.named(name).asks(action);
    };
    button(ui, "×", "Close the lesson", "Close the lesson", true, LessonAction::Close.into());
    let back = format!("Back to the step ({})", shortcut(Leave::BackToStep));
    let hint = "Resets everything to the step";
    button(ui, &back, "Back to the step", hint, changed, Leave::BackToStep.into());
    let hint = |text: &str, action: LessonAction| format!("{text}: {}", keys_text(action));
    let can = is_asking || open.next().is_some();
    let (text, name, about) = match is_asking {
        true => (SHOW_ANSWER, SHOW_ANSWER, "The answer to the question"),
        false => (NEXT, "Next", "The next step"),
    };
    button(ui, text, name, &hint(about, LessonAction::Next), can, LessonAction::Next.into());
    let can = open.previous().is_some();
    let hint = hint("The previous step", LessonAction::Previous);
    button(ui, "← Previous", "Previous", &hint, can, LessonAction::Previous.into());
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
