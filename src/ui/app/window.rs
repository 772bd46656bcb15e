//! The window itself: its title and place, closing it, checking the scene's files for changes, and the
//! settings for the next run.

use std::io::Write as _;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use egui::{Context, ViewportCommand};

use super::writing::Writing;
use crate::model::files::{Stamps, argument_of, is_text, remember, title_of};
use crate::model::{Remembered, Settings, Store};
use crate::ui::app::scene::OpenScene;

/// The window's own state.
#[derive(Default)]
pub(super) struct AppWindow {
    store: Option<Store>,
    /// This window's state when it was last loaded or saved.
    stored: Arc<Mutex<Remembered>>,
    /// This window's state in the last pass.
    state: Remembered,
    writing: Writing,
    /// What is kept for the next run. Its settings, progress and scene are those of the start.
    pub(super) kept: Remembered,
    title: String,
    /// While presenting, whether the window filled the screen before; `None` otherwise.
    filled_before: Option<bool>,
    /// True if the close button may close the window without a question.
    may_close: bool,
    /// True if the user chose to discard the unsaved changes.
    pub(super) discarded: bool,
}

impl AppWindow {
    pub(super) fn new(store: Option<Store>, remembered: Remembered) -> AppWindow {
        AppWindow {
            store,
            kept: remembered.clone(),
            state: remembered.clone(),
            stored: Arc::new(Mutex::new(remembered)),
            writing: Writing::new("settings were not saved"),
            ..AppWindow::default()
        }
    }

    /// Puts a file first in the list of recent files.
    pub(super) fn remember(&mut self, path: &Path) {
        remember(&mut self.kept.recent, path);
    }

    /// Closes the window without asking.
    pub(super) fn close(&mut self, ctx: &Context) {
        self.may_close = true;
        ctx.send_viewport_cmd(ViewportCommand::Close);
    }

    /// Returns true if the close button was pressed and the window may not close yet.
    pub(super) fn is_to_close(&self, ctx: &Context) -> bool {
        ctx.input(|i| i.viewport().close_requested()) && !self.may_close
    }

    /// Allows the window to close, or keeps it open.
    pub(super) fn let_close(&mut self, ctx: &Context, may_close: bool) {
        self.may_close = may_close;
        if !may_close {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
        }
    }

    /// Updates the title, fills the screen while presenting, and saves the state some time after a change.
    pub(super) fn follow(&mut self, ctx: &Context, scene: &OpenScene) {
        self.fill_screen(ctx, scene.session.presenting.is_some());
        let changed = if scene.open.has_changes() { "*" } else { "" };
        let title = format!("{}{changed} - Pinhole", title_of(scene.open.origin()));
        if title != self.title {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
        }
        if self.store.is_some() {
            let state = self.state(scene);
            if state != self.state {
                self.state = state;
                self.writing.note(ctx);
            }
            if self.writing.is_due(ctx) {
                self.save_state();
            }
        }
    }

    /// Makes the window fill its screen when presenting begins, and restores it when presenting ends.
    fn fill_screen(&mut self, ctx: &Context, presenting: bool) {
        if presenting != self.filled_before.is_some() {
            let fills = ctx.input(|i| i.viewport().fullscreen) == Some(true);
            let before = self.filled_before.take();
            self.filled_before = presenting.then_some(fills);
            ctx.send_viewport_cmd(ViewportCommand::Fullscreen(before.unwrap_or(true)));
        }
    }

    /// Returns what the next run is to know: the settings, window, recent files and open scene.
    fn state(&self, scene: &OpenScene) -> Remembered {
        let argument = argument_of(scene.open.origin());
        Remembered {
            settings: settings_to_remember(scene),
            progress: scene.session.progress.clone(),
            selection: argument.is_some().then_some(scene.session.shown.selection),
            recent: self.kept.recent.iter().filter(|path| is_text(path)).cloned().collect(),
            last: argument.or_else(|| scene.lessons.scene_before.clone()),
            lesson: scene.lessons.remembered(),
            ..self.kept.clone()
        }
    }

    /// Saves the state for the next run. Returns when it is on the disk.
    pub(super) fn remember_state(&mut self, scene: &OpenScene) {
        self.state = self.state(scene);
        self.save_state();
        self.writing.finish();
    }

    /// Saves a change of the state now, because it may be a long time until the next frame.
    pub(super) fn save_now(&mut self) {
        if self.writing.first_change.is_some() {
            self.save_state();
        }
    }

    /// Starts to save the state.
    fn save_state(&mut self) {
        let Some(store) = self.store.clone() else { return };
        let (stored, state) = (Arc::clone(&self.stored), self.state.clone());
        self.writing.start(move || {
            let mut stored = stored.lock().unwrap_or_else(PoisonError::into_inner);
            store.save(&stored, &state).map_err(|error| error.to_string())?;
            stored.clone_from(&state);
            Ok(())
        });
    }
}

/// Returns the settings without the changes that lessons and presenter mode made.
fn settings_to_remember(scene: &OpenScene) -> Settings {
    let Settings { mut setup, preferences } = scene.session.settings();
    if let Some(presenting) = &scene.session.presenting {
        setup.layout = presenting.before(setup.layout);
    }
    if let Some(before) = &scene.lessons.before {
        setup = before.shown.setup;
    }
    Settings { setup, preferences }
}

/// Writes a message to standard error. Ignores a failure, because there is nowhere to report it.
pub fn complain(text: &str) {
    let _ = writeln!(std::io::stderr(), "pinhole: {text}");
}

/// Notices that another program has changed the scene's files.
#[derive(Default)]
pub(super) struct FileWatch {
    /// The files' stamps (times and sizes) at the last check, if a file had changed by then.
    last: Option<Stamps>,
    /// The stamps of the last reported change.
    reported: Option<Stamps>,
}

impl FileWatch {
    /// Returns true if a change of the scene's files must be reported. `touched` is the files' stamps (times
    /// and sizes) if one of them has changed. A change is reported once, and only when two checks see the
    /// same stamps, because until then another program may still be writing the file.
    pub(super) fn is_news(&mut self, touched: Option<Stamps>, may_report: bool) -> bool {
        let rests = touched.is_some() && touched == self.last;
        self.last = touched;
        let is_news = rests && may_report && touched != self.reported;
        if is_news {
            self.reported = touched;
        }
        is_news
    }
}
