//! The window's program: small parts, each with its own state, and the order in which they take their
//! turns in a frame (`frame`).

mod apply;
mod files;
mod frame;
mod history;
mod lessons;
mod over;
mod playback;
mod recovery;
mod scene;
mod views;
mod window;

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use egui::Context;
use pinhole_exchange::document::Document;

use self::history::SceneHistory;
use self::over::Overlays;
use self::playback::Playback;
use self::recovery::Recovery;
use self::scene::OpenScene;
use self::views::Views;
use self::window::AppWindow;
use self::window::FileWatch;
use crate::model::files::OpenDocument;
use crate::model::lessons::{Lesson, OpenLesson, StepId};
use crate::model::play::Player;
use crate::model::session::{Session, Settings, ZOOM};
use crate::model::store::{Remembered, Store};
use crate::ui::action::{Action, FileAction};
use crate::ui::dialogs::Dialog;
use crate::ui::dialogs::path_field::{FileAnswer, FileRequest};
use crate::ui::frame_times::{FrameWork, WorkTimes};
use crate::ui::scene::dragging::Dragging;
use crate::ui::workspaces::Tools;
use crate::view::adaptive_resolution::AdaptiveResolution;
use crate::view::derive::Derived;
use crate::view::typesetting::theme::{self, Look};

pub(crate) use self::window::complain;

/// The open document, how it is looked at, and what is shown of it.
pub struct App {
    scene: OpenScene,
    history: SceneHistory,
    playback: Playback,
    over: Overlays,
    views: Views,
    tools: Tools,
    dragging: Dragging,
    window: AppWindow,
    recovery: Recovery,
    watch: FileWatch,
    /// A fault of the program itself in the last frame.
    failure: Option<String>,
    /// Actions for the next pass.
    waiting: Vec<Action>,
    /// True once a pass has laid out the window.
    is_laid_out: bool,
}

impl App {
    /// The program on this document, with what the last run remembered.
    pub fn new(open: OpenDocument, remembered: Remembered, store: Option<Store>) -> App {
        let recovery = Recovery::new(store.as_ref());
        let mut window = AppWindow::new(store, remembered.window, remembered.recent);
        if let Some(path) = open.file().map(Path::to_owned) {
            window.remember(&path);
        }
        let session = Session {
            selection: remembered.selection.map_or_else(Default::default, Into::into),
            settings: remembered.settings.in_range(),
            ..Session::default()
        };
        App {
            history: SceneHistory::new(&open.document),
            scene: OpenScene::new(open, session),
            playback: Playback::default(),
            // What was found is offered as soon as no dialog is open.
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

    /// Gives a window's context the program's fonts, zoom and ways. Once, before the first frame.
    pub fn set_up(ctx: &Context, settings: &Settings) {
        theme::install_base(ctx);
        ctx.all_styles_mut(|style| {
            style.interaction.selectable_labels = true;
            // Bars that stay tell that there is more.
            style.spacing.scroll = egui::style::ScrollStyle::solid();
        });
        // Its keys stand in the table of commands with all others.
        ctx.options_mut(|options| {
            options.zoom_with_keyboard = false;
            // Set at once: a change would be taken over in the first pass, with another size of the screen.
            options.zoom_factor = settings.zoom.clamp(ZOOM.0, ZOOM.1);
        });
        theme::install(ctx, Look::new(settings, false));
    }

    /// Says what draws the window.
    pub fn set_renderer_name(&mut self, renderer: String) {
        self.window.renderer = renderer;
    }

    /// Tells the user about an error from before the window was there.
    pub fn tell(&mut self, title: &str, text: String) {
        self.over.dialog = Some(Dialog::message(title, text));
    }

    /// Shows a lesson from this step on; `file` is the lesson if it comes from a file. Nothing happens
    /// where there is no such step.
    pub fn open_lesson(&mut self, id: StepId, file: Option<Arc<Lesson>>) {
        if let Some(opened) = self.scene.open_lesson(id, file) {
            self.history.take_as_settled(&self.scene.open.document);
            self.show_opened(opened);
        }
    }

    /// The open document.
    pub fn document(&self) -> &Document {
        &self.scene.open.document
    }

    /// The session, which looks at the document.
    pub fn session(&self) -> &Session {
        &self.scene.session
    }

    /// The lesson that is open.
    pub fn lesson(&self) -> Option<&OpenLesson> {
        self.scene.lessons.open.as_ref()
    }

    /// The animation that is open.
    pub fn player(&self) -> Option<&Player> {
        self.playback.player.as_ref()
    }

    /// The values that the last frame showed.
    pub fn derived(&self) -> &Derived {
        &self.views.derived
    }

    /// Number of pictures traced so far.
    pub fn pictures_traced(&self) -> u64 {
        self.views.deriver.traced()
    }

    /// Sets the time that tracing may take while a hand moves what is traced; pictures are coarser where
    /// it would take longer. For those who want to see it happen on any scene.
    pub fn follow_within(&mut self, budget: Duration) {
        self.views.adaptive_resolution = AdaptiveResolution::within(budget);
    }

    /// Times all frames from now on, for those who keep a log.
    pub(crate) fn time_frames(&mut self) {
        self.views.frame_work = Some(FrameWork::default());
    }

    /// The work of the frame presented last, if it showed a new picture and is timed.
    pub(crate) fn work_presented(&self) -> Option<WorkTimes> {
        self.views.frame_work.as_ref()?.work()
    }

    /// Returns true if the scene has a file, which another program may change.
    pub fn watches_file(&self) -> bool {
        self.scene.open.scene_file().is_some()
    }

    /// Looks whether another program has changed the scene's file. Returns true if there is something to show.
    pub fn look_at_file(&mut self) -> bool {
        let is_free = !self.over.covers() && self.playback.player.is_none();
        let is_news = self.watch.is_news(self.scene.open.touched(), is_free);
        self.waiting.extend(is_news.then(|| FileAction::CheckFile.into()));
        is_news
    }

    /// Asks for files by the desktop's dialog from now on; the caller then looks at
    /// [`file_request`](App::file_request) after each frame.
    pub fn use_desktop_dialog(&mut self) {
        self.over.has_desktop = true;
    }

    /// The question that the desktop's dialog is to ask; `None` closes it.
    pub fn file_request(&mut self) -> Option<&FileRequest> {
        self.over.dialog.as_mut()?.field()?.request()
    }

    /// Takes the answer of the desktop's dialog. The next frame carries it out.
    pub fn answer_file(&mut self, answer: FileAnswer) {
        self.over.answer(answer);
    }

    /// Takes note that there may be no frame for a long time.
    pub fn rest(&mut self) {
        self.recovery.write_now(&self.scene.open);
    }

    /// Remembers settings, window, recent files and the open scene for the next run, and changes that
    /// nobody was asked about.
    pub fn on_exit(&mut self) {
        self.recovery.end(&self.scene.open, self.window.discarded);
        self.window.end(&self.scene);
    }
}
