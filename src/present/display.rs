//! Reaching the display, without panics where it cannot be reached.

use super::PresentError;
use super::window::UserEvent;
use std::panic::{AssertUnwindSafe, catch_unwind};
use winit::event_loop::EventLoop;

/// The event loop, of which a process can have one.
pub(super) fn event_loop() -> Result<EventLoop<UserEvent>, PresentError> {
    let mut builder = EventLoop::with_user_event();
    #[cfg(target_os = "linux")]
    if only_x11_answers() {
        winit::platform::x11::EventLoopBuilderExtX11::with_x11(&mut builder);
    }
    // A missing libxkbcommon-x11, or an X server without an extension, is a panic in winit.
    match without_panic(|| builder.build()) {
        Ok(Ok(event_loop)) => Ok(event_loop),
        Ok(Err(error)) => Err(PresentError::NoDisplay(first_line(&error.to_string()))),
        Err(panic) => Err(PresentError::NoDisplay(panic)),
    }
}

/// Whether `WAYLAND_DISPLAY` names nothing that answers while there is an X display: winit would
/// try the first alone.
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

/// Runs something; a panic in it becomes its message, and is not written to stderr.
pub(super) fn without_panic<T>(run: impl FnOnce() -> T) -> Result<T, String> {
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let result = catch_unwind(AssertUnwindSafe(run));
    std::panic::set_hook(hook);
    result.map_err(|panic| {
        let text = panic.downcast_ref::<String>().cloned();
        text.or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned()))
            .unwrap_or_else(|| "an unknown failure".to_owned())
    })
}

fn first_line(text: &str) -> String {
    text.lines().next().unwrap_or_default().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_becomes_its_message() {
        assert_eq!(without_panic(|| 7), Ok(7));
        assert_eq!(without_panic(|| panic!("no {}", "luck")), Err::<(), _>("no luck".to_owned()));
    }
}
