//! What every command promises of the files it writes: none is one that it reads, several come together,
//! and a run that is ended leaves no others.

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant, SystemTime};

use super::{command_in, entries, run_in};

const SCENE: &str = "pinhole = 1\nspheres = \"balls.csv\"\n\n[camera]\neye = [0, 0, 0]\n\
                     view = [0, 0, -1]\nup = [0, 1, 0]\n";

/// The same scene under names with the endings of what is written.
const SCENES: [&str; 4] = ["s.toml", "s.png", "s.exr", "s.json"];

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    SCENES.iter().for_each(|name| write(name, SCENE));
    write("balls.csv", "x,y,z,r\n0,0,-5,1\n");
    write("in.csv", "ox,oy,oz,dx,dy,dz\n0,0,0,0,0,-2\n");
    write("in.png", "a picture");
    folder
}

fn contents(folder: &Path) -> Vec<(String, String)> {
    let read = |name: String| (name.clone(), fs::read_to_string(folder.join(name)).unwrap());
    entries(folder).into_iter().map(read).collect()
}

#[test]
fn no_output_is_written_over_an_input() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    fs::hard_link(path("in.csv"), path("hard.csv")).unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink("in.csv", path("soft.csv")).unwrap();
    #[cfg(not(unix))]
    fs::hard_link(path("in.csv"), path("soft.csv")).unwrap();
    let before = contents(folder.path());
    let absolute = path("s.toml");
    let absolute = absolute.display();
    for (line, refused) in [
        ("export s.toml --to povray -o s.toml", "-o would write over s.toml, which is read"),
        ("export s.toml --to povray -o balls.csv", "-o would write over balls.csv, which is read"),
        (
            &format!("export s.toml --to povray -o {absolute}"),
            &format!("-o would write over {absolute}, which is read as s.toml"),
        ),
        ("trace s.toml --rays in.csv -o s.toml", "-o would write over s.toml, which is read"),
        ("trace s.toml --rays in.csv -o balls.csv", "-o would write over balls.csv, which is read"),
        ("trace s.toml --rays in.csv -o in.csv", "-o would write over in.csv, which is read"),
        (
            "trace s.toml --rays in.csv -o soft.csv",
            "-o would write over soft.csv, which is read as in.csv",
        ),
        (
            "trace s.toml --rays in.csv -o hard.csv",
            "-o would write over hard.csv, which is read as in.csv",
        ),
        ("render ./s.png -o s.png", "-o would write over s.png, which is read"),
        ("render ./s.exr -o new.png --aov s.exr", "--aov would write over s.exr, which is read"),
        ("figure ./s.png --view world -o s.png", "-o would write over s.png, which is read"),
        ("import in.csv -o in.csv", "-o would write over in.csv, which is read"),
        ("check s.toml --answers in.png --map in.png", "--map would write over in.png, which"),
        ("report ./s.json --json s.json", "--json would write over s.json, which is read"),
    ] {
        let run = run_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{line}: {}", run.stderr);
        assert!(run.stderr.starts_with(&format!("error: {refused}")), "{line}: {}", run.stderr);
        assert!(run.stderr.ends_with(": choose another name\n"), "{line}: {}", run.stderr);
        assert_eq!(contents(folder.path()), before, "{line}");
    }
}

#[cfg(unix)]
#[test]
fn standard_input_is_not_written_over() {
    let folder = folder();
    let rays = folder.path().join("in.csv");
    let before = fs::read_to_string(&rays).unwrap();
    let output = command_in(folder.path())
        .args(["trace", "s.toml", "--rays", "-", "-o", "in.csv"])
        .stdin(fs::File::open(&rays).unwrap())
        .output()
        .unwrap();
    let message = "-o would write over in.csv, which is standard input: choose another name";
    super::finished(output).failed(2, message);
    assert_eq!(fs::read_to_string(&rays).unwrap(), before);
}

/// Runs it with a limit of `ulimit`: `-f` and the size of a file in blocks of 512 bytes, beyond which writing fails
/// as on a full disk; or `-v` and the size of the memory in KiB.
#[cfg(unix)]
pub(in crate::commands) fn run_within(limit: &str, folder: &Path, line: &str) -> super::Run {
    let script = format!("ulimit {limit}; exec \"$0\" \"$@\"");
    let mut command = std::process::Command::new("sh");
    command.args(["-c", &script, env!("CARGO_BIN_EXE_pinhole")]).args(line.split(' '));
    // Each thread takes memory of its own.
    command.env("RAYON_NUM_THREADS", "2");
    super::finished(command.current_dir(folder).output().unwrap())
}

#[cfg(unix)]
#[test]
fn of_two_files_none_is_written_if_one_cannot_be() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("out.png"), "old").unwrap();
    let problem = "cannot be written: the file may not become larger, by ulimit -f or on this disk";
    for (limit, line, file) in [
        ("-f 100", "render canonical -o out.png --aov out.exr --shade object", "out.exr"),
        ("-f 20", "render planet -o out.png --width 900", "out.png"),
    ] {
        run_within(limit, folder.path(), line).failed(1, &format!("{file}: {problem}"));
        assert_eq!(contents(folder.path()), [("out.png".to_owned(), "old".to_owned())]);
    }
}

#[cfg(unix)]
#[test]
fn of_several_files_nothing_is_written_if_one_cannot_be() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.png"), "old").unwrap();
    std::os::unix::fs::symlink("no/folder", folder.path().join("a.exr")).unwrap();
    let line = "render canonical --width 8 -o a.png --aov a.exr";
    let run = run_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
    assert_eq!(run.status, 1);
    assert!(run.stderr.contains("a.exr: cannot be written"), "{}", run.stderr);
    assert_eq!(fs::read_to_string(folder.path().join("a.png")).unwrap(), "old");
    assert_eq!(entries(folder.path()), ["a.exr", "a.png"]);
}

/// Returns true if the process has a file in this folder open.
#[cfg(target_os = "linux")]
fn is_writing(process: u32, folder: &Path) -> bool {
    let open = fs::read_dir(format!("/proc/{process}/fd")).into_iter().flatten().flatten();
    let is_in = |path: std::path::PathBuf| path.starts_with(folder);
    open.into_iter().any(|entry| fs::read_link(entry.path()).is_ok_and(is_in))
        || !entries(folder).is_empty()
}

/// Tracing many rays takes a while, and their hits go to a file that is not in place yet.
#[cfg(target_os = "linux")]
#[test]
fn a_run_that_is_ended_by_a_signal_leaves_nothing() {
    let signals = [("TERM", 15), ("HUP", 1), ("INT", 2), ("QUIT", 3), ("USR1", 10), ("XCPU", 24)];
    // The system's own record of a crash would lie in the folder.
    let script = "ulimit -c 0; exec \"$0\" \"$@\"";
    for (signal, number) in signals.into_iter().chain([("ABRT", 6), ("KILL", 9)]) {
        use std::os::unix::process::ExitStatusExt as _;

        let [folder, inputs] = [(); 2].map(|()| tempfile::tempdir().unwrap());
        let rays = "ox,oy,oz,dx,dy,dz\n".to_owned() + &"0,0,0,0.01,0.02,-1\n".repeat(2_000_000);
        fs::write(inputs.path().join("rays.csv"), rays).unwrap();
        let rays = inputs.path().join("rays.csv");
        let line = format!("trace canonical --rays {} -o a.csv", rays.display());
        let mut shell = std::process::Command::new("sh");
        shell.args(["-c", script, env!("CARGO_BIN_EXE_pinhole")]).args(line.split(' '));
        let mut child = shell.current_dir(folder.path()).spawn().unwrap();
        let start = Instant::now();
        let path = folder.path().canonicalize().unwrap();
        while !is_writing(child.id(), &path) && start.elapsed() < Duration::from_secs(60) {
            std::thread::sleep(Duration::from_millis(10));
        }
        let is_nameless = entries(folder.path()).is_empty();
        assert!(is_writing(child.id(), &path));
        super::send_signal(&child, signal);
        // A shell has its background jobs ignore SIGINT, and nohup SIGHUP; what is ignored stays so.
        if is_ignored(number) {
            child.kill().unwrap();
            child.wait().unwrap();
            continue;
        }
        assert_eq!(child.wait().unwrap().signal(), Some(number), "{signal}");
        // Nobody removes a name after these two.
        if is_nameless || !["ABRT", "KILL"].contains(&signal) {
            assert_eq!(entries(folder.path()), [""; 0], "{signal}");
        }
    }
}

/// Returns true if this process ignores the signal with this number.
#[cfg(target_os = "linux")]
fn is_ignored(number: i32) -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let set = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    set.is_some_and(|set| u64::from_str_radix(set.trim(), 16).unwrap() & (1 << (number - 1)) != 0)
}

#[test]
fn what_a_killed_run_has_left_is_removed_by_a_later_one() {
    let folder = tempfile::tempdir().unwrap();
    let old = SystemTime::now() - Duration::from_secs(2 * 3600);
    let names = [
        ".pinhole-aB3xYz12aB3x.tmp",
        ".pinhole-my-notes",
        ".pinhole-backup",
        ".other-aB3xYz12aB3x.tmp",
    ];
    for name in names {
        fs::write(folder.path().join(name), "").unwrap();
        fs::File::options()
            .write(true)
            .open(folder.path().join(name))
            .and_then(|file| file.set_modified(old))
            .unwrap();
    }
    // Another run may be at work on these.
    fs::write(folder.path().join(".pinhole-123456789012.tmp"), "").unwrap();
    let locked = fs::File::create(folder.path().join(".pinhole-locked345678.tmp")).unwrap();
    locked.set_modified(old).and_then(|()| locked.try_lock().map_err(Into::into)).unwrap();
    run_in(folder.path(), &["render", "canonical", "--width", "8", "-o", "a.png"]).done();
    let kept = [
        ".other-aB3xYz12aB3x.tmp",
        ".pinhole-123456789012.tmp",
        ".pinhole-backup",
        ".pinhole-locked345678.tmp",
        ".pinhole-my-notes",
        "a.png",
    ];
    assert_eq!(entries(folder.path()), kept);
}
