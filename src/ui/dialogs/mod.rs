//! Dialogs over the window: files, figures, questions and messages. The submodules also hold the command
//! palette, the list of keys and the texts of the Help menu.

use egui::{Context, Id, Modal, ProgressBar, ScrollArea, Ui, Vec2};
use pinhole_exchange::legible;

use crate::features::export::ui::ExportForm;
use crate::features::share::ui::ShareForm;
use crate::ui::action::{Action, FileUse, request};

pub mod help;
pub mod palette;

use crate::ui::widgets::path_field::{FileAnswer, PathField};

/// The open dialog.
pub(crate) enum Dialog {
    /// Asks for a file, and for what.
    File(PathField, FileUse),
    /// Asks which figure to export, and to which file.
    Export(ExportForm),
    /// Shows the progress of an animation's export; closing the dialog cancels it.
    Progress { done: u32, frames: u32 },
    /// Shows the link to what the window shows.
    Share(ShareForm),
    /// A question with a few answers, or a message to read and close.
    Question(Question),
}

/// A question to the user, or a message.
pub(crate) struct Question {
    pub(crate) title: String,
    pub(crate) text: String,
    /// The path of the file that the question is about; empty for none.
    pub(crate) file: String,
    pub(crate) answers: Vec<Choice>,
}

/// A button that answers a question: its text, its tooltip (empty for none), and its action. Without an
/// action, the button only closes the dialog.
pub(crate) type Choice = (&'static str, &'static str, Option<Action>);

impl Question {
    /// Creates a question with these answers.
    pub(crate) fn new(title: String, text: impl ToString, answers: Vec<Choice>) -> Question {
        let text = text.to_string().split('\n').map(legible).collect::<Vec<_>>().join("\n");
        Question { title: legible(&title), text, file: String::new(), answers }
    }

    /// Creates a message.
    pub(crate) fn message(title: &str, text: impl ToString) -> Question {
        Question::new(title.to_owned(), text, vec![("Close", "", None)])
    }

    /// Shows the question. Returns true if it was answered.
    fn ui(&self, ui: &mut Ui) -> bool {
        ui.heading(&self.title);
        ui.label(&self.text);
        if !self.file.is_empty() {
            ui.weak(&self.file);
        }
        ui.add_space(8.0);
        let mut is_answered = false;
        ui.horizontal_wrapped(|ui| {
            for (text, hint, action) in &self.answers {
                let mut button = ui.button(*text);
                if !hint.is_empty() {
                    button = button.on_hover_text(*hint);
                }
                if button.clicked() {
                    is_answered = true;
                    action.iter().for_each(|action| request(ui.ctx(), action.clone()));
                }
            }
        });
        is_answered
    }
}

impl Dialog {
    /// Creates a message.
    pub(crate) fn message(title: &str, text: impl ToString) -> Dialog {
        Dialog::Question(Question::message(title, text))
    }

    /// Returns the dialog in words, for screen readers.
    pub(crate) fn spoken(&self) -> String {
        match self {
            Dialog::File(field, _) => field.question.title.to_owned(),
            Dialog::Export(form) => form.field.question.title.to_owned(),
            Dialog::Progress { .. } => "Exporting the animation".to_owned(),
            Dialog::Share(_) => "Share".to_owned(),
            Dialog::Question(Question { title, text, file, answers }) => {
                let answers = answers.iter().map(|(answer, ..)| *answer);
                let texts = [title, &text[..], file].into_iter().chain(answers);
                texts.filter(|text| !text.is_empty()).collect::<Vec<_>>().join("\n")
            }
        }
    }

    /// If this dialog needs a file, lets the user choose the file in the desktop's own dialog. When a figure
    /// is exported, the desktop's dialog opens only once a button is clicked.
    pub(crate) fn leave_to_desktop(&mut self) {
        let at_once = !matches!(self, Dialog::Export(_));
        if let Some(field) = self.field() {
            field.leave_to_desktop(at_once);
        }
    }

    /// Returns the field for a path, if there is one.
    pub(crate) fn field(&mut self) -> Option<&mut PathField> {
        match self {
            Dialog::File(field, _) => Some(field),
            Dialog::Export(form) => Some(&mut form.field),
            _ => None,
        }
    }
}

/// Passes the answer of the desktop's file dialog to the open dialog. If the user cancelled, closes the
/// open dialog, unless it exports a figure.
pub(crate) fn answer(dialog: &mut Option<Dialog>, answer: FileAnswer) {
    let is_figure = matches!(dialog, Some(Dialog::Export(_)));
    let Some(field) = dialog.as_mut().and_then(Dialog::field) else { return };
    match answer {
        FileAnswer::Chosen(path) => field.choose(path),
        FileAnswer::Cancelled if is_figure => field.leave_to_desktop(false),
        FileAnswer::Cancelled => *dialog = None,
        FileAnswer::Unavailable => field.ask_by_list(),
        FileAnswer::Elsewhere(uri) => {
            let problem =
                format!("{uri} is not on this computer. Choose a file in a local folder.");
            *dialog = Some(Dialog::message("This place cannot be reached", problem));
        }
    }
}

/// Width of a dialog where there is room for it, and its minimum distance from the window's edges, in points.
const WIDTH: f32 = 460.0;
const EDGE: f32 = 12.0;

/// Shows the contents of the dialog. Returns the action of its answer; sets `close` to true if it is closed.
fn contents(ui: &mut Ui, open: &mut Dialog, close: &mut bool) -> Option<Action> {
    match open {
        Dialog::File(field, of) => {
            ui.heading(field.question.title);
            field.ui(ui, close).map(|path| Action::Use(of.clone(), path))
        }
        Dialog::Export(form) => form.ui(ui, close),
        Dialog::Share(form) => form.ui(ui, close),
        Dialog::Progress { done, frames } => {
            ui.heading("Exporting the animation");
            ui.add(ProgressBar::new(*done as f32 / (*frames).max(1) as f32));
            ui.label(format!("{done} of {frames} frames"));
            ui.add_space(8.0);
            *close |= ui.button("Cancel").clicked();
            None
        }
        Dialog::Question(question) => {
            *close |= question.ui(ui);
            None
        }
    }
}

/// Shows the dialog, if one is open, and closes it when it is answered.
pub(crate) fn ui(ctx: &Context, dialog: &mut Option<Dialog>) {
    let Some(open) = dialog else { return };
    let mut close = false;
    let id = Id::unique("dialog");
    let size = || ctx.memory(|memory| memory.area_rect(id)).map(|rect| rect.size());
    let size_before = size();
    let response = Modal::new(id).show(ctx, |ui| {
        let room = ctx.content_rect().size() - Vec2::splat(2.0 * EDGE);
        ui.set_width(room.x.min(WIDTH));
        // A scroll area stays as small as in the last pass, so that a dialog that fits could not grow.
        let is_too_high = size_before.is_some_and(|size| size.y > room.y);
        let answer = if is_too_high {
            let scrolled = ScrollArea::vertical().max_height(room.y);
            scrolled.show(ui, |ui| contents(ui, open, &mut close)).inner
        } else {
            contents(ui, open, &mut close)
        };
        if let Some(action) = answer {
            close = true;
            request(ctx, action);
        }
    });
    // The dialog was centred by its size in the last frame, which may belong to another dialog. Without
    // another pass, it would move under the pointer in the next frame.
    if size() != size_before {
        ctx.request_discard("a dialog has another size");
    }
    if close || response.should_close() {
        *dialog = None;
    }
}
