//! The page of a browser: a canvas, drawn by WebGL through eframe, and the page's own script.
//!
//! eframe hands on events, draws, and keeps a loop of animation frames. The script (`page.js`) does what only
//! a script can: it stores, downloads, locks, and stops that loop while nothing changes.

mod browser;
mod page;
pub mod rehearsal;
pub mod self_test;

use std::any::Any;
use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::pin::Pin;
use std::process::ExitCode;
use std::sync::{Arc, OnceLock};

use eframe::{CreationContext, WebOptions, WebRunner};
use egui::{Context, FullOutput, RawInput, Ui, ViewportCommand, ViewportId};
use pinhole_exchange::page::PagePart;
use pinhole_exchange::{FileError, host, limits};
use pinhole_figure::typesetting::theme::{self, Look};
use wasm_bindgen::JsCast as _;
use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::HtmlCanvasElement;

use crate::model::lessons::{Lesson, LessonArgument, OpenLesson, StepId};
use crate::model::recovery::{Slot, Unsaved};
use crate::model::{Remembered, Store, fault};
use crate::ui::app::{App, SpokenAbout, look_of};
use crate::ui::widgets::number;
use crate::ui::widgets::path_field::{FileAnswer, FileRequest};

/// The identifier of the page's canvas.
const CANVAS: &str = "canvas";

/// The app, as eframe runs it.
struct Page {
    app: App,
    /// True while the browser's dialog for files is open.
    is_choosing: bool,
    /// What the screen reader was told about last.
    told: Option<SpokenAbout>,
}

/// What the script has done since the last frame.
#[derive(Default)]
struct Events {
    /// Files that were dropped.
    dropped: Vec<PathBuf>,
    /// The reason why a chosen or dropped file cannot be read.
    refused: Option<String>,
    /// True if the page no longer fills the screen.
    left_screen: bool,
    /// The link that was opened in the page's address.
    link: Option<String>,
    /// The answer of the browser's dialog for files.
    choice: Option<FileAnswer>,
}

thread_local! {
    static EVENTS: RefCell<Events> = RefCell::default();
    static RUNNER: RefCell<Option<WebRunner>> = const { RefCell::new(None) };
}

static CONTEXT: OnceLock<Context> = OnceLock::new();

/// Shows the program in the page's canvas.
pub fn main() -> ExitCode {
    fault::watch(program_failed);
    host::set(browser::Browser);
    wasm_bindgen_futures::spawn_local(async {
        let Some(canvas) = canvas() else { return };
        let (files, locks) = browser::slots();
        page::find_locks(locks, files).await;
        let app =
            Box::new(|creation: &CreationContext<'_>| Ok(Box::new(Page::new(creation)?) as _));
        let runner = WebRunner::new();
        RUNNER.set(Some(runner.clone()));
        if let Err(error) = runner.start(canvas, WebOptions::default(), app).await {
            program_failed(&format!("{error:?}"));
        }
    });
    ExitCode::SUCCESS
}

/// Returns the canvas of the page.
fn canvas() -> Option<HtmlCanvasElement> {
    web_sys::window()?.document()?.get_element_by_id(CANVAS)?.dyn_into().ok()
}

impl Page {
    fn new(creation: &CreationContext<'_>) -> Result<Page, FileError> {
        let store = Store::at(&browser::state());
        let mut remembered = store.load();
        if store.is_new() {
            remembered.settings.preferences.reduced_motion = page::reduced_motion();
        }
        // Files that the user chose in an earlier run are not in this page.
        remembered.recent.clear();
        if remembered.last.take_if(|last| last.extension().is_some()).is_some() {
            remembered.selection = None;
        }
        App::set_up(&creation.egui_ctx, &remembered.settings);
        let look = Look { by_touch: page::is_touched(), ..look_of(&remembered.settings, false) };
        theme::install(&creation.egui_ctx, look);
        creation.egui_ctx.add_plugin(Output);
        let _ = CONTEXT.set(creation.egui_ctx.clone());
        let address = page::address();
        if address.starts_with("http") {
            remembered.address = address;
        }
        let mut app = open(store, remembered)?;
        let fragment = page::fragment();
        if !fragment.is_empty() {
            app.follow_link(fragment);
        }
        app.set_renderer_name("WebGL".to_owned());
        app.use_desktop_dialog();
        Ok(Page { app, is_choosing: false, told: None })
    }
}

/// Starts the app with what the page's address or the page itself names. If that cannot be opened, starts
/// with the last scene, and shows the reason.
fn open(store: Store, remembered: Remembered) -> Result<App, FileError> {
    let start = |scene: Option<&Path>, lesson| {
        super::start(scene, lesson, Some(store.clone()), remembered.clone())
    };
    let opened = PagePart::parse(&page::part()).and_then(|part| {
        for (name, text) in part.files {
            browser::add(&name, text.into_bytes());
        }
        let lesson = part.lesson.map(|name| lesson_of(&name, part.step)).transpose()?;
        let scene = part.scene.map(PathBuf::from);
        start(scene.as_deref(), lesson).map_err(|error| error.to_string())
    });
    opened.or_else(|reason| {
        let mut app = start(None, None)?;
        app.show_message("The scene in this page cannot be opened", reason);
        Ok(app)
    })
}

/// Reads the lesson of the page's part or address, and finds its step, counted from 1.
fn lesson_of(name: &str, step: Option<usize>) -> Result<(StepId, Option<Arc<Lesson>>), String> {
    let argument = LessonArgument::parse(name)?;
    let (mut id, file) = argument.load().map_err(|error| error.to_string())?;
    id.step = step.map_or(id.step, |step| step.wrapping_sub(1));
    match OpenLesson::at(id, file.as_ref()) {
        Some(_) => Ok((id, file)),
        None => Err(format!("the lesson has no step {}", id.step.wrapping_add(1))),
    }
}

impl eframe::App for Page {
    fn raw_input_hook(&mut self, _: &Context, input: &mut RawInput) {
        // eframe does not say how large the window is, although a page always has a size.
        let size = input.screen_rect;
        input.viewports.entry(ViewportId::ROOT).or_default().inner_rect = size;
        let events = EVENTS.take();
        input.dropped_files.clear();
        input
            .dropped_files
            .extend(events.dropped.into_iter().map(|path| Arc::new(Dropped(path)) as _));
        if let Some(reason) = events.refused {
            self.app.show_message("This file cannot be read", reason);
        }
        if events.left_screen {
            self.app.end_presenting();
        }
        if let Some(link) = events.link {
            self.app.follow_link(link);
        }
        if let Some(choice) = events.choice {
            self.is_choosing = false;
            self.app.answer_file(choice);
        }
    }

    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        LAST.set(self.app.unsaved());
        self.app.ui(ui);
        self.ask_for_file();
        if !ui.input(|input| input.pointer.any_down()) {
            let about = self.app.spoken_about();
            if self.told.as_ref() != Some(&about) {
                page::tell(&self.app.spoken());
                self.told = Some(about);
            }
        }
    }

    fn save(&mut self, _: &mut dyn eframe::Storage) {
        self.app.rest();
        self.app.remember();
    }

    fn as_any_mut(&mut self) -> Option<&mut dyn Any> {
        Some(self)
    }
}

impl Page {
    /// Opens the browser's dialog for files if the app asks for a file to read.
    fn ask_for_file(&mut self) {
        let Some(FileRequest { question, .. }) = self.app.file_request() else {
            self.is_choosing = false;
            return;
        };
        if std::mem::replace(&mut self.is_choosing, true) {
            return;
        }
        // A scene may name a table, which must be chosen together with it.
        let endings = question.endings.iter().chain(&["csv"]);
        let extensions: Vec<_> = endings.map(|ending| format!(".{ending}")).collect();
        page::choose(&extensions.join(","));
    }
}

/// A file that was dropped into the page, and is in memory.
#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes_async(&self) -> Pin<Box<dyn Future<Output = Result<Vec<u8>, String>> + '_>> {
        let bytes = limits::read(&self.0, limits::TABLE).map_err(|error| error.to_string());
        Box::pin(async { bytes })
    }
}

/// Takes a file that the user chose or dropped into memory. Returns the path under which the app knows it.
#[wasm_bindgen]
pub fn file_added(name: &str, content: Vec<u8>) -> String {
    browser::add(name, content).to_string_lossy().into_owned()
}

/// Tells the app which file the user chose, or that the user chose none.
#[wasm_bindgen]
pub fn choice_made(path: Option<String>) {
    let answer = path.map_or(FileAnswer::Cancelled, |path| FileAnswer::Chosen(path.into()));
    EVENTS.with_borrow_mut(|events| events.choice = Some(answer));
    wake();
}

/// Tells the app which file the user dropped.
#[wasm_bindgen]
pub fn file_dropped(path: String) {
    EVENTS.with_borrow_mut(|events| events.dropped.push(path.into()));
    wake();
}

/// Tells the app why a file that the user chose or dropped cannot be read.
#[wasm_bindgen]
pub fn file_refused(reason: String) {
    EVENTS.with_borrow_mut(|events| events.refused = Some(reason));
    wake();
}

/// Tells the app that the page no longer fills the screen, which the user may have asked of the browser.
#[wasm_bindgen]
pub fn screen_left() {
    EVENTS.with_borrow_mut(|events| events.left_screen = true);
    wake();
}

/// Stores unsaved changes and settings, because the page is hidden or closed.
#[wasm_bindgen]
pub fn page_hidden() {
    let runner = RUNNER.with_borrow(Clone::clone);
    if let Some(mut page) = runner.as_ref().and_then(|runner| runner.app_mut::<Page>()) {
        page.app.rest();
        page.app.remember();
    }
}

/// Tells the app which link the user opened in the page.
#[wasm_bindgen]
pub fn link_opened(fragment: String) {
    EVENTS.with_borrow_mut(|events| events.link = Some(fragment));
    wake();
}

fn wake() {
    if let Some(ctx) = CONTEXT.get() {
        ctx.request_repaint();
    }
}

thread_local! {
    /// The unsaved changes before the last frame, for the case that the frame fails.
    static LAST: RefCell<Option<(Unsaved, Arc<Slot>)>> = const { RefCell::new(None) };
}

/// Writes the last changes to their slot, because the program has failed and cannot go on. Shows a message with
/// a report, which has the scene. The script calls it for an error that is no panic, such as a trap.
#[wasm_bindgen]
pub fn program_failed(message: &str) {
    let version = env!("CARGO_PKG_VERSION");
    let last = LAST.take();
    let is_kept = last.as_ref().is_none_or(|(unsaved, slot)| unsaved.write(slot).is_ok());
    let scene = last.and_then(|(unsaved, slot)| unsaved.text(&slot).ok()).unwrap_or_default();
    let report = format!("Pinhole {version} in a browser\n{message}\n\n{scene}");
    page::failed(message, &report, is_kept);
}

/// Carries out what a frame asks of the window, and lets the page rest until the next one.
struct Output;

impl egui::Plugin for Output {
    fn debug_name(&self) -> &'static str {
        "page"
    }

    fn output_hook(&mut self, ctx: &Context, output: &mut FullOutput) {
        page::type_numbers(number::is_typed(ctx));
        let Some(window) = output.viewport_output.get_mut(&ViewportId::ROOT) else { return };
        for command in window.commands.drain(..) {
            match command {
                ViewportCommand::Title(title) => page::set_title(&title),
                ViewportCommand::Fullscreen(fill) => page::fill_screen(fill),
                // A page cannot do anything else to its window.
                _ => {}
            }
        }
        page::rest(window.repaint_delay.as_secs_f64());
    }
}
