//! The page of a browser: a canvas, drawn by WebGL through eframe.

use eframe::wasm_bindgen::JsCast as _;
use eframe::{CreationContext, Frame, WebOptions, WebRunner};
use egui::Ui;
use pinhole_exchange::{BuiltinScene, Document, FileError, SceneSource};
use web_sys::HtmlCanvasElement;

use crate::model::OpenDocument;
use crate::model::store::Remembered;
use crate::ui::app::App;

/// The identifier of the page's canvas.
const CANVAS: &str = "canvas";

/// The window's contents, as eframe runs them.
struct Page(App);

impl eframe::App for Page {
    fn ui(&mut self, ui: &mut Ui, _: &mut Frame) {
        self.0.ui(ui);
    }
}

/// Shows the program in the page's canvas.
pub fn main() {
    wasm_bindgen_futures::spawn_local(async {
        let Some(canvas) = canvas() else { return };
        let runner = WebRunner::new();
        let app = Box::new(|creation: &CreationContext<'_>| Ok(Box::new(page(creation)?) as _));
        if let Err(error) = runner.start(canvas, WebOptions::default(), app).await {
            panic!("{error:?}");
        }
    });
}

/// Returns the canvas of the page.
fn canvas() -> Option<HtmlCanvasElement> {
    web_sys::window()?.document()?.get_element_by_id(CANVAS)?.dyn_into().ok()
}

fn page(creation: &CreationContext<'_>) -> Result<Page, FileError> {
    let remembered = Remembered::default();
    App::set_up(&creation.egui_ctx, &remembered.settings);
    Ok(Page(App::new(canonical()?, remembered, None)))
}

fn canonical() -> Result<OpenDocument, FileError> {
    match BuiltinScene::find("canonical") {
        Some(scene) => Ok(OpenDocument::new(scene.load()?, SceneSource::Builtin(scene))),
        None => Ok(OpenDocument::new(Document::default(), SceneSource::File("scene.toml".into()))),
    }
}
