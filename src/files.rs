//! Where the open document came from, and getting it from and to there.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use pinhole_exchange::document::Document;
use pinhole_exchange::format::{Exported, Text};
use pinhole_exchange::scenes::SceneSource;

use pinhole_exchange::{FileError, atomic, scene_file};

/// How many files the list of recent ones holds.
const RECENT: usize = 10;

/// Where a document came from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A scene.
    Scene(SceneSource),
    /// A lesson's step, of this title.
    Step(String),
}

/// What the window's title calls a document from there.
pub fn title_of(origin: &Origin) -> String {
    match origin {
        Origin::Step(title) => title.clone(),
        Origin::Scene(SceneSource::Builtin(scene)) => scene.name.to_owned(),
        Origin::Scene(SceneSource::File(path)) => match path.file_name() {
            Some(name) => name.to_string_lossy().into_owned(),
            None => path.display().to_string(),
        },
    }
}

/// The argument that names this scene on the command line, from any folder; a step has none.
pub fn argument_of(origin: &Origin) -> Option<PathBuf> {
    match origin {
        Origin::Scene(SceneSource::Builtin(scene)) => Some(PathBuf::from(scene.name)),
        Origin::Scene(SceneSource::File(path)) => Some(absolute(path)),
        Origin::Step(_) => None,
    }
}

/// The open document with what is needed to save it again and to know whether it changed.
#[derive(Clone, Debug)]
pub struct OpenDocument {
    /// The document as edited.
    pub document: Document,
    /// The document as it was opened or last saved.
    saved: Document,
    /// The source's text, whose comments stay with the document wherever it is saved; `None` where
    /// it could not be read.
    text: Option<String>,
    /// Where it came from.
    origin: Origin,
    /// Its changes are not worth asking about: the lesson's step that it is from can be gone back
    /// to, and it belongs to no file.
    forgiving: bool,
}

impl OpenDocument {
    /// A document just read from its source.
    pub fn new(document: Document, source: SceneSource) -> Self {
        let text = match &source {
            SceneSource::Builtin(scene) => Some(scene.text.to_owned()),
            file => file.scene_file().and_then(|path| fs::read_to_string(path).ok()),
        };
        let origin = Origin::Scene(source);
        OpenDocument { saved: document.clone(), document, text, origin, forgiving: false }
    }

    /// The document of a lesson's step that is called `title`. While its lesson is open, no change
    /// of it counts as one that is lost.
    pub fn of_step(document: Document, title: String) -> Self {
        let origin = Origin::Step(title);
        OpenDocument { saved: document.clone(), document, text: None, origin, forgiving: true }
    }

    /// The lesson is closed: from now on, changes count.
    pub fn leave_lesson(&mut self) {
        self.forgiving = false;
    }

    /// Where it came from.
    pub fn origin(&self) -> &Origin {
        &self.origin
    }

    /// Whether there is anything to lose.
    pub fn has_changes(&self) -> bool {
        !self.forgiving && self.document != self.saved
    }

    /// The file that it was read from; a built-in scene has none, nor has a lesson's step.
    pub fn file(&self) -> Option<&Path> {
        match &self.origin {
            Origin::Scene(SceneSource::File(path)) => Some(path),
            Origin::Scene(SceneSource::Builtin(_)) | Origin::Step(_) => None,
        }
    }

    /// The file that *Save* writes: where it was read from a scene file, that one.
    pub fn scene_file(&self) -> Option<&Path> {
        match &self.origin {
            Origin::Scene(source) => source.scene_file(),
            Origin::Step(_) => None,
        }
    }

    /// The name that a file of this document could have.
    pub fn file_name(&self) -> String {
        match &self.origin {
            Origin::Scene(SceneSource::Builtin(scene)) => format!("{}.toml", scene.name),
            Origin::Step(_) => "scene.toml".to_owned(),
            file => title_of(file),
        }
    }

    /// Writes the document to `path`, from where it comes from now on. The comments are those of the
    /// file that it came from until now, also where another file is overwritten.
    ///
    /// # Errors
    /// Why it could not be written; what was there before is still there.
    pub fn save_to(&mut self, path: &Path) -> Result<(), String> {
        let saved = match self.text_on_disk(path) {
            Some(text) => scene_file::save_over(&self.document, path, Some(&text)),
            None => scene_file::save_over(&self.document, path, self.text.as_deref()),
        };
        let saved = saved.map_err(|error| error.to_string())?;
        // As written: the reference to a file of spheres is relative to where the scene lies.
        self.document = saved.document;
        self.saved = self.document.clone();
        self.text = Some(saved.text);
        self.origin = Origin::Scene(SceneSource::File(path.to_owned()));
        self.forgiving = false;
        Ok(())
    }

    /// What the file at `path` holds now, if it is the one that the document came from: its
    /// comments may have been edited since.
    fn text_on_disk(&self, path: &Path) -> Option<String> {
        let same = self.file().is_some_and(|file| resolved(file) == resolved(path));
        same.then(|| fs::read_to_string(path).ok()).flatten()
    }
}

fn resolved(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| absolute(path))
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

/// Writes a camera in another program's terms: a text as a file, several as a folder of files.
///
/// # Errors
/// Where it cannot be written.
pub(crate) fn save_written(written: &Exported, path: &Path) -> Result<(), FileError> {
    let save = |path: &Path, sheet: &Text| {
        atomic::write(path, |file| file.write_all(sheet.text.as_bytes()))
    };
    if let [(_, sheet)] = &written.files[..] {
        return save(path, sheet);
    }
    fs::create_dir_all(path).map_err(|error| FileError::unwritable(path, &error))?;
    written.files.iter().try_for_each(|(name, sheet)| save(&path.join(name), sheet))
}
