//! The window's program: the only place that fixes the order of a frame.
//!
//! inputs (keys, panels, mouse in the views) -> apply (actions) -> derive -> outputs (views,
//! readouts). Where an edit changes what a panel above it has already drawn, egui is asked to run
//! the pass again before anything is presented, so that nothing on screen is older than the rest.

mod actions;
mod animation;
mod answers;
mod exchange;
mod figures;
mod ghost;
mod hand;
mod history;
mod inputs;
mod lessons;
mod outputs;
mod pace;
mod play;
mod verbs;

use std::io::Write as _;
use std::path::{Path, PathBuf};

use egui::ViewportCommand;
use egui::{CentralPanel, Context, Panel, ScrollArea, Ui};

use self::history::Changes;
use self::lessons::Lessons;
use self::verbs::Sheet;
use crate::figures::Recorder;
use crate::model::concept::Hovered;
use crate::model::files::{OpenDocument, argument_of, remember, title_of};
use crate::model::observer::Observer;
use crate::model::play::Player;
use crate::model::session::{Session, Settings, ViewLayout};
use crate::model::store::{Remembered, Store};
use crate::model::window_geometry::WindowGeometry;
use crate::ui::action::Action;
use crate::ui::derivation::DerivationPanel;
use crate::ui::dialogs::dialog as dialogs;
use crate::ui::dialogs::dialog::Dialog;
use crate::ui::frame_times::{FrameWork, Stopwatch};
use crate::ui::panels::{camera, objects, selection, top_bar};
use crate::ui::ray::plot;
use crate::ui::scene::handles::HandInput;
use crate::ui::scene::navigation::Navigation;
use crate::ui::scene::{places, views};
use crate::ui::tools::measuring::Measuring;
use crate::ui::tools::translator::TranslatorPanel;
use crate::ui::view_texture::ViewTexture;
use crate::view::adaptive_resolution::AdaptiveResolution;
use crate::view::derive::{Derived, Deriver, ViewSizes};
use crate::view::typesetting::theme::{self, Look};
use pinhole_exchange::document::Document;

/// The open document, how it is looked at, and what is shown of it.
pub struct App {
    open: OpenDocument,
    session: Session,
    lessons: Lessons,
    changes: Changes,
    player: Option<Player>,
    recorder: Option<Recorder>,
    recent: Vec<PathBuf>,
    chosen_object: usize,
    dialog: Option<Dialog>,
    /// What lies over the window: commands, or keys.
    sheet: Option<Sheet>,
    /// The focus was moved by the keyboard, and is shown by a ring.
    by_keyboard: bool,
    /// Actions for the next pass.
    waiting: Vec<Action>,
    deriver: Deriver,
    derived: Derived,
    world_texture: ViewTexture,
    camera_texture: ViewTexture,
    derivation: DerivationPanel,
    translator: TranslatorPanel,
    /// The error map, or what a wrong camera sees.
    beside_texture: ViewTexture,
    measuring: Measuring,
    /// What went into the last frame, for those who keep a log.
    frame_work: Option<FrameWork>,
    adaptive_resolution: AdaptiveResolution,
    hand: HandInput,
    navigation: Navigation,
    store: Option<Store>,
    geometry: WindowGeometry,
    title: String,
    /// What draws the window, in words.
    renderer: String,
    may_close: bool,
    /// The user chose to lose the changes.
    discarded: bool,
    /// What the last pass showed, and whether it had changes and differed from the lesson's step.
    known: Option<(Document, Session, [bool; 2])>,
}

impl App {
    /// The program on this document, with what the last run remembered.
    pub fn new(open: OpenDocument, remembered: Remembered, store: Option<Store>) -> App {
        let mut app = App {
            changes: Changes::of(&open.document),
            open,
            session: Session {
                selection: remembered.selection.map_or(Session::default().selection, Into::into),
                settings: remembered.settings.in_range(),
                ..Session::default()
            },
            lessons: Lessons::default(),
            player: None,
            recorder: None,
            recent: remembered.recent,
            chosen_object: 0,
            dialog: None,
            sheet: None,
            by_keyboard: false,
            waiting: Vec::new(),
            deriver: Deriver::default(),
            derived: Derived::default(),
            world_texture: ViewTexture::default(),
            camera_texture: ViewTexture::default(),
            derivation: DerivationPanel::default(),
            translator: TranslatorPanel::default(),
            beside_texture: ViewTexture::default(),
            measuring: Measuring::default(),
            frame_work: None,
            adaptive_resolution: AdaptiveResolution::default(),
            hand: HandInput::default(),
            navigation: Navigation::default(),
            store,
            geometry: remembered.window,
            title: String::new(),
            renderer: String::new(),
            may_close: false,
            discarded: false,
            known: None,
        };
        if let Some(path) = app.open.file().map(Path::to_owned) {
            remember(&mut app.recent, &path);
        }
        app
    }

    /// Gives a window's context the program's fonts, zoom and ways. Once, before the first frame.
    pub fn set_up(ctx: &Context, settings: &Settings) {
        theme::install_base(ctx);
        ctx.set_zoom_factor(settings.zoom.clamp(0.5, 4.0));
        ctx.all_styles_mut(|style| {
            style.interaction.selectable_labels = true;
            // Bars that stay tell that there is more.
            style.spacing.scroll = egui::style::ScrollStyle::solid();
        });
        // Its keys stand in the table of commands with all others.
        ctx.options_mut(|options| options.zoom_with_keyboard = false);
        theme::install(ctx, Look::of(settings, false));
    }

    /// Says what draws the window.
    pub fn drawn_by(&mut self, renderer: String) {
        self.renderer = renderer;
    }

    /// Tells the user something that went wrong before the window was there.
    pub fn tell(&mut self, title: &str, text: String) {
        self.dialog = Some(Dialog::Message { title: title.to_owned(), text });
    }

    /// The open document.
    pub fn document(&self) -> &Document {
        &self.open.document
    }

    /// How the document is looked at.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// What the last frame showed.
    pub fn derived(&self) -> &Derived {
        &self.derived
    }

    /// How many pictures were traced so far.
    pub fn pictures_traced(&self) -> u64 {
        self.deriver.traced()
    }

    /// One frame.
    pub fn ui(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        let mut actions = Vec::new();
        self.hand_inputs(&ctx);
        self.window_inputs(&ctx, &mut actions);
        self.panels(ui, &mut actions);
        CentralPanel::default().show(ui, |ui| {
            let image = self.open.document.camera.image;
            let presenting = self.session.presenting.is_some();
            let places = places::places(ui, &mut self.session.settings, image, presenting);
            if let (None, Some(rect)) = (self.session.observer, places.world) {
                self.session.observer = Some(self.framed(rect.aspect_ratio()));
                self.lessons.framed(self.session.observer);
            }
            if !self.is_covered() {
                views::inputs(ui, &places, &mut self.session, &self.derived, &mut actions);
            }
            self.session.hovered = self.hovered(ui, &places);
            for action in actions {
                self.apply(&ctx, action);
            }
            let subsampling = self.subsampling(&ctx);
            let sizes = views::sizes(ui, &places, self.session.settings.layout);
            let under_hand = self.is_under_hand(&ctx);
            let sizes = ViewSizes { subsampling, under_hand, ..sizes };
            // Whose spheres are then changed in place, not copied.
            self.derived.scene = None;
            let stopwatch = Stopwatch::start();
            let tell = |work| stopwatch.tell(work);
            let (document, session) = (&self.open.document, &self.session);
            self.derived = self.deriver.derive_watched(document, session, &sizes, &tell);
            let times = stopwatch.stop();
            self.keep_pace(&ctx, subsampling, times.traced());
            if let Some(frame_work) = &mut self.frame_work {
                frame_work.add(ctx.cumulative_frame_nr(), times);
            }
            if self.session.settings.layout == ViewLayout::Accuracy {
                let name = title_of(self.open.origin());
                self.measuring.step(&ctx, &name, &self.open.document.camera, &self.derived);
            }
            self.outputs(ui, &places);
        });
        self.over_all(ui);
        self.paste_notice(&ctx);
        self.keep_history(&ctx);
        self.record(&ctx);
        self.window_outputs(&ctx);
        self.draw_again_if_stale(&ctx);
    }

    /// Panels are drawn from the top while they are edited. Where an edit changed what had already
    /// been drawn, the pass is run again before anything is presented.
    fn draw_again_if_stale(&mut self, ctx: &Context) {
        let marks = [self.open.has_changes(), self.differs_from_step()];
        let now = (&self.open.document, &self.session, marks);
        let stale = match &self.known {
            None => true,
            Some(known) if (&known.0, &known.1, known.2) == now => return,
            Some((document, session, had_changes)) => {
                let (mut as_drawn, mut looked_at) = (now.0.clone(), now.1.clone());
                // A drag of the camera or of the observer alone changes nothing above its field.
                let camera = &document.camera;
                let same_kind = camera.orientation.kind() == as_drawn.camera.orientation.kind();
                if same_kind && camera.resolve().is_ok() && as_drawn.camera.resolve().is_ok() {
                    as_drawn.camera.eye = camera.eye;
                    as_drawn.camera.orientation = camera.orientation;
                }
                looked_at.observer = session.observer;
                // Nor do handles, which are taken before anything is drawn.
                looked_at.hand.clone_from(&session.hand);
                // Nor does pointing, which is known before anything is drawn.
                looked_at.hovered = session.hovered;
                (document, session, *had_changes) != (&as_drawn, &looked_at, now.2)
            }
        };
        self.known = Some((now.0.clone(), now.1.clone(), now.2));
        if stale {
            ctx.request_discard("an edit changed what is drawn above it");
        }
    }

    fn panels(&mut self, ui: &mut Ui, actions: &mut Vec<Action>) {
        let ctx = ui.ctx().clone();
        dialogs::ui(&ctx, &mut self.dialog, actions);
        self.sheets(&ctx, actions);
        self.follow_look(&ctx);
        if self.session.presenting.is_some() {
            self.lesson_strip(ui, actions);
            return self.play_on(ui, actions);
        }
        Panel::top("top bar").show(ui, |ui| {
            let (undo, redo) = (self.changes.undo_name(), self.changes.redo_name());
            let steps = top_bar::Steps { undo, redo };
            let there = self.available();
            let settings = &mut self.session.settings;
            let open = &self.open;
            top_bar::ui(ui, open, &self.recent, steps, there, settings, actions);
        });
        self.lesson_strip(ui, actions);
        self.play_on(ui, actions);
        if !self.session.settings.layout.shows_the_scene() {
            return;
        }
        let panel =
            Panel::left("panel").resizable(true).default_size(336.0).size_range(316.0..=560.0);
        panel.show(ui, |ui| {
            ScrollArea::vertical().auto_shrink(false).show(ui, |ui| self.left_panel(ui));
        });
    }

    fn left_panel(&mut self, ui: &mut Ui) {
        ui.add_space(4.0);
        if !self.open.document.note.is_empty() {
            egui::CollapsingHeader::new("What to look for").default_open(true).show(ui, |ui| {
                for paragraph in self.open.document.note.split("\n\n") {
                    ui.label(paragraph.replace('\n', " "));
                }
            });
            ui.separator();
        }
        let document = &mut self.open.document;
        let settings = &mut self.session.settings;
        let (image, viewport) = (document.camera.image, document.camera.viewport);
        camera::ui(ui, &mut document.camera, settings);
        let selection = &mut self.session.selection;
        *selection = selection.in_another_image(image, document.camera.image);
        if settings.keep_picture {
            *selection = selection.in_another_viewport(viewport, document.camera.viewport);
        }
        ui.separator();
        let resolved = document.camera.resolve().ok();
        let from_one = settings.count_from_one;
        selection::ui(ui, &mut self.session.selection, resolved.as_ref(), from_one);
        ui.separator();
        objects::ui(ui, document, &mut self.chosen_object);
        ui.add_space(8.0);
    }

    /// What the mouse or the focus is on: something in a view, or a line about it.
    fn hovered(&self, ui: &Ui, places: &places::Places) -> Option<Hovered> {
        if self.is_covered() {
            return None;
        }
        let at_line = || match self.session.settings.layout {
            ViewLayout::Derivation | ViewLayout::DerivationAlone => {
                self.derivation.hovered(ui.ctx())
            }
            ViewLayout::Plot => plot::hovered(ui.ctx(), &self.derived),
            _ => None,
        };
        views::hovered(ui, places, &self.derived).or_else(at_line)
    }

    /// Where everything can be seen from.
    fn framed(&self, aspect: f32) -> Observer {
        let document = &self.open.document;
        // An object at fault is not there yet; the camera is.
        let scene = document.scene().unwrap_or_default();
        Observer::frame_all(&document.camera, &scene, f64::from(aspect))
    }

    fn window_outputs(&mut self, ctx: &Context) {
        let changed = if self.open.has_changes() { "*" } else { "" };
        let title = format!("{}{changed} - Pinhole", title_of(self.open.origin()));
        if title != self.title {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }

    /// Remembers settings, window, recent files and the open scene for the next run.
    pub fn on_exit(&mut self) {
        let Some(store) = self.store.clone() else { return };
        if self.open.has_changes() && !self.discarded {
            // The window went away without asking: its display or its adapter did.
            let path = store.unsaved();
            self.save_to(&path);
            complain(&format!("the unsaved changes are in {}", path.display()));
        }
        let scene = argument_of(self.open.origin());
        let remembered = Remembered {
            settings: self.settings_to_remember(),
            window: self.geometry,
            selection: scene.is_some().then(|| self.session.selection.into()),
            recent: self.recent.clone(),
            renderer: self.renderer.clone(),
            last: scene.or_else(|| self.lessons.scene_before()),
            lesson: self.lessons.remembered(),
        };
        if let Err(error) = store.save(&remembered) {
            complain(&format!("settings were not saved: {error}"));
        }
    }
}

/// Says something on standard error; where that is closed, there is nobody to tell.
pub(crate) fn complain(text: &str) {
    let _ = writeln!(std::io::stderr(), "pinhole: {text}");
}
