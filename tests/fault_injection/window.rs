//! What the window writes by itself, each in a process of its own.

use std::fs;
use std::path::Path;
use std::process::Command;

use pinhole::model::files::OpenDocument;
use pinhole::model::recovery::{Slot, Unsaved};
use pinhole::model::store::{Remembered, Store};
use pinhole_exchange::scenes::SceneSource;

use super::{Case, check};

/// Says what is to be written, and in which folder.
const WHAT: &str = "PINHOLE_TEST_WRITES";
const FOLDER: &str = "PINHOLE_TEST_FOLDER";

/// This test program, which writes one thing and ends.
fn program(what: &str, folder: &Path) -> Command {
    let mut program = Command::new(std::env::current_exe().unwrap());
    program.args(["--exact", "fault_injection::window::writes", "--ignored"]);
    program.args(["--nocapture", "--test-threads=1"]).env(WHAT, what).env(FOLDER, folder);
    program
}

#[test]
#[ignore = "the tests of this file start it under strace"]
fn writes() {
    let Some(folder) = std::env::var_os(FOLDER) else { return };
    let folder = Path::new(&folder);
    // strace counts the calls of each thread: these make more than the test program's own thread has.
    for _ in 0..50 {
        fs::write("/dev/null", " ").unwrap();
    }
    let written = match std::env::var(WHAT).unwrap().as_str() {
        "scene" => save(&folder.join("s.toml")),
        "settings" => {
            let remembered = Remembered { renderer: "new".to_owned(), ..Remembered::default() };
            let saved = store(folder).save(&Remembered::default(), &remembered);
            saved.map_err(|error| error.to_string())
        }
        _ => write_aside_again(folder),
    };
    if let Err(problem) = written {
        eprintln!("error: {problem}");
        std::process::exit(1);
    }
}

fn save(path: &Path) -> Result<(), String> {
    let source = SceneSource::File(path.to_owned());
    let mut open = OpenDocument::open(source).map_err(|error| error.to_string())?;
    open.document.camera.eye.x = 0.5;
    open.save_to(path)
}

fn store(folder: &Path) -> Store {
    Store::at(&folder.join("state/state.json"))
}

fn write_aside(folder: &Path) {
    let (slot, ..) = Slot::open(&store(folder).unsaved());
    let source = SceneSource::from_argument(Path::new("look-at")).unwrap();
    let mut open = OpenDocument::open(source).unwrap();
    open.document.camera.eye.x = 0.25;
    Unsaved::of(&open).write(&slot.unwrap()).unwrap();
}

/// Goes on in the slot of changes that were restored, in a scene of another name.
fn write_aside_again(folder: &Path) -> Result<(), String> {
    let (_, mut found, fault) = Slot::open(&store(folder).unsaved());
    if let Some(fault) = fault {
        return Err(fault.to_string());
    }
    let (mut open, slot) = found.remove(0).restore(true)?;
    open.document.camera.eye.x = 0.5;
    Unsaved::of(&open).write(&slot)
}

#[test]
fn saving() {
    check(&Case {
        name: "the window saves",
        prepare: |_| {},
        program: |folder| program("scene", folder),
        writes: &["s.toml"],
    });
}

#[test]
fn settings() {
    check(&Case {
        name: "the window remembers",
        prepare: |folder| {
            let remembered = Remembered { renderer: "old".to_owned(), ..Remembered::default() };
            store(folder).save(&Remembered::default(), &remembered).unwrap();
        },
        program: |folder| program("settings", folder),
        writes: &["state", "state/state.json"],
    });
}

#[test]
fn recovery() {
    check(&Case {
        name: "the window writes aside",
        prepare: write_aside,
        program: |folder| program("unsaved", folder),
        writes: &[
            "state/unsaved",
            "state/unsaved/0.lock",
            "state/unsaved/1.lock",
            "state/unsaved/0.toml",
        ],
    });
}
