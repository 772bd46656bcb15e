//! Dialogs over the window: files, figures, unsaved changes and messages. The submodules also hold the
//! command palette, the list of keys and the texts of the Help menu.

use std::path::{Path, PathBuf};

use egui::{Context, Id, Modal, ProgressBar, Ui};
use pinhole_exchange::scenes::SceneSource;

use crate::ui::action::{Action, AnswersAction, ExchangeAction, FileAction, Leave};
use crate::ui::dialogs::export::ExportForm;
use crate::ui::dialogs::path_field::{FileAnswer, PathField};

pub mod export;
pub mod help;
pub mod palette;
pub mod path_field;

/// The open dialog.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Dialog {
    /// Asks for a file to open.
    Open(PathField),
    /// Asks for a student's answers to grade.
    Answers(PathField),
    /// Asks for a file to save to.
    SaveAs { field: PathField, then: Option<Leave> },
    /// Asks for the file to which the camera is written in another program's format.
    Translate(PathField),
    /// Asks for a figure and the file to which it is written.
    Export(ExportForm),
    /// Shows the progress of an animation's export; closing the dialog cancels it.
    Progress { done: u32, frames: u32 },
    /// Asks whether to save unsaved changes before leaving them.
    Unsaved { title: String, then: Leave },
    /// Offers the unsaved changes of a window that ended without asking the user.
    Found { title: String, file: Option<PathBuf>, age: String },
    /// Asks which version to keep after another program has changed the scene's file. `saves` is true if the
    /// user was about to save the scene to that file.
    Theirs { title: String, saves: bool, then: Option<Leave> },
    /// A message to read and close.
    Message(Message),
}

/// A message to the user.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Message {
    /// The heading.
    title: String,
    /// The explanation.
    text: String,
}

impl Message {
    pub(crate) fn new(title: &str, text: impl ToString) -> Message {
        Message { title: title.to_owned(), text: text.to_string() }
    }
}

impl Dialog {
    /// A message to read and close.
    pub(crate) fn message(title: &str, text: impl ToString) -> Dialog {
        Dialog::Message(Message::new(title, text))
    }

    /// Lets the desktop's dialog ask for a file, if this dialog needs one. The dialog for a figure does so
    /// only when its button is clicked.
    pub(crate) fn leave_to_desktop(&mut self) {
        let at_once = !matches!(self, Dialog::Export(_));
        if let Some(field) = self.field() {
            field.leave_to_desktop(at_once);
        }
    }

    /// Returns the field for a path, if there is one.
    pub(crate) fn field(&mut self) -> Option<&mut PathField> {
        match self {
            Dialog::Open(field)
            | Dialog::Answers(field)
            | Dialog::SaveAs { field, .. }
            | Dialog::Translate(field) => Some(field),
            Dialog::Export(form) => Some(form.field()),
            _ => None,
        }
    }
}

/// Passes the desktop dialog's answer to the open dialog, and closes it if it was cancelled.
pub(crate) fn answer(dialog: &mut Option<Dialog>, answer: FileAnswer) {
    let is_figure = matches!(dialog, Some(Dialog::Export(_)));
    let Some(field) = dialog.as_mut().and_then(Dialog::field) else { return };
    match answer {
        FileAnswer::Chosen(path) => field.choose(path),
        FileAnswer::Cancelled if is_figure => field.close_desktop(),
        FileAnswer::Cancelled => *dialog = None,
        FileAnswer::Unavailable => field.ask_by_list(),
        FileAnswer::Elsewhere(uri) => {
            let problem =
                format!("{uri} is not on this computer. Choose a file in a local folder.");
            *dialog = Some(Dialog::message("This place cannot be reached", problem));
        }
    }
}

/// Shows the dialog, if one is open, and closes it when it is answered.
pub(crate) fn ui(ctx: &Context, dialog: &mut Option<Dialog>, actions: &mut Vec<Action>) {
    let Some(open) = dialog else { return };
    let mut close = false;
    let id = Id::unique("dialog");
    let size = || ctx.memory(|memory| memory.area_rect(id)).map(|rect| rect.size());
    let size_before = size();
    let response = Modal::new(id).show(ctx, |ui| {
        ui.set_width(460.0);
        let answer = match open {
            Dialog::Open(field) => {
                let path = file_ui(ui, field, &mut close);
                path.map(|path| Leave::Open(SceneSource::File(path)).into())
            }
            Dialog::Answers(field) => {
                let path = file_ui(ui, field, &mut close);
                path.map(|path| AnswersAction::Check(path).into())
            }
            Dialog::SaveAs { field, then } => {
                let path = file_ui(ui, field, &mut close);
                path.map(|path| FileAction::SaveAs { path, then: then.take() }.into())
            }
            Dialog::Translate(field) => {
                let path = file_ui(ui, field, &mut close);
                path.map(|path| ExchangeAction::Save(path).into())
            }
            Dialog::Export(form) => form.ui(ui, &mut close),
            Dialog::Unsaved { title, then } => unsaved_ui(ui, title, then, &mut close),
            Dialog::Found { title, file, age } => {
                found_ui(ui, title, file.as_deref(), age, &mut close)
            }
            Dialog::Theirs { title, saves, then } => theirs_ui(ui, title, *saves, then, &mut close),
            Dialog::Progress { done, frames } => {
                ui.heading("Exporting the animation");
                ui.add(ProgressBar::new(*done as f32 / (*frames).max(1) as f32));
                ui.label(format!("{done} of {frames} frames"));
                ui.add_space(8.0);
                close |= ui.button("Cancel").clicked();
                None
            }
            Dialog::Message(Message { title, text }) => {
                ui.heading(title.as_str());
                ui.label(text.as_str());
                ui.add_space(8.0);
                close |= ui.button("Close").clicked();
                None
            }
        };
        close |= answer.is_some();
        actions.extend(answer);
    });
    // The dialog was centred by the last size, which may belong to another dialog, so it would move under the
    // pointer in the next frame.
    if size() != size_before {
        ctx.request_discard("a dialog has another size");
    }
    if close || response.should_close() {
        *dialog = None;
    }
}

fn file_ui(ui: &mut Ui, field: &mut PathField, close: &mut bool) -> Option<PathBuf> {
    ui.heading(field.question.title);
    field.ui(ui, close)
}

fn found_ui(
    ui: &mut Ui,
    title: &str,
    file: Option<&Path>,
    age: &str,
    close: &mut bool,
) -> Option<Action> {
    ui.heading(format!("Restore the unsaved changes to {title}?"));
    ui.label(format!("Pinhole ended without saving them. The last one was made {age} ago."));
    if let Some(file) = file {
        ui.weak(file.display().to_string());
    }
    ui.add_space(8.0);
    let buttons = ui.horizontal(|ui| {
        let restore = ui.button("Restore").on_hover_text("Opens the scene with these changes");
        let beside = ui.button("Open beside");
        let beside = beside.on_hover_text("Opens them as a new scene without a file");
        let discard = ui.button("Discard").on_hover_text("Deletes these changes");
        let later = ui.button("Not now").on_hover_text("Asks again at the next start");
        *close |= later.clicked();
        match (restore.clicked(), beside.clicked(), discard.clicked()) {
            (true, ..) => Some(Leave::Restore { as_new: false }.into()),
            (_, true, _) => Some(Leave::Restore { as_new: true }.into()),
            (.., true) => Some(FileAction::DiscardRecovered.into()),
            _ => None,
        }
    });
    buttons.inner
}

fn theirs_ui(
    ui: &mut Ui,
    title: &str,
    saves: bool,
    then: &Option<Leave>,
    close: &mut bool,
) -> Option<Action> {
    ui.heading(format!("Another program has changed {title}"));
    ui.label(
        "Your changes are not in the file, and the other program's changes are not on the screen.",
    );
    ui.add_space(8.0);
    let buttons = ui.horizontal(|ui| {
        let what =
            if saves { "Saves your version over theirs" } else { "Continues with your version" };
        let mine = ui.button("Keep mine").on_hover_text(what);
        let theirs = ui.button("Take theirs");
        let theirs = theirs.on_hover_text("Reads the file again. Undo restores your version");
        let other = ui.button("Save as…").on_hover_text("Saves your version to another file");
        *close |= ui.button("Cancel").clicked();
        let then = || then.clone();
        match (mine.clicked(), theirs.clicked(), other.clicked()) {
            (true, ..) => Some(FileAction::KeepMine { saves, then: then() }.into()),
            (_, true, _) => Some(FileAction::TakeTheirs { then: then() }.into()),
            (.., true) => Some(FileAction::AskSaveAs { then: then() }.into()),
            _ => None,
        }
    });
    buttons.inner
}

fn unsaved_ui(ui: &mut Ui, title: &str, then: &Leave, close: &mut bool) -> Option<Action> {
    ui.heading(format!("Save the changes to {title}?"));
    ui.label("Unsaved changes will be lost.");
    ui.add_space(8.0);
    let buttons = ui.horizontal(|ui| {
        let save = ui.button("Save").clicked();
        let discard = ui.button("Discard").clicked();
        *close |= ui.button("Cancel").clicked();
        match (save, discard) {
            (true, _) => Some(FileAction::SaveThen(then.clone()).into()),
            (_, true) => Some(FileAction::Discard(then.clone()).into()),
            _ => None,
        }
    });
    buttons.inner
}
