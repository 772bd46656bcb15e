//! The file calls of a process, listed and made to fail by `strace`.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Every call by which a file is opened, changed, named or removed; with `?`, those that not every processor has.
const TRACED: &str = "trace=?open,openat,?creat,close,write,writev,pwrite64,copy_file_range,sendfile,\
                      ftruncate,fallocate,fchmod,?chmod,fchmodat,fsync,fdatasync,?rename,renameat,\
                      renameat2,?link,linkat,symlinkat,?unlink,unlinkat,?mkdir,mkdirat,?rmdir";

/// A call on a file in the folder that is watched.
#[derive(Clone, Debug)]
pub(super) struct Call {
    pub(super) name: String,
    /// Its number among the calls of this name of its thread, from 1; those elsewhere count.
    number: usize,
    /// Its paths in the folder.
    pub(super) paths: Vec<PathBuf>,
    /// True if it opens a folder to read the names in it.
    pub(super) lists: bool,
    /// True if it creates a file without a name.
    pub(super) is_nameless: bool,
    pub(super) injected: bool,
}

impl Call {
    /// Tells `strace` to do this at the call: `signal=KILL` before it, or `error=EIO` in its place.
    pub(super) fn inject(&self, fault: &str) -> String {
        format!("inject={}:{fault}:when={}", self.name, self.number)
    }

    /// Tells `strace` to do this at both calls, of the same name.
    pub(super) fn inject_with(&self, later: &Call, fault: &str) -> String {
        let [first, last] = [self.number, later.number];
        format!("{}..{last}+{}", self.inject(fault), (last - first).max(1))
    }

    pub(super) fn is_any_of(&self, names: &[&str]) -> bool {
        names.contains(&self.name.as_str())
    }
}

/// Runs a program under `strace`, with what is injected; the calls on files in this folder.
pub(super) fn run(program: &Command, inject: &[String], folder: &Path) -> (Output, Vec<Call>) {
    let log = tempfile::NamedTempFile::new().unwrap();
    let mut strace = Command::new("strace");
    strace.args(["-f", "-y", "-s", "0", "-e", TRACED]);
    if !inject.iter().any(|inject| inject.contains("signal")) {
        // Stops at these calls alone; signals sent there do not arrive.
        strace.arg("--seccomp-bpf");
    }
    strace.args(inject.iter().flat_map(|inject| ["-e", inject]));
    strace.arg("-o").arg(log.path()).arg(program.get_program()).args(program.get_args());
    for (name, value) in program.get_envs() {
        strace.env(name, value.unwrap());
    }
    // Cargo's folders, in each of which every library is looked for.
    let output = strace.env_remove("LD_LIBRARY_PATH").current_dir("/").output().unwrap();
    (output, calls(&fs::read_to_string(log.path()).unwrap(), folder))
}

fn calls(log: &str, folder: &Path) -> Vec<Call> {
    let (mut numbers, mut calls) = (BTreeMap::new(), Vec::<Call>::new());
    // The paths of descriptors: a file without a name has one that tells it from others.
    let mut open = BTreeMap::<&str, PathBuf>::new();
    // The index of each thread's last call, if it is one of them: other threads may come before its end.
    let mut last = BTreeMap::new();
    for line in log.lines() {
        let (thread, call) = line.split_once(' ').unwrap();
        let call = call.trim_start();
        if let Some((name, rest)) = call.split_once('(').filter(|_| !call.starts_with('<')) {
            let number = numbers.entry((thread, name)).or_insert(0);
            *number += 1;
            let (mut paths, mut before) = (Vec::new(), "");
            for part in rest.split(['"', '<', '>']) {
                let itself =
                    part.strip_prefix("/proc/self/fd/").and_then(|number| open.get(number));
                let path = itself.cloned().unwrap_or_else(|| part.into());
                if path.starts_with(folder) {
                    let descriptor = before.rsplit(|c: char| !c.is_ascii_digit()).next();
                    open.extend(descriptor.map(|number| (number, path.clone())));
                    paths.push(path);
                }
                before = part;
            }
            last.remove(thread);
            if !paths.is_empty() {
                last.insert(thread, calls.len());
                let [lists, is_nameless] =
                    ["O_DIRECTORY", "O_TMPFILE"].map(|flag| rest.contains(flag));
                let (name, number) = (name.to_owned(), *number);
                calls.push(Call { name, number, paths, lists, is_nameless, injected: false });
            }
        }
        if let (true, Some(index)) = (call.ends_with("(INJECTED)"), last.get(thread)) {
            calls[*index].injected = true;
        }
    }
    calls
}

/// Returns whether processes can be traced here. Fails the test if not, where the environment asks for it.
pub(super) fn is_there() -> bool {
    let tried =
        Command::new("strace").args(["-f", "-o", "/dev/null", "-e", TRACED, "true"]).output();
    let problem = match tried {
        Ok(output) if output.status.success() => return true,
        Ok(output) => String::from_utf8_lossy(&output.stderr).into_owned(),
        Err(error) => format!("strace cannot be started: {error}"),
    };
    let required = std::env::var_os("PINHOLE_TEST_STRACE").is_some();
    assert!(!required, "PINHOLE_TEST_STRACE asks for faults at file calls: {problem}");
    println!("no faults are injected: {}", problem.trim_end());
    false
}
