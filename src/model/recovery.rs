//! Recovery of unsaved changes. They are written to a separate file as they are made, and the program
//! offers them at its next start.
//!
//! Each window has a numbered slot in a folder. A slot consists of a scene file, whose last line names the
//! source of the document, and a lock file. The system releases the lock however the window ends.

use std::path::{Path, PathBuf};
use std::time::Duration;

use pinhole_exchange::host::{Lock, Stamp, host};
use pinhole_exchange::{Document, FileError, SceneSource, limits, scene_file};
use serde::{Deserialize, Serialize};

use super::files::{OpenDocument, argument_of, title_of};

/// Maximum number of slots, each of which holds the unsaved changes of one window. Further windows do not
/// record theirs.
const SLOTS: usize = 64;

/// The beginning of the last line of a slot's scene file, a TOML comment. A [`ChangedScene`] as JSON
/// follows.
const SOURCE: &str = "\n# unsaved changes to: ";

/// A window's slot: its file for unsaved changes, and a lock that is held as long as this value lives.
pub struct Slot {
    scene: PathBuf,
    /// Keeps the lock.
    _lock: Lock,
}

/// Unsaved changes left in the slot of a window that ended without asking whether to save them.
pub struct Found {
    slot: Slot,
    /// The text of the scene file.
    text: Result<String, FileError>,
    source: ChangedScene,
    /// Time since the last change was written.
    pub age: Duration,
}

/// Unsaved changes that are to be written into a slot.
#[derive(Clone, Debug)]
pub struct Unsaved {
    document: Document,
    source: ChangedScene,
}

/// The scene that changes were made to.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
struct ChangedScene {
    /// The name of the scene.
    title: String,
    /// The command-line argument that opens the scene; `None` if there is none.
    argument: Option<PathBuf>,
    /// The stamp of the scene's file when the changes began.
    stamp: Option<Stamp>,
}

impl Unsaved {
    /// Copies the unsaved changes of the open document.
    pub fn of(open: &OpenDocument) -> Unsaved {
        let origin = open.origin();
        let document = open.own().into_owned();
        let source = ChangedScene {
            title: title_of(origin),
            argument: argument_of(origin),
            stamp: open.stamp(),
        };
        Unsaved { document, source }
    }

    /// Writes the changes into a slot, completely or not at all.
    ///
    /// # Errors
    /// Returns the reason if the file could not be written, or if the document could not be read back from
    /// the written text. The slot's previous content is then unchanged.
    pub fn write(&self, slot: &Slot) -> Result<(), String> {
        let text = self.text(slot)?;
        host().write(&slot.scene, text.as_bytes()).map_err(|error| error.to_string())
    }

    /// Returns the text that [`write`](Unsaved::write) writes into a slot.
    ///
    /// # Errors
    /// Returns the reason if the document could not be read back from the text.
    pub fn text(&self, slot: &Slot) -> Result<String, String> {
        let source = serde_json::to_string(&self.source).map_err(|error| error.to_string())?;
        let prepared = scene_file::prepare(&self.document, &slot.scene, None, true);
        Ok(prepared.map_err(|error| error.to_string())?.text + SOURCE + &source)
    }
}

impl Slot {
    /// Opens the slots in this folder. Returns a free slot, if there is one; the changes that ended windows
    /// left in other slots; and the first error if a slot could not be opened.
    pub fn open(folder: &Path) -> (Option<Slot>, Vec<Found>, Option<FileError>) {
        let (mut own, mut found, mut fault) = (None, Vec::new(), None);
        for number in 0..SLOTS {
            let is_there =
                |ending: &str| host().stamp(&folder.join(format!("{number}.{ending}"))).is_some();
            if own.is_some() && !is_there("toml") {
                // A system's slots follow one another; in a browser, any of them may have been left.
                if host().has_folders() && !is_there("lock") {
                    break;
                }
                continue;
            }
            match Slot::at(folder, number) {
                Ok(Some(slot)) if is_there("toml") => found.extend(Found::of(slot)),
                Ok(slot) => own = own.or(slot),
                Err(error) => fault = fault.or(Some(error)),
            }
        }
        found.sort_by_key(|found| found.age);
        (own, found, fault)
    }

    /// Returns the paths of all scene files in the folder, each with that of its lock.
    pub fn all_paths(folder: &Path) -> impl Iterator<Item = [PathBuf; 2]> {
        (0..SLOTS).map(|number| Slot::paths(folder, number))
    }

    fn paths(folder: &Path, number: usize) -> [PathBuf; 2] {
        ["toml", "lock"].map(|ending| folder.join(format!("{number}.{ending}")))
    }

    /// Locks the slot with this number. Returns `None` if another window has locked it.
    fn at(folder: &Path, number: usize) -> Result<Option<Slot>, FileError> {
        let [scene, lock] = Slot::paths(folder, number);
        host().make_folder(folder)?;
        Ok(host().lock(&lock)?.map(|lock| Slot { scene, _lock: lock }))
    }

    /// Deletes the recorded changes.
    pub fn clear(&self) {
        // If the file cannot be deleted, its changes are offered again.
        host().remove(&self.scene);
    }
}

impl Found {
    fn of(slot: Slot) -> Option<Found> {
        let written = host().stamp(&slot.scene)?.modified?;
        let age = host().now().duration_since(written).unwrap_or_default();
        // A slot has one line more than a scene.
        let mut text = limits::read_text_of(&slot.scene, limits::FOREIGN);
        let source = text.as_mut().ok().and_then(|text| {
            // The last line is cut off before the text is parsed: a name in it may contain characters that
            // are not allowed in a TOML comment.
            let line = text.split_off(text.rfind(SOURCE)?);
            serde_json::from_str(&line[SOURCE.len()..]).ok()
        });
        let unknown = || ChangedScene { title: "a scene".to_owned(), ..ChangedScene::default() };
        Some(Found { source: source.unwrap_or_else(unknown), age, slot, text })
    }

    /// Returns the title of the scene that was changed.
    pub fn title(&self) -> &str {
        &self.source.title
    }

    /// Returns the file of the scene that was changed; `None` if it did not come from a file.
    pub fn file(&self) -> Option<&Path> {
        self.source.argument.as_deref().filter(|argument| argument.is_absolute())
    }

    /// Returns the document with its changes, and the slot that holds the changes until they are saved. If
    /// `as_new` is true, the document belongs to no file, so that the scene's own file stays unchanged.
    ///
    /// # Errors
    /// Returns the reason if the changes cannot be read. They then stay in the slot.
    pub fn restore(self, as_new: bool) -> Result<(OpenDocument, Slot), String> {
        let (file, folder) = (&self.slot.scene, self.slot.scene.parent().unwrap_or(Path::new("")));
        let document = self.text.and_then(|text| scene_file::parse_draft(&text, file, folder));
        let document = document.map_err(|error| error.to_string())?;
        let ChangedScene { title, argument, stamp } = self.source;
        let open = if as_new {
            OpenDocument::unsaved(document, format!("{title}, unsaved"))
        } else {
            let source = argument.and_then(|path| SceneSource::from_argument(&path).ok());
            OpenDocument::changed(document, source, stamp)
        };
        Ok((open, self.slot))
    }

    /// Discards the recorded changes.
    pub fn discard(self) {
        self.slot.clear();
    }
}

/// Formats a duration in whole units of the largest one that fits twice, such as `3 minutes`.
pub fn in_words(age: Duration) -> String {
    let seconds = age.as_secs();
    let (count, unit) = match seconds {
        0..120 => (seconds, "second"),
        120..7200 => (seconds / 60, "minute"),
        7200..172_800 => (seconds / 3600, "hour"),
        _ => (seconds / 86_400, "day"),
    };
    format!("{count} {unit}{}", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use std::fs;

    use super::*;

    fn changed() -> Unsaved {
        let open = OpenDocument::changed(Document::default(), None, None);
        Unsaved::of(&open)
    }

    #[test]
    fn a_slot_belongs_to_one_window_until_it_ends() {
        let folder = tempfile::tempdir().unwrap();
        let (first, found, _) = Slot::open(folder.path());
        assert!(found.is_empty());
        let first = first.unwrap();
        changed().write(&first).unwrap();
        let (second, found, _) = Slot::open(folder.path());
        assert!(found.is_empty(), "its window is still open");
        changed().write(&second.unwrap()).unwrap();
        drop(first);
        let (_, found, _) = Slot::open(folder.path());
        assert_eq!(found.len(), 2);
        for found in found {
            let (open, slot) = found.restore(false).unwrap();
            assert_eq!(open.document, Document::default());
            slot.clear();
        }
        assert!(Slot::open(folder.path()).1.is_empty());
    }

    #[test]
    fn a_slot_that_cannot_be_opened_is_told() {
        let file = tempfile::NamedTempFile::new().unwrap();
        let (own, found, fault) = Slot::open(file.path());
        assert!(own.is_none() && found.is_empty());
        let message = fault.unwrap().to_string();
        assert!(message.starts_with(file.path().to_str().unwrap()), "{message}");
        assert!(message.contains(": cannot be written: "), "{message}");
    }

    /// Any name is possible on disk and in the line that records it.
    #[cfg(unix)]
    #[test]
    fn changes_to_a_file_of_any_name_are_found() {
        use std::os::unix::ffi::OsStrExt as _;

        for name in [&b"a\x7f\n.toml"[..], b"\xff.toml"] {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join(std::ffi::OsStr::from_bytes(name));
            let mut document = Document::default();
            scene_file::save(&document, &path, None).unwrap();
            document.camera.eye.x = 0.5;
            let source = Some(SceneSource::File(path.clone()));
            let open = OpenDocument::changed(document.clone(), source, None);
            let (slot, ..) = Slot::open(folder.path());
            Unsaved::of(&open).write(&slot.unwrap()).unwrap();
            let (_, mut found, _) = Slot::open(folder.path());
            let found = found.remove(0);
            assert_eq!(found.title(), title_of(open.origin()));
            assert_eq!(found.file(), path.to_str().map(Path::new));
            assert_eq!(found.restore(false).unwrap().0.document, document);
        }
    }

    #[test]
    fn a_scene_without_its_last_line_is_restored() {
        let folder = tempfile::tempdir().unwrap();
        let (slot, ..) = Slot::open(folder.path());
        let scene = scene_file::to_text(&Document::default(), None);
        fs::write(slot.unwrap().scene, scene).unwrap();
        let (_, mut found, _) = Slot::open(folder.path());
        let found = found.remove(0);
        assert_eq!(found.title(), "a scene");
        assert_eq!(found.restore(false).unwrap().0.document, Document::default());
    }

    #[test]
    fn ages_are_told_in_words() {
        for (seconds, words) in [
            (0, "0 seconds"),
            (1, "1 second"),
            (59, "59 seconds"),
            (110, "110 seconds"),
            (120, "2 minutes"),
            (7200, "2 hours"),
            (172_800, "2 days"),
        ] {
            assert_eq!(in_words(Duration::from_secs(seconds)), words);
        }
    }
}
