//! Verbs that are not plain edits of the document or session.

use std::path::PathBuf;

use pinhole_core::DVec2;
use pinhole_lecture::exercises::Exercise;
use pinhole_lecture::mistakes::Mistake;

use crate::document::Document;
use crate::figures::{Frames, Order};
use crate::formats::scene_argument::SceneSource;
use crate::ledger::{LedgerSection, Markup};
use crate::lessons::Place;
use crate::overlay::{Item, Scheme};
use crate::play::Kind;
use crate::presenter::Full;
use crate::session::{EyeKeeps, MethodName, Session, ShadeName, ThemeName, ViewLayout};

/// A document from no file.
#[derive(Clone, Debug, PartialEq)]
pub struct MadeUp {
    /// The document.
    pub document: Document,
    /// What the window calls it.
    pub title: String,
    /// The ray to look at, if any.
    pub uv: Option<DVec2>,
}

/// What is done to an animation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlayMove {
    /// Open one, at its start.
    Open(Kind),
    /// Let it run, or rest.
    Toggle,
    /// So many single steps on; negative: back.
    Step(i64),
    /// So many speeds faster, of those to choose from; negative: slower.
    Faster(i32),
    /// Begin again after the end, or not.
    Loop,
    /// End it, and keep what is there now.
    Keep,
    /// End it, and go back to how it was.
    Close,
}

/// What is done with the ghost, the camera to compare with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GhostMove {
    /// The camera becomes the ghost, in place of the one that was there.
    Freeze,
    /// Take it away.
    Drop,
    /// Camera and ghost change places.
    Swap,
}

/// What keys do to the camera, as the mouse does in the camera view; in steps to the right and up, on
/// and back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steer {
    /// Look round.
    Look(i32, i32),
    /// Orbit round at.
    Orbit(i32, i32),
    /// Narrow the field of view.
    Zoom(i32),
    /// Go towards what the camera looks at.
    Dolly(i32),
}

/// What keys do to the observer of the world view; likewise.
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
}

/// What is done with the scene's objects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ObjectMove {
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

/// Something to do once, after the panels and before anything is derived.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Open a scene, asking first if there are unsaved changes.
    Open(SceneSource),
    /// Ask for the path of a scene to open.
    AskOpen,
    /// Ask for the path of a file of a student's answers.
    AskAnswers,
    /// Grade the answers in this file.
    CheckAnswers(PathBuf),
    /// Forget the answers.
    PutAnswersAway,
    /// Save to where the scene came from; ask where if it came from nowhere.
    Save,
    /// Ask for a path to save to.
    AskSaveAs,
    /// Save to this path.
    SaveAs {
        /// Where to.
        path: PathBuf,
        /// What to go on with if that worked.
        then: Option<Box<Action>>,
    },
    /// Ask which figure to export.
    AskExport,
    /// Write a figure.
    Export {
        /// Which.
        order: Order,
        /// Where to.
        path: PathBuf,
    },
    /// Ask how to export the animation that is open.
    AskExportAnimation,
    /// Write an animation.
    ExportAnimation {
        /// What each figure shows.
        order: Order,
        /// How many there are.
        frames: Frames,
        /// Where to.
        path: PathBuf,
    },
    /// Put the ledger on the clipboard.
    CopyLedger(Markup),
    /// Ask for the clipboard's text.
    AskPaste,
    /// Set the camera from another program's text.
    Paste(String),
    /// Show the camera in the terms of the format of this name.
    TranslateInto(&'static str),
    /// Ask where to write the camera in another program's terms.
    AskTranslate,
    /// Write it there.
    Translate(PathBuf),
    /// Close the window, asking first if there are unsaved changes.
    Quit,
    /// Show this step of a lesson, asking first if there are unsaved changes of a scene.
    GoTo(Place),
    /// Set everything as the open lesson's step says, once more; asking likewise.
    BackToStep,
    /// Show a document that was made up, such as an exercise's, asking first if there are unsaved
    /// changes.
    Show(Box<MadeUp>),
    /// Close the lesson that is open; its scene stays.
    CloseLesson,
    /// Do it (close the window, open the scene or the step) without saving.
    Discard(Box<Action>),
    /// Save, then go on with this if that worked.
    SaveThen(Box<Action>),
    /// Undo the last step of the history.
    Undo,
    /// Redo the step that was undone last.
    Redo,
    /// Something with the ghost.
    Ghost(GhostMove),
    /// Something with an animation.
    Play(PlayMove),
    /// Move the camera.
    Steer(Steer),
    /// Move the observer of the world view.
    Observe(Observe),
    /// Something with the scene's objects.
    Object(ObjectMove),
    /// Put the observer where everything can be seen.
    FrameAll,
    /// Move the selected pixel that many rows down and columns right.
    Step {
        /// Rows down.
        rows: i64,
        /// Columns right.
        columns: i64,
    },
    /// Show the next step of the open lesson.
    Next,
    /// Show the step before of the open lesson.
    Previous,
    /// Show these views.
    Layout(ViewLayout),
    /// Colour the pictures like this.
    Shade(ShadeName),
    /// Colour the window like this.
    Theme(ThemeName),
    /// Tell things apart by these colours.
    Scheme(Scheme),
    /// Draw the camera's picture by this method.
    Method(MethodName),
    /// Switch something on, or off if it is on.
    Toggle(Switch),
    /// Show so many digits more.
    DigitsBy(i32),
    /// Make everything that many steps larger; 0 is back to the usual size.
    ZoomBy(i32),
    /// Ask this.
    Exercise(Exercise),
    /// Show this wrong camera.
    Mistake(Mistake),
    /// Begin to present, or end it.
    Present,
    /// Fill the window with this.
    Fill(Full),
    /// Open the command palette.
    Palette,
    /// Open the sheet of all keys.
    KeySheet,
}

/// What is either on or off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Switch {
    /// Something that is drawn over the views.
    Item(Item),
    /// A part of the ledger.
    Section(LedgerSection),
    /// Rows and columns are shown counted from 1.
    CountFromOne,
    /// A moved eye takes the view along; off, it orbits at.
    EyeTravels,
    /// Changing the viewport or image keeps the pixels' shape.
    KeepPixelShape,
    /// Distance, width and height go together, so that the picture stays.
    KeepPicture,
    /// Nothing moves by itself.
    ReducedMotion,
    /// All but what is round the pointer is dimmed.
    Spotlight,
}

impl Switch {
    /// Whether it is on.
    pub fn is_on(self, session: &Session) -> bool {
        let settings = &session.settings;
        match self {
            Switch::Item(item) => settings.items.shows(item),
            Switch::Section(section) => session.sections.shows(section),
            Switch::CountFromOne => settings.count_from_one,
            Switch::EyeTravels => settings.eye_keeps == EyeKeeps::View,
            Switch::KeepPixelShape => settings.keep_pixel_shape,
            Switch::KeepPicture => settings.keep_picture,
            Switch::ReducedMotion => settings.reduced_motion,
            Switch::Spotlight => session.spotlight,
        }
    }

    /// Switches it over.
    pub(crate) fn toggle(self, session: &mut Session) {
        let on = !self.is_on(session);
        let settings = &mut session.settings;
        match self {
            Switch::Item(item) => settings.items.set(item, on),
            Switch::Section(section) => session.sections.set(section, on),
            Switch::CountFromOne => settings.count_from_one = on,
            Switch::EyeTravels => settings.eye_keeps = settings.eye_keeps.other(),
            Switch::KeepPixelShape => settings.keep_pixel_shape = on,
            Switch::KeepPicture => settings.keep_picture = on,
            Switch::ReducedMotion => settings.reduced_motion = on,
            Switch::Spotlight => session.spotlight = on,
        }
    }
}
