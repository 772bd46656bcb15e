//! The headless commands, run as a user runs them.

mod check;
mod conventions;
mod exchange;
mod figure;
mod figure_read_back;
mod generated;
mod inspect;
mod install;
mod lesson;
mod outputs;
mod page;
mod render;
mod report;
mod scenes;
mod share;
mod trace;

use std::ffi::OsStr;
use std::path::Path;
use std::process::{Command, Output};

/// What a run of the program left behind.
struct Run {
    status: i32,
    stdout: String,
    stderr: String,
}

/// The program without a display, in a folder.
fn command_in(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_pinhole"));
    command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").current_dir(folder);
    command
}

fn run_in<S: AsRef<OsStr>>(folder: &Path, arguments: &[S]) -> Run {
    finished(command_in(folder).args(arguments).output().unwrap())
}

/// Runs a command line without quotes in it, in the temporary folder.
fn run(line: &str) -> Run {
    run_in(&std::env::temp_dir(), &line.split(' ').collect::<Vec<_>>())
}

fn finished(output: Output) -> Run {
    Run {
        status: output.status.code().unwrap(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

impl Run {
    /// Standard output of a run that went well.
    fn done(self) -> String {
        assert_eq!((self.status, self.stderr.as_str()), (0, ""));
        self.stdout
    }

    /// Asserts that the run failed with this message and said nothing else.
    fn failed(self, status: i32, message: &str) {
        assert_eq!(
            (self.status, self.stderr.as_str()),
            (status, format!("error: {message}\n").as_str())
        );
        assert_eq!(self.stdout, "");
    }

    /// Asserts that the arguments were refused, with this in the message.
    fn refused(self, message: &str) {
        assert_eq!((self.status, self.stdout.as_str()), (2, ""));
        assert!(self.stderr.contains(message), "{}", self.stderr);
    }
}

/// Sends a signal by the shell's own `kill`: there need be no program of that name.
#[cfg(unix)]
fn send_signal(to: &std::process::Child, signal: &str) {
    let line = format!("kill -{signal} {}", to.id());
    assert!(Command::new("sh").args(["-c", &line]).status().unwrap().success());
}

/// The files of a folder, sorted.
fn entries(folder: &Path) -> Vec<String> {
    let names = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        names.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn every_command_is_offered_and_has_a_help() {
    let help = run("--help").done();
    for command in [
        "scenes", "inspect", "render", "trace", "report", "check", "figure", "export", "import",
        "page", "share",
    ] {
        assert!(help.contains(&format!("\n  {command} ")), "{help}");
        assert!(run(&format!("{command} --help")).done().contains("Usage: pinhole"));
    }
}

/// The help and the version are output like any other.
#[cfg(target_os = "linux")]
#[test]
fn help_that_cannot_be_written_is_an_error() {
    for line in ["--help", "--version", "render --help", "scenes"] {
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let mut command = command_in(&std::env::temp_dir());
        let output = command.args(line.split(' ')).stdout(full).output().unwrap();
        finished(output).failed(1, "standard output: cannot be written: no space left on device");
    }
}

#[test]
fn wrong_arguments_are_status_2() {
    run("inspect").refused("required arguments were not provided");
    run("inspect canonical").refused("<--pixel <ROW,COL>|--uv <U,V>>");
    run("inspect canonical --uv 0,0 --pixel 1,1").refused("cannot be used with");
    run("inspect canonical --uv 1").refused(
        "invalid value '1' for '--uv <U,V>': there must be two numbers with a comma between, such as \
         0.2,-0.1",
    );
    run("inspect canonical --uv 1,x")
        .refused("\"x\" is no finite number: write it such as 0.2,-0.1");
    run("inspect canonical --uv nan,0").refused("\"nan\" is no finite number");
    run("inspect canonical --pixel -1,2")
        .refused("\"-1\" is no row or column: whole numbers from 0, such as 99,199");
    run("inspect canonical --pixel 1.5,2").refused("\"1.5\" is no row or column");
    run("render canonical").refused("--output <OUT.png>");
    for wrong in ["--width 0", "--height 16385", "--width abc"] {
        run(&format!("render canonical -o a.png {wrong}"))
            .refused("it must be a whole number of pixels, 1 to 16384");
    }
    run("render canonical -o a.png --shade phong").refused("lambert, normal, t, object");
    run("render canonical -o a.png --view side").refused("camera, world");
    run("check canonical").refused("--answers <IN.csv|IN.png|FOLDER>");
    run("check canonical --answers a.csv --tolerance -1").refused("\"-1\" is no tolerance");
    run("check canonical --answers a.csv --tolerance=nan").refused("\"nan\" is no tolerance");
    run("check canonical --answers a.csv --count-from 2").refused("2 is not in 0..=1");
    run("trace canonical").refused("--rays <IN.csv>");
    run("--renderer gpu").refused("wgpu, cpu");
    run("--nonsense").refused("unexpected argument '--nonsense'");
}
