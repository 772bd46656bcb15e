//! Where the program runs: in a window of the desktop, or in a page of a browser. Both show the same
//! [`App`], and keep files by a [`Host`](pinhole_exchange::host::Host) each.

#[cfg(not(target_arch = "wasm32"))]
mod desktop;
#[cfg(target_arch = "wasm32")]
pub mod web;

#[cfg(not(target_arch = "wasm32"))]
pub use desktop::main;
#[cfg(target_arch = "wasm32")]
pub use web::main;

use std::path::Path;
use std::sync::Arc;

use pinhole_exchange::{BuiltinScene, FileError, SceneSource};

use crate::model::lessons::{Lesson, StepId};
use crate::model::{OpenDocument, Remembered, Store};
use crate::ui::app::App;

/// Starts the app with the named scene or lesson, otherwise with that of the last run, otherwise with the
/// lecture's own scene.
///
/// # Errors
/// Returns an error if the named scene or lesson cannot be read.
fn start(
    scene: Option<&Path>,
    lesson: Option<(StepId, Option<Arc<Lesson>>)>,
    store: Option<Store>,
    mut remembered: Remembered,
) -> Result<App, FileError> {
    let lesson = match (lesson, scene) {
        (Some(lesson), _) => Some(lesson),
        (None, Some(_)) => None,
        (None, None) => remembered.lesson_step().map(|id| (id, None)),
    };
    let load = |argument: &Path| OpenDocument::open(SceneSource::from_argument(argument)?);
    let (open, trouble) = match scene {
        Some(argument) => (load(argument)?, None),
        None => match remembered.last.as_deref().map(load) {
            Some(Ok(open)) => (open, None),
            Some(Err(error)) => (canonical()?, Some(error.to_string())),
            None => (canonical()?, None),
        },
    };
    if scene.is_some() || trouble.is_some() {
        // A ray selected in another scene has no meaning in this one.
        remembered.selection = None;
    }
    let mut app = App::new(open, remembered, store);
    if let Some((id, file)) = lesson {
        app.open_lesson(id, file);
    }
    if let Some(trouble) = trouble {
        app.show_message("The last scene cannot be opened again", trouble);
    }
    Ok(app)
}

/// Returns the lecture's own scene.
fn canonical() -> Result<OpenDocument, FileError> {
    match BuiltinScene::find("canonical") {
        Some(scene) => OpenDocument::open(SceneSource::Builtin(scene)),
        None => Ok(OpenDocument::blank()),
    }
}
