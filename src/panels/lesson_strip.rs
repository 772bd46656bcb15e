//! The strip of the lesson that is open: what to look at, and the way through the lessons.

use egui::containers::menu::{MenuButton, MenuConfig};
use egui::{Align, Button, Label, Layout, RichText, ScrollArea, Ui, Vec2, vec2};

use super::marked_text;
use crate::action::Action;
use crate::lessons::{Lesson, OpenLesson, Place, Which, builtin, title_of};

/// Of the text, in points: legible from the back row.
const TEXT: f32 = 18.0;
/// Of the buttons' text.
const BUTTON: f32 = 15.0;
/// So many lines are always kept free, that the views stay where they are from step to step.
const LINES: f32 = 2.0;

/// Shows the strip; what was chosen in it goes into `actions`. `changed`: something is not as the
/// step says.
pub(crate) fn ui(
    ui: &mut Ui,
    open: &OpenLesson,
    file: Option<&Lesson>,
    changed: bool,
    actions: &mut Vec<Action>,
) {
    ui.add_space(2.0);
    ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            buttons(ui, open, file, changed, actions);
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| titles(ui, open));
        });
    });
    let size = vec2(ui.available_width(), LINES * marked_text::row_height(ui, TEXT));
    ui.allocate_ui_with_layout(size, Layout::top_down(Align::Min), |ui| {
        ui.set_min_size(size);
        marked_text::label(ui, &open.step().text, TEXT);
    });
    ui.add_space(2.0);
}

fn titles(ui: &mut Ui, open: &OpenLesson) {
    ui.spacing_mut().item_spacing.x = 10.0;
    ui.label(RichText::new(open.title()).size(TEXT).strong());
    let (step, of) = (open.place().step + 1, open.lesson().steps.len());
    ui.label(RichText::new(format!("{step} of {of}")).size(TEXT).weak());
    let title = RichText::new(&open.step().title).size(TEXT).strong();
    ui.add(Label::new(title).truncate());
}

/// From right to left.
fn buttons(
    ui: &mut Ui,
    open: &OpenLesson,
    file: Option<&Lesson>,
    changed: bool,
    actions: &mut Vec<Action>,
) {
    let mut button = |ui: &mut Ui, text: &str, name: &str, hint: &str, action: Option<Action>| {
        let button = Button::new(RichText::new(text).size(BUTTON));
        let response = ui.add_enabled(action.is_some(), button);
        let response = response.on_hover_text(hint).on_disabled_hover_text(hint);
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(name));
        if let (true, Some(action)) = (response.clicked(), action) {
            actions.push(action);
        }
    };
    button(ui, "×", "Close the lesson", "Close the lesson", Some(Action::CloseLesson));
    let back = changed.then_some(Action::BackToStep);
    button(ui, "Back to the step (R)", "Back to the step", "Everything as the step says", back);
    let next = open.next().map(Action::GoTo);
    button(ui, "Next →", "Next", "The next step: right arrow, Page Down", next);
    let previous = open.previous().map(Action::GoTo);
    button(ui, "← Previous", "Previous", "The step before: left arrow, Page Up", previous);
    // Laid out like every menu, whatever the buttons' direction is.
    let menu = MenuButton::from_button(Button::new(RichText::new("Contents").size(BUTTON)));
    menu.config(MenuConfig::new()).ui(ui, |ui| contents(ui, open, file, actions));
}

/// All lessons with their steps.
fn contents(ui: &mut Ui, open: &OpenLesson, file: Option<&Lesson>, actions: &mut Vec<Action>) {
    let most = Vec2::new(460.0, (ui.ctx().content_rect().height() - 160.0).max(120.0));
    ScrollArea::vertical().max_height(most.y).show(ui, |ui| {
        ui.set_width(most.x);
        let file = file.map(|lesson| (Which::File, lesson));
        let builtin = builtin::all().iter().enumerate();
        let builtin = builtin.map(|(index, lesson)| (Which::Builtin(index), &**lesson));
        for (which, lesson) in file.into_iter().chain(builtin) {
            ui.label(RichText::new(title_of(which, lesson)).size(BUTTON).strong());
            ui.indent(("lesson", &lesson.title), |ui| {
                for (index, step) in lesson.steps.iter().enumerate() {
                    let place = Place { lesson: which, step: index };
                    let text = RichText::new(format!("{}. {}", index + 1, step.title)).size(BUTTON);
                    let entry = ui.selectable_label(place == open.place(), text);
                    let name = format!("{}, step {}", title_of(which, lesson), index + 1);
                    ui.ctx().accesskit_node_builder(entry.id, |node| node.set_description(name));
                    if entry.clicked() {
                        actions.push(Action::GoTo(place));
                    }
                }
            });
        }
    });
}
