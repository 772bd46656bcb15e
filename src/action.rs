//! Verbs that are not plain edits of the document or session.

use std::path::PathBuf;

use pinhole_core::DVec2;

use crate::document::Document;
use crate::figures::{Frames, Order};
use crate::formats::scene_argument::SceneSource;
use crate::ledger::Markup;
use crate::lessons::Place;
use crate::play::Kind;

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

/// Something to do once, after the panels and before anything is derived.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Open a scene, asking first if there are unsaved changes.
    Open(SceneSource),
    /// Ask for the path of a scene to open.
    AskOpen,
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
    /// Put the observer where everything can be seen.
    FrameAll,
    /// Move the selected pixel that many rows down and columns right.
    Step {
        /// Rows down.
        rows: i64,
        /// Columns right.
        columns: i64,
    },
}
