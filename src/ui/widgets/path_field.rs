//! The choice of a file, in the window's own list or in the desktop's dialog.

use std::path::{Path, PathBuf};

use egui::{Button, Key, RichText, ScrollArea, Ui};
use pinhole_exchange::host::host;
use pinhole_figure::typesetting::theme::error_color;

use crate::ui::widgets::{ResponseExt as _, line_field};

/// A question that asks for a file to read or to write.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FileQuestion {
    /// The heading of the dialog. Its first word is the verb on the button that answers the question.
    pub title: &'static str,
    /// The extensions of the listed files.
    pub endings: &'static [&'static str],
    /// The hint in the empty field.
    pub hint: &'static str,
    /// For a file to write, the extension that is added to a name without one; `None` for a file to read.
    pub writes: Option<&'static str>,
}

impl FileQuestion {
    /// Returns the name of the button that answers it.
    pub fn verb(&self) -> &'static str {
        self.title.split(' ').next().unwrap_or_default()
    }
}

/// A question for the desktop's dialog.
#[derive(Clone, Debug, PartialEq)]
pub struct FileRequest {
    /// The question.
    pub question: FileQuestion,
    /// The folder to begin in.
    pub folder: PathBuf,
    /// The proposed name; empty for none.
    pub name: String,
}

/// The answer of the desktop's dialog.
#[derive(Clone, Debug, PartialEq)]
pub enum FileAnswer {
    /// The user chose this file; the desktop has already asked about overwriting it.
    Chosen(PathBuf),
    /// The user chose a place with this URI, which is not on this computer.
    Elsewhere(String),
    /// The dialog was closed without a choice.
    Cancelled,
    /// The desktop's dialog is missing or does not work.
    Unavailable,
}

/// A field for a path, which the user types, chooses from a list, or chooses in the desktop's dialog.
#[derive(Default)]
pub(crate) struct PathField {
    /// The typed text.
    pub(crate) text: String,
    pub(crate) question: FileQuestion,
    /// True if an existing file is not replaced: something is added to its end.
    pub(crate) adds: bool,
    /// True if the user chooses the file in the desktop's dialog, rather than in the window's list.
    is_desktops: bool,
    /// The request to the desktop's dialog, while that dialog is open.
    request: Option<FileRequest>,
    /// The path that was chosen in the desktop's dialog.
    chosen: Option<PathBuf>,
    /// The listed folder and its entries: folders before files, and each kind in order of names.
    folder: PathBuf,
    entries: Vec<FolderEntry>,
    /// The path of an existing file that is overwritten if the user chooses it again.
    overwrite: Option<PathBuf>,
}

/// A file or folder in the list: true for a file, its name, and its path.
type FolderEntry = (bool, String, PathBuf);

impl PathField {
    /// Creates the field. It starts in the folder of `path`, with `name` filled in.
    pub(crate) fn new(question: FileQuestion, path: Option<&Path>, name: &str) -> PathField {
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
        let mut field = PathField { text, question, ..PathField::default() };
        field.list(folder);
        field
    }

    /// Lets the user choose the file in the desktop's dialog. If `at_once` is true, that dialog opens
    /// immediately; otherwise, when the button is clicked. A browser chooses the folder of a download, but not
    /// its name; and a desktop would ask whether to replace a file to which something is added.
    pub(crate) fn leave_to_desktop(&mut self, at_once: bool) {
        if self.adds || self.question.writes.is_some() && !host().has_folders() {
            return;
        }
        (self.is_desktops, self.request) = (true, None);
        if at_once {
            let name = Path::new(&self.text).file_name().unwrap_or_default();
            let name = name.to_string_lossy().into_owned();
            let folder = std::path::absolute(&self.folder).unwrap_or_else(|_| self.folder.clone());
            self.request = Some(FileRequest { question: self.question, folder, name });
        }
    }

    /// Returns the request to the desktop's dialog, while that dialog is open.
    pub(crate) fn request(&self) -> Option<&FileRequest> {
        self.request.as_ref()
    }

    /// Accepts the path that was chosen in the desktop's dialog.
    pub(crate) fn choose(&mut self, path: PathBuf) {
        (self.chosen, self.request) = (Some(path), None);
    }

    /// Uses the window's list from now on.
    pub(crate) fn ask_by_list(&mut self) {
        (self.is_desktops, self.request) = (false, None);
    }

    fn list(&mut self, folder: PathBuf) {
        let files = std::fs::read_dir(&folder).into_iter().flatten().flatten();
        let entries = files.map(|entry| {
            let (path, name) = (entry.path(), entry.file_name().to_string_lossy().into_owned());
            (!path.is_dir(), name, path)
        });
        let is_listed = |(is_file, name, path): &FolderEntry| {
            let ending = path.extension().and_then(|ending| ending.to_str());
            let is_one = ending.is_some_and(|ending| self.question.endings.contains(&ending));
            !name.starts_with('.') && (!is_file || is_one)
        };
        self.entries = entries.filter(is_listed).collect();
        self.entries.sort();
        self.folder = folder;
    }

    /// Shows the field. Returns the path of a file once the user has chosen it; sets `cancel` to true if the
    /// user cancels instead. In the window's own list, the user must confirm before an existing file is
    /// overwritten.
    pub(crate) fn ui(&mut self, ui: &mut Ui, cancel: &mut bool) -> Option<PathBuf> {
        let mut chosen = match self.is_desktops {
            true => self.desktop_ui(ui, cancel),
            false => self.list_ui(ui, cancel),
        };
        if let Some(folder) = chosen.take_if(|path| path.is_dir()) {
            self.list(folder);
            self.ask_by_list();
        }
        self.check_overwriting(ui, chosen)
    }

    fn list_ui(&mut self, ui: &mut Ui, cancel: &mut bool) -> Option<PathBuf> {
        let mut chosen = None;
        if !host().has_folders() {
            // A browser chooses the folder of a download.
            self.text = self.text.replace(['/', '\\'], "-");
        }
        let field = line_field(&mut self.text).hint_text(self.question.hint);
        let response = ui.add(field.desired_width(f32::INFINITY)).named("path");
        if response.changed() {
            self.overwrite = None;
        }
        let entered = response.lost_focus() && ui.input(|i| i.key_pressed(Key::Enter));
        if !entered && ui.memory(|memory| memory.focused().is_none()) {
            response.request_focus();
        }
        match host().has_folders() {
            true => chosen = self.folder_ui(ui),
            false => self.endings_ui(ui),
        }
        let typed = self.text.trim();
        let mut ready = entered;
        ui.horizontal(|ui| {
            let verb = Button::new(self.question.verb());
            ready |= ui.add_enabled(!typed.is_empty(), verb).clicked();
            *cancel |= ui.button("Cancel").clicked();
        });
        if ready && !typed.is_empty() {
            chosen = Some(std::path::absolute(typed).unwrap_or_else(|_| PathBuf::from(typed)));
        }
        chosen
    }

    /// Shows a choice of the file's kind, if there are several.
    fn endings_ui(&mut self, ui: &mut Ui) {
        let endings = self.question.endings;
        ui.horizontal_wrapped(|ui| {
            for ending in endings.iter().filter(|_| endings.len() > 1) {
                let path = Path::new(&self.text);
                let is_chosen = path.extension().is_some_and(|chosen| chosen == *ending);
                if ui.radio(is_chosen, *ending).clicked() {
                    let own =
                        path.extension().filter(|own| endings.iter().any(|ending| own == ending));
                    let stem =
                        if own.is_some() { path.with_extension("") } else { path.to_owned() };
                    self.text = format!("{}.{ending}", stem.display());
                }
            }
        });
    }

    /// Shows the folder and its files. Returns the path of a folder that was clicked, or of a file that was
    /// clicked twice.
    fn folder_ui(&mut self, ui: &mut Ui) -> Option<PathBuf> {
        let mut chosen = None;
        ui.horizontal_wrapped(|ui| {
            if let Some(parent) = self.folder.parent().map(Path::to_owned)
                && ui.button("Up").on_hover_text("The folder above").clicked()
            {
                self.list(parent);
            }
            ui.weak(self.folder.display().to_string());
        });
        let list = ScrollArea::vertical().auto_shrink([false, false]);
        let height = (ui.ctx().content_rect().height() - 360.0).clamp(64.0, 240.0);
        list.max_height(height).min_scrolled_height(height).show(ui, |ui| {
            for (is_file, name, path) in &self.entries {
                let slash = if *is_file { "" } else { "/" };
                let row =
                    ui.selectable_label(Path::new(&self.text) == path, format!("{name}{slash}"));
                // A double click is also reported as a click.
                if row.clicked() && !is_file || row.double_clicked() {
                    chosen = Some(path.clone());
                } else if row.clicked() {
                    self.text = path.display().to_string();
                }
            }
        });
        chosen
    }

    fn desktop_ui(&mut self, ui: &mut Ui, cancel: &mut bool) -> Option<PathBuf> {
        let chosen = self.chosen.take();
        if chosen.is_some() {
            self.overwrite.clone_from(&chosen);
        }
        let is_open = self.request.is_some();
        // The button stays in place, so that a second click hits it again.
        let waits = "Choose the file in the dialog of your desktop.";
        ui.label(if is_open { waits } else { self.question.hint });
        ui.add_space(8.0);
        let mut is_old = chosen.is_some();
        ui.horizontal(|ui| {
            let verb = Button::new(format!("{}…", self.question.verb()));
            if ui.add_enabled(!is_open, verb).clicked() {
                is_old = true;
                self.leave_to_desktop(true);
            }
            *cancel |= ui.button("Cancel").clicked();
            // The desktop's dialog may open on another screen, or never.
            if host().has_folders() && ui.button("List files here").clicked() {
                is_old = true;
                self.ask_by_list();
            }
        });
        if is_old {
            // The buttons drawn in this pass are out of date.
            ui.ctx().request_repaint();
        }
        chosen
    }

    /// Returns a chosen path once it may be used. A file to read may be used at once. A file to write gets
    /// its extension, if it has none, and may be used if it does not exist yet, if something is
    /// added to its end, or if the user has confirmed that it is to be overwritten; until then, shows a warning and returns `None`.
    fn check_overwriting(&mut self, ui: &mut Ui, chosen: Option<PathBuf>) -> Option<PathBuf> {
        let Some(ending) = self.question.writes else { return chosen };
        let chosen = chosen.and_then(|mut path| {
            if path.extension().is_none() {
                path.set_extension(ending);
            }
            if path.exists() && !self.adds && self.overwrite.as_ref() != Some(&path) {
                self.ask_by_list();
                self.text = path.display().to_string();
                self.overwrite = Some(path);
                return None;
            }
            self.overwrite = None;
            Some(path)
        });
        if let Some(path) = &self.overwrite {
            let verb = self.question.verb();
            let text = format!("{} exists. {verb} once more to replace it.", path.display());
            ui.label(RichText::new(text).color(error_color(ui)));
        }
        chosen
    }
}
