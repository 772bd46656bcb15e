//! Unsaved changes, written aside while they are made, for the next start to offer them.
//!
//! Each window has a numbered slot in a folder: a scene file, what it was made from, and a lock that
//! the system releases however the window ends.

use std::fs::{self, File, TryLockError};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use pinhole_core::DVec3;
use pinhole_exchange::document::Document;
use pinhole_exchange::scenes::SceneSource;
use pinhole_exchange::{atomic, scene_file};
use serde::{Deserialize, Serialize};

use super::files::{OpenDocument, Stamp, argument_of, title_of};

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
    source: Source,
    /// Time that has passed since the last change was written.
    pub age: Duration,
}

/// Changes to be written aside.
#[derive(Clone, Debug)]
pub struct Unsaved {
    document: Document,
    source: Source,
}

/// What changes were made to.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
struct Source {
    /// The name of the scene.
    title: String,
    /// The scene in the command line's notation.
    argument: Option<PathBuf>,
    /// The state of its file when the changes began.
    stamp: Option<Stamp>,
    /// Numbers of the document that no scene file may have.
    faults: Faults,
}

/// Numbers at fault that somebody is about to type over, or is shown the reason for.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
struct Faults {
    /// Width, height and distance of the viewport.
    viewport: Option<[f64; 3]>,
    /// Indices of spheres, and their radii.
    radii: Vec<(usize, f64)>,
    /// Indices of planes whose normal is zero.
    normals: Vec<usize>,
}

impl Faults {
    /// Takes them out of a document; others are there instead.
    fn take(document: &mut Document) -> Faults {
        let mut faults = Faults::default();
        let viewport = &mut document.camera.viewport;
        let numbers = [viewport.width, viewport.height, viewport.distance];
        if numbers.iter().any(|number| *number <= 0.0) {
            faults.viewport = Some(numbers);
            (viewport.width, viewport.height, viewport.distance) = (1.0, 1.0, 1.0);
        }
        let spheres = document.spheres.iter().enumerate();
        let radii = spheres.map(|(index, sphere)| (index, sphere.shape.radius));
        faults.radii = radii.filter(|(_, radius)| *radius <= 0.0).collect();
        for (index, _) in &faults.radii {
            document.spheres[*index].shape.radius = 1.0;
        }
        let planes = document.planes.iter().enumerate();
        let normals = planes.filter(|(_, plane)| plane.shape.normal == DVec3::ZERO);
        faults.normals = normals.map(|(index, _)| index).collect();
        for index in &faults.normals {
            document.planes[*index].shape.normal = DVec3::Y;
        }
        faults
    }

    /// Puts them back.
    fn put_into(&self, document: &mut Document) {
        if let Some([width, height, distance]) = self.viewport {
            let viewport = &mut document.camera.viewport;
            (viewport.width, viewport.height, viewport.distance) = (width, height, distance);
        }
        for (index, radius) in &self.radii {
            if let Some(sphere) = document.spheres.get_mut(*index) {
                sphere.shape.radius = *radius;
            }
        }
        for index in &self.normals {
            if let Some(plane) = document.planes.get_mut(*index) {
                plane.shape.normal = DVec3::ZERO;
            }
        }
    }
}

impl Unsaved {
    /// Takes the changes of the open document.
    pub fn of(open: &OpenDocument) -> Unsaved {
        let origin = open.origin();
        let mut document = open.document.clone();
        let source = Source {
            title: title_of(origin),
            argument: argument_of(origin),
            stamp: open.stamp(),
            faults: Faults::take(&mut document),
        };
        Unsaved { document, source }
    }

    /// Writes the changes into a slot; each of its two files completely or not at all.
    ///
    /// # Errors
    /// Returns the reason if a file could not be written, or the document could not be read back from
    /// it; what was there before then stays.
    pub fn write(&self, slot: &Slot) -> Result<(), String> {
        let source = serde_json::to_vec(&self.source).map_err(|error| error.to_string())?;
        atomic::write(&slot.source, |file| file.write_all(&source))
            .map_err(|error| error.to_string())?;
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
            if !is_known && own.is_some() {
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
            Ok(()) => Some(Slot { scene: path("toml"), source: path("json"), _lock: lock }),
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
        let source = fs::read(&slot.source).unwrap_or_default();
        let source = serde_json::from_slice(&source);
        let unknown = || Source { title: "a scene".to_owned(), ..Source::default() };
        Some(Found { source: source.unwrap_or_else(|_| unknown()), age, slot })
    }

    /// Returns the name of the scene that was changed.
    pub fn title(&self) -> &str {
        &self.source.title
    }

    /// Returns the file of the scene that was changed, if it has one.
    pub fn file(&self) -> Option<&Path> {
        self.source.argument.as_deref().filter(|argument| argument.is_absolute())
    }

    /// Returns the document with its changes, and the slot that holds them until they are written
    /// elsewhere. `beside` leaves the scene that was changed alone: the document is in no file.
    ///
    /// # Errors
    /// Returns the reason if it cannot be read; it is then kept.
    pub fn restore(self, beside: bool) -> Result<(OpenDocument, Slot), String> {
        let mut document = scene_file::load(&self.slot.scene).map_err(|error| error.to_string())?;
        let Source { title, argument, stamp, faults } = self.source;
        faults.put_into(&mut document);
        let open = if beside {
            OpenDocument::unsaved(document, format!("{title}, unsaved"))
        } else {
            let source = argument.and_then(|path| SceneSource::from_argument(&path).ok());
            OpenDocument::changed(document, source, stamp)
        };
        Ok((open, self.slot))
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
        let open = OpenDocument::changed(Document::default(), None, None);
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
            let (open, slot) = found.restore(false).unwrap();
            assert_eq!(open.document, Document::default());
            slot.clear();
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
