//! Unsaved changes, written aside while they are made, for the next start to offer them.
//!
//! Each window has a numbered slot in a folder: a scene file, what it was made from, and a lock that
//! the system releases however the window ends.

use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use pinhole_exchange::document::Document;
use pinhole_exchange::scene_file;
use pinhole_exchange::scenes::SceneSource;

use super::files::{OpenDocument, argument_of, title_of};

/// Maximum number of slots; windows beyond them write nothing aside.
const SLOTS: usize = 64;

/// A window's slot, locked as long as this value lives.
#[derive(Debug)]
pub struct Slot {
    scene: PathBuf,
    source: PathBuf,
    /// Keeps the lock.
    _lock: File,
}

/// Unsaved changes of a window that ended without being asked.
#[derive(Debug)]
pub struct Found {
    slot: Slot,
    /// Name of the scene that was changed.
    pub title: String,
    /// Time that has passed since the last change was written.
    pub age: Duration,
}

/// Changes to be written aside.
#[derive(Clone, Debug)]
pub struct Unsaved {
    document: Document,
    title: String,
    argument: Option<PathBuf>,
}

impl Unsaved {
    /// Takes the changes of the open document.
    pub fn of(open: &OpenDocument) -> Unsaved {
        let origin = open.origin();
        Unsaved {
            document: open.document.clone(),
            title: title_of(origin),
            argument: argument_of(origin),
        }
    }

    /// Writes the changes into a slot, completely or not at all.
    ///
    /// # Errors
    /// Returns the reason if a file could not be written, or the document could not be read back from
    /// it; what was there before then stays.
    pub fn write(&self, slot: &Slot) -> Result<(), String> {
        let argument = self.argument.as_deref().and_then(Path::to_str).unwrap_or_default();
        let source = format!("{}\n{argument}\n", self.title);
        fs::write(&slot.source, source).map_err(|error| error.to_string())?;
        let saved = scene_file::save_over(&self.document, &slot.scene, None);
        saved.map(drop).map_err(|error| error.to_string())
    }
}

impl Slot {
    /// Returns a free slot in this folder, if there is one, and what ended windows have left in others.
    pub fn open(folder: &Path) -> (Option<Slot>, Vec<Found>) {
        let (mut own, mut found) = (None, Vec::new());
        for number in 0..SLOTS {
            let is_known = folder.join(format!("{number}.lock")).exists();
            match Slot::at(folder, number) {
                Some(slot) if slot.scene.exists() => found.extend(Found::of(slot)),
                Some(slot) => own = own.or(Some(slot)),
                None => {}
            }
            if !is_known {
                break;
            }
        }
        found.sort_by_key(|found| found.age);
        (own, found)
    }

    /// Locks a slot, unless another window has it.
    fn at(folder: &Path, number: usize) -> Option<Slot> {
        let path = |ending: &str| folder.join(format!("{number}.{ending}"));
        fs::create_dir_all(folder).ok()?;
        let options = File::options().create(true).write(true).truncate(false).open(path("lock"));
        let lock = options.ok()?;
        match lock.try_lock() {
            Ok(()) => Some(Slot { scene: path("toml"), source: path("source"), _lock: lock }),
            Err(TryLockError::WouldBlock | TryLockError::Error(_)) => None,
        }
    }

    /// Removes what was written.
    pub fn clear(&self) {
        // What is not there needs no removing; what cannot be removed is offered once more.
        let _ = fs::remove_file(&self.scene);
        let _ = fs::remove_file(&self.source);
    }
}

impl Found {
    fn of(slot: Slot) -> Option<Found> {
        let written = fs::metadata(&slot.scene).and_then(|data| data.modified()).ok()?;
        let age = SystemTime::now().duration_since(written).unwrap_or_default();
        let source = fs::read_to_string(&slot.source).unwrap_or_default();
        let title = source.lines().next().filter(|title| !title.is_empty());
        Some(Found { title: title.unwrap_or("a scene").to_owned(), age, slot })
    }

    /// Returns the document with its changes, and forgets what was written.
    ///
    /// # Errors
    /// Returns the reason if it cannot be read; it is then kept.
    pub fn restore(self) -> Result<OpenDocument, String> {
        let document = scene_file::load(&self.slot.scene).map_err(|error| error.to_string())?;
        let source = fs::read_to_string(&self.slot.source).unwrap_or_default();
        let argument = source.lines().nth(1).filter(|argument| !argument.is_empty());
        let source = argument.and_then(|path| SceneSource::from_argument(Path::new(path)).ok());
        self.slot.clear();
        Ok(OpenDocument::changed(document, source))
    }

    /// Forgets what was written.
    pub fn discard(self) {
        self.slot.clear();
    }
}

/// Returns a duration in the largest unit that it fills, such as `3 minutes`.
pub fn in_words(age: Duration) -> String {
    let seconds = age.as_secs();
    let (count, unit) = match seconds {
        0..60 => (seconds, "second"),
        60..3600 => (seconds / 60, "minute"),
        3600..86_400 => (seconds / 3600, "hour"),
        _ => (seconds / 86_400, "day"),
    };
    format!("{count} {unit}{}", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;

    fn changed() -> Unsaved {
        let open = OpenDocument::changed(Document::default(), None);
        Unsaved::of(&open)
    }

    #[test]
    fn a_slot_belongs_to_one_window_until_it_ends() {
        let folder = tempfile::tempdir().unwrap();
        let (first, found) = Slot::open(folder.path());
        assert!(found.is_empty());
        let first = first.unwrap();
        changed().write(&first).unwrap();
        let (second, found) = Slot::open(folder.path());
        assert!(found.is_empty(), "its window is still open");
        changed().write(&second.unwrap()).unwrap();
        drop(first);
        let (_, found) = Slot::open(folder.path());
        assert_eq!(found.len(), 2);
        for found in found {
            assert_eq!(found.restore().unwrap().document, Document::default());
        }
        assert!(Slot::open(folder.path()).1.is_empty());
    }

    #[test]
    fn ages_are_told_in_words() {
        for (seconds, words) in [
            (0, "0 seconds"),
            (1, "1 second"),
            (59, "59 seconds"),
            (60, "1 minute"),
            (7200, "2 hours"),
            (90_000, "1 day"),
        ] {
            assert_eq!(in_words(Duration::from_secs(seconds)), words);
        }
    }
}
