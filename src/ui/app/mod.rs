//! The program in the window: its parts, each of which owns its state, and the order in which a frame runs
//! them (`frame.rs`).

mod apply;
mod files;
mod frame;
mod glide;
mod history;
mod keep;
mod lessons;
mod over;
mod playback;
mod question;
mod recovery;
mod scene;
mod share;
mod spoken;
mod views;
mod window;
mod writing;

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use egui::Context;
use pinhole_exchange::document::Document;
use pinhole_figure::typesetting::theme;

pub(crate) use self::apply::look_of;
use self::history::SceneHistory;
use self::over::Overlays;
use self::playback::Playback;
use self::recovery::Recovery;
use self::scene::OpenScene;
use self::views::Views;
use self::window::{AppWindow, FileWatch};
use crate::features::play::Player;
use crate::model::recovery::{Slot, Unsaved};
use crate::model::session::{Session, Settings, Shown, ZOOM};
use crate::model::{Lesson, OpenDocument, OpenLesson, Remembered, StepId, Store};
use crate::ui::Tools;
use crate::ui::action::{Action, FileAction, LookAction};
use crate::ui::frame_times::WorkTimes;
use crate::ui::scene::Dragging;
use crate::ui::widgets::path_field::{FileAnswer, FileRequest};
use crate::view::adaptive_resolution::AdaptiveResolution;
use crate::view::derive::Derived;

pub use self::spoken::SpokenAbout;
pub use self::window::complain;

/// The program's state: the open document, the session that views it, and everything derived from them.
pub struct App {
    scene: OpenScene,
    /// The scene of the exercise on the stage.
    question: Option<OpenScene>,
    history: SceneHistory,
    playback: Playback,
    over: Overlays,
    views: Views,
    tools: Tools,
    dragging: Dragging,
    window: AppWindow,
    recovery: Recovery,
    watch: FileWatch,
    /// The message of a panic in the last frame, if there was one.
    failure: Option<String>,
    /// Actions for the next pass.
    waiting: Vec<Action>,
    /// True once a pass has laid out the window.
    is_laid_out: bool,
}

impl App {
    /// Creates the program with this document and with the state saved by the last run.
    pub fn new(open: OpenDocument, remembered: Remembered, store: Option<Store>) -> App {
        let recovery = Recovery::new(store.as_ref());
        let mut window = AppWindow::new(store, remembered.clone());
        if let Some(path) = open.scene_file().map(Path::to_owned) {
            window.remember(&path);
        }
        let Settings { setup, preferences } = remembered.settings.in_range();
        let selection = remembered.selection.unwrap_or_default();
        let session = Session {
            shown: Shown { selection, setup, ..Shown::default() },
            preferences,
            progress: remembered.progress,
            ..Session::default()
        };
        App {
            history: SceneHistory::new(&open.document),
            scene: OpenScene::new(open, session),
            question: None,
            playback: Playback::default(),
            // Recovered changes are offered once no dialog is open.
            over: Overlays::default(),
            views: Views::default(),
            tools: Tools::default(),
            dragging: Dragging::default(),
            window,
            recovery,
            watch: FileWatch::default(),
            failure: None,
            waiting: Vec::new(),
            is_laid_out: false,
        }
    }

    /// Sets up a context's fonts, zoom and style. Must be called once, before the first frame.
    pub fn set_up(ctx: &Context, settings: &Settings) {
        theme::install_base(ctx);
        ctx.all_styles_mut(|style| {
            style.interaction.selectable_labels = true;
            // Scroll bars stay visible, so that the user sees that there is more.
            style.spacing.scroll = egui::style::ScrollStyle::solid();
        });
        ctx.options_mut(|options| {
            // The zoom's keys are in the table of commands.
            options.zoom_with_keyboard = false;
            options.fallback_theme = egui::Theme::Light;
            // If the zoom were set later, it would take effect in the first pass and change the size of the
            // screen.
            options.zoom_factor = settings.preferences.zoom.clamp(ZOOM.0, ZOOM.1);
        });
        theme::install(ctx, look_of(settings, false));
    }

    /// Sets the renderer's name, which bug reports and the next run use.
    pub fn set_renderer_name(&mut self, renderer: String) {
        self.window.kept.renderer = renderer;
    }

    /// Shows a message about an error that occurred before the window opened.
    pub fn show_message(&mut self, title: &str, text: String) {
        self.tell(title, text);
    }

    /// Opens a lesson at this step; `file` is the lesson if it comes from a file. Does nothing if the step
    /// does not exist.
    pub fn open_lesson(&mut self, id: StepId, file: Option<Arc<Lesson>>) {
        self.stop_animation();
        match self.scene.open_lesson(id, file) {
            Ok(opened) => {
                self.history.take_as_settled(&self.scene.open.document);
                self.show_opened(opened);
            }
            Err(problem) => self.over.ask(problem),
        }
    }

    /// Ends presenting, because the window no longer fills the screen.
    pub fn end_presenting(&mut self) {
        if self.scene.session.presenting.is_some() {
            apply::change_look(&mut self.scene.session, LookAction::Present);
        }
    }

    /// Returns the open document.
    pub fn document(&self) -> &Document {
        &self.scene.open.document
    }

    /// Returns the session: how the document is viewed.
    pub fn session(&self) -> &Session {
        &self.scene.session
    }

    /// Returns the open lesson.
    pub fn lesson(&self) -> Option<&OpenLesson> {
        self.scene.lessons.open.as_ref()
    }

    /// Returns the open animation.
    pub fn player(&self) -> Option<&Player> {
        self.playback.player.as_ref()
    }

    /// Returns the values shown in the last frame.
    pub fn derived(&self) -> &Derived {
        &self.views.derived
    }

    /// Returns the number of pictures traced so far.
    pub fn pictures_traced(&self) -> u64 {
        self.views.deriver.traced()
    }

    /// Sets the time budget for tracing during a drag. Pictures that take longer become coarser. Tests use it
    /// to make any scene coarse.
    pub fn follow_within(&mut self, budget: Duration) {
        self.views.adaptive_resolution = AdaptiveResolution::within(budget);
    }

    /// Returns the times of the work of the last presented frame; `None` if it showed no new picture.
    pub fn work_presented(&self) -> Option<WorkTimes> {
        self.views.frame_work.work()
    }

    /// Returns true if the scene has a file, which another program may change.
    pub fn watches_file(&self) -> bool {
        self.scene.open.scene_file().is_some()
    }

    /// Checks whether another program has changed the scene's file. Returns true if a frame is needed to
    /// report the change.
    pub fn look_at_file(&mut self) -> bool {
        // A message about a broken file goes when the file is mended.
        let may_ask = !self.over.covers() || self.over.says(apply::NOT_READ);
        let is_free = may_ask && self.playback.player.is_none();
        let is_news = self.watch.is_news(self.scene.open.touched(), is_free);
        self.waiting.extend(is_news.then(|| FileAction::CheckFile.into()));
        is_news
    }

    /// Uses the desktop's dialog to ask for files from now on. The caller must check
    /// [`file_request`](App::file_request) after each frame.
    pub fn use_desktop_dialog(&mut self) {
        self.over.has_desktop = true;
    }

    /// Returns the request to the desktop's file dialog. If this is `None`, the dialog must be closed.
    pub fn file_request(&mut self) -> Option<&FileRequest> {
        self.over.dialog.as_mut()?.field()?.request()
    }

    /// Stores the answer of the desktop's file dialog. The next frame applies it.
    pub fn answer_file(&mut self, answer: FileAnswer) {
        self.over.answer(answer);
    }

    /// Writes pending changes to the recovery file, and saves those of the settings, because it may be a long time
    /// until the next frame.
    pub fn rest(&mut self) {
        self.recovery.write_now(&self.scene.open);
        self.window.save_now();
    }

    /// Returns the unsaved changes, and the recovery slot that they belong to.
    pub fn unsaved(&self) -> Option<(Unsaved, Arc<Slot>)> {
        self.recovery.unsaved(&self.scene.open)
    }

    /// Saves the settings, window, recent files and open scene for the next run.
    pub fn remember(&mut self) {
        self.window.remember_state(&self.scene);
    }

    /// Saves the settings, window, recent files and open scene for the next run, and writes unsaved changes to
    /// the recovery file unless the user discarded them.
    pub fn on_exit(&mut self) {
        self.recovery.end(&self.scene.open, self.window.discarded);
        self.window.remember_state(&self.scene);
    }
}
