//! The desktop's own file dialog, if there is one. On Linux and similar systems it belongs to the
//! desktop's portal; on Windows and macOS, to the system.
//!
//! The dialog runs on another thread while the window continues to draw, and the answer arrives as an
//! event.
//!
//! The crate `rfd` is used only on Windows and macOS. With a portal, it mistakes an error for a closed
//! dialog, or starts Zenity, whereas the window would show its own list. Also, `rfd` needs libdbus,
//! whereas the window already uses zbus for screen readers.

#[cfg(all(unix, not(target_os = "macos")))]
mod portal;
#[cfg(any(windows, target_os = "macos"))]
mod system;

#[cfg(all(unix, not(target_os = "macos")))]
pub(super) use self::portal::{FileDialog, ask, detect};
#[cfg(any(windows, target_os = "macos"))]
pub(super) use self::system::{FileDialog, ask, detect};
