//! The table of commands: each command's name, description, keys and [`Action`].
//!
//! Menus, the keyboard ([`pressed`]), the command palette and the list of keys all use this table, so a new
//! command is a row in `table.rs`. That file also lists the mouse [gestures](GESTURES), but only for the list
//! of keys: what a gesture does depends on what is under the pointer, so the views handle it.

use std::sync::LazyLock;

use egui::{Context, Event, Key, ModifierNames, Modifiers};
use pinhole_figure::typesetting::theme;

use crate::ui::action::{Action, CameraMove, Observe, Steer, VoteAction};

pub use search::found;
pub use table::GESTURES;
pub(crate) use table::{command, of_lesson};

mod search;
mod table;

pinhole_core::texts! {
    /// The group of a command. The list of keys has a heading for each group.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Group[1];
    {
        /// Returns the group's heading, which precedes a command's name in the palette.
        label,
    }
    /// Opening, saving, quitting.
    File: "File";
    /// Undo, redo.
    Edit: "Edit";
    /// The way through a lesson.
    Lesson: "Lesson";
    /// Presenter mode.
    Presenting: "Presenting";
    /// The open vote.
    Vote: "Vote";
    /// The selected pixel and the observer.
    Views: "Views";
    /// Moving the camera by its handles or in the camera view.
    Hand: "Manipulate";
    /// The scene's spheres and planes.
    Objects: "Objects";
    /// Animations and the ghost.
    Play: "Play and compare";
    /// The program itself.
    Program: "Program";
    /// The views that are shown.
    Layout: "Layout";
    /// The items drawn over the views.
    Overlay: "Overlay";
    /// The colours of pictures and window.
    Colours: "Colours";
    /// The form of numbers.
    Numbers: "Numbers";
    /// The built-in scenes.
    Scene: "Scene";
    /// The lessons' steps.
    Step: "Contents";
    /// The exercises.
    Exercise: "Exercise";
    /// The wrong cameras.
    Mistake: "Mistake";
}

/// A command.
#[derive(Clone, Debug)]
pub struct UiCommand {
    /// The group that it is listed in.
    pub group: Group,
    /// The name within its group.
    pub name: String,
    /// A sentence that describes the command.
    pub about: String,
    /// The keys that trigger it; menus show the first one.
    pub keys: Vec<Keys>,
    /// The action.
    pub action: Action,
}

impl UiCommand {
    /// Returns the name in the palette.
    pub fn title(&self) -> String {
        format!("{}: {}", self.group.label(), self.name)
    }

    /// Returns its keys in words, such as `Ctrl+Shift+Z, Ctrl+Y`.
    pub fn keys_text(&self) -> String {
        let texts: Vec<String> = self.keys.iter().map(Keys::text).collect();
        texts.join(", ")
    }
}

static ALL: LazyLock<Vec<UiCommand>> = LazyLock::new(table::table);

/// Returns every command that does not depend on what is open, sorted by group.
pub fn all() -> &'static [UiCommand] {
    &ALL
}

/// Returns the first key of this action, such as `Ctrl+O`; empty if the action has no key.
pub fn shortcut(action: impl Into<Action>) -> String {
    command_of(&action.into())
        .and_then(|command| command.keys.first())
        .map(Keys::text)
        .unwrap_or_default()
}

/// Returns the description of an action's command, with its keys.
pub(crate) fn hint(action: impl Into<Action>) -> String {
    let Some(command) = command_of(&action.into()) else { return String::new() };
    let (about, keys) = (command.about.trim_end_matches('.'), command.keys_text());
    if keys.is_empty() { about.to_owned() } else { format!("{about} ({keys})") }
}

/// Words for keys and a mouse, and what a finger does instead.
const BY_TOUCH: [[&str; 2]; 3] =
    [["Press Space", "Tap Play"], ["Click ", "Tap "], [", then use the arrow keys", ""]];

/// Returns an instruction in the words for the last pointer, a mouse or a finger.
pub(crate) fn instruction(ctx: &Context, text: &str) -> String {
    let words = if theme::installed(ctx).by_touch { &BY_TOUCH[..] } else { &[] };
    words.iter().fold(text.to_owned(), |text, [keys, touch]| text.replace(keys, touch))
}

/// Returns the command of an action.
pub(crate) fn command_of(action: &Action) -> Option<&'static UiCommand> {
    all().iter().find(|command| command.action == *action)
}

/// Returns the name that an action's command shares, in the list of keys, with those that differ from it only
/// in direction; `None` for other actions.
fn family(action: &Action) -> Option<&'static str> {
    match action {
        Action::Select { rows: -1..=1, columns: -1..=1 } => Some("The next pixel"),
        Action::Select { .. } => Some("Ten pixels"),
        Action::Steer(Steer(CameraMove::Look, ..)) => Some("Look around (camera view)"),
        Action::Steer(Steer(CameraMove::Orbit, ..)) => Some("Orbit around at (camera view)"),
        Action::Steer(Steer(CameraMove::Zoom, ..)) => Some("Field of view (camera view)"),
        Action::Observe(Observe::Orbit(..)) => Some("Orbit the observer (world view)"),
        Action::Observe(Observe::Pan(..)) => Some("Pan the observer (world view)"),
        Action::Observe(Observe::Zoom(_)) => Some("Zoom (world view)"),
        Action::Vote(VoteAction::Choose(_)) => Some("Choose this option"),
        _ => None,
    }
}

/// Returns the keys of a family of commands, which differ only in direction: a short form such as
/// `Alt+arrows`, or a list of all keys.
fn keys_of(family: &[&UiCommand]) -> String {
    let arrows = [Key::ArrowUp, Key::ArrowDown, Key::ArrowLeft, Key::ArrowRight];
    let keys: Vec<&Keys> = family.iter().flat_map(|command| &command.keys).collect();
    let are_arrows = keys.len() == 4 && arrows.iter().all(|a| keys.iter().any(|k| k.key == *a));
    if let (true, Some(first)) = (are_arrows, keys.first())
        && keys.iter().all(|key| key.modifiers == first.modifiers)
    {
        let arrows = if first.modifiers.is_none() { "Arrows" } else { "arrows" };
        return first.held_with(arrows);
    }
    keys.iter().map(|key| key.text()).collect::<Vec<_>>().join(", ")
}

/// Returns the list of keys, by group: the commands that have keys, and the gestures. Each entry is the keys
/// and a name. Commands that differ only in direction share one entry.
pub fn sheet() -> Vec<(Group, Vec<(String, String)>)> {
    let mut groups: Vec<(Group, Vec<(String, String)>)> = Vec::new();
    let with_keys: Vec<&UiCommand> =
        all().iter().filter(|command| !command.keys.is_empty()).collect();
    let same = |a: &&UiCommand, b: &&UiCommand| {
        let name = |command: &UiCommand| family(&command.action);
        name(a).is_some() && name(a) == name(b)
    };
    let commands = with_keys.chunk_by(same).map(|commands| {
        let name = family(&commands[0].action).map_or(commands[0].name.clone(), str::to_owned);
        (commands[0].group, keys_of(commands), name)
    });
    let gestures = GESTURES.map(|(group, how, does)| (group, how.to_owned(), does.to_owned()));
    for (group, keys, name) in commands.chain(gestures) {
        match groups.iter_mut().find(|(known, _)| *known == group) {
            Some((_, rows)) => rows.push((keys, name)),
            None => groups.push((group, vec![(keys, name)])),
        }
    }
    groups
}

/// The condition under which a key works. While a dialog is open, no key works.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// Always, even while the user types into a field; the typed text is then accepted first.
    Anywhere,
    /// Except during typing.
    Untyped,
    /// While a lesson is open, even during typing.
    Lesson,
    /// While a lesson is open, except during typing.
    LessonUntyped,
    /// While a lesson is open and nothing has the focus.
    LessonUnfocused,
    /// While a vote is open whose right option is not shown yet, even during typing.
    Vote,
    /// During such a vote, except during typing.
    VoteUntyped,
    /// During such a vote, while nothing has the focus.
    VoteUnfocused,
    /// While presenting, except during typing.
    Presenting,
    /// While presenting without an open animation, except during typing.
    PresentingStill,
    /// While a view or nothing has the focus.
    View,
    /// While the camera view has the focus, or is the only view and nothing has the focus.
    CameraView,
    /// While the world view has the focus, or is the only view and nothing has the focus.
    WorldView,
}

/// A key with its modifiers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keys {
    /// The modifiers that must be held.
    pub modifiers: Modifiers,
    /// The key that is pressed.
    pub key: Key,
    /// The condition under which it works.
    pub when: When,
}

impl Keys {
    /// Returns the names of the keys, such as `Ctrl+Shift+S`.
    pub fn text(&self) -> String {
        self.held_with(name(self.key))
    }

    /// Returns the names of the modifiers and, behind them, this name.
    fn held_with(&self, name: &str) -> String {
        let held = ModifierNames::NAMES.format(&self.modifiers, false);
        if held.is_empty() { name.to_owned() } else { format!("{held}+{name}") }
    }

    /// Consumes the presses of the key and returns their number.
    fn take(self, ctx: &Context) -> usize {
        let is_other = |event: &Event| {
            !matches!(event, Event::Key { key, pressed: true, modifiers, .. }
                if *key == self.key && self.is_held(*modifiers))
        };
        ctx.input_mut(|input| {
            let before = input.events.len();
            input.events.retain(is_other);
            before - input.events.len()
        })
    }

    fn is_held(self, now: Modifiers) -> bool {
        // Punctuation may need Shift or AltGr, depending on the keyboard.
        let mut letters = name(self.key).chars();
        let begins_with_sign = letters.next().is_some_and(|c| !c.is_alphabetic());
        let is_sign = begins_with_sign && letters.next().is_none();
        let same = |now: bool, wanted: bool| now == wanted || (is_sign && !wanted);
        now.command == self.modifiers.command
            && same(now.shift, self.modifiers.shift)
            && same(now.alt, self.modifiers.alt)
    }
}

fn name(key: Key) -> &'static str {
    match key {
        Key::ArrowUp | Key::ArrowDown | Key::ArrowLeft | Key::ArrowRight => key.name(),
        Key::Comma | Key::Period => key.name(),
        Key::PageUp => "Page Up",
        Key::PageDown => "Page Down",
        _ => key.symbol_or_name(),
    }
}

/// Returns the actions of the keys that were pressed, one for each press, with the key's condition. `counts`
/// tells whether a condition holds now. If two commands share a key, a vote's gets it, or else the first one
/// in the table.
pub fn pressed(ctx: &Context, counts: impl Fn(When) -> bool) -> Vec<(When, Action)> {
    let is_key = |event: &Event| matches!(event, Event::Key { pressed: true, .. });
    if !ctx.input(|input| input.events.iter().any(is_key)) {
        return Vec::new();
    }
    let mut actions = Vec::new();
    let keys = || all().iter().flat_map(|command| command.keys.iter().map(move |k| (k, command)));
    let is_of_vote = |when| matches!(when, When::Vote | When::VoteUntyped | When::VoteUnfocused);
    let (of_vote, others): (Vec<_>, Vec<_>) = keys().partition(|(keys, _)| is_of_vote(keys.when));
    for (keys, command) in of_vote.into_iter().chain(others).filter(|(keys, _)| counts(keys.when)) {
        let times = keys.take(ctx);
        actions.extend((0..times).map(|_| (keys.when, command.action.clone())));
    }
    actions
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_commands_have_the_same_title_or_the_same_action() {
        for (k, command) in all().iter().enumerate() {
            for other in &all()[..k] {
                assert_ne!(command.title(), other.title());
                assert_ne!(command.action, other.action, "{}, {}", command.title(), other.title());
            }
        }
    }

    #[test]
    fn no_key_does_two_things_at_once() {
        let keys =
            || all().iter().flat_map(|command| command.keys.iter().map(move |key| (key, command)));
        for (k, (key, command)) in keys().enumerate() {
            for (other, owner) in keys().take(k) {
                assert_ne!(key, other, "{} and {}", command.title(), owner.title());
            }
        }
    }

    #[test]
    fn every_key_stands_in_one_entry_of_the_sheet() {
        let entries: usize = sheet().iter().map(|(_, rows)| rows.len()).sum();
        let mut names: Vec<String> =
            sheet().into_iter().flat_map(|(_, rows)| rows.into_iter().map(|row| row.1)).collect();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), entries, "a name stands twice: {names:?}");
        let keys: Vec<String> =
            sheet().into_iter().flat_map(|(_, rows)| rows.into_iter().map(|row| row.0)).collect();
        for arrows in ["Arrows", "Shift+arrows", "Alt+arrows", "Ctrl+arrows"] {
            assert!(keys.iter().any(|keys| keys == arrows), "{keys:?}");
        }
    }

    #[test]
    fn every_command_is_said_in_a_sentence() {
        for command in all() {
            assert!(command.about.ends_with('.'), "{}: {}", command.title(), command.about);
            assert!(!command.name.is_empty());
        }
    }
}
