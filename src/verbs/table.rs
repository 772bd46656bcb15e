//! The commands themselves.

/// Commands, written as the table that they are.
macro_rules! verbs {
    ($($group:ident, $name:expr, $about:expr, [$($keys:expr),*], $action:expr;)*) => {
        vec![$(Verb {
            group: Group::$group,
            name: std::borrow::Cow::Borrowed($name),
            about: std::borrow::Cow::Borrowed($about),
            keys: const { &[$($keys),*] },
            action: $action,
        }),*]
    };
}

mod hand;

use std::borrow::Cow;

use egui::{Key, Modifiers};
use pinhole_core::Shade;
use pinhole_core::methods::Method;
use pinhole_lecture::exercises::{Exercise, title};
use pinhole_lecture::mistakes::Mistake;

use super::{Group, Keys, Verb, When};
use crate::action::{Action, GhostMove, PlayMove, Switch};
use crate::formats::builtin;
use crate::formats::scene_argument::SceneSource;
use crate::ledger::{LedgerSection, Markup};
use crate::lessons::{self, Lesson, Place, Which, title_of};
use crate::overlay::{Item, Scheme};
use crate::play::Kind;
use crate::presenter::Full;
use crate::session::{MethodName, ShadeName, ThemeName, ViewLayout};
use crate::translator::Target;

/// Something that is done with the mouse, or with keys that are held: listed, not looked up.
#[derive(Clone, Copy, Debug)]
pub struct Gesture {
    /// What it belongs to.
    pub group: Group,
    /// How it is done.
    pub how: &'static str,
    /// What it does.
    pub does: &'static str,
}

/// What the mouse does.
pub const GESTURES: &[Gesture] = &[
    Gesture { group: Group::Views, how: "Drag in the world view", does: "Orbit the observer" },
    Gesture { group: Group::Views, how: "Shift+drag there", does: "Pan the observer" },
    Gesture { group: Group::Views, how: "Wheel there", does: "Zoom" },
    Gesture { group: Group::Views, how: "Click", does: "Select the pixel there" },
    Gesture { group: Group::Hand, how: "Drag a handle", does: "Move it in the picture's plane" },
    Gesture { group: Group::Hand, how: "X, Y, Z, U, V, W", does: "Along this axis" },
    Gesture { group: Group::Hand, how: "Shift+one of them", does: "In the plane of the other two" },
    Gesture { group: Group::Hand, how: "Ctrl", does: "In round steps" },
    Gesture { group: Group::Hand, how: "K, Alt", does: "Eye orbits at, or travels" },
    Gesture { group: Group::Hand, how: "Arrows on a handle", does: "Move the one in focus a step" },
    Gesture { group: Group::Hand, how: "Escape", does: "Give back what is dragged" },
    Gesture { group: Group::Hand, how: "Right drag in the camera view", does: "Look round" },
    Gesture { group: Group::Hand, how: "Middle drag there", does: "Orbit round at" },
    Gesture { group: Group::Hand, how: "Wheel there", does: "Field of view" },
    Gesture { group: Group::Hand, how: "Ctrl+wheel there", does: "Dolly" },
    Gesture { group: Group::Program, how: "Tab, Shift+Tab", does: "Next and previous control" },
    Gesture { group: Group::Program, how: "Enter, Space", does: "Press the control in focus" },
];

const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

const fn key(when: When, modifiers: Modifiers, key: Key) -> Keys {
    Keys { modifiers, key, when }
}

const fn plain(when: When, k: Key) -> Keys {
    key(when, Modifiers::NONE, k)
}

/// Every command that does not depend on what is open.
pub(super) fn table() -> Vec<Verb> {
    let mut verbs = program();
    verbs.extend(presenting());
    verbs.extend(playing());
    verbs.extend(hand::strip());
    verbs.extend(pixel_steps());
    verbs.extend(hand::hand());
    verbs.extend(layouts());
    verbs.extend(translations());
    verbs.extend(switches());
    verbs.extend(looks());
    verbs.extend(places());
    verbs
}

#[rustfmt::skip]
fn program() -> Vec<Verb> {
    use When::*;
    verbs![
        File, "Open…", "Asks which scene or lesson to open.",
            [key(Anywhere, CTRL, Key::O)], Action::AskOpen;
        File, "Save as…", "Asks which file to save the scene to.",
            [key(Anywhere, CTRL_SHIFT, Key::S)], Action::AskSaveAs;
        File, "Save", "Saves the scene to its file.",
            [key(Anywhere, CTRL, Key::S)], Action::Save;
        File, "Check answers…", "Asks which file of a student’s answers to grade.",
            [], Action::AskAnswers;
        File, "Export a figure…", "Asks which figure to write to which file.",
            [key(Anywhere, CTRL, Key::E)], Action::AskExport;
        File, "Copy the ledger as LaTeX", "Puts the ledger on the clipboard as LaTeX.",
            [], Action::CopyLedger(Markup::Latex);
        File, "Copy the ledger as Markdown", "Puts the ledger on the clipboard as Markdown.",
            [], Action::CopyLedger(Markup::Markdown);
        File, "Save the camera for another program…", "Asks which file to write the translator's text to.",
            [], Action::AskTranslate;
        File, "Quit", "Closes the window.",
            [key(Anywhere, CTRL, Key::Q)], Action::Quit;
        Edit, "Undo", "Takes back the last change of the scene.",
            [key(Untyped, CTRL, Key::Z)], Action::Undo;
        Edit, "Redo", "Does again what was taken back last.",
            [key(Untyped, CTRL_SHIFT, Key::Z), key(Untyped, CTRL, Key::Y)], Action::Redo;
        Edit, "Paste a camera", "Sets the camera from another program's text on the clipboard.",
            [key(Untyped, CTRL, Key::V)], Action::AskPaste;
        Lesson, "Next step", "Goes to the lesson's next step.",
            [plain(Lesson, Key::PageDown), plain(LessonUnfocused, Key::ArrowRight)], Action::Next;
        Lesson, "Previous step", "Goes to the lesson's step before this one.",
            [plain(Lesson, Key::PageUp), plain(LessonUnfocused, Key::ArrowLeft)], Action::Previous;
        Lesson, "Back to the step", "Sets everything as the lesson's step says.",
            [plain(LessonUntyped, Key::R)], Action::BackToStep;
        Lesson, "Close the lesson", "Closes the lesson; its scene stays open.", [], Action::CloseLesson;
        Views, "Frame all", "Puts the observer where everything can be seen.",
            [plain(View, Key::F), plain(View, Key::Home)], Action::FrameAll;
        Program, "Command palette", "Finds a command by a few of its letters.",
            [key(Anywhere, CTRL, Key::P), key(Anywhere, CTRL_SHIFT, Key::P), plain(Untyped, Key::Slash)],
            Action::Palette;
        Program, "Keys", "Shows all keys on one sheet.",
            [plain(Untyped, Key::Questionmark), plain(Untyped, Key::F1)], Action::KeySheet;
        Program, "Larger", "Makes everything in the window larger; while presenting, the text.",
            [key(Anywhere, CTRL, Key::Plus), key(Anywhere, CTRL, Key::Equals)], Action::ZoomBy(1);
        Program, "Smaller", "Makes everything in the window smaller; while presenting, the text.",
            [key(Anywhere, CTRL, Key::Minus)], Action::ZoomBy(-1);
        Program, "Usual size", "Makes everything in the window as large as at first.",
            [key(Anywhere, CTRL, Key::Num0)], Action::ZoomBy(0);
    ]
}

#[rustfmt::skip]
fn presenting() -> Vec<Verb> {
    use When::*;
    verbs![
        Presenting, "Presenter mode",
            "Puts panels away and makes text and lines large; once more gives back the window as it was.",
            [plain(Anywhere, Key::F5)], Action::Present;
        Presenting, "Ledger full", "Fills the window with the ledger.",
            [plain(Presenting, Key::Num1)], Action::Fill(Full::Ledger);
        Presenting, "World view full", "Fills the window with the world view.",
            [plain(Presenting, Key::Num2)], Action::Fill(Full::World);
        Presenting, "Camera view full", "Fills the window with the camera view.",
            [plain(Presenting, Key::Num3)], Action::Fill(Full::Camera);
        Presenting, "Both views full", "Fills the window with both views.",
            [plain(Presenting, Key::Num4)], Action::Fill(Full::Both);
        Presenting, "Spotlight", "Dims all but what is round the pointer.",
            [plain(Presenting, Key::S)], Action::Toggle(Switch::Spotlight);
    ]
}

#[rustfmt::skip]
fn playing() -> Vec<Verb> {
    use When::*;
    let play = |kind| Action::Play(PlayMove::Open(kind));
    verbs![
        Play, "Swing up", "Turns up round the view: all these cameras look along one line.",
            [], play(Kind::SwingUp);
        Play, "Orbit", "Takes the camera once round what it looks at.", [], play(Kind::Orbit);
        Play, "Walk along the ray", "Runs t from the eye to what the ray hits.", [], play(Kind::Walk);
        Play, "Scan the pixels", "Sends out the rays row by row, as a renderer does.",
            [], play(Kind::Scan);
        Play, "Play or pause", "Lets the open animation run, or rest.",
            [plain(View, Key::Space)], Action::Play(PlayMove::Toggle);
        Play, "Step on", "Takes the open animation a step on.",
            [plain(Untyped, Key::Period)], Action::Play(PlayMove::Step(1));
        Play, "Step back", "Takes the open animation a step back.",
            [plain(Untyped, Key::Comma)], Action::Play(PlayMove::Step(-1));
        Play, "Freeze the camera as a ghost", "Makes the camera the ghost, to compare with.",
            [plain(Untyped, Key::G)], Action::Ghost(GhostMove::Freeze);
        Play, "Drop the ghost", "Takes the frozen camera away.",
            [key(Untyped, Modifiers::SHIFT, Key::G)], Action::Ghost(GhostMove::Drop);
        Play, "Swap camera and ghost", "Lets camera and frozen camera change places.",
            [], Action::Ghost(GhostMove::Swap);
    ]
}

#[rustfmt::skip]
fn pixel_steps() -> Vec<Verb> {
    use When::View;
    let go = |rows, columns| Action::Step { rows, columns };
    const FAR: Modifiers = Modifiers::SHIFT;
    verbs![
        Views, "Pixel above", "Selects the pixel above.", [plain(View, Key::ArrowUp)], go(-1, 0);
        Views, "Pixel below", "Selects the pixel below.", [plain(View, Key::ArrowDown)], go(1, 0);
        Views, "Pixel to the left", "Selects the pixel to the left.",
            [plain(View, Key::ArrowLeft)], go(0, -1);
        Views, "Pixel to the right", "Selects the pixel to the right.",
            [plain(View, Key::ArrowRight)], go(0, 1);
        Views, "Ten pixels up", "Selects the tenth pixel above.",
            [key(View, FAR, Key::ArrowUp)], go(-10, 0);
        Views, "Ten pixels down", "Selects the tenth pixel below.",
            [key(View, FAR, Key::ArrowDown)], go(10, 0);
        Views, "Ten pixels to the left", "Selects the tenth pixel to the left.",
            [key(View, FAR, Key::ArrowLeft)], go(0, -10);
        Views, "Ten pixels to the right", "Selects the tenth pixel to the right.",
            [key(View, FAR, Key::ArrowRight)], go(0, 10);
    ]
}

fn verb(
    group: Group,
    name: impl Into<Cow<'static, str>>,
    about: impl Into<Cow<'static, str>>,
    action: Action,
) -> Verb {
    let about: Cow<'static, str> = about.into();
    let about = if about.ends_with('.') { about } else { Cow::Owned(format!("{about}.")) };
    Verb { group, name: name.into(), about, keys: &[], action }
}

fn layouts() -> impl Iterator<Item = Verb> {
    ViewLayout::LISTED
        .into_iter()
        .map(|layout| verb(Group::Layout, layout.label(), layout.about(), Action::Layout(layout)))
}

fn translations() -> impl Iterator<Item = Verb> {
    Target::all().map(|target| {
        let name = format!("translate into {}", target.label());
        let about = "Shows the camera in these terms.";
        verb(Group::Layout, name, about, Action::TranslateInto(target.name()))
    })
}

fn switches() -> Vec<Verb> {
    let of = |switch: Switch, group, name: Cow<'static, str>, about: Cow<'static, str>| {
        verb(group, name, about, Action::Toggle(switch))
    };
    let mut verbs: Vec<Verb> = Item::ALL
        .into_iter()
        .map(|item| {
            let about = format!("Shows or hides {}.", item.label());
            of(Switch::Item(item), Group::Overlay, item.label().into(), about.into())
        })
        .collect();
    verbs.extend(LedgerSection::ALL.into_iter().map(|section| {
        let name = format!("ledger’s part “{}”", section.label());
        let about = format!("Shows or hides the {name}.");
        of(Switch::Section(section), Group::Layout, name.into(), about.into())
    }));
    verbs.extend([
        of(
            Switch::CountFromOne,
            Group::Numbers,
            "Count from 1".into(),
            "Counts rows and columns from 1, or from 0.".into(),
        ),
        of(
            Switch::ReducedMotion,
            Group::Colours,
            "Reduced motion".into(),
            "Lets nothing move by itself: no transitions.".into(),
        ),
        verb(Group::Numbers, "More digits", "Shows one digit more.", Action::DigitsBy(1)),
        verb(Group::Numbers, "Fewer digits", "Shows one digit less.", Action::DigitsBy(-1)),
    ]);
    verbs
}

fn looks() -> Vec<Verb> {
    let mut verbs = Vec::new();
    for shade in ShadeName::ALL {
        let name = format!("shade by {}", Shade::from(shade).name());
        verbs.push(verb(Group::Colours, name, shade.about(), Action::Shade(shade)));
    }
    for theme in ThemeName::ALL {
        let about = "Colours the window's background.";
        verbs.push(verb(Group::Colours, theme.label(), about, Action::Theme(theme)));
    }
    for scheme in Scheme::ALL {
        verbs.push(verb(Group::Colours, scheme.label(), scheme.about(), Action::Scheme(scheme)));
    }
    for &method in Method::ALL {
        let action = Action::Method(MethodName(method));
        verbs.push(verb(Group::Method, method.name(), method.about(), action));
    }
    verbs
}

fn places() -> Vec<Verb> {
    let mut verbs = Vec::new();
    for scene in builtin::all() {
        let action = Action::Open(SceneSource::Builtin(scene));
        verbs.push(verb(Group::Scene, scene.name, scene.summary(), action));
    }
    for (index, lesson) in lessons::builtin::all().iter().enumerate() {
        verbs.extend(of_lesson(Which::Builtin(index), lesson));
    }
    for &exercise in Exercise::ALL {
        let name = title(exercise);
        verbs.push(verb(Group::Exercise, name, "Asks this.", Action::Exercise(exercise)));
    }
    for &mistake in Mistake::GALLERY {
        let action = Action::Mistake(mistake);
        verbs.push(verb(Group::Mistake, mistake.name(), mistake.shows(), action));
    }
    verbs
}

/// A command for each step of a lesson.
pub fn of_lesson(which: Which, lesson: &Lesson) -> Vec<Verb> {
    let title = title_of(which, lesson);
    let steps = lesson.steps.iter().enumerate().map(|(step, of)| {
        let name = format!("{title}, {}. {}", step + 1, of.title);
        let about = "Shows this step of the lesson.";
        verb(Group::Step, name, about, Action::GoTo(Place { lesson: which, step }))
    });
    steps.collect()
}
