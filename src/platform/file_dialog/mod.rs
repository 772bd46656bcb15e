//! The desktop's own file dialog, where it has one: its portal on Linux and the like, the system's dialog
//! on Windows and macOS.
//!
//! It is asked beside the window's thread, which goes on drawing, and tells its answer as an event.
//!
//! The crate `rfd` is used on Windows and macOS alone. With a portal it takes an error for a closed
//! dialog, or starts Zenity, where the window would ask by its own list; and it needs libdbus, while the
//! window talks to screen readers through zbus already.

#[cfg(all(unix, not(target_os = "macos")))]
mod portal;
#[cfg(any(windows, target_os = "macos"))]
mod system;

#[cfg(all(unix, not(target_os = "macos")))]
pub(super) use self::portal::{FileDialog, ask, detect};
#[cfg(any(windows, target_os = "macos"))]
pub(super) use self::system::{FileDialog, ask, detect};
