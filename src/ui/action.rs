//! Verbs that are not plain edits of the document or session.

use std::path::PathBuf;

use pinhole_core::methods::Method;
use pinhole_core::steering::Keep;
use pinhole_core::{DVec2, Shade};
use pinhole_exchange::document::Document;
use pinhole_exchange::scenes::SceneSource;
use pinhole_lecture::exercises::Exercise;
use pinhole_lecture::mistakes::Mistake;

use crate::figures::{Frames, Order};
use crate::model::color_scheme::Scheme;
use crate::model::derivation_sections::DerivationSection;
use crate::model::given::Given;
use crate::model::lessons::StepId;
use crate::model::overlay_items::Item;
use crate::model::play::Kind;
use crate::model::session::pen::Pen;
use crate::model::session::{Session, ThemeName, ViewLayout};
use crate::view::derivation::Markup;

/// A document from no file.
#[derive(Clone, Debug, PartialEq)]
pub struct MadeUp {
    /// The document.
    pub document: Document,
    /// The window's name for it.
    pub title: String,
    /// The ray to look at, if any.
    pub uv: Option<DVec2>,
}

/// Leaves the open scene for another. The user is first asked about unsaved changes.
#[derive(Clone, Debug, PartialEq)]
pub enum Leave {
    /// Open a scene.
    Open(SceneSource),
    /// Show a document that was made up, such as an exercise's.
    Show(Box<MadeUp>),
    /// Show this step of a lesson.
    GoTo(StepId),
    /// Set everything as the open lesson's step says, once more.
    BackToStep,
    /// Open the unsaved changes that were offered; `beside` in no file, so that the file that they were
    /// made to is left alone.
    Found {
        /// True for no file.
        beside: bool,
    },
    /// Close the window.
    Quit,
}

/// Getting scenes from files and into them.
#[derive(Clone, Debug, PartialEq)]
pub enum FileAction {
    /// Ask for the path of a scene to open.
    AskOpen,
    /// Save to where the scene came from; ask where if it came from nowhere.
    Save,
    /// Ask for a path to save to.
    AskSaveAs {
        /// The way to leave if that worked.
        then: Option<Leave>,
    },
    /// Save to this path.
    SaveAs {
        /// The file.
        path: PathBuf,
        /// The way to leave if that worked.
        then: Option<Leave>,
    },
    /// Save, then go on with this if that worked.
    SaveThen(Leave),
    /// Leave without saving.
    Discard(Leave),
    /// Forget the unsaved changes that were offered.
    DiscardFound,
    /// See what another program has written into the scene's file.
    Look,
    /// Let saving replace what another program has written; save now if that was asked for.
    KeepMine {
        /// True to save now.
        saves: bool,
        /// The way to leave if that worked.
        then: Option<Leave>,
    },
    /// Open what another program has written.
    TakeTheirs {
        /// The way to leave after that.
        then: Option<Leave>,
    },
}

/// The way through the open lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LessonAction {
    /// Show the next step.
    Next,
    /// Show the step before.
    Previous,
    /// Show all that the step keeps back.
    ShowAll,
    /// Close it; its scene stays.
    Close,
}

/// The way through the history.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HistoryAction {
    /// Undo the last step.
    Undo,
    /// Redo the step that was undone last.
    Redo,
}

/// Writing what the window shows.
#[derive(Clone, Debug, PartialEq)]
pub enum FigureAction {
    /// Ask which figure to export.
    Ask,
    /// Write a figure.
    Export {
        /// The figure.
        order: Order,
        /// The file.
        path: PathBuf,
    },
    /// Ask how to export the animation that is open.
    AskAnimation,
    /// Write an animation.
    ExportAnimation {
        /// The figure of each frame.
        order: Order,
        /// The number of frames.
        frames: Frames,
        /// The file.
        path: PathBuf,
    },
    /// Put a figure of what the layout is about on the clipboard.
    Copy,
    /// Put the derivation on the clipboard.
    CopyDerivation(Markup),
}

/// The camera in other programs' terms.
#[derive(Clone, Debug, PartialEq)]
pub enum ExchangeAction {
    /// Ask for the clipboard's text.
    AskPaste,
    /// Set the camera from another program's text.
    Paste(String),
    /// Show the camera in the terms of the format of this name.
    TranslateInto(&'static str),
    /// Ask where to write the camera in another program's terms.
    AskSave,
    /// Write it there.
    Save(PathBuf),
}

/// A student's answers.
#[derive(Clone, Debug, PartialEq)]
pub enum AnswersAction {
    /// Ask for the path of their file.
    Ask,
    /// Grade those in this file.
    Check(PathBuf),
    /// Forget them.
    PutAway,
}

/// An action on an animation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlayAction {
    /// Open one, at its start.
    Open(Kind),
    /// Let it run, or rest.
    Toggle,
    /// Go this many steps on; negative: back.
    Step(i64),
    /// Choose a speed this many places faster; negative: slower.
    Faster(i32),
    /// Begin again after the end, or not.
    Loop,
    /// End it, and keep what is there now.
    Keep,
    /// End it, and go back to how it was.
    Close,
}

/// An action on the ghost, the camera to compare with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GhostAction {
    /// The camera becomes the ghost, in place of the one that was there.
    Freeze,
    /// Take it away.
    Drop,
    /// Camera and ghost change places.
    Swap,
}

/// Moves of the camera by keys, like those of the mouse in the camera view; in steps to the right and
/// up, on and back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steer {
    /// Look round.
    Look(i32, i32),
    /// Orbit around at.
    Orbit(i32, i32),
    /// Narrow the field of view.
    Zoom(i32),
    /// Go towards what the camera looks at.
    Dolly(i32),
}

/// Moves of the world view's observer by keys; likewise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Observe {
    /// Orbit what it looks at.
    Orbit(i32, i32),
    /// Go sideways.
    Pan(i32, i32),
    /// Go nearer.
    Zoom(i32),
    /// Go where the eye and the viewport fill the picture.
    FrameCamera,
    /// Go where everything can be seen.
    FrameAll,
}

/// An action on the scene's objects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ObjectAction {
    /// Add a sphere that the camera sees, and choose it.
    AddSphere,
    /// Add a plane below the origin, and choose it.
    AddPlane,
    /// Take the chosen one away.
    Remove,
    /// Choose the one with this index.
    Choose(usize),
    /// Choose the one so many places on in the list; after the last comes the first.
    Next(i32),
}

/// A change of how the scene is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LookAction {
    /// Show these views.
    Layout(ViewLayout),
    /// Colour the pictures like this.
    Shade(Shade),
    /// Colour the window like this.
    Theme(ThemeName),
    /// Draw the views with this colour scheme.
    Scheme(Scheme),
    /// Draw the camera's picture by this method.
    Method(Method),
    /// Turn a switch on, or off if it is on.
    Toggle(Switch),
    /// Show so many digits more.
    DigitsBy(i32),
    /// Make everything that many steps larger; 0 is back to the usual size.
    ZoomBy(i32),
    /// Ask this.
    Exercise(Exercise),
    /// Show this wrong camera.
    Mistake(Mistake),
    /// Show a wrong picture, and ask which mistake made it.
    Vote,
    /// Begin to present, or end it.
    Present,
    /// Fill the window with this.
    Fill(ViewLayout),
}

/// A box that lies over the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overlay {
    /// The command palette.
    Palette,
    /// The list of all keys.
    Keys,
    /// The lecture's conventions, as the program keeps them.
    Conventions,
    /// The program's version, licence and purpose.
    About,
}

/// A command of the user. It is carried out once, after the panels and before anything is derived.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Leave what is open.
    Leave(Leave),
    /// Open or save a scene.
    File(FileAction),
    /// Move through the open lesson.
    Lesson(LessonAction),
    /// Undo or redo.
    History(HistoryAction),
    /// Export a figure.
    Figure(FigureAction),
    /// Read or write another program's camera.
    Exchange(ExchangeAction),
    /// Open, grade or put away a student's answers.
    Answers(AnswersAction),
    /// Open or control an animation.
    Play(PlayAction),
    /// Freeze, drop or swap the ghost.
    Ghost(GhostAction),
    /// Set a given number to a value, as it is shown.
    Give(Given, f64),
    /// Move the camera.
    Steer(Steer),
    /// Move the observer of the world view.
    Observe(Observe),
    /// Add, choose or remove an object.
    Object(ObjectAction),
    /// Select the pixel that many rows down and columns right of the selected one.
    Select {
        /// Rows down.
        rows: i64,
        /// Columns right.
        columns: i64,
    },
    /// Change how the scene is shown.
    Look(LookAction),
    /// Open a box over the window.
    Overlay(Overlay),
}

macro_rules! action_of {
    ($($part:ident($action:ty)),* $(,)?) => {
        $(impl From<$action> for Action {
            fn from(action: $action) -> Action {
                Action::$part(action)
            }
        })*
    };
}

action_of! {
    Leave(Leave),
    File(FileAction),
    Lesson(LessonAction),
    History(HistoryAction),
    Figure(FigureAction),
    Exchange(ExchangeAction),
    Answers(AnswersAction),
    Play(PlayAction),
    Ghost(GhostAction),
    Steer(Steer),
    Observe(Observe),
    Object(ObjectAction),
    Look(LookAction),
    Overlay(Overlay),
}

/// The end of the open animation before an action is carried out.
pub(crate) enum PlayEnd {
    GoesOn,
    /// Everything stays as it is now.
    Keeps,
    /// Everything becomes as it was at the start.
    GivesBack,
}

/// The targets of actions, true where they exist at the moment.
#[derive(Clone, Copy)]
pub(crate) struct Available {
    /// A step to undo.
    pub(crate) undo: bool,
    /// A step to redo.
    pub(crate) redo: bool,
    pub(crate) lesson: bool,
    pub(crate) animation: bool,
    pub(crate) ghost: bool,
    pub(crate) answers: bool,
}

impl Action {
    /// Returns the end of the open animation: the camera is saved as it is seen; who goes elsewhere
    /// leaves the camera as it was.
    pub(crate) fn play_end(&self) -> PlayEnd {
        match self {
            Action::Leave(_) | Action::History(_) => PlayEnd::GivesBack,
            Action::File(action) => match action {
                FileAction::AskOpen | FileAction::Look => PlayEnd::GoesOn,
                FileAction::Discard(_) | FileAction::TakeTheirs { .. } => PlayEnd::GivesBack,
                FileAction::DiscardFound => PlayEnd::GoesOn,
                FileAction::Save
                | FileAction::KeepMine { .. }
                | FileAction::AskSaveAs { .. }
                | FileAction::SaveAs { .. }
                | FileAction::SaveThen(_) => PlayEnd::Keeps,
            },
            Action::Lesson(action) => match action {
                LessonAction::Close => PlayEnd::GivesBack,
                // They are left by [`Leave::GoTo`], if there is such a step.
                LessonAction::Next | LessonAction::Previous | LessonAction::ShowAll => {
                    PlayEnd::GoesOn
                }
            },
            Action::Ghost(action) => match action {
                GhostAction::Swap => PlayEnd::GivesBack,
                GhostAction::Freeze | GhostAction::Drop => PlayEnd::GoesOn,
            },
            Action::Figure(_)
            | Action::Exchange(_)
            | Action::Answers(_)
            | Action::Play(_)
            | Action::Give(..)
            | Action::Steer(_)
            | Action::Observe(_)
            | Action::Object(_)
            | Action::Select { .. }
            | Action::Look(_)
            | Action::Overlay(_) => PlayEnd::GoesOn,
        }
    }

    /// Returns true if something that is drawn before actions are carried out may show its effect: the
    /// bars, the dialogs or the history. A move of camera or observer shows in the views alone.
    pub(crate) fn shows_above_views(&self) -> bool {
        !matches!(self, Action::Steer(_) | Action::Observe(_) | Action::Figure(_))
    }

    /// Returns true if its target exists.
    pub(crate) fn is_possible(&self, there: Available) -> bool {
        match self {
            Action::History(HistoryAction::Undo) => there.undo,
            Action::History(HistoryAction::Redo) => there.redo,
            Action::Lesson(_) => there.lesson,
            Action::Leave(leave) => match leave {
                Leave::BackToStep => there.lesson,
                Leave::Open(_)
                | Leave::Show(_)
                | Leave::GoTo(_)
                | Leave::Found { .. }
                | Leave::Quit => true,
            },
            Action::Ghost(action) => match action {
                GhostAction::Drop | GhostAction::Swap => there.ghost,
                GhostAction::Freeze => true,
            },
            Action::Play(action) => match action {
                PlayAction::Open(_) => true,
                PlayAction::Toggle
                | PlayAction::Step(_)
                | PlayAction::Faster(_)
                | PlayAction::Loop
                | PlayAction::Keep
                | PlayAction::Close => there.animation,
            },
            Action::Answers(action) => match action {
                AnswersAction::PutAway => there.answers,
                AnswersAction::Ask | AnswersAction::Check(_) => true,
            },
            Action::File(_)
            | Action::Figure(_)
            | Action::Exchange(_)
            | Action::Give(..)
            | Action::Steer(_)
            | Action::Observe(_)
            | Action::Object(_)
            | Action::Select { .. }
            | Action::Look(_)
            | Action::Overlay(_) => true,
        }
    }
}

/// A setting that is either on or off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Switch {
    /// An item of the overlay.
    Item(Item),
    /// A part of the derivation.
    Section(DerivationSection),
    /// The derivation writes short exact forms in place of decimals.
    ExactForms,
    /// Rows and columns are shown counted from 1.
    CountFromOne,
    /// A moved eye takes the view along; off, it orbits at.
    EyeTravels,
    /// Changing the viewport or image keeps the pixels' shape.
    KeepPixelShape,
    /// Distance, width and height go together, so that the picture stays.
    KeepPicture,
    /// Up stays as it is given while eye and at are dragged.
    KeepUp,
    /// Nothing moves by itself.
    ReducedMotion,
    /// All but what is round the pointer is dimmed.
    Spotlight,
    /// A pen draws over the views.
    Pen,
    /// The panel beside the views is shown.
    Panel,
    /// The numbers are shown below the views while presenting.
    PresentedNumbers,
}

impl Switch {
    /// Returns true if it is on.
    pub(crate) fn is_on(self, session: &Session) -> bool {
        let settings = &session.settings;
        match self {
            Switch::Item(item) => settings.items.shows(item),
            Switch::Section(section) => session.sections.shows(section),
            Switch::ExactForms => settings.exact_forms,
            Switch::CountFromOne => settings.count_from_one,
            Switch::EyeTravels => settings.eye_keeps == Keep::View,
            Switch::KeepPixelShape => settings.keep_pixel_shape,
            Switch::KeepPicture => settings.keep_picture,
            Switch::KeepUp => settings.keep_up,
            Switch::ReducedMotion => settings.reduced_motion,
            Switch::Spotlight => session.spotlight,
            Switch::Pen => session.pen.is_some(),
            Switch::Panel => !settings.hides_panel,
            Switch::PresentedNumbers => settings.presents_numbers,
        }
    }

    /// Switches it over.
    pub(crate) fn toggle(self, session: &mut Session) {
        let on = !self.is_on(session);
        let settings = &mut session.settings;
        match self {
            Switch::Item(item) => settings.items.set(item, on),
            Switch::Section(section) => session.sections.set(section, on),
            Switch::ExactForms => settings.exact_forms = on,
            Switch::CountFromOne => settings.count_from_one = on,
            Switch::EyeTravels => settings.eye_keeps = settings.eye_keeps.other(),
            Switch::KeepPixelShape => settings.keep_pixel_shape = on,
            Switch::KeepPicture => settings.keep_picture = on,
            Switch::KeepUp => settings.keep_up = on,
            Switch::ReducedMotion => settings.reduced_motion = on,
            Switch::Spotlight => session.spotlight = on,
            Switch::Pen => session.pen = on.then(Pen::default),
            Switch::Panel => settings.hides_panel = !on,
            Switch::PresentedNumbers => settings.presents_numbers = on,
        }
    }
}
