//! What comes from outside the panels: keys, dropped files and the close button.

use egui::{Context, Key, Modifiers, Popup, ViewportCommand};

use super::App;
use super::answers;
use crate::ui::action::{Action, Leave, LookAction};
use crate::ui::commands_table::{self, When};

impl App {
    /// Keys, dropped files and the close button.
    pub(super) fn window_inputs(&mut self, ctx: &Context, actions: &mut Vec<Action>) {
        actions.append(&mut self.waiting);
        self.keys(ctx, actions);
        self.pasted_text(ctx, actions);
        let dropped = ctx.input(|i| i.raw.dropped_files.first().map(|f| f.path().to_owned()));
        // Not under a dialog: its answer would then be about another scene.
        let dropped = dropped.filter(|_| !self.is_covered());
        actions.extend(dropped.map(answers::dropped));
        if ctx.input(|i| i.viewport().close_requested()) && !self.may_close {
            self.give_back_play();
            if self.open.has_changes() {
                ctx.send_viewport_cmd(ViewportCommand::CancelClose);
                self.ask_about_changes(Leave::Quit);
            } else {
                self.may_close = true;
            }
        }
        self.geometry.update(ctx);
    }

    /// Does it now; where something has the focus, in the next pass: a number that is being typed is
    /// taken over when its field loses the focus.
    pub(super) fn after_typing(
        &mut self,
        ctx: &Context,
        action: Action,
        actions: &mut Vec<Action>,
    ) {
        match ctx.memory(|memory| memory.focused()) {
            Some(focused) => {
                ctx.memory_mut(|memory| memory.surrender_focus(focused));
                self.waiting.push(action);
                ctx.request_repaint();
            }
            None => actions.push(action),
        }
    }

    /// The keys of all commands but those of the views, which [`crate::ui::scene::views`] knows.
    fn keys(&mut self, ctx: &Context, actions: &mut Vec<Action>) {
        if self.is_covered() {
            return;
        }
        let is_typing = ctx.text_edit_focused();
        let has_focus = ctx.memory(|memory| memory.focused().is_some());
        let has_lesson = self.lessons.open.is_some();
        let presenting = self.session.presenting.is_some();
        let pressed = commands_table::pressed(ctx, |when| match when {
            When::Anywhere => true,
            When::Untyped => !is_typing,
            When::Lesson => has_lesson,
            When::LessonUntyped => has_lesson && !is_typing,
            When::LessonUnfocused => has_lesson && !has_focus,
            When::Presenting => presenting && !is_typing,
            When::View | When::CameraView | When::WorldView => false,
        });
        for (when, action) in pressed {
            if matches!(when, When::Anywhere | When::Lesson) {
                self.after_typing(ctx, action, actions);
            } else {
                actions.push(action);
            }
        }
        // Escape ends a drag, closes a menu and lets go of the focus before it ends presenting.
        let is_busy = has_focus || Popup::is_any_open(ctx) || ctx.input(|i| i.pointer.any_down());
        if presenting && !is_busy && ctx.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Escape))
        {
            actions.push(LookAction::Present.into());
        }
    }
}
