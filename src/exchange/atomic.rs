//! Writes files in such a way that a crash, a signal or a full disk leaves existing files intact.
//!
//! A file is written without a name, which it gets when it is complete: first a temporary one, and at once the
//! old file's. However the program ends, the system removes a file without a name. Where there are no such files
//! (network folders, memory sticks, systems other than Linux), the file has its temporary name from the start. A
//! run of the program removes its temporary names when it ends; a later run removes those of runs that were killed.

use std::collections::BTreeSet;
use std::fs::{self, File, Metadata, TryLockError};
use std::io::{self, Seek};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, SystemTime};

use tempfile::{NamedTempFile, TempPath};

use crate::{FileError, windows_names};

/// Writes a file completely or not at all.
///
/// `content` writes to a temporary file in the same directory, which replaces the old file only after
/// it has reached the disk. An existing file keeps its permissions, and a symbolic link is followed,
/// not replaced. If the path is a device or a pipe, the finished content is copied to it.
///
/// # Errors
/// Returns an error if `content` or the system fails, or if the file is read-only. Nothing has changed
/// then.
pub fn write(
    path: &Path,
    content: impl FnOnce(&mut File) -> io::Result<()>,
) -> Result<(), FileError> {
    let mut batch = Batch::default();
    batch.add(path, content)?;
    batch.finish()
}

/// Several files that are written together. All of them are complete and on the disk before the first one is put
/// in place. If the batch is dropped before it is finished, or an error is returned, none has changed; but a file
/// that was replaced before the error stays new where the system has no hard links, as on a memory stick.
///
/// No file is ever half written. But files are put in place one after the other: if the program is killed or
/// power fails between them, some are new and the others old.
#[derive(Debug, Default)]
pub struct Batch {
    /// Files that are not in place yet.
    files: Vec<Pending>,
    /// The contents to be copied to devices and pipes, which cannot be replaced by a file.
    through: Vec<(PathBuf, File)>,
}

#[derive(Debug)]
struct Pending {
    file: File,
    /// The file's temporary name; `None` if it has no name.
    name: Option<TempPath>,
    target: PathBuf,
    old: Option<Metadata>,
    /// The path as it was given, for messages.
    path: PathBuf,
}

impl Batch {
    /// Writes a file's content. The file gets its final name when the batch is finished. After an error, it is no
    /// part of the batch.
    ///
    /// # Errors
    /// Returns the errors of [`write()`].
    pub fn add(
        &mut self,
        path: &Path,
        content: impl FnOnce(&mut File) -> io::Result<()>,
    ) -> Result<(), FileError> {
        let known = [self.files.len(), self.through.len()];
        let mut file = self.create(path)?;
        content(&mut file).map_err(|error| {
            self.files.truncate(known[0]);
            self.through.truncate(known[1]);
            FileError::unwritable(path, &error)
        })
    }

    /// Creates a file, whose content must be written before the batch is finished.
    ///
    /// # Errors
    /// Returns an error if the system fails, or if the file is read-only.
    pub fn create(&mut self, path: &Path) -> Result<File, FileError> {
        self.try_create(path).map_err(|error| FileError::unwritable(path, &error))
    }

    fn try_create(&mut self, path: &Path) -> io::Result<File> {
        let (target, old) = target_of(path)?;
        if old.as_ref().is_some_and(|old| !old.is_file()) {
            let buffer = tempfile::tempfile()?;
            let file = buffer.try_clone();
            self.through.push((target, buffer));
            return file;
        }
        let (file, name) = new_file(folder_of(&target))?;
        let same = file.try_clone();
        self.files.push(Pending { file, name, target, old, path: path.to_owned() });
        same
    }

    /// Gives all files their final names.
    ///
    /// # Errors
    /// Returns an error if a file cannot reach the disk or be given its final name. All files are then as they
    /// were before, see [`Batch`].
    pub fn finish(self) -> Result<(), FileError> {
        for Pending { file, old, path, .. } in &self.files {
            let permitted =
                old.as_ref().map_or(Ok(()), |old| file.set_permissions(old.permissions()));
            permitted
                .and_then(|()| file.sync_all())
                .map_err(|error| FileError::unwritable(path, &error))?;
        }
        for (target, buffer) in self.through {
            write_through(&target, buffer)
                .map_err(|error| FileError::unwritable(&target, &error))?;
        }
        let folders: BTreeSet<PathBuf> =
            self.files.iter().map(|file| folder_of(&file.target).to_owned()).collect();
        place(self.files)?;
        folders.iter().for_each(|folder| sync(folder));
        Ok(())
    }
}

/// Gives the files temporary names, unless they have them, and renames them to their final ones. If one of these
/// steps fails, all are undone. Meanwhile, [`abandon`] blocks.
fn place(files: Vec<Pending>) -> Result<(), FileError> {
    let is_alone = files.len() == 1;
    let mut live = live();
    let with_name = |Pending { file, name, target, old, path }| {
        let link = |name: &Path| nameless::link(&file, name);
        let linked = || match builder().make_in(folder_of(&target), link) {
            Ok(linked) => Ok(linked.into_temp_path()),
            // A sandbox may refuse to name it.
            Err(_) => copied(&file, folder_of(&target)),
        };
        match name.map_or_else(linked, Ok) {
            Ok(name) => Ok((file, name, target, old.is_some(), path)),
            Err(error) => Err(FileError::unwritable(&path, &error)),
        }
    };
    let files: Vec<_> = files.into_iter().map(with_name).collect::<Result<_, FileError>>()?;
    let mut placed: Vec<(PathBuf, bool, Option<NamedTempFile<()>>)> = Vec::new();
    for (file, name, target, is_there, path) in files {
        // A second hard link to the old file, from which it can be restored.
        let link = |name: &Path| fs::hard_link(&target, name);
        let second = (is_there && !is_alone).then(|| builder().make_in(folder_of(&target), link));
        live.remove(&*name);
        // On Windows, nobody else could read a locked file.
        let _ = file.unlock();
        if let Err(error) = name.persist(&target) {
            placed.into_iter().for_each(take_back);
            return Err(FileError::unwritable(&path, &error.error));
        }
        placed.push((target, is_there, second.and_then(Result::ok)));
    }
    Ok(())
}

/// Copies a file to one with a temporary name.
fn copied(mut file: &File, folder: &Path) -> io::Result<TempPath> {
    let mut copy = builder().tempfile_in(folder)?;
    file.rewind()?;
    io::copy(&mut file, &mut copy)?;
    copy.as_file().set_permissions(file.metadata()?.permissions())?;
    copy.as_file().sync_all()?;
    Ok(copy.into_temp_path())
}

/// Undoes a rename: restores the old file, or removes the new one if there was none. If the file system
/// has no hard links, an old file cannot be restored, and the new one stays.
fn take_back((target, was_there, old): (PathBuf, bool, Option<NamedTempFile<()>>)) {
    // The error that led here has already been reported.
    match old {
        Some(old) => drop(old.persist(target)),
        None if !was_there => drop(fs::remove_file(target)),
        None => {}
    }
}

/// Checks that [`write()`] can write to this path, before a long computation. Since nothing is written,
/// it may still fail later because the disk is full or the folder is not writable.
///
/// # Errors
/// Returns an error if the path is a folder, lies in a folder that does not exist, or is read-only.
pub fn check(path: &Path) -> Result<(), FileError> {
    let check = || fs::metadata(folder_of(&target_of(path)?.0)).map(drop);
    check().map_err(|error| FileError::unwritable(path, &error))
}

/// Returns the path of the file that will be written, after following links, and the metadata of the
/// existing file there, if there is one.
fn target_of(path: &Path) -> io::Result<(PathBuf, Option<Metadata>)> {
    if let Some(reason) = windows_names::refusal(path).filter(|_| cfg!(windows)) {
        return Err(io::Error::other(reason));
    }
    // The link of a pipe, such as /dev/stdout, does not lead to a file name.
    let is_device = |data: &Metadata| !data.is_file() && !data.is_dir();
    if let Some(device) = fs::metadata(path).ok().filter(is_device) {
        return Ok((path.to_owned(), Some(device)));
    }
    let target = follow_links(path)?;
    let old = match fs::metadata(&target) {
        Ok(metadata) => metadata,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok((target, None)),
        Err(error) => return Err(error),
    };
    if old.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    if old.is_file() && old.permissions().readonly() {
        return Err(io::Error::other("the file is read-only"));
    }
    Ok((target, Some(old)))
}

/// Copies the content to a device or a pipe, which cannot be replaced by a file.
fn write_through(target: &Path, mut content: File) -> io::Result<()> {
    content.rewind()?;
    let mut device = File::options().write(true).open(target)?;
    io::copy(&mut content, &mut device).map(drop)
}

/// Returns the file to which a path refers after following all links, even if that file does not exist
/// yet.
fn follow_links(path: &Path) -> io::Result<PathBuf> {
    const MOST_LINKS: usize = 40;
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::symlink_metadata(&target) {
            Ok(metadata) if metadata.is_symlink() => {
                let link = fs::read_link(&target)?;
                target = target.parent().map_or(link.clone(), |parent| parent.join(link));
            }
            _ => return Ok(target),
        }
    }
    Err(io::Error::other("too many symbolic links"))
}

/// Returns true if the two paths refer to the same file, possibly through links. The file need not
/// exist yet. Devices and pipes never count as the same file.
pub fn is_same_file(a: &Path, b: &Path) -> bool {
    identity(a).is_some_and(|a| identity(b) == Some(a))
}

#[derive(PartialEq, Eq)]
enum Identity {
    #[cfg(unix)]
    Inode(u64, u64),
    Path(PathBuf),
}

fn identity(path: &Path) -> Option<Identity> {
    let target = follow_links(path).ok()?;
    match fs::metadata(&target) {
        Ok(data) if !data.is_file() => None,
        #[cfg(unix)]
        Ok(data) => {
            use std::os::unix::fs::MetadataExt as _;
            Some(Identity::Inode(data.dev(), data.ino()))
        }
        #[cfg(not(unix))]
        Ok(_) => target.canonicalize().ok().map(Identity::Path),
        Err(_) => {
            let folder = folder_of(&target).canonicalize().ok()?;
            Some(Identity::Path(folder.join(target.file_name()?)))
        }
    }
}

/// The prefix of the names of temporary files, which users are unlikely to give their own files.
const PREFIX: &str = ".pinhole-";
/// The suffix of the names of temporary files.
const SUFFIX: &str = ".tmp";
/// The number of random letters and digits between the prefix and the suffix.
const RANDOM: usize = 12;

/// Age from which a temporary file is considered abandoned by a run that was killed.
const ABANDONED: Duration = Duration::from_secs(3600);

/// Creates a file without a name or, where that is not possible, with a temporary one, which is in [`LIVE`].
fn new_file(folder: &Path) -> io::Result<(File, Option<TempPath>)> {
    clear_abandoned(folder);
    let (file, name) = match nameless::create(folder) {
        Some(file) => (file, None),
        None => {
            let mut live = live();
            let (file, name) = builder().tempfile_in(folder)?.into_parts();
            live.insert(name.to_path_buf());
            (file, Some(name))
        }
    };
    // Tells other runs that this one lives, where the folder's system has locks.
    let _ = file.try_lock();
    Ok((file, name))
}

/// Files without a name.
#[cfg(target_os = "linux")]
mod nameless {
    use std::os::fd::AsRawFd as _;

    use rustix::fs::{AtFlags, CWD, Mode, OFlags, linkat, open};

    use super::{File, Path, PathBuf, io};

    /// Returns the path by which the system knows an open file that has no name.
    fn itself(file: &File) -> PathBuf {
        Path::new("/proc/self/fd").join(file.as_raw_fd().to_string())
    }

    /// Creates a file. Returns `None` if the folder's system has no files without a name, or could not give it
    /// one later.
    pub(super) fn create(folder: &Path) -> Option<File> {
        let flags = OFlags::TMPFILE | OFlags::RDWR | OFlags::CLOEXEC;
        // The usual permissions of a new file, before the umask is applied.
        let file = File::from(open(folder, flags, Mode::from_raw_mode(0o666)).ok()?);
        itself(&file).exists().then_some(file)
    }

    /// Gives the file a name.
    pub(super) fn link(file: &File, name: &Path) -> io::Result<()> {
        Ok(linkat(CWD, itself(file), CWD, name, AtFlags::SYMLINK_FOLLOW)?)
    }
}

/// Replaces the module `nameless` where every file has a name.
#[cfg(not(target_os = "linux"))]
mod nameless {
    use super::{File, Path, io};

    pub(super) fn create(_: &Path) -> Option<File> {
        None
    }

    pub(super) fn link(_: &File, _: &Path) -> io::Result<()> {
        Err(io::ErrorKind::Unsupported.into())
    }
}

/// Flushes a folder's directory entries to the disk. Errors are ignored: some systems do not allow
/// opening a folder, and the contents of the files are safe either way.
fn sync(folder: &Path) {
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
}

/// The temporary names of this run's files. Some may be gone.
static LIVE: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Locks [`LIVE`], the list of temporary names. While the lock is held, no other thread gives a file a name.
fn live() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    LIVE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes all temporary files of this run, which is about to end. If a [`Batch`] is being renamed,
/// that is completed first. Afterwards, threads that write files block forever, so that no file can be
/// created any more.
pub fn abandon() {
    let live = live();
    for path in live.iter() {
        // A later run removes the file if it cannot be removed now.
        let _ = fs::remove_file(path);
    }
    std::mem::forget(live);
}

/// Removes the temporary files that killed runs left in this folder. Each run does this once per folder.
fn clear_abandoned(folder: &Path) {
    static SEEN: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    if !SEEN.lock().unwrap_or_else(PoisonError::into_inner).insert(folder.to_owned()) {
        return;
    }
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten().filter(|entry| is_ours(&entry.file_name())) {
        // A pipe of such a name would never let itself be opened.
        let data = entry.metadata().ok().filter(Metadata::is_file);
        let written = data.and_then(|data| data.modified().ok());
        let age = written.map(|time| SystemTime::now().duration_since(time).unwrap_or_default());
        let path = entry.path();
        let is_old = age.is_some_and(|age| age > ABANDONED);
        if is_old && !live().contains(&path) && !is_locked(&path) {
            // A file that cannot be removed belongs to somebody else.
            let _ = fs::remove_file(path);
        }
    }
}

/// Returns true if a run that lives has locked this file.
fn is_locked(path: &Path) -> bool {
    let lock = File::options().write(true).open(path).map(|file| file.try_lock());
    matches!(lock, Ok(Err(TryLockError::WouldBlock)))
}

fn is_ours(name: &std::ffi::OsStr) -> bool {
    let random = name.to_str().and_then(|name| name.strip_prefix(PREFIX)?.strip_suffix(SUFFIX));
    random.is_some_and(|random| {
        random.len() == RANDOM && random.bytes().all(|byte| byte.is_ascii_alphanumeric())
    })
}

fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX).rand_bytes(RANDOM);
    // The usual permissions of a new file, before the umask is applied. By default, the crate
    // `tempfile` gives permissions only to the owner.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder
}

/// Returns the folder that contains a file.
pub(crate) fn folder_of(target: &Path) -> &Path {
    match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}
