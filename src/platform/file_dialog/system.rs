//! The file dialog of Windows and macOS.

use rfd::AsyncFileDialog;
use winit::window::Window;

use crate::ui::dialogs::path_field::{FileAnswer, FileRequest};

/// Calls `tell`: these systems always have a dialog.
pub(crate) fn detect(tell: impl FnOnce() + Send + 'static) {
    tell();
}

/// An open dialog. The system keeps the dialog in front of its window until the user answers.
pub(crate) struct FileDialog;

/// Opens a file dialog over the window, and passes the answer to `tell`.
pub(crate) fn ask(
    request: &FileRequest,
    window: &Window,
    tell: impl FnOnce(FileAnswer) + Send + 'static,
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
        wait(dialog.save_file(), tell);
    } else {
        wait(dialog.pick_file(), tell);
    }
    FileDialog
}

fn wait(
    chosen: impl Future<Output = Option<rfd::FileHandle>> + Send + 'static,
    tell: impl FnOnce(FileAnswer) + Send + 'static,
) {
    std::thread::spawn(move || {
        let chosen = pollster::block_on(chosen);
        tell(chosen.map_or(FileAnswer::Cancelled, |file| FileAnswer::Chosen(file.path().into())));
    });
}
