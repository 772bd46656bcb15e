//! `pinhole scenes`

use std::io::{BufRead, BufReader};
use std::process::Stdio;

use super::{command_in, run};

#[test]
fn a_line_for_each_scene() {
    let list = run("scenes").done();
    let lines: Vec<&str> = list.lines().collect();
    assert_eq!(lines.len(), 12);
    assert_eq!(lines[0], "canonical           The lecture's canonical camera, and its warm-up.");
    for line in lines {
        let (name, summary) = line.split_once("  ").unwrap();
        assert!(line.len() <= 100 && summary.trim_start().len() > 10, "{line}");
        assert_eq!(run(&format!("inspect {name} --pixel 0,0 --json")).status, 0);
    }
}

#[test]
fn a_reader_who_has_seen_enough_is_no_error() {
    for line in ["scenes", "inspect canonical --uv 0,0", "render planet --width 300 -o -"] {
        let mut child = command_in(&std::env::temp_dir())
            .args(line.split(' '))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // Closed before the program has anything to write.
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), &b""[..]));
    }
}

#[test]
fn the_list_can_be_cut_short() {
    let mut child =
        command_in(&std::env::temp_dir()).arg("scenes").stdout(Stdio::piped()).spawn().unwrap();
    let mut first = String::new();
    BufReader::new(child.stdout.take().unwrap()).read_line(&mut first).unwrap();
    assert!(first.starts_with("canonical "), "{first}");
    assert!(child.wait().unwrap().success());
}
