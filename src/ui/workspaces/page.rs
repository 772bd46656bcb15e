//! A page as a value: where its views lie, what it has derived, what it draws.

use egui::{Context, RichText, Ui};

use crate::figures::Subject;
use crate::model::concept::Hovered;
use crate::model::files::OpenDocument;
use crate::model::readings::NumberStyle;
use crate::model::session::{Session, Split};
use crate::ui::action::{Action, LessonAction};
use crate::ui::commands_table::shortcut;
use crate::ui::derivation::DerivationPanel;
use crate::ui::practice::exercises::scene::QuestionScene;
use crate::ui::scene::view_rects::{Areas, Divider};
use crate::ui::tools::measuring::Measuring;
use crate::ui::tools::translator::TranslatorPanel;
use crate::ui::view_texture::ViewTexture;
use crate::view::derive::{Derived, SecondPicture};

/// A page of a workspace.
pub(crate) struct Page {
    /// True if camera and objects can be edited beside it.
    pub(crate) has_panel: bool,
    /// True if the ray under the pointer is shown in place of the selected one.
    pub(crate) follows_pointer: bool,
    /// Lays out its parts.
    pub(crate) areas: fn(&mut Divider<'_>) -> Areas,
    /// The picture beside the camera's, if it has one.
    pub(crate) second: Option<SecondPicture>,
    /// Shows what it has below the views, beside them or in their place.
    pub(crate) rest: fn(&mut Ui, &mut Desk<'_>),
    /// Shows what may be seen of that while the question of a lesson's step waits for its answer.
    pub(crate) asked: fn(&mut Ui, &Desk<'_>),
    /// Returns the concept that the mouse or the focus is on in that.
    pub(crate) hovered: fn(&Context, &Tools, &Derived) -> Option<Hovered>,
    /// The figure that it is about.
    pub(crate) figure: Subject,
}

/// The state of the pages from one pass to the next.
#[derive(Default)]
pub(crate) struct Tools {
    pub(crate) derivation: DerivationPanel,
    pub(crate) translator: TranslatorPanel,
    pub(crate) measuring: Measuring,
    /// The scene of the open exercise.
    pub(crate) question: QuestionScene,
    /// The second picture.
    pub(crate) second: ViewTexture,
}

/// The values that a page shows, and those that it may change.
pub(crate) struct Desk<'a> {
    pub(crate) open: &'a OpenDocument,
    pub(crate) session: &'a mut Session,
    pub(crate) derived: &'a Derived,
    pub(crate) tools: &'a mut Tools,
    pub(crate) style: NumberStyle,
    /// A lesson is open.
    pub(crate) has_lesson: bool,
    /// Actions for the next pass.
    pub(crate) actions: &'a mut Vec<Action>,
}

/// Size of the text in place of what is hidden, in points.
const HIDDEN: f32 = 16.0;

impl Page {
    /// Both views, and nothing below them.
    pub(crate) const VIEWS: Page = Page {
        has_panel: true,
        follows_pointer: false,
        areas: |divider| divider.both_above(Split::Readouts),
        second: None,
        rest: |_, _| (),
        asked: |ui, _| hidden(ui),
        hovered: |_, _, _| None,
        figure: Subject::World,
    };
}

/// Says in the middle that something is hidden, and which key shows it, where there is room for that.
fn hidden(ui: &mut Ui) {
    let text = format!("Hidden until you show the answer ({})", shortcut(LessonAction::Next));
    let room = ui.available_height();
    if room > ui.spacing().interact_size.y {
        ui.centered_and_justified(|ui| ui.label(RichText::new(text).size(HIDDEN).weak()));
    }
}
