//! The window itself: its title and place, closing it, checking the scene's files for changes, and the
//! settings for the next run.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use egui::{Context, ViewportCommand};

use crate::model::files::{Stamps, argument_of, is_text, remember, title_of};
use crate::model::{Remembered, Settings, Store, WindowGeometry};
use crate::ui::app::scene::OpenScene;

/// The window's own state.
#[derive(Default)]
pub(super) struct AppWindow {
    store: Option<Store>,
    pub(super) geometry: WindowGeometry,
    /// Files opened or saved recently, the latest first.
    pub(super) recent: Vec<PathBuf>,
    /// The address of the page in a browser, for links; empty until the user has typed it.
    pub(super) address: String,
    title: String,
    /// The renderer's name.
    pub(super) renderer: String,
    /// While presenting, whether the window filled the screen before; `None` otherwise.
    filled_before: Option<bool>,
    /// True if the close button may close the window without a question.
    may_close: bool,
    /// True if the user chose to discard the unsaved changes.
    pub(super) discarded: bool,
}

impl AppWindow {
    pub(super) fn new(
        store: Option<Store>,
        geometry: WindowGeometry,
        recent: Vec<PathBuf>,
    ) -> AppWindow {
        AppWindow { store, geometry, recent, ..AppWindow::default() }
    }

    /// Puts a file first in the list of recent files.
    pub(super) fn remember(&mut self, path: &Path) {
        remember(&mut self.recent, path);
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

    /// Updates the title, and fills the screen while presenting.
    pub(super) fn follow(&mut self, ctx: &Context, scene: &OpenScene) {
        self.fill_screen(ctx, scene.session.presenting.is_some());
        let changed = if scene.open.has_changes() { "*" } else { "" };
        let title = format!("{}{changed} - Pinhole", title_of(scene.open.origin()));
        if title != self.title {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
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

    /// Saves the settings, window, recent files and open scene for the next run.
    pub(super) fn remember_state(&mut self, scene: &OpenScene) {
        let Some(store) = &self.store else { return };
        let argument = argument_of(scene.open.origin());
        let remembered = Remembered {
            settings: settings_to_remember(scene),
            progress: scene.session.progress.clone(),
            window: self.geometry,
            selection: argument.is_some().then_some(scene.session.selection),
            recent: self.recent.iter().filter(|path| is_text(path)).cloned().collect(),
            renderer: self.renderer.clone(),
            address: self.address.clone(),
            last: argument.or_else(|| scene.lessons.scene_before.clone()),
            lesson: scene.lessons.remembered(),
        };
        if let Err(error) = store.save(&remembered) {
            complain(&format!("settings were not saved: {error}"));
        }
    }
}

/// Returns the settings without the changes that lessons and presenter mode made.
fn settings_to_remember(scene: &OpenScene) -> Settings {
    let mut session = scene.session.clone();
    if let Some(presenting) = session.presenting {
        session.settings.layout = presenting.before(session.settings.layout);
    }
    scene.lessons.settings_without(&session)
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
