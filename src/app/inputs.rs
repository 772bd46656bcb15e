//! What comes from outside the panels: keys, dropped files and the close button.

use egui::{Context, Key, KeyboardShortcut, Modifiers, ViewportCommand};

use super::App;
use crate::action::Action;
use crate::formats::scene_argument::SceneSource;

impl App {
    /// Keys, dropped files and the close button.
    pub(super) fn window_inputs(&mut self, ctx: &Context, actions: &mut Vec<Action>) {
        actions.append(&mut self.waiting);
        self.lesson_keys(ctx, actions);
        let command = |key| KeyboardShortcut::new(Modifiers::COMMAND, key);
        let shifted = KeyboardShortcut::new(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
        let pressed = |shortcut| ctx.input_mut(|i| i.consume_shortcut(&shortcut));
        // The longer shortcut first: the shorter one would match it too.
        for (shortcut, action) in [
            (shifted, Action::AskSaveAs),
            (command(Key::S), Action::Save),
            (command(Key::O), Action::AskOpen),
            (command(Key::E), Action::AskExport),
            (command(Key::Q), Action::Quit),
        ] {
            if pressed(shortcut) && self.dialog.is_none() {
                self.after_typing(ctx, action, actions);
            }
        }
        self.history_keys(ctx, actions);
        self.ghost_keys(ctx, actions);
        let dropped = ctx.input(|i| i.raw.dropped_files.first().map(|f| f.path().to_owned()));
        // Not under a dialog: its answer would then be about another scene.
        let dropped = dropped.filter(|_| self.dialog.is_none());
        actions.extend(dropped.map(|path| Action::Open(SceneSource::File(path))));
        if ctx.input(|i| i.viewport().close_requested()) && !self.may_close {
            self.give_back_play();
            if self.open.has_changes() {
                ctx.send_viewport_cmd(ViewportCommand::CancelClose);
                self.ask_about_changes(Action::Quit);
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

    /// Undo and redo; a text that is being typed has an undo of its own.
    fn history_keys(&self, ctx: &Context, actions: &mut Vec<Action>) {
        if ctx.text_edit_focused() || self.dialog.is_some() {
            return;
        }
        let pressed = |modifiers, key| ctx.input_mut(|i| i.consume_key(modifiers, key));
        // The longer one first: the shorter one would match it too.
        let redo = pressed(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
        if redo || pressed(Modifiers::COMMAND, Key::Y) {
            actions.push(Action::Redo);
        } else if pressed(Modifiers::COMMAND, Key::Z) {
            actions.push(Action::Undo);
        }
    }
}
