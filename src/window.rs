//! Opening the window on a scene.

use std::path::Path;

use crate::app::App;
use crate::document::Document;
use crate::files::OpenDocument;
use crate::formats::FileError;
use crate::formats::builtin;
use crate::formats::scene_argument::SceneSource;
use crate::present::{self, PresentError, Program, Renderer, WindowOptions};
use crate::store::{Remembered, Store};

/// What the window opens on.
struct Start {
    open: OpenDocument,
    remembered: Remembered,
    /// Why it is not the scene of the last run.
    trouble: Option<String>,
}

/// Reads the scene to open: the one named, else the last run's, else the lecture's own.
fn start(scene: Option<&Path>, remembered: Remembered) -> Result<Start, FileError> {
    let load = |argument: &Path| {
        let source = SceneSource::of(argument)?;
        Ok::<_, FileError>(OpenDocument::new(source.load()?, source))
    };
    if let Some(argument) = scene {
        // A ray selected in another scene means nothing in this one.
        let remembered = Remembered { selection: None, ..remembered };
        return Ok(Start { open: load(argument)?, remembered, trouble: None });
    }
    let last = remembered.last.as_deref().map(load);
    match last {
        Some(Ok(open)) => Ok(Start { open, remembered, trouble: None }),
        Some(Err(error)) => Ok(Start {
            open: canonical()?,
            remembered: Remembered { selection: None, ..remembered },
            trouble: Some(error.to_string()),
        }),
        None => Ok(Start { open: canonical()?, remembered, trouble: None }),
    }
}

fn canonical() -> Result<OpenDocument, FileError> {
    match builtin::find("canonical") {
        Some(scene) => Ok(OpenDocument::new(scene.load()?, SceneSource::Builtin(scene))),
        None => Ok(OpenDocument::new(Document::default(), SceneSource::File("scene.toml".into()))),
    }
}
