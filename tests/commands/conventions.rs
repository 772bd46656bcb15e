//! The habits of a command line: mistyped commands, `-`, JSON for programs, completions.

use std::io::Write as _;
use std::process::Stdio;

use super::{Run, command_in, entries, finished, run};

const SCENE: &str = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nat = [0, 0, -1]\nup = [0, 1, 0]\n\
                     [[sphere]]\ncenter = [0, 0, -5]\nradius = 1\n";

/// A command line with this on standard input, in a folder of its own, in which no file may be left.
fn piped(line: &str, input: &str) -> (Vec<u8>, Run) {
    let folder = tempfile::tempdir().unwrap();
    let mut child = command_in(folder.path())
        .args(line.split(' '))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    let mut output = child.wait_with_output().unwrap();
    assert!(entries(folder.path()).is_empty(), "{line}");
    let bytes = std::mem::take(&mut output.stdout);
    (bytes, finished(output))
}

#[test]
fn a_mistyped_command_is_suggested() {
    for line in ["rendr", "rendr canonical -o a.png", "Render canonical -o a.png", "exprt"] {
        let command = if line.starts_with('e') { "'export'" } else { "'render'" };
        let told = run(line);
        assert!(told.stderr.contains(" similar subcommand"), "{}", told.stderr);
        told.refused(command);
    }
    // A scene that is mistyped is told as such.
    let scene = run("canonicl");
    assert!(scene.stderr.contains("did you mean canonical?"), "{}", scene.stderr);
    assert!(!scene.stderr.contains("subcommand"), "{}", scene.stderr);
}

#[test]
fn errors_look_like_those_of_the_arguments() {
    let folder = tempfile::tempdir().unwrap();
    let ours = run("inspect no-such-scene --pixel 0,0");
    let theirs = run("inspect canonical --pixel 0");
    for run in [ours, theirs] {
        assert!(run.stderr.starts_with("error: "), "{}", run.stderr);
    }
    let mut colored = command_in(folder.path());
    colored.args(["inspect", "no-such-scene", "--pixel", "0,0"]).env("CLICOLOR_FORCE", "1");
    let colored = finished(colored.output().unwrap());
    assert!(colored.stderr.starts_with("\u{1b}["), "{:?}", colored.stderr);
}

#[test]
fn a_scene_comes_from_standard_input_and_results_go_to_standard_output() {
    let (text, run) = piped("inspect - --uv 0,0 --json", SCENE);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    assert!(String::from_utf8(text).unwrap().contains("\"t\": 4.0"));

    let (png, run) = piped("render - -o - --width 20", SCENE);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let mut reader = png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    assert_eq!((reader.info().width, reader.info().height), (20, 20));

    for line in ["export - --to opengl -o -", "figure - --view camera --width 40 -o -"] {
        let (text, run) = piped(line, SCENE);
        assert_eq!(run.status, 0, "{line}: {}", run.stderr);
        assert!(text.len() > 100, "{line}");
    }
    let (text, run) = piped("trace canonical --rays - -o -", "ox,oy,oz,dx,dy,dz\n0,0,0,0,0,-1\n");
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert_eq!(String::from_utf8(text).unwrap().lines().count(), 2);
}

#[test]
fn standard_input_and_output_are_one_each() {
    let refused = [
        ("trace - --rays -", "SCENE and --rays are both -: standard input can be read only once"),
        (
            "check - --answers -",
            "SCENE and --answers are both -: standard input can be read only once",
        ),
        ("render canonical -o a.png --aov -", "--aov needs a file: - is for -o"),
        (
            "check canonical --answers - --map -",
            "--map needs a file: the grade goes to standard output",
        ),
    ];
    for (line, message) in refused {
        let (_, run) = piped(line, "");
        run.failed(2, message);
    }
    let (_, run) = piped("inspect - --uv 0,0", "pinhole = 1\n[camera]\neye = [0, 0]\n");
    assert!(run.stderr.starts_with("error: standard input:3:7: "), "{}", run.stderr);
}

#[test]
fn the_scenes_are_listed_for_programs() {
    let text = run("scenes --json").done();
    let list: serde_json::Value = serde_json::from_str(&text).unwrap();
    let scenes = list["scenes"].as_array().unwrap();
    let lines = run("scenes").done();
    assert_eq!(scenes.len(), lines.lines().count());
    for (scene, line) in scenes.iter().zip(lines.lines()) {
        let [name, summary] = ["name", "summary"].map(|key| scene[key].as_str().unwrap());
        assert!(line.starts_with(name) && line.ends_with(summary), "{line}");
    }
}

#[test]
fn completions_are_printed_for_a_shell() {
    for (shell, part) in [
        ("bash", "complete -F _pinhole"),
        ("zsh", "#compdef pinhole"),
        ("fish", "complete -c pinhole"),
    ] {
        assert!(run(&format!("completions {shell}")).done().contains(part), "{shell}");
    }
    run("completions tcsh").refused("bash, zsh, fish");
}
