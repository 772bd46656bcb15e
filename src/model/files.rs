//! The open document and its origin, and how it is read and saved.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use pinhole_core::Camera;
use pinhole_exchange::host::{Stamp, host};
use pinhole_exchange::{Document, FileError, SceneSource, legible_name, limits, scene_file};

/// Maximum number of files in the list of recent files.
const RECENT: usize = 10;

/// The title of a scene that belongs to no file.
const UNNAMED: &str = "Unnamed scene";

/// The origin of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A scene.
    Scene(SceneSource),
    /// The title of a lesson's step, or of another scene that belongs to no file.
    Step(String),
}

/// Returns the name of a document with this origin in the window's title.
pub fn title_of(origin: &Origin) -> String {
    match origin {
        Origin::Step(title) => title.clone(),
        Origin::Scene(SceneSource::Builtin(scene)) => scene.name.to_owned(),
        Origin::Scene(SceneSource::File(path)) => {
            legible_name(path.file_name().unwrap_or(path.as_os_str()))
        }
    }
}

/// Returns the command-line argument that opens this scene from any folder. Returns `None` for a
/// lesson's step, and for a path that is not valid Unicode and therefore cannot be stored as text.
pub fn argument_of(origin: &Origin) -> Option<PathBuf> {
    match origin {
        Origin::Scene(SceneSource::Builtin(scene)) => Some(PathBuf::from(scene.name)),
        Origin::Scene(SceneSource::File(path)) => Some(absolute(path)).filter(|path| is_text(path)),
        Origin::Step(_) => None,
    }
}

/// The stamps of the scene file and of the CSV file with its spheres.
pub type Stamps = [Option<Stamp>; 2];

/// Returns the current stamp of the CSV file with a document's spheres; `None` if there is no such file.
fn csv_stamp(document: &Document) -> Option<Stamp> {
    document.csv_spheres.as_ref().and_then(|csv| host().stamp(&csv.file))
}

/// The open document, with the data needed to save it and to detect changes made here or by other programs.
#[derive(Clone, Debug)]
pub struct OpenDocument {
    /// The document as edited.
    pub document: Document,
    /// The camera from before the open animation, which moves that of the document; `None` without one.
    pub before_animation: Option<Camera>,
    /// The document as it was opened or last saved.
    saved: Document,
    /// The text of the source, whose comments are kept when the document is saved; `None` if the
    /// source could not be read.
    text: Option<String>,
    /// The stamps of the files before this window last read them or after it last wrote them; `None` for a file
    /// that did not exist.
    stamps: Stamps,
    /// The document's origin.
    origin: Origin,
    /// True if the document may be closed without a question about unsaved changes. This is the case
    /// for a step of the open lesson, to which the user can return.
    forgiving: bool,
}

impl OpenDocument {
    /// Reads a scene.
    ///
    /// # Errors
    /// Returns the first error in the file or in its CSV file.
    pub fn open(source: SceneSource) -> Result<Self, FileError> {
        // A change of a file while it is read must be noticed later.
        let stamp = source.scene_file().and_then(|path| host().stamp(path));
        let (document, text) = match &source {
            SceneSource::Builtin(scene) => (scene.load()?, scene.text.to_owned()),
            SceneSource::File(path) => scene_file::load_with_text(path)?,
        };
        let stamps = [stamp, document.csv_spheres.as_ref().and_then(|csv| csv.stamp)];
        let (text, origin) = (Some(text), Origin::Scene(source));
        Ok(OpenDocument { text, stamps, origin, ..Self::made_up(document, String::new()) })
    }

    /// Opens the lesson step with this title. While the lesson is open, changes to the document do not
    /// count as unsaved.
    pub fn of_step(document: Document, title: String) -> Self {
        let (origin, saved) = (Origin::Step(title), document.clone());
        OpenDocument {
            document,
            before_animation: None,
            saved,
            text: None,
            stamps: [None; 2],
            origin,
            forgiving: true,
        }
    }

    /// Opens a document with unsaved changes. It belongs to `source` if that can still be read, and
    /// otherwise to no file. `stamp` is the one that the source had when the changes
    /// began.
    pub fn changed(document: Document, source: Option<SceneSource>, stamp: Option<Stamp>) -> Self {
        let Some(open) = source.and_then(|source| Self::open(source).ok()) else {
            return Self::unsaved(document, UNNAMED.to_owned());
        };
        // If the stamps differ, the file's text at the time when the changes began is unknown.
        let text = open.text.filter(|_| open.stamps[0] == stamp);
        OpenDocument { document, text, stamps: [stamp, open.stamps[1]], ..open }
    }

    /// Opens a document with this title that belongs to no file yet and has unsaved changes.
    pub fn unsaved(document: Document, title: String) -> Self {
        OpenDocument { document, ..Self::made_up(Document::default(), title) }
    }

    /// Opens a document with this title that was made by the program: it belongs to no file and has no
    /// unsaved changes.
    pub fn made_up(document: Document, title: String) -> Self {
        OpenDocument { forgiving: false, ..Self::of_step(document, title) }
    }

    /// Makes an empty scene with the canonical camera.
    pub fn blank() -> Self {
        Self::made_up(Document::default(), UNNAMED.to_owned())
    }

    /// Leaves the lesson: from now on, changes count as unsaved. If the step's scene equals one of the
    /// scenes in `known`, the document belongs to the first such scene; otherwise it is unnamed.
    pub fn leave_lesson(&mut self, known: impl Iterator<Item = SceneSource>) {
        if !std::mem::take(&mut self.forgiving) {
            return;
        }
        // A step's document has no note.
        let is_same =
            |known: &Document| Document { note: String::new(), ..known.clone() } == self.saved;
        let mut opened = known.filter_map(|source| Self::open(source).ok());
        *self = match opened.find(|known| is_same(&known.document)) {
            Some(known) => {
                let note = known.document.note.clone();
                OpenDocument { document: Document { note, ..self.document.clone() }, ..known }
            }
            None => OpenDocument { origin: Origin::Step(UNNAMED.to_owned()), ..self.clone() },
        };
    }

    /// Returns the document's origin.
    pub fn origin(&self) -> &Origin {
        &self.origin
    }

    /// Returns true if the document has unsaved changes, or is in no file since its own was removed.
    pub fn has_changes(&self) -> bool {
        let is_removed = self.scene_file().is_some() && self.stamps[0].is_none();
        self.has_edits() || is_removed && !self.forgiving
    }

    /// Returns true if the document differs from the one that was opened or last saved.
    pub fn has_edits(&self) -> bool {
        !self.forgiving && *self.own() != self.saved
    }

    /// Returns the document without what the open animation has changed.
    pub fn own(&self) -> Cow<'_, Document> {
        match self.before_animation {
            None => Cow::Borrowed(&self.document),
            Some(camera) => Cow::Owned(Document { camera, ..self.document.clone() }),
        }
    }

    /// Returns the file that *Save* writes: the scene file from which the document was read.
    pub fn scene_file(&self) -> Option<&Path> {
        match &self.origin {
            Origin::Scene(source) => source.scene_file(),
            Origin::Step(_) => None,
        }
    }

    /// Returns the source's stamp when this window last read or wrote it.
    pub fn stamp(&self) -> Option<Stamp> {
        self.stamps[0]
    }

    /// Returns the current stamps of the scene file and of the CSV file with
    /// its spheres.
    fn stamps_now(&self) -> Stamps {
        [self.scene_file().and_then(|path| host().stamp(path)), csv_stamp(&self.saved)]
    }

    /// Returns the current stamps of the scene file and of its CSV file if either differs from the stored
    /// one; `None` if nothing has changed or the scene file has been missing. The contents are not compared.
    pub fn touched(&self) -> Option<Stamps> {
        let now = self.stamps_now();
        let was_there = now[0].is_some() || self.stamps[0].is_some();
        (was_there && now != self.stamps).then_some(now)
    }

    /// Returns true, once, if another program has removed the scene file.
    pub fn take_removal(&mut self) -> bool {
        let is_removed = self.stamps[0].is_some() && self.stamps_now()[0].is_none();
        if is_removed {
            self.stamps[0] = None;
        }
        is_removed
    }

    /// Returns the name of a file that another program has changed since it was read: the scene file or
    /// its CSV file. Returns `None` if neither has changed.
    pub fn changed_by_others(&mut self) -> Option<String> {
        if self.was_changed_by_others() {
            return Some(title_of(&self.origin));
        }
        let csv = self.saved.csv_spheres.as_ref()?;
        (csv_stamp(&self.saved) != self.stamps[1]).then(|| csv.path.clone())
    }

    /// Returns true if another program has changed the scene file's content since this window last read
    /// or wrote it. Stamps decide only if the file cannot be read: one may be made alike.
    pub fn was_changed_by_others(&mut self) -> bool {
        let [now, _] = self.stamps_now();
        let is_same = match self.text_on_disk() {
            Some(text) => self.text == Some(text),
            None => now.is_none() || now == self.stamps[0],
        };
        if is_same && now.is_some() {
            self.stamps[0] = now;
        }
        !is_same
    }

    /// Acknowledges the changes that another program made to the files, so that saving may overwrite them.
    pub fn keep_mine(&mut self) {
        self.stamps = self.stamps_now();
        self.text = self.text_on_disk().or(self.text.take());
    }

    fn text_on_disk(&self) -> Option<String> {
        limits::read_text(self.scene_file()?).ok()
    }

    /// Returns the files that the scene is read from: its own, and the CSV file with its spheres.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        let csv = self.document.csv_spheres.as_ref().map(|csv| csv.file.as_path());
        self.scene_file().into_iter().chain(csv)
    }

    /// Checks that an output does not overwrite a file that the scene is read from.
    ///
    /// # Errors
    /// Returns the reason, as a sentence.
    pub fn check_output(&self, path: &Path) -> Result<(), String> {
        if self.files().any(|read| host().is_same_file(read, path)) {
            let path = path.display();
            return Err(format!("The scene is read from {path}: choose another name."));
        }
        Ok(())
    }

    /// Returns true if `path` is the file that the scene was read from.
    pub fn is_own(&self, path: &Path) -> bool {
        self.scene_file().is_some_and(|file| host().is_same_file(file, path))
    }

    /// Returns a file name to suggest when the document is saved.
    pub fn file_name(&self) -> String {
        match &self.origin {
            Origin::Scene(SceneSource::Builtin(scene)) => format!("{}.toml", scene.name),
            Origin::Step(title) => {
                let words = title.split(|letter: char| !letter.is_alphanumeric());
                let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
                format!("{}.toml", words.join("-").to_lowercase())
            }
            file => title_of(file),
        }
    }

    /// Saves the document in `path`, which becomes its origin. Keeps the comments of the file that the
    /// document came from, even if `path` is another existing file.
    ///
    /// # Errors
    /// Returns the reason if the file could not be written; an existing file is then unchanged.
    pub fn save_to(&mut self, path: &Path) -> Result<(), String> {
        if !self.is_own(path) {
            self.check_output(path)?;
        }
        // The comments in the document's own file may have been edited since it was read.
        let on_disk = self.text_on_disk().filter(|_| self.is_own(path));
        let text = on_disk.as_deref().or(self.text.as_deref());
        let saved = scene_file::save(&self.document, path, text).map_err(|e| e.to_string())?;
        // Keep the document as written: its path to a CSV file is now relative to the scene's new
        // folder.
        self.document = saved.document;
        self.saved = self.document.clone();
        self.text = Some(saved.text);
        self.stamps[0] = host().stamp(path);
        self.origin = Origin::Scene(SceneSource::File(path.to_owned()));
        self.forgiving = false;
        Ok(())
    }
}

/// Moves a file to the front of the list of recent files.
pub fn remember(recent: &mut Vec<PathBuf>, path: &Path) {
    let path = absolute(path);
    recent.retain(|known| *known != path);
    recent.insert(0, path);
    recent.truncate(RECENT);
}

/// Returns true if a path is valid Unicode, so that it can be stored as text.
pub fn is_text(path: &Path) -> bool {
    path.to_str().is_some()
}

fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}
