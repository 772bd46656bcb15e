//! Whatever writes files, killed before every one of its file calls, and with every one of them failing in turn:
//! a file is the old or the new one, an error is told, and several files are complete before the first is put in
//! place. The same where the system has no files without names.
//!
//! Needs `strace`. Where that is not there, it is told; `PINHOLE_TEST_STRACE=required` makes it an error.

#![cfg(target_os = "linux")]
#![allow(clippy::print_stdout, reason = "CI shows what was injected, and what was left")]

mod strace;
mod window;

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs::{self, File};
use std::os::unix::process::ExitStatusExt as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, SystemTime};

use strace::Call;

const SCENE: &str = "pinhole = 1\n# kept\n\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\n\
                     up = [0, 1, 0]\n\n[image]\nwidth = 4\nheight = 4\n\n[[sphere]]\n\
                     center = [0, 0, -5]\nradius = 1\n";

/// Errors, and the system's words for them. The first is injected at every call, all of them where it is written, synced
/// or renamed.
const ERRORS: [(&str, &str); 3] = [
    ("ENOSPC", "no space left on device"),
    ("EIO", "input/output error"),
    ("EINTR", "interrupted system call"),
];

/// Something that writes files in a folder that has a scene, `s.toml`.
struct Case {
    name: &'static str,
    /// Writes the files that are there before.
    prepare: fn(&Path),
    program: fn(&Path) -> Command,
    /// The files that messages may name, beside the scene.
    writes: &'static [&'static str],
}

/// A folder's files by their names, without temporary ones and locks; folders are empty and end with a slash.
type Contents = BTreeMap<String, Vec<u8>>;

/// Reads a folder, and finds temporary files and folders.
fn read(folder: &Path) -> (Contents, Vec<PathBuf>) {
    let (mut contents, mut temporary, mut open) =
        (Contents::new(), vec![], vec![folder.to_owned()]);
    while let Some(inside) = open.pop() {
        for path in fs::read_dir(inside).unwrap().map(|entry| entry.unwrap().path()) {
            let name = path.strip_prefix(folder).unwrap().to_str().unwrap().to_owned();
            if is_temporary(&path) {
                temporary.push(path);
            } else if path.is_dir() {
                contents.insert(name + "/", vec![]);
                open.push(path);
            } else if path.extension() != Some("lock".as_ref()) {
                contents.insert(name, fs::read(path).unwrap());
            }
        }
    }
    (contents, temporary)
}

fn is_temporary(path: &Path) -> bool {
    let is_one = |name: &OsStr| name.to_str().is_some_and(|name| name.starts_with(".pinhole-"));
    path.iter().any(is_one)
}

/// A case as it goes without faults.
struct Undisturbed<'a> {
    case: &'a Case,
    /// Makes the calls that create files without names fail; empty where they may succeed.
    with_names: Vec<String>,
    old: Contents,
    new: Contents,
    calls: Vec<Call>,
}

fn prepared(case: &Case) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("s.toml"), SCENE).unwrap();
    (case.prepare)(folder.path());
    folder
}

fn undisturbed(case: &Case, with_names: Vec<String>) -> Undisturbed<'_> {
    let folder = prepared(case);
    let (old, _) = read(folder.path());
    let program = (case.program)(folder.path());
    let (output, mut calls) = strace::run(&program, &with_names, folder.path());
    assert!(output.status.success(), "{output:?}");
    let (new, left) = read(folder.path());
    assert!(old != new && left.is_empty(), "{left:?}");
    for path in calls.iter_mut().flat_map(|call| &mut call.paths) {
        *path = path.strip_prefix(folder.path()).unwrap().to_owned();
    }
    Undisturbed { case, with_names, old, new, calls }
}

/// Returns the case as it goes where each call that creates a file without a name fails like this.
fn with_names<'a>(nameless: &Undisturbed<'a>, fault: &str) -> Option<Undisturbed<'a>> {
    let case = nameless.case;
    let first = nameless.calls.iter().find(|call| call.is_nameless)?;
    let mut named = undisturbed(case, vec![first.inject(fault)]);
    if let Some(later) = named.calls.iter().find(|call| call.is_nameless && !call.injected) {
        named = undisturbed(case, vec![first.inject_with(later, fault)]);
    }
    assert!(named.calls.iter().all(|call| call.injected == call.is_nameless), "{:?}", named.calls);
    Some(named)
}

/// Returns true for what `strace` calls a file without a name.
fn is_nameless(path: &Path) -> bool {
    path.file_name().and_then(OsStr::to_str).is_some_and(|name| name.starts_with('#'))
}

fn is_write(call: &Call) -> bool {
    call.is_any_of(&["write", "writev", "pwrite64", "copy_file_range", "sendfile"])
}

fn is_rename(call: &Call) -> bool {
    call.is_any_of(&["rename", "renameat", "renameat2"])
}

/// The names that files get, with the numbers of the calls.
fn renames(calls: &[Call]) -> impl Iterator<Item = (usize, &Path, &Path)> {
    let renames = calls.iter().enumerate().filter(|(_, call)| is_rename(call));
    renames.map(|(index, call)| (index, call.paths[0].as_path(), call.paths[1].as_path()))
}

impl Undisturbed<'_> {
    /// Asserts that power may go off: a file's content is on the disk before it gets its name, and its name before
    /// the program ends.
    fn assert_reaches_the_disk(&self) {
        let is_sync = |call: &Call, path| call.name == "fsync" && call.paths[0] == path;
        let writes = |call: &Call, path| is_write(call) && call.paths.iter().any(|p| p == path);
        let mut count = 0;
        for (index, from, to) in renames(&self.calls) {
            let (before, after) = self.calls.split_at(index);
            let is_link = |call: &&Call| call.name == "linkat" && call.paths[1] == from;
            let from = before.iter().find(is_link).map_or(from, |link| &link.paths[0]);
            let synced = before.iter().rposition(|call| is_sync(call, from));
            let written = before.iter().rposition(|call| writes(call, from));
            assert!(written.is_some() && synced > written, "{}: {from:?}", self.case.name);
            let folder = to.parent().unwrap();
            assert!(after.iter().any(|call| is_sync(call, folder)), "{}: {to:?}", self.case.name);
            count += 1;
        }
        assert!(count > 0);
    }

    /// Runs it with a fault at a call; its folder, and what it said.
    fn disturbed(&self, index: usize, fault: &str) -> (tempfile::TempDir, Output) {
        let folder = prepared(self.case);
        let call = &self.calls[index];
        let program = (self.case.program)(folder.path());
        let inject = [&self.with_names[..], &[call.inject(fault)]].concat();
        let (output, calls) = strace::run(&program, &inject, folder.path());
        let is_hit = |hit: &Call| hit.name == call.name && (hit.injected || fault == "signal=KILL");
        assert!(calls.get(index).is_some_and(is_hit), "{call:?}: {output:?}, {calls:?}");
        (folder, output)
    }

    /// Kills it before a call. Each file is the new one if it had its name already, and else the old one. The number
    /// of temporary files that are left, until a later run removes them.
    fn kill(&self, index: usize) -> usize {
        let (folder, output) = self.disturbed(index, "signal=KILL");
        assert_eq!(output.status.signal(), Some(9), "{output:?}");
        let mut wanted = self.old.clone();
        for (_, _, to) in renames(&self.calls[..index]) {
            let name = to.to_str().unwrap();
            wanted.insert(name.to_owned(), self.new[name].clone());
        }
        let (mut contents, left) = read(folder.path());
        for files in [&mut wanted, &mut contents] {
            files.retain(|name, _| !name.ends_with('/'));
        }
        self.assert_same(index, "killed", &contents, &wanted);
        let is_named = self.calls[..index].iter().any(|call| call.name == "linkat");
        assert!(left.is_empty() || is_named || !self.with_names.is_empty(), "{left:?}");
        clear(&left);
        left.len()
    }

    /// Lets a call fail. All files are the old ones, and the error is told; or all are the new ones, where it does
    /// not matter or was tried again. True if it is told.
    fn fail(&self, index: usize, (error, reason): (&str, &str)) -> bool {
        let (folder, output) = self.disturbed(index, &format!("error={error}"));
        let call = &self.calls[index];
        let (contents, left) = read(folder.path());
        let told = output.status.code() == Some(1);
        if told {
            self.assert_same(index, error, &contents, &self.old);
            let stderr = String::from_utf8(output.stderr).unwrap();
            let is_of = |file: &&str| {
                let file = folder.path().join(file);
                ["written", "read"].iter().any(|done| {
                    stderr == format!("error: {}: cannot be {done}: {reason}\n", file.display())
                })
            };
            let mut files = self.case.writes.iter().copied().chain(["s.toml"]);
            assert!(files.any(|file| is_of(&file)), "{call:?}, {error}: {stderr}");
        } else {
            assert_eq!(output.status.code(), Some(0), "{call:?}, {error}: {output:?}");
            self.assert_same(index, error, &contents, &self.new);
            assert!(error == "EINTR" || does_not_matter(call), "{call:?}, {error} is not told");
        }
        assert!(left.is_empty() || removes(call), "{call:?}, {error}: left {left:?}");
        clear(&left);
        told
    }

    fn assert_same(&self, index: usize, fault: &str, contents: &Contents, wanted: &Contents) {
        let (case, call) = (self.case.name, &self.calls[index]);
        let names = |contents: &Contents| contents.keys().cloned().collect::<Vec<_>>();
        assert_eq!(names(contents), names(wanted), "{case}: {call:?}, {fault}");
        for (name, content) in contents {
            let is_same = *content == wanted[name];
            assert!(is_same, "{case}: {name} is another after {call:?}, {fault}");
        }
    }
}

/// Returns true for a call whose failure loses nothing: the scene is read again, for its comments; a folder is read for
/// what others have left, or for a file without a name, or its names are written to the disk, which not every system
/// can; there is no lock for windows that save their settings at once; a file gets no second name, or the first one by a copy.
fn does_not_matter(call: &Call) -> bool {
    let is_folder = call.paths[0].extension().is_none() && !is_nameless(&call.paths[0]);
    let is_read = is_folder
        || ["s.toml", "state/state.lock"].iter().any(|path| call.paths[0] == Path::new(path));
    call.is_any_of(&["open", "openat"]) && is_read
        || call.name == "fsync" && is_folder
        || call.name == "linkat"
        || removes(call)
}

/// Returns true for a call that removes something temporary.
fn removes(call: &Call) -> bool {
    let names = ["unlink", "unlinkat", "rmdir"];
    is_temporary(&call.paths[0]) && (call.lists || call.is_any_of(&names))
}

/// Asserts that a later run removes what was left.
fn clear(left: &[PathBuf]) {
    let old = SystemTime::now() - Duration::from_secs(2 * 3600);
    for path in left {
        File::open(path).and_then(|file| file.set_modified(old)).unwrap();
    }
    for path in left.iter().filter(|path| path.exists()) {
        let other = path.with_file_name("other.inc");
        let line = ["export", "canonical", "--to", "povray", "-o"];
        let run = Command::new(env!("CARGO_BIN_EXE_pinhole")).args(line).arg(&other).output();
        assert!(run.unwrap().status.success());
        assert!(left.iter().all(|path| !path.exists()), "{left:?}");
    }
}

fn check(case: &Case) {
    if strace::is_there() {
        undisturbed(case, Vec::new()).disturb("");
    }
}

/// The same where the system has no files without names, in either of its words for that.
fn check_by_name(case: &Case) {
    if !strace::is_there() {
        return;
    }
    let nameless = undisturbed(case, Vec::new());
    let named =
        ["EISDIR", "EOPNOTSUPP"].map(|error| with_names(&nameless, &format!("error={error}")));
    match named {
        [Some(_), Some(named)] => named.disturb(", by name"),
        _ => println!("{}: there are no files without names here, so that all had one", case.name),
    }
}

impl Undisturbed<'_> {
    /// Disturbs it in every way, and says what came of it.
    fn disturb(&self, how: &str) {
        self.assert_reaches_the_disk();
        // `strace` injects one fault into calls of the same name.
        let nameless = self.calls.iter().find(|call| call.injected).map(|call| &call.name);
        let is_free = |index: &usize| nameless != Some(&self.calls[*index].name);
        let all: Vec<usize> = (0..self.calls.len()).filter(is_free).collect();
        let most = all.iter().map(|index| self.kill(*index)).max().unwrap();
        let faults = all.iter().flat_map(|index| {
            let call = &self.calls[*index];
            let most = match call.name.as_str() {
                // What is closed is on the disk, or was only read.
                "close" => 0,
                "fsync" => 3,
                _ if is_rename(call) || is_write(call) => 3,
                _ => 1,
            };
            ERRORS[..most].iter().map(move |error| (*index, *error))
        });
        let told: Vec<bool> = faults.map(|(index, error)| self.fail(index, error)).collect();
        let count = |wanted| told.iter().filter(|told| **told == wanted).count();
        println!(
            "{:32} {:2} file calls: killed before each, at most {most} temporary left until a later run; {} errors told \
             and nothing changed, {} of no matter",
            self.case.name.to_owned() + how,
            all.len(),
            count(true),
            count(false),
        );
    }
}

/// The program with these arguments, whose names are in the folder after the @.
fn pinhole(folder: &Path, line: &str) -> Command {
    let mut program = Command::new(env!("CARGO_BIN_EXE_pinhole"));
    program.args(line.replace('@', &format!("{}/", folder.display())).split(' '));
    program
}

fn old_files(folder: &Path, names: &[&str]) {
    names.iter().for_each(|name| fs::write(folder.join(name), "old").unwrap());
}

#[test]
fn export_of_a_file() {
    check(&Case {
        name: "export",
        prepare: |folder| old_files(folder, &["out.inc"]),
        program: |folder| pinhole(folder, "export @s.toml --to povray -o @out.inc"),
        writes: &["out.inc"],
    });
}

#[test]
fn render() {
    let case = Case {
        name: "render --aov",
        prepare: |folder| old_files(folder, &["a.png", "a.exr"]),
        program: |folder| pinhole(folder, "render @s.toml -o @a.png --aov @a.exr"),
        writes: &["a.png", "a.exr"],
    };
    check(&case);
    check_by_name(&case);
}

#[test]
fn figure() {
    check(&Case {
        name: "figure",
        prepare: |folder| old_files(folder, &["a.svg"]),
        program: |folder| pinhole(folder, "figure @s.toml --view camera --width 8 -o @a.svg"),
        writes: &["a.svg"],
    });
}
