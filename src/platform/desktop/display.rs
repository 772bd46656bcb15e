//! Connects to the display. Returns an error instead of panicking if there is no display.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

use egui_winit::accesskit_winit;
use winit::error::EventLoopError;
use winit::event_loop::EventLoop;

use crate::model::fault::text_of;
use crate::ui::widgets::path_field::FileAnswer;

/// An event that wakes the event loop, other than the window's own events.
#[derive(Debug)]
pub(super) enum UserEvent {
    /// A repaint that egui requested.
    Repaint {
        when: Instant,
        /// The number of the egui pass that requested the repaint. The request is outdated once a later pass
        /// has run.
        pass: u64,
    },
    /// A signal that ends the program.
    End,
    /// The desktop has a file dialog that can be used.
    FileDialog,
    /// The number of one of the desktop's file dialogs, and its answer. Only the answer of the latest dialog
    /// counts.
    File(u64, FileAnswer),
    /// A request from a screen reader or a similar tool.
    Accessibility(accesskit_winit::Event),
}

impl From<accesskit_winit::Event> for UserEvent {
    fn from(event: accesskit_winit::Event) -> Self {
        Self::Accessibility(event)
    }
}

/// Creates the event loop, of which a process can have only one.
///
/// # Errors
/// Returns the reason as a sentence if there is no display.
pub(super) fn event_loop() -> Result<EventLoop<UserEvent>, String> {
    let mut builder = EventLoop::with_user_event();
    #[cfg(target_os = "linux")]
    if only_x11_answers() {
        winit::platform::x11::EventLoopBuilderExtX11::with_x11(&mut builder);
    }
    // winit panics without libxkbcommon-x11 or if the X server lacks an extension.
    let built = without_panic(|| builder.build().map_err(|error| cause(&error)));
    built.flatten().map_err(|cause| {
        format!(
            "there is no display to open a window on: {cause}; pinhole render, inspect and the other \
             commands need none: see pinhole --help"
        )
    })
}

/// Returns true if nothing answers at `WAYLAND_DISPLAY`, but there is an X display. In that case winit
/// by itself would try only Wayland.
#[cfg(target_os = "linux")]
fn only_x11_answers() -> bool {
    use std::{env, os::unix::net::UnixStream, path::PathBuf};
    let set = |name: &str| env::var_os(name).filter(|value| !value.is_empty());
    let Some(wayland) = set("WAYLAND_DISPLAY") else { return false };
    if set("DISPLAY").is_none() || set("WAYLAND_SOCKET").is_some() {
        return false;
    }
    let folder = set("XDG_RUNTIME_DIR").map(PathBuf::from).unwrap_or_default();
    UnixStream::connect(folder.join(wayland)).is_err()
}

/// Runs a function. If the function panics, returns the panic message as the error, without
/// printing to stderr.
pub(super) fn without_panic<T>(run: impl FnOnce() -> T) -> Result<T, String> {
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let result = catch_unwind(AssertUnwindSafe(run));
    std::panic::set_hook(hook);
    result.map_err(|panic| text_of(&*panic))
}

/// Returns the reason why the event loop ended unexpectedly, in words for the user.
pub(super) fn reason_of_end(error: &EventLoopError) -> String {
    match error {
        // winit says nothing more about a connection that has failed.
        EventLoopError::ExitFailure(_) => "the connection to the display was lost".to_owned(),
        error => cause(error),
    }
}

/// Returns the first line of an error without the source location that winit puts before it: `TEXT` of `os
/// error at FILE.rs:LINE: TEXT`.
pub(super) fn cause(error: &impl std::fmt::Display) -> String {
    let text = error.to_string();
    let text = text.lines().next().unwrap_or_default();
    let after_location = text.strip_prefix("os error at ").and_then(|rest| {
        let (_, after_file) = rest.split_once(".rs:")?;
        after_file.split_once(": ").map(|(_, cause)| cause)
    });
    after_location.unwrap_or(text).trim_end_matches('.').to_owned()
}

/// Returns the message for a window that is open but can no longer be drawn.
pub(super) fn lost(cause: impl std::fmt::Display) -> String {
    format!("the window can no longer be drawn: {cause}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn causes_name_no_source_files() {
        assert_eq!(cause(&"os error at /a/b.rs:12: no server: gone."), "no server: gone");
        assert_eq!(cause(&"gone\nwith details"), "gone");
    }

    #[test]
    fn a_panic_becomes_its_message() {
        assert_eq!(without_panic(|| 7), Ok(7));
        assert_eq!(without_panic(|| panic!("no {}", "luck")), Err::<(), _>("no luck".to_owned()));
    }
}
