//! The window's contents: the order of a frame ([`app`]), the views ([`scene`]), the [`derivation`], the panels
//! around them, dialogs, widgets, and the table of commands. What a feature shows is in [`crate::features`].

pub mod action;
pub mod app;
pub mod commands_table;
pub mod derivation;
pub mod dialogs;
pub mod frame_times;
pub mod panels;
pub mod scene;
pub(crate) mod second_picture;
pub(crate) mod stage;
pub mod widgets;
pub(crate) mod workspaces;

use pinhole_figure::NumberStyle;

use crate::features::accuracy::ui::Measuring;
use crate::features::mistakes::ui_gallery::Gallery;
use crate::model::lessons::{Lesson, OpenLesson};
use crate::model::{OpenDocument, Session};
use crate::ui::derivation::DerivationPanel;
use crate::ui::widgets::ViewTexture;
use crate::view::derive::Derived;

/// The values that a page shows or changes.
pub(crate) struct PageContext<'a> {
    pub(crate) open: &'a OpenDocument,
    pub(crate) session: &'a mut Session,
    pub(crate) derived: &'a Derived,
    pub(crate) tools: &'a mut Tools,
    pub(crate) style: NumberStyle,
    /// The step of the open lesson, unless the page is not about it.
    pub(crate) step: Option<OpenStep<'a>>,
}

/// The state of the pages from one pass to the next.
#[derive(Default)]
pub(crate) struct Tools {
    pub(crate) derivation: DerivationPanel,
    pub(crate) measuring: Measuring,
    pub(crate) gallery: Gallery,
    /// The second picture.
    pub(crate) second: ViewTexture,
}

/// The open lesson.
#[derive(Clone, Copy)]
pub(crate) struct OpenStep<'a> {
    pub(crate) open: &'a OpenLesson,
    /// The lesson that was opened from a file.
    pub(crate) file: Option<&'a Lesson>,
    /// True if anything differs from the step.
    pub(crate) is_changed: bool,
}
