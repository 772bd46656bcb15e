//! The host that keeps the program's files: the operating system on the desktop, the browser in a page.

use std::any::Any;
use std::env;
use std::fs::{self, File, TryLockError};
use std::io::{self, Read, Write as _};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::time::SystemTime;

use serde::{Deserialize, Serialize};

use crate::{FileError, atomic, windows_names};

/// What tells a file's content from another one without reading it: its state before it was read, or after it
/// was written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Stamp {
    /// The modification time, if the host knows it.
    pub modified: Option<SystemTime>,
    /// The size in bytes.
    pub length: u64,
    /// The number of the file, and the seconds and nanoseconds of its last change of any kind, if the host knows
    /// them. Programs that copy a file with its modification time do not set them.
    pub change: Option<[i64; 3]>,
}

/// A lock that is held until this value is dropped.
pub type Lock = Box<dyn Any + Send + Sync>;

/// What keeps the program's files, and what differs between an operating system and a browser.
pub trait Host: Send + Sync {
    /// Opens a file to read it.
    ///
    /// # Errors
    /// Returns an error if there is no such file, or if it is a device, or a pipe that was not opened for the
    /// program: reading such a source may block forever.
    fn open(&self, path: &Path) -> Result<Box<dyn Read>, FileError>;

    /// Writes a file completely or not at all.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written. An existing file is then unchanged.
    fn write(&self, path: &Path, content: &[u8]) -> Result<(), FileError>;

    /// Checks that a file can be written, before a long computation. Writing it may still fail later.
    ///
    /// # Errors
    /// Returns an error if the path is a folder, lies in a folder that does not exist, or is read-only.
    fn check(&self, path: &Path) -> Result<(), FileError>;

    /// Makes a folder for the program's own files, unless it exists.
    ///
    /// # Errors
    /// Returns an error if the folder cannot be made.
    fn make_folder(&self, folder: &Path) -> Result<(), FileError>;

    /// Removes a file. Does nothing if that fails, or if there is no such file.
    fn remove(&self, path: &Path);

    /// Returns the stamp of a file; `None` if there is no such file.
    fn stamp(&self, path: &Path) -> Option<Stamp>;

    /// Returns the absolute path of a file without links, even if the file does not exist but its folder does.
    /// Returns `None` if there is no such folder.
    fn resolved(&self, path: &Path) -> Option<PathBuf>;

    /// Returns true if the two paths refer to the same file.
    fn is_same_file(&self, a: &Path, b: &Path) -> bool;

    /// Locks a name for this window. Returns `None` if another window holds the lock, which its host
    /// releases however the window ends.
    ///
    /// # Errors
    /// Returns an error if the host cannot lock.
    fn lock(&self, path: &Path) -> Result<Option<Lock>, FileError>;

    /// Returns the time of day.
    fn now(&self) -> SystemTime;

    /// Returns the page that runs the program in a browser.
    ///
    /// # Errors
    /// Returns a reason, as a sentence, if there is no such page.
    fn page(&self) -> Result<String, String>;

    /// Returns true if the user's files are in folders that can be listed, and may be changed there by
    /// other programs.
    fn has_folders(&self) -> bool;
}

static HOST: OnceLock<Box<dyn Host>> = OnceLock::new();

/// Sets the host. Must be called before any file is read, because until then the host is the operating
/// system.
pub fn set(host: impl Host + 'static) {
    // Only the first host counts.
    let _ = HOST.set(Box::new(host));
}

/// Returns the host.
pub fn host() -> &'static dyn Host {
    HOST.get_or_init(|| Box::new(OperatingSystem)).as_ref()
}

/// The name of the page that runs the program in a browser.
const PAGE: &str = "pinhole.html";

/// The operating system, with its folders and files.
struct OperatingSystem;

/// The paths of files that were opened for the program before it started, such as standard input.
/// Unlike others, they may be pipes.
const INHERITED: [&str; 4] = ["/dev/stdin", "/dev/fd", "/proc/self/fd", "/proc/thread-self/fd"];

impl Host for OperatingSystem {
    fn open(&self, path: &Path) -> Result<Box<dyn Read>, FileError> {
        let is_inherited = INHERITED.iter().any(|of_shell| path.starts_with(of_shell));
        let data = path.metadata().map_err(|error| FileError::unreadable(path, &error))?;
        if !(data.is_file() || data.is_dir() || is_inherited) {
            let problem = "cannot be read: it is a device or a pipe, and must be a file";
            return Err(FileError::of_file(path, problem));
        }
        Ok(Box::new(File::open(path).map_err(|error| FileError::unreadable(path, &error))?))
    }

    fn write(&self, path: &Path, content: &[u8]) -> Result<(), FileError> {
        atomic::write(path, |file| file.write_all(content))
    }

    fn check(&self, path: &Path) -> Result<(), FileError> {
        atomic::check(path)
    }

    fn make_folder(&self, folder: &Path) -> Result<(), FileError> {
        fs::create_dir_all(folder).map_err(|error| FileError::unwritable(folder, &error))
    }

    fn remove(&self, path: &Path) {
        let _ = fs::remove_file(path);
    }

    fn stamp(&self, path: &Path) -> Option<Stamp> {
        let data = fs::metadata(path).ok()?;
        // A modification time before 1970 is dropped: it could not be serialized with the unsaved
        // changes.
        let modified = data.modified().ok().filter(|time| *time >= SystemTime::UNIX_EPOCH);
        #[cfg(unix)]
        let change = {
            use std::os::unix::fs::MetadataExt as _;
            Some([data.ino().cast_signed(), data.ctime(), data.ctime_nsec()])
        };
        #[cfg(not(unix))]
        let change = None;
        Some(Stamp { modified, length: data.len(), change })
    }

    fn resolved(&self, path: &Path) -> Option<PathBuf> {
        let in_folder = || path.parent()?.canonicalize().ok().zip(path.file_name());
        path.canonicalize()
            .ok()
            .or_else(|| in_folder().map(|(folder, name)| folder.join(name)))
            .or_else(|| std::path::absolute(path).ok())
            .map(windows_names::usual)
    }

    fn is_same_file(&self, a: &Path, b: &Path) -> bool {
        atomic::is_same_file(a, b)
    }

    fn lock(&self, path: &Path) -> Result<Option<Lock>, FileError> {
        let why = |error: io::Error| FileError::unwritable(path, &error);
        let file =
            File::options().create(true).write(true).truncate(false).open(path).map_err(why)?;
        match file.try_lock() {
            Ok(()) => Ok(Some(Box::new(file))),
            Err(TryLockError::WouldBlock) => Ok(None),
            Err(TryLockError::Error(error)) => Err(why(error)),
        }
    }

    fn now(&self) -> SystemTime {
        SystemTime::now()
    }

    fn page(&self) -> Result<String, String> {
        // An archive has the page beside the program, an installed program in its folder of data, and a build
        // one folder above.
        let places = ["", "../share/pinhole", ".."];
        let program = env::current_exe().map_err(|error| error.to_string())?;
        let folder = atomic::folder_of(&program);
        let found = places.iter().map(|place| folder.join(place).join(PAGE));
        let page = found.into_iter().find(|page| page.is_file()).ok_or_else(|| {
            format!("{PAGE} is missing. It belongs in the program's folder, {}.", folder.display())
        })?;
        fs::read_to_string(&page).map_err(|error| FileError::unreadable(&page, &error).to_string())
    }

    fn has_folders(&self) -> bool {
        true
    }
}
