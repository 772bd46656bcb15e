//! The desktop's own file dialog, if there is one: that of the desktop's portal, on Linux and similar systems, and
//! that of Windows.
//!
//! The dialog runs on another thread while the window continues to draw, and the answer arrives as an
//! event.
//!
//! The crate `rfd` is used on Windows only: with a portal, it mistakes an error for a closed dialog, or starts Zenity,
//! whereas the window would show its own list. Also, it needs libdbus, whereas the window already uses zbus for
//! screen readers.

#[cfg(all(unix, not(target_os = "macos")))]
mod portal;
#[cfg(windows)]
mod windows;

#[cfg(all(unix, not(target_os = "macos")))]
pub(super) use self::portal::{FileDialog, ask, detect};
#[cfg(windows)]
pub(super) use self::windows::{FileDialog, ask, detect};
#[cfg(target_os = "macos")]
pub(super) use self::without::{FileDialog, ask, detect};

/// Time within which no user closes a dialog. A dialog that ends sooner could not be opened.
#[cfg(not(target_os = "macos"))]
const AT_ONCE: std::time::Duration = std::time::Duration::from_millis(500);

/// Replaces the dialog on macOS: the window shows its own list.
#[cfg(target_os = "macos")]
mod without {
    use winit::window::Window;

    use crate::ui::widgets::path_field::{FileAnswer, FileRequest};

    /// An open dialog; there is none.
    pub(crate) struct FileDialog;

    /// Does nothing: there is no dialog to find.
    pub(crate) fn detect(_: impl FnOnce() + Send + 'static) {}

    /// Opens no dialog. Is not called, because [`detect`] finds none.
    pub(crate) fn ask(
        _: &FileRequest,
        _: &Window,
        _: impl FnOnce(FileAnswer) + Send + 'static,
    ) -> FileDialog {
        FileDialog
    }
}
