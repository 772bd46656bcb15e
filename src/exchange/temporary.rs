//! Temporary files and folders: this run's, which are gone when it ends, and those that others have left.

use std::collections::BTreeSet;
use std::fs::{self, File, Permissions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, SystemTime};

use tempfile::{NamedTempFile, TempDir};

use crate::FileError;

/// The two ends of their names, and the number of letters and digits between: nobody gives such a name.
const PREFIX: &str = ".pinhole-";
const SUFFIX: &str = ".tmp";
const RANDOM: usize = 12;

/// Age from which a temporary file has no run any more that would finish it.
const ABANDONED: Duration = Duration::from_secs(3600);

/// Number of times that a folder is removed which is written to.
const TRIES: usize = 16;

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

/// A folder for files that are not finished, whose names are numbers. Dropped, it is gone.
#[derive(Debug)]
pub struct DraftFolder {
    folder: TempDir,
    _name: Known,
}

impl DraftFolder {
    /// Makes one in the folder where files beside this one will be.
    ///
    /// # Errors
    /// Returns an error if nothing can be written there.
    pub fn create_beside(path: &Path) -> Result<DraftFolder, FileError> {
        let folder = folder_of(path);
        clear_abandoned(folder);
        let mut live = live();
        let made = builder().tempdir_in(folder);
        let made = made.map_err(|error| FileError::unwritable(path, &error))?;
        live.insert(made.path().to_owned());
        let name = Known(made.path().to_owned());
        Ok(DraftFolder { folder: made, _name: name })
    }

    fn file(&self, number: usize) -> PathBuf {
        self.folder.path().join(number.to_string())
    }

    /// Writes the file of this number onto the disk.
    ///
    /// # Errors
    /// Returns an error if it cannot be written.
    pub fn write(&self, number: usize, content: &[u8]) -> io::Result<()> {
        let mut file = File::create(self.file(number))?;
        file.write_all(content)?;
        file.sync_all()
    }

    /// Gives its files names outside of it, in the order of their numbers from 0: all of them or none.
    ///
    /// # Errors
    /// Returns an error if one cannot get its name, or there is such a file.
    pub fn rename_all(&self, names: &[PathBuf]) -> Result<(), FileError> {
        let _live = live();
        for (number, name) in names.iter().enumerate() {
            let renamed = match fs::symlink_metadata(name) {
                Ok(_) => Err(io::ErrorKind::AlreadyExists.into()),
                Err(_) => fs::rename(self.file(number), name),
            };
            if let Err(error) = renamed {
                names[..number].iter().for_each(|name| drop(fs::remove_file(name)));
                return Err(FileError::unwritable(name, &error));
            }
        }
        names.first().into_iter().for_each(|name| sync(folder_of(name)));
        Ok(())
    }
}

/// Writes the names in a folder onto the disk. Not every system lets a folder be opened, and the files' content is
/// safe either way.
pub(crate) fn sync(folder: &Path) {
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
}

/// The temporary files and folders of this run.
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
        // Into a folder, somebody may write at the same time. What cannot be removed now, a later run
        // removes.
        let _ = (0..TRIES).find(|_| remove(path).is_ok() || !path.exists());
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
            let _ = remove(&entry.path());
        }
    }
}

fn is_ours(name: &std::ffi::OsStr) -> bool {
    let random = name.to_str().and_then(|name| name.strip_prefix(PREFIX)?.strip_suffix(SUFFIX));
    random.is_some_and(|random| {
        random.len() == RANDOM && random.bytes().all(|byte| byte.is_ascii_alphanumeric())
    })
}

/// Removes a file, or a folder with the files of a [`DraftFolder`]: whatever else is in it stays, and the
/// folder with it.
fn remove(path: &Path) -> io::Result<()> {
    if !fs::symlink_metadata(path)?.is_dir() {
        return fs::remove_file(path);
    }
    for entry in fs::read_dir(path)?.flatten() {
        let name = entry.file_name();
        if name.to_str().is_some_and(|name| name.bytes().all(|byte| byte.is_ascii_digit())) {
            fs::remove_file(entry.path())?;
        }
    }
    fs::remove_dir(path)
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
