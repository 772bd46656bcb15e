//! The file dialog of Windows.

use std::thread;
use std::time::Instant;

use winit::window::Window;

use super::AT_ONCE;
use crate::ui::widgets::path_field::{FileAnswer, FileRequest};

/// An open dialog. It cannot be closed by the program, whose window takes no input meanwhile.
pub(crate) struct FileDialog;

/// Calls `on_found`: Windows always has a dialog.
pub(crate) fn detect(on_found: impl FnOnce() + Send + 'static) {
    on_found();
}

/// Opens a file dialog over the window, and passes the answer to `on_answer`.
pub(crate) fn ask(
    request: &FileRequest,
    window: &Window,
    on_answer: impl FnOnce(FileAnswer) + Send + 'static,
) -> FileDialog {
    let (question, writes) = (request.question, request.question.writes.is_some());
    let mut dialog = rfd::FileDialog::new()
        .set_parent(window)
        .set_title(question.title)
        .set_directory(&request.folder)
        .set_file_name(&request.name);
    if !question.endings.is_empty() {
        dialog = dialog
            .add_filter(question.endings.join(", "), question.endings)
            .add_filter("all files", &["*"]);
    }
    thread::spawn(move || {
        let asked = Instant::now();
        let chosen = if writes { dialog.save_file() } else { dialog.pick_file() };
        let was_seen = asked.elapsed() > AT_ONCE;
        let none = if was_seen { FileAnswer::Cancelled } else { FileAnswer::Unavailable };
        on_answer(chosen.map_or(none, FileAnswer::Chosen));
    });
    FileDialog
}
