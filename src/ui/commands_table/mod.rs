//! Every command of the program, once: its name, what it does, its keys and its [`Action`].
//!
//! Menus take their keys' names from this table, [`pressed`] looks keys up in it, and the command
//! palette and the key sheet list it, so that a key stands in one place. A command that is added
//! to `table` is found by all of them; one that is carried out elsewhere, because it needs to
//! know what is under the pointer, is a [`Gesture`].

use std::borrow::Cow;
use std::sync::LazyLock;

use egui::{Context, Event, Key, Modifiers};

use crate::ui::action::{Action, ObjectAction, Observe, Steer};

pub use search::found;
pub use table::{GESTURES, Gesture};
pub(crate) use table::{command, of_lesson};

mod search;
mod table;

/// The group of a command: a heading of the key sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// Opening, saving, quitting.
    File,
    /// Undo, redo.
    Edit,
    /// The way through a lesson.
    Lesson,
    /// Presenter mode.
    Presenting,
    /// The selected pixel and the observer.
    Views,
    /// The camera in the hand: handles, and dragging in the camera view.
    Hand,
    /// The scene's spheres and planes.
    Objects,
    /// Animations, and the camera to compare with.
    Play,
    /// The program itself.
    Program,
    /// The views that are shown.
    Layout,
    /// The items drawn over the views.
    Overlay,
    /// The colours of pictures and window.
    Colours,
    /// The form of numbers.
    Numbers,
    /// The built-in scenes.
    Scene,
    /// The lessons' steps.
    Step,
    /// The exercises.
    Exercise,
    /// The wrong cameras.
    Mistake,
    /// The method that draws the camera's picture.
    Method,
}

impl Group {
    /// Returns the heading, which the palette writes before a command's name.
    pub fn label(self) -> &'static str {
        match self {
            Group::File => "File",
            Group::Edit => "Edit",
            Group::Lesson => "Lesson",
            Group::Presenting => "Presenting",
            Group::Views => "Views",
            Group::Hand => "Manipulate",
            Group::Objects => "Objects",
            Group::Play => "Play and compare",
            Group::Program => "Program",
            Group::Layout => "Layout",
            Group::Overlay => "Overlay",
            Group::Colours => "Colours",
            Group::Numbers => "Numbers",
            Group::Scene => "Scene",
            Group::Step => "Step",
            Group::Exercise => "Exercise",
            Group::Mistake => "Mistake",
            Group::Method => "Picture drawn by",
        }
    }
}

/// A command.
#[derive(Clone, Debug)]
pub struct UiCommand {
    /// The heading that it stands under.
    pub group: Group,
    /// The name within its group.
    pub name: Cow<'static, str>,
    /// A sentence about it.
    pub about: Cow<'static, str>,
    /// The keys that do it; the first one is the one that menus tell.
    pub keys: &'static [Keys],
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

/// Every command that does not depend on what is open, by groups.
pub fn all() -> &'static [UiCommand] {
    &ALL
}

/// The first key of this action, such as `Ctrl+O`; nothing where it has none.
pub fn shortcut(action: impl Into<Action>) -> String {
    with_action(&action.into())
        .and_then(|command| command.keys.first())
        .map(Keys::text)
        .unwrap_or_default()
}

/// All keys of this action, such as `Page Down, Right`; nothing where it has none.
pub fn keys_text(action: impl Into<Action>) -> String {
    with_action(&action.into()).map(UiCommand::keys_text).unwrap_or_default()
}

fn with_action(action: &Action) -> Option<&'static UiCommand> {
    all().iter().find(|command| command.action == *action)
}

/// Returns the common name of commands that are one but for their direction.
fn family(action: &Action) -> Option<&'static str> {
    match action {
        Action::Select { rows: -1..=1, columns: -1..=1 } => Some("The next pixel"),
        Action::Select { .. } => Some("Ten pixels on"),
        Action::Steer(Steer::Look(..)) => Some("Look around (camera view)"),
        Action::Steer(Steer::Orbit(..)) => Some("Orbit around at (camera view)"),
        Action::Steer(Steer::Zoom(_)) => Some("Field of view (camera view)"),
        Action::Steer(Steer::Dolly(_)) => Some("Dolly: the eye along w (camera view)"),
        Action::Observe(Observe::Orbit(..)) => Some("Orbit the observer (world view)"),
        Action::Observe(Observe::Pan(..)) => Some("Pan the observer (world view)"),
        Action::Observe(Observe::Zoom(_)) => Some("Zoom (world view)"),
        Action::Object(ObjectAction::Next(_)) => Some("Previous and next object"),
        _ => None,
    }
}

/// The keys of commands that belong together: `Alt+arrows`, or all of them.
fn keys_of(family: &[&UiCommand]) -> String {
    let arrows = [Key::ArrowUp, Key::ArrowDown, Key::ArrowLeft, Key::ArrowRight];
    let keys: Vec<&Keys> = family.iter().flat_map(|command| command.keys).collect();
    let are_arrows = keys.len() == 4 && arrows.iter().all(|a| keys.iter().any(|k| k.key == *a));
    if let (true, Some(first)) = (are_arrows, keys.first())
        && keys.iter().all(|key| key.modifiers == first.modifiers)
    {
        let held = first.held();
        return if held.is_empty() { "Arrows".to_owned() } else { format!("{held}arrows") };
    }
    keys.iter().map(|key| key.text()).collect::<Vec<_>>().join(", ")
}

/// The commands that have keys, and the gestures, by groups; commands that differ in direction alone
/// are one entry.
pub fn sheet() -> Vec<(Group, Vec<(String, String)>)> {
    let mut groups: Vec<(Group, Vec<(String, String)>)> = Vec::new();
    let with_keys: Vec<&UiCommand> =
        all().iter().filter(|command| !command.keys.is_empty()).collect();
    let same = |a: &&UiCommand, b: &&UiCommand| {
        let name = |command: &UiCommand| family(&command.action);
        name(a).is_some() && name(a) == name(b)
    };
    let commands = with_keys.chunk_by(same).map(|commands| {
        let name = family(&commands[0].action).map_or(commands[0].name.to_string(), str::to_owned);
        (commands[0].group, keys_of(commands), name)
    });
    let gestures = GESTURES.iter().map(|g| (g.group, g.how.to_owned(), g.does.to_owned()));
    for (group, keys, name) in commands.chain(gestures) {
        match groups.iter_mut().find(|(known, _)| *known == group) {
            Some((_, rows)) => rows.push((keys, name)),
            None => groups.push((group, vec![(keys, name)])),
        }
    }
    groups
}

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
    fn held(&self) -> String {
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
