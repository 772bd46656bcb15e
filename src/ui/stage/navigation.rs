//! The buttons that lead through the lessons, and the table of contents.

use egui::containers::menu::{MenuButton, MenuConfig};
use egui::{
    Align2, Area, Button, Context, Event, Id, Order, Pos2, Rect, RichText, ScrollArea, Ui, Vec2,
    vec2,
};
use pinhole_figure::typesetting::theme;

use crate::model::lessons::{Lesson, OpenLesson, StepId, Which, builtin, title_of};
use crate::ui::action::{Action, Leave, LessonAction, LookAction, request};
use crate::ui::commands_table::{hint, shortcut};
use crate::ui::widgets::{ResponseExt as _, column_of};
use crate::ui::{OpenStep, PageContext};

/// Size of the buttons' text, in points.
const BUTTON: f32 = 15.0;
const NEXT: &str = "Next →";
const SHOW_ANSWER: &str = "Show the answer";
/// Widths below which the buttons that show the answer and that reset the step have short texts, in points.
const NARROW: f32 = 400.0;
const NARROWEST: f32 = 320.0;

/// Shows the buttons from right to left.
pub(super) fn buttons(ui: &mut Ui, step: &OpenStep<'_>, is_asking: bool) {
    let OpenStep { open, file, is_changed } = *step;
    let button = |ui: &mut Ui, text: &str, name: &str, can: bool, action: Action| {
        let (hint, button) = (hint(action.clone()), Button::new(RichText::new(text).size(BUTTON)));
        let response =
            ui.add_enabled(can, button).on_hover_text(&hint).on_disabled_hover_text(hint);
        response.named(name).asks(action);
    };
    button(ui, "×", "Close the lesson", true, LessonAction::Close.into());
    let width = ui.max_rect().width();
    let back = match theme::installed(ui.ctx()).by_touch || width < NARROWEST {
        true => "Reset".to_owned(),
        false => format!("Reset ({})", shortcut(Leave::BackToStep)),
    };
    button(ui, &back, "Back to the step", is_changed, Leave::BackToStep.into());
    let can = is_asking || open.next().is_some();
    let (text, name) = match is_asking {
        true if width < NARROW => ("Answer", SHOW_ANSWER),
        true => (SHOW_ANSWER, SHOW_ANSWER),
        false => (NEXT, "Next"),
    };
    button(ui, text, name, can, LessonAction::Next.into());
    button(ui, "←", "Previous", open.previous().is_some(), LessonAction::Previous.into());
    // Laid out like every menu, independent of the buttons' direction.
    let menu = MenuButton::from_button(Button::new(RichText::new("Contents").size(BUTTON)));
    menu.config(MenuConfig::new()).ui(ui, |ui| contents(ui, open, file));
}

/// Shows the button that opens a vote on the step's question, if it is asked and has answers to vote on.
pub(super) fn vote(ui: &mut Ui, context: &PageContext<'_>) {
    let question = context.step.and_then(|step| step.open.step().question.as_ref());
    if context.session.can_vote() && question.is_some_and(|question| !question.choices.is_empty()) {
        let button = Button::new(RichText::new("Vote").size(BUTTON));
        ui.add(button).on_hover_text(hint(LessonAction::Vote)).asks(LessonAction::Vote);
    }
}

/// Distance of the buttons for a finger from the window's edges, in points.
const EDGE: f32 = 6.0;

/// Shows, in the lower right corner of the window, what a finger has in place of the presenter's keys: a button
/// that ends presenting and, in a lesson, those that lead through it.
pub(crate) fn for_fingers(ctx: &Context, has_lesson: bool) {
    let area = Area::new(Id::unique("for fingers")).order(Order::Middle);
    area.anchor(Align2::RIGHT_BOTTOM, Vec2::splat(-EDGE)).show(ctx, |ui| {
        let button = |ui: &mut Ui, text: &str, name: &str, action: Action| {
            let side = Vec2::splat(ui.spacing().interact_size.y);
            ui.add(Button::new(RichText::new(text).size(BUTTON)).min_size(side))
                .named(name)
                .asks(action);
        };
        ui.horizontal(|ui| {
            if has_lesson {
                button(ui, "←", "Previous", LessonAction::Previous.into());
                button(ui, "→", "Next", LessonAction::Next.into());
            }
            button(ui, "×", "End presenting", LookAction::Present.into());
        });
    });
}

/// Minimum distance of a swipe, in points.
const SWIPE: f32 = 60.0;

/// Goes to the next step if a finger swipes over the column to the left, and back if it swipes to the right.
pub(super) fn swipe(ui: &Ui, column: Rect) {
    let slot = Id::unique("swipe");
    let (before, ctx) = (ui.data(|data| data.get_temp::<[Pos2; 2]>(slot)), ui.ctx());
    // A finger may move and leave in one frame.
    let (way, is_down) = ui.input(|input| {
        let to = |event: &Event| match event {
            Event::Touch { pos, .. } => Some(*pos),
            _ => None,
        };
        let ends = |way: Option<[Pos2; 2]>, to| Some([way.map_or(to, |[from, _]| from), to]);
        (input.events.iter().filter_map(to).fold(before, ends), input.any_touches())
    });
    let Some([from, to]) = way else { return };
    if is_down && ctx.dragged_id().is_none() {
        ui.data_mut(|data| data.insert_temp(slot, [from, to]));
        return;
    }
    ui.data_mut(|data| data.remove::<[Pos2; 2]>(slot));
    let is_on_column =
        column.contains(from) && ctx.layer_id_at(from).is_none_or(|layer| layer == ui.layer_id());
    let way = to - from;
    if !is_down && is_on_column && way.x.abs() > SWIPE.max(2.0 * way.y.abs()) {
        let to = if way.x > 0.0 { LessonAction::Previous } else { LessonAction::Next };
        request(ctx, to);
    }
}

/// Maximum number of columns of the table of contents. With this number, all lessons fit into a window that is
/// 720 points high.
const COLUMNS: usize = 3;
/// Width of a column, in points.
const COLUMN: f32 = 330.0;

/// Shows all lessons with their steps; a lesson from a teacher's file is above the built-in ones.
fn contents(ui: &mut Ui, open: &OpenLesson, file: Option<&Lesson>) {
    // The default limit of a menu is too small for all lessons.
    let room = (ui.ctx().content_rect().size() - vec2(40.0, 120.0)).max(vec2(200.0, 120.0));
    ui.set_max_size(room);
    let count = ((room.x / COLUMN) as usize).clamp(1, COLUMNS);
    ScrollArea::both().show(ui, |ui| {
        ui.set_width(count as f32 * COLUMN);
        if let Some(lesson) = file {
            entries(ui, Which::File, lesson, open);
            ui.separator();
        }
        let all = builtin::all();
        let rows: Vec<usize> = all.iter().map(|lesson| lesson.steps.len() + 1).collect();
        ui.columns(count, |columns| {
            for (index, lesson) in all.iter().enumerate() {
                let column = &mut columns[column_of(&rows, index, count)];
                entries(column, Which::Builtin(index), lesson, open);
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
