//! Where the open document came from, and getting it from and to there.

use std::path::{Path, PathBuf};

use crate::document::Document;
use crate::formats::scene_argument::SceneSource;
use crate::formats::scene_file;

/// How many files the list of recent ones holds.
const RECENT: usize = 10;

/// What the window's title calls a scene from there.
pub fn title_of(source: &SceneSource) -> String {
    match source {
        SceneSource::Builtin(scene) => scene.name.to_owned(),
        SceneSource::File(path) => match path.file_name() {
            Some(name) => name.to_string_lossy().into_owned(),
            None => path.display().to_string(),
        },
    }
}

/// The argument that names this source on the command line, from any folder.
pub fn argument_of(source: &SceneSource) -> PathBuf {
    match source {
        SceneSource::Builtin(scene) => PathBuf::from(scene.name),
        SceneSource::File(path) => absolute(path),
    }
}

/// The open document with what is needed to save it again and to know whether it changed.
#[derive(Clone, Debug)]
pub struct OpenDocument {
    /// The document as edited.
    pub document: Document,
    /// The document as it was opened or last saved.
    saved: Document,
    /// Where it came from.
    pub source: SceneSource,
}

impl OpenDocument {
    /// A document just read from its source.
    pub fn new(document: Document, source: SceneSource) -> Self {
        OpenDocument { saved: document.clone(), document, source }
    }

    /// Whether there is anything to lose.
    pub fn has_changes(&self) -> bool {
        self.document != self.saved
    }

    /// The file that *Save* writes; a built-in scene has none.
    pub fn file(&self) -> Option<&Path> {
        match &self.source {
            SceneSource::File(path) => Some(path),
            SceneSource::Builtin(_) => None,
        }
    }

    /// Writes the document to `path`, from where it comes from now on.
    ///
    /// # Errors
    /// Why it could not be written; what was there before is still there.
    pub fn save_to(&mut self, path: &Path) -> Result<(), String> {
        scene_file::save(&self.document, path).map_err(|error| error.to_string())?;
        // The reference to a file of spheres is relative to where the scene lies.
        self.document = scene_file::load(path).map_err(|error| error.to_string())?;
        self.saved = self.document.clone();
        self.source = SceneSource::File(path.to_owned());
        Ok(())
    }
}

/// Puts a file at the head of the list of recent ones.
pub fn remember(recent: &mut Vec<PathBuf>, path: &Path) {
    let path = absolute(path);
    recent.retain(|known| *known != path);
    recent.insert(0, path);
    recent.truncate(RECENT);
}

fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}
