//! The window on the screen, drawn by the graphics driver or, without a driver, by our own painter.
//!
//! [`run`] opens the window and shows the app in it. The window is drawn by:
//!
//! - a hardware graphics adapter, through wgpu, if there is one;
//! - otherwise [`painter`](pinhole_figure::painter), on the CPU. It is also used if the adapter fails to
//!   start, or is itself software, because software drivers take many times as long for the same
//!   picture. If the adapter fails later, the painter takes over the open window.
//!
//! The two renderers share one event loop (`window.rs`, `open.rs`), so everything else about the window
//! is the same. Only `gpu.rs` uses wgpu. The user chooses files in the desktop's own dialog if there is
//! one (`file_dialog`).
//!
//! eframe, egui's own framework for windows, has no renderer on the CPU and cannot hand an open window
//! to another renderer when the adapter fails, so the event loop is our own.

use std::path::Path;
use std::process::ExitCode;

use clap::Parser as _;
use etcetera::{BaseStrategy as _, choose_base_strategy};

use crate::cli::arguments::{Arguments, WindowArguments};
use crate::cli::{self, CommandError};
use crate::features::share;
use crate::model::{Store, fault};
use crate::platform::desktop::frames::FrameLog;

mod cpu;
mod display;
mod file_dialog;
mod frames;
#[cfg(feature = "wgpu")]
mod gpu;
mod open;
#[cfg(unix)]
mod signals;
mod start;
mod surface;
mod window;

/// Replaces the module `signals` on systems without signals that end a program.
#[cfg(not(unix))]
mod signals {
    /// Does nothing: no signal ends the window.
    pub(super) fn end_window_by(_end: impl FnOnce() + Send + 'static) {}

    /// Does nothing: there are no signals to watch.
    pub(super) fn watch() {}

    /// Does nothing: there is no signal to pass on.
    pub(super) fn pass_on() {}
}

/// Parses the arguments, and opens the window or runs a headless command.
pub fn main() -> ExitCode {
    #[cfg(windows)]
    attach_terminal();
    fault::watch(fault::print);
    signals::watch();
    let parsed = Arguments::try_parse();
    let is_no_command = match &parsed {
        Ok(parsed) => parsed.command.is_none(),
        Err(asked) => asked.use_stderr(),
    };
    let first = std::env::args_os().nth(1).filter(|_| is_no_command);
    if let Some(wrong) = first.and_then(|first| cli::mistyped(&first)) {
        wrong.exit();
    }
    let code = cli::exit_code(match parsed {
        Ok(Arguments { command: Some(command), .. }) => cli::run(&command),
        Ok(Arguments { command: None, window }) => run(&window),
        // Not an error: the user asked for the help or the version.
        Err(asked) if !asked.use_stderr() => cli::print(&asked),
        Err(wrong) => wrong.exit(),
    });
    signals::pass_on();
    code
}

/// Writes to the terminal that started the program, if there is one: for programs with a window, Windows does not
/// do that. Output to a file or a pipe stays there.
#[cfg(windows)]
fn attach_terminal() {
    use std::os::windows::io::AsRawHandle as _;
    if std::io::stdout().as_raw_handle().is_null() {
        // An error means that there is no terminal.
        let _ = winsafe::AttachConsole(winsafe::PidParent::Parent);
    }
}

/// Opens the window with the named scene or lesson, otherwise with that of the last run, otherwise with
/// the lecture's own scene. Returns when the window is closed.
///
/// # Errors
/// Returns an error if the named scene or lesson cannot be read, or if there is no display.
fn run(arguments: &WindowArguments) -> Result<(), CommandError> {
    let WindowArguments { scene, lesson, renderer } = arguments;
    // The window's thread joins rayon's pool. Otherwise it would wait idly, for each picture, until the
    // workers wake up. An error means that the pool exists already, which is fine.
    let _ = rayon::ThreadPoolBuilder::new().use_current_thread().build_global();
    let store = Store::of_user();
    let mut remembered = store.as_ref().map(Store::load).unwrap_or_default();
    if store.as_ref().is_none_or(Store::is_new) {
        let folders = choose_base_strategy();
        remembered.settings.preferences.reduced_motion =
            folders.is_ok_and(|folders| is_reduced(&folders.config_dir()));
    }
    let geometry = remembered.window;
    let lesson = lesson.as_ref().map(|lesson| lesson.load()).transpose()?;
    let link = scene.as_deref().and_then(share::link::of_argument).transpose()?;
    let scene = scene.as_deref().filter(|_| link.is_none());
    let mut app = super::start(scene, lesson, store, remembered)?;
    if let Some(link) = link {
        app.open_link(link);
    }
    window::run(*renderer, geometry, app, FrameLog::from_environment()).map_err(CommandError::Input)
}

/// Files below the user's configuration folder, each with the key and the values that switch animations
/// off.
const SETTINGS: [(&str, &str, &[&str]); 3] = [
    ("gtk-4.0/settings.ini", "gtk-enable-animations", &["false", "0"]),
    ("gtk-3.0/settings.ini", "gtk-enable-animations", &["false", "0"]),
    ("kdeglobals", "AnimationDurationFactor", &["0"]),
];

/// Returns true if the desktop's settings in `folder` switch animations off; false if the settings
/// do not mention animations.
fn is_reduced(folder: &Path) -> bool {
    SETTINGS.iter().any(|(file, key, off)| {
        let text = std::fs::read_to_string(folder.join(file)).unwrap_or_default();
        let mut entries = text.lines().filter_map(|line| line.split_once('='));
        entries.any(|(name, value)| name.trim() == *key && off.contains(&value.trim()))
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test that cannot write its input has failed")]
mod tests {
    use super::*;

    #[test]
    fn either_desktop_can_switch_motion_off() {
        let folder = tempfile::tempdir().unwrap();
        let write = |file: &str, text: &str| {
            let path = folder.path().join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        };
        assert!(!is_reduced(folder.path()));
        write("gtk-3.0/settings.ini", "[Settings]\ngtk-enable-animations=true\n");
        assert!(!is_reduced(folder.path()));
        write("gtk-3.0/settings.ini", "[Settings]\ngtk-enable-animations = 0\n");
        assert!(is_reduced(folder.path()));
        write("gtk-3.0/settings.ini", "");
        write("kdeglobals", "[KDE]\nAnimationDurationFactor=0.5\n");
        assert!(!is_reduced(folder.path()));
        write("kdeglobals", "[KDE]\nAnimationDurationFactor=0\n");
        assert!(is_reduced(folder.path()));
    }
}
