//! Writing a file so that a crash or a full disk leaves the old one.

use std::fs::{self, File, Metadata, Permissions};
use std::io::{self, Seek};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::FileError;

/// Writes a file as a whole or not at all.
///
/// `content` writes to a temporary file in the same directory, which takes the place of the old one
/// only after it has reached the disk. An existing file keeps its permissions, and a symbolic link
/// keeps pointing where it did. A device or pipe, which cannot be replaced, gets the finished
/// content.
///
/// # Errors
/// Returns an error if the content or the system fails, or the file is marked as read-only; then
/// nothing has changed.
pub fn write(
    path: &Path,
    content: impl FnOnce(&mut File) -> io::Result<()>,
) -> Result<(), FileError> {
    replace(path, content).map_err(|error| FileError::unwritable(path, &error))
}

/// Checks that [`write()`] has a place to write to, for those with long work before it. Nothing is
/// written, so the disk may still turn out to be full, or the folder not ours to write in.
///
/// # Errors
/// Returns an error if the path is a folder, lies in a folder that does not exist, or is marked as
/// read-only.
pub fn check(path: &Path) -> Result<(), FileError> {
    let check = || fs::metadata(folder_of(&target_of(path)?.0)).map(drop);
    check().map_err(|error| FileError::unwritable(path, &error))
}

/// The file that is to be written, and what is there now, which may be replaced.
fn target_of(path: &Path) -> io::Result<(PathBuf, Option<Metadata>)> {
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

fn folder_of(target: &Path) -> &Path {
    match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// A file that is written bit by bit, and takes its place only as a whole.
#[derive(Debug)]
pub struct Draft {
    new: NamedTempFile,
    path: PathBuf,
}

impl Draft {
    /// Begins one, in the folder of the file that it becomes. Dropped, it leaves nothing.
    ///
    /// # Errors
    /// Returns an error if nothing can be written there.
    pub fn create(path: &Path) -> Result<Draft, FileError> {
        let new = target_of(path).and_then(|(target, _)| temporary_in(folder_of(&target)));
        let new = new.map_err(|error| FileError::unwritable(path, &error))?;
        Ok(Draft { new, path: path.to_owned() })
    }

    /// Returns the file as written so far, to write on.
    ///
    /// # Errors
    /// Returns an error if the system cannot open another file.
    pub fn file(&self) -> Result<File, FileError> {
        self.new.as_file().try_clone().map_err(|error| FileError::unwritable(&self.path, &error))
    }

    /// Puts it in its place.
    ///
    /// # Errors
    /// Returns the errors of [`write()`].
    pub fn finish(mut self) -> Result<(), FileError> {
        write(&self.path, |file| {
            let written = self.new.as_file_mut();
            written.rewind()?;
            io::copy(written, file).map(drop)
        })
    }
}

fn replace(path: &Path, content: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<()> {
    let (target, old) = target_of(path)?;
    if old.as_ref().is_some_and(|old| !old.is_file()) {
        return write_through(&target, content);
    }
    let directory = folder_of(&target);
    let mut new = temporary_in(directory)?;
    content(new.as_file_mut())?;
    if let Some(old) = old {
        new.as_file().set_permissions(old.permissions())?;
    }
    new.as_file().sync_all()?;
    new.persist(&target).map_err(|error| error.error)?;
    // The new name itself is on the disk only when the directory is; not every system lets a
    // directory be opened, and the content is safe either way.
    let _ = File::open(directory).and_then(|directory| directory.sync_all());
    Ok(())
}

fn temporary_in(directory: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".pinhole-");
    if let Some(permissions) = default_permissions() {
        builder.permissions(permissions);
    }
    builder.tempfile_in(directory)
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

/// Writes to a device or pipe, where nothing can be sought or replaced.
fn write_through(
    target: &Path,
    content: impl FnOnce(&mut File) -> io::Result<()>,
) -> io::Result<()> {
    let mut buffer = tempfile::tempfile()?;
    content(&mut buffer)?;
    buffer.rewind()?;
    let mut device = File::options().write(true).open(target)?;
    io::copy(&mut buffer, &mut device).map(drop)
}

/// The file that a path stands for, also where a link points to a file that does not exist yet.
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
