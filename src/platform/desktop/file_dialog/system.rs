//! The file dialog of Windows and macOS.

use rfd::AsyncFileDialog;
use winit::window::Window;

use crate::ui::dialogs::path_field::{FileAnswer, FileRequest};

/// Calls `on_found`: these systems always have a dialog.
pub(crate) fn detect(on_found: impl FnOnce() + Send + 'static) {
    on_found();
}

/// An open dialog. The system keeps the dialog in front of its window until the user answers.
pub(crate) struct FileDialog;

/// Opens a file dialog over the window, and passes the answer to `on_answer`.
pub(crate) fn ask(
    request: &FileRequest,
    window: &Window,
    on_answer: impl FnOnce(FileAnswer) + Send + 'static,
) -> FileDialog {
    let question = request.question;
    let mut dialog = AsyncFileDialog::new()
        .set_title(question.title)
        .set_directory(&request.folder)
        .set_file_name(&request.name)
        .set_parent(window);
    if !question.endings.is_empty() {
        dialog = dialog
            .add_filter(question.endings.join(", "), question.endings)
            .add_filter("all files", &["*"]);
    }
    // On macOS, the window's thread must start the dialog, and another thread must wait for the
    // answer.
    if question.writes.is_some() {
        wait(dialog.save_file(), on_answer);
    } else {
        wait(dialog.pick_file(), on_answer);
    }
    FileDialog
}

fn wait(
    chosen: impl Future<Output = Option<rfd::FileHandle>> + Send + 'static,
    on_answer: impl FnOnce(FileAnswer) + Send + 'static,
) {
    std::thread::spawn(move || {
        let chosen = pollster::block_on(chosen);
        on_answer(
            chosen.map_or(FileAnswer::Cancelled, |file| FileAnswer::Chosen(file.path().into())),
        );
    });
}
