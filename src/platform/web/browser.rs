//! The browser as the keeper of files: chosen and dropped files are in memory, a written file is a download,
//! and the program's own files are in the browser's storage.

use std::collections::BTreeMap;
use std::io::{Cursor, Read};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, SystemTime};

use pinhole_exchange::FileError;
use pinhole_exchange::host::{Host, Lock, Stamp};

use super::page;
use crate::model::recovery::Slot;

/// The folder of the program's own files, which are in the browser's storage.
const STORAGE: &str = "/browser";
/// The folder of unsaved changes.
const UNSAVED: &str = "/browser/unsaved";

/// Returns the path of a file that stores the program's state.
pub(super) fn state() -> PathBuf {
    Path::new(STORAGE).join("state.json")
}

/// Returns the keys of all files of unsaved changes and, in the same order, of their locks.
pub(super) fn slots() -> (Vec<String>, Vec<String>) {
    Slot::all_paths(Path::new(UNSAVED)).map(|[scene, lock]| (key(&scene), key(&lock))).unzip()
}

/// A file in memory.
struct MemoryFile {
    content: Vec<u8>,
    stamp: Stamp,
}

/// The browser.
#[derive(Default)]
pub(super) struct Browser;

/// The files in memory: those that the page contains, and those that the user chose, dropped or saved.
static FILES: Mutex<BTreeMap<PathBuf, MemoryFile>> = Mutex::new(BTreeMap::new());

fn files() -> MutexGuard<'static, BTreeMap<PathBuf, MemoryFile>> {
    FILES.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Puts a file into memory. Returns its path.
pub(super) fn add(name: &str, content: Vec<u8>) -> PathBuf {
    let stamp = Stamp { modified: Some(now()), length: content.len() as u64, change: None };
    let path = plain(Path::new(name));
    files().insert(path.clone(), MemoryFile { content, stamp });
    path
}

/// Returns true if a file belongs to the program: it is in the browser's storage.
fn is_own(path: &Path) -> bool {
    let endings = ["json", "lock", "toml"];
    path.starts_with(STORAGE)
        && path.extension().is_some_and(|own| endings.iter().any(|e| own == *e))
}

/// Returns the path of a file in memory: without the folder of unsaved changes, which name their tables as if
/// they stood beside them, and without `.` and `..`.
fn plain(path: &Path) -> PathBuf {
    pinhole_exchange::page::plain(path.strip_prefix(UNSAVED).unwrap_or(path))
}

fn key(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

fn now() -> SystemTime {
    SystemTime::UNIX_EPOCH + Duration::from_millis(page::now() as u64)
}

/// Returns a stored file's modification time and content. It is stored as the time, in milliseconds since
/// 1970, a line break, and the content.
fn stored(path: &Path) -> Option<(SystemTime, String)> {
    let mut text = page::stored(&key(path))?;
    let content = text.split_off(text.find('\n')? + 1);
    let time = SystemTime::UNIX_EPOCH + Duration::from_millis(text.trim_end().parse().ok()?);
    Some((time, content))
}

impl Host for Browser {
    fn open(&self, path: &Path) -> Result<Box<dyn Read>, FileError> {
        let found = if is_own(path) {
            stored(path).map(|(_, content)| content.into_bytes())
        } else {
            files().get(&plain(path)).map(|file| file.content.clone())
        };
        let found = found.map(|content| Box::new(Cursor::new(content)) as Box<dyn Read>);
        found.ok_or_else(|| {
            let problem = "is not in this page: drop it into the window, together with the file \
                           that names it";
            FileError::of_file(path, problem)
        })
    }

    fn write(&self, path: &Path, content: &[u8]) -> Result<(), FileError> {
        if is_own(path) {
            let time = page::now();
            let text = format!("{time:.0}\n{}", String::from_utf8_lossy(content));
            return match page::store(&key(path), &text) {
                None => Ok(()),
                Some(reason) => Err(FileError::of_file(Path::new("unsaved changes"), reason)),
            };
        }
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        page::download(&name, content);
        add(&name, content.to_vec());
        Ok(())
    }

    fn check(&self, _: &Path) -> Result<(), FileError> {
        Ok(())
    }

    fn make_folder(&self, _: &Path) -> Result<(), FileError> {
        Ok(())
    }

    fn remove(&self, path: &Path) {
        if is_own(path) {
            page::forget(&key(path));
        } else {
            files().remove(&plain(path));
        }
    }

    fn stamp(&self, path: &Path) -> Option<Stamp> {
        if !is_own(path) {
            return files().get(&plain(path)).map(|file| file.stamp);
        }
        let (modified, content) = stored(path)?;
        Some(Stamp { modified: Some(modified), length: content.len() as u64, change: None })
    }

    fn resolved(&self, path: &Path) -> Option<PathBuf> {
        Some(plain(path))
    }

    fn is_same_file(&self, a: &Path, b: &Path) -> bool {
        plain(a) == plain(b)
    }

    fn lock(&self, path: &Path) -> Result<Option<Lock>, FileError> {
        let name = key(path);
        Ok(page::lock(&name).then(|| Box::new(PageLock(name)) as Lock))
    }

    fn now(&self) -> SystemTime {
        now()
    }

    fn page(&self) -> Result<String, String> {
        Ok(page::source())
    }

    fn has_folders(&self) -> bool {
        false
    }
}

/// A lock among the pages of this browser.
struct PageLock(String);

impl Drop for PageLock {
    fn drop(&mut self) {
        page::unlock(&self.0);
    }
}
