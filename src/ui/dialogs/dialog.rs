//! Dialogs over the window: opening and saving files, exporting figures, unsaved changes, and
//! messages.

use std::path::{Path, PathBuf};

use egui::{Context, Id, Modal, ProgressBar, RichText, ScrollArea, TextEdit, Ui};
use pinhole_exchange::scenes::SceneSource;

use super::export::ExportForm;
use crate::ui::action::{Action, AnswersAction, ExchangeAction, FileAction, Leave};
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::typesetting::theme::error_color;

/// The open dialog.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Dialog {
    /// Asks for a file to open.
    Open(PathField),
    /// Asks for a student's answers to grade.
    Answers(PathField),
    /// Asks for a file to save to.
    SaveAs { field: PathField, then: Option<Leave> },
    /// Asks for a file to write the camera to, in another program's format; `ending` is empty for a
    /// folder.
    Translate { field: PathField, ending: &'static str },
    /// Asks for a figure and a file to write it to.
    Export(ExportForm),
    /// Shows the progress of an animation's export; closing the dialog cancels it.
    Progress { done: u32, frames: u32 },
    /// Asks for a decision about unsaved changes before they are left.
    Unsaved { title: String, then: Leave },
    /// Offers the unsaved changes of a window that ended without being asked.
    Found { title: String, file: Option<PathBuf>, age: String },
    /// Asks whose version stays: another program has changed the scene's file. `saves` if it was about to be
    /// saved.
    Theirs { title: String, saves: bool, then: Option<Leave> },
    /// A message to read and close.
    Message(Message),
}

/// A message to the user.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Message {
    /// One line.
    title: String,
    /// The whole story.
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
}

/// A field for a path, typed or chosen from a list.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PathField {
    /// The typed text.
    pub(crate) text: String,
    /// The extensions of the listed files, and the hint in the empty field.
    endings: &'static [&'static str],
    hint: &'static str,
    /// The listed folder and its entries.
    folder: PathBuf,
    entries: Vec<Entry>,
    /// The path of an existing file that may be overwritten.
    overwrite: Option<PathBuf>,
}

#[derive(Clone, Debug, PartialEq)]
struct Entry {
    name: String,
    path: PathBuf,
    is_folder: bool,
}

impl PathField {
    /// Creates the field for a file with one of these extensions; starts in the folder of `path`, with
    /// `name` filled in.
    pub(crate) fn new(
        path: Option<&Path>,
        name: &str,
        endings: &'static [&'static str],
        hint: &'static str,
    ) -> PathField {
        let folder = path
            .and_then(Path::parent)
            .filter(|folder| !folder.as_os_str().is_empty())
            .map(Path::to_owned)
            .or_else(|| std::env::current_dir().ok())
            .unwrap_or_default();
        let text = match name {
            "" => String::new(),
            name => folder.join(name).display().to_string(),
        };
        let mut field = PathField {
            text,
            endings,
            hint,
            folder: PathBuf::new(),
            entries: Vec::new(),
            overwrite: None,
        };
        field.list(folder);
        field
    }

    fn list(&mut self, folder: PathBuf) {
        let mut entries: Vec<Entry> = (std::fs::read_dir(&folder).into_iter().flatten().flatten())
            .filter_map(|entry| {
                let path = entry.path();
                let name = entry.file_name().to_string_lossy().into_owned();
                let is_folder = path.is_dir();
                let ending = path.extension().and_then(|ending| ending.to_str());
                let is_one = ending.is_some_and(|ending| self.endings.contains(&ending));
                (!name.starts_with('.') && (is_folder || is_one)).then_some(Entry {
                    name,
                    path,
                    is_folder,
                })
            })
            .collect();
        entries.sort_by(|a, b| (!a.is_folder, &a.name).cmp(&(!b.is_folder, &b.name)));
        self.entries = entries;
        self.folder = folder;
    }

    /// Shows the field and the folder. Returns a path once one is chosen that is no folder.
    fn ui(&mut self, ui: &mut Ui, verb: &str, cancel: &mut bool) -> Option<PathBuf> {
        let mut chosen = None;
        let field = TextEdit::singleline(&mut self.text).hint_text(self.hint);
        let response = ui.add(field.desired_width(f32::INFINITY)).named("path");
        if response.changed() {
            self.overwrite = None;
        }
        let entered = response.lost_focus() && ui.input(|i| i.key_pressed(egui::Key::Enter));
        if !entered && ui.memory(|memory| memory.focused().is_none()) {
            response.request_focus();
        }
        ui.horizontal_wrapped(|ui| {
            if let Some(parent) = self.folder.parent().map(Path::to_owned)
                && ui.button("Up").on_hover_text("The folder above").clicked()
            {
                self.list(parent);
            }
            ui.weak(self.folder.display().to_string());
        });
        let mut enter = None;
        let list = ScrollArea::vertical().auto_shrink([false, false]);
        let height = list_height(ui.ctx());
        list.max_height(height).min_scrolled_height(height).show(ui, |ui| {
            for entry in &self.entries {
                let name =
                    if entry.is_folder { format!("{}/", entry.name) } else { entry.name.clone() };
                let row = ui.selectable_label(Path::new(&self.text) == entry.path, name);
                // A double click is also reported as a click.
                if row.clicked() && entry.is_folder {
                    enter = Some(entry.path.clone());
                } else if row.double_clicked() {
                    chosen = Some(entry.path.clone());
                } else if row.clicked() {
                    self.text = entry.path.display().to_string();
                }
            }
        });
        if let Some(folder) = enter {
            self.list(folder);
        }
        let typed = self.text.trim();
        let buttons = ui.horizontal(|ui| {
            let ready = ui.add_enabled(!typed.is_empty(), egui::Button::new(verb)).clicked();
            *cancel |= ui.button("Cancel").clicked();
            ready
        });
        let ready = buttons.inner || entered;
        if ready && !typed.is_empty() {
            chosen = Some(std::path::absolute(typed).unwrap_or_else(|_| PathBuf::from(typed)));
        }
        if let Some(folder) = chosen.take_if(|path| path.is_dir()) {
            self.list(folder);
        }
        chosen
    }
}

/// Height of the list of files: as high as it needs to be, less where the window is low. Never what an
/// area has left over, which is known only after some frames.
fn list_height(ctx: &Context) -> f32 {
    (ctx.content_rect().height() - 360.0).clamp(64.0, 240.0)
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
                ui.heading("Open a scene");
                let path = field.ui(ui, "Open", &mut close);
                path.map(|path| Leave::Open(SceneSource::File(path)).into())
            }
            Dialog::Answers(field) => {
                ui.heading("Check a student's answers");
                let path = field.ui(ui, "Check", &mut close);
                path.map(|path| AnswersAction::Check(path).into())
            }
            Dialog::SaveAs { field, then } => {
                ui.heading("Save the scene as");
                let path = save_ui(ui, field, "Save", "toml", &mut close);
                path.map(|path| FileAction::SaveAs { path, then: then.take() }.into())
            }
            Dialog::Translate { field, ending } => {
                ui.heading("Save the camera for another program");
                let path = save_ui(ui, field, "Save", ending, &mut close);
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
    // It was put in the middle by the size it had, which may be that of another dialog. Shown there, it
    // would jump away from under the mouse.
    if size() != size_before {
        ctx.request_discard("a dialog has another size");
    }
    if close || response.should_close() {
        *dialog = None;
    }
}

/// Shows the field. Returns a path once it is chosen; an existing file must be chosen twice.
pub(crate) fn save_ui(
    ui: &mut Ui,
    field: &mut PathField,
    verb: &str,
    ending: &str,
    cancel: &mut bool,
) -> Option<PathBuf> {
    let mut chosen = None;
    if let Some(mut path) = field.ui(ui, verb, cancel) {
        if path.extension().is_none() {
            path.set_extension(ending);
        }
        if path.exists() && field.overwrite.as_ref() != Some(&path) {
            field.overwrite = Some(path);
        } else {
            chosen = Some(path);
        }
    }
    if let Some(path) = &field.overwrite {
        let text = format!("{} exists. {verb} once more to replace it.", path.display());
        ui.label(RichText::new(text).color(error_color(ui)));
    }
    chosen
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
        let restore = ui.button("Restore").on_hover_text("Opens the scene with them");
        let beside = ui.button("Open beside");
        let beside = beside.on_hover_text("Opens them as a scene of their own, in no file");
        let discard = ui.button("Discard").on_hover_text("Removes them");
        let later = ui.button("Not now").on_hover_text("Asks again at the next start");
        *close |= later.clicked();
        match (restore.clicked(), beside.clicked(), discard.clicked()) {
            (true, ..) => Some(Leave::Found { beside: false }.into()),
            (_, true, _) => Some(Leave::Found { beside: true }.into()),
            (.., true) => Some(FileAction::DiscardFound.into()),
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
        "Your changes are not in the file, and those of the other program are not on the screen.",
    );
    ui.add_space(8.0);
    let buttons = ui.horizontal(|ui| {
        let when = if saves { "Saves" } else { "Lets the next save write" };
        let mine = ui.button("Keep mine").on_hover_text(format!("{when} yours over theirs"));
        let theirs = ui.button("Take theirs");
        let theirs = theirs.on_hover_text("Reads the file again. Undo brings yours back");
        let other = ui.button("Save as…").on_hover_text("Saves yours to another file");
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
