//! The rows of the table: every command with its group, name, description, keys and action, and the mouse
//! gestures.

use egui::{Key, Modifiers};
use pinhole_core::Shade;
use pinhole_exchange::{BuiltinScene, SceneSource};
use pinhole_figure::derivation::Markup;
use pinhole_figure::observer::WorldAxis;
use pinhole_figure::{Item, Scheme};
use pinhole_lecture::{Exercise, Mistake};

use crate::features::play::state::Kind;
use crate::model::lessons::{self, Lesson, StepId, Which, title_of};
use crate::model::session::{TOOLS, ThemeName, ViewLayout, shade_texts};
use crate::ui::action::{
    Action, CameraMove, FigureAction, FileAction, FileUse, Leave, LessonAction, LookAction,
    ObjectAction, Observe, PlayAction, ShareAction, Steer, Switch, VoteAction,
};
use crate::ui::commands_table::{Group, Keys, UiCommand, When};

/// Builds commands from the rows of a table.
macro_rules! commands {
    ($($group:ident, $name:expr, $about:expr, $action:expr $(=> $($keys:expr),+)?;)*) => {
        vec![$(UiCommand {
            keys: vec![$($($keys),+)?],
            ..command(Group::$group, $name, $about, $action)
        }),*]
    };
}

/// The gestures with the mouse or with held keys, each as its group, the gesture and its effect. This table
/// is only for the list of keys; other code handles the gestures.
pub const GESTURES: [(Group, &str, &str); 16] = [
    (Group::Views, "Drag in the world view", "Orbit the observer"),
    (Group::Views, "Shift+drag in the world view", "Pan the observer"),
    (Group::Views, "Wheel in the world view", "Zoom to what is under the pointer"),
    (Group::Views, "Double click", "Frame the sphere or the camera there, or everything"),
    (Group::Views, "Click", "Select the pixel, or choose the sphere, there"),
    (Group::Hand, "Drag a handle", "Move it parallel to the screen"),
    (Group::Hand, "Ctrl", "In fixed steps"),
    (Group::Hand, "Alt", "Eye orbits at, or travels"),
    (Group::Hand, "Arrows on a handle", "Move it by one step"),
    (Group::Hand, "Escape", "Cancel the drag"),
    (Group::Hand, "Right drag in the camera view", "Look around"),
    (Group::Hand, "Middle drag in the camera view", "Orbit around at"),
    (Group::Hand, "Wheel in the camera view", "Enlarge pixels"),
    (Group::Hand, "Ctrl+wheel in the camera view", "Field of view"),
    (Group::Program, "Tab, Shift+Tab", "Next and previous control"),
    (Group::Program, "Enter, Space", "Press the control in focus"),
];

const ALT: Modifiers = Modifiers::ALT;
const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

fn key(when: When, modifiers: Modifiers, key: Key) -> Keys {
    Keys { modifiers, key, when }
}

fn plain(when: When, k: Key) -> Keys {
    key(when, Modifiers::NONE, k)
}

/// Returns every command that does not depend on what is open.
pub(super) fn table() -> Vec<UiCommand> {
    let parts =
        [files, program, presenting, voting, playing, steps, views_and_objects, switches, choices];
    parts.into_iter().flat_map(|part| part()).collect()
}

#[rustfmt::skip]
fn files() -> Vec<UiCommand> {
    use When::*;
    commands![
        File, "New", "Opens an empty scene with the canonical camera.",
            Leave::New => key(Anywhere, CTRL, Key::N);
        File, "Open…", "Asks which scene or lesson to open.",
            FileUse::Open => key(Anywhere, CTRL, Key::O);
        File, "Save as…", "Asks which file to save the scene to.",
            FileUse::SaveAs(None) => key(Anywhere, CTRL_SHIFT, Key::S);
        File, "Save", "Saves the scene to its file.", FileAction::Save(None) => key(Anywhere, CTRL, Key::S);
        File, "Save as a page…", "Asks where to save a page that opens the scene or step in any browser.",
            FileUse::SavePage;
        File, "Check answers…", "Asks which file of a student's answers to grade.", FileUse::CheckAnswers;
        File, "Export a figure…", "Asks which figure to export, as SVG, PDF or PNG, and where.",
            FigureAction::Ask => key(Anywhere, CTRL, Key::E);
        File, "Copy the figure", "Copies a picture of what is shown to the clipboard.", FigureAction::Copy;
        File, "Copy the derivation as LaTeX", "Copies the derivation to the clipboard as LaTeX.",
            FigureAction::CopyDerivation(Markup::Latex);
        File, "Copy the derivation as Markdown", "Copies the derivation to the clipboard as Markdown.",
            FigureAction::CopyDerivation(Markup::Markdown);
        File, "Share…", "Shows the link to what is shown, with its QR code; while presenting, the code fills the figure until Q or Escape.",
            ShareAction::Show => plain(Untyped, Key::Q);
        File, "Save the camera for another program…", "Asks where to save the camera as glTF, or for three.js, OpenGL, C++, NumPy and others.",
            FileUse::SaveCamera;
        File, "Quit", "Closes the window.", Leave::Quit => key(Anywhere, CTRL, Key::Q);
    ]
}

#[rustfmt::skip]
fn program() -> Vec<UiCommand> {
    use When::*;
    commands![
        Edit, "Undo", "Undoes the last change to the scene.", Action::Undo => key(Untyped, CTRL, Key::Z);
        Edit, "Redo", "Redoes the change that was undone last.",
            Action::Redo => key(Untyped, CTRL_SHIFT, Key::Z), key(Untyped, CTRL, Key::Y);
        File, "Import a camera…", "Asks which glTF, or file of numbers, to take the camera from.",
            FileUse::Import;
        Edit, "Paste a camera", "Sets the camera from a glTF or from numbers on the clipboard, or opens a link.",
            Action::AskPaste => key(Untyped, CTRL, Key::V);
        Lesson, "Next step", "Shows the answer to the lesson's step, while presenting also the exercise's solution, or goes to the next step.",
            LessonAction::Next => plain(Lesson, Key::PageDown), plain(LessonUnfocused, Key::ArrowRight);
        Lesson, "Show all of the step", "Shows the answer and the remaining lines of the derivation.",
            LessonAction::ShowAll => plain(LessonUntyped, Key::End);
        Lesson, "Previous step", "Goes to the lesson's previous step. While presenting, takes back the last line or answer first.",
            LessonAction::Previous => plain(Lesson, Key::PageUp), plain(LessonUnfocused, Key::ArrowLeft);
        Lesson, "Back to the step", "Resets everything to the lesson's step.",
            Leave::BackToStep => plain(LessonUntyped, Key::R);
        Lesson, "Close the lesson", "Closes the lesson; its scene stays open.", LessonAction::Close;
        Lesson, "All steps", "Lists the steps of all lessons; a few letters or a number such as 7.4 find one.",
            Action::OpenContents => plain(Untyped, Key::O);
        Views, "Frame all", "Moves the observer until everything is in view.",
            Observe::FrameAll => plain(View, Key::F), plain(View, Key::Home);
        Views, "Keep this view in the scene", "Lets the scene open with the world view as it is now.",
            FileAction::KeepView;
        Views, "Save this view as a step…", "Asks which lesson to add what is shown to, as its last step.",
            FileUse::SaveStep;
        Views, "Recap: from view to the ray", "Shows in six lines how view, w, u, v, d and the ray come about; again to end.",
            LookAction::Recap => plain(Untyped, Key::W);
        Program, "Side panel", "Shows or hides the panel with camera and objects.",
            LookAction::Toggle(Switch::Panel) => key(Anywhere, CTRL, Key::B);
        Program, "Command palette", "Finds a command by a few of its letters.",
            Action::OpenPalette => key(Anywhere, CTRL, Key::P),
                key(Anywhere, CTRL_SHIFT, Key::P), plain(Untyped, Key::Slash);
        Program, "Keys", "Shows all keys on one sheet.",
            Action::ShowKeys => plain(Untyped, Key::Questionmark), plain(Untyped, Key::F1);
        Program, "The lecture's conventions", "Shows what u, v, w, a pixel and a hit mean here.",
            Action::ShowConventions;
        Program, "About Pinhole", "Shows the version and the licences.", Action::ShowAbout;
        Program, "Larger", "Makes everything in the window larger; while presenting, the text.",
            LookAction::ZoomBy(1) => key(Anywhere, CTRL, Key::Plus), key(Anywhere, CTRL, Key::Equals);
        Program, "Smaller", "Makes everything in the window smaller; while presenting, the text.",
            LookAction::ZoomBy(-1) => key(Anywhere, CTRL, Key::Minus);
        Program, "Reset zoom", "Shows everything in the window at its normal size.",
            LookAction::ZoomBy(0) => key(Anywhere, CTRL, Key::Num0);
    ]
}

#[rustfmt::skip]
fn presenting() -> Vec<UiCommand> {
    use When::*;
    commands![
        Presenting, "Present", "Fills the screen with the views, in large text and thick lines; again to end.",
            LookAction::Present => plain(Anywhere, Key::F5);
        Presenting, "Maximise the derivation", "Fills the window with the derivation.",
            LookAction::Fill(ViewLayout::DerivationAlone) => plain(Presenting, Key::Num1);
        Presenting, "Maximise the world view", "Fills the window with the world view.",
            LookAction::Fill(ViewLayout::World) => plain(Presenting, Key::Num2);
        Presenting, "Maximise the camera view", "Fills the window with the camera view; on a lesson's stage, it and the world view change places.",
            LookAction::Fill(ViewLayout::Camera) => plain(Presenting, Key::Num3);
        Presenting, "Maximise both views", "Fills the window with both views.",
            LookAction::Fill(ViewLayout::Both) => plain(Presenting, Key::Num4);
        Presenting, "Numbers", "Shows or hides the numbers below the views.",
            LookAction::Toggle(Switch::PresentedNumbers) => plain(Presenting, Key::N);
        Presenting, "Pen", "Draws over the views; Escape erases the strokes.",
            LookAction::Toggle(Switch::Pen) => plain(Presenting, Key::P);
        Presenting, "Colour of the pen", "Takes the pen's next colour, of three.",
            LookAction::NextPenColor => plain(Presenting, Key::C);
        Presenting, "Light or dark", "Switches between the light and the dark theme; afterwards the window has its own again.",
            LookAction::SwitchTheme => plain(Presenting, Key::T);
        Presenting, "Blank screen", "Turns the screen black; any key or click brings the picture back.",
            LookAction::Blank => plain(Presenting, Key::B), plain(PresentingStill, Key::Period);
    ]
}

#[rustfmt::skip]
fn voting() -> Vec<UiCommand> {
    use When::{LessonUntyped, Vote, VoteUnfocused, VoteUntyped};
    let letters = pinhole_lecture::Vote::LETTERS.into_iter().filter_map(Key::from_name).enumerate();
    let mut commands: Vec<UiCommand> = letters.map(|(option, letter)| UiCommand {
        keys: vec![plain(VoteUntyped, letter)],
        ..command(Group::Vote, letter.name(), "Chooses this option of the vote.", VoteAction::Choose(option))
    }).collect();
    commands.extend(commands![
        Vote, "Vote on the question", "Shows answers to the question of the lesson's step, among which the class votes.",
            LessonAction::Vote => plain(LessonUntyped, Key::V);
        Vote, "Count hands", "Asks for the numbers of raised hands, which are drawn as bars.",
            VoteAction::CountHands => plain(VoteUntyped, Key::H);
        Vote, "Second round", "Lets the class vote again; the first round's bars stay.",
            VoteAction::NextRound => plain(VoteUntyped, Key::V);
        Vote, "Reveal", "Shows which option is right, and then why.",
            VoteAction::Reveal => plain(Vote, Key::PageDown), plain(VoteUnfocused, Key::Enter);
    ]);
    commands
}

#[rustfmt::skip]
fn playing() -> Vec<UiCommand> {
    use When::*;
    commands![
        Play, "Roll", "Turns up around view: the camera rolls and keeps its view direction.",
            PlayAction::Open(Kind::SwingUp);
        Play, "Orbit", "Moves the camera once around what it looks at.", PlayAction::Open(Kind::Orbit);
        Play, "Tilt past up", "Tilts the camera until view meets up, and past it: the picture flips.",
            PlayAction::Open(Kind::OverTheTop);
        Play, "Walk along the ray", "Moves t from the eye to the ray's hit.", PlayAction::Open(Kind::Walk);
        Play, "Scan the pixels", "Traces the rays row by row, as a renderer does.",
            PlayAction::Open(Kind::Scan);
        Play, "Play or pause", "Runs or pauses the open animation.",
            PlayAction::Toggle => plain(View, Key::Space);
        Play, "Step forward", "Moves the open animation one step forward.",
            PlayAction::Step(1) => plain(Untyped, Key::Period);
        Play, "Step back", "Moves the open animation one step back.",
            PlayAction::Step(-1) => plain(Untyped, Key::Comma);
        Play, "Freeze the camera as a ghost", "Keeps a copy of the camera, the ghost, to compare with.",
            Action::FreezeGhost => plain(Untyped, Key::G);
        Play, "Remove the ghost", "Removes the ghost.",
            Action::DropGhost => key(Untyped, Modifiers::SHIFT, Key::G);
        Play, "Loop", "Turns repetition of the open animation on or off.",
            PlayAction::Loop => plain(Untyped, Key::L);
        Play, "Keep", "Closes the animation and keeps the current state.", PlayAction::Keep;
        Play, "Stop", "Closes the animation and restores the state from before it.", PlayAction::Close;
        Play, "Export the animation…", "Asks how to export the open animation.", FigureAction::AskAnimation;
    ]
}

/// The arrow keys, each with its direction in words and its steps to the right and up.
const ARROWS: [(Key, &str, i32, i32); 4] = [
    (Key::ArrowUp, "up", 0, 1),
    (Key::ArrowDown, "down", 0, -1),
    (Key::ArrowLeft, "to the left", -1, 0),
    (Key::ArrowRight, "to the right", 1, 0),
];

/// Returns the commands of the arrow keys in the views.
#[rustfmt::skip]
fn steps() -> Vec<UiCommand> {
    use When::{CameraView, View, WorldView};
    let mut commands = Vec::new();
    // `{}` stands for the direction.
    let mut add = |group, when, modifiers, name: &str, about: &str, action: fn(i32, i32) -> Action| {
        for (arrow, way, right, up) in ARROWS {
            let [name, about] = [name, about].map(|text| text.replace("{}", way));
            let keys = vec![key(when, modifiers, arrow)];
            commands.push(UiCommand { keys, ..command(group, &name, &about, action(right, up)) });
        }
    };
    add(Group::Views, View, Modifiers::NONE, "One pixel {}", "Moves the selection {} by one pixel.",
        |x, y| Action::Select { rows: -i64::from(y), columns: x.into() });
    add(Group::Views, View, Modifiers::SHIFT, "Ten pixels {}", "Moves the selection {} by ten pixels.",
        |x, y| Action::Select { rows: -10 * i64::from(y), columns: 10 * i64::from(x) });
    add(Group::Hand, CameraView, ALT, "Look {}", "Turns the camera {}.", |x, y| Steer(CameraMove::Look, x, y).into());
    add(Group::Hand, CameraView, CTRL, "Orbit {}", "Moves the eye {} around what it looks at.",
        |x, y| Steer(CameraMove::Orbit, x, y).into());
    add(Group::Views, WorldView, CTRL, "Observer {}", "Moves the observer {} around what it looks at.",
        |x, y| Observe::Orbit(x, y).into());
    add(Group::Views, WorldView, ALT, "Pan {}", "Moves the world view {}.", |x, y| Observe::Pan(x, y).into());
    commands
}

/// Returns a command without keys.
pub(crate) fn command(
    group: Group,
    name: &str,
    about: &str,
    action: impl Into<Action>,
) -> UiCommand {
    let dot = if about.ends_with('.') { "" } else { "." };
    let (name, about) = (name.to_owned(), format!("{about}{dot}"));
    UiCommand { group, name, about, keys: Vec::new(), action: action.into() }
}

#[rustfmt::skip]
fn switches() -> Vec<UiCommand> {
    let mut commands = Vec::new();
    for item in Item::ALL {
        let (name, action) = (item.label(), LookAction::Toggle(Switch::Item(item)));
        commands.push(command(Group::Overlay, name, &format!("Shows or hides {name}"), action));
    }
    commands.extend(commands![
        Numbers, "Exact forms in the derivation", "Writes 1/√2 and the like, or decimals.",
            LookAction::Toggle(Switch::ExactForms);
        Numbers, "Count from 1", "Counts rows and columns from 1, or from 0.",
            LookAction::Toggle(Switch::CountFromOne);
        Colours, "Reduced motion", "Turns off transitions.", LookAction::Toggle(Switch::ReducedMotion);
    ]);
    commands
}

/// Returns the commands that choose one of several alternatives, such as a layout, a shading, a scene,
/// a mistake, an exercise or a lesson step.
fn choices() -> Vec<UiCommand> {
    let mut commands = Vec::new();
    let mut add = |group, name: &str, about: &str, action: Action| {
        commands.push(command(group, name, about, action));
    };
    let is_there = |layout: &ViewLayout| layout.workspace().is_some() || TOOLS.contains(layout);
    for layout in ViewLayout::ALL.into_iter().filter(is_there) {
        add(Group::Layout, layout.label(), layout.about(), LookAction::Layout(layout).into());
    }
    for shade in Shade::ALL {
        let [label, about] = shade_texts(shade);
        add(Group::Colours, &format!("shading {label}"), about, LookAction::Shade(shade).into());
    }
    for theme in ThemeName::ALL {
        let about = "Colours the window's background.";
        add(Group::Colours, theme.label(), about, LookAction::Theme(theme).into());
    }
    for scheme in Scheme::ALL {
        add(Group::Colours, scheme.label(), scheme.about(), LookAction::Scheme(scheme).into());
    }
    for scene in BuiltinScene::all() {
        let action = Leave::Open(SceneSource::Builtin(scene));
        add(Group::Scene, scene.name, &scene.summary(), action.into());
    }
    let about = "Vote: a wrong picture, and four mistakes, one of which caused it.";
    add(Group::Mistake, "Guess which", about, LookAction::Vote.into());
    for &mistake in Mistake::GALLERY {
        add(Group::Mistake, mistake.name(), mistake.shows(), LookAction::Mistake(mistake).into());
    }
    for &exercise in Exercise::LISTED {
        let action = LookAction::Exercise(exercise);
        add(Group::Exercise, exercise.title(), "Asks this question.", action.into());
    }
    for (index, lesson) in lessons::builtin::all().iter().enumerate() {
        commands.extend(of_lesson(Which::Builtin(index), lesson));
    }
    commands
}

/// Returns a command for each step of a lesson.
pub(crate) fn of_lesson(which: Which, lesson: &Lesson) -> Vec<UiCommand> {
    let title = title_of(which, lesson);
    let steps = lesson.steps.iter().enumerate().map(|(step, shown)| {
        let name = format!("{title}, {}. {}", step + 1, shown.title);
        let about = "Shows this step of the lesson.";
        command(Group::Step, &name, about, Leave::GoTo(StepId { lesson: which, step }))
    });
    steps.collect()
}

#[rustfmt::skip]
fn views_and_objects() -> Vec<UiCommand> {
    use When::*;
    commands![
        Hand, "Narrow the field of view", "Makes the viewport smaller and the picture's contents larger.",
            Steer(CameraMove::Zoom, 1, 0) => plain(CameraView, Key::Plus), plain(CameraView, Key::Equals);
        Hand, "Widen the field of view", "Makes the viewport larger and the picture's contents smaller.",
            Steer(CameraMove::Zoom, -1, 0) => plain(CameraView, Key::Minus);
        Views, "Frame the camera", "Moves the observer until eye and viewport fill the world view.",
            Observe::FrameCamera => key(View, Modifiers::SHIFT, Key::F);
        Views, "Look along x", "Shows the scene from the side; again, from the other side.",
            Observe::Along(WorldAxis::X) => plain(View, Key::X);
        Views, "Look along y", "Shows the scene from above; again, from below.",
            Observe::Along(WorldAxis::Y) => plain(View, Key::Y);
        Views, "Look along z", "Shows the scene from the front; again, from behind.",
            Observe::Along(WorldAxis::Z) => plain(View, Key::Z);
        Views, "Observer nearer", "Moves the observer nearer to what it looks at.",
            Observe::Zoom(1) => plain(WorldView, Key::Plus), plain(WorldView, Key::Equals);
        Views, "Observer farther", "Moves the observer away from what it looks at.",
            Observe::Zoom(-1) => plain(WorldView, Key::Minus);
        Objects, "+ Sphere", "Adds a sphere that the camera sees, and chooses it.", ObjectAction::AddSphere;
        Objects, "+ Plane", "Adds a plane below the origin, and chooses it.", ObjectAction::AddPlane;
        Objects, "Delete the chosen object", "Deletes it from the scene.",
            ObjectAction::Delete => plain(Untyped, Key::Delete);
        Objects, "Duplicate the chosen object", "Adds a copy beside it, and chooses it.",
            ObjectAction::Duplicate => key(Untyped, CTRL, Key::D);
        Hand, "Eye travels", "On: moving the eye keeps the view direction. Off: the eye orbits at.",
            LookAction::Toggle(Switch::EyeTravels);
        Hand, "Keep up", "On: up stays fixed while eye or at is dragged. Off: up turns with the camera where view comes close to it.",
            LookAction::Toggle(Switch::KeepUp);
    ]
}
