//! Temporary files: this run's, which are gone when it ends, and those that others have left.

use std::collections::BTreeSet;
use std::fs::{self, File, Permissions};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, SystemTime};

use tempfile::NamedTempFile;

/// The two ends of their names, and the number of letters and digits between: nobody gives such a name.
const PREFIX: &str = ".pinhole-";
const SUFFIX: &str = ".tmp";
const RANDOM: usize = 12;

/// Age from which a temporary file has no run any more that would finish it.
const ABANDONED: Duration = Duration::from_secs(3600);

/// A temporary file, known to [`abandon`].
#[derive(Debug)]
pub(crate) struct Temporary {
    pub(crate) file: NamedTempFile,
    pub(crate) name: Known,
}

impl Temporary {
    /// Makes one in this folder.
    pub(crate) fn in_folder(folder: &Path) -> io::Result<Temporary> {
        clear_abandoned(folder);
        let mut builder = builder();
        if let Some(permissions) = default_permissions() {
            builder.permissions(permissions);
        }
        let mut live = live();
        let file = builder.tempfile_in(folder)?;
        live.insert(file.path().to_owned());
        let name = Known(file.path().to_owned());
        Ok(Temporary { file, name })
    }
}

/// Writes the names in a folder onto the disk. Not every system lets a folder be opened, and the files' content is
/// safe either way.
pub(crate) fn sync(folder: &Path) {
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
}

/// The temporary files of this run.
static LIVE: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Nothing begins, is given its name or is removed while this is held.
pub(crate) fn live() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    LIVE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The name of a temporary file, in the list of this run's.
#[derive(Debug)]
pub(crate) struct Known(PathBuf);

impl Drop for Known {
    fn drop(&mut self) {
        live().remove(&self.0);
    }
}

/// Removes the temporary files of this run, which is about to end: nothing is finished after this, and
/// who writes waits forever. Files that are being given their names all get them first.
pub fn abandon() {
    let live = live();
    for path in live.iter() {
        // What cannot be removed now, a later run removes.
        let _ = fs::remove_file(path);
    }
    std::mem::forget(live);
}

/// Removes what runs that were killed have left in this folder. Looks once in a run.
fn clear_abandoned(folder: &Path) {
    static SEEN: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    if !SEEN.lock().unwrap_or_else(PoisonError::into_inner).insert(folder.to_owned()) {
        return;
    }
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten().filter(|entry| is_ours(&entry.file_name())) {
        let written = entry.metadata().and_then(|data| data.modified());
        let age = written.map(|time| SystemTime::now().duration_since(time).unwrap_or_default());
        if age.is_ok_and(|age| age > ABANDONED) && !live().contains(&entry.path()) {
            // What cannot be removed is not ours.
            let _ = fs::remove_file(entry.path());
        }
    }
}

fn is_ours(name: &std::ffi::OsStr) -> bool {
    let random = name.to_str().and_then(|name| name.strip_prefix(PREFIX)?.strip_suffix(SUFFIX));
    random.is_some_and(|random| {
        random.len() == RANDOM && random.bytes().all(|byte| byte.is_ascii_alphanumeric())
    })
}

pub(crate) fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX).rand_bytes(RANDOM);
    builder
}

/// Permissions that a new file gets from the system, less the user's mask; a temporary file
/// would be its owner's alone.
#[cfg(unix)]
fn default_permissions() -> Option<Permissions> {
    use std::os::unix::fs::PermissionsExt;
    Some(Permissions::from_mode(0o666))
}

#[cfg(not(unix))]
fn default_permissions() -> Option<Permissions> {
    None
}

/// The folder that a file lies in.
pub(crate) fn folder_of(target: &Path) -> &Path {
    match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}
