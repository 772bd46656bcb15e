//! Actions: the user's commands that do more than edit a value of the document or the session in place.
//! Panels, keys and dialogs request them, and the window applies them.

use std::path::PathBuf;

use egui::{Context, Id};
use pinhole_core::steering::Keep;
use pinhole_core::{Shade, Sphere};
use pinhole_exchange::SceneSource;
use pinhole_exchange::host::host;
use pinhole_exchange::link::Link;
use pinhole_figure::derivation::Markup;
use pinhole_figure::observer::WorldAxis;
use pinhole_figure::overlay::PointShown;
use pinhole_figure::{Given, Item, Scheme};
use pinhole_lecture::{Exercise, Mistake};

use crate::features::export::animation::Frames;
use crate::features::export::order::Order;
use crate::features::play::state::Kind;
use crate::model::session::presenting::Pen;
use crate::model::{Session, StepId, ThemeName, ViewLayout};

/// An action that leaves the open scene. The user is first asked about unsaved changes.
#[derive(Clone, Debug, PartialEq)]
pub enum Leave {
    /// Open an empty scene.
    New,
    /// Open a scene.
    Open(SceneSource),
    /// Open what a link shows.
    Follow(Box<Link>),
    /// Show this step of a lesson.
    GoTo(StepId),
    /// Reset everything to the open lesson's step.
    BackToStep,
    /// Open the recovered changes that were offered.
    Restore {
        /// True to open the changes as a new scene, so that the file of the changed scene stays as it is.
        as_new: bool,
    },
    /// Close the window.
    Quit,
}

/// The use of a file that the user chooses.
#[derive(Clone, Debug, PartialEq)]
pub enum FileUse {
    /// Open a scene, or whatever else the file holds.
    Open,
    /// Save the scene to it, and take the action once the scene is saved.
    SaveAs(Option<Leave>),
    /// Save the scene, or the lesson's step, as a page for a browser.
    SavePage,
    /// Add what is shown to a lesson file, as its last step.
    SaveStep,
    /// Set the camera from another program's file.
    Import,
    /// Save the translated camera.
    SaveCamera,
    /// Grade a student's answers.
    CheckAnswers,
}

impl FileUse {
    /// Returns true if the file gets the scene as it is shown.
    pub(crate) fn saves_scene(&self) -> bool {
        matches!(self, FileUse::SaveAs(_) | FileUse::SavePage | FileUse::SaveStep)
    }
}

/// Saves the scene, or settles what becomes of changes to it.
#[derive(Clone, Debug, PartialEq)]
pub enum FileAction {
    /// Save to the scene's file, or ask for one if the scene has none; take the action once the scene is saved.
    Save(Option<Leave>),
    /// Let the scene open with the observer that is shown. Moving the observer alone never changes a scene.
    KeepView,
    /// Leave without saving.
    Discard(Leave),
    /// Delete the recovered changes that were offered.
    DiscardRecovered,
    /// Read the scene's file again if another program has changed it.
    CheckFile,
    /// Keep the user's version of a scene whose file another program has changed. Saving then overwrites the
    /// other program's changes.
    KeepMine {
        /// True to save at once.
        saves: bool,
        /// The action to take once the scene is saved.
        then: Option<Leave>,
    },
    /// Open the version that another program has written, and then take the action.
    TakeTheirs(Option<Leave>),
}

/// Moves through the open lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LessonAction {
    /// Show the next step.
    Next,
    /// Show the previous step.
    Previous,
    /// Show the step's answer and all lines of its derivation.
    ShowAll,
    /// Open a vote on the step's question.
    Vote,
    /// Close the lesson; its scene stays open.
    Close,
}

/// Writes what the window shows to a file or the clipboard.
#[derive(Clone, Debug, PartialEq)]
pub enum FigureAction {
    /// Ask which figure to export.
    Ask,
    /// Write a figure to a file.
    Export(Order, PathBuf),
    /// Ask how to export the open animation.
    AskAnimation,
    /// Write an animation of these frames, each of which is such a figure, to a file.
    ExportAnimation(Order, Frames, PathBuf),
    /// Copy the figure of the open page to the clipboard.
    Copy,
    /// Copy the derivation to the clipboard.
    CopyDerivation(Markup),
}

/// Shares what the window shows as a link, or the answers to an exercise as a code; opens a link.
#[derive(Clone, Debug, PartialEq)]
pub enum ShareAction {
    /// Show the link to what the window shows. While presenting, its code fills the figure; again to end.
    Show,
    /// Open what this link shows.
    Follow(String),
    /// Copy this link to the clipboard.
    Copy(String),
    /// Copy the code of the answers to the open exercise to the clipboard.
    CopyAnswer,
}

/// Closes a student's answers, starts the exercises over, and collects codes of a class's answers.
#[derive(Clone, Debug, PartialEq)]
pub enum AnswersAction {
    /// Close the student's answers.
    PutAway,
    /// Ask whether to start the exercises over.
    AskStartOver,
    /// Forget which exercises are done, and what was typed in them.
    StartOver,
    /// Add a text with codes of a class's answers.
    AddCodes(String),
}

/// Opens or controls an animation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlayAction {
    /// Open an animation at its start.
    Open(Kind),
    /// Play or pause.
    Toggle,
    /// Move forward by this many steps, or back if negative.
    Step(i64),
    /// Toggle whether the animation repeats after its end.
    Loop,
    /// Close the animation and keep the current state.
    Keep,
    /// Close the animation and restore the state from before it.
    Close,
}

/// A way in which a drag, a key or the wheel moves the camera in the camera view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CameraMove {
    /// Look around.
    Look,
    /// Orbit the eye around *at*.
    Orbit,
    /// Narrow the field of view.
    Zoom,
}

/// Moves the camera by key presses, as drags do in the camera view: by these numbers of steps to the right and
/// up. A zoom counts only the first one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Steer(pub CameraMove, pub i32, pub i32);

/// Moves the observer, the camera from which the world view is drawn. Whole numbers count steps, as in
/// [`Steer`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Observe {
    /// Orbit the point that the observer looks at.
    Orbit(i32, i32),
    /// Move sideways.
    Pan(i32, i32),
    /// Move nearer.
    Zoom(i32),
    /// Move nearer to a point by a factor; the point keeps its place in the view.
    ZoomTo(PointShown, f64),
    /// Look along an axis.
    Along(WorldAxis),
    /// Frame a sphere.
    FrameSphere(Sphere),
    /// Frame the eye and the viewport.
    FrameCamera,
    /// Frame the whole scene.
    FrameAll,
}

/// Adds or deletes one of the scene's objects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ObjectAction {
    /// Add a sphere in view of the camera and choose it.
    AddSphere,
    /// Add a plane below the origin and choose it.
    AddPlane,
    /// Delete the chosen object.
    Delete,
    /// Add a copy of the chosen object and choose it.
    Duplicate,
}

/// Changes how the scene is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LookAction {
    /// Show this layout.
    Layout(ViewLayout),
    /// Use this shading.
    Shade(Shade),
    /// Use this window theme.
    Theme(ThemeName),
    /// Use this colour scheme for the views.
    Scheme(Scheme),
    /// Show numbers with this many significant digits.
    Digits(usize),
    /// Toggle a switch.
    Toggle(Switch),
    /// Zoom the window in by this many steps; 0 resets the zoom.
    ZoomBy(i32),
    /// Show this exercise.
    Exercise(Exercise),
    /// Show the camera with this mistake.
    Mistake(Mistake),
    /// Show the camera with this mistake as a ghost in the exercise's figure; again to hide it.
    ShowMe(Mistake),
    /// Show a wrong picture and ask which mistake caused it.
    Vote,
    /// Start or end presenter mode.
    Present,
    /// While presenting, switch between the light and the dark theme.
    SwitchTheme,
    /// While presenting, turn the screen black.
    Blank,
    /// Take the pen's next colour.
    NextPenColor,
    /// Show the recap from view to the ray, or what it replaced.
    Recap,
    /// Fill the window with this layout.
    Fill(ViewLayout),
}

/// Takes part in the open vote.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VoteAction {
    /// Choose the option with this index.
    Choose(usize),
    /// Type the numbers of raised hands.
    CountHands,
    /// Begin the second round.
    NextRound,
    /// Show which option is right.
    Reveal,
    /// Open another vote.
    Another,
    /// Close the vote and return to the list of mistakes.
    End,
}

/// Defines the enum `Action`, and the conversions to it from the action type of each part of the window.
macro_rules! actions {
    ($($(#[$doc:meta])* $part:ident($action:ty),)*) => {
        /// A command from the user. Requested actions are applied in each egui pass, after the panels are
        /// drawn and before anything is derived.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Action {
            $($(#[$doc])* $part($action),)*
            /// Use this file.
            Use(FileUse, PathBuf),
            /// Undo the last step.
            Undo,
            /// Redo the step that was last undone.
            Redo,
            /// Ask for the clipboard's text.
            AskPaste,
            /// Set the camera from another program's text.
            Paste(String),
            /// Make the camera the ghost, a frozen copy for comparison.
            FreezeGhost,
            /// Remove the ghost.
            DropGhost,
            /// Open the command palette.
            OpenPalette,
            /// Open the command palette with the steps of all lessons.
            OpenContents,
            /// Show the list of all keys.
            ShowKeys,
            /// Show the lecture's conventions.
            ShowConventions,
            /// Show the program's version, purpose and licences.
            ShowAbout,
            /// Set an input number, which is given rather than computed, to a value in the units that the
            /// window shows.
            Give(Given, f64),
            /// Move the selected pixel.
            Select {
                /// Rows down.
                rows: i64,
                /// Columns right.
                columns: i64,
            },
        }
        $(impl From<$action> for Action {
            fn from(action: $action) -> Action {
                Action::$part(action)
            }
        })*
    };
}

actions! {
    /// Leave the open scene.
    Leave(Leave),
    /// Ask which file to use.
    Ask(FileUse),
    /// Save the scene.
    File(FileAction),
    /// Move through the open lesson.
    Lesson(LessonAction),
    /// Export a figure.
    Figure(FigureAction),
    /// Share a link, or open one.
    Share(ShareAction),
    /// Close a student's answers, or collect a class's.
    Answers(AnswersAction),
    /// Open or control an animation.
    Play(PlayAction),
    /// Vote.
    Vote(VoteAction),
    /// Move the camera.
    Steer(Steer),
    /// Move the observer of the world view.
    Observe(Observe),
    /// Add or delete an object.
    Object(ObjectAction),
    /// Change how the scene is shown.
    Look(LookAction),
}

fn queue() -> Id {
    Id::unique("requested actions")
}

/// Queues an action. The window applies it in the current egui pass if the views are not drawn yet, otherwise
/// in the next one.
pub(crate) fn request(ctx: &Context, action: impl Into<Action>) {
    let action = action.into();
    ctx.data_mut(|data| data.get_temp_mut_or_default::<Vec<Action>>(queue()).push(action));
}

/// Returns true if an action was requested and has not been applied yet.
pub(crate) fn is_any_requested(ctx: &Context) -> bool {
    ctx.data(|data| data.get_temp::<Vec<Action>>(queue())).is_some()
}

/// Removes and returns the requested actions, in their order.
pub(crate) fn take_requested(ctx: &Context) -> Vec<Action> {
    ctx.data_mut(|data| data.remove_temp(queue())).unwrap_or_default()
}

/// The preconditions of actions, as they are at the moment.
#[derive(Clone, Copy)]
pub(crate) struct Available<'a> {
    pub(crate) session: &'a Session,
    /// The name of the step to undo.
    pub(crate) undo: Option<&'a str>,
    /// The name of the step to redo.
    pub(crate) redo: Option<&'a str>,
    /// True if a lesson is open.
    pub(crate) lesson: bool,
    /// True if an animation is open.
    pub(crate) animation: bool,
    /// True if an object of the scene on the screen is chosen.
    pub(crate) object: bool,
}

impl Action {
    /// Returns true if the action is possible now. Undo, for example, needs a step to undo.
    pub(crate) fn is_possible(&self, there: Available<'_>) -> bool {
        let session = there.session;
        match self {
            Action::Undo => there.undo.is_some(),
            Action::Redo => there.redo.is_some(),
            Action::Lesson(LessonAction::Vote) => session.can_vote(),
            Action::Lesson(_) | Action::Leave(Leave::BackToStep) => there.lesson,
            Action::Object(ObjectAction::Delete | ObjectAction::Duplicate) => there.object,
            Action::DropGhost => session.shown.ghost.is_some(),
            Action::Play(PlayAction::Open(_)) => true,
            Action::Play(_) => there.animation,
            Action::Answers(AnswersAction::PutAway)
            | Action::Look(LookAction::Layout(ViewLayout::Answers)) => session.answers.is_some(),
            Action::Vote(_) => session.is_voting(),
            Action::Look(
                LookAction::SwitchTheme | LookAction::Blank | LookAction::NextPenColor,
            ) => session.presenting.is_some(),
            // A page is closed by its browser.
            Action::Leave(Leave::Quit) => host().has_folders(),
            Action::Leave(Leave::New) => session.presenting.is_none(),
            _ => true,
        }
    }
}

impl LookAction {
    /// Returns true if what it chooses is chosen, or what it toggles is on.
    pub(crate) fn is_on(self, session: &Session) -> bool {
        let (setup, settings) = (&session.shown.setup, &session.preferences);
        match self {
            LookAction::Layout(layout) => setup.layout == layout,
            LookAction::Shade(shade) => setup.shade == shade,
            LookAction::Theme(theme) => settings.theme == theme,
            LookAction::Scheme(scheme) => settings.scheme == scheme,
            LookAction::Toggle(switch) => switch.is_on(session),
            _ => false,
        }
    }
}

/// A setting that is either on or off. The comment on each variant says what holds while it is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Switch {
    /// This item of the overlay is shown.
    Item(Item),
    /// The derivation shows short exact forms instead of decimals.
    ExactForms,
    /// Rows and columns are counted from 1.
    CountFromOne,
    /// Moving the eye keeps the view direction. While this is off, a moved eye keeps looking at *at*.
    EyeTravels,
    /// *Up* stays fixed while *eye* or *at* is dragged.
    KeepUp,
    /// Transitions are off.
    ReducedMotion,
    /// A pen draws over the views.
    Pen,
    /// The side panel is shown.
    Panel,
    /// The numbers are shown below the views while presenting.
    PresentedNumbers,
}

impl Switch {
    /// Returns true if it is on.
    pub(crate) fn is_on(self, session: &Session) -> bool {
        let (setup, settings) = (&session.shown.setup, &session.preferences);
        match self {
            Switch::Item(item) => setup.items.shows(item),
            Switch::ExactForms => settings.exact_forms,
            Switch::CountFromOne => setup.count_from_one,
            Switch::EyeTravels => settings.eye_keeps == Keep::View,
            Switch::KeepUp => settings.keep_up,
            Switch::ReducedMotion => settings.reduced_motion,
            Switch::Pen => session.live.pen.is_some(),
            Switch::Panel => !settings.hides_panel,
            Switch::PresentedNumbers => settings.presents_numbers,
        }
    }

    /// Toggles the switch.
    pub(crate) fn toggle(self, session: &mut Session) {
        let on = !self.is_on(session);
        let (setup, settings) = (&mut session.shown.setup, &mut session.preferences);
        match self {
            Switch::Item(item) => setup.items.set(item, on),
            Switch::ExactForms => settings.exact_forms = on,
            Switch::CountFromOne => setup.count_from_one = on,
            Switch::EyeTravels => settings.eye_keeps = settings.eye_keeps.other(),
            Switch::KeepUp => settings.keep_up = on,
            Switch::ReducedMotion => settings.reduced_motion = on,
            Switch::Pen => session.live.pen = on.then(Pen::default),
            Switch::Panel => settings.hides_panel = !on,
            Switch::PresentedNumbers => settings.presents_numbers = on,
        }
    }
}
