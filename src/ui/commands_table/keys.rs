//! Keys: when they count, what they are called, and which were pressed.

use egui::{Context, Event, Key, Modifiers};

use super::all;
use crate::ui::action::Action;

/// The time at which a key counts. Under a dialog none does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// Always, also while something is typed, which is taken over first.
    Anywhere,
    /// Unless a text is being typed.
    Untyped,
    /// While a lesson is open, also while something is typed.
    Lesson,
    /// While a lesson is open and no text is typed.
    LessonUntyped,
    /// While a lesson is open and nothing has the focus.
    LessonUnfocused,
    /// While presenting, unless a text is being typed.
    Presenting,
    /// While a view has the focus, or nothing has.
    View,
    /// While the camera view has the focus, or nothing has and it is the only view.
    CameraView,
    /// The same for the world view.
    WorldView,
}

/// A key with what is held besides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keys {
    /// The modifiers that are held.
    pub modifiers: Modifiers,
    /// The key that is pressed.
    pub key: Key,
    /// The time at which it counts.
    pub when: When,
}

impl Keys {
    /// Returns the words on the keys, such as `Ctrl+Shift+S`.
    pub fn text(&self) -> String {
        self.held() + name(self.key)
    }

    /// Returns the words on the held keys, such as `Ctrl+Shift+`.
    pub(super) fn held(&self) -> String {
        let held = [
            (self.modifiers.command, "Ctrl+"),
            (self.modifiers.alt, "Alt+"),
            (self.modifiers.shift, "Shift+"),
        ];
        held.iter().filter(|held| held.0).map(|held| held.1).collect()
    }

    /// Takes the presses of it, and returns their number.
    fn take(self, ctx: &Context) -> usize {
        let mut count = 0;
        ctx.input_mut(|input| {
            input.events.retain(|event| {
                let is_it = matches!(event, Event::Key { key, pressed: true, modifiers, .. }
                    if *key == self.key && self.is_held(*modifiers));
                count += usize::from(is_it);
                !is_it
            });
        });
        count
    }

    fn is_held(self, now: Modifiers) -> bool {
        // A sign's place on the keyboard differs: some need Shift or AltGr to be typed at all.
        let mut letters = name(self.key).chars();
        let is_sign =
            letters.next().is_some_and(|c| !c.is_alphabetic()) && letters.next().is_none();
        let same = |now: bool, wanted: bool| now == wanted || (is_sign && !wanted);
        now.command == self.modifiers.command
            && same(now.shift, self.modifiers.shift)
            && same(now.alt, self.modifiers.alt)
    }
}

fn name(key: Key) -> &'static str {
    match key {
        Key::ArrowUp => "Up",
        Key::ArrowDown => "Down",
        Key::ArrowLeft => "Left",
        Key::ArrowRight => "Right",
        Key::PageUp => "Page Up",
        Key::PageDown => "Page Down",
        Key::Questionmark => "?",
        Key::Slash => "/",
        Key::Plus => "+",
        Key::Equals => "=",
        Key::Minus => "−",
        Key::OpenBracket => "[",
        Key::CloseBracket => "]",
        other => other.name(),
    }
}

/// The actions of the keys that were pressed, as often as they were; `counts` says which keys count
/// now. Of two that are the same key, the one that stands first in the table gets it.
pub fn pressed(ctx: &Context, counts: impl Fn(When) -> bool) -> Vec<(When, Action)> {
    let is_key = |event: &Event| matches!(event, Event::Key { pressed: true, .. });
    if !ctx.input(|input| input.events.iter().any(is_key)) {
        return Vec::new();
    }
    let mut actions = Vec::new();
    for command in all() {
        for keys in command.keys.iter().filter(|keys| counts(keys.when)) {
            let times = keys.take(ctx);
            actions.extend((0..times).map(|_| (keys.when, command.action.clone())));
        }
    }
    actions
}
